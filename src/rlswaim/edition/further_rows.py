"""Printed numbers of ``data/printed_more.csv``: those that ``data/printed.csv`` does not have yet.

They are data and choices of the text, what the text says of Figures 10 and 11 and of four sensor stations,
the stations of Table 3, and integers inside equations.
"""

from functools import cache

import numpy as np

from rlswaim.edition.ledger import Entry, ledger
from rlswaim.edition.section_4 import CLOSED_LOOPS, K_C, closed_loop_roots
from rlswaim.edition.section_5 import K_R, K_Z
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.loops.systems import single_sensor
from rlswaim.loops.transfer_functions import close, displacement_numerator, open_loop_parts, theta_loop
from rlswaim.source.tables import constants, printed, read_table
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations
from rlswaim.vehicle.trajectory import swaim_ascent

TRIED = (20, 140, 300, 420)
"""Sensor stations (ft) that the report tries in Section V."""


def _vehicle() -> dict[str, float]:
    """Return the data of Sections II and III, and two masses that confirm Table 1."""
    booster, ascent, data = swaim_booster(), swaim_ascent(), constants("vehicle")
    named = {f"sec2-{name}": data[name] for name in ("W_0", "W_burnout", "t_burn", "T", "S")}
    slopes = {f"sec2-C_Nalpha-{s.name}": s.C_Nalpha for s in booster.surfaces}
    frequencies = {f"sec2-omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    return (
        named
        | slopes
        | frequencies
        | {
            "sec3-zeta_1": booster.modes[0].zeta,
            "sec2-payload": float(booster.masses[0] * ascent.g),
            "sec2-M": ascent.M_0 - ascent.m_p * booster.flight.t,
        }
    )


def _slow_roots(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the root (1/s) beside the origin of each closed loop of Eqs. 77 to 82."""
    p = printed("IV", "eq75-")
    return {
        f"eq{number}-origin-root": float(min(closed_loop_roots(eqs, p["K_A"], p["K_R"], *at), key=abs).real)
        for number, at in CLOSED_LOOPS.items()
    }


def _figures(eqs: PerturbationEquations) -> dict[str, float]:
    """Return which modes are unstable in Figure 10 at large K_A, and how many Figure 11 stiffens."""
    p = printed("IV", "fig1")
    ten = close(theta_loop(eqs, p["0-K_C"], p["0-K_R"], 60), 1e3, open_loop_parts(eqs, p["0-K_C"])).ends
    starts = open_loop_parts(eqs, p["1-K_C"])
    eleven = close(theta_loop(eqs, p["1-K_C"], p["1-K_R"], None), p["1-K_A"], starts).ends
    modes = ("mode 1", "mode 2")
    unstable = {f"fig10-mode{i}-unstable": float(ten[m].real.max() > 0) for i, m in enumerate(modes, start=1)}
    higher = sum(bool(abs(eleven[m][0]) > abs(starts[m][0])) for m in modes)
    return unstable | {"fig11-stiffened": float(higher)}


def _best_station(eqs: PerturbationEquations) -> float:
    """Return which of `TRIED` has the least abscissa at the gains of Figure 16, K_z of either sign."""
    K_A = printed("V")["fig16-K_A"]
    gains = {"K_A": K_A, "K_C": K_C, "K_R": K_R}

    def abscissa(station: int) -> float:
        loops = (single_sensor(eqs, **gains, K_z=K_z, sensor=station) for K_z in (K_Z, -K_Z))
        return float(min(loop.poles().real.max() for loop in loops))

    return float(min(TRIED, key=abscissa))


def _design(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the choices of Section IV and what Eqs. 69 to 75 make of them, and the sensor's frequency."""
    numerator = displacement_numerator(eqs, 140.0)
    zeros = np.roots(numerator[::-1])
    return {
        "sec4-omega_sp": abs(WANTED),
        "sec4-zeta_sp": -WANTED.real / abs(WANTED),
        "eq69-2zw": -2 * WANTED.real,
        "eq70-w2": abs(WANTED) ** 2,
        "sec4-K_C": K_C,
        "sec4-loci": 20.0,  # a count of what was done
        "eq99-b": float(-zeros[np.abs(zeros + 1).argmin()].real),
    }


def computed() -> dict[str, float]:
    """Return our number for each row of ``data/printed_more.csv``, by its id."""
    eqs = printed_equations()
    stations = {f"sec5-sensor-{x}": float(x) for x in TRIED} | {"sec5-best": _best_station(eqs)}
    pairs = {
        f"tab3-{what}-{row['case']}": float(row[f"{what}_ft"])
        for row in read_table("table3")
        for what in ("sensor", "jet")
    }
    return _vehicle() | _slow_roots(eqs) | _figures(eqs) | _design(eqs) | stations | pairs


@cache
def further_rows() -> tuple[Entry, ...]:
    """Return the entries of ``data/printed_more.csv``, in its order."""
    ours = computed()
    return tuple(Entry(computed=ours[row["id"]], **row) for row in read_table("printed_more"))


@cache
def entries() -> dict[str, Entry]:
    """Return all entries by id: the ledger's, and those that are to join it."""
    return {entry.id: entry for entry in (*ledger(), *further_rows())}
