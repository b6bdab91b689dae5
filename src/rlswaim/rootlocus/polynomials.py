"""Polynomials and polynomial matrices in floats; coefficients run from the constant term up."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

TINY = float(np.finfo(float).tiny)


def determinant(matrix: NDArray) -> NDArray:
    """Return the determinant of a polynomial matrix, expanded along its first row.

    Parameters
    ----------
    matrix : ndarray, shape (n, n, m)
        ``matrix[i, j]`` holds the coefficients of entry (i, j), constant term first.

    Returns
    -------
    ndarray, shape (n (m - 1) + 1,)
        Coefficients of the determinant, constant term first.
    """
    n, _, m = matrix.shape
    if n == 1:
        return matrix[0, 0].copy()
    total = np.zeros(n * (m - 1) + 1, matrix.dtype)  # fractions stay fractions
    for j in range(n):
        minor = np.delete(matrix[1:], j, axis=1)
        total += (-1) ** j * np.convolve(matrix[0, j], determinant(minor))
    return total


def trimmed(coefficients: ArrayLike) -> NDArray:
    """Return a polynomial's coefficients without leading zeros (at the end: constant term first)."""
    p = np.asarray(coefficients, dtype=float)
    return p[: max(p.nonzero()[0], default=0) + 1]


def derivative(coefficients: NDArray) -> NDArray:
    """Return the ``coefficients`` of a polynomial's derivative."""
    return coefficients[1:] * np.arange(1, coefficients.size)


def values(coefficients: NDArray, s: NDArray) -> NDArray:
    """Return a polynomial at some points.

    Parameters
    ----------
    coefficients : ndarray, shape (n + 1,)
        Constant term first.
    s : ndarray of complex, shape (m,)

    Returns
    -------
    ndarray of complex, shape (m,)
    """
    return np.vander(s, coefficients.size, increasing=True) @ coefficients


def roots(coefficients: ArrayLike) -> NDArray:
    """Return the roots of a polynomial, zeros at the origin exactly so.

    Parameters
    ----------
    coefficients : array_like, shape (n + 1,)
        Constant term first.

    Returns
    -------
    ndarray of complex, shape (n,)
    """
    p = trimmed(coefficients)
    at_origin = int(np.flatnonzero(p)[0]) if p.any() else 0
    return np.concatenate([np.zeros(at_origin), _roots_elsewhere(p[at_origin:])]).astype(complex)


def _roots_elsewhere(p: NDArray) -> NDArray:
    """Return the roots of a polynomial whose constant term is not 0."""
    if p.size < 2:
        return np.zeros(0)
    # Eigenvalues find roots of size 1 best; by logarithms, since powers of a tiny size overflow.
    with np.errstate(divide="ignore"):
        logs = np.log(np.abs(p))
    log_size = (logs[0] - logs[-1]) / (p.size - 1)
    logs += log_size * np.arange(p.size)
    scaled = np.sign(p) * np.exp(logs - logs.max())
    companion = np.eye(p.size - 1, k=1)
    companion[-1] = -scaled[:-1] / scaled[-1]
    return _polished(p, np.exp(log_size) * np.linalg.eigvals(companion))


def horner(
    coefficients: NDArray, s: NDArray, sizes: NDArray | None = None
) -> tuple[NDArray, NDArray, NDArray]:
    """Return a polynomial, its derivative and the sum of its terms' sizes, at many points.

    Parameters
    ----------
    coefficients : ndarray, shape (n + 1,) or (n + 1, K)
        Constant term first; one polynomial for each column.
    s : ndarray of complex, shape (m,) or (m, K)
    sizes : ndarray, shape of the coefficients, optional
        What each coefficient is a small difference of; by default its own size.

    Returns
    -------
    tuple of ndarray, each of the shape of s
        p(s), p'(s), and the sum of sizes times |s|^i: the error of p(s) is of order 2^-52 times that.
    """
    size, sizes = np.abs(s), np.abs(coefficients) if sizes is None else sizes
    if coefficients.ndim == 1:  # one polynomial: what need not be exact to the last digit all at once
        powers, p = np.vander(s, coefficients.size, increasing=True), coefficients[-1]
        for c in coefficients[-2::-1].tolist():
            p = p * s + c
        return p, powers[:, :-1] @ derivative(coefficients), np.abs(powers) @ sizes
    p, slope, terms = coefficients[-1] + 0 * s, 0 * s, sizes[-1] + 0 * size
    for c, c_size in zip(coefficients[-2::-1], sizes[-2::-1], strict=True):
        slope = slope * s + p
        p = p * s + c
        terms = terms * size + c_size
    return p, slope, terms


def _polished(coefficients: NDArray, approximations: NDArray, steps: int = 3) -> NDArray:
    """Return roots: approximations after Newton steps on the coefficients where they can only improve.

    A step is taken where it is small beside the distance to the next root, and larger than
    the rounding error of the polynomial explains; multiple roots are left as they are.  Eigenvalues fit all
    coefficients together, even where roots are near each other: what loses that is not taken.
    """
    found = approximations
    distance = np.abs(found[:, None] - found)
    np.fill_diagonal(distance, np.inf)
    nearest = distance.min(axis=1)
    for _ in range(steps):
        p, slope, terms = horner(coefficients, found)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = p / slope
            useful = (np.abs(step) < 1e-2 * nearest) & (np.abs(p) > 1e-16 * terms)
        if not useful.any():
            break
        found = found - np.where(useful, step, 0)
    size, moved = np.abs(found), np.abs(found - approximations)
    if (moved <= 1e-12 * size).all() or (nearest > 0.1 * size).all():
        return found
    return min(found, approximations, key=lambda s: misfit(coefficients, s))


def misfit(coefficients: NDArray, s: NDArray, sizes: NDArray | float = 0.0) -> float:
    """Return by how much of their terms' sizes the coefficients are missed by the polynomial with roots s.

    Parameters
    ----------
    coefficients : ndarray, shape (n + 1,)
        Constant term first; the last is not 0.
    s : ndarray of complex, shape (n,)
    sizes : ndarray, shape (n + 1,), optional
        What each coefficient is a small difference of.

    Returns
    -------
    float
        Some units of rounding if these are the roots; inf where the terms overflow.
    """
    with np.errstate(all="ignore"):
        off = np.abs(np.poly(s) - coefficients[::-1] / coefficients[-1])
        own = np.abs(np.atleast_1d(sizes / coefficients[-1])[::-1])
        off /= np.maximum(np.maximum(np.abs(np.poly(-np.abs(s))), own), TINY)  # 0 below roots at the origin
    return float(np.nan_to_num(off, nan=np.inf).max(initial=0.0))
