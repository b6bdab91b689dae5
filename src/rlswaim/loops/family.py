"""Families of closed loops: matrices that are sums of (product of factors) x (fixed matrix).

Each gain, actuator pole and mode-shape value enters a closed loop at most once in a product.  So the
matrices at corners of the factors' cube, every factor 0 or 1, give them at all values of the factors.
Searches, maps over stations, sensitivities and live views all evaluate such a family.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
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
    terms : mapping of tuple of str to ndarray of int, shape (n + p, n + m)
        The fixed matrix [A B; C D] times 2^exponent that each product of factors multiplies: with
        whole numbers it is exact.
    exponent : int
    states, inputs, outputs : tuple of str
        Their names, n, m and p in number.
    """

    factors: tuple[str, ...]
    terms: Mapping[Product, NDArray]
    exponent: int
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
        products = [*_products(groups)]
        loops = [closed_loop(**{name: float(name in product) for name in factors}) for product in products]
        # A square of a factor looks like the factor itself at 0 and 1, and differs at 2.
        loops.append(closed_loop(**dict.fromkeys(factors, 2.0)))
        exponent, (*corners, wanted) = _whole(loops)
        # The matrix at a corner is the sum of the terms of all its subsets: subtract the smaller ones.
        terms: dict[Product, NDArray] = {}
        for product, corner in zip(products, corners, strict=True):
            smaller = [term for part, term in terms.items() if {*part} < {*product}]
            terms[product] = corner - sum(smaller, start=0 * corner)
        doubled = sum(2 ** len(product) * term for product, term in terms.items())
        if abs(doubled - wanted).max() > tolerance * abs(wanted).max():
            raise ValueError(f"Family.of: got a closed loop not multi-affine in {', '.join(factors)}")
        zero = loops[0]
        names = (tuple(labels) for labels in (zero.state_labels, zero.input_labels, zero.output_labels))
        return cls(
            factors, {product: term for product, term in terms.items() if term.any()}, exponent, *names
        )

    @cached_property
    def _state_terms(self) -> NDArray:
        """The terms of the state matrix alone, rounded; shape (number of terms, n, n)."""
        n = len(self.states)
        return np.array([(term[:n, :n] / 2**self.exponent).astype(float) for term in self.terms.values()])

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
        weights = np.empty(
            (len(self.terms), *np.broadcast_shapes(*(value.shape for value in values.values()))),
            np.result_type(float, *values.values()),
        )
        for i, product in enumerate(self.terms):
            weights[i] = prod((values[name] for name in product), start=1.0)
        return np.tensordot(weights, self._state_terms, axes=(0, 0))


def _whole(loops: Sequence[control.StateSpace]) -> tuple[int, list[NDArray]]:
    """Return an exponent e and the matrices [A B; C D] times 2^e, all of whole numbers."""
    matrices = [np.block([[loop.A, loop.B], [loop.C, loop.D]]) for loop in loops]
    exponent = max(x.as_integer_ratio()[1].bit_length() - 1 for matrix in matrices for x in matrix.flat)
    whole = np.vectorize(int, otypes=[object])
    return exponent, [whole(np.ldexp(matrix, exponent)) for matrix in matrices]


def _products(groups: Sequence[Collection[str]]) -> Iterator[Product]:
    """Yield all products of factors of one group, those of few factors first, none twice."""
    for size in range(max(map(len, groups)) + 1):
        yield from dict.fromkeys(product for group in groups for product in combinations(group, size))
