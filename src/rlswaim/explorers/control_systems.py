"""The live views of Sections IV to VII: each control system as its parameters, factors and loops."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import control
import numpy as np
from numpy.typing import ArrayLike

from rlswaim.explorers.parameter import FEET, Parameter, Value, whole_station
from rlswaim.explorers.presets import corrected_designs, designs, presets
from rlswaim.explorers.workbench import Explorer
from rlswaim.figures.style import COLORS
from rlswaim.loops import systems
from rlswaim.loops.multiaffine import Forms, MultiAffine, multiaffine_forms, with_shapes
from rlswaim.rootlocus.branches import continuous_branches
from rlswaim.source import checks
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import OUTPUTS, STATES, PerturbationEquations, printed_equations
from rlswaim.vehicle.stations import LENGTH

FEEDBACKS = ("total", "rigid body")
BRANCHES = {
    "attitude": COLORS["rigid"],
    "short period": COLORS["rigid"],
    "mode 1": COLORS["mode 1"],
    "mode 2": COLORS["mode 2"],
    "actuator": COLORS["actuator"],
}
UNITS = {"alpha": "rad", "theta": "rad", "q1": "ft", "q2": "ft", "delta": "rad", "delta_r": "lb"}
AT_SENSOR = {"phi_1": ("deflection", 0), "phi_2": ("deflection", 1)}
AT_GYRO = {"sigma_1": ("slope", 0), "sigma_2": ("slope", 1)}

Shapes = Mapping[str, Mapping[str, tuple[str, int]]]


@dataclass(frozen=True)
class ControlSystem:
    """What a live view of one control system needs to know of it.

    Attributes
    ----------
    name, section : str
    function : callable
        Of `rlswaim.loops.systems`: takes the equations and the parameters.
    gains : mapping of str to (smallest, largest size, whether of both signs)
        The number parameters in the order of their sliders.
    shapes : mapping of station parameter to factors
        What each station enters by: a mode's deflection or slope, or the arm about the centre of gravity.
    groups : tuple of tuple of str
        The factors; those of one group multiply each other in the closed loop's matrices.
    actuators : mapping of factor to branch
        Gains that are minus an actuator's pole.
    loci : tuple of mapping
        The loops in the order in which the report closes them; the gains that they run in are ``closing``.
    """

    name: str
    section: str
    function: Callable[..., control.StateSpace]
    gains: Mapping[str, tuple[float, float, bool]]
    shapes: Shapes
    groups: tuple[tuple[str, ...], ...]
    actuators: Mapping[str, str]
    loci: tuple[Mapping[str, Any], ...]
    choice: bool = False

    @property
    def outputs(self) -> list[str]:
        """The outputs whose numerators the view gets."""
        return [*OUTPUTS, "delta", *(["delta_r"] if "K_r" in self.actuators else [])]

    def at_factors(self, eqs: PerturbationEquations, **factors: float) -> control.StateSpace:
        """Return the closed loop at given factors: a place of its own, 0 or 420 ft, for each station."""
        places = dict(zip(self.shapes, (0.0, LENGTH), strict=False))
        pairs: dict[str, dict[float, tuple[float, ...]]] = {"deflection": {}, "slope": {}}
        arm: dict[str, Any] = {}
        for station, entering in self.shapes.items():
            values = {f: factors.pop(f) for f in entering}
            for kind, at in pairs.items():
                at[places[station]] = tuple(values[f] for f, (k, _) in entering.items() if k == kind)
            if "arm" in values:
                arm = {"l_CG": places[station] - values["arm"]}
        deflections, slopes = ({x: pair for x, pair in at.items() if pair} for at in pairs.values())
        return self.function(replace(with_shapes(eqs, deflections, slopes), **arm), **factors, **places)

    def forms(self, eqs: PerturbationEquations) -> Forms:
        """Return the characteristic polynomial and all numerators in the factors, exactly."""
        return multiaffine_forms(
            lambda **factors: self.at_factors(eqs, **factors), self.groups, self.outputs, OUTPUTS
        )

    def polynomial(self, eqs: PerturbationEquations) -> MultiAffine:
        """Return the characteristic polynomial alone, as `forms` does."""
        return multiaffine_forms(lambda **factors: self.at_factors(eqs, **factors), self.groups).polynomial

    def shape_values(self, eqs: PerturbationEquations) -> dict[str, dict[str, Any]]:
        """Return for each factor of a station the name of that and the values at each foot of the vehicle."""
        return {
            factor: {"at": station, "values": _shape_values(eqs, *enters)}
            for station, entering in self.shapes.items()
            for factor, enters in entering.items()
        }

    def closed_loop(self, eqs: PerturbationEquations, **values: Any) -> control.StateSpace:
        """Return the closed loop of the library at the sliders' values."""
        if values.pop("feedback", "total") == "rigid body":
            values["gyro"] = None
        return self.function(eqs, **values)

    def parameters(self, eqs: PerturbationEquations) -> tuple[Parameter, ...]:
        """Return the parameters with the places of their sliders."""
        known = [*designs(self.section).values(), *corrected_designs(self.section, eqs).values()]
        numbers = [_number(name, *scale, known) for name, scale in self.gains.items()]
        stations = [
            Parameter(
                at, at.replace("_", " ").capitalize(), "ft", f"station of the {at} (ft)", FEET, whole_station
            )
            for at in self.shapes
        ]
        choice = Parameter("feedback", "Feedback", "", "angle fed back", FEEDBACKS, _feedback)
        return (*numbers, *stations, *([choice] if self.choice else []))


