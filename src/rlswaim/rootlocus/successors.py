"""Which root at one gain is which at the next, and where the ends of an interval do not tell."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import assigned, squared_distances
from rlswaim.rootlocus.closed_loop import ClosedLoop, RootSets, kinds_of
from rlswaim.rootlocus.open_loop import OpenLoop

PAIRS = 200_000
"""So many pairs of roots at a time: memory does not grow with the number of gains times the order squared."""


def unsure(closed: ClosedLoop, before: RootSets, after: RootSets, kinds: NDArray) -> NDArray:
    """Return the numbers of those intervals in which a root's successor is unsure: where discs overlap.

    Parameters
    ----------
    closed : ClosedLoop
    before, after : RootSets
        At the ends of K intervals, the roots in the order of their successors.
    kinds : ndarray, shape (K, n)

    Returns
    -------
    ndarray of int
    """
    wide = np.abs(after.gains - before.gains) > 1e-9 * np.maximum(np.abs(before.gains), np.abs(after.gains))
    if closed.loop.D:
        wide &= ~passes_infinity(closed.loop, before.gains, after.gains)
    return np.flatnonzero(wide & ~discs(before, after, kinds).apart.all(axis=1))


def kinds_at(closed: ClosedLoop, before: RootSets, after: RootSets) -> list[NDArray]:
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
    kinds, doubles = [sets.kinds.copy() for sets in ends], [sets.tangents == 0 for sets in ends]
    unknown = doubles[0].any(axis=1) & doubles[1].any(axis=1)
    at = np.flatnonzero(np.not_equal(*((kind > 1).sum(axis=1) for kind in kinds)))
    if at.size:
        kind, double = (np.concatenate([part[at] for part in both]) for both in (kinds, doubles))
        turned = double & (double.sum(axis=1, keepdims=True) == 2)
        real = (kind > 1) ^ turned
        sides = 2 * (turned.cumsum(axis=1) % 2) - 1
        roots = np.concatenate([sets.roots[at] for sets in ends])
        kinds[0][at], kinds[1][at] = np.split(np.where(turned & ~real, sides, kinds_of(roots, real)), 2)
        unknown[at] |= np.not_equal(*((kind[at] > 1).sum(axis=1) for kind in kinds))
    if closed.loop.D:
        unknown |= passes_infinity(closed.loop, before.gains, after.gains)
    if unknown.any():
        for kind in kinds:
            kind[unknown] = 0
    return kinds


def _blocks(count: int, order: int) -> list[slice]:
    """Return parts of so many intervals that all pairs of roots of a part are a bounded number.

    Parameters
    ----------
    count : int
        Number of the intervals; at least one part is returned.
    order : int
        Number of the roots.
    """
    step = max(1, PAIRS // max(order, 1) ** 2)
    return [slice(start, start + step) for start in range(0, max(count, 1), step)]


def matched(before: RootSets, after: RootSets, kinds: list[NDArray]) -> NDArray:
    """Return each root's successor (K, n): the nearest of its kind.

    Parameters
    ----------
    before, after : RootSets
        At the ends of K intervals.
    kinds : list of ndarray
        As `kinds_at` tells them.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    found = []
    for part in _blocks(*before.roots.shape):
        square = squared_distances(before.roots[part], after.roots[part])
        square[kinds[0][part, :, None] != kinds[1][part, None]] = np.inf
        found.append(assigned(square))
    return np.concatenate(found)


class Discs(NamedTuple):
    """For each root (K, n) a disc that its way stays in, and whether it is apart from the others' discs."""

    middle: NDArray
    radius: NDArray
    apart: NDArray


def discs(before: RootSets, after: RootSets, kinds: NDArray | None = None) -> Discs:
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
    Discs
    """
    width, middle = np.abs(after.gains - before.gains), (before.roots + after.roots) / 2
    promised = width[:, None] * np.maximum(np.abs(before.tangents), np.abs(after.tangents))
    radius = np.maximum(1.25 * np.abs(after.roots - before.roots), promised)
    apart, own = np.empty(radius.shape, bool), np.arange(radius.shape[1])
    for part in _blocks(*radius.shape):
        center, reach = middle[part], radius[part]
        near = squared_distances(center, center) <= (reach[:, :, None] + reach[:, None]) ** 2
        if kinds is not None:
            near &= kinds[part, :, None] == kinds[part, None]
        for sets in (before, after):
            double = sets.tangents[part] == 0
            if double.any():
                near &= ~(double[:, :, None] & double[:, None])
        near[:, own, own] = False
        apart[part] = ~near.any(axis=2)
    return Discs(middle, radius, apart)


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
