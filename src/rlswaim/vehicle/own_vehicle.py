"""A reader's own vehicle, from one CSV file of its masses, surfaces, modes and flight condition.

Each line of the file is one number; its columns are ``kind, name, station, value``::

    kind        name                           station  value
    mass        any                            ft       concentrated mass (slug)
    surface     its name                       ft       slope of the normal force on the area S (1/rad)
    deflection  the mode's name                ft       its deflection there, positive up
    slope       the mode's name                ft       its slope -d phi/d l there (1/ft); may be left out
    frequency   the mode's name                         omega (rad/s)
    damping     the mode's name                         damping ratio
    vehicle     S, T, thrust_station                    area (ft^2), thrust (lb), station of the thrust (ft)
    flight      q_D, U, h, t, gamma_0                   lb/ft^2, ft/s, ft, s, rad; gamma_0 may be left out

Total mass, centre of gravity, moment of inertia and generalized masses are sums over the masses.
"""

from collections import defaultdict
from dataclasses import fields
from os import PathLike

import numpy as np

from rlswaim.source import checks
from rlswaim.source.tables import Row, read_own_table
from rlswaim.vehicle.booster import Booster, FlightCondition, Surface
from rlswaim.vehicle.modes import BendingMode

COLUMNS = ("kind", "name", "station", "value")
AT_STATIONS = ("mass", "surface", "deflection", "slope")
KINDS = (*AT_STATIONS, "frequency", "damping", "vehicle", "flight")
WANTED = {"vehicle": ("S", "T", "thrust_station"), "flight": ("q_D", "U", "h", "t")}

Places = dict[str, dict[float, float]]


def _number(row: Row, column: str, where: str) -> float:
    try:
        return checks.real(column, float(row[column]), where)
    except ValueError as error:
        line = f"{row['kind']} {row['name']}".strip()
        raise ValueError(
            f"{column} of {line} in {where}: got {row[column]!r}, wanted a finite number"
        ) from error


def _sorted_out(rows: tuple[Row, ...], where: str) -> tuple[dict[str, Places], dict[str, dict[str, float]]]:
    """Return the lines with stations, and the others, by kind and name."""
    along: dict[str, Places] = {kind: defaultdict(dict) for kind in AT_STATIONS}
    single: dict[str, dict[str, float]] = {kind: {} for kind in KINDS if kind not in AT_STATIONS}
    for row in rows:
        kind = checks.one_of("kind", row["kind"], KINDS, where)
        value = _number(row, "value", where)
        if kind in along:
            name = "" if kind == "mass" else row["name"]
            along[kind][name][_number(row, "station", where)] = value
        else:
            single[kind][row["name"]] = value
    for kind, names in WANTED.items():
        if missing := [name for name in names if name not in single[kind]]:
            raise ValueError(f"{kind} in {where}: got no {missing[0]}, wanted {', '.join(names)}")
    if not along["mass"]:
        raise ValueError(f"masses in {where}: got none, wanted one or more")
    return along, single


def _mode(
    name: str, along: dict[str, Places], single: dict[str, dict[str, float]], where: str
) -> BendingMode:
    """Return one mode; its generalized mass follows from the masses later."""
    for kind in ("frequency", "damping"):
        if name not in single[kind]:
            raise ValueError(f"{kind} in {where}: got none of mode {name}, wanted one")
    phi, sigma = (dict(sorted(along[kind].get(name, {}).items())) for kind in ("deflection", "slope"))
    return BendingMode(
        stations=np.array([*phi]),
        deflections=np.array([*phi.values()]),
        slope_stations=np.array([*sigma]),
        slopes=np.array([*sigma.values()]),
        omega=single["frequency"][name],
        zeta=single["damping"][name],
        mass=1.0,
        name=f"bending mode {name}",
    )


def read_booster(path: str | PathLike[str]) -> Booster:
    """Return a vehicle from a CSV file of its own, with columns kind, name, station and value.

    Parameters
    ----------
    path : path
        Of the file; what its lines say stands at the top of `rlswaim.vehicle.own_vehicle`.  Stations
        are in ft from the nose, 0 to 420.

    Returns
    -------
    Booster
        Modes in the order in which the file names them.

    Raises
    ------
    ValueError
        If a column, a kind or a number is missing, unknown or makes no sense.
    FileNotFoundError
        If there is no such file.
    """
    where = f"{path}"
    along, single = _sorted_out(read_own_table(path, COLUMNS), where)
    known = [field.name for field in fields(FlightCondition)]
    for name in single["flight"]:
        checks.one_of("flight", name, known, where)
    masses = dict(sorted(along["mass"][""].items()))
    total = sum(masses.values())
    centre = sum(x * m for x, m in masses.items()) / total
    own = single["vehicle"]
    return Booster(
        stations=np.array([*masses]),
        masses=np.array([*masses.values()]),
        M=total,
        I_y=sum(m * (x - centre) ** 2 for x, m in masses.items()),
        l_CG=centre,
        l_G=own["thrust_station"] - centre,
        S=own["S"],
        T=own["T"],
        surfaces=tuple(Surface(n, x, C) for n, at in along["surface"].items() for x, C in at.items()),
        modes=tuple(_mode(name, along, single, where) for name in along["deflection"]),
        flight=FlightCondition(**single["flight"]),
        name=where,
    ).recomputed()
