"""All frequencies at which a real rational function is real on the imaginary axis."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS

SPREAD = np.array([-8.0, -2.5, -1.0, -0.4, 0.0, 0.4, 1.0, 2.5, 8.0])
"""First points around each place, times its distance from the axis."""
PARTS = 8
"""An interval is cut into so many."""
LEVELS = 30
"""So often an interval is cut at most: then it is as narrow as its ends' rounding."""
MOST = 20_000
"""So many intervals are looked at together at most; then the ends of each decide."""


class Phases(NamedTuple):
    """S phases offset + sum of weights atan((omega - imag)/(-real)) of places real + j imag off the axis.

    Places (P, S), weights (P, 1), offsets (S,).
    """

    real: NDArray
    imag: NDArray
    weights: NDArray
    offsets: NDArray

    def at(self, which: NDArray) -> "Phases":
        """Return the phases of given numbers."""
        return Phases(self.real[:, which], self.imag[:, which], self.weights, self.offsets[which])

    def terms(self, omega: NDArray) -> NDArray:
        """Return each place's part (P, S), rising or falling, of each phase at its own ``omega`` (S,)."""
        return -self.weights * np.arctan((omega - self.imag) / self.real)

    def slope(self, omega: NDArray) -> NDArray:
        """Return the derivative of each phase at its own ``omega`` (S,)."""
        return self._slopes((omega - self.imag) ** 2).sum(axis=0)

    def _slopes(self, square: NDArray) -> NDArray:
        return -self.weights * self.real / (self.real**2 + square)

    def slope_bounds(self, low: NDArray, high: NDArray) -> tuple[NDArray, NDArray]:
        """Return the least and the most (S,) that the derivative of each phase can be in its own interval.

        Parameters
        ----------
        low, high : ndarray, shape (S,)
            Ends of the intervals (rad/s; in discrete time rad).
        """
        before, after = low - self.imag, high - self.imag
        least = np.maximum(np.maximum(before, -after), 0.0)
        most = np.maximum(np.abs(before), np.abs(after))
        ends = self._slopes(least**2), self._slopes(most**2)
        return np.minimum(*ends).sum(axis=0), np.maximum(*ends).sum(axis=0)


class _Intervals(NamedTuple):
    """M intervals, the number of the phase in each, and its terms (P, M) at both ends."""

    low: NDArray
    high: NDArray
    which: NDArray
    at_low: NDArray
    at_high: NDArray

    def at(self, mask: NDArray) -> "_Intervals":
        """Return some of the intervals."""
        return _Intervals(*(part[..., mask] for part in self))

    def parts(self, phases: Phases) -> "_Intervals":
        """Return each interval cut evenly: the first parts of all, the second parts of all, and so on."""
        ends, count = np.linspace(self.low, self.high, PARTS + 1), self.low.size
        inner = phases.at(np.tile(self.which, PARTS - 1)).terms(ends[1:-1].ravel())
        terms = np.concatenate([self.at_low, inner, self.at_high], axis=1)
        which = np.tile(self.which, PARTS)
        return _Intervals(ends[:-1].ravel(), ends[1:].ravel(), which, terms[:, :-count], terms[:, count:])


def real_frequencies(phases: Phases, tops: NDArray) -> list[NDArray]:
    """Return for each phase all frequencies within (0, top] where it passes a multiple of pi.

    Intervals are cut until each either can be excluded, because no multiple of pi lies between
    the bounds of the phase, or has a phase that only rises or only falls.  Places where the phase
    touches a multiple of pi and turns back are not returned.  Where places all but cancel each other the
    bounds stay wide however often intervals are cut: a limited number of them is looked at.

    Parameters
    ----------
    phases : Phases
    tops : ndarray, shape (S,)

    Returns
    -------
    list of ndarray
    """
    cells, found = _first_intervals(phases, tops), []
    rounding = 8 * phases.weights.size * EPS * np.pi
    for level in range(LEVELS):
        start, end = (phases.offsets[cells.which] + part.sum(axis=0) for part in cells[3:])
        up = np.maximum(cells.at_high - cells.at_low, 0).sum(axis=0)
        keep = _may_pass(end - up - rounding, start + up + rounding)
        if not keep.any():
            break
        cells, start, end = cells.at(keep), start[keep], end[keep]
        turns = np.floor(np.array([start, end]) / np.pi)
        slopes = phases.at(cells.which).slope_bounds(cells.low, cells.high)
        settled = ((slopes[0] > 0) | (slopes[1] < 0)) & (np.abs(turns[1] - turns[0]) <= 1)
        left = ~settled
        if left.any():
            width = cells.high - cells.low
            unsure = rounding * (1 + width * (slopes[1] - slopes[0]))
            least, most = _within(start, end, slopes[0] * width, slopes[1] * width)
            left &= _may_pass(least - unsure, most + unsure)
        if level == LEVELS - 1 or PARTS * np.count_nonzero(left) > MOST:
            left, settled = np.zeros_like(left), settled | left
        target = np.pi * turns.max(axis=0)
        clear = np.maximum(np.abs(start - target), np.abs(end - target)) > rounding
        passed = settled & (turns[0] != turns[1]) & clear  # not where rounding alone goes to and fro
        found.append((*cells.at(passed), target[passed]))
        if not left.any():
            break
        cells = cells.at(left).parts(phases)
    if not found:
        return [np.zeros(0) for _ in tops]
    *brackets, target = (np.concatenate(part, axis=-1) for part in zip(*found, strict=True))
    omega, which = _bracketed(phases, _Intervals(*brackets), target), brackets[2]
    smallest = np.hypot(phases.real, phases.imag).min(axis=0)
    return [np.unique(omega[(which == i) & (omega > 1e-12 * size)]) for i, size in enumerate(smallest)]


