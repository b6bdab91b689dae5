"""The ladder's loops with the delay itself, exp(-s T), in place of Pade's approximation.

A loop is s x = A x + exp(-s T) B x, where B holds what the effectors do to the vehicle.  Its roots are
those of det(s I - A - exp(-s T) B), infinitely many; finitely many lie right of any line, and the argument
of the determinant along the line counts them.
"""

from dataclasses import replace
from functools import cache

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.slow_roots import abscissas
from rlswaim.practice.conclusions_on_rungs import (
    CONCLUSIONS,
    Cell,
    stiffness_ends_it,
    unstable_root,
    with_the_jet,
)
from rlswaim.practice.ladder_search import SEARCHED, modest_gains, stored
from rlswaim.practice.limits import limits
from rlswaim.practice.measurements import attitude
from rlswaim.practice.rungs import Step, ladder_steps
from rlswaim.source import checks

RUNG = "20 ms delay"
EFFECTORS = ("engine", "jet")
POINTS = 40
"""Of the polynomial that stands for the motion over the delay."""
LARGEST = 20.0
"""Size of the roots, times the delay, up to which that polynomial serves."""

BESIDE = 0.01
"""Real parts that differ by less count as beside each other (1/s)."""


def parted(closed: control.StateSpace) -> tuple[NDArray, NDArray]:
    """Return a closed loop's matrix without what the effectors do to the vehicle, and that alone.

    Parameters
    ----------
    closed : control.StateSpace
        Of `rlswaim.practice.ladder`, without a delay.

    Returns
    -------
    ndarray, ndarray, shape (n, n)
        A and B of s x = A x + exp(-s T) B x.
    """
    owner = [str(label).split("_x")[0] for label in closed.state_labels]
    into = np.array([name == "vehicle" for name in owner])
    out = np.array([name in EFFECTORS for name in owner])
    late = np.where(into[:, None] & out, closed.A, 0.0)
    return closed.A - late, late


def _determinant(A: NDArray, B: NDArray, T: float, s: NDArray) -> NDArray:
    """Return det(s I - A - exp(-s T) B) at many s."""
    z = s[:, None, None]
    return np.linalg.det(z * np.eye(len(A)) - A - np.exp(-z * T) * B)


def delayed_roots(A: NDArray, B: NDArray, T: float, points: int = POINTS) -> NDArray:
    """Return the rightmost roots of det(s I - A - exp(-s T) B).

    The motion over the last T seconds is a polynomial through Chebyshev's points: its slope at each point
    but the newest is that of the motion itself, and the newest obeys the equation [Breda, Maset, Vermiglio].

    Parameters
    ----------
    A, B : ndarray, shape (n, n)
        From `parted`.
    T : float
        The delay (s), above 0.
    points : int
        So many roots for each state; those up to some 20/T in size are exact to rounding.

    Returns
    -------
    ndarray, complex
        Those of a size up to 20/T (1/s), in the order of falling real parts.
    """
    checks.positive("T", T, "delayed_roots")
    x = np.cos(np.pi * np.arange(points + 1) / points)
    weight = np.r_[2.0, np.ones(points - 1), 2.0] * (-1.0) ** np.arange(points + 1)
    D = np.outer(weight, 1 / weight) / (x[:, None] - x + np.eye(points + 1))
    D -= np.diag(D.sum(axis=1))
    n = len(A)
    whole = np.kron(2 / T * D, np.eye(n))
    whole[:n] = 0.0
    whole[:n, :n], whole[:n, -n:] = A, B
    found = np.linalg.eigvals(whole)
    found = found[np.abs(found) * T < LARGEST]
    return found[np.argsort(-found.real)]


