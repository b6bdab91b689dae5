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
    numbers = np.array(common_factors(zeros, poles))
    shared = zeros.values[numbers[0]], poles.values[numbers[1]]
    same = np.abs(shared[0] - shared[1]) <= SAME * np.abs(shared[0])
    if not same.all():
        known = zeros.errors[numbers[0]].max(), poles.errors[numbers[1]].max()
        i, j = (0, 1) if known[0] <= known[1] else (1, 0)  # the better known first
        distinct = np.unique(shared[i], return_index=True)[1]
        both = (zeros, poles)[i], (zeros, poles)[j]
        for chosen in numbers[[i, j]], numbers[[i, j]][:, distinct]:
            found = _sharing(both, chosen, (polynomials[i], polynomials[j]))
            if found is not None:
                at = chosen[0], np.arange(chosen.shape[1])
                return found[i], found[j], (at[i], at[j])
    return zeros, poles, (numbers[0, same], numbers[1, same])


def _sharing(
    both: tuple[Points, Points], chosen: NDArray, polynomials: tuple[NDArray, NDArray]
) -> tuple[Points, Points] | None:
    """Return the roots of two polynomials that have some in common: fitted to the coefficients of both.

    The others of the second polynomial are those of the quotient or, where this has lost digits, its own.

    Parameters
    ----------
    both : tuple of Points
        All roots of each polynomial.
    chosen : ndarray of int, shape (2, c)
        The numbers of those in common, known better in the first one.
    polynomials : tuple of ndarray
        Constant term first.

    Returns
    -------
    tuple of Points
        Of the second polynomial those in common come first.  None if no such roots fit the coefficients.
    """
    own, other = (p[int(np.flatnonzero(p)[0]) :] for p in polynomials)
    shared = Points(*(part[chosen[0]] for part in both[0]))
    moving = shared.values[shared.values != 0]
    quotient = points_of_polynomial(np.polydiv(other[::-1], np.poly(moving).real)[0][::-1])
    rest = Points(*(np.delete(part, chosen[1]) for part in both[1]))
    at_origin = np.zeros(np.count_nonzero(rest.values == 0))
    elsewhere = Points(*(part[rest.values != 0] for part in rest))
    for left in quotient, elsewhere:
        near = np.abs(left.values[:, None] - moving) <= SAME * np.abs(moving)
        again = np.where(near.any(axis=1), moving[near.argmax(axis=1)], left.values)
        second = np.concatenate([shared.values, again, at_origin])
        fit = _fitted([own, other], both[0].values, second)
        if fit is not None:
            errors = np.concatenate([shared.errors, left.errors, at_origin])
            return Points(fit[0], both[0].errors), Points(fit[1], errors)
    return None


def _fitted(polynomials: list[NDArray], first: NDArray, second: NDArray) -> list[NDArray] | None:
    """Return all roots of two polynomials, equal ones together, fitted to both; None if they do not fit.

    Parameters
    ----------
    polynomials : list of ndarray
        Constant term first, without roots at the origin.
    first, second : ndarray of complex
        The roots of each, those at the origin too.
    """
    distinct, place = np.unique(np.append(first, second), return_inverse=True)
    places = np.split(place, [first.size])
    counts = np.stack([np.bincount(part, minlength=distinct.size) for part in places])
    free = distinct != 0
    distinct[free], off = fitted(polynomials, distinct[free], counts[:, free])
    fits = off <= 8 * max(p.size for p in polynomials) * EPS
    return [distinct[part] for part in places] if fits else None
