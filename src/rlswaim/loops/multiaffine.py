"""The exact multi-affine forms of a closed loop: characteristic polynomial and numerators.

Each gain, actuator pole and mode-shape value enters a closed loop at most once
in a product.  So its matrices are sums of terms (product of some factors) x
(fixed matrix), and their values at corners of the factor cube, every factor 0
or 1, fix all of them.  The determinant and the cofactors of s I - A follow by
Laplace's expansion in whole numbers, so that nothing is rounded on the way.
"""

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from math import prod
from typing import Any, NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.modes import BendingMode

Subset = frozenset[str]
Polynomials = dict[Subset, list[int]]
"""Terms by their factors: whole coefficients, constant term first."""


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


@dataclass(frozen=True)
class ModeWith:
    """A bending mode with other numbers in place of its own at single stations (ft)."""

    mode: BendingMode
    deflections: Mapping[float, float]
    slopes: Mapping[float, float]

    def deflection(self, station: float) -> float:
        """Return phi at a station: the given number, else the mode's own."""
        return self.deflections[station] if station in self.deflections else self.mode.deflection(station)

    def slope(self, station: float) -> float:
        """Return sigma = -d phi/d l (1/ft) at a station: the given number, else the mode's own."""
        return self.slopes[station] if station in self.slopes else self.mode.slope(station)


def with_shapes(
    eqs: PerturbationEquations,
    deflections: Mapping[float, Sequence[float]] | None = None,
    slopes: Mapping[float, Sequence[float]] | None = None,
) -> PerturbationEquations:
    """Return the equations with modes that take given values at single stations.

    Parameters
    ----------
    eqs : PerturbationEquations
    deflections, slopes : mapping of station (ft) to the values of both modes, optional
        phi_1, phi_2 and sigma_1, sigma_2 (1/ft): so they can be factors in their own right.
    """
    given = (deflections or {}, slopes or {})
    modes: Any = tuple(
        ModeWith(mode, *({at: pair[i] for at, pair in shapes.items()} for shapes in given))
        for i, mode in enumerate(eqs.modes)
    )
    return replace(eqs, modes=modes)


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
    factors = tuple(dict.fromkeys(name for group in groups for name in group))
    zero = closed_loop(**dict.fromkeys(factors, 0.0))
    n, e, terms = zero.nstates, *_entries(_matrix_terms(closed_loop, groups, factors))
    A, B = [row[:n] for row in terms[:n]], [row[n:] for row in terms[:n]]
    C = {name: terms[n + i][:n] for i, name in enumerate(zero.output_labels) if name in outputs}
    for i in range(n):
        B[i] += [{frozenset(): [2**e]} if zero.state_labels[i] == f"x_{s}" else {} for s in initial]
    inputs = [*zero.input_labels, *(f"{state}(0)" for state in initial)]

    def form(polynomials: Polynomials, power: int) -> MultiAffine:
        rounded = {s: [c / 2 ** (e * power) for c in p] for s, p in polynomials.items() if any(p)}
        ordered = sorted(
            rounded, key=lambda s: (len(s), [factors.index(f) for f in sorted(s, key=factors.index)])
        )
        return MultiAffine(
            factors, tuple(Term(tuple(f for f in factors if f in s), tuple(rounded[s])) for s in ordered)
        )

    pencil = [_pencil_row(A[i], i, e) for i in range(n)]
    whole = _minors(pencil)[2**n - 1]
    numerators: dict[str, dict[str, Polynomials]] = {i: {o: {} for o in outputs} for i in inputs}
    for i in range(n) if outputs else ():
        if any(B[i]):
            minors = _minors(pencil[:i] + pencil[i + 1 :])
            for out, row in C.items():
                for j, weight in enumerate(row):
                    adjugate = _product(minors.get(2**n - 1 - 2**j, {}), weight, (-1) ** (i + j))
                    for name, entry in zip(inputs, B[i], strict=True):
                        _add(numerators[name][out], _product(adjugate, entry))
    return Forms(
        form(whole, n),
        {i: {o: form(p, n + 1) for o, p in by_output.items()} for i, by_output in numerators.items()},
    )


