"""The live views of Sections IV to VII: each control system with its sliders and its loops."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.explorers.parameter import FEET, Parameter, Value, whole_station
from rlswaim.explorers.presets import corrected_designs, designs
from rlswaim.loops import control_systems
from rlswaim.loops.control_systems import ControlSystem, entering_value
from rlswaim.source import checks
from rlswaim.source.quantity import unit_of
from rlswaim.vehicle.equations import PerturbationEquations

FEEDBACKS = ("total", "rigid body")


@dataclass(frozen=True)
class View:
    """What a live view of one control system adds to it.

    Attributes
    ----------
    name, section : str
    system : ControlSystem
    gains : mapping of str to (smallest, largest size, whether of both signs)
        The number parameters in the order of their sliders.
    loci : tuple of mapping
        The loops in the order in which the report closes them; their gains are ``locus_gains``.
    """

    name: str
    section: str
    system: ControlSystem
    gains: Mapping[str, tuple[float, float, bool]]
    loci: tuple[Mapping[str, Any], ...]

    @property
    def choice(self) -> bool:
        """Whether the feedback can be chosen: the total angle, or the rigid body's alone."""
        return "gyro" in self.system.optional

    def closed_loop(self, eqs: PerturbationEquations, **values: Any) -> control.StateSpace:
        """Return the closed loop of the library at the sliders' values.

        Parameters
        ----------
        eqs : PerturbationEquations
        **values : float or str
            By parameter.
        """
        if values.pop("feedback", "total") == "rigid body":
            values["gyro"] = None
        return self.system.function(eqs, **values)

    def shape_values(self, eqs: PerturbationEquations) -> dict[str, dict[str, Any]]:
        """Return for each factor of a station the name of that and its value for ``eqs`` at each foot."""
        return {
            factor: {"at": station, "values": values_at_feet(eqs, *by)}
            for station, entering in self.system.stations.items()
            for factor, by in entering.items()
        }

    def parameters(self, eqs: PerturbationEquations) -> tuple[Parameter, ...]:
        """Return the parameters with the places of their sliders, for the designs of ``eqs``."""
        known = [*designs(self.section).values(), *corrected_designs(self.section, eqs).values()]
        numbers = [_number(name, *scale, known) for name, scale in self.gains.items()]
        stations = [
            Parameter(
                at,
                at.replace("_", " ").capitalize(),
                "ft",
                f"station of the {at.replace('_', ' ')} (ft)",
                FEET,
                whole_station,
            )
            for at in self.system.stations
        ]
        choice = Parameter("feedback", "Feedback", "", "angle fed back", FEEDBACKS, _feedback)
        return (*numbers, *stations, *([choice] if self.choice else []))


MEANINGS = {
    "K_A": ("K_A", "amplifier gain"),
    "K_C": ("K_C", "actuator gain"),
    "K_R": ("K_R", "rate gyro gain"),
    "K_z": ("K_z", "displacement sensor gain"),
    "K_za": ("K_{z_a}", "gain of sensor a"),
    "K_zb": ("K_{z_b}", "gain of sensor b"),
    "kK_z": ("k K_z", "jet constant times sensor gain"),
    "K_r": ("K_r", "gain of the jet's valve"),
    "b": ("b", "attitude-to-rate ratio of the sensor"),
}
"""Symbol (TeX) and meaning of each number parameter."""
UNIT_OF_RATIO = "1/s"
"""Of b, which the report's list of symbols has not."""


FINE_FROM = {"K_A": 0.1, "K_z": 0.01, "K_za": 0.01, "K_zb": 0.01, "kK_z": 1e4}
"""The size from which a slider's places stand close; so most of its travel is where designs lie."""
FINE = np.hstack([np.arange(10, 20, 1), np.arange(20, 40, 2), np.arange(40, 100, 5)])
"""The places of one decade where they stand close."""
COARSE = np.array([10, 20, 50])
"""The places of one decade below."""


