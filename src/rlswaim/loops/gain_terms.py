"""The characteristic polynomial of Sections IV to VI as terms in the gains, and the gains for a pole.

With x = K_A K_C, y = K_A K_C K_R and w = K_C K_z, every coefficient is affine in K_C, x, y and
the w's [Eq. 83].
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

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
