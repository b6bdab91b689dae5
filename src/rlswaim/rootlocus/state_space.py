"""Poles and zeros of a state space, as eigenvalues of its matrices."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig, matrix_balance

from rlswaim.rootlocus.aberth import EPS, real_and_conjugate
from rlswaim.rootlocus.exact_polynomials import exact_transfer, plus, times
from rlswaim.rootlocus.polynomials import trimmed
from rlswaim.rootlocus.repeated_roots import Points, grouped, refined

EXACT = 32
"""Up to this order eigenvalues are refined on the characteristic polynomial, computed without rounding."""


class Transfer(NamedTuple):
    """Zeros, poles and gain of a transfer function, and its coefficients, constant term first."""

    zeros: Points
    poles: Points
    gain: float
    numerator: NDArray
    denominator: NDArray


def transfer_of_state_space(A: NDArray, B: NDArray, C: NDArray, D: NDArray) -> Transfer:
    """Return the zeros, poles and gain of C (sI - A)^-1 B + D, none of them cancelled.

    Poles are eigenvalues of A, zeros those of the pencil [A - sI, B; C, D].

    Parameters
    ----------
    A, B, C, D : ndarray, shapes (n, n), (n, 1), (1, n) and (1, 1)

    Returns
    -------
    Transfer
    """
    poles = _eigenvalues(A)
    if len(A) <= EXACT:
        numerator, denominator = exact_transfer(A, B, C)
        numerator = plus(numerator, times(denominator, float(D[0, 0])))
        zeros = _zeros(A, B, C, D, numerator.degree)
        coefficients = trimmed(numerator.rounded)
        zeros, poles = (refined(*part) for part in ((numerator, zeros), (denominator, poles)))
        return Transfer(zeros, poles, float(coefficients[-1]), coefficients, denominator.rounded)
    order, gain = _leading(A, B, C, float(D[0, 0]))
    zeros, poles = grouped(_zeros(A, B, C, D, order)), grouped(poles)
    N, D_ = (np.atleast_1d(np.poly(part.values)).real[::-1] for part in (zeros, poles))
    return Transfer(zeros, poles, gain, gain * N, D_)


def _eigenvalues(A: NDArray) -> Points:
    """Return the eigenvalues of a matrix: rounding moves each by eps |A| |y| |x| / |y^H x|."""
    balanced = matrix_balance(A, permute=False)[0]
    values, left, right = eig(balanced, left=True, right=True)
    with np.errstate(divide="ignore"):
        errors = EPS * np.linalg.norm(balanced) / np.abs((left.conj() * right).sum(axis=0))
    return Points(values, errors)


def _zeros(A: NDArray, B: NDArray, C: NDArray, D: NDArray, count: int) -> Points:
    """Return the ``count`` finite eigenvalues of the pencil [A - sI, B; C, D]."""
    if count == 0:
        return Points(np.zeros(0, complex), np.zeros(0))
    balanced, (scale, _) = matrix_balance(A, permute=False, separate=True)
    B, C, size = B / scale[:, None], C * scale, max(float(np.linalg.norm(balanced)), 1e-300)
    b, c = (size / max(float(np.linalg.norm(part)), 1e-300) for part in (B, C))
    matrix = np.block([[balanced, b * B], [c * C, b * c * D]])
    moving = np.diag(np.append(np.ones(len(A)), 0.0))
    with np.errstate(all="ignore"):
        values, left, right = eig(matrix, moving, left=True, right=True)
        along = np.abs((left[:-1].conj() * right[:-1]).sum(axis=0))
        lengths = np.linalg.norm(left, axis=0) * np.linalg.norm(right, axis=0)
        errors = EPS * (np.linalg.norm(matrix) + np.abs(values)) * lengths / along
    values[~np.isfinite(values)], errors[~np.isfinite(errors)] = 1e300, np.inf
    finite = np.abs(values).argsort(kind="stable")[:count]
    return Points(real_and_conjugate(values[finite]), errors[finite])


def _leading(A: NDArray, B: NDArray, C: NDArray, D: float) -> tuple[int, float]:
    """Return how many finite zeros there are, and the gain: D, or the first C A^i B that is not 0."""
    if D:
        return len(A), D
    reached = B
    for i in range(len(A)):
        gain = float((C @ reached).item())
        if abs(gain) > len(A) * EPS * (np.abs(C) @ np.abs(reached)).item():
            return len(A) - 1 - i, gain
        reached = A @ reached
    return 0, 0.0
