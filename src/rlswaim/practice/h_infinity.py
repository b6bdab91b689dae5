"""H-infinity control of the vehicle with its hardware: the worst that disturbances do is made least.

Disturbances are the gust, noise on the commands and the instruments' noise, all as in `Wishes`; what counts
are the outputs and commands that they weigh.  The synthesis solves both Riccati equations by scipy (Zhou,
Doyle, Glover), since SLICOT's, by python-control, returns a controller here that misses its own bound.
"""

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag, solve_continuous_are

from rlswaim.practice.instruments import Instrument
from rlswaim.practice.optimal import NOISE, Wishes, design_plant, rows_of
from rlswaim.vehicle.booster import Booster

SLACK = 1.05
"""The controller is that for so many times the least bound, where its equations are well-conditioned."""


def weighed_plant(
    whole: control.StateSpace, instruments: tuple[Instrument, ...], wishes: Wishes
) -> control.StateSpace:
    """Return a plant from what disturbs and the commands to what counts and what is read, all in their sizes.

    Parameters
    ----------
    whole : control.StateSpace
        From `optimal.design_plant`.
    instruments : tuple of Instrument
    wishes : Wishes
        Without "integral".

    Returns
    -------
    control.StateSpace
        Inputs gust, noise of the commands and of the instruments, commands; outputs what is weighed, the
        commands, readings.
    """
    size, n = wishes.commands(whole.ninputs - 1), whole.nstates
    reads = rows_of(whole, [one.name for one in instruments])
    noise = np.array([NOISE[one.kind] for one in instruments])
    unit = np.array([*wishes.sizes.values()])
    m, k, w = len(size), len(reads), len(unit)
    enters = np.append(wishes.gust, wishes.recovery * size)
    B = np.hstack([whole.B * enters, np.zeros((n, k)), whole.B[:, 1:] * size])
    seen = whole.D[reads] / noise[:, None]
    D = np.zeros((w + m + k, B.shape[1]))
    D[w : w + m, -m:] = np.eye(m)
    D[w + m :] = np.hstack([seen * enters, np.eye(k), seen[:, 1:] * size])
    weighed = whole.C[rows_of(whole, [*wishes.sizes])] / unit[:, None]
    C = np.vstack([weighed, np.zeros((m, n)), whole.C[reads] / noise[:, None]])
    return control.ss(whole.A, B, C, D)


def central_controller(plant: control.StateSpace, k: int, m: int, bound: float) -> control.StateSpace | None:
    """Return the central controller that keeps the worst ratio below a bound, or None if there is none.

    Parameters
    ----------
    plant : control.StateSpace
        From `weighed_plant`: nothing that disturbs reaches what counts at once, and commands count as 1.
    k, m : int
        Number of readings and of commands, the last outputs and inputs.
    bound : float

    Returns
    -------
    control.StateSpace or None
    """
    A, B, C, D = plant.A, plant.B, plant.C, plant.D
    n, q, p = plant.nstates, plant.ninputs - m, plant.noutputs - k
    D21, D22 = D[p:, :q], D[p:, q:]
    try:
        cross = np.hstack([np.zeros((n, q)), C[:p].T @ D[:p, q:]])
        weight = block_diag(-(bound**2) * np.eye(q), np.eye(m))
        X = solve_continuous_are(A, B, C[:p].T @ C[:p], weight, s=cross)
        both = np.hstack([np.zeros((n, p)), B[:, :q] @ D21.T])
        noise = block_diag(-(bound**2) * np.eye(p), D21 @ D21.T)
        Y = solve_continuous_are(A.T, C.T, B[:, :q] @ B[:, :q].T, noise, s=both)
    except np.linalg.LinAlgError:
        return None
    scale = 1e-6 * max(np.abs(X).max(), 1.0)
    definite = np.linalg.eigvalsh(X).min() > -scale and np.linalg.eigvalsh(Y).min() > -scale
    if not definite or np.abs(np.linalg.eigvals(X @ Y)).max() >= bound**2:
        return None
    F = -np.linalg.solve(weight, cross.T + B.T @ X)
    L = -np.linalg.solve(noise, (both + Y @ C.T).T).T[:, p:]
    gain = np.linalg.solve(np.eye(n) - Y @ X / bound**2, L)
    inner = A + B @ F + gain @ (C[p:] + D21 @ F[:q])
    return control.ss(inner + gain @ D22 @ F[q:], -gain, F[q:], np.zeros((m, k)))


def h_infinity(
    booster: Booster, instruments: tuple[Instrument, ...], wishes: Wishes, jet: float | None = None
) -> tuple[control.StateSpace, float]:
    """Return a controller whose worst ratio of what counts to what disturbs is near the least, and its bound.

    Parameters
    ----------
    booster : Booster
    instruments : tuple of Instrument
    wishes : Wishes
        Without "integral".
    jet : float, optional
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace, float

    Raises
    ------
    ValueError
        If no bound below 1000 can be kept.
    """
    whole = design_plant(booster, instruments, jet)
    plant, k, m = weighed_plant(whole, instruments, wishes), len(instruments), whole.ninputs - 1
    low, high = 0.0, 1e3
    while high - low > 1e-3 * high:
        middle = (low + high) / 2
        low, high = (low, middle) if central_controller(plant, k, m, middle) is not None else (middle, high)
    made = central_controller(plant, k, m, SLACK * high)
    if made is None:
        raise ValueError("wishes in h_infinity: got no bound below 1000 that can be kept, wanted other sizes")
    return _in_units(made, instruments, wishes.commands(m)), SLACK * high


def _in_units(
    made: control.StateSpace, instruments: tuple[Instrument, ...], size: NDArray
) -> control.StateSpace:
    """Return a controller of weighed signals for signals in their units; theta_c is subtracted."""
    reads = made.B / np.array([NOISE[one.kind] for one in instruments])
    attitude = np.array([[float(one.kind == "attitude")] for one in instruments])
    return control.ss(
        made.A,
        np.hstack([-reads @ attitude, reads]),
        size[:, None] * made.C,
        np.zeros((size.size, len(instruments) + 1)),
        name="H-infinity",
        inputs=["theta_c", *(one.name for one in instruments)],
        outputs=["delta_c", "delta_r_c"][: size.size],
    )
