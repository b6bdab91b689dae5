"""Proofs of Sections IV to VI for every station, those between the feet too, in exact arithmetic.

A gyro's station enters a closed loop by the slopes of the modes there, quadratic between the nodes of their
shapes.  So the linear programs of `certificates` are programs whose equations are polynomials in the
station, and `exact_programs` proves them for whole stretches.  For linear sensors no station is needed.
The coefficients of Eq. 29 and of the shapes are taken as the fractions that the floats are.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PPoly

from rlswaim.loops.exact_programs import Program, Rows, proved_least
from rlswaim.rootlocus.polynomials import determinant
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.stations import LENGTH, as_station

STRETCH, FINEST = Fraction(5), Fraction(1, 16)
"""Longest stretch (ft) that is tried whole, and the shortest to which one that fails is halved."""
Polynomial = list[Fraction]
Terms = Callable[[Fraction], list[Polynomial]]
_exactly = np.vectorize(Fraction, otypes=[object])


class Proof(NamedTuple):
    """What is proved along the vehicle.

    Attributes
    ----------
    stretches : tuple of (start, end, least)
        Stations (ft), and what the claim holds by at least on the whole stretch between them.
    fails : tuple of (start, end)
        The rest (ft): there nothing is proved.
    """

    stretches: tuple[tuple[float, float, float], ...]
    fails: tuple[tuple[float, float], ...]

    @property
    def holds_by(self) -> float:
        """What the claim holds by at least at every station; 0 if it is not proved for all."""
        return 0.0 if self.fails else min(least for _, _, least in self.stretches)


def _numerators(eqs: PerturbationEquations) -> dict[str, NDArray]:
    """Return Delta and the numerators of theta, q1 and q2 over delta, over U, as fractions."""
    matrix, U = _exactly(eqs.matrix), Fraction(eqs.U)
    found = {"Delta": determinant(matrix) / U}
    for j, name in enumerate(eqs.outputs):
        replaced = matrix.copy()
        replaced[:, j] = Fraction(0)
        replaced[:, j, 0] = _exactly(eqs.forcing("delta"))
        found[name] = determinant(replaced) / U
    return found


def _shifted(p: Sequence[Fraction] | NDArray, by: int = 1, size: int = 8) -> Polynomial:
    """Return s^by times a polynomial: its ``size`` coefficients from the constant term up."""
    return ([Fraction(0)] * by + list(p) + [Fraction(0)] * size)[:size]


def _on(curve: PPoly, piece: int) -> Callable[[Fraction], Fraction]:
    """Return one piece of a curve as a function of the station, in fractions."""
    powers, start = [Fraction(float(c)) for c in curve.c[:, piece]], Fraction(float(curve.x[piece]))
    return lambda at: reduce(lambda total, c: total * (at - start) + c, powers, Fraction(0))


def _with_gyro(eqs: PerturbationEquations, piece: int) -> Terms:
    """Return the polynomials that the gains multiply over the gyro's station, on a piece of the shapes."""
    N = _numerators(eqs)
    slopes = [_on(mode.shape.derivative(), piece) for mode in eqs.modes]

    def terms(at: Fraction) -> list[Polynomial]:
        # theta_F = theta - sum of sigma_i q_i, and sigma = -d phi/d l
        seen = N["theta"] + sum(d(at) * N[f"q{i}"] for i, d in enumerate(slopes, start=1))
        return [_shifted(N["Delta"], 0), _shifted(seen, 0), _shifted(seen)]

    return terms


def _by_signs(free: Polynomial, terms: Terms, degree: int) -> Program:
    """Return the program of `stability_certificate`: weights that cancel the gains and leave least."""
    one = [Fraction(1)] * 8
    count = len(terms(Fraction(0)))
    return Program(
        [-c for c in free], lambda at: [*terms(at), one], [Fraction(0)] * count + [Fraction(1)], degree
    )


