"""The tables of Section III: coefficients of Eq. 29 by parameters, and its determinant by coefficients."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations, product
from math import prod
from typing import NamedTuple

import numpy as np

from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import COLUMNS, ROWS, perturbation_equations

BLOCKS = {"short period": (0, 1), "mode 1": (2,), "mode 2": (3,)}
"""Rows and columns of Eq. 29 that each motion would have to itself."""
BLOCK_OF = {
    "Z": 0,
    "M": 0,
    "alpha": 0,
    "thetadot": 0,
    "F1": 1,
    "q1": 1,
    "q1dot": 1,
    "F2": 2,
    "q2": 2,
    "q2dot": 2,
}
LEVER: dict[str, tuple[float, tuple[str, ...]]] = {
    "Z": (1.0, ()),
    "M": (1.0, ("arm",)),
    "F1": (-1.0, ("phi_1",)),
    "F2": (-1.0, ("phi_2",)),
}
"""How a downward force at a surface enters each equation: sign and shape there."""


class Product(NamedTuple):
    """A number times some factors."""

    weight: float
    factors: tuple[str, ...]


class DeterminantTerm(NamedTuple):
    """A number times a power of s times some coefficients of Eq. 29."""

    weight: float
    power: int
    factors: tuple[str, ...]


def coefficient_table(booster: Booster) -> dict[str, tuple[Product, ...]]:
    """Return each coefficient of Eq. 29 as a sum of products.

    Parameters
    ----------
    booster : Booster
        Masses, thrust, shapes and damping ratios stay its own.

    Returns
    -------
    dict
        Factors: q_D, C_<surface>, omega_i, ``coupling`` (1 for the vehicle, 0 for motions by themselves) and
        ``<shape>_<surface>``, where shape is arm (l - l_CG, ft), phi_i or sigma_i (1/ft).
    """
    bare = perturbation_equations(replace(booster, surfaces=())).coefficients
    inertia = dict(zip(ROWS, (booster.M, booster.I_y, *(m.mass for m in booster.modes)), strict=True))
    U = booster.flight.U
    incidence: dict[str, tuple[float, tuple[str, ...]]] = {"alpha": (1.0, ()), "thetadot": (1 / U, ("arm",))}
    structure: dict[str, tuple[Product, ...]] = {}
    for i, mode in enumerate(booster.modes, start=1):
        incidence |= {f"q{i}dot": (-1 / U, (f"phi_{i}",)), f"q{i}": (1.0, (f"sigma_{i}",))}
        structure[f"F{i}_q{i}dot"] = (Product(2 * mode.zeta, (f"omega_{i}",)),)
        structure[f"F{i}_q{i}"] = (Product(1.0, (f"omega_{i}", f"omega_{i}")),)

    def thrust(name: str) -> float:
        own = structure.get(name, ())
        omegas = {f"omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
        return bare[name] - sum(p.weight * prod(omegas[f] for f in p.factors) for p in own)

    def terms(row: str, column: str) -> Iterator[Product]:
        coupled = () if BLOCK_OF[row] == BLOCK_OF[column] else ("coupling",)
        (sign, lever), (weight, shape) = LEVER[row], incidence[column]
        yield Product(thrust(f"{row}_{column}"), coupled)
        yield from structure.get(f"{row}_{column}", ())
        for surface in booster.surfaces:
            at = tuple(f"{name}_{surface.name}" for name in lever + shape)
            yield Product(
                booster.S / inertia[row] * sign * weight, ("q_D", f"C_{surface.name}", *at, *coupled)
            )

    return {f"{row}_{column}": tuple(terms(row, column)) for row in ROWS for column in COLUMNS[:-1]}


def determinant_table(rows: Sequence[int], U: float) -> tuple[DeterminantTerm, ...]:
    """Return the determinant of ``rows`` and columns of Eq. 29 at speed ``U``, multiplied out and monic."""

    def entry(i: int, j: int) -> list[DeterminantTerm]:
        row, column = ROWS[i], ("alpha", "thetadot", "q1", "q2")[j]
        found = [DeterminantTerm(1.0, 1 if j == 1 else 0, (f"{row}_{column}",))]
        if j > 1:
            found.append(DeterminantTerm(1.0, 1, (f"{row}_{column}dot",)))
        if i == 0 and j < 2:
            found.append(DeterminantTerm(U if j == 0 else -U, 1, ()))
        if i == j > 0:
            found.append(DeterminantTerm(1.0, 2, ()))
        return found

    def expanded() -> Iterator[DeterminantTerm]:
        for order in permutations(range(len(rows))):
            sign = round(np.linalg.det(np.eye(len(rows))[list(order)]))
            entries = (entry(rows[i], rows[j]) for i, j in enumerate(order))
            for chosen in product(*entries):
                weight = sign * prod(t.weight for t in chosen) / (U if 0 in rows else 1.0)
                names = tuple(name for t in chosen for name in t.factors)
                yield DeterminantTerm(weight, sum(t.power for t in chosen), names)

    return tuple(expanded())
