"""Branches: closed-loop roots along the gain, each column one continuous curve."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import in_order
from rlswaim.rootlocus.closed_loop import ClosedLoop, RootSets
from rlswaim.rootlocus.successors import discs, kinds_at, matched, unsure

ANCHOR = 16
"""Of a long run of gains each sixteenth starts from eigenvalues, and the others from these."""
PIECES = 8
"""An interval of gains is cut into so many where branches are hard to tell apart."""
LEVELS = 13
"""So often it is cut again at most."""
MOST = 3000
"""So many sets are computed at a time at most where intervals are cut again."""


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
    if path.size <= 4 * ANCHOR:
        found = connected(closed, closed.sets(path)).roots
    else:
        found = _along(closed, path, meetings)
    return found[np.searchsorted(path, distinct)][place]


def _along(closed: ClosedLoop, gains: NDArray, meetings: NDArray) -> NDArray:
    """Return branches (K, n) at rising gains: from eigenvalues at anchors, and from these between them.

    Where an anchor's roots keep apart on the way to the next anchor, and those between move
    by little, each keeps its column.

    Parameters
    ----------
    closed : ClosedLoop
    gains : ndarray, shape (K,)
    meetings : ndarray
        They are anchors too.

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    anchor = np.isin(gains, meetings)
    anchor[::ANCHOR] = anchor[-1] = True
    ends = connected(closed, closed.sets(gains[anchor]))
    low = np.cumsum(anchor) - 1
    inner = between(closed, ends.at(low[~anchor]), ends.at(low[~anchor] + 1), gains[~anchor])
    sets = RootSets(*(np.empty((gains.size, *part.shape[1:]), part.dtype) for part in ends))
    for whole, part, other in zip(sets, ends, inner, strict=True):
        whole[anchor], whole[~anchor] = part, other
    middle, radius, apart = discs(ends.at(slice(None, -1)), ends.at(slice(1, None)))
    at = low[:-1]
    kept = apart[at] & (np.abs(sets.roots[:-1] - middle[at]) <= radius[at])
    return connected(closed, sets, np.flatnonzero(~kept.all(axis=1))).roots


def between(closed: ClosedLoop, low: RootSets, high: RootSets, gains: NDArray) -> RootSets:
    """Return root sets at gains, each between two known sets.

    First guesses are cubics through these or, from a double root, which has no tangent, parabolas in
    the square root of the distance from its gain.

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
    for end, other, way, sign in (low, bends[1], t, 1), (high, bends[0], 1 - t, -1):
        double = end.tangents == 0
        if double.any():
            bend = np.where(double, 2 * sign * (way - np.sqrt(way)) * other, bend)
    return closed.sets(gains, low.roots + t * chord + bend)


def connected(closed: ClosedLoop, sets: RootSets, which: NDArray | None = None) -> RootSets:
    """Return root sets with each column a continuous branch.

    Neighboring sets are paired root by root where each root moves less than its distance
    to the others.  Where one moves more, sets at gains in between are computed and paired.

    Parameters
    ----------
    closed : ClosedLoop
    sets : RootSets
        K sets at rising or falling gains, each in any order.
    which : ndarray of int, optional
        After which sets a root's successor may be in another column; by default after all.

    Returns
    -------
    RootSets
    """
    which = np.arange(sets.gains.size - 1) if which is None else which
    successors = np.tile(np.arange(closed.order), (sets.gains.size - 1, 1))
    successors[which] = _successors(closed, sets.at(which), sets.at(which + 1), LEVELS)
    return sets.in_columns(in_order(successors))


def nearly_connected(closed: ClosedLoop, sets: RootSets) -> tuple[RootSets, NDArray]:
    """Return root sets as `connected` does, without a look at what lies between them, and their kinds.

    Parameters
    ----------
    closed : ClosedLoop
    sets : RootSets
        K sets at rising or falling gains, each in any order.

    Returns
    -------
    RootSets
    ndarray, shape (K - 1, n)
        The kinds that `kinds_at` tells for the starts of the intervals.
    """
    before, after = sets.at(slice(None, -1)), sets.at(slice(1, None))
    kinds = kinds_at(closed, before, after)
    order = in_order(matched(before, after, kinds))
    return sets.in_columns(order), kinds[0][np.arange(len(kinds[0]))[:, None], order[:-1]]


def surely_connected(closed: ClosedLoop, sets: RootSets, kinds: NDArray) -> RootSets:
    """Return root sets from `nearly_connected` as `connected` does.

    Parameters
    ----------
    closed : ClosedLoop
    sets : RootSets
        K sets at rising or falling gains, as `nearly_connected` returns them.
    kinds : ndarray, shape (K - 1, n)
        As it returns them too.

    Returns
    -------
    RootSets
    """
    at = unsure(closed, sets.at(slice(None, -1)), sets.at(slice(1, None)), kinds)
    if not at.size:
        return sets
    successors = np.tile(np.arange(closed.order), (sets.gains.size - 1, 1))
    successors[at] = _followed(closed, sets.at(at), sets.at(at + 1), LEVELS)
    return sets.in_columns(in_order(successors))


def _successors(closed: ClosedLoop, before: RootSets, after: RootSets, levels: int) -> NDArray:
    """Return each root's successor at the other end of its interval of gains.

    Parameters
    ----------
    closed : ClosedLoop
    before, after : RootSets
        At the ends of K intervals.
    levels : int
        So often an interval may be cut again.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    kinds = kinds_at(closed, before, after)
    step = matched(before, after, kinds)
    after = after.in_columns(step)
    at = unsure(closed, before, after, kinds[0])
    if not at.size or not levels or (levels < LEVELS and at.size * PIECES > MOST):
        return step
    way = _followed(closed, before.at(at), after.at(at), levels)
    step[at] = step[at[:, None], way]
    return step


def _followed(closed: ClosedLoop, low: RootSets, high: RootSets, levels: int) -> NDArray:
    """Return each root's successor as `_successors` does, by a look at gains in between.

    Parameters
    ----------
    closed : ClosedLoop
    low, high : RootSets
        At the ends of K intervals, the roots in the order of what the ends tell.
    levels : int
        So often an interval may be cut, this time included.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    count = low.gains.size
    cuts = np.tile(np.arange(count), PIECES - 1)
    inner = between(closed, low.at(cuts), high.at(cuts), _cut(low.gains, high.gains).ravel())
    starts, ends = (
        RootSets(*(np.concatenate(parts) for parts in zip(a, b, strict=True)))
        for a, b in ((low, inner), (inner, high))
    )
    steps = _successors(closed, starts, ends, levels - 1).reshape(PIECES, count, -1)
    way, rows = steps[0], np.arange(count)[:, None]
    for piece in steps[1:]:
        way = piece[rows, way]
    return way


def _cut(a: NDArray, b: NDArray) -> NDArray:
    """Return gains (PIECES - 1, m) between ``a`` and ``b`` (m,), evenly, or by logarithms if far apart."""
    small, large = np.minimum(np.abs(a), np.abs(b)), np.maximum(np.abs(a), np.abs(b))
    part = (np.arange(1, PIECES) / PIECES)[:, None]
    least = np.maximum(small, 1e-4 * large)
    up = np.where(np.abs(b) > np.abs(a), part, 1 - part)
    by_logarithm = np.sign(a + b) * least * (large / least) ** up
    return np.where((a * b >= 0) & (large > 2 * small), by_logarithm, a + part * (b - a))
