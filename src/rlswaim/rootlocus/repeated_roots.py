"""Roots of one polynomial with what rounding of the data does to each, repeated ones found as such."""

from collections.abc import Iterator, Sequence
from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS, conjugates, real_and_conjugate
from rlswaim.rootlocus.exact_polynomials import Exact, exact, refined_roots
from rlswaim.rootlocus.polynomials import horner, roots

NEAR = 0.03
"""Repeated roots spread at most so far, relative to their size, when their coefficients are rounded."""
STEPS = 5
"""Steps of the fit of repeated roots to all coefficients; their errors fall with the square at each."""
ILL = 3e3
"""Roots are refined on exact integers if rounding moves one by more than so many times its own rounding."""


class Points(NamedTuple):
    """Poles or zeros (m,), and how far (m,) rounding of the data moves each."""

    values: NDArray
    errors: NDArray


def points_of_polynomial(coefficients: NDArray) -> Points:
    """Return the roots of a polynomial whose ``coefficients`` (constant term first) are the data.

    A group of roots within 3 % of each other is one repeated root if the polynomial that has it, and all
    others like it, differs from the given one by rounding.
    """
    at_origin = int(np.flatnonzero(coefficients)[0])
    p = coefficients[at_origin:]
    found = roots(p)
    errors = _moved_by_rounding(p, found)
    if (errors > ILL * EPS / 2 * np.abs(found)).any():
        found = refined_roots(exact(p), found)
        errors = _moved_by_rounding(p, found)
    groups = list(_repeated_groups(p, Points(found, errors)))
    values = _together(p, found, groups)
    for group, _ in groups if values is not found else ():
        errors[group] = _moved_by_rounding(_taylor(p, len(group) - 1), values[group[:1]])
    nothing = np.zeros(at_origin)
    return Points(np.append(real_and_conjugate(values), nothing), np.append(errors, nothing))


def refined(polynomial: Exact, points: Points) -> Points:
    """Return eigenvalues refined on the exact characteristic polynomial, with errors that are smaller.

    Points that are nearer to each other than their errors explain are one repeated root.

    Parameters
    ----------
    polynomial : Exact
    points : Points
        The eigenvalues with their errors.

    Returns
    -------
    Points
    """
    integers = polynomial.integers[: polynomial.degree + 1]
    at_origin = next((i for i, c in enumerate(integers) if c), 0)
    rest = polynomial._replace(integers=integers[at_origin:])
    order = np.argsort(np.abs(points.values))[at_origin:]
    guess, nothing = Points(*(part[order] for part in points)), np.zeros(at_origin)
    if order.size == 0:
        return Points(nothing.astype(complex), nothing)
    found = refined_roots(rest, guess.values)
    errors = np.minimum(guess.errors, _moved_by_rounding(rest.rounded, found))
    values, errors = grouped(Points(found, errors))
    return Points(np.append(values, nothing), np.append(errors, nothing))


def grouped(points: Points) -> Points:
    """Return ``points``, groups of them nearer to each other than their errors explain as repeated ones."""
    (found, errors), n = points, points.values.size
    values, known = found.copy(), errors.copy()
    for group in linked(found, np.minimum(_explained(points), NEAR * np.abs(found))):
        values[group] = found[group].mean()
        known[group] = n * EPS * np.abs(found).max()
    return Points(real_and_conjugate(values), known)


def _explained(points: Points) -> NDArray:
    """Return half of the distance to others (m,) that the errors of ``points`` explain."""
    return 30 * points.values.size * points.errors


def linked(points: NDArray, reach: NDArray) -> list[list[int]]:
    """Return the groups of points that chains of neighbors join.

    Parameters
    ----------
    points : ndarray of complex, shape (n,)
    reach : ndarray, shape (n,)
        Two points are neighbors if their reaches together span their distance.

    Returns
    -------
    list of list of int
        Groups of at least two points, by their indices.
    """
    near = np.abs(points[:, None] - points) <= reach[:, None] + reach
    if near.sum() == points.size:
        return []
    joined = near @ near
    while (joined != near).any():
        near, joined = joined, joined @ joined
    first = joined.argmax(axis=1)
    return [np.flatnonzero(first == i).tolist() for i in np.flatnonzero(np.bincount(first) > 1)]


def _moved_by_rounding(p: NDArray, s: NDArray) -> NDArray:
    """Return how far rounding of the coefficients ``p`` moves the roots ``s``.

    Each coefficient is uncertain by half a unit in its last place: 2^-53 sum |p_i s^i| / |p'(s)|.
    """
    _, slope, terms = horner(p, s)
    with np.errstate(divide="ignore"):
        return EPS / 2 * terms / np.abs(slope)


def _taylor(p: NDArray, order: int) -> NDArray:
    """Return the coefficients of the derivative of an ``order`` of ``p``, over the order's factorial."""
    return p[order:] * [comb(i, order) for i in range(order, p.size)]


