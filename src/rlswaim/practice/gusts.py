"""Winds: the 1-cosine gust and its worst length, wind shear with a gust on top, and turbulence.

Wind is a function of time here, in the unit of its amplitude; over the speed it is an incidence.  It
meets the whole vehicle at once, as the report's alpha_g does.
"""

from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_continuous_lyapunov

from rlswaim.practice.blocks import second_order
from rlswaim.source import checks


def one_minus_cosine(t: NDArray, amplitude: float, duration: float) -> NDArray:
    """Return amplitude/2 (1 - cos(2 pi t/duration)) while the gust lasts, 0 before and after.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times (s).
    amplitude : float
        Peak, in the unit of the result.
    duration : float
        From the first to the last touch of the gust (s).

    Returns
    -------
    ndarray, shape (n,)
    """
    inside = (t > 0) & (t < duration)
    return np.where(inside, amplitude / 2 * (1 - np.cos(2 * np.pi * t / duration)), 0.0)


def shear_with_gust(
    t: NDArray,
    wind: float,
    build_up: float,
    gust: float,
    edge: float,
    plateau: float,
    together: float = 0.85,
) -> NDArray:
    """Return a synthetic profile: the wind builds up, and as it peaks a gust stands on top of it.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times (s).
    wind : float
        Peak of the steady wind; it falls off after the gust as it rose.
    build_up : float
        Time of the rise, half a cosine (s).
    gust : float
        Height of the gust on top, in the unit of ``wind``.
    edge, plateau : float
        Times of the gust's rise and fall, half cosines, and of its flat top (s).
    together : float
        Factor of both, since the worst of each seldom meet (1).

    Returns
    -------
    ndarray, shape (n,)
    """

    def ramp(start: float, length: float) -> NDArray:
        return 0.5 * (1 - np.cos(np.pi * np.clip((t - start) / length, 0, 1)))

    for what, value in (("build_up", build_up), ("edge", edge)):
        checks.positive(what, value, "shear_with_gust")
    checks.not_negative("plateau", plateau, "shear_with_gust")
    end = build_up + edge + plateau
    steady = wind * (ramp(0, build_up) - ramp(end, build_up))
    return together * (steady + gust * (ramp(build_up - edge, edge) - ramp(end - edge, edge)))


def dryden(sigma: float, length: float, speed: float) -> control.StateSpace:
    """Return the filter that makes lateral Dryden turbulence from white noise of unit intensity.

    sigma sqrt(T) (1 + sqrt(3) T s)/(1 + T s)^2 with T = length/speed.

    Parameters
    ----------
    sigma : float
        RMS of the turbulence.
    length : float
        Its scale.
    speed : float
        Of the vehicle, in the same unit of length (per s).

    Returns
    -------
    control.StateSpace
        Its output has the RMS ``sigma``.
    """
    T = checks.positive("length", length, "dryden") / checks.positive("speed", speed, "dryden")
    size = sigma * np.sqrt(T)
    names = {"name": "dryden", "inputs": "noise", "outputs": "wind"}
    return second_order([size * np.sqrt(3) * T, size], [T**2, 2 * T, 1.0], **names)


def rms(system: control.StateSpace, noise: control.StateSpace | None = None) -> dict[str, float]:
    """Return the RMS of each output of a stable system in turbulence, by Lyapunov's equation.

    Parameters
    ----------
    system : control.StateSpace
        With one input.
    noise : control.StateSpace, optional
        The filter that makes the input from white noise of unit intensity, for instance `dryden`.

    Returns
    -------
    dict of str to float
        By the names of the outputs.

    Raises
    ------
    ValueError
        If the system is not stable, or passes white noise straight through.
    """
    driven = system if noise is None else control.series(noise, system)
    largest = float(driven.poles().real.max())
    if largest >= 0:
        raise ValueError(f"system in rms: got a pole with real part {largest:.3g}, wanted a stable system")
    if np.any(driven.D):
        raise ValueError("system in rms: got white noise passed straight through, wanted D = 0")
    spread = solve_continuous_lyapunov(driven.A, -driven.B @ driven.B.T)
    variances = np.diag(driven.C @ spread @ driven.C.T)
    return dict(zip(system.output_labels, np.sqrt(np.maximum(variances, 0)).tolist(), strict=True))


def response(system: control.StateSpace, t: NDArray, wind: NDArray) -> dict[str, NDArray]:
    """Return how a system with one input moves in a wind.

    Parameters
    ----------
    system : control.StateSpace
    t, wind : ndarray, shape (n,)
        Equally spaced times (s), and the input at them, straight between them.

    Returns
    -------
    dict of str to ndarray, shape (n,)
        Each output over time, by its name.
    """
    found = control.forced_response(system, t, wind)
    values = np.asarray(found.y).reshape(system.noutputs, -1)
    return dict(zip(system.output_labels, values, strict=True))


DURATIONS = (0.2, 60.0)
"""The shortest and the longest gust that is tried (s)."""
COUNT, FINE = 40, 21
"""How many lengths are tried, and how many between the neighbours of the worst of them."""


class WorstGust(NamedTuple):
    """The gust that moves one output most: its duration (s), and the peak that it makes."""

    duration: float
    peak: float


def worst_gust(
    system: control.StateSpace,
    output: str,
    amplitude: float,
    durations: tuple[float, float] = DURATIONS,
    count: int = COUNT,
    step: float = 0.005,
) -> WorstGust:
    """Return the 1-cosine gust of the worst length for one output.

    Parameters
    ----------
    system : control.StateSpace
        Stable, with one input.
    output : str
    amplitude : float
        Peak of every gust, in the unit of the input.
    durations : (float, float)
        The shortest and the longest (s).
    count : int
        Of lengths tried, in equal ratios; the best is refined between its neighbours.
    step : float
        Of time (s).

    Returns
    -------
    WorstGust
        Its peak is a lower bound of the true one over all lengths, as near as the steps are fine.
    """
    checks.one_of("output", output, system.output_labels, "worst_gust")
    t = np.arange(0, 2 * durations[1], step)
    row = system.output_labels.index(output)
    single = control.ss(system.A, system.B, system.C[[row]], system.D[[row]])
    to_step = control.forced_response(single, t, np.ones_like(t)).y.squeeze()

    def peak(duration: float) -> float:
        slope = np.diff(one_minus_cosine(t, amplitude, duration), prepend=0.0)
        return float(np.abs(_convolved(slope, to_step)).max())

    lengths = np.geomspace(*durations, count)
    peaks = [peak(length) for length in lengths]
    at = int(np.argmax(peaks))
    fine = np.geomspace(lengths[max(at - 1, 0)], lengths[min(at + 1, count - 1)], FINE)
    return max((WorstGust(float(d), peak(d)) for d in [lengths[at], *fine]), key=lambda gust: gust.peak)


def _convolved(increments: NDArray, to_step: NDArray) -> NDArray:
    """Return the sum of steps at all times, each with the response to a unit step."""
    size = 2 * increments.size
    product = np.fft.rfft(increments, size) * np.fft.rfft(to_step, size)
    return np.fft.irfft(product, size)[: increments.size]
