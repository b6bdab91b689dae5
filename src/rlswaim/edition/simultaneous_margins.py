"""What a closed loop of Section VII bears in both actuators at once: disk margins of its two loops.

Each actuator's command is multiplied by a complex factor (1 + d/2)/(1 - d/2) of its own.  The disk margin is
the least size of both d at which a root reaches the axis, the structured singular value's reciprocal; with
two of them scaling finds that value exactly (Doyle).
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.robustness import ACTUATORS, FACTORS, stable_matrix
from rlswaim.vehicle.equations import PerturbationEquations

FREQUENCIES = np.geomspace(1e-3, 1e3, 20_001)
"""Frequencies that are tried (rad/s), a fifteenth of a percent apart."""


class Together(NamedTuple):
    """What both loops bear at once.

    Attributes
    ----------
    disk : float
        Every pair of factors with both d smaller than this leaves the loop stable.
    lower, upper : float
        Real factors on the two gains between these leave it stable, each its own.
    phase : float
        As do phase shifts of either sign below this (deg).
    omega : float
        Frequency (rad/s) at which the worst pair puts a root on the axis.
    worst : ndarray of complex, shape (2,)
        That pair: factors on the thrust's command and on the jet's.
    one_down, one_up : float
        The nearest factors on both gains alike at which the loop fails; 0 and infinity without any.
    """

    disk: float
    lower: float
    upper: float
    phase: float
    omega: float
    worst: NDArray
    one_down: float
    one_up: float


def scaled(A: NDArray, factors: NDArray) -> NDArray:
    """Return the loop's state matrix with each actuator's command multiplied.

    Parameters
    ----------
    A : ndarray, shape (9, 9)
    factors : ndarray, shape (..., 2)
        On the thrust's command and on the jet's.

    Returns
    -------
    ndarray, shape (..., 9, 9)
    """
    changed = np.broadcast_to(A, (*factors.shape[:-1], *A.shape)).astype(np.result_type(A, factors))
    for i, at in enumerate(ACTUATORS.values()):
        changed[..., at, :7] *= factors[..., i, None]
    return changed


def together(eqs: PerturbationEquations, gains: Mapping[str, float]) -> Together:
    """Return the margins of a stable loop in both actuators at once.

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.

    Raises
    ------
    ValueError
        If the loop is not stable as it is.
    """
    A = stable_matrix(eqs, gains, "together")
    M = _seen(A)
    coupling = np.abs(M[:, 0, 1] * M[:, 1, 0])
    # The scaling that makes both couplings alike has the least largest singular value.
    total = np.abs(M[:, 0, 0]) ** 2 + np.abs(M[:, 1, 1]) ** 2 + 2 * coupling
    product = np.abs(np.linalg.det(M)) ** 2
    sizes = np.sqrt((total + np.sqrt(np.maximum(total**2 - 4 * product, 0))) / 2)
    at = int(sizes.argmax())
    disk = float(1 / sizes[at])
    fails = FACTORS[np.linalg.eigvals(scaled(A, np.repeat(FACTORS[:, None], 2, 1))).real.max(axis=1) >= 0]
    return Together(
        disk,
        (2 - disk) / (2 + disk),
        (2 + disk) / (2 - disk) if disk < 2 else np.inf,
        float(np.degrees(2 * np.arctan(disk / 2))),
        float(FREQUENCIES[at]),
        _worst(M[at]),
        float(fails[fails < 1].max(initial=0.0)),
        float(fails[fails > 1].min(initial=np.inf)),
    )


def _seen(A: NDArray) -> NDArray:
    """Return what both d meet over the frequencies, the sensitivity less a half; shape (m, 2, 2)."""
    rows, push = np.zeros((2, len(A))), np.zeros((len(A), 2))
    for i, at in enumerate(ACTUATORS.values()):
        rows[i, :7], push[at, i] = A[at, :7] / -A[at, at], -A[at, at]
    s = 1j * FREQUENCIES[:, None, None]
    return np.eye(2) / 2 + rows @ np.linalg.solve(s * np.eye(len(A)) - A, push.astype(complex))


def _worst(M: NDArray) -> NDArray:
    """Return the pair of factors that makes the loop singular at one frequency."""
    d = np.sqrt(np.abs(M[1, 0] / M[0, 1])) if M[0, 1] and M[1, 0] else 1.0
    left, sizes, right = np.linalg.svd(M * [[1, d], [1 / d, 1]])
    delta = right[0].conj() / (sizes[0] * left[:, 0])
    return (1 + delta / 2) / (1 - delta / 2)