MEANINGS = {
    "K_A": ("K_A", "", "amplifier gain (rad/rad)"),
    "K_C": ("K_C", "1/s", "actuator gain (1/s)"),
    "K_R": ("K_R", "s", "rate gyro gain (s)"),
    "K_z": ("K_z", "rad s/ft", "displacement sensor gain (rad s/ft)"),
    "K_za": ("K_{z_a}", "rad s/ft", "gain of sensor a (rad s/ft)"),
    "K_zb": ("K_{z_b}", "rad s/ft", "gain of sensor b (rad s/ft)"),
    "kK_z": ("k K_z", "lb s/ft", "jet constant times sensor gain (lb s/ft)"),
    "K_r": ("K_r", "1/s", "gain of the jet's valve (1/s)"),
    "b": ("b", "1/s", "attitude-to-rate ratio of the sensor (1/s)"),
}
"""Symbol (TeX), unit and meaning of each number parameter."""


def _number(name: str, least: float, most: float, signed: bool, known: list[dict[str, Value]]) -> Parameter:
    """Return a number parameter: its slider runs over round numbers and the designs' own values."""
    size = np.linspace(least, most, 100) if most == 1 else np.geomspace(least, most, 281 if signed else 121)
    places: tuple[ArrayLike, ...] = (-size, 0.0, size) if signed else (size,)
    rounded = [float(f"{place:.3g}") for place in np.hstack(places)]
    symbol, unit, meaning = MEANINGS[name]
    grid = np.union1d(rounded, [float(f"{design[name]:.4g}") for design in known])
    return Parameter(name, rf"\({symbol}\)", unit, f"{name}, {meaning}", tuple(grid.tolist()))


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


def _renamed(shapes: Mapping[str, tuple[str, int]], mark: str) -> dict[str, tuple[str, int]]:
    return {f"{factor}{mark}": enters for factor, enters in shapes.items()}


