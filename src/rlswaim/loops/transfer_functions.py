"""Open-loop transfer functions of Sections IV to VI, with K_A (or K_z) set to 1 for a locus in it.

Each is numerators of the vehicle [Eqs. 92-94] over its characteristic
polynomial Delta and the actuator's s + K_C.  A loop that is closed already
moves the denominator: ``closed`` lists the gain and the station of each
linear sensor in an inner loop.
"""

from collections.abc import Sequence

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import ArrayLike, NDArray

from rlswaim.loops.named_branches import open_loop_parts
from rlswaim.rootlocus.polynomials import roots, trimmed
from rlswaim.source import checks
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations
from rlswaim.vehicle.stations import as_stations

Closed = Sequence[tuple[float, float]]


def transfer(numerator: ArrayLike, denominator: ArrayLike) -> control.TransferFunction:
    """Return a transfer function.

    Parameters
    ----------
    numerator, denominator : array_like
        Two polynomials, constant term first.
    """
    top, bottom = (
        checks.frozen_array(name, p, "transfer")
        for name, p in (("numerator", numerator), ("denominator", denominator))
    )
    return control.tf(trimmed(top)[::-1], trimmed(bottom)[::-1])


def closed_polynomial(loop: control.TransferFunction, gain: float = 1.0) -> NDArray:
    """Return denominator plus gain times numerator, constant term first.

    Parameters
    ----------
    loop : TransferFunction
    gain : float
    """
    gain = checks.real("gain", gain, "closed_polynomial")
    return npp.polyadd(gain * loop.num[0][0][::-1], loop.den[0][0][::-1])


def attitude_numerator(eqs: PerturbationEquations, gyro: float | None, order: int = 4) -> NDArray:
    """Return the numerator of theta_i/delta, what a gyro reads [Eqs. 85-89].

    Parameters
    ----------
    eqs : PerturbationEquations
    gyro : float or None
        Station (ft); None takes the rigid-body angle alone.
    order : int
        3 with the first mode, 4 with both.

    Returns
    -------
    ndarray, shape (2 order,)
        Constant term first, over `PerturbationEquations.characteristic_polynomial` of that order.
    """
    numerator = eqs.numerator("theta", "delta", order=order)
    if gyro is None:
        return numerator
    for i, mode in enumerate(eqs.modes[: order - 2], start=1):
        numerator = numerator - mode.slope(gyro) * eqs.numerator(f"q{i}", "delta", order=order)
    return numerator


def elastic_numerator(
    eqs: PerturbationEquations, sensor: float, signal: str = "delta", jet: float = JET_STATION
) -> NDArray:
    """Return phi_1 N_q1 + phi_2 N_q2 at a sensor [Eqs. 119, 133, 134].

    Parameters
    ----------
    eqs : PerturbationEquations
    sensor : float
        Station of the linear sensor (ft).
    signal : str
        ``"delta"`` or ``"delta_r"``.
    jet : float
        Station of the reaction jet (ft), used for ``"delta_r"`` alone.

    Returns
    -------
    ndarray, shape (8,)
        Constant term first.
    """
    phi = [mode.deflection(sensor) for mode in eqs.modes]
    return phi[0] * eqs.numerator("q1", signal, jet) + phi[1] * eqs.numerator("q2", signal, jet)


def displacement_numerator(eqs: PerturbationEquations, sensor: float, b: float = 1.0) -> NDArray:
    """Return the numerator of z/delta for K_z = 1: -(s + b)(phi_1 N_q1 + phi_2 N_q2) [Eq. 100].

    Parameters
    ----------
    eqs : PerturbationEquations
    sensor : float
        Station of the linear sensor (ft).
    b : float
        Attitude-to-rate ratio of the sensor (1/s); 1 in Sections V and VI.

    Returns
    -------
    ndarray, shape (9,)
        Constant term first.
    """
    return -np.convolve([checks.real("b", b, "displacement_numerator"), 1.0], elastic_numerator(eqs, sensor))


