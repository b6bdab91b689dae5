"""All frequencies at which a real rational function is real on the imaginary axis."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.repeated_roots import EPS

SPREAD = np.array([-8.0, -2.5, -1.0, -0.4, 0.0, 0.4, 1.0, 2.5, 8.0])
"""First points around each place, times its distance from the axis."""
LEVELS = 60
"""So often an interval is halved at most: then it is as narrow as its ends' rounding."""


class Phase(NamedTuple):
    """The phase offset + sum of weights atan((omega - imag)/(-real)) of places real + j imag off the axis."""

    real: NDArray
    imag: NDArray
    weights: NDArray
    offset: float

    def terms(self, omega: NDArray) -> NDArray:
        """Return each place's part of the phase at ``omega`` (M,), shape (P, M); each rises or falls."""
        return -self.weights[:, None] * np.arctan((omega - self.imag[:, None]) / self.real[:, None])

    def slope(self, omega: NDArray) -> NDArray:
        """Return the derivative of the phase at ``omega``."""
        return self._slopes((omega - self.imag[:, None]) ** 2).sum(axis=0)

    def _slopes(self, square: NDArray) -> NDArray:
        return (-self.weights * self.real)[:, None] / (self.real[:, None] ** 2 + square)

    def slope_bounds(self, low: NDArray, high: NDArray) -> tuple[NDArray, NDArray]:
        """Return bounds of the derivative of the phase on intervals.

        Parameters
        ----------
        low, high : ndarray, shape (K,)
            Ends of each interval (rad/s; in discrete time rad).

        Returns
        -------
        tuple of ndarray, shape (K,)
            The least and the most that it can be.
        """
        before, after = low - self.imag[:, None], high - self.imag[:, None]
        least = np.maximum(np.maximum(before, -after), 0.0)
        most = np.maximum(np.abs(before), np.abs(after))
        ends = self._slopes(least**2), self._slopes(most**2)
        return np.minimum(*ends).sum(axis=0), np.maximum(*ends).sum(axis=0)


def real_frequencies(phase: Phase, top: float) -> NDArray:
    """Return all frequencies within (0, top] where the phase passes a multiple of pi.

    Intervals are halved until each either can be excluded, because no multiple of pi lies between
    the bounds of the phase, or has a phase that only rises or only falls.  Places where the phase
    touches a multiple of pi and turns back are not returned.

    Parameters
    ----------
    phase : Phase
    top : float

    Returns
    -------
    ndarray
    """
    grid = (phase.imag[:, None] + np.abs(phase.real[:, None]) * SPREAD).ravel()
    grid = np.unique(np.concatenate([[0.0, top], grid[(grid > 0) & (grid < top)]]))
    low, high, brackets = grid[:-1], grid[1:], []
    for _ in range(LEVELS):
        low, high = _possible(phase, low, high)
        if not low.size:
            break
        slowest, fastest = phase.slope_bounds(low, high)
        turns = [np.floor((phase.offset + phase.terms(end).sum(axis=0)) / np.pi) for end in (low, high)]
        one_way = (slowest > 0) | (fastest < 0)
        settled = one_way & (np.abs(turns[1] - turns[0]) <= 1)
        passed = settled & (turns[0] != turns[1])
        brackets.append((low[passed], high[passed], np.pi * np.maximum(*turns)[passed], slowest[passed] > 0))
        low, high = low[~settled], high[~settled]
        middle = (low + high) / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    if not brackets:
        return np.zeros(0)
    found = _bracketed(phase, *(np.concatenate(part) for part in zip(*brackets, strict=True)))
    smallest = np.hypot(phase.real, phase.imag).min()
    return np.unique(found[found > 1e-12 * smallest])


def _possible(phase: Phase, low: NDArray, high: NDArray) -> tuple[NDArray, NDArray]:
    """Return the intervals in which the phase may be a multiple of pi."""
    start, end = phase.terms(low), phase.terms(high)
    change, at = end - start, phase.offset + start.sum(axis=0)
    rounding = 8 * phase.real.size * EPS * np.pi
    least = at + np.minimum(change, 0).sum(axis=0) - rounding
    most = at + np.maximum(change, 0).sum(axis=0) + rounding
    keep = np.floor(least / np.pi) != np.floor(most / np.pi)
    return low[keep], high[keep]


def _bracketed(phase: Phase, low: NDArray, high: NDArray, target: NDArray, rising: NDArray) -> NDArray:
    """Return where the phase is a multiple of pi, by Newton's steps, or by halves where these lead out.

    Parameters
    ----------
    phase : Phase
    low, high : ndarray, shape (M,)
        Ends of intervals in which the phase only rises or only falls.
    target : ndarray, shape (M,)
        The multiple of pi that is passed in each.
    rising : ndarray of bool, shape (M,)

    Returns
    -------
    ndarray, shape (M,)
    """
    omega, rounding = (low + high) / 2, 8 * phase.real.size * EPS * np.pi
    for _ in range(80):
        value = phase.offset + phase.terms(omega).sum(axis=0) - target
        beyond = (value > 0) == rising
        low, high = np.where(beyond, low, omega), np.where(beyond, omega, high)
        step = omega - value / phase.slope(omega)
        settled = np.abs(value) <= rounding  # the last step: another would follow rounding alone
        other = np.where(settled, omega, (low + high) / 2)
        after = np.where((step >= low) & (step <= high), step, other)
        done = settled | (np.abs(after - omega) <= 2 * EPS * np.abs(omega))
        omega = after
        if done.all():
            break
    return omega