def roots_right_of(A: NDArray, B: NDArray, T: float, line: float, points: int = 4000) -> int:
    """Return how many roots of a loop with a delay lie right of a line, by the argument of the determinant.

    Parameters
    ----------
    A, B : ndarray, shape (n, n)
        From `parted`.
    T : float
        The delay (s).
    line : float
        Real part of the line (1/s); no root lies on it.
    points : int
        Along the line, dense where roots may lie; no root right of it is larger than the last.

    Returns
    -------
    int
    """
    most = np.linalg.norm(A, 2) + np.exp(-line * T) * np.linalg.norm(B, 2)
    heights = np.r_[0.0, np.geomspace(1e-4, 100 * most, points)]
    values = _determinant(A, B, T, line + 1j * heights)
    turned = 2 * np.angle(values[1:] / values[:-1]).sum()
    # On the great half circle the determinant turns as s^n does, by n pi; the rest of n pi is the roots'.
    corner = 2 * np.angle(line + 1j * heights[-1])
    return round((len(A) * corner - turned) / (2 * np.pi))


def prompt(step: Step) -> Step:
    """Return a ``step`` without its delay."""
    return Step(step.eqs, replace(step.rung, delay=0.0))


def rightmost_of(closed: control.StateSpace, T: float) -> tuple[float, int]:
    """Return the largest real part (1/s), a slow real root apart, of a loop with an exact delay.

    Parameters
    ----------
    closed : control.StateSpace
        Of `rlswaim.practice.ladder`, without the delay.
    T : float
        The delay (s).

    Returns
    -------
    float, int
        The real part; and how many roots right of a line left of all those counted were missed (0).
    """
    A, B = parted(closed)
    roots = delayed_roots(A, B, T)
    value = float(abscissas(roots[None], apart=True)[0])
    line = value - 0.01
    return value, roots_right_of(A, B, T, line) - int((roots.real > line).sum())


def rightmost(step: Step, section: str, gains: dict[str, float]) -> tuple[float, int]:
    """Return the largest real part (1/s), a slow real root apart, of a section's loop with the exact delay.

    Parameters
    ----------
    step : Step
        Its rung has a delay.
    section : str
        One of `ladder_search.SEARCHED`.
    gains : dict of str to float

    Returns
    -------
    float, int
        The real part; and how many roots right of a line left of all those counted were missed (0).
    """
    return rightmost_of(SEARCHED[section].closed_loop(prompt(step), **gains), step.rung.delay)


def farthest_from_pade() -> float:
    """Return how far the rightmost roots with the exact delay are from those with Pade's at most (1/s).

    Where the best gains let roots nearly meet, as in IV, floats fix few digits of each, and all of their
    mean: the means of the roots beside the rightmost one are compared.
    """
    step, found = ladder_steps()[RUNG], stored()
    off = []
    for section, searched in SEARCHED.items():
        gains = found[RUNG, section].gains
        exact = delayed_roots(*parted(searched.closed_loop(prompt(step), **gains)), step.rung.delay)
        means = [
            roots[np.abs(roots.real - found[RUNG, section].abscissa) < BESIDE].real.mean()
            for roots in (exact, searched.closed_loop(step, **gains).poles())
        ]
        off.append(abs(means[0] - means[1]))
    return float(max(off))


@cache
def cells() -> dict[str, Cell]:
    """Return the row of the table of conclusions for the delay itself, at the gains found with Pade's.

    The least peak of |S| is exp(p T) times that without a delay, p the unstable pole.
    """
    step, found = ladder_steps()[RUNG], stored()
    root = unstable_root(step)
    peak = limits(attitude(step.eqs, None)).peak * np.exp(root * step.rung.delay)
    row = {"diverges": Cell("stands", root), "parity": Cell("stands", float(peak))}
    row["rigid"] = stiffness_ends_it(RUNG)
    left = rightmost_of(with_the_jet(prompt(step)), step.rung.delay)[0]
    row["jet"] = Cell("stands" if left > 0 else "falls", left)
    for section in ("IV", "V", "VI"):
        least = rightmost(step, section, found[RUNG, section].gains)[0]
        row[section] = Cell("stands" if least > 0 else "falls", least)
    modest = {name: value for name, value in modest_gains().items() if name not in ("sensor", "jet")}
    for name, gains in (("modest", modest), ("VII", found[RUNG, "VII"].gains)):
        least = rightmost(step, "VII", gains)[0]
        row[name] = Cell("stands" if least < 0 else "falls", least)
    return {name: row[name] for name in CONCLUSIONS}
