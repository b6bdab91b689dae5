"""Families of closed loops: matrices that are sums of (product of factors) x (fixed matrix).

Each gain, actuator pole and mode-shape value enters a closed loop at most once in a product.  So the
matrices at corners of the factors' cube, every factor 0 or 1, give them at all values of the factors.
Searches, maps over stations, sensitivities and live views all evaluate such a family.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from math import prod
from typing import Self

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

Product = tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Family:
    """Closed loops that differ in the values of some factors alone.

    Attributes
    ----------
    factors : tuple of str
    terms : mapping of tuple of str to ndarray of Fraction, shape (n + p, n + m)
        The fixed matrix [A B; C D] that each product of factors multiplies.
    states, inputs, outputs : tuple of str
        Their names, n, m and p in number.
    """

    factors: tuple[str, ...]
    terms: Mapping[Product, NDArray]
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    @classmethod
    def of(
        cls,
        closed_loop: Callable[..., control.StateSpace],
        groups: Sequence[Collection[str]],
        tolerance: float = 0.0,
    ) -> Self:
        """Return the family of a closed loop.

        Parameters
        ----------
        closed_loop : callable
            Takes the factors by name and returns the closed loop.
        groups : sequence of collection of str
            The factors.  Only factors of one group may multiply each other in one entry of the
            closed loop's matrices.
        tolerance : float
            Largest deviation from a multi-affine function that counts as rounding, relative to
            the largest entry; 0 wants none at all.

        Returns
        -------
        Family

        Raises
        ------
        ValueError
            If the closed loop is not multi-affine in these factors, or one multiplies another group's.
        """
        factors = tuple(dict.fromkeys(name for group in groups for name in group))
        # The matrix at a corner is the sum of the terms of all its subsets: subtract the smaller ones.
        terms: dict[Product, NDArray] = {}
        for product in _products(groups):
            corner = _matrix(closed_loop(**{name: float(name in product) for name in factors}))
            terms[product] = corner - sum(
                (term for part, term in terms.items() if {*part} < {*product}), start=0 * corner
            )
        # A square of a factor looks like the factor itself at 0 and 1, and differs at 2.
        doubled = sum(2 ** len(product) * term for product, term in terms.items())
        wanted = _matrix(closed_loop(**dict.fromkeys(factors, 2.0)))
        if abs(doubled - wanted).max() > tolerance * abs(wanted).max():
            raise ValueError(f"Family.of: got a closed loop not multi-affine in {', '.join(factors)}")
        loop = closed_loop(**dict.fromkeys(factors, 0.0))
        names = (tuple(labels) for labels in (loop.state_labels, loop.input_labels, loop.output_labels))
        return cls(factors, {product: term for product, term in terms.items() if term.any()}, *names)

    @cached_property
    def _state_terms(self) -> NDArray:
        """The terms of the state matrix alone, rounded; shape (number of terms, n, n)."""
        n = len(self.states)
        return np.array([term[:n, :n].astype(float) for term in self.terms.values()])

    def matrices(self, factors: Mapping[str, ArrayLike]) -> NDArray:
        """Return state matrices, shape (..., n, n), at values of the ``factors`` whose shapes broadcast.

        Raises
        ------
        ValueError
            If a factor is missing.
        """
        if missing := [name for name in self.factors if name not in factors]:
            raise ValueError(f"factors in Family.matrices: got {', '.join(factors)}, wanted {missing[0]} too")
        values = {name: np.asarray(value) for name, value in factors.items()}
        products = (prod((values[name] for name in product), start=1) for product in self.terms)
        weights = np.stack(np.broadcast_arrays(*products), axis=-1)
        return np.tensordot(weights, self._state_terms, axes=1)


def _matrix(loop: control.StateSpace) -> NDArray:
    """Return [A B; C D] in exact fractions."""
    return np.vectorize(Fraction, otypes=[object])(np.block([[loop.A, loop.B], [loop.C, loop.D]]))


def _products(groups: Sequence[Collection[str]]) -> Iterator[Product]:
    """Yield all products of factors of one group, those of few factors first, none twice."""
    for size in range(max(map(len, groups)) + 1):
        yield from dict.fromkeys(product for group in groups for product in combinations(group, size))
