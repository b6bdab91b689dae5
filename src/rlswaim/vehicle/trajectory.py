"""The ascent of Section II: the report's closed forms beside an integration in a standard atmosphere.

Thrust and propellant flow are constant and there is no drag, as in the report.
The pitch program gamma_0(t) is a parameter: a callable from time (s) to the
flight path angle (rad).  The report does not print its own; `level_at_burnout`
is the one that the book assumes.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from ambiance import Atmosphere
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from rlswaim.source import checks
from rlswaim.source.quantity import quantity
from rlswaim.source.tables import constants

FOOT, SLUG = 0.3048, 14.59390294
"""Metres in a foot, kilograms in a slug: the atmosphere comes in SI units."""

PitchProgram = Callable[[float], float]


def density(h: ArrayLike) -> NDArray:
    """Return the air density (slug/ft^3) of the standard atmosphere at altitudes h (ft).

    Raises
    ------
    ValueError
        If an altitude lies outside the atmosphere's 81 km (265,000 ft), or below the ground.
    """
    heights = checks.frozen_array("h", np.atleast_1d(h), "density")
    if heights.min() < 0 or heights.max() > 265000:
        worst = heights[np.argmax(np.abs(heights - 132500))]
        raise ValueError(f"h in density: got {worst:g} ft, wanted 0 to 265000 ft")
    return Atmosphere(heights * FOOT).density * FOOT**3 / SLUG


def dynamic_pressure(h: ArrayLike, U: ArrayLike) -> NDArray:
    """Return the dynamic pressure q_D = rho U^2 / 2 (lb/ft^2) in the standard atmosphere.

    Parameters
    ----------
    h, U : array_like
        Altitudes (ft) and speeds (ft/s).
    """
    return density(h) * np.asarray(U) ** 2 / 2


def speed_for(q_D: float, h: float) -> float:
    """Return the speed (ft/s) that gives a dynamic pressure in the standard atmosphere.

    Parameters
    ----------
    q_D : float
        Dynamic pressure (lb/ft^2).
    h : float
        Altitude (ft).
    """
    return float(np.sqrt(2 * q_D / density(h))[0])


@dataclass(frozen=True)
class Ascent:
    """A first stage with constant thrust and propellant flow; ValueError if a number is not positive.

    Its methods take a time or an array of times (s), and the mean of sin gamma_0 up to then [Eq. 33].
    """

    M_0: float = quantity("M_0", "slug", "launch mass", "Section II")
    m_p: float = quantity("m_p", "slug/s", "propellant flow", "Section II")
    T: float = quantity("T", "lb", "thrust", "Section II")
    g: float = quantity("g", "ft/s^2", "acceleration of gravity", "assumed")
    t_burn: float = quantity("t_b", "s", "burning time of the first stage", "Section II")

    def __post_init__(self) -> None:
        """Check the numbers."""
        for name in ("M_0", "m_p", "T", "g", "t_burn"):
            object.__setattr__(self, name, checks.positive(name, getattr(self, name), "Ascent"))
        checks.positive("mass at burnout", self.M_0 - self.m_p * self.t_burn, "Ascent")

    def times(self, t: ArrayLike) -> NDArray:
        """Return times t (s) as an array; ValueError outside 0..t_burn."""
        array = checks.frozen_array("t", t, "Ascent")
        if array.min() < 0 or array.max() > self.t_burn:
            worst = array.flat[np.argmax(np.abs(array - self.t_burn / 2))]
            raise ValueError(f"t in Ascent: got {worst:g} s, wanted 0 to {self.t_burn:g} s")
        return array

    def mass(self, t: ArrayLike) -> NDArray:
        """Return M = M_0 - m_p t (slug)."""
        return self.M_0 - self.m_p * self.times(t)

    def acceleration(self, t: ArrayLike, sine: ArrayLike) -> NDArray:
        """Return the acceleration along the path, a_0 = T/M - g sin gamma_0 (ft/s^2) [Eq. 30].

        Parameters
        ----------
        t : array_like
            Times (s).
        sine : array_like
            Sine of the path's angle, sin gamma_0.
        """
        return self.T / self.mass(t) - self.g * np.asarray(sine)

    def speed(self, t: ArrayLike, mean_sine: ArrayLike) -> NDArray:
        """Return the speed U (ft/s), the integral of a_0 [Eqs. 31, 32].

        Parameters
        ----------
        t : array_like
            Times (s).
        mean_sine : array_like
            Mean of sin gamma_0 up to then [Eq. 33].
        """
        s = np.asarray(mean_sine)
        return self.T / self.m_p * np.log(self.M_0 / self.mass(t)) - self.g * self.times(t) * s

    def altitude(self, t: ArrayLike, mean_sine: ArrayLike) -> NDArray:
        """Return the altitude h (ft), with the mean sine taken out of the integrals [Eq. 37].

        Parameters
        ----------
        t : array_like
            Times (s).
        mean_sine : array_like
            Mean of sin gamma_0 up to then [Eq. 33].
        """
        t, s, burn = self.times(t), np.asarray(mean_sine), self.M_0 / self.m_p
        log = np.log(self.M_0 / self.mass(t))
        return self.T * s / self.m_p * ((1 + log) * t - burn * log) - self.g * t**2 * s**2 / 2

    def altitude_before_collecting(self, t: ArrayLike, mean_sine: ArrayLike) -> NDArray:
        """Return the altitude h (ft) as first integrated; it is the same as `altitude` [Eqs. 35, 36].

        Parameters
        ----------
        t : array_like
            Times (s).
        mean_sine : array_like
            Mean of sin gamma_0 up to then [Eq. 33].
        """
        t, s, burn = self.times(t), np.asarray(mean_sine), self.M_0 / self.m_p
        logs = t * np.log(self.M_0) + (burn - t) * (np.log(self.mass(t)) - 1) - burn * (np.log(self.M_0) - 1)
        return self.T * s / self.m_p * logs - self.g * t**2 * s**2 / 2

    def mean_sine_for_speed(self, t: float, U: float) -> float:
        """Return the mean of sin gamma_0 with which Eq. 32 gives a speed.

        Parameters
        ----------
        t, U : float
            Time (s) and speed then (ft/s).
        """
        return float((self.speed(t, 0.0) - U) / (self.g * t))

    def mean_sine_for_altitude(self, t: float, h: float) -> float:
        """Return the mean of sin gamma_0 for which Eq. 37 gives an altitude.

        Parameters
        ----------
        t, h : float
            Time (s) and altitude then (ft).

        Raises
        ------
        ValueError
            If no mean from 0 to 1 gives it.
        """
        if not 0 <= h <= self.altitude(t, 1.0):
            raise ValueError(f"h: got {h:g} ft, wanted 0 to {self.altitude(t, 1.0):g} ft at t = {t:g} s")
        return float(brentq(lambda s: float(self.altitude(t, s)) - h, 0.0, 1.0))


def swaim_ascent() -> Ascent:
    """Return the first stage of the report's booster [Section II]."""
    data = constants("vehicle")
    return Ascent(M_0=data["W_0"] / data["g"], **{k: data[k] for k in ("m_p", "T", "g", "t_burn")})


