"""Branches: closed-loop roots along the gain, each column one continuous curve."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import assigned, in_order, squared_distances
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
    middle, radius, apart = _discs(ends.at(slice(None, -1)), ends.at(slice(1, None)))
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


def nearly_connected(closed: ClosedLoop, sets: RootSets) -> RootSets:
    """Return root sets as `connected` does, without a look at what lies between them."""
    before, after = sets.at(slice(None, -1)), sets.at(slice(1, None))
    return sets.in_columns(in_order(_matched(before, after, _kinds(closed, before, after))))


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
    kinds = _kinds(closed, before, after)
    step = _matched(before, after, kinds)
    after = after.in_columns(step)
    width = np.abs(after.gains - before.gains)
    wide = width > 1e-9 * np.maximum(np.abs(before.gains), np.abs(after.gains))
    wide &= ~passes_infinity(closed.loop, before.gains, after.gains)
    at = np.flatnonzero(wide & ~_discs(before, after, kinds[0]).apart.all(axis=1))
    if not at.size or not levels or (levels < LEVELS and at.size * PIECES > MOST):
        return step
    low, high = before.at(at), after.at(at)
    cuts = np.tile(np.arange(at.size), PIECES - 1)
    inner = between(closed, low.at(cuts), high.at(cuts), _cut(low.gains, high.gains).ravel())
    starts, ends = (
        RootSets(*(np.concatenate(parts) for parts in zip(a, b, strict=True)))
        for a, b in ((low, inner), (inner, high))
    )
    steps = _successors(closed, starts, ends, levels - 1).reshape(PIECES, at.size, -1)
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


def _kinds(closed: ClosedLoop, before: RootSets, after: RootSets) -> list[NDArray]:
    """Return a number for each root (K, n) at both ends of K intervals: only an equal one can succeed it.

    Where no branches meet on the way, real roots stay real and in order, and complex ones on their
    side of the real axis.  A double root at one end may be two real ones or a pair.  Where the ends
    do not tell which, all numbers are equal.

    Parameters
    ----------
    closed : ClosedLoop
    before, after : RootSets

    Returns
    -------
    list of ndarray
        For ``before`` and ``after``.
    """
    ends = before, after
    kinds, doubles = [np.sign(sets.roots.imag) for sets in ends], [sets.tangents == 0 for sets in ends]
    open_ = doubles[0].any(axis=1) & doubles[1].any(axis=1)
    unlike = (kinds[0] == 0).sum(axis=1) != (kinds[1] == 0).sum(axis=1)
    if unlike.any():
        for kind, double in zip(kinds, doubles, strict=True):
            turned = double & (unlike & (double.sum(axis=1) == 2))[:, None]
            sides = 2 * (turned.cumsum(axis=1) % 2) - 1
            kind[turned] = np.where(kind == 0, sides, 0)[turned]
        open_ |= (kinds[0] == 0).sum(axis=1) != (kinds[1] == 0).sum(axis=1)
    open_ |= passes_infinity(closed.loop, before.gains, after.gains)
    for i, sets in enumerate(ends):
        real = kinds[i] == 0
        rank = np.where(real, sets.roots.real, np.inf).argsort(axis=1).argsort(axis=1)
        kinds[i] = np.where(open_[:, None], 0, np.where(real, 2 + rank, kinds[i]))
    return kinds


def _matched(before: RootSets, after: RootSets, kinds: list[NDArray]) -> NDArray:
    """Return each root's successor (K, n): the nearest of its kind.

    Parameters
    ----------
    before, after : RootSets
        At the ends of K intervals.
    kinds : list of ndarray
        As `_kinds` tells them.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    square = squared_distances(before.roots, after.roots)
    square[kinds[0][:, :, None] != kinds[1][:, None]] = np.inf
    return assigned(square)


class _Discs(NamedTuple):
    """For each root (K, n) a disc that its way stays in, and whether it is apart from the others' discs."""

    middle: NDArray
    radius: NDArray
    apart: NDArray


def _discs(before: RootSets, after: RootSets, kinds: NDArray | None = None) -> _Discs:
    """Return discs around the ways of roots, as wide as their steps and their speeds at either end promise.

    Two roots that meet at an end are apart whatever their discs.

    Parameters
    ----------
    before, after : RootSets
        At the ends of K intervals, the roots in the order of their successors.
    kinds : ndarray, shape (K, n), optional
        A disc has to be apart from those of its own kind; by default from all.

    Returns
    -------
    _Discs
    """
    width, middle = np.abs(after.gains - before.gains), (before.roots + after.roots) / 2
    promised = width[:, None] * np.maximum(np.abs(before.tangents), np.abs(after.tangents))
    radius = np.maximum(1.25 * np.abs(after.roots - before.roots), promised)
    near = squared_distances(middle, middle) <= (radius[:, :, None] + radius[:, None]) ** 2
    if kinds is not None:
        near &= kinds[:, :, None] == kinds[:, None]
    for double in (before.tangents == 0, after.tangents == 0):
        if double.any():
            near &= ~(double[:, :, None] & double[:, None])
    own = np.arange(near.shape[1])
    near[:, own, own] = False
    return _Discs(middle, radius, ~near.any(axis=2))


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
