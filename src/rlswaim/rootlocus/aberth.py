"""Aberth's iteration: all roots of a function at once, for many functions at once."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

EPS = float(np.finfo(float).eps)
MEET = 1e-5
"""Roots nearer to each other than this, relative to their size, meet: either may be continued by either."""
Slopes = Callable[[NDArray, NDArray], tuple[NDArray, NDArray, NDArray]]
"""Takes points (n, K) and the numbers (K,) of their functions: f'/f, which are roots, which are blurred."""


class Roots(NamedTuple):
    """Roots of K functions, shape (n, K), for which functions (K,) all are found, and which roots meet."""

    values: NDArray
    found: NDArray
    meet: NDArray


def aberth(slopes: Slopes, guess: NDArray, steps: int) -> Roots:
    """Return the roots of functions, all roots of a function at once.

    Newton's step from s_i would be 1/(f'/f).  The other roots are kept away from: each counts as
    divided out of f, so that the step is 1/(f'/f - sum over j of 1/(s_i - s_j)).  The iteration
    converges cubically at simple roots, and roots near each other do not fall into one.
    A root is found where ``slopes`` says that rounding is all that is left of f, or after a step so
    small that rounding is more than what the next one would be.  Of two blurred roots nearer than
    sqrt(EPS) rounding fixes the middle alone: they are found too.

    Parameters
    ----------
    slopes : callable
        Takes points (n, K) and the numbers of their functions (K,); returns f'/f, which of the points are
        roots to rounding, and at which f is of the size of its rounding, blurred: all of shape (n, K).
    guess : ndarray of complex, shape (n, K)
    steps : int
        Most steps.

    Returns
    -------
    Roots
    """
    z, busy = guess.astype(complex), np.arange(guess.shape[1])
    s, found, meet = z.copy(), np.zeros(busy.size, dtype=bool), np.zeros(z.shape, dtype=bool)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(steps):
            slope, done, blurred = slopes(z, busy)
            push, nearest = _repulsion(z)
            step, closeness = 1 / (slope - push), nearest / np.abs(z) ** 2
            done |= blurred & (closeness <= EPS)
            step[done | ~np.isfinite(step)] = 0
            z = z - step
            ready = (done | _last(step, z, nearest)).all(axis=0)
            s[:, busy], found[busy], meet[:, busy] = z, ready, closeness <= MEET**2
            if ready.all():
                break
            busy, z = busy[~ready], z[:, ~ready]
    return Roots(s, found, meet)


def _repulsion(s: NDArray) -> tuple[NDArray, NDArray]:
    """Return the sum over j of 1/(s_i - s_j), and the least |s_i - s_j|^2, each column of ``s`` by itself."""
    x, y = s.real.copy(), s.imag.copy()  # without gaps in memory
    dx, dy = x[:, None] - x, y[:, None] - y
    square = dx * dx
    square += dy * dy
    square[square == 0] = np.inf
    dx /= square
    dy /= square
    return 1j * dy.sum(axis=0) - dx.sum(axis=0), square.min(axis=0)


def _last(step: NDArray, s: NDArray, nearest: NDArray) -> NDArray:
    """Return whether an Aberth ``step`` to a root ``s`` was the last that rounding leaves anything to do.

    Its error is at most some n |step|^3 / nearest, with the squared distance to the nearest root.
    """
    square = step.real**2 + step.imag**2
    error = len(s) * square / nearest
    return (error <= 1e-4) & (error * np.sqrt(square) <= EPS / 8 * np.abs(s))


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
    """Return ``values`` (n,), roots of a real function, as exact conjugate pairs and exactly real ones."""
    return (values + values[conjugates(values)].conj()) / 2


def conjugates(values: NDArray) -> NDArray:
    """Return for each root of a real function the number of its conjugate, its own where it is real.

    Each is paired with the conjugate of one, itself allowed, so that the total distance is least.

    Parameters
    ----------
    values : ndarray of complex, shape (n,)

    Returns
    -------
    ndarray of int, shape (n,)
    """
    partner = linear_sum_assignment(np.abs(values[:, None] - values.conj()))[1]
    for i in np.flatnonzero(partner[partner] != np.arange(partner.size)):  # equal distances make longer rings
        j = partner[i]
        if partner[j] != i:  # take these two out of their ring
            partner[partner == i], partner[j] = partner[j], i
    return np.asarray(partner)