def _sizes(name: str, least: float, most: float) -> NDArray:
    """Return the sizes of a slider's places: round numbers, even ones up to 1, else some in each decade."""
    if most == 1:
        return np.linspace(least, most, 100)
    powers = np.arange(np.floor(np.log10(least)), np.log10(most)) - 1
    fine_from = FINE_FROM.get(name, least)
    decades = [(FINE if 10.0 ** (p + 1) >= 0.999 * fine_from else COARSE) * 10.0**p for p in powers]
    return np.hstack([*decades, most])


def _number(name: str, least: float, most: float, signed: bool, known: list[dict[str, Value]]) -> Parameter:
    """Return a number parameter: its slider runs over round numbers and the designs' own values."""
    size = _sizes(name, least, most)
    places: tuple[ArrayLike, ...] = (-size, 0.0, size) if signed else (size,)
    rounded = [float(f"{place:.3g}") for place in np.hstack(places)]
    symbol, meaning = MEANINGS[name]
    unit = UNIT_OF_RATIO if name == "b" else unit_of(symbol)
    shown = "" if unit == "rad/rad" else unit
    grid = np.union1d(rounded, [float(f"{design[name]:.4g}") for design in known])
    return Parameter(name, rf"\({symbol}\)", shown, f"{name}, {meaning} ({unit})", tuple(grid.tolist()))


def _feedback(name: str, value: object, where: str) -> str:
    return checks.one_of(name, value, FEEDBACKS, where)


ATTITUDE: Mapping[str, tuple[float, float, bool]] = {
    "K_A": (1e-4, 1e3, True),
    "K_C": (0.1, 100.0, False),
    "K_R": (0.01, 1.0, True),
}
SENSOR_GAIN = (1e-4, 1e2, True)


def _locus(name: str, running: str, *off: str, **zeros: str) -> dict[str, Any]:
    return {"name": name, "running": running, "off": off, "of": "zeros" if zeros else "poles", **zeros}


RATE_ATTITUDE = View(
    "rate-attitude", "IV", control_systems.RATE_ATTITUDE, ATTITUDE, (_locus("attitude loop", "K_A"),)
)
SINGLE_SENSOR = View(
    "single-sensor",
    "V",
    control_systems.SINGLE_SENSOR,
    {**ATTITUDE, "K_z": SENSOR_GAIN},
    (_locus("inner loop", "K_z", "K_A"), _locus("outer loop", "K_A")),
)
TWO_SENSOR = View(
    "two-sensor",
    "VI",
    control_systems.TWO_SENSOR,
    {**ATTITUDE, "K_za": SENSOR_GAIN, "K_zb": SENSOR_GAIN},
    (
        _locus("first closure", "K_za", "K_zb", "K_A"),
        _locus("second closure", "K_zb", "K_A"),
        _locus("outer loop", "K_A"),
    ),
)
DUAL_ACTUATION = View(
    "dual-actuation",
    "VII",
    control_systems.DUAL_ACTUATION,
    {**ATTITUDE, "kK_z": (1e2, 1e10, True), "K_r": (0.1, 100.0, False), "b": (0.1, 100.0, False)},
    (
        _locus("closure 1", "kK_z", "K_A"),
        _locus("closure 2", "kK_z", gain="K_A"),
        _locus("closure 3", "K_A"),
    ),
)
VIEWS = {view.section: view for view in (RATE_ATTITUDE, SINGLE_SENSOR, TWO_SENSOR, DUAL_ACTUATION)}


def values_at_feet(eqs: PerturbationEquations, kind: str, mode: int) -> list[float]:
    """Return a deflection, a slope or an arm at each foot of the vehicle.

    Parameters
    ----------
    eqs : PerturbationEquations
    kind : str
        ``"deflection"``, ``"slope"`` (1/ft) or ``"arm"`` (ft).
    mode : int
        Which mode, from 0; an arm does not depend on it.

    Returns
    -------
    list of float
        At stations 0 to 420 ft.
    """
    feet = np.array(FEET, dtype=float)
    return np.asarray(entering_value(eqs.modes, eqs.l_CG, kind, mode, feet)).tolist()
