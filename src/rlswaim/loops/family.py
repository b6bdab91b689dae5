"""The closed loops of Sections IV to VII at many gains at once, and at one set of gains two other ways.

`state_matrices` serves the searches; `closed_loop`, wired by signal name, and `determinants`, from
polynomials, check what they find.
"""

from collections.abc import Callable, Mapping
from functools import partial
from inspect import signature

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.loops import systems
from rlswaim.loops.certificates import gain_terms
from rlswaim.loops.closures import JetLoop, closed_1, theta_numerator
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations

LOOPS: dict[str, Callable[..., control.StateSpace]] = {
    "rate_attitude": systems.rate_attitude,
    "rigid_angle": partial(systems.rate_attitude, gyro=None),
    "single_sensor": systems.single_sensor,
    "two_sensor": systems.two_sensor,
    "dual_actuation": systems.dual_actuation,
    "modest_jet": systems.dual_actuation,
    "figure_25": systems.dual_actuation,
}
SENSORS = {"K_z": "sensor", "K_za": "sensor_a", "K_zb": "sensor_b"}
"""Gain of each linear sensor that feeds the thrust vector, and the name of its station."""


def _readings(modes: tuple, stations: NDArray, what: str) -> NDArray:
    """Return phi or sigma at stations (ft) as weights of the states q1 and q2; shape (S, 7)."""
    rows = np.zeros((stations.size, 7))
    rows[:, 3], rows[:, 5] = (getattr(mode, what)(stations) for mode in modes)
    return rows


def _angle(eqs: PerturbationEquations, gains: Mapping[str, NDArray]) -> NDArray:
    """Return the angle that the gyro reads as weights of the states, rates left out; shape (S, 7)."""
    rows = np.zeros((gains["K_C"].size, 7))
    if "gyro" in gains:
        rows -= _readings(eqs.modes, gains["gyro"], "slope")
    rows[:, 1] = 1.0
    return rows


def state_matrices(eqs: PerturbationEquations, gains: Mapping[str, NDArray]) -> NDArray:
    """Return closed-loop state matrices at many gains at once, as `systems` wires them one by one.

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to ndarray, shape (S,)
        Gains and stations of one of `LOOPS`, by the names of its arguments; a gyro without a
        station reads the rigid-body angle.

    Returns
    -------
    ndarray, shape (S, 8, 8) or, with a jet, (S, 9, 9)
    """
    if missing := [name for name in ("K_A", "K_C", "K_R") if name not in gains]:
        raise TypeError(f"gains in state_matrices: got {', '.join(gains)}, wanted {missing[0]} too")
    g = {name: checks.frozen_array(name, v, "state_matrices")[:, None] for name, v in gains.items()}
    angle = _angle(eqs, gains)
    # A rate is the state after the one it belongs to.
    thrust = -g["K_A"] * (angle + g["K_R"] * np.roll(angle, 1, axis=1))
    for gain, station in SENSORS.items():
        if gain in g:
            bent = _readings(eqs.modes, gains[station], "deflection")
            thrust = thrust + g[gain] * (bent + np.roll(bent, 1, axis=1))
    vehicle, n = eqs.state_space(), 8 + ("jet" in g)
    A = np.zeros((len(angle), n, n))
    A[:, :7, :7], A[:, :7, 7] = vehicle.A, vehicle.B[:, 0]
    A[:, 7, :7], A[:, 7, 7] = g["K_C"] * thrust, -gains["K_C"]
    if "jet" in g:
        bent = _readings(eqs.modes, gains["sensor"], "deflection")
        A[:, 8, :7] = g["K_r"] * g["kK_z"] * (g["b"] * bent + np.roll(bent, 1, axis=1))
        A[:, 8, 8], A[:, :7, 8] = -gains["K_r"], _jet(eqs, gains["jet"])
    return A


def _jet(eqs: PerturbationEquations, stations: NDArray) -> NDArray:
    """Return what one pound of the jet does to the states, by its stations (ft); shape (S, 7) [Eq. 125]."""
    column = -_readings(eqs.modes, stations, "deflection") * [0, 0, 0, eqs.jet["F1"], 0, eqs.jet["F2"], 0]
    column = np.roll(column, 1, axis=1)
    column[:, 0], column[:, 2] = eqs.jet["Z"] / eqs.U, eqs.jet["M"] * (stations - eqs.l_CG)
    return column


def with_pair(
    eqs: PerturbationEquations, gains: Mapping[str, NDArray], pole: complex = WANTED
) -> dict[str, NDArray]:
    """Return the ``gains`` (S,) with the one K_A and K_R that put a pair at a ``pole`` (1/s), the rest kept.

    With x the states that a unit signal at the actuator moves at s = pole, and N x the angle
    read, the loop closes at K_A (1 + K_R s) = -1 / (N x): `certificates.gains_for_pole` for all loops.
    """
    pole, none = checks.off_axis("pole", pole, "with_pair"), np.zeros_like(gains["K_C"])
    A = state_matrices(eqs, {**gains, "K_A": none, "K_R": none})
    push = np.zeros((*A.shape[:2], 1))
    push[:, 7, 0] = gains["K_C"]
    x = np.linalg.solve(pole * np.eye(A.shape[1]) - A, push)[:, :7, 0]
    wanted = -1 / (_angle(eqs, gains) * x).sum(axis=1)
    product = wanted.imag / pole.imag
    K_A = wanted.real - product * pole.real
    return {**gains, "K_A": K_A, "K_R": product / K_A}


def closed_loop(eqs: PerturbationEquations, system: str, gains: Mapping[str, float]) -> control.StateSpace:
    """Return the closed loop of one of `LOOPS` (``system``) at its ``gains``, as state space."""
    return LOOPS[checks.one_of("system", system, tuple(LOOPS), "closed_loop")](eqs, **gains)


def determinants(eqs: PerturbationEquations, system: str, gains: Mapping[str, float]) -> NDArray:
    """Return the characteristic polynomial of the same loop from determinants, constant term first.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        One of `LOOPS`.
    gains : mapping of str to float
        The arguments of its function.
    """
    loop = signature(LOOPS[checks.one_of("system", system, tuple(LOOPS), "determinants")])
    given = loop.bind(eqs, **gains)
    given.apply_defaults()
    g = {n: checks.real(n, value, "determinants") for n, value in given.kwargs.items() if value is not None}
    K_C, x = g["K_C"], g["K_A"] * g["K_C"]
    if "jet" in g:
        jet = JetLoop(g["K_r"], g["b"], g["sensor"], g["jet"])
        bottom = npp.polymul([K_C, 1.0], closed_1(eqs, jet, g["kK_z"]))
        return npp.polyadd(bottom, x * npp.polymul([1.0, g["K_R"]], theta_numerator(eqs, jet, g["kK_z"])))
    inner = {gain: g[station] for gain, station in SENSORS.items() if gain in g}
    free, at_K_C, at_x, at_y, *at_z = gain_terms(eqs, g.get("gyro"), list(inner.values())).values()
    return (
        free
        + K_C * at_K_C
        + x * (at_x + g["K_R"] * at_y)
        + K_C * sum(g[gain] * p for gain, p in zip(inner, at_z, strict=True))
    )
