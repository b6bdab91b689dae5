"""What no choice of gains can change: characteristic equations as affine functions of the gains.

With x = K_A K_C, y = K_A K_C K_R and w = K_C K_z, every coefficient of the
closed-loop characteristic polynomial of Sections IV to VI is affine in K_C, x,
y and the w's.  A stable polynomial has coefficients of one sign, so a linear
program can prove that no gains give stability: it finds a sum of coefficients
with positive weights in which every gain cancels and what is left is negative.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray
from scipy.optimize import linprog

from rlswaim.loops.transfer_functions import attitude_numerator, displacement_numerator
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.stations import as_station


def _padded(p: NDArray, size: int = 9) -> NDArray:
    return np.pad(p[:size], (0, max(0, size - p.size)))


def gain_terms(
    eqs: PerturbationEquations, gyro: float | None, sensors: Sequence[float] = ()
) -> Mapping[str, NDArray]:
    """Return the characteristic polynomial as terms in the gains [Eq. 83].

    Parameters
    ----------
    eqs : PerturbationEquations
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle alone.
    sensors : sequence of float
        Stations of the linear sensors (ft).

    Returns
    -------
    mapping of str to ndarray, shape (9,)
        Polynomials, constant term first, that multiply 1, K_C, K_A K_C, K_A K_C K_R and
        K_C K_z of each sensor (``"K_C K_z at <station>"``).
    """
    checks.instance("eqs", eqs, PerturbationEquations, "gain_terms")
    sensors = [as_station("sensor", x, "gain_terms") for x in sensors]
    delta, attitude = eqs.characteristic_polynomial(), attitude_numerator(eqs, gyro)
    terms = {
        "1": npp.polymulx(delta),
        "K_C": delta,
        "K_A K_C": attitude,
        "K_A K_C K_R": npp.polymulx(attitude),
    }
    terms |= {f"K_C K_z at {x:g}": displacement_numerator(eqs, x) for x in sensors}
    return {name: _padded(p) for name, p in terms.items()}


def gains_for_pole(
    eqs: PerturbationEquations, pole: complex, K_C: float, gyro: float | None
) -> tuple[float, float]:
    """Return the one pair K_A, K_R that puts a closed-loop pole at a complex place [Eqs. 83, 84].

    Parameters
    ----------
    eqs : PerturbationEquations
    pole : complex
        Wanted pole (1/s), off the real axis.
    K_C : float
        Actuator gain (1/s).
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle alone.

    Returns
    -------
    K_A, K_R : float

    Raises
    ------
    ValueError
        If the pole is real: then one gain remains free; or if a number is not finite.
    """
    pole, K_C = checks.off_axis("pole", pole, "gains_for_pole"), checks.real("K_C", K_C, "gains_for_pole")
    terms = {name: npp.polyval(pole, p) for name, p in gain_terms(eqs, gyro).items()}
    # K_A (1 + K_R s) = -(Delta (s + K_C)) / (K_C N) at the pole
    wanted = -(terms["1"] + K_C * terms["K_C"]) / (K_C * terms["K_A K_C"])
    product = wanted.imag / np.imag(pole)
    K_A = wanted.real - product * np.real(pole)
    return float(K_A), float(product / K_A)


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
    """Return whether any real gains at all could make every coefficient positive.

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
    """Return how far all gains fail to leave nothing but one slow real root right of the axis.

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
        When positive, no gains of any sign put all other roots left of the axis; 0 decides nothing.

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
