"""Optimal control for the vehicle with its hardware: LQR, LQG, loop-transfer recovery.

The cost weighs outputs of the plant and its commands, each over the size that counts as much as the others
(Bryson's rule).  The controllers read the attitude's error, whose integral is among what is weighed, so a
constant command is followed.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_continuous_are

from rlswaim.practice.dispersed import with_gravity
from rlswaim.practice.hardware import Hardware, plant, real_hardware
from rlswaim.practice.instruments import Instrument
from rlswaim.practice.loads import section_loads, with_moments
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import JET_STATION

MIDDLE = 200.0
"""Station of the bending moment that a design may weigh (ft): where the vehicle is bent most."""

NOISE = {"attitude": 2e-4, "rate": 5e-4, "accelerometer": 0.1, "vane": 2e-3}
"""White noise of each kind of instrument (rad, rad/s, ft/s^2, rad; each times the root of a second)."""


@dataclass(frozen=True)
class Wishes:
    """What an optimal design weighs.

    Attributes
    ----------
    sizes : mapping of str to float
        Size of each output of the plant that counts as 1, and of "integral", that of the attitude (rad s).
    delta, jet : float
        Size of the engine's angle (rad) and of the jet's force (lb) that counts as 1.
    gust : float
        Intensity of the gust that the filter expects (rad times the root of a second).
    recovery : float
        Noise on the commands that the filter expects, in sizes of them: larger recovers more of the
        regulator's loop.
    """

    sizes: Mapping[str, float]
    delta: float = 0.02
    jet: float = 1e5
    gust: float = 0.02
    recovery: float = 0.0

    def commands(self, count: int) -> NDArray:
        """Return the sizes of the first ``count`` commands."""
        return np.array([self.delta, self.jet])[:count]


def design_plant(
    booster: Booster, instruments: tuple[Instrument, ...], jet: float | None
) -> control.StateSpace:
    """Return the plant that a design is made for: the gyros' lag counts as more delay, of the first order.

    Parameters
    ----------
    booster : Booster
    instruments : tuple of Instrument
    jet : float or None
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace
        With further outputs "moment 200" (lb ft) and drift, the velocity across the path (ft/s).
    """
    real, eqs = real_hardware(), with_gravity(booster)
    lag = 2 * real.gyro_zeta / real.gyro_omega
    made = Hardware(real.actuator_omega, real.actuator_zeta, delay=real.delay + lag, pade_order=1)
    whole = plant(eqs, instruments, made, jet)
    loads = section_loads(booster, eqs, [MIDDLE], JET_STATION if jet is None else jet)
    bent = with_moments(whole, loads)
    alpha, theta = rows_of(whole, ["alpha", "theta"])
    drift = eqs.U * (whole.C[alpha] - whole.C[theta])
    return control.ss(
        bent.A,
        bent.B,
        np.vstack([bent.C, drift]),
        np.vstack([bent.D, np.zeros(bent.ninputs)]),
        inputs=whole.input_labels,
        outputs=[*bent.output_labels, "drift"],
    )


def rows_of(whole: control.StateSpace, names: Sequence[str]) -> list[int]:
    """Return where outputs of a plant stand.

    Parameters
    ----------
    whole : control.StateSpace
    names : sequence of str
    """
    return [list(whole.output_labels).index(name) for name in names]


def _with_integral(whole: control.StateSpace, attitude: str) -> tuple[NDArray, NDArray]:
    """Return A and the commands' B of a plant with the integral of one output as the last state."""
    at, n = rows_of(whole, [attitude]), whole.nstates
    A = np.block([[whole.A, np.zeros((n, 1))], [whole.C[at], np.zeros((1, 1))]])
    return A, np.vstack([whole.B[:, 1:], whole.D[at, 1:]])


def regulator(whole: control.StateSpace, wishes: Wishes, attitude: str) -> NDArray:
    """Return the optimal feedback of all states and of the attitude's integral.

    Parameters
    ----------
    whole : control.StateSpace
        From `design_plant`.
    wishes : Wishes
    attitude : str
        Output whose integral is weighed.

    Returns
    -------
    ndarray, shape (commands, states + 1)
    """
    A, B = _with_integral(whole, attitude)
    Q = 1e-9 * np.eye(len(A))
    for name, size in wishes.sizes.items():
        row = np.eye(len(A))[-1] if name == "integral" else np.append(whole.C[rows_of(whole, [name])[0]], 0.0)
        Q += np.outer(row, row) / size**2
    K, _, _ = control.lqr(A, B, Q, np.diag(wishes.commands(B.shape[1]) ** -2.0))
    return np.asarray(K)


