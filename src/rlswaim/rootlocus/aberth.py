"""Aberth's iteration: all roots of a function at once, for many functions at once."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

Slopes = Callable[[NDArray, NDArray], tuple[NDArray, NDArray]]
"""Takes points (n, K) and the numbers (K,) of their functions, returns f'/f and which roots are found."""


class Roots(NamedTuple):
    """Roots of K functions, shape (n, K), and for which functions (K,) all of them are found."""

    values: NDArray
    found: NDArray


def aberth(slopes: Slopes, guess: NDArray, steps: int) -> Roots:
    """Return the roots of functions, all roots of a function at once.

    Newton's step from s_i would be 1/(f'/f).  The other roots are kept away from: each counts as
    divided out of f, so that the step is 1/(f'/f - sum over j of 1/(s_i - s_j)).  The iteration
    converges cubically at simple roots, and roots near each other do not fall into one.
    The steps end where ``slopes`` says that rounding is all that is left of f.

    Parameters
    ----------
    slopes : callable
        Takes points (n, K) and the numbers of their functions (K,); returns f'/f and
        which of the points are roots to rounding, both of shape (n, K).
    guess : ndarray of complex, shape (n, K)
    steps : int
        Most steps.

    Returns
    -------
    Roots
    """
    s, busy = guess.astype(complex), np.arange(guess.shape[1])
    found = np.ones(busy.size, dtype=bool)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(steps):
            z = s[:, busy]
            slope, done = slopes(z, busy)
            left = ~done.all(axis=0)
            if not left.any():
                return Roots(s, found)
            if not left.all():
                busy, z, slope, done = busy[left], z[:, left], slope[:, left], done[:, left]
            step = 1 / (slope - _repulsion(z))
            s[:, busy] = np.where(done | ~np.isfinite(step), z, z - step)
        found[busy] = slopes(s[:, busy], busy)[1].all(axis=0)
    return Roots(s, found)


def _repulsion(s: NDArray) -> NDArray:
    """Return the sum over j of 1/(s_i - s_j), each column of ``s`` by itself."""
    dx, dy = s.real[:, None] - s.real, s.imag[:, None] - s.imag
    square = dx * dx + dy * dy
    square[square == 0] = np.inf
    return (dx / square).sum(axis=1) - 1j * (dy / square).sum(axis=1)


def starting_points(coefficients: NDArray) -> NDArray:
    """Return first guesses of all roots of a polynomial, on circles around the origin (Bini's choice).

    The radii are the slopes of the upper hull of the points (i, log |p_i|), the ``coefficients``
    running from the constant term up: an edge from i to j stands for j - i roots.
    """
    n, low, found = coefficients.size - 1, int(np.flatnonzero(coefficients)[0]), []
    found.append(np.zeros(low, complex))
    with np.errstate(divide="ignore"):
        heights = np.log(np.abs(coefficients))
    while low < n:
        slopes = (heights[low + 1 :] - heights[low]) / np.arange(1, n - low + 1)
        high = low + 1 + int(np.flatnonzero(slopes == slopes.max())[-1])
        turn = np.arange(high - low) / (high - low) + low / n
        found.append(np.exp(-slopes.max() + 1j * (2 * np.pi * turn + 0.7)))
        low = high
    return np.concatenate(found)


def real_and_conjugate(values: NDArray) -> NDArray:
    """Return ``values`` (n,), roots of a real function, as exact conjugate pairs and exactly real ones.

    Each root is paired with the conjugate of one, itself allowed, so that the total distance is least.
    """
    partner = linear_sum_assignment(np.abs(values[:, None] - values.conj()))[1]
    alone = partner[partner] != np.arange(partner.size)  # equal distances can make a longer chain
    partner[alone] = np.flatnonzero(alone)
    return (values + values[partner].conj()) / 2