def _matrix_terms(
    closed_loop: Callable[..., control.StateSpace], groups: Sequence[Sequence[str]], factors: Sequence[str]
) -> dict[Subset, NDArray]:
    """Return the exact terms of the closed loop's matrix [A B; C D], by their factors."""

    def matrix(values: Mapping[str, float]) -> NDArray:
        loop = closed_loop(**values)
        return np.vectorize(Fraction, otypes=[object])(np.block([[loop.A, loop.B], [loop.C, loop.D]]))

    # The corner of a subset is the sum of the terms of all its subsets (Moebius): subtract the smaller ones.
    terms: dict[Subset, NDArray] = {}
    for subset in _subsets(groups):
        corner = matrix({name: float(name in subset) for name in factors})
        terms[subset] = corner - sum((terms[part] for part in terms if part < subset), start=0 * corner)
    # A square of a factor looks like the factor itself at 0 and 1, and differs at 2.
    doubled = sum(2 ** len(subset) * term for subset, term in terms.items())
    if (doubled != matrix(dict.fromkeys(factors, 2.0))).any():
        raise ValueError(f"multiaffine_forms: got a closed loop not multi-affine in {', '.join(factors)}")
    return {subset: term for subset, term in terms.items() if term.any()}


def _subsets(groups: Sequence[Collection[str]]) -> Iterator[Subset]:
    """Yield all subsets of each group, small ones first, none twice."""
    for size in range(max(map(len, groups)) + 1):
        yield from dict.fromkeys(frozenset(s) for group in groups for s in combinations(group, size))


def _entries(terms: Mapping[Subset, NDArray]) -> tuple[int, list[list[Polynomials]]]:
    """Return an exponent e and the matrix times 2^e, each entry as terms of one whole number."""
    e = max(x.denominator.bit_length() - 1 for term in terms.values() for x in term.flat)
    rows, columns = next(iter(terms.values())).shape
    return e, [
        [{s: [int(t[i, j] * 2**e)] for s, t in terms.items() if t[i, j]} for j in range(columns)]
        for i in range(rows)
    ]


def _pencil_row(row: Sequence[Polynomials], i: int, e: int) -> dict[int, Polynomials]:
    """Return row i of 2^e (s I - A): its entries by column, without those that are zero."""
    entries = {j: {s: [-p[0], 0] for s, p in entry.items()} for j, entry in enumerate(row) if entry}
    entries.setdefault(i, {}).setdefault(frozenset(), [0, 0])[1] = 2**e
    return entries


def _minors(rows: Sequence[Mapping[int, Polynomials]]) -> dict[int, Polynomials]:
    """Return the determinants of these rows in every choice of as many columns (Laplace).

    Keys are the chosen columns as bits.
    """
    found: dict[int, Polynomials] = {0: {frozenset(): [1]}}
    for row in rows:
        grown: dict[int, Polynomials] = defaultdict(dict)
        for columns, minor in found.items():
            for j, entry in row.items():
                if not columns >> j & 1:
                    sign = -1 if (columns >> j).bit_count() % 2 else 1
                    _add(grown[columns | 1 << j], _product(minor, entry, sign))
        found = grown
    return found


def _product(first: Polynomials, second: Polynomials, sign: int = 1) -> Polynomials:
    product: Polynomials = {}
    for s, p in first.items():
        for t, q in second.items():
            if s & t:
                raise ValueError(f"multiaffine_forms: got a square of {', '.join(s & t)}")
            _add(product, {s | t: (sign * np.convolve(np.array(p, object), np.array(q, object))).tolist()})
    return product


def _add(total: Polynomials, more: Polynomials) -> None:
    """Add ``more`` to ``total``, in place."""
    for s, p in more.items():
        q = total.get(s, [])
        size = max(len(p), len(q))
        total[s] = [a + b for a, b in zip(p + [0] * (size - len(p)), q + [0] * (size - len(q)), strict=True)]
