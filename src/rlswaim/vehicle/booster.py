"""The vehicle: masses, lifting surfaces, thrust and flight condition [Section II]."""

from dataclasses import dataclass, field, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from rlswaim.source import checks
from rlswaim.source.quantity import quantity
from rlswaim.source.tables import column, constants, number, read_table
from rlswaim.vehicle.modes import BendingMode, generalized_mass, purified
from rlswaim.vehicle.stations import as_station, increasing_stations
from rlswaim.vehicle.trajectory import level_at_burnout, swaim_ascent


@dataclass(frozen=True)
class FlightCondition:
    """The state of flight about which the equations are linearized [Section II].

    Raises
    ------
    ValueError
        If the speed is not positive, the dynamic pressure is negative, or a number is not finite.
    """

    q_D: float = quantity("q_D", "lb/ft^2", "dynamic pressure", "Section II, Figure 3")
    U: float = quantity("U", "ft/s", "undisturbed speed along the x axis", "Section II, Figure 4")
    h: float = quantity("h", "ft", "altitude", "Section II, Figure 3")
    t: float = quantity("t", "s", "time from launch", "Section II")
    gamma_0: float | None = quantity(
        "gamma_0",
        "rad",
        "angle of the flight path, if it is known",
        "Section II; the pitch program is the book's",
        default=None,
    )

    def __post_init__(self) -> None:
        """Check the numbers."""
        where = "FlightCondition"
        object.__setattr__(self, "q_D", checks.not_negative("q_D", self.q_D, where))
        object.__setattr__(self, "U", checks.positive("U", self.U, where))
        object.__setattr__(self, "h", checks.real("h", self.h, where))
        object.__setattr__(self, "t", checks.not_negative("t", self.t, where))
        if self.gamma_0 is not None:
            object.__setattr__(self, "gamma_0", checks.real("gamma_0", self.gamma_0, where))

    @property
    def weight_across(self) -> float:
        """The weight across the path over the mass, g sin gamma_0 (ft/s^2) [Eq. 1].

        Raises
        ------
        ValueError
            If gamma_0 is not known.
        """
        if self.gamma_0 is None:
            raise ValueError("gamma_0 in FlightCondition: got None, wanted the angle of the path (rad)")
        return float(constants("vehicle")["g"] * np.sin(self.gamma_0))


@dataclass(frozen=True)
class Surface:
    """A lifting surface, its normal force taken at one station [Section II].

    Raises
    ------
    ValueError
        If the station lies outside 0..420 ft or the slope is not finite.
    """

    name: str
    station: float = quantity("l", "ft", "station of the center of pressure", "recovered, Eq. 38")
    C_Nalpha: float = quantity(
        "C_N_alpha", "1/rad", "slope of the normal force coefficient, on the planform area S", "Section II"
    )

    def __post_init__(self) -> None:
        """Check the numbers."""
        where = f"Surface {self.name}"
        object.__setattr__(self, "station", as_station("station", self.station, where))
        object.__setattr__(self, "C_Nalpha", checks.real("C_Nalpha", self.C_Nalpha, where))


