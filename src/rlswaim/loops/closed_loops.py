"""The closed loops of the searches by name, at one set of gains: as state space and from determinants.

The two ways share no line, so that each checks the other.
"""

from collections.abc import Mapping
from inspect import signature

import control
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.loops.closures import JetLoop, closure_1_polynomial, theta_numerator
from rlswaim.loops.control_systems import (
    DUAL_ACTUATION,
    RATE_ATTITUDE,
    SINGLE_SENSOR,
    TWO_SENSOR,
    ControlSystem,
)
from rlswaim.loops.gain_terms import gain_terms
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations

LOOPS: dict[str, ControlSystem] = {
    "rate_attitude": RATE_ATTITUDE,
    "rigid_angle": RATE_ATTITUDE,
    "single_sensor": SINGLE_SENSOR,
    "two_sensor": TWO_SENSOR,
    "dual_actuation": DUAL_ACTUATION,
    "modest_jet": DUAL_ACTUATION,
    "figure_25": DUAL_ACTUATION,
}
"""The control system of each search; the searches of one system differ in their bounds."""
SENSORS = {"K_z": "sensor", "K_za": "sensor_a", "K_zb": "sensor_b"}
"""Gain of each linear sensor that feeds the thrust vector, and the name of its station."""


def _loop(system: str, where: str) -> ControlSystem:
    return LOOPS[checks.one_of("system", system, tuple(LOOPS), where)]


def state_space(eqs: PerturbationEquations, system: str, gains: Mapping[str, float]) -> control.StateSpace:
    """Return a closed loop wired by signal name.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        One of `LOOPS`.
    gains : mapping of str to float
        The arguments of its function; a gyro without a station reads the rigid-body angle.
    """
    loop = _loop(system, "state_space")
    return loop.function(eqs, **{**dict.fromkeys(loop.optional), **gains})


def polynomial(eqs: PerturbationEquations, system: str, gains: Mapping[str, float]) -> NDArray:
    """Return the characteristic polynomial of a closed loop from determinants, constant term first.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        One of `LOOPS`.
    gains : mapping of str to float
        The arguments of its function.

    Returns
    -------
    ndarray, shape (9,) or, with a jet, (10,)
    """
    loop = _loop(system, "polynomial")
    given = signature(loop.function).bind(eqs, **{**dict.fromkeys(loop.optional), **gains})
    given.apply_defaults()
    g = {n: checks.real(n, value, "polynomial") for n, value in given.kwargs.items() if value is not None}
    K_C, x = g["K_C"], g["K_A"] * g["K_C"]
    if "jet" in g:
        jet = JetLoop(g["K_r"], g["b"], g["sensor"], g["jet"])
        bottom = npp.polymul([K_C, 1.0], closure_1_polynomial(eqs, jet, g["kK_z"]))
        return npp.polyadd(bottom, x * npp.polymul([1.0, g["K_R"]], theta_numerator(eqs, jet, g["kK_z"])))
    inner = {gain: g[station] for gain, station in SENSORS.items() if gain in g}
    free, at_K_C, at_x, at_y, *at_z = gain_terms(eqs, g.get("gyro"), list(inner.values())).values()
    return (
        free
        + K_C * at_K_C
        + x * (at_x + g["K_R"] * at_y)
        + K_C * sum(g[gain] * p for gain, p in zip(inner, at_z, strict=True))
    )