RATE_ATTITUDE = ControlSystem(
    "rate-attitude",
    "IV",
    systems.rate_attitude,
    ATTITUDE,
    {"gyro": AT_GYRO},
    (("K_A", "K_C"), ("K_R", "sigma_1", "sigma_2")),
    {"K_C": "actuator"},
    (_locus("attitude loop", "K_A"),),
    choice=True,
)
SINGLE_SENSOR = ControlSystem(
    "single-sensor",
    "V",
    systems.single_sensor,
    {**ATTITUDE, "K_z": SENSOR_GAIN},
    {"sensor": AT_SENSOR},
    (("K_C",), ("K_A", "K_R"), ("K_z", "phi_1", "phi_2")),
    {"K_C": "actuator"},
    (_locus("inner loop", "K_z", "K_A"), _locus("outer loop", "K_A")),
)
TWO_SENSOR = ControlSystem(
    "two-sensor",
    "VI",
    systems.two_sensor,
    {**ATTITUDE, "K_za": SENSOR_GAIN, "K_zb": SENSOR_GAIN},
    {"sensor_a": _renamed(AT_SENSOR, "a"), "sensor_b": _renamed(AT_SENSOR, "b")},
    (("K_C",), ("K_A", "K_R"), ("K_za", "phi_1a", "phi_2a"), ("K_zb", "phi_1b", "phi_2b")),
    {"K_C": "actuator"},
    (
        _locus("first closure", "K_za", "K_zb", "K_A"),
        _locus("second closure", "K_zb", "K_A"),
        _locus("outer loop", "K_A"),
    ),
)
DUAL_ACTUATION = ControlSystem(
    "dual-actuation",
    "VII",
    systems.dual_actuation,
    {**ATTITUDE, "kK_z": (1e2, 1e10, True), "K_r": (0.1, 100.0, False), "b": (0.1, 100.0, False)},
    {"sensor": AT_SENSOR, "jet": {"arm": ("arm", 0), **_renamed(AT_SENSOR, "r")}},
    (("K_A", "K_C"), ("K_R",), ("kK_z", "b", "phi_1", "phi_2"), ("K_r", "arm", "phi_1r", "phi_2r")),
    {"K_C": "actuator", "K_r": "valve"},
    (
        _locus("closure 1", "kK_z", "K_A"),
        _locus("closure 2", "kK_z", gain="K_A"),
        _locus("closure 3", "K_A"),
    ),
)
SYSTEMS = {s.section: s for s in (RATE_ATTITUDE, SINGLE_SENSOR, TWO_SENSOR, DUAL_ACTUATION)}


def named_poles(eqs: PerturbationEquations) -> list[tuple[complex, str]]:
    """Return the vehicle's poles (1/s), each with the name of the uncoupled motion that it grows out of.

    The coupling between rigid body, mode 1 and mode 2 (the off-diagonal blocks
    of Eq. 29) is raised from nothing to its size.  The attitude is left out on
    the way: it is the integral of its rate, always a pole at the origin.
    """
    kept = [i for i, state in enumerate(STATES) if state != "theta"]
    A = eqs.state_space().A[np.ix_(kept, kept)]
    block = np.array([0, 0, 1, 1, 2, 2])
    own = block[:, None] == block
    on_the_way = [np.linalg.eigvals(np.where(own, A, share * A)) for share in np.linspace(0, 1, 401)]
    names = np.empty(6, dtype=object)
    for i, name in enumerate(("short period", "mode 1", "mode 2")):
        rows = block == i
        for pole in np.linalg.eigvals(A[np.ix_(rows, rows)]):
            names[np.abs(on_the_way[0] - pole).argmin()] = name
    poles = continuous_branches(np.array(on_the_way, dtype=complex))[-1]
    return [(0j, "attitude"), *zip(poles.tolist(), names.tolist(), strict=True)]


def _shape_values(eqs: PerturbationEquations, kind: str, mode: int) -> list[float]:
    """Return what a station enters the equations by, at each foot of the vehicle."""
    feet = np.array(FEET, dtype=float)
    values = feet - eqs.l_CG if kind == "arm" else getattr(eqs.modes[mode], kind)(feet)
    return np.asarray(values).tolist()