def level_at_burnout(ascent: Ascent) -> PitchProgram:
    """Return an ascent's gamma_0 = 90 deg (1 - t/t_burn): a constant turn from vertical to level."""
    return lambda t: np.pi / 2 * (1 - t / ascent.t_burn)


def turn(upright: float, level: float) -> PitchProgram:
    """Return the program of a flight that is vertical at first and is then turned evenly to level.

    Parameters
    ----------
    upright, level : float
        When the turn begins and when the flight is level (s).

    Raises
    ------
    ValueError
        If a time is negative or not finite, or the flight is level before it turns.
    """
    start = checks.not_negative("upright", upright, "turn")
    end = start + checks.positive("level - upright", level - start, "turn")
    return lambda t: np.pi / 2 * np.clip((end - t) / (end - start), 0.0, 1.0)


def mean_sine(gamma_0: PitchProgram, t: float) -> float:
    """Return the mean of sin gamma_0 from launch to a time [Eq. 33].

    Parameters
    ----------
    gamma_0 : callable
        Pitch program: flight path angle (rad) at time (s).
    t : float
        Time (s).
    """
    return float(quad(lambda tau: np.sin(gamma_0(tau)), 0, t)[0] / t) if t else float(np.sin(gamma_0(0.0)))


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Speed U (ft/s), altitude h (ft) and dynamic pressure q_D (lb/ft^2) at ``times`` (s); arrays (N,)."""

    times: NDArray
    U: NDArray
    h: NDArray

    @property
    def q_D(self) -> NDArray:
        """Dynamic pressure in the standard atmosphere (lb/ft^2)."""
        return dynamic_pressure(self.h, self.U)

    def at(self, t: float) -> dict[str, float]:
        """Return U, h and q_D at time t (s), linear between the sampled times."""
        return {name: float(np.interp(t, self.times, getattr(self, name))) for name in ("U", "h", "q_D")}

    @property
    def peak(self) -> tuple[float, float]:
        """Time (s) and size (lb/ft^2) of the largest sampled dynamic pressure."""
        return float(self.times[np.argmax(self.q_D)]), float(self.q_D.max())


def fly(ascent: Ascent, gamma_0: PitchProgram, times: ArrayLike) -> Trajectory:
    """Return the ascent integrated from rest at sea level: U' = a_0 [Eq. 30], h' = U sin gamma_0.

    Parameters
    ----------
    ascent : Ascent
    gamma_0 : callable
        Pitch program: flight path angle (rad) at time (s).
    times : array_like, shape (N,)
        Increasing times (s) within the burning time.

    Returns
    -------
    Trajectory
    """
    run = ascent.times(times)

    def rates(t: float, state: NDArray) -> list[float]:
        sine = np.sin(checks.real("gamma_0", gamma_0(t), f"fly at t = {t:g} s"))
        return [float(ascent.acceleration(t, sine)), state[0] * sine]

    flown = solve_ivp(rates, (0, run[-1]), [0.0, 0.0], t_eval=run, rtol=1e-9, atol=1e-6)
    return Trajectory(run, *flown.y)


def closed_form(ascent: Ascent, gamma_0: PitchProgram, times: ArrayLike) -> Trajectory:
    """Return the ascent by Eqs. 32 and 37, with the mean of sin gamma_0 as in Eq. 33.

    Parameters
    ----------
    ascent, gamma_0, times
        As in `fly`.
    """
    run = ascent.times(times)
    sines = np.array([mean_sine(gamma_0, float(t)) for t in run])
    return Trajectory(run, ascent.speed(run, sines), ascent.altitude(run, sines))
