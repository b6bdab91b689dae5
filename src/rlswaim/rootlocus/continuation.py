"""Branches: closed-loop roots along the gain, each column one continuous curve."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import in_order, match_roots, squared_distances
from rlswaim.rootlocus.closed_loop import ClosedLoop, RootSets
from rlswaim.rootlocus.open_loop import OpenLoop

ANCHOR = 16
"""Of a long run of gains each sixteenth starts from eigenvalues, and the others from these."""
PIECES = 8
"""An interval of gains is cut into so many where branches are hard to tell apart."""
LEVELS = 13
"""So often it is cut again at most."""
MOST = 3000
"""So many sets are computed at a time at most where intervals are cut again."""
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
    return connected(closed, _along(closed, path))[np.searchsorted(path, distinct)][place]


def _along(closed: ClosedLoop, gains: NDArray) -> RootSets:
    """Return root sets for rising ``gains``: from eigenvalues at anchors, from these between them."""
    if gains.size <= 4 * ANCHOR:
        return closed.sets(gains)
    number = np.arange(gains.size)
    at = (number % ANCHOR == 0) | (number == gains.size - 1)
    anchors, low = in_branches(closed.sets(gains[at])), number[~at] // ANCHOR
    inner = between(closed, anchors.at(low), anchors.at(low + 1), gains[~at])
    place = np.append(number[at], number[~at]).argsort()
    return RootSets(*(np.concatenate(parts)[place] for parts in zip(anchors, inner, strict=True)))


def in_branches(sets: RootSets) -> RootSets:
    """Return the ``sets`` with each root's column that of the nearest root in the set before."""
    return sets.in_columns(in_order(match_roots(sets.roots[:-1], sets.roots[1:])))


def between(closed: ClosedLoop, low: RootSets, high: RootSets, gains: NDArray) -> RootSets:
    """Return root sets at gains, each between two known sets; first guesses are cubics through these.

    Parameters
    ----------
    closed : ClosedLoop
    low, high : RootSets
        K sets on either side, the roots of a branch in one column.
    gains : ndarray, shape (K,)

    Returns
    -------
    RootSets
    """
    width, chord = (high.gains - low.gains)[:, None], high.roots - low.roots
    t = (gains - low.gains)[:, None] / width
    bends = []
    for end in (low, high):
        tangent = width * end.tangents
        usable = (end.tangents != 0) & (np.abs(tangent) < 3 * np.abs(chord))
        bends.append(np.where(usable, tangent - chord, 0))
    bend = t * (1 - t) * ((1 - t) * bends[0] - t * bends[1])
    return closed.sets(gains, low.roots + t * chord + bend)


def connected(closed: ClosedLoop, sets: RootSets) -> NDArray:
    """Return root sets as continuous branches.

    Neighboring sets are paired root by root where each root moves less than its distance
    to the others.  Where one moves more, sets at gains in between are computed and paired.

    Parameters
    ----------
    closed : ClosedLoop
    sets : RootSets
        K sets at rising or falling gains, each in any order.

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    return sets.in_columns(in_order(_successors(closed, sets, 1, LEVELS))).roots


def _successors(closed: ClosedLoop, sets: RootSets, paths: int, levels: int) -> NDArray:
    """Return each root's successor in the next set, on several paths at once.

    Parameters
    ----------
    closed : ClosedLoop
    sets : RootSets
        The first sets of all paths, the second sets of all paths, and so on, K in all.
    paths : int
    levels : int
        So often an interval may be cut again.

    Returns
    -------
    ndarray of int, shape (K - paths, n)
    """
    before, after = sets.at(slice(None, -paths)), sets.at(slice(paths, None))
    step = match_roots(before.roots, after.roots)
    after = after.in_columns(step)
    at = _unsure(closed, before, after)
    if not at.size or not levels or (levels < LEVELS and at.size * PIECES > MOST):
        return step
    low, high = before.at(at), after.at(at)
    cuts = np.tile(np.arange(at.size), PIECES - 1)
    gains = _cut(low.gains, high.gains).ravel()
    inner = between(closed, low.at(cuts), high.at(cuts), gains)
    path = RootSets(*(np.concatenate(parts) for parts in zip(low, inner, high, strict=True)))
    steps = _successors(closed, path, at.size, levels - 1).reshape(PIECES, at.size, -1)
    way, rows = steps[0], np.arange(at.size)[:, None]
    for piece in steps[1:]:
        way = piece[rows, way]
    step[at] = step[at[:, None], way]
    return step


def _cut(a: NDArray, b: NDArray) -> NDArray:
    """Return gains (PIECES - 1, m) between ``a`` and ``b`` (m,), evenly, or by logarithms if far apart."""
    small, large = np.minimum(np.abs(a), np.abs(b)), np.maximum(np.abs(a), np.abs(b))
    part = (np.arange(1, PIECES) / PIECES)[:, None]
    least = np.maximum(small, 1e-4 * large)
    up = np.where(np.abs(b) > np.abs(a), part, 1 - part)
    by_logarithm = np.sign(a + b) * least * (large / least) ** up
    return np.where((a * b >= 0) & (large > 2 * small), by_logarithm, a + part * (b - a))


def _unsure(closed: ClosedLoop, before: RootSets, after: RootSets) -> NDArray:
    """Return the numbers of those intervals in which a root's successor is unsure.

    It is sure if its step, and what its speed at either end promises for the interval,
    is small beside the distance to every root that it does not meet.

    Parameters
    ----------
    closed : ClosedLoop
    before, after : RootSets
        At the ends of the intervals, the roots in the order of their successors.

    Returns
    -------
    ndarray of int
    """
    width = np.abs(after.gains - before.gains)
    promised = width[:, None] * np.maximum(np.abs(before.tangents), np.abs(after.tangents))
    reach = np.maximum(2.5 * np.abs(after.roots - before.roots), promised)
    wide = width > 1e-9 * np.maximum(np.abs(before.gains), np.abs(after.gains))
    wide &= ~passes_infinity(closed.loop, before.gains, after.gains)
    at = np.flatnonzero(wide & (reach > np.minimum(_nearest(before), _nearest(after))).any(axis=1))
    if at.size:  # what is met at one end counts at neither
        at = at[(reach[at] > _nearest(before.at(at), after.at(at))).any(axis=1)]
    return at


def _nearest(*ends: RootSets) -> NDArray:
    """Return each root's distance (K, n) to the nearest one that it does not meet, at one end or several."""
    squares = [squared_distances(sets.roots, sets.roots) for sets in ends]
    met = [
        square <= (MEET * np.abs(sets.roots)[:, :, None]) ** 2
        for square, sets in zip(squares, ends, strict=True)
    ]
    return np.sqrt(np.where(np.any(met, axis=0), np.inf, np.min(squares, axis=0)).min(axis=2))


def passes_infinity(loop: OpenLoop, a: NDArray, b: NDArray) -> NDArray:
    """Return whether a root passes infinity between two gains: whether -1/D lies there.

    Parameters
    ----------
    loop : OpenLoop
    a, b : ndarray, shape (K,)
        The two gains of each interval.

    Returns
    -------
    ndarray of bool, shape (K,)
    """
    return np.asarray((1 + a * loop.D > 0) != (1 + b * loop.D > 0))
