"""Linear programs whose equations are polynomials in one number, solved for a whole stretch of it, exactly.

With its basis fixed, a program's unknowns are quotients of determinants (Cramer's rule), so polynomials in
that number over one of them.  A polynomial is a mean of its Bernstein coefficients on the stretch: where
these have one sign, so has it, and a quotient lies between the quotients of the coefficients.  All numbers
are fractions; floats only choose the basis, which the fractions then prove or refuse.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

Rows = list[list[Fraction]]


class Program(NamedTuple):
    """Most of ``gains @ x`` over x >= 0 with ``rows(at) @ x == targets``.

    ``degree`` bounds that of every determinant of the rows as a polynomial in ``at``.
    """

    gains: list[Fraction]
    rows: Callable[[Fraction], Rows]
    targets: list[Fraction]
    degree: int


def solved(matrix: Rows, right: Sequence[Fraction]) -> tuple[Fraction, list[Fraction]]:
    """Return the determinant of a matrix and the solution of its equations times that (Gauss and Cramer).

    Parameters
    ----------
    matrix : list of list of Fraction, shape (n, n)
    right : sequence of Fraction, shape (n,)

    Returns
    -------
    Fraction, list of Fraction
        Where the determinant is 0, so is the solution.
    """
    n, determinant = len(matrix), Fraction(1)
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    for k in range(n):
        at = next((i for i in range(k, n) if rows[i][k]), None)
        if at is None:
            return Fraction(0), [Fraction(0)] * n
        if at != k:
            rows[k], rows[at], determinant = rows[at], rows[k], -determinant
        pivot = rows[k][k]
        determinant *= pivot
        rows[k] = [value / pivot for value in rows[k]]
        for i in range(n):
            if i != k and (factor := rows[i][k]):
                rows[i] = [a - factor * b if b else a for a, b in zip(rows[i], rows[k], strict=True)]
    return determinant, [determinant * row[n] for row in rows]


@lru_cache(maxsize=8)
def _to_bernstein(degree: int) -> Rows:
    """Return the matrix from values at 0, 1/degree .. 1 to Bernstein coefficients on 0..1."""
    points = [Fraction(j, max(degree, 1)) for j in range(degree + 1)]
    values = [[comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)] for t in points]
    columns = []
    for j in range(degree + 1):
        determinant, column = solved(values, [Fraction(i == j) for i in range(degree + 1)])
        columns.append([value / determinant for value in column])
    return [list(row) for row in zip(*columns, strict=True)]


def _optimum(program: Program, at: Fraction) -> NDArray | None:
    """Return the unknowns that are best at one place, in floats; None if the optimum is not positive."""
    rows, gains, targets = (
        np.array(v, dtype=float) for v in (program.rows(at), program.gains, program.targets)
    )
    scale = np.abs(rows).max(axis=1)
    found = linprog(-gains, A_eq=rows / scale[:, None], b_eq=targets / scale, bounds=(0, None))
    return found.x if found.x is not None and found.fun < 0 else None


def _independent(rows: NDArray, order: NDArray) -> list[int] | None:
    """Return the first columns in an order that are independent, as many as there are rows; else None."""
    columns = rows / np.abs(rows).max(axis=1)[:, None]
    columns = columns / np.linalg.norm(columns, axis=0)
    chosen: list[int] = []
    for j in order:
        if np.linalg.svd(columns[:, [*chosen, j]], compute_uv=False)[-1] > 1e-10:
            chosen.append(int(j))
        if len(chosen) == len(rows):
            return chosen
    return None


def _chosen(program: Program, start: Fraction, end: Fraction) -> tuple[list[int], dict[int, Fraction]] | None:
    """Return the basis for a stretch, and the unknowns outside it that are held at positive numbers.

    The basis changes within some stretches: what is best at both ends has more unknowns than equations then.
    """
    first, last = (_optimum(program, at) for at in (start, end))
    if first is None or last is None:
        return None
    both = np.maximum(first, last)
    basis = _independent(np.array(program.rows((start + end) / 2), dtype=float), np.argsort(-both))
    if basis is None:
        return None
    rest = [int(j) for j in np.flatnonzero(both > 1e-12) if j not in basis]
    return basis, {j: Fraction(2 * float(both[j])) for j in rest}  # less would leave others below 0


def _at(program: Program, at: Fraction, basis: list[int], held: dict[int, Fraction]) -> list[Fraction]:
    """Return the determinant of the basis at one place, then what is sought and the unknowns times that."""
    rows = program.rows(at)
    right = [
        target - sum((row[j] * x for j, x in held.items()), Fraction(0))
        for row, target in zip(rows, program.targets, strict=True)
    ]
    determinant, unknowns = solved([[row[j] for j in basis] for row in rows], right)
    total = sum((program.gains[j] * x for j, x in zip(basis, unknowns, strict=True)), Fraction(0))
    total += determinant * sum((program.gains[j] * x for j, x in held.items()), Fraction(0))
    return [determinant, total, *unknowns]


def proved_least(program: Program, start: Fraction, end: Fraction) -> Fraction | None:
    """Return a positive number that the program's optimum nowhere on a stretch goes below.

    Parameters
    ----------
    program : Program
    start, end : Fraction
        Of the stretch.

    Returns
    -------
    Fraction or None
        None if the basis that is best at its ends proves nothing on the whole stretch.
    """
    choice = _chosen(program, start, end)
    if choice is None:
        return None
    points = [start + (end - start) * Fraction(j, max(program.degree, 1)) for j in range(program.degree + 1)]
    values = [_at(program, at, *choice) for at in points]
    below, above, *unknowns = (
        [
            sum((w * v for w, v in zip(weights, column, strict=True)), Fraction(0))
            for weights in _to_bernstein(program.degree)
        ]
        for column in zip(*values, strict=True)
    )
    sign = 1 if below[0] > 0 else -1
    if min(sign * b for b in below) <= 0 or any(sign * c < 0 for x in unknowns for c in x):
        return None
    least = min(a / b for a, b in zip(above, below, strict=True))
    return least if least > 0 else None