def denominator(eqs: PerturbationEquations, K_C: float, closed: Closed = (), order: int = 4) -> NDArray:
    """Return (s + K_C) Delta plus what closed inner loops add, constant term first [Eqs. 89, 111, 118].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C : float
        Actuator gain (1/s).
    closed : sequence of (K_z, station)
        Linear sensors whose inner loops are closed, gains in rad s/ft.
    order : int
        2 for the rigid body alone, 3 with the first mode, 4 with both.
    """
    K_C = checks.real("K_C", K_C, "denominator")
    total = np.convolve([K_C, 1.0], eqs.characteristic_polynomial(order))
    for K_z, sensor in closed:
        total = npp.polyadd(
            total, K_C * checks.real("K_z", K_z, "denominator") * displacement_numerator(eqs, sensor)
        )
    return total


def theta_loop(
    eqs: PerturbationEquations,
    K_C: float,
    K_R: float,
    gyro: float | None,
    closed: Closed = (),
    order: int = 4,
) -> control.TransferFunction:
    """Return the attitude loop for K_A = 1: K_C (K_R s + 1) N / ((s + K_C) Delta) [Eqs. 89, 95, 96, 111].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C, K_R : float
        Actuator (1/s) and rate gyro (s) gains.
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle alone.
    closed : sequence of (K_z, station)
        Linear sensors whose inner loops are closed, gains in rad s/ft.
    order : int
        2 for the rigid body alone, 3 with the first mode, 4 with both.

    Returns
    -------
    TransferFunction
    """
    rate = [1.0, checks.real("K_R", K_R, "theta_loop")]
    return transfer(
        K_C * np.convolve(rate, attitude_numerator(eqs, gyro, order)), denominator(eqs, K_C, closed, order)
    )


def outer_loop(
    eqs: PerturbationEquations, K_C: float, K_R: float, closed: Closed
) -> control.TransferFunction:
    """Return `theta_loop` for the rigid-body angle [Eqs. 110, 111].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C, K_R : float
        Actuator (1/s) and rate gyro (s) gains.
    closed : sequence of (K_z, station)
        Linear sensors whose inner loops are closed, gains in rad s/ft.
    """
    return theta_loop(eqs, K_C, K_R, None, closed)


def inner_loop(
    eqs: PerturbationEquations, K_C: float, sensor: float, closed: Closed = ()
) -> control.TransferFunction:
    """Return a linear sensor's loop for K_z = 1, other inner loops closed or not [Eqs. 106, 112, 118].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C : float
        Actuator gain (1/s).
    sensor : float
        Station of the linear sensor (ft).
    closed : sequence of (K_z, station)
        Linear sensors whose loops are closed, gains in rad s/ft.

    Returns
    -------
    TransferFunction
    """
    return transfer(K_C * displacement_numerator(eqs, sensor), denominator(eqs, K_C, closed))


def sensor_zeros(eqs: PerturbationEquations, stations: ArrayLike) -> NDArray:
    """Return the zeros of Eq. 119 but the one at the origin.

    Parameters
    ----------
    eqs : PerturbationEquations
    stations : array_like, shape (K,)
        Sensor stations (ft).

    Returns
    -------
    ndarray of complex, shape (K, 4)
        In 1/s.
    """
    return np.array([roots(elastic_numerator(eqs, x)[1:]) for x in as_stations("stations", stations)])


def frequency_rates(eqs: PerturbationEquations, K_C: float, stations: ArrayLike) -> dict[str, NDArray]:
    """Return how fast each mode's frequency rises with K_z when K_z leaves zero, over the sensor's station.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C : float
        Actuator gain (1/s).
    stations : array_like, shape (K,)
        Sensor stations (ft).

    Returns
    -------
    dict of str to ndarray, shape (K,)
        d|s|/dK_z of ``"mode 1"`` and ``"mode 2"`` (ft/s^2/rad): two equal signs stiffen both modes.
    """
    top = np.array([K_C * displacement_numerator(eqs, x) for x in as_stations("stations", stations)])
    slope = npp.polyder(denominator(eqs, K_C))
    found = {}
    for name in ("mode 1", "mode 2"):
        s = max(open_loop_parts(eqs, K_C)[name], key=np.imag)
        found[name] = np.real(np.conj(s) * -npp.polyval(s, top.T) / npp.polyval(s, slope)) / abs(s)
    return found
