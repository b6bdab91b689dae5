"""The tables of Section III: coefficients of Eq. 29 by parameters, and its determinant by coefficients."""

from collections.abc import Iterator, Sequence
from itertools import permutations, product
from math import prod
from typing import NamedTuple

import numpy as np

from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.eq_29 import Product, equation_terms, products

BLOCKS = {"short period": (0, 1), "mode 1": (2,), "mode 2": (3,)}
"""Rows and columns of Eq. 29 that each motion would have to itself."""


class DeterminantTerm(NamedTuple):
    """A number times a power of s times some coefficients of Eq. 29."""

    weight: float
    power: int
    factors: tuple[str, ...]


def _uncoupled(booster: Booster) -> set[str]:
    """Return the coefficients that stay where each motion is by itself: those of `BLOCKS`."""
    block = {i: name for name, rows in BLOCKS.items() for i in rows}
    terms = equation_terms(len(booster.modes), booster.flight.U)
    return {term.coefficient for term in terms if block[term.row] == block[term.column]}


def coupled_products(booster: Booster) -> dict[str, tuple[Product, ...]]:
    """Return `products`, those that couple motions times one more factor: ``coupling``, 1 for the vehicle.

    Parameters
    ----------
    booster : Booster
    """
    alone = _uncoupled(booster)
    return {
        name: tuple(
            Product(weight, factors if name in alone else (*factors, "coupling")) for weight, factors in sums
        )
        for name, sums in products(booster).items()
    }


def determinant_table(rows: Sequence[int], U: float) -> tuple[DeterminantTerm, ...]:
    """Return the determinant of some rows and columns of Eq. 29, multiplied out and monic.

    Parameters
    ----------
    rows : sequence of int
        Rows of the matrix, and the same columns.
    U : float
        Speed (ft/s).

    Returns
    -------
    tuple of DeterminantTerm
    """
    terms = list(equation_terms(max(rows) - 1, U))

    def entry(i: int, j: int) -> list[DeterminantTerm]:
        return [
            DeterminantTerm(weight, power, (name,) if name else ())
            for row, column, power, weight, name in terms
            if (row, column) == (i, j) and weight
        ]

    def expanded() -> Iterator[DeterminantTerm]:
        for order in permutations(range(len(rows))):
            sign = round(np.linalg.det(np.eye(len(rows))[list(order)]))
            for chosen in product(*(entry(rows[i], rows[j]) for i, j in enumerate(order))):
                weight = sign * prod(t.weight for t in chosen) / (U if 0 in rows else 1.0)
                names = tuple(name for t in chosen for name in t.factors)
                yield DeterminantTerm(weight, sum(t.power for t in chosen), names)

    return tuple(expanded())