def payload(system: ControlSystem, eqs: PerturbationEquations, forms: Forms) -> dict[str, Any]:
    """Return what the browser gets of a control system with its ``forms``, but where its sliders stand."""
    jet = {"valve": COLORS["jet"]} if "K_r" in system.actuators else {}
    zeros = {"zero": COLORS["neutral"]} if any(locus["of"] == "zeros" for locus in system.loci) else {}
    return {
        "system": system.name,
        "parameters": [{"name": p.name, "grid": p.grid} for p in system.parameters(eqs)],
        "terms": [term._asdict() for term in forms.polynomial.terms],
        "numerators": {
            i: {o: [term._asdict() for term in form.terms] for o, form in by_output.items()}
            for i, by_output in forms.numerators.items()
        },
        "units": {name: UNITS[name] for name in system.outputs},
        "shapes": system.shape_values(eqs),
        "choice": {"name": "feedback", "zero": {"total": [], "rigid body": list(AT_GYRO)}}
        if system.choice
        else None,
        "poles": [{"re": pole.real, "im": pole.imag, "branch": name} for pole, name in named_poles(eqs)],
        "actuators": [{"factor": factor, "branch": name} for factor, name in system.actuators.items()],
        "branches": {**BRANCHES, **jet, **zeros},
        "closing": [locus["running"] for locus in system.loci if locus["of"] == "poles"],
        "loci": list(system.loci),
        "running": {
            **{n: {"magnitudes": [a, z], "signed": signed} for n, (a, z, signed) in system.gains.items()},
            **{station: {"ends": [FEET[0], FEET[-1]], "step": 10, "unit": "ft"} for station in system.shapes},
        },
        "maps": list(system.shapes),
        "vehicle": {
            "length": LENGTH,
            "thrust": swaim_booster().thrust_station,
            "l_CG": eqs.l_CG,
            "U": eqs.U,
            **{f"phi_{i + 1}": _shape_values(eqs, "deflection", i) for i in range(2)},
        },
        "presets": presets(system.section, eqs, system.loci),
        "python": {
            "function": system.function.__name__,
            "equations": _source(eqs),
            "arguments": {name: name for name in (*system.gains, *system.shapes)},
            "none": {"gyro": {"feedback": "rigid body"}} if system.choice else {},
        },
    }


def _source(eqs: PerturbationEquations) -> str:
    """Return the call of the library that gives these equations, ``eqs`` if it is none of the book's."""
    if eqs.source == printed_equations().source:
        return "rl.printed_equations()"
    return "rl.perturbation_equations(rl.swaim_booster())" if eqs.source == swaim_booster().name else "eqs"


def explorer(system: ControlSystem, eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of a control system; values not given are those of its first preset."""
    checks.instance("eqs", eqs, PerturbationEquations, f"{system.name} explorer")
    forms = system.forms(eqs)
    sent = payload(system, eqs, forms)
    return Explorer(
        system.name,
        system.parameters(eqs),
        sent,
        lambda **under: system.closed_loop(eqs, **under),
        {**sent["presets"][0]["values"], **values},
    )


def rate_attitude_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section IV's control system.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float or str
        Where the sliders start: K_A (rad/rad), K_C (1/s), K_R (s), gyro (ft, whole),
        feedback ("total" or "rigid body"); what is not given is that of Figure 8.

    Returns
    -------
    Explorer
        Its attributes are the parameters; ``closed_loop()`` is `rate_attitude` under the sliders.

    Raises
    ------
    ValueError
        If a gain is not finite, the gyro's station is not a whole number of feet
        on the vehicle, or the feedback is unknown.
    TypeError
        If a gain is not a real number or a parameter is unknown.

    Notes
    -----
    Figures 8 to 11, Eqs. 58, 59 and 83.
    """
    return explorer(RATE_ATTITUDE, eqs, **values)


def single_sensor_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section V's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, K_z (rad s/ft) and sensor (ft, whole); what is not given is that of Figure 15.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `single_sensor` under the sliders [Eqs. 98 to 110].
    """
    return explorer(SINGLE_SENSOR, eqs, **values)


def two_sensor_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section VI's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, K_za, K_zb (rad s/ft), sensor_a and sensor_b (ft, whole); what is not given
        is that of Figure 19.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `two_sensor` under the sliders [Eqs. 112 to 114].
    """
    return explorer(TWO_SENSOR, eqs, **values)


def dual_actuation_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section VII's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, kK_z (lb s/ft), K_r, b (1/s), sensor and jet (ft, whole); what is not given
        is that of Figure 24.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `dual_actuation` under the sliders [Eqs. 120 to 130].
    """
    return explorer(DUAL_ACTUATION, eqs, **values)
