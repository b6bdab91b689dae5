"""Continuous branches: which root of one set is which root of the next."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment


def successors(values: NDArray, vectors: NDArray | None = None) -> NDArray:
    """Return for each root of each set the index of its successor in the next set.

    The pairing is the assignment of least total distance.  Where every root has
    a nearest successor of its own, that is the assignment and nothing need be
    optimized.  Elsewhere, with eigenvectors, a change of direction counts as
    up to twice the distance, which tells apart branches that nearly cross.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)
    vectors : ndarray of complex, shape (K, n, n), optional
        Unit eigenvectors in columns.

    Returns
    -------
    ndarray of int, shape (K - 1, n)
    """
    distance = np.abs(values[:-1, :, None] - values[1:, None, :])
    nearest = distance.argmin(axis=2)
    reached = np.zeros(nearest.shape, dtype=bool)
    np.put_along_axis(reached, nearest, True, axis=1)
    for i in np.flatnonzero(~reached.all(axis=1)):
        cost = distance[i]
        if vectors is not None:
            cost = cost * (2 - np.abs(vectors[i].conj().T @ vectors[i + 1]))
        nearest[i] = linear_sum_assignment(cost)[1]
    return nearest


def branch_order(values: NDArray, vectors: NDArray | None = None) -> NDArray:
    """Return for each set the order of its roots in which each column is a continuous branch.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)
    vectors : ndarray of complex, shape (K, n, n), optional
        Unit eigenvectors in columns, to tell apart branches that nearly cross.

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    K, n = values.shape
    current, start = np.arange(n, dtype=np.intp), 0
    order = np.tile(current, (K, 1))
    if K < 2 or n < 2:
        return order
    step = successors(values, vectors)
    for i in np.flatnonzero((step != np.arange(n)).any(axis=1)).tolist():
        order[start : i + 1] = current
        current, start = step[i][current], i + 1
    order[start:] = current
    return order


def continuous_branches(values: NDArray) -> NDArray:
    """Return root sets re-ordered so that each column is a continuous branch.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)

    Returns
    -------
    ndarray of complex, shape (K, n)
    """
    return np.take_along_axis(values, branch_order(values), axis=1)


def partners(values: NDArray) -> NDArray:
    """Return for each root of each set the index of its conjugate; its own for a real root.

    Parameters
    ----------
    values : ndarray of complex, shape (K, n)

    Returns
    -------
    ndarray of int, shape (K, n)
    """
    partner = np.abs(values.conj()[:, :, None] - values[:, None, :]).argmin(axis=2)
    return np.where(values.imag == 0, np.arange(values.shape[1]), partner)