def regulated(
    booster: Booster,
    instruments: tuple[Instrument, ...],
    wishes: Wishes,
    jet: float | None = None,
    opened: int | None = None,
) -> control.StateSpace:
    """Return the loop of `regulator` on the plant that it is made for, all states known.

    Parameters
    ----------
    booster : Booster
    instruments : tuple of Instrument
        The integral is that of the first attitude gyro.
    wishes : Wishes
    jet : float, optional
        Station of the jet (ft).
    opened : int, optional
        Which command the loop is opened at, the rest closed.

    Returns
    -------
    control.StateSpace
        From alpha_g to the outputs of `design_plant`; L(s) with ``opened``.
    """
    whole = design_plant(booster, instruments, jet)
    attitude = next(one.name for one in instruments if one.kind == "attitude")
    (A, B), K = _with_integral(whole, attitude), regulator(whole, wishes, attitude)
    if opened is not None:
        rest = [i for i in range(len(K)) if i != opened]
        return control.ss(A - B[:, rest] @ K[rest], B[:, [opened]], K[[opened]], 0)
    gust = np.vstack([whole.B[:, :1], whole.D[rows_of(whole, [attitude]), :1]])
    C = np.hstack([whole.C, np.zeros((whole.noutputs, 1))]) - whole.D[:, 1:] @ K
    return control.ss(A - B @ K, gust, C, whole.D[:, :1], inputs=["alpha_g"], outputs=whole.output_labels)


def kalman(whole: control.StateSpace, instruments: tuple[Instrument, ...], wishes: Wishes) -> NDArray:
    """Return the gain of the filter that estimates a plant's states from its instruments.

    Parameters
    ----------
    whole : control.StateSpace
    instruments : tuple of Instrument
    wishes : Wishes

    Returns
    -------
    ndarray, shape (states, instruments)
    """
    C = whole.C[rows_of(whole, [one.name for one in instruments])]
    noise = np.diag([NOISE[one.kind] ** 2 for one in instruments])
    expected = np.append(wishes.gust, wishes.recovery * wishes.commands(whole.ninputs - 1))
    spread = (whole.B * expected**2) @ whole.B.T + 1e-12 * np.eye(whole.nstates)
    P = solve_continuous_are(whole.A.T, C.T, spread, noise)
    return np.asarray(P @ C.T / np.diag(noise))


def lqg(
    booster: Booster, instruments: tuple[Instrument, ...], wishes: Wishes, jet: float | None = None
) -> control.StateSpace:
    """Return the controller that feeds back the estimates of all states, and the attitude's integral.

    Parameters
    ----------
    booster : Booster
    instruments : tuple of Instrument
        The first attitude gyro is the one that follows theta_c.
    wishes : Wishes
    jet : float, optional
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace
        Inputs theta_c and the instruments, outputs the commands.
    """
    whole = design_plant(booster, instruments, jet)
    attitude = next(one.name for one in instruments if one.kind == "attitude")
    K, L = regulator(whole, wishes, attitude), kalman(whole, instruments, wishes)
    rows = rows_of(whole, [one.name for one in instruments])
    C, D, B = whole.C[rows], whole.D[rows][:, 1:], whole.B[:, 1:]
    n, m = whole.nstates, len(instruments)
    # x' = A x + B u + L (y - C x - D u), e' = attitude - theta_c, u = -K (x, e)
    A = np.zeros((n + 1, n + 1))
    A[:n, :n] = whole.A - L @ C
    A[:n] -= (B - L @ D) @ K
    reads = np.vstack([L, [float(one.name == attitude) for one in instruments]])
    follows = -reads @ [[float(one.kind == "attitude")] for one in instruments]
    return control.ss(
        A,
        np.hstack([follows, reads]),
        -K,
        np.zeros((len(K), m + 1)),
        name="LQG",
        inputs=["theta_c", *(one.name for one in instruments)],
        outputs=["delta_c", "delta_r_c"][: len(K)],
    )
