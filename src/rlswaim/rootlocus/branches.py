"""Continuous branches: which root of one set is which root of the next."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment


def squared_distances(a: NDArray, b: NDArray) -> NDArray:
    """Return the squares of the distances of all roots of one set to all of another, for many sets.

    Parameters
    ----------
    a : ndarray of complex, shape (K, n)
    b : ndarray of complex, shape (K, m)

    Returns
    -------
    ndarray, shape (K, n, m)
    """
    square = np.ascontiguousarray(a.real)[:, :, None] - np.ascontiguousarray(b.real)[:, None]
    square *= square
    other = np.ascontiguousarray(a.imag)[:, :, None] - np.ascontiguousarray(b.imag)[:, None]
    other *= other
    square += other
    return np.asarray(square)


def assigned(square: NDArray, turns: NDArray | None = None) -> NDArray:
    """Return for each root of each set the index of its successor in another set.

    The pairing is the assignment of least total distance.  Where every root has
    a nearest successor of its own, that is the assignment and nothing need be
    optimized.  Elsewhere the distances may be weighted.

    Parameters
    ----------
    square : ndarray, shape (K, n, n)
        Squares of the distances of each root to each possible successor, infinite to the others.
    turns : ndarray, shape (K, n, n), optional
        From 0 to 1: how far each root's eigenvector turns on the way to each successor.  It counts as
        up to twice the distance, which tells apart branches that nearly cross.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    nearest = square.argmin(axis=2)
    reached = np.zeros(nearest.shape, dtype=bool)
    reached[np.arange(len(nearest))[:, None], nearest] = True
    for i in np.flatnonzero(~reached.all(axis=1)):
        cost = np.sqrt(square[i]) if turns is None else np.sqrt(square[i]) * (1 + turns[i])
        nearest[i] = linear_sum_assignment(cost)[1]
    return nearest


def in_order(successors: NDArray) -> NDArray:
    """Return for each set the order of its roots in which each column is one branch.

    The ``successors``, shape (K - 1, n), tell each root's place in the next set; the result is (K, n).
    """
    n = successors.shape[1]
    current, start = np.arange(n, dtype=np.intp), 0
    order = np.tile(current, (len(successors) + 1, 1))
    for i in np.flatnonzero((successors != np.arange(n)).any(axis=1)).tolist():
        order[start : i + 1] = current
        current, start = successors[i][current], i + 1
    order[start:] = current
    return order


def branch_order(values: NDArray, vectors: NDArray) -> NDArray:
    """Return for each set the order of its roots in which each column is a continuous branch.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)
    vectors : ndarray of complex, shape (K, n, n)
        Unit eigenvectors in columns, to tell apart branches that nearly cross.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    turns = 1 - np.abs(vectors[:-1].conj().swapaxes(1, 2) @ vectors[1:])
    return in_order(assigned(squared_distances(values[:-1], values[1:]), turns))


def continuous_branches(values: NDArray) -> NDArray:
    """Return root sets re-ordered so that each column is a continuous branch.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    return np.take_along_axis(values, in_order(assigned(squared_distances(values[:-1], values[1:]))), axis=1)