def _repeated_groups(p: NDArray, points: Points) -> Iterator[tuple[list[int], complex]]:
    """Return the groups of roots that are one repeated root of a polynomial to rounding, and where.

    Parameters
    ----------
    p : ndarray, shape (n + 1,)
        The polynomial's coefficients, constant term first.
    points : Points
        Its roots with their errors: those of one repeated root are no farther apart than these explain.
    """
    found, explained = points.values, _explained(points)
    free = np.ones(found.size, dtype=bool)
    for near in NEAR / 2 * 0.5 ** np.arange(26):
        members = np.flatnonzero(free)
        groups = linked(found[members], np.minimum(near * np.abs(found), explained)[members])
        if not groups:
            return
        for group in groups:
            which = members[group].tolist()
            for parts in _readings(p, which, found[which]):
                if all(_is_repeated(p, center, len(part)) for part, center in parts):
                    free[which] = False
                    yield from parts
                    break


def _readings(p: NDArray, which: list[int], group: NDArray) -> Iterator[list[tuple[list[int], complex]]]:
    """Return what a group of roots near each other may be: one repeated root, or a repeated pair.

    Parameters
    ----------
    p : ndarray, shape (n + 1,)
    which : list of int
        Numbers of the roots.
    group : ndarray of complex
        The roots.

    Returns
    -------
    iterator of list of (list of int, complex)
        The numbers that belong to each repeated root, and about where that is.
    """
    yield [(which, _center(_taylor(p, len(which) - 1), group))]
    half = len(which) // 2
    middle = group.mean().real
    square = -((group - middle) ** 2).mean().real  # of the pair's distance from the axis: well conditioned
    if 2 * half == len(which) and half > 1 and square > 0 and np.isin(group.conj(), group).all():
        center = _center(_taylor(p, half - 1), np.array([middle + 1j * np.sqrt(square)]))
        yield [(which[:half], center), (which[half:], center.conjugate())]


def _together(p: NDArray, found: NDArray, groups: list[tuple[list[int], complex]]) -> NDArray:
    """Return all roots of ``p``, those of a group as one repeated root; ``found`` if no such polynomial fits.

    Parameters
    ----------
    p : ndarray, shape (n + 1,)
        Coefficients, constant term first.
    found : ndarray of complex, shape (n,)
        Its roots as single ones.
    groups : list of (list of int, complex)
        Members of each group, and about where the repeated root is.

    Returns
    -------
    ndarray of complex, shape (n,)
    """
    if not groups:
        return found
    first, place = np.arange(found.size), found.copy()
    for group, center in groups:
        first[group], place[group[0]] = group[0], center
    distinct, which, counts = np.unique(first, return_inverse=True, return_counts=True)
    s, left = fitted([p], place[distinct], counts[None])
    return s[which] if left <= 4 * p.size * EPS else found


def fitted(polynomials: Sequence[NDArray], s: NDArray, counts: NDArray) -> tuple[NDArray, float]:
    """Return distinct roots fitted to all coefficients of one or more polynomials, and their misfit.

    Gauss and Newton's steps count each coefficient in the unit of its rounding: among polynomials with
    such repeated and common roots these are well conditioned (Zeng, Math. Comp. 74, 2005, p. 869).

    Parameters
    ----------
    polynomials : sequence of ndarray, shapes (n + 1,)
        Coefficients, constant term first; the first is not 0.
    s : ndarray of complex, shape (d,)
        First guesses; which are pairs, and which real, stays so.
    counts : ndarray of int, shape (number of polynomials, d)
        How often each polynomial has each root.

    Returns
    -------
    ndarray of complex, shape (d,)
        In exact pairs.
    float
        By how much of its terms' sizes a coefficient is missed at most; inf where the terms overflow.
    """

    def off(s: NDArray) -> NDArray:
        return np.concatenate(
            [
                (np.poly(np.repeat(s, count)) - p[::-1] / p[-1]) / unit
                for p, count, unit in zip(polynomials, counts, units, strict=True)
            ]
        )

    def slope(i: int) -> NDArray:
        one = np.arange(s.size) == i
        return np.concatenate(
            [
                np.append(0, np.poly(np.repeat(s, count - one))) * -count[i] / unit
                if count[i]
                else np.zeros(unit.size)
                for count, unit in zip(counts, units, strict=True)
            ]
        )

    partner = conjugates(s)
    with np.errstate(all="ignore"):
        units = [np.abs(np.poly(-np.abs(np.repeat(s, count)))) for count in counts]
        for _ in range(STEPS):
            slopes = np.stack([slope(i) for i in range(s.size)], axis=1)
            if not np.isfinite(slopes).all():
                return s, np.inf
            s = s - np.linalg.lstsq(slopes, off(s))[0]
        s = (s + s[partner].conj()) / 2
        return s, float(np.nan_to_num(np.abs(off(s)), nan=np.inf).max())


def _center(derivative_: NDArray, group: NDArray) -> complex:
    """Return the simple root of a derivative amid a group of roots, real if the group is symmetric."""
    symmetric = np.isin(group.conj(), group).all()
    s = complex(group.mean())
    for _ in range(4):
        s = s.real if symmetric else s
        value, slope, _ = horner(derivative_, np.array([s]))
        if slope[0]:
            s = complex(s - value[0] / slope[0])
    return complex(s.real) if symmetric else s


def _is_repeated(p: NDArray, center: complex, count: int) -> bool:
    """Return whether ``p`` has, but for rounding, a root repeated ``count`` times at a center."""
    at = np.array([center])
    for order in range(count):
        value, _, terms = horner(_taylor(p, order), at)
        if abs(value[0]) > 4 * p.size * EPS * terms[0]:
            return False
    return True
