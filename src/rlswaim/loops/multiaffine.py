"""The exact multi-affine forms of a closed loop: characteristic polynomial and numerators.

The determinant and the cofactors of s I - A follow by Laplace's expansion from the matrices of a
`Family`, in whole numbers, so that nothing is rounded on the way.
"""

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.loops.family import Family
from rlswaim.source import checks

Whole = defaultdict[tuple[frozenset[str], int], int]
Polynomial = Mapping[tuple[frozenset[str], int], int]
"""Whole coefficients by their factors and their power of s."""


class Term(NamedTuple):
    """One term: the factors that multiply it, and its coefficients, constant term first."""

    factors: tuple[str, ...]
    coefficients: tuple[float, ...]


@dataclass(frozen=True)
class MultiAffine:
    """A polynomial as a sum of products of factors with fixed polynomials."""

    factors: tuple[str, ...]
    terms: tuple[Term, ...]

    def __call__(self, **values: float) -> NDArray:
        """Return the coefficients at given factors, constant term first; shape (n + 1,).

        Raises
        ------
        ValueError
            If a factor is missing, unknown or not finite.
        """
        wrong = sorted(set(values) ^ set(self.factors))
        if wrong:
            raise ValueError(
                f"MultiAffine: got a missing or unknown factor {wrong[0]!r}, wanted {', '.join(self.factors)}"
            )
        given = {name: checks.real(name, value, "MultiAffine") for name, value in values.items()}
        total = np.zeros(max((len(term.coefficients) for term in self.terms), default=1))
        for term in self.terms:
            total[: len(term.coefficients)] += prod(given[f] for f in term.factors) * np.array(
                term.coefficients
            )
        return total


class Forms(NamedTuple):
    """A closed loop: its characteristic polynomial, and its numerators by input and output."""

    polynomial: MultiAffine
    numerators: dict[str, dict[str, MultiAffine]]


def multiaffine_forms(
    closed_loop: Callable[..., control.StateSpace],
    groups: Sequence[Sequence[str]],
    outputs: Sequence[str] = (),
    initial: Sequence[str] = (),
) -> Forms:
    """Return a closed loop's polynomials as multi-affine forms, without rounding.

    Parameters
    ----------
    closed_loop : callable
        Takes the factors by name and returns the closed loop.
    groups : sequence of sequence of str
        The factors: gains, actuator poles, mode slopes and deflections.  Only factors of one
        group may multiply each other in one entry of the closed loop's matrices.
    outputs : sequence of str
        Outputs whose numerators are wanted, from every input.
    initial : sequence of str
        States ``x_<name>`` whose initial value is an input as well, ``"<name>(0)"``.

    Returns
    -------
    Forms
        Only the terms that are not zero; each coefficient is rounded once, at the end.

    Raises
    ------
    ValueError
        If the closed loop is not multi-affine in these factors, or one multiplies another group's.
    """
    return forms(Family.of(closed_loop, groups), outputs, initial)


def forms(family: Family, outputs: Sequence[str] = (), initial: Sequence[str] = ()) -> Forms:
    """Return the polynomials of a family of closed loops, as `multiaffine_forms` does.

    Parameters
    ----------
    family : Family
    outputs, initial : sequence of str
        As in `multiaffine_forms`.

    Returns
    -------
    Forms
    """
    n, e, whole = len(family.states), family.exponent, _entries(family)
    A, B = [row[:n] for row in whole[:n]], [row[n:] for row in whole[:n]]
    C = {name: whole[n + i][:n] for i, name in enumerate(family.outputs) if name in outputs}
    for state, row in zip(family.states, B, strict=True):
        row += [{(frozenset(), 0): 2**e} if state == f"x_{name}" else {} for name in initial]
    inputs = [*family.inputs, *(f"{state}(0)" for state in initial)]
    pencil = [_pencil_row(row, i, e) for i, row in enumerate(A)]
    numerators: dict[str, dict[str, Whole]] = {i: {o: defaultdict(int) for o in outputs} for i in inputs}
    for i in range(n) if outputs else ():
        if any(B[i]):
            minors = _minors(pencil[:i] + pencil[i + 1 :])
            for out, row in C.items():
                for j, weight in enumerate(row):
                    adjugate: Whole = defaultdict(int)
                    _add_product(adjugate, minors.get(2**n - 1 - 2**j, {}), weight, (-1) ** (i + j))
                    for name, entry in zip(inputs, B[i], strict=True):
                        _add_product(numerators[name][out], adjugate, entry)
    return Forms(
        _rounded(family.factors, _minors(pencil)[2**n - 1], n, 2 ** (e * n)),
        {
            i: {o: _rounded(family.factors, p, n - 1, 2 ** (e * (n + 1))) for o, p in by_output.items()}
            for i, by_output in numerators.items()
        },
    )


def _rounded(factors: tuple[str, ...], polynomial: Polynomial, degree: int, scale: int) -> MultiAffine:
    """Return a polynomial over ``scale``: terms of few factors first, then in the order of the factors."""
    terms: dict[tuple[int, ...], list[float]] = defaultdict(lambda: [0.0] * (degree + 1))
    for (subset, power), coefficient in polynomial.items():
        if coefficient:
            terms[tuple(i for i, f in enumerate(factors) if f in subset)][power] = coefficient / scale
    ordered = sorted(terms.items(), key=lambda term: (len(term[0]), term[0]))
    return MultiAffine(factors, tuple(Term(tuple(factors[i] for i in at), tuple(c)) for at, c in ordered))


def _entries(family: Family) -> list[list[Polynomial]]:
    """Return the matrix [A B; C D] times 2^exponent by entries, without terms that are zero."""
    terms = {frozenset(product): term for product, term in family.terms.items()}
    rows, columns = next(iter(terms.values())).shape
    return [
        [{(s, 0): term[i, j] for s, term in terms.items() if term[i, j]} for j in range(columns)]
        for i in range(rows)
    ]


def _pencil_row(row: Sequence[Polynomial], i: int, e: int) -> dict[int, Polynomial]:
    """Return row i of 2^e (s I - A): its entries by column, without those that are zero."""
    entries: dict[int, Polynomial] = {
        j: {key: -c for key, c in entry.items()} for j, entry in enumerate(row) if entry
    }
    entries[i] = {**entries.get(i, {}), (frozenset(), 1): 2**e}
    return entries


def _minors(rows: Sequence[Mapping[int, Polynomial]]) -> Mapping[int, Polynomial]:
    """Return the determinants of these rows in every choice of as many columns, by Laplace's expansion.

    The keys have one bit for each chosen column.
    """
    found: Mapping[int, Polynomial] = {0: {(frozenset(), 0): 1}}
    for row in rows:
        grown: dict[int, Whole] = defaultdict(lambda: defaultdict(int))
        for columns, minor in found.items():
            for j, entry in row.items():
                if not columns >> j & 1:
                    sign = -1 if (columns >> j).bit_count() % 2 else 1
                    _add_product(grown[columns | 1 << j], minor, entry, sign)
        found = grown
    return found


def _add_product(total: Whole, first: Polynomial, second: Polynomial, sign: int = 1) -> None:
    """Add ``sign`` times a product of two polynomials to ``total``, in place."""
    for (s, power), a in first.items():
        for (t, more), b in second.items():
            if s & t:
                raise ValueError(f"multiaffine_forms: got a square of {', '.join(s & t)}")
            total[s | t, power + more] += sign * a * b