@dataclass(frozen=True, eq=False, kw_only=True)
class Booster:
    """The booster of the report; ``dataclasses.replace`` varies it.

    ``M``, ``I_y``, ``l_CG`` and the modes' generalized masses are the report's
    totals; `recomputed` puts the sums of Tables 1 and 2 in their place.

    Raises
    ------
    ValueError
        If a mass, the inertia, the area or an arm is not positive, the thrust
        is negative or a station lies outside 0..420 ft.
    """

    stations: NDArray = quantity("l", "ft", "stations of the concentrated masses", "Table 1")
    masses: NDArray = quantity("m", "slug", "concentrated masses", "Table 1")
    M: float = quantity("M", "slug", "total mass", "Table 1")
    I_y: float = quantity(
        "I_y", "slug ft^2", "pitch moment of inertia about the center of gravity", "Table 1"
    )
    l_CG: float = quantity("l_CG", "ft", "station of the center of gravity", "Section II")
    l_G: float = quantity(
        "l_G", "ft", "distance from the center of gravity aft to the thrust point G", "recovered"
    )
    S: float = quantity("S", "ft^2", "planform area, reference of all coefficients", "Section II")
    T: float = quantity("T", "lb", "thrust", "Section II")
    surfaces: tuple[Surface, ...]
    modes: tuple[BendingMode, ...]
    flight: FlightCondition
    name: str = field(default="Swaim's booster")

    def __post_init__(self) -> None:
        """Check and freeze the data."""
        x = increasing_stations("stations", self.stations, self.name)
        masses = checks.frozen_array("masses", self.masses, self.name, x.shape)
        for at, mass in enumerate(masses):
            checks.positive(f"masses[{at}]", float(mass), self.name)
        object.__setattr__(self, "stations", x)
        object.__setattr__(self, "masses", masses)
        for what in ("M", "I_y", "l_G", "S"):
            object.__setattr__(self, what, checks.positive(what, getattr(self, what), self.name))
        object.__setattr__(self, "l_CG", as_station("l_CG", self.l_CG, self.name))
        object.__setattr__(self, "T", checks.not_negative("T", self.T, self.name))
        as_station("thrust point l_CG + l_G", self.thrust_station, self.name)
        checks.instance("flight", self.flight, FlightCondition, self.name)
        for what, parts, kind in (("modes", self.modes, BendingMode), ("surfaces", self.surfaces, Surface)):
            for at, part in enumerate(parts):
                checks.instance(f"{what}[{at}]", part, kind, self.name)

    @property
    def thrust_station(self) -> float:
        """Station of the thrust point G (ft)."""
        return self.l_CG + self.l_G

    @property
    def arms(self) -> NDArray:
        """l_CG - l of each mass (ft), positive ahead of the center of gravity [Table 1]."""
        return self.l_CG - self.stations

    def recomputed(self) -> Self:
        """Return the booster with M, l_CG, I_y and the generalized masses summed from Tables 1 and 2.

        The thrust point stays where it is on the vehicle.
        """
        total = float(self.masses.sum())
        centre = float(self.masses @ self.stations / total)
        inertia = float(self.masses @ (centre - self.stations) ** 2)
        modes = tuple(replace(mode, mass=self._sum_m_phi_squared(mode)) for mode in self.modes)
        return replace(self, M=total, l_CG=centre, I_y=inertia, modes=modes, l_G=self.thrust_station - centre)

    def orthogonalized(self, last_first: bool = False) -> Self:
        """Return the booster with modes that are orthogonal to rigid motion and to each other.

        Parts along translation, rotation and the modes before are taken off by projection, the masses as
        weights (Gram and Schmidt); the first mode, or with ``last_first`` the last, loses the rigid
        parts alone.  Frequencies, damping ratios, phi = 1 at the thrust point and all data but the modes'
        are kept; generalized masses are the sums for the new shapes.
        """
        found: dict[int, BendingMode] = {}
        order = range(len(self.modes))
        for at in reversed(order) if last_first else order:
            mode = purified(self.modes[at], self.stations, self.masses, list(found.values()))
            one = mode.deflection(self.thrust_station)
            mode = replace(mode, deflections=mode.deflections / one, slopes=mode.slopes / one)
            found[at] = replace(mode, mass=self._sum_m_phi_squared(mode))
        modes = tuple(found[at] for at in order)
        return replace(self, modes=modes, name=f"{self.name}, modes orthogonalized")

    def _sum_m_phi_squared(self, mode: BendingMode) -> float:
        phi = np.asarray(mode.deflection(self.stations))
        return generalized_mass(self.masses, phi, phi)


def _mode(which: int) -> BendingMode:
    """Return bending mode 1 or 2 from the data tables [Table 2]."""
    rows = [row for row in read_table("modes") if row["mode"] == str(which)]
    pick = {
        kind: [(float(r["station_ft"]), number(r["value"])) for r in rows if r["kind"] == kind]
        for kind in ("deflection", "slope")
    }
    data = constants("vehicle")
    (x, phi), (at, sigma) = (zip(*pick[kind], strict=True) for kind in ("deflection", "slope"))
    return BendingMode(
        stations=np.array(x),
        deflections=np.array(phi),
        slope_stations=np.array(at),
        slopes=np.array(sigma),
        omega=data[f"omega_{which}"],
        zeta=data[f"zeta_{which}"],
        mass=data[f"mass_{which}"],
        name=f"bending mode {which}",
    )


def swaim_booster() -> Booster:
    """Return the vehicle of Section II at maximum dynamic pressure.

    Returns
    -------
    Booster
        Tables 1 and 2 and the text's figures; what the source lost is recovered
        from the printed coefficients, as each row of ``data/`` says.
    """
    data: dict[str, Any] = {**constants("vehicle")}
    surfaces = tuple(
        Surface(row["name"], float(row["station_ft"]), number(row["C_Nalpha_per_rad"]))
        for row in read_table("surfaces")
    )
    return Booster(
        stations=np.array(column("masses", "station_ft")),
        masses=np.array(column("masses", "mass_slug")),
        **{symbol: data[symbol] for symbol in ("M", "I_y", "l_CG", "l_G", "S", "T")},
        surfaces=surfaces,
        modes=(_mode(1), _mode(2)),
        flight=FlightCondition(
            **{symbol: data[symbol] for symbol in ("q_D", "U", "h", "t")},
            gamma_0=level_at_burnout(swaim_ascent())(data["t"]),
        ),
    )
