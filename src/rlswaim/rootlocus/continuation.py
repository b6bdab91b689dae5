"""Branches: closed-loop roots along the gain, each column one continuous curve."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import continuous_branches, in_order, match_roots
from rlswaim.rootlocus.closed_loop import ClosedLoop
from rlswaim.rootlocus.open_loop import OpenLoop

ANCHOR = 16
"""Of a long run of gains each sixteenth starts from eigenvalues, and the others from these."""
LEVELS = 40
"""So often an interval of gains is halved at most where branches are hard to tell apart."""
MOST = 3000
"""So many gains are put between the given ones at most."""
MEET = 1e-5
"""Roots nearer to each other than this, relative to their size, meet: either may be continued by either."""


def solve(closed: ClosedLoop, gains: NDArray, meetings: NDArray) -> NDArray:
    """Return the moving roots (K, n) as branches continuous in the gain, however coarse the gains.

    Parameters
    ----------
    closed : ClosedLoop
    gains : ndarray, shape (K,)
        In any order.
    meetings : ndarray
        The gains at which branches meet.

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    distinct, place = np.unique(gains, return_inverse=True)
    closed.loop.refuse_infinite(distinct)
    if closed.order == 0:  # nothing moves
        return np.zeros((gains.size, 0), complex)
    between = (meetings > distinct[0]) & (meetings < distinct[-1])
    path = np.union1d(distinct, meetings[between])
    values = connected(closed, path, _roots_along(closed, path))
    return values[np.searchsorted(path, distinct)][place]


def _roots_along(closed: ClosedLoop, gains: NDArray) -> NDArray:
    """Return root sets (K, n) for rising ``gains``: from eigenvalues at anchors, from these between them."""
    if gains.size <= 4 * ANCHOR:
        return closed.roots(gains)
    at = np.unique(np.append(np.arange(0, gains.size, ANCHOR), gains.size - 1))
    inner = np.setdiff1d(np.arange(gains.size), at)
    values = np.empty((gains.size, closed.order), dtype=complex)
    values[at] = continuous_branches(closed.roots(gains[at]))
    values[inner] = inserted(closed, gains[at], values[at], gains[inner])
    return values


def inserted(closed: ClosedLoop, known: NDArray, values: NDArray, gains: NDArray) -> NDArray:
    """Return root sets at gains between known ones, unordered.

    Parameters
    ----------
    closed : ClosedLoop
    known : ndarray, shape (K,)
        Rising or falling gains.
    values : ndarray of complex, shape (K, n)
        Branches at the known gains.
    gains : ndarray, shape (m,)

    Returns
    -------
    ndarray of complex, shape (m, n)
    """
    rising = np.argsort(known)
    known, values = known[rising], values[rising]
    right = np.clip(np.searchsorted(known, gains), 1, known.size - 1)
    t = ((gains - known[right - 1]) / (known[right] - known[right - 1]))[:, None]
    return closed.roots(gains, (1 - t) * values[right - 1] + t * values[right])


def connected(closed: ClosedLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return root sets as continuous branches.

    Neighboring sets are paired root by root where each root moves less than its distance
    to the others.  Where one moves more, sets at gains in between are computed and paired.

    Parameters
    ----------
    closed : ClosedLoop
    gains : ndarray, shape (K,)
        Rising or falling.
    values : ndarray of complex, shape (K, n)
        The sets, each in any order.

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    path, sets, given = gains, values, np.ones(gains.size, dtype=bool)
    step, unsure = _paired(closed, gains, values)
    for _ in range(LEVELS):
        at = np.flatnonzero(unsure)
        if not at.size or path.size > gains.size + MOST:
            break
        ends, after = path[[at, at + 1]], np.take_along_axis(sets[at + 1], step[at], axis=1)
        middle = _middle(*ends)
        t = ((middle - ends[0]) / (ends[1] - ends[0]))[:, None]
        between = closed.roots(middle, (1 - t) * sets[at] + t * after)
        low = _paired(closed, np.stack([ends[0], middle]), np.stack([sets[at], between]))
        high = _paired(closed, np.stack([middle, ends[1]]), np.stack([between, sets[at + 1]]))
        step[at], unsure[at] = low[0][0], low[1][0]
        step, unsure = (
            np.insert(part, at + 1, new[0], axis=0) for part, new in zip((step, unsure), high, strict=True)
        )
        path, given = np.insert(path, at + 1, middle), np.insert(given, at + 1, False)
        sets = np.insert(sets, at + 1, between, axis=0)
    return np.take_along_axis(sets, in_order(step), axis=1)[given]


def _middle(a: NDArray, b: NDArray) -> NDArray:
    """Return gains between ``a`` and ``b``: in the middle, of the logarithm where these differ much."""
    small, large = np.minimum(np.abs(a), np.abs(b)), np.maximum(np.abs(a), np.abs(b))
    size = np.sqrt(np.maximum(small, 1e-4 * large)) * np.sqrt(large)
    return np.where((a * b >= 0) & (large > 2 * small), np.sign(a + b) * size, (a + b) / 2)


def _paired(closed: ClosedLoop, gains: NDArray, values: NDArray) -> tuple[NDArray, NDArray]:
    """Return each root's successor in the next set, and for which intervals of gains this is unsure.

    A root's successor is sure if its step, and what its speed at either end promises for the interval,
    is small beside the distance to every root that it does not meet.

    Parameters
    ----------
    closed : ClosedLoop
    gains : ndarray, shape (K,) or (K, M)
    values : ndarray of complex, shape (K, n) or (K, M, n)

    Returns
    -------
    tuple of ndarray, shapes (K - 1, n) and (K - 1,) or (K - 1, M, n) and (K - 1, M)
    """
    shape, n = values.shape, values.shape[-1]
    flat, all_gains = values.reshape(-1, n), gains.ravel()
    tangent, known = closed.tangents(all_gains, flat)
    speed = np.where(known, np.abs(tangent), 0.0)
    gap = np.abs(flat[:, :, None] - flat[:, None])
    gap[gap <= MEET * np.abs(flat)[:, :, None]] = np.inf  # a root met, or the root itself
    M = flat.shape[0] // shape[0]
    before, after = flat[:-M], flat[M:]
    step = match_roots(before, after)
    moved = np.abs(before - np.take_along_axis(after, step, axis=1))
    gap_after = np.take_along_axis(np.take_along_axis(gap[M:], step[:, :, None], 1), step[:, None], 2)
    meets = np.isinf(gap[:-M]) | np.isinf(gap_after)
    nearest = np.where(meets, np.inf, np.minimum(gap[:-M], gap_after)).min(axis=2)
    width = np.abs(all_gains[M:] - all_gains[:-M])
    promised = width[:, None] * np.maximum(speed[:-M], np.take_along_axis(speed[M:], step, axis=1))
    far = ((moved > 0.4 * nearest) | (promised > nearest)).any(axis=1)
    narrow = width <= 1e-9 * np.maximum(np.abs(all_gains[M:]), np.abs(all_gains[:-M]))
    across = passes_infinity(closed.loop, gains).ravel()
    unsure = far & ~narrow & ~across
    return step.reshape(shape[0] - 1, *shape[1:]), unsure.reshape(shape[0] - 1, *shape[1:-1])


def passes_infinity(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return in which intervals of ``gains`` a root of the ``loop`` passes infinity: k = -1/D lies there."""
    side = np.sign(1 + gains * loop.D)
    return np.asarray(side[:-1] != side[1:])