def _but_a_slow_root(free: Polynomial, terms: Terms, degree: int, slow: Fraction) -> Program:
    """Return the dual of the program of `slow_root_certificate`.

    Notes
    -----
    Its unknowns are a weight for each upper and each lower bound on p_k - q_(k-1), at most 1 in sum, then
    what is left in the inequality of each q_k and in that of the sum.
    """
    zero, count = Fraction(0), len(terms(Fraction(0)))
    left = [[Fraction(i == k) for i in range(8)] for k in range(8)]
    q = []
    for k in range(7):
        upper, lower = [zero] * 8, [zero] * 8
        upper[k], lower[k] = slow, slow
        upper[k + 1], lower[k + 1] = Fraction(1), Fraction(-1)
        q.append([*upper, *lower, *left[k]])
    total = [*[Fraction(1)] * 16, *left[7]]

    def rows(at: Fraction) -> Rows:
        return [*([*p, *(-c for c in p), *[zero] * 8] for p in terms(at)), *q, total]

    gains = [*free, *(-c for c in free), *[zero] * 8]
    gains[7], gains[15] = gains[7] - slow, gains[15] - slow
    return Program(gains, rows, [zero] * (count + 7) + [Fraction(1)], degree)


def _program(free: Polynomial, terms: Terms, degree: int, slow: float | None) -> Program:
    """Return the program that proves one claim: no gains stabilize, or none leave only a slow root."""
    if slow is None:
        return _by_signs(free, terms, degree)
    bound = checks.not_negative("slow", slow, "a proof between stations")
    return _but_a_slow_root(free, terms, degree, Fraction(bound))


def proof_for_gyros(
    eqs: PerturbationEquations, slow: float | None = None, between: tuple[float, float] = (0.0, LENGTH)
) -> Proof:
    """Return where rate and attitude feedback is proved not to stabilize, all stations between included.

    Parameters
    ----------
    eqs : PerturbationEquations
    slow : float, optional
        With it, not even a loop with one real root between -slow and slow (1/s) set apart.
    between : tuple of float
        The part of the vehicle (ft) along which the gyro package stands.

    Returns
    -------
    Proof
    """
    low, high = (as_station("between", x, "proof_for_gyros") for x in between)
    stretches: list[tuple[float, float, float]] = []
    fails: list[tuple[float, float]] = []
    free = _shifted(_numerators(eqs)["Delta"])
    for piece, ends in enumerate(pairwise(eqs.modes[0].shape.x)):
        start, end = (Fraction(float(np.clip(x, low, high))) for x in ends)
        if start < end:
            # Two rows hold the reading, whose slopes are quadratic.
            program = _program(free, _with_gyro(eqs, piece), 4, slow)
            _halved(program, start, end, stretches, fails)
    return Proof(tuple(stretches), tuple(fails))


def proof_for_sensors(eqs: PerturbationEquations, slow: float | None = None) -> float:
    """Return what is proved of the rigid-body angle and any sensors at any stations [Sections V and VI].

    Parameters
    ----------
    eqs : PerturbationEquations
    slow : float, optional
        With it, not even a loop with one real root between -slow and slow (1/s) set apart.

    Returns
    -------
    float
        What the claim holds by at least, whatever the shapes of the modes are; 0 if nothing is proved.

    Notes
    -----
    A sensor reads phi_1 q_1 + phi_2 q_2.  Where q_1 and q_2, each with a gain of its own, do not help,
    no sensor does, nor do two: no station enters.
    """
    N = {name: list(p) for name, p in _numerators(eqs).items()}
    elastic = [[a + b for a, b in zip(_shifted(N[q], 0), _shifted(N[q]), strict=True)] for q in ("q1", "q2")]
    terms = [_shifted(N["Delta"], 0), _shifted(N["theta"], 0), _shifted(N["theta"]), *elastic]
    program = _program(_shifted(N["Delta"]), lambda _: terms, 0, slow)
    return float(proved_least(program, Fraction(0), Fraction(0)) or 0)


def _halved(
    program: Program,
    start: Fraction,
    end: Fraction,
    stretches: list[tuple[float, float, float]],
    fails: list[tuple[float, float]],
) -> None:
    """Prove a stretch, or else its halves, and add what came of it to the lists."""
    least = proved_least(program, start, end) if end - start <= STRETCH else None
    if least is not None:
        stretches.append((float(start), float(end), float(least)))
    elif end - start <= FINEST:
        fails.append((float(start), float(end)))
    else:
        middle = (start + end) / 2
        _halved(program, start, middle, stretches, fails)
        _halved(program, middle, end, stretches, fails)
