"""The control systems of Sections IV to VII as families of closed loops, at many gains and stations at once.

`systems` wires the same closed loops one by one, by signal name, and checks what is found here.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.loops import systems
from rlswaim.loops.family import Family
from rlswaim.loops.given_shapes import with_shapes
from rlswaim.loops.multiaffine import Forms, MultiAffine, forms
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.source import checks
from rlswaim.vehicle.equations import OUTPUTS, PerturbationEquations
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.stations import LENGTH, as_stations

Entering = Mapping[str, tuple[str, int]]
"""The factors that a station enters by: name to (deflection, slope or arm; which mode)."""

AT_SENSOR: Entering = {"phi_1": ("deflection", 0), "phi_2": ("deflection", 1)}
AT_GYRO: Entering = {"sigma_1": ("slope", 0), "sigma_2": ("slope", 1)}


@dataclass(frozen=True, eq=False)
class ControlSystem:
    """A control system of the report and the factors that its closed loops differ in.

    Attributes
    ----------
    function : callable
        Of `rlswaim.loops.systems`: takes the equations, the gains and the stations.
    stations : mapping of str to Entering
        The factors by which each station enters: a mode's deflection or slope there, or the arm
        about the centre of gravity.
    groups : tuple of tuple of str
        All factors; those of one group multiply each other in the closed loop's matrices.
    actuators : mapping of str to str
        Gains that are minus an actuator's pole, and the names of the branches that start there.
    optional : tuple of str
        Stations that may be None or left out, so that nothing elastic is read there.
    """

    function: Callable[..., control.StateSpace]
    stations: Mapping[str, Entering]
    groups: tuple[tuple[str, ...], ...]
    actuators: Mapping[str, str]
    optional: tuple[str, ...] = ()

    @property
    def gains(self) -> tuple[str, ...]:
        """The factors that do not depend on a station."""
        at_stations = {factor for entering in self.stations.values() for factor in entering}
        return tuple(f for group in self.groups for f in group if f not in at_stations)

    @property
    def outputs(self) -> list[str]:
        """The outputs that a live view shows."""
        return [*OUTPUTS, "delta", *(["delta_r"] if "K_r" in self.actuators else [])]

    def at_factors(self, eqs: PerturbationEquations, **factors: float) -> control.StateSpace:
        """Return the closed loop at given factors.

        The stations are put at different places, and the mode shapes take the given factors there.

        Parameters
        ----------
        eqs : PerturbationEquations
        **factors : float
            All factors of ``groups``.
        """
        places = dict(zip(self.stations, (0.0, LENGTH), strict=False))
        pairs: dict[str, dict[float, tuple[float, ...]]] = {"deflection": {}, "slope": {}}
        arm: dict[str, Any] = {}
        for station, entering in self.stations.items():
            values = {f: factors.pop(f) for f in entering}
            for kind, at in pairs.items():
                at[places[station]] = tuple(values[f] for f, (k, _) in entering.items() if k == kind)
            if "arm" in values:
                arm = {"l_CG": places[station] - values["arm"]}
        deflections, slopes = ({x: pair for x, pair in at.items() if pair} for at in pairs.values())
        return self.function(replace(with_shapes(eqs, deflections, slopes), **arm), **factors, **places)

    def around(self, eqs: PerturbationEquations) -> "ControlledVehicle":
        """Return the control system around the vehicle of ``eqs``, at any gains and stations."""
        return _around(self, eqs)

    def forms(self, eqs: PerturbationEquations) -> Forms:
        """Return the characteristic polynomial and all numerators around ``eqs`` in the factors, exactly."""
        return forms(self.around(eqs).family, self.outputs, OUTPUTS)

    def polynomial(self, eqs: PerturbationEquations) -> MultiAffine:
        """Return the characteristic polynomial around ``eqs`` alone, as `forms` does."""
        return forms(self.around(eqs).family).polynomial


@dataclass(frozen=True, eq=False)
class ControlledVehicle:
    """A control system around one vehicle: closed loops at many gains and stations at once.

    Attributes
    ----------
    system : ControlSystem
    family : Family
    modes : tuple of BendingMode
    l_CG : float
        Station of the center of gravity (ft).
    """

    system: ControlSystem
    family: Family
    modes: tuple[BendingMode, ...]
    l_CG: float

    def factors(self, **given: ArrayLike | None) -> dict[str, NDArray]:
        """Return the factors at gains and stations, each ``given`` as a number or an array.

        Raises
        ------
        TypeError
            If a gain or station is missing, unknown or no real number.
        ValueError
            If one is not finite, or a station lies outside 0..420 ft.
        """
        where, system = self.system.function.__name__, self.system
        wanted = [*system.gains, *system.stations]
        given = {**dict.fromkeys(system.optional), **given}
        if wrong := sorted(set(given) ^ set(wanted)):
            raise TypeError(
                f"gains in {where}: got a missing or unknown {wrong[0]}, wanted {', '.join(wanted)}"
            )
        found = {name: checks.frozen_array(name, np.asarray(given[name]), where) for name in system.gains}
        for station, entering in system.stations.items():
            if (place := given[station]) is None:
                found |= dict.fromkeys(entering, np.zeros(()))
            else:
                x = as_stations(station, place, where)
                found |= {f: entering_value(self.modes, self.l_CG, *by, x) for f, by in entering.items()}
        return found

    def matrices(self, **given: ArrayLike | None) -> NDArray:
        """Return state matrices (..., n, n) at gains and stations whose shapes broadcast.

        Parameters
        ----------
        **given : array_like
            The arguments of the system's function but the equations.

        Returns
        -------
        ndarray
            The states are those of `systems`: the vehicle's seven, then one of each actuator.
        """
        return self.family.matrices(self.factors(**given))

    def abscissas(self, **given: ArrayLike | None) -> NDArray:
        """Return the largest real part of the poles (1/s), shape (...), at ``given`` gains as `matrices`."""
        return np.linalg.eigvals(self.matrices(**given)).real.max(axis=-1)

    def with_pair(self, given: Mapping[str, NDArray], pole: complex = WANTED) -> dict[str, NDArray]:
        """Return gains with the one K_A and K_R that put a pair at a pole, the rest kept.

        Parameters
        ----------
        given : mapping of str to ndarray, shape (S,)
            Gains and stations; K_A and K_R among them do not count.
        pole : complex
            Wanted pole (1/s), off the real axis.

        Notes
        -----
        det(s I - A) is D + K_A (1 + K_R s) N; its values at K_A = 0 and 1 with K_R = 0 give D and N.
        `gain_terms.gains_for_pole` does the same for one loop of Section IV.
        """
        pole = checks.off_axis("pole", pole, "with_pair")
        ends = {"K_A": np.array([[0.0], [1.0]]), "K_R": np.zeros(())}
        A = self.matrices(**{**given, **ends})
        D, one = np.linalg.det(pole * np.eye(A.shape[-1]) - A)
        wanted = D / (D - one)
        product = wanted.imag / pole.imag
        K_A = wanted.real - product * pole.real
        return {**given, "K_A": K_A, "K_R": product / K_A}


@lru_cache(maxsize=32)
def _around(system: ControlSystem, eqs: PerturbationEquations) -> ControlledVehicle:
    """Return a control system around a vehicle; the last ones are kept, since neither can change."""
    family = Family.of(partial(system.at_factors, eqs), system.groups)
    return ControlledVehicle(system, family, eqs.modes, eqs.l_CG)


def entering_value(
    modes: tuple[BendingMode, ...], l_CG: float, kind: str, mode: int, stations: NDArray
) -> NDArray:
    """Return the deflections, slopes or arms by which stations enter the equations.

    Parameters
    ----------
    modes : tuple of BendingMode
    l_CG : float
        Station of the center of gravity (ft).
    kind : str
        ``"deflection"``, ``"slope"`` (1/ft) or ``"arm"`` (ft), the distance behind the center of gravity.
    mode : int
        Which mode, from 0; an arm does not depend on it.
    stations : ndarray
        In feet.
    """
    return stations - l_CG if kind == "arm" else getattr(modes[mode], kind)(stations)


def _marked(entering: Entering, mark: str) -> Entering:
    """Return the same factors with a ``mark`` at the end of their names."""
    return {f"{factor}{mark}": by for factor, by in entering.items()}


RATE_ATTITUDE = ControlSystem(
    systems.rate_attitude,
    {"gyro": AT_GYRO},
    (("K_A", "K_C"), ("K_R", "sigma_1", "sigma_2")),
    {"K_C": "actuator"},
    optional=("gyro",),
)
SINGLE_SENSOR = ControlSystem(
    systems.single_sensor,
    {"sensor": AT_SENSOR},
    (("K_C",), ("K_A", "K_R"), ("K_z", "phi_1", "phi_2")),
    {"K_C": "actuator"},
)
TWO_SENSOR = ControlSystem(
    systems.two_sensor,
    {"sensor_a": _marked(AT_SENSOR, "a"), "sensor_b": _marked(AT_SENSOR, "b")},
    (("K_C",), ("K_A", "K_R"), ("K_za", "phi_1a", "phi_2a"), ("K_zb", "phi_1b", "phi_2b")),
    {"K_C": "actuator"},
)
DUAL_ACTUATION = ControlSystem(
    systems.dual_actuation,
    {"sensor": AT_SENSOR, "jet": {"arm": ("arm", 0), **_marked(AT_SENSOR, "r")}},
    (("K_A", "K_C"), ("K_R",), ("kK_z", "b", "phi_1", "phi_2"), ("K_r", "arm", "phi_1r", "phi_2r")),
    {"K_C": "actuator", "K_r": "valve"},
)
