"""Open-loop transfer functions of Sections IV to VI, with K_A (or K_z) set to 1 for a locus in it.

Each is numerators of the vehicle [Eqs. 92-94] over its characteristic
polynomial Delta and the actuator's s + K_C.  A loop that is closed already
moves the denominator: ``closed`` lists the gain and the station of each
linear sensor in an inner loop.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import linear_sum_assignment

from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.rootlocus.polynomials import roots, trimmed
from rlswaim.source import checks
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations
from rlswaim.vehicle.stations import as_stations

Closed = Sequence[tuple[float, float]]


def transfer(numerator: ArrayLike, denominator: ArrayLike) -> control.TransferFunction:
    """Return ``numerator`` over ``denominator``, two polynomials given constant term first."""
    top, bottom = (
        checks.frozen_array(name, p, "transfer")
        for name, p in (("numerator", numerator), ("denominator", denominator))
    )
    return control.tf(trimmed(top)[::-1], trimmed(bottom)[::-1])


def from_factors(gain: float, zeros: Sequence[complex], poles: Sequence[complex]) -> control.TransferFunction:
    """Return a transfer function from its factors, as the report prints them.

    Parameters
    ----------
    gain : float
    zeros, poles : sequence of complex
        A root with an imaginary part stands for itself and its conjugate (1/s).
    """

    def product(given: Sequence[complex]) -> NDArray:
        return npp.polyfromroots([r for z in given for r in ((z, np.conj(z)) if np.imag(z) else (z,))]).real

    return transfer(gain * product(zeros), product(poles))


def factors(loop: control.TransferFunction) -> tuple[float, NDArray, NDArray]:
    """Return gain, zeros and poles (1/s) of a ``loop``; of a pair, the root above the real axis."""
    top, bottom = (trimmed(p[0][0][::-1]) for p in (loop.num, loop.den))
    zeros, poles = (np.sort_complex(r[r.imag >= 0]) for r in (roots(top), roots(bottom)))
    return float(top[-1] / bottom[-1]), zeros, poles


def as_latex(loop: control.TransferFunction, digits: int = 4) -> str:
    """Return a ``loop`` in factors, with so many ``digits``, as LaTeX in the report's manner [Eqs. 92-96]."""

    def number(x: float) -> str:
        text = f"{abs(x):.{digits}g}"
        mantissa, _, power = text.partition("e")
        return rf"{mantissa}\times 10^{{{int(power)}}}" if power else text

    def factor(root: complex) -> str:
        if root == 0:
            return "s"
        real = f"{'-' if root.real > 0 else '+'} {number(root.real)}"
        return rf"(s {real} \pm j\,{number(root.imag)})" if root.imag else f"(s {real})"

    gain, zeros, poles = factors(loop)
    sign = "-" if gain < 0 else ""
    return rf"\frac{{{sign}{number(gain)}\,{''.join(map(factor, zeros))}}}{{{''.join(map(factor, poles))}}}"


def closed_polynomial(loop: control.TransferFunction, gain: float = 1.0) -> NDArray:
    """Return denominator plus ``gain`` times numerator of a ``loop``, constant term first."""
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
    """Return phi_1 N_q1 + phi_2 N_q2 at ``sensor``, for ``signal`` delta or delta_r; shape (8,) [Eq. 119]."""
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
    """Return `theta_loop` of ``eqs``, K_C, K_R and ``closed`` for the rigid-body angle [Eqs. 110, 111]."""
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
    """Return the zeros (1/s) of Eq. 119 but the origin, from ``eqs`` at ``stations`` (ft); shape (K, 4)."""
    return np.array([roots(elastic_numerator(eqs, x)[1:]) for x in as_stations("stations", stations)])


def open_loop_parts(eqs: PerturbationEquations, K_C: float) -> dict[str, NDArray]:
    """Return the open loop's poles (1/s) by origin: rigid body, modes of ``eqs``, actuator (K_C in 1/s)."""
    poles, K_C = roots(eqs.characteristic_polynomial()), checks.real("K_C", K_C, "open_loop_parts")
    size = np.sort(np.abs(poles[poles.imag > 0]))
    pair = [poles[(poles.imag != 0) & np.isclose(np.abs(poles), s)] for s in size]
    real = poles[poles.imag == 0]
    return {"rigid": real, "mode 1": pair[0], "mode 2": pair[1], "actuator": np.array([-K_C])}


def branch_parts(locus: RootLocus, starts: Mapping[str, ArrayLike]) -> dict[str, list[int]]:
    """Return which branches of a locus start at given poles.

    Parameters
    ----------
    locus : RootLocus
        Its first gain is 0.
    starts : mapping of str to array_like of complex
        Poles (1/s) by name, as many as the locus has branches.

    Returns
    -------
    dict of str to list of int
        Columns of ``locus.roots`` by name, for `figures.loci.draw_root_locus`.
    """
    names = [name for name, poles in starts.items() for _ in np.atleast_1d(poles)]
    points = np.concatenate([np.atleast_1d(poles) for poles in starts.values()])
    columns = linear_sum_assignment(np.abs(points[:, None] - locus.roots[0]))[1]
    return {name: [int(c) for c, n in zip(columns, names, strict=True) if n == name] for name in starts}


class Closure(NamedTuple):
    """A loop closed at one gain: its locus, which branch is which, and where the roots arrive (1/s)."""

    locus: RootLocus
    parts: dict[str, list[int]]
    ends: dict[str, NDArray]

    @property
    def poles(self) -> NDArray:
        """All closed-loop poles (1/s)."""
        return np.concatenate(list(self.ends.values()))


def close(loop: control.TransferFunction, gain: float, starts: Mapping[str, ArrayLike]) -> Closure:
    """Return a loop's locus and what its named poles become at one gain.

    Parameters
    ----------
    loop : TransferFunction
    gain : float
        If it is negative, the locus runs over negative gains (its ``gains`` are their sizes).
    starts : mapping of str to array_like of complex
        The open-loop poles (1/s) by name: `open_loop_parts`, or the ends of a loop closed before.

    Returns
    -------
    Closure
    """
    signed = loop if gain >= 0 else -loop
    locus, path = root_locus(signed), root_locus(signed, np.linspace(0, abs(gain), 401))
    ends = {name: path.roots[-1, columns] for name, columns in branch_parts(path, starts).items()}
    return Closure(locus, branch_parts(locus, starts), ends)


def as_text(values: ArrayLike, digits: int = 3) -> str:
    """Return ``values`` (roots, 1/s) in one line, rightmost first, with so many ``digits``."""
    upper = sorted((r for r in np.asarray(values, complex) if r.imag >= 0), key=lambda r: -r.real)
    signed = [
        f"{r.real:.{digits}f} ± j{r.imag:.{digits}f}" if r.imag else f"{r.real:.{digits + 2}g}" for r in upper
    ]
    return ", ".join(signed).replace("-", "−")


def stiffening(eqs: PerturbationEquations, K_C: float, stations: ArrayLike) -> dict[str, NDArray]:
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
