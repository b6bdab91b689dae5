"""Which root at one gain is which at the next, and where the ends of an interval do not tell."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import assigned, squared_distances
from rlswaim.rootlocus.closed_loop import ClosedLoop, RootSets, kinds_of
from rlswaim.rootlocus.open_loop import OpenLoop


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
    unlike = (kinds[0] > 1).sum(axis=1) != (kinds[1] > 1).sum(axis=1)
    at = np.flatnonzero(unlike)
    if at.size:
        for kind, double, sets in zip(kinds, doubles, ends, strict=True):
            turned = double[at] & (double[at].sum(axis=1, keepdims=True) == 2)
            real = (kind[at] > 1) ^ turned
            sides = 2 * (turned.cumsum(axis=1) % 2) - 1
            kind[at] = np.where(turned & ~real, sides, kinds_of(sets.roots[at], real))
        unknown[at] |= (kinds[0][at] > 1).sum(axis=1) != (kinds[1][at] > 1).sum(axis=1)
    unknown |= passes_infinity(closed.loop, before.gains, after.gains)
    for kind in kinds:
        kind[unknown] = 0
    return kinds


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
    square = squared_distances(before.roots, after.roots)
    square[kinds[0][:, :, None] != kinds[1][:, None]] = np.inf
    return assigned(square)


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
    near = squared_distances(middle, middle) <= (radius[:, :, None] + radius[:, None]) ** 2
    if kinds is not None:
        near &= kinds[:, :, None] == kinds[:, None]
    for double in (before.tangents == 0, after.tangents == 0):
        if double.any():
            near &= ~(double[:, :, None] & double[:, None])
    own = np.arange(near.shape[1])
    near[:, own, own] = False
    return Discs(middle, radius, ~near.any(axis=2))


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
