"""Proofs that no gains stabilize the loops of Sections IV to VI.

The coefficients of the closed-loop characteristic polynomial are affine in the gains (`gain_terms`).
A stable polynomial has coefficients of one sign, so a linear program can prove that no gains
give stability: it finds a sum of coefficients with positive weights in which every gain cancels
and the rest is negative.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from rlswaim.loops.gain_terms import gain_terms
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations


class Certificate(NamedTuple):
    """A proof from the signs of the coefficients.

    ``margin`` is the largest t for which some gains make every coefficient at least t;
    when it is not positive, no gains give stability.  ``weights`` (one for each of s^0 to
    s^7, sum 1) combine the coefficients so that all gains cancel and ``margin`` is left; where
    none do, it is infinite and they are zero.
    """

    margin: float
    weights: NDArray


def stability_certificate(
    eqs: PerturbationEquations, gyro: float | None, sensors: Sequence[float] = ()
) -> Certificate:
    """Return the proof, where there is one, that no real gains make every coefficient positive.

    Parameters
    ----------
    eqs : PerturbationEquations
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle alone.
    sensors : sequence of float
        Stations of the linear sensors (ft).  Two in general position stand for every pair,
        since their readings span those of all others.

    Returns
    -------
    Certificate

    Notes
    -----
    By duality the largest t with ``free + terms @ gains >= t`` is the least ``weights @ free``
    over weights of sum 1 with ``weights @ terms = 0``.
    """
    free, *terms = (p[:8] for p in gain_terms(eqs, gyro, sensors).values())
    balance = np.vstack([*terms, np.ones(8)])
    found = linprog(free, A_eq=balance, b_eq=np.r_[np.zeros(len(terms)), 1.0], bounds=(0, None))
    if found.x is None:  # no weights cancel the gains, so that they make t as large as they like
        return Certificate(np.inf, np.zeros(8))
    return Certificate(float(found.fun), found.x)


def slow_root_certificate(
    eqs: PerturbationEquations, gyro: float | None, sensors: Sequence[float] = (), slow: float = 0.0
) -> float:
    """Return a number that is positive only if no gains stabilize all roots but one slow real root.

    Parameters
    ----------
    eqs : PerturbationEquations
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle alone.
    sensors : sequence of float
        Stations of the linear sensors (ft).
    slow : float
        The real root that is set apart lies between -slow and slow (1/s).

    Returns
    -------
    float
        If it is positive, no gains of either sign put all other roots left of the axis.  If it is 0,
        nothing is proved.

    Notes
    -----
    With the slow root r divided out, q remains: p_k = q_(k-1) - r q_k, so that p_k differs from
    q_(k-1) by at most slow q_k, and a stable q has positive coefficients.  The program seeks
    gains and a q without a negative coefficient, and returns the least excess over these bounds.
    """
    free, *terms = (p[:8] for p in gain_terms(eqs, gyro, sensors).values())
    shifted, own = np.eye(8, 8, -1), checks.not_negative("slow", slow, "slow_root_certificate") * np.eye(8)
    # The unknowns are the gains, q_0 to q_7 (which is 1, as p is monic) and the excess.
    moved, excess = np.array(terms).T, np.ones((8, 1))
    sides = [[moved, -shifted - own, -excess], [-moved, shifted - own, -excess]]
    found = linprog(
        np.r_[np.zeros(len(terms) + 8), 1.0],
        A_ub=np.block(sides),
        b_ub=np.r_[-free, free],
        bounds=[(None, None)] * len(terms) + [(0, None)] * 7 + [(1, 1), (0, None)],
    )
    return float(found.fun)