def _may_pass(least: NDArray, most: NDArray) -> NDArray:
    """Return whether a multiple of pi lies between the ``least`` and the ``most`` that phases can be."""
    return np.asarray(np.floor(least / np.pi) != np.floor(most / np.pi))


def _within(start: NDArray, end: NDArray, slowest: NDArray, fastest: NDArray) -> tuple[NDArray, NDArray]:
    """Return the least and the most that a function can be between its ends.

    Where it may fall and rise, it lies above the two lines that fall as steeply as can be from either end.

    Parameters
    ----------
    start, end : ndarray, shape (M,)
        Its values at the ends.
    slowest, fastest : ndarray, shape (M,)
        The least and the most that its derivative can be, times the distance of the ends.

    Returns
    -------
    tuple of ndarray
    """
    down, up = np.minimum(slowest, 0.0), np.maximum(fastest, 1e-300)
    spread = up - down
    least = (up * start - down * end + up * down) / spread
    most = (up * end - down * start - up * down) / spread
    return least, most


def _first_intervals(phases: Phases, tops: NDArray) -> _Intervals:
    """Return the intervals between 0, points around each place, and the top of each phase."""
    grid = phases.imag + np.abs(phases.real) * SPREAD[:, None, None]
    grid = np.vstack([0 * tops, tops, grid.reshape(-1, tops.size)])
    grid = np.sort(np.clip(grid, 0, tops), axis=0).T
    which, at = np.nonzero(grid[:, 1:] > grid[:, :-1])
    low, high = grid[which, at], grid[which, at + 1]
    last = np.append(which[1:] != which[:-1], True)
    at_low, at_top = phases.at(which).terms(low), phases.terms(tops)
    at_high = np.concatenate([at_low[:, 1:], at_top[:, -1:]], axis=1)
    at_high[:, last] = at_top
    return _Intervals(low, high, which, at_low, at_high)


def _bracketed(phases: Phases, cells: _Intervals, target: NDArray) -> NDArray:
    """Return where a phase is a multiple of pi, by Newton's steps, or by halves where these lead out.

    Parameters
    ----------
    phases : Phases
    cells : _Intervals
        M intervals in which the phase only rises or only falls.
    target : ndarray, shape (M,)
        The multiple of pi that is passed in each.

    Returns
    -------
    ndarray, shape (M,)
    """
    low, high, which, *ends = cells
    own = phases.at(which)
    before, after = (own.offsets + end.sum(axis=0) - target for end in ends)
    rising, rounding = after > before, 8 * phases.weights.size * EPS * np.pi
    nearest, omega = np.abs(own.real).min(axis=0), low - (high - low) * before / (after - before)
    for _ in range(80):
        value = own.offsets + own.terms(omega).sum(axis=0) - target
        beyond = (value > 0) == rising
        low, high = np.where(beyond, low, omega), np.where(beyond, omega, high)
        with np.errstate(divide="ignore", invalid="ignore"):  # the phase may rest there
            step = omega - value / own.slope(omega)
        settled = np.abs(value) <= rounding  # the last step: another would follow rounding alone
        inside = (step >= low) & (step <= high)
        after = np.where(inside, step, np.where(settled, omega, (low + high) / 2))
        change = np.abs(after - omega)
        # Newton's next step is some square of this one over the distance to the nearest place.
        done = settled | (change <= 2 * EPS * omega) | (inside & (change**2 <= EPS * omega * nearest))
        omega = after
        if done.all():
            break
    return omega
