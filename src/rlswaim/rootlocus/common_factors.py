"""Factors that numerator and denominator of a loop have in common, but for rounding."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS
from rlswaim.rootlocus.repeated_roots import Points, fitted, points_of_polynomial

SAME = 64 * EPS
"""Points that differ by so much of their size are the same."""


def common_factors(zero_points: Points, pole_points: Points) -> tuple[NDArray, NDArray]:
    """Return the numbers (c,) of zeros, and of poles, that are the same point but for rounding.

    A real zero meets a real pole only, and one above the axis a pole there: pairs stay pairs.

    Parameters
    ----------
    zero_points, pole_points : Points
        With the errors that rounding explains.
    """
    (zeros, zero_errors), (poles, pole_errors) = zero_points, pole_points
    beyond = np.abs(zeros[:, None] - poles) - 8 * (zero_errors[:, None] + pole_errors)
    beyond[np.sign(zeros.imag)[:, None] != np.sign(poles.imag)] = np.inf
    found: list[tuple[int, int]] = []
    for i in np.flatnonzero((beyond <= 0).any(axis=1)):
        at = int(beyond[i].argmin())
        if beyond[i, at] <= 0:
            found.append((int(i), at))
            beyond[:, at] = np.inf
    numbers = np.array(found, int).reshape(-1, 2)
    return numbers[:, 0], numbers[:, 1]


def agreeing(
    zeros: Points, poles: Points, polynomials: tuple[NDArray, NDArray]
) -> tuple[Points, Points, tuple[NDArray, NDArray]]:
    """Return zeros, poles, and the numbers of the zeros and the poles that are factors of both, made equal.

    Of a group not all may be: where its polynomial cannot have them all, one of each distinct point is tried.

    Parameters
    ----------
    zeros, poles : Points
        The roots of the polynomials.
    polynomials : tuple of ndarray
        Numerator and denominator, constant term first.
    """
    both, numbers = (zeros, poles), np.array(common_factors(zeros, poles))
    shared = [points.values[at] for points, at in zip(both, numbers, strict=True)]
    if (np.abs(shared[0] - shared[1]) <= SAME * np.abs(shared[0])).all():
        return zeros, poles, (numbers[0], numbers[1])
    known = [points.errors[at].max() for points, at in zip(both, numbers, strict=True)]
    better, other = (0, 1) if known[0] <= known[1] else (1, 0)
    distinct = np.unique(shared[better], return_index=True)[1]
    for which in numbers[better], numbers[better, distinct]:
        found = _sharing(both[better], which, (polynomials[better], polynomials[other]))
        if found is not None:
            at = np.arange(which.size)
            return (*found, (which, at)) if other else (*found[::-1], (at, which))
    return zeros, poles, (numbers[0, :0], numbers[1, :0])


def _sharing(
    points: Points, which: NDArray, polynomials: tuple[NDArray, NDArray]
) -> tuple[Points, Points] | None:
    """Return the roots of two polynomials that have some in common: fitted to the coefficients of both.

    Parameters
    ----------
    points : Points
        All roots of the first polynomial.
    which : ndarray of int
        The numbers of those that the second shall have.
    polynomials : tuple of ndarray
        Constant term first.

    Returns
    -------
    tuple of Points
        Of the second polynomial those in common come first.  None if no such roots fit the coefficients.
    """
    own, other = (p[int(np.flatnonzero(p)[0]) :] for p in polynomials)
    shared = Points(*(part[which] for part in points))
    moving = shared.values[shared.values != 0]
    rest = points_of_polynomial(np.polydiv(other[::-1], np.poly(moving).real)[0][::-1])
    near = np.abs(rest.values[:, None] - moving) <= SAME * np.abs(moving)
    again = np.where(near.any(axis=1), moving[near.argmax(axis=1)], rest.values)
    at_origin = np.zeros(polynomials[1].size - other.size - which.size + moving.size)
    sets = points.values, np.concatenate([shared.values, again, at_origin])
    distinct, place = np.unique(np.concatenate(sets), return_inverse=True)
    places = np.split(place, [points.values.size])
    counts = np.stack([np.bincount(part, minlength=distinct.size) for part in places])
    free = distinct != 0
    fit, left = fitted([own, other], distinct[free], counts[:, free])
    if left > 8 * max(own.size, other.size) * EPS:
        return None
    distinct[free] = fit
    errors = points.errors, np.concatenate([shared.errors, rest.errors, at_origin])
    return Points(distinct[places[0]], errors[0]), Points(distinct[places[1]], errors[1])
