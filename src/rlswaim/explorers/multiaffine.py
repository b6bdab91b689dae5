"""The exact multi-affine form of a closed loop's characteristic polynomial.

Each gain, actuator pole and mode-shape value enters a control system's
characteristic polynomial at most once in a product.  So the polynomial is a sum
of terms (product of some factors) x (fixed polynomial), and its values at the
corners of the factor cube, every factor 0 or 1, fix all of them.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from math import prod
from typing import Any, NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim import checks
from rlswaim.modes import BendingMode
from rlswaim.perturbation import PerturbationEquations
from rlswaim.polynomials import exact_characteristic_polynomial

Subset = frozenset[str]


class Term(NamedTuple):
    """One term: the factors that multiply it, and its coefficients, constant term first."""

    factors: tuple[str, ...]
    coefficients: tuple[float, ...]


@dataclass(frozen=True)
class MultiAffine:
    """A characteristic polynomial as a sum of products of factors with fixed polynomials."""

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
        return sum(
            (prod(given[f] for f in term.factors) * np.array(term.coefficients) for term in self.terms),
            start=np.zeros(len(self.terms[0].coefficients)),
        )


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


def multiaffine_form(closed_loop: Callable[..., control.StateSpace], factors: Sequence[str]) -> MultiAffine:
    """Return the characteristic polynomial of a closed loop as a multi-affine form, without rounding.

    Parameters
    ----------
    closed_loop : callable
        Takes the factors by name and returns the closed loop.
    factors : sequence of str
        Gains, actuator poles, mode slopes and deflections at a sensor or jet.

    Returns
    -------
    MultiAffine
        Only the terms that are not zero; each coefficient is rounded once, at the end.

    Raises
    ------
    ValueError
        If the polynomial is not multi-affine in these factors.
    """

    def polynomial(values: Mapping[str, float]) -> list[Fraction]:
        return exact_characteristic_polynomial(closed_loop(**values).A)

    # The corner of a subset is the sum of the terms of all its subsets (Moebius): subtract the smaller ones.
    exact: dict[Subset, list[Fraction]] = {}
    for subset in _subsets(factors):
        corner = polynomial({name: float(name in subset) for name in factors})
        smaller = [exact[part] for part in exact if part < subset]
        exact[subset] = [c - sum(below) for c, *below in zip(corner, *smaller, strict=True)]
    kept = {subset: c for subset, c in exact.items() if any(c)}
    # A square of a factor looks like the factor itself at 0 and 1, and differs at 2.
    doubled = [sum(2 ** len(s) * c[k] for s, c in kept.items()) for k in range(len(exact[frozenset()]))]
    if doubled != polynomial(dict.fromkeys(factors, 2.0)):
        raise ValueError(f"multiaffine_form: got a closed loop not multi-affine in {', '.join(factors)}")
    terms = (Term(tuple(f for f in factors if f in s), tuple(map(float, c))) for s, c in kept.items())
    return MultiAffine(tuple(factors), tuple(terms))


def _subsets(factors: Sequence[str]) -> Iterator[Subset]:
    """Yield all subsets, small ones first."""
    for size in range(len(factors) + 1):
        yield from map(frozenset, combinations(factors, size))
