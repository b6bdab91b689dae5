"""Root loci: where the closed-loop roots go as a gain, or any other parameter, runs.

Convention: negative feedback, 1 + k G(s) = 0, with k of either sign.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim import checks
from rlswaim.branches import continuous_branches, partners
from rlswaim.openloop import BreakAway, Crossing, OpenLoop, System, break_aways, crossings, open_loop
from rlswaim.polynomials import horner

SCREEN = (800, 600)
"""Size (pixels) of the picture for which gains are chosen."""
ANCHOR = 8
"""Of a long run of gains each eighth is solved by eigenvalues, and the others from these."""

Axes = tuple[float, float, float, float]


@dataclass(frozen=True, eq=False)
class RootLocus:
    """Closed-loop roots along a parameter.

    Attributes
    ----------
    gains : ndarray, shape (K,)
        The running parameter.
    roots : ndarray of complex, shape (K, n)
        Closed-loop roots (1/s); column j is one continuous branch.
    poles, zeros : ndarray of complex
        Open-loop poles and zeros (1/s); empty for a locus in another parameter than the loop gain.
    break_aways : tuple of BreakAway
    crossings : tuple of Crossing
    """

    gains: NDArray
    roots: NDArray
    poles: NDArray
    zeros: NDArray
    break_aways: tuple[BreakAway, ...] = ()
    crossings: tuple[Crossing, ...] = ()
    loop: OpenLoop | None = None

    @cached_property
    def condition(self) -> NDArray:
        """Relative change of each root per relative change of the polynomial's coefficients, shape (K, n).

        Above 1e3 three-digit data do not fix a root, above 1e13 double precision does not.
        """
        if self.loop is None:
            raise ValueError("condition: got a locus in a general parameter, wanted one in a loop gain")
        return _relative_condition(self.loop, self.gains, self.roots)

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """The open-loop mode that each branch leaves from (a general parameter: the first root), in words."""
        start = int(np.abs(self.gains).argmin())
        first = self.roots[start]
        leaves = first if self.loop is None else _leaves(self.loop, self.gains[start], first)
        return tuple(mode_name(pole) for pole in leaves)


def mode_name(pole: complex) -> str:
    """Return a name for a pole (1/s), the same for both of a pair."""
    if pole == 0:
        return "pole at the origin"
    return f"mode at {abs(pole):.3g} rad/s" if pole.imag else f"pole at {pole.real:.3g} 1/s"


def _aberth(polynomials: NDArray, guess: NDArray, steps: int = 5) -> tuple[NDArray, NDArray]:
    """Return roots (n, K) corrected by Aberth's iteration, and which sets (K,) are to be trusted."""
    s, n = guess.copy(), guess.shape[0]
    itself = np.eye(n, dtype=bool)[..., None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(steps):
            p, slope, terms = horner(polynomials, s)
            good = np.abs(p) <= 4e-16 * n * terms
            if good.all():
                break
            newton = p / slope
            push = np.where(itself, 0, 1 / np.where(itself, 1, s[:, None] - s[None])).sum(axis=1)
            s = s - np.where(good, 0, newton / (1 - newton * push))
        total = -polynomials[-2] / polynomials[-1]
        sum_rule = np.abs(s.sum(axis=0) - total) <= 1e-12 * np.abs(s).sum(axis=0)
    return s, good.all(axis=0) & sum_rule & np.isfinite(s).all(axis=0)


def _polish(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return eigenvalues (K, n) after one Newton step where the polynomial knows the root better."""
    s = values.T
    p, slope, terms = horner(loop.polynomials(gains), s)
    norm = np.linalg.norm(loop.A) + np.abs(gains) * np.linalg.norm(loop.B) * np.linalg.norm(loop.C)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        step = p / slope
        better = (terms < norm * np.abs(slope)) & (np.abs(step) < 1e-6 * np.abs(s))
    return np.where(better, s - np.where(better, step, 0), s).T


def _eigen(loop: OpenLoop, gains: NDArray) -> NDArray:
    return _polish(loop, gains, loop.eigenvalues(gains))


def _from_anchors(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return root sets (K, n) for rising gains: eigenvalues at anchors, Aberth between them."""
    at = np.unique(np.append(np.arange(0, gains.size, ANCHOR), gains.size - 1))
    anchors = continuous_branches(_eigen(loop, gains[at]))
    partner = partners(anchors)
    alike = (partner[:-1] == partner[1:]).all(axis=1)
    interval = np.clip(np.searchsorted(at, np.arange(gains.size), side="right") - 1, 0, at.size - 2)
    inner = np.setdiff1d(np.flatnonzero(alike[interval]), at)
    left = interval[inner]
    t = ((inner - at[left]) / (at[left + 1] - at[left]))[:, None]
    guess = (1 - t) * anchors[left] + t * anchors[left + 1]
    s, trusted = _aberth(loop.polynomials(gains[inner]), guess.T)
    pair = np.take_along_axis(s.T, partner[left], axis=1)
    values = np.empty((gains.size, anchors.shape[1]), dtype=complex)
    values[at] = anchors
    values[inner] = (s.T + pair.conj()) / 2
    rest = np.setdiff1d(np.arange(gains.size), np.concatenate([at, inner[trusted]]))
    values[rest] = _eigen(loop, gains[rest])
    return values


def _solve(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return the closed-loop roots (K, n) for gains in any order, as branches continuous in the gain."""
    order = np.argsort(gains, kind="stable")
    long = gains.size > 8 * ANCHOR and not loop.fixed_at_origin
    values = np.empty((gains.size, loop.poles.size), dtype=complex)
    values[order] = continuous_branches((_from_anchors if long else _eigen)(loop, gains[order]))
    return values


def _default_axes(loop: OpenLoop) -> Axes:
    """Return left, right, bottom, top (1/s) of a picture that shows all poles and zeros with some room."""
    points = np.concatenate([loop.poles, loop.zeros, [0.0]])
    left, right = points.real.min(), points.real.max()
    top = np.abs(points.imag).max()
    size = max(right - left, 2 * top, 1e-3)
    room = 0.3 * max(right - left, size / 4)
    return left - room, right + room, -1.3 * max(top, size / 8), 1.3 * max(top, size / 8)


def _chord_error(left: NDArray, middle: NDArray, right: NDArray, axes: Axes) -> NDArray:
    """Return how far (pixels) the middle roots lie off the chord between their neighbors, worst branch."""
    scale = np.array([SCREEN[0] / (axes[1] - axes[0]), SCREEN[1] / (axes[3] - axes[2])])
    a, m, b = ((z.real * scale[0], z.imag * scale[1]) for z in (left, middle, right))
    chord, offset = (b[0] - a[0], b[1] - a[1]), (m[0] - a[0], m[1] - a[1])
    length2 = np.maximum(chord[0] ** 2 + chord[1] ** 2, 1e-300)
    along = np.clip((chord[0] * offset[0] + chord[1] * offset[1]) / length2, 0, 1)
    miss = np.hypot(offset[0] - along * chord[0], offset[1] - along * chord[1])
    centre = (axes[0] + axes[1]) / 2 * scale[0], (axes[2] + axes[3]) / 2 * scale[1]
    seen = [
        (np.abs(z[0] - centre[0]) < 0.55 * SCREEN[0]) & (np.abs(z[1] - centre[1]) < 0.55 * SCREEN[1])
        for z in (a, m, b)
    ]
    return np.where(seen[0] | seen[1] | seen[2], miss, 0.0).max(axis=1, initial=0.0)


def _cut(low: NDArray, high: NDArray, pieces: NDArray, offset: float) -> NDArray:
    """Return the inner points of intervals of gains, each cut evenly in ln(k + offset)."""
    which = np.repeat(np.arange(low.size), pieces - 1)
    number = np.arange(which.size) - np.repeat(np.cumsum(pieces - 1) - (pieces - 1), pieces - 1) + 1
    a, b = low[which] + offset, high[which] + offset
    return a * (b / a) ** (number / pieces[which]) - offset


def _picture(
    loop: OpenLoop, marks: NDArray, axes: Axes, tolerance: float, sign: int
) -> tuple[NDArray, NDArray]:
    """Return gains of one sign, marks among them, and branches true to the curve within the tolerance."""
    lead = np.abs(loop.denominator).max() / max(np.abs(loop.numerator).max(), 1e-300)
    offset = 1e-6 * lead
    gains = np.unique(np.concatenate([[0.0], lead * np.logspace(-6, 7, 40), marks]))
    values, unsure = loop.eigenvalues(sign * gains), np.ones(gains.size - 1, dtype=bool)
    for _ in range(8):
        low, high = gains[:-1][unsure], gains[1:][unsure]
        middle = _cut(low, high, np.full(low.size, 2), offset)
        gains, values, at = _merged(gains, values, middle, loop.eigenvalues(sign * middle))
        error = _chord_error(values[at - 1], values[at], values[at + 1], axes)
        bad = error > tolerance
        if not bad.any():
            break
        # The sagitta falls with the square of the step: cut each half so that a third of the limit is left.
        pieces = np.clip(np.ceil(np.sqrt(0.75 * error[bad] / tolerance)), 2, 12).astype(int)
        ends = np.concatenate([at[bad] - 1, at[bad]]), np.concatenate([at[bad], at[bad] + 1])
        more = _cut(gains[ends[0]], gains[ends[1]], np.tile(pieces, 2), offset)
        wild = np.repeat(np.tile(error[bad] > 8 * tolerance, 2), np.tile(pieces, 2) - 1)
        gains, values, new = _merged(gains, values, more, loop.eigenvalues(sign * more))
        unsure = np.zeros(gains.size - 1, dtype=bool)
        unsure[new[wild] - 1] = unsure[new[wild]] = True
        if not wild.any():
            break
    return sign * gains, continuous_branches(_polish(loop, sign * gains, values))


def _merged(
    gains: NDArray, values: NDArray, more: NDArray, found: NDArray
) -> tuple[NDArray, NDArray, NDArray]:
    """Return gains and branches with some added, and where the added ones stand."""
    order = np.argsort(np.concatenate([gains, more]), kind="stable")
    place = np.empty_like(order)
    place[order] = np.arange(order.size)
    branches = continuous_branches(np.concatenate([values, found])[order])
    return np.concatenate([gains, more])[order], branches, place[gains.size :]


def _relative_condition(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return sum |c_i| |s|^i / (|s| |p'(s)|) for each root (K, n); 1 for a root that rests at the origin."""
    _, slope, terms = horner(loop.polynomials(gains), values.T)
    with np.errstate(divide="ignore", invalid="ignore"):
        condition = terms / (np.abs(values.T) * np.abs(slope))
    return np.where(values == 0, 1.0, condition.T)


def _leaves(loop: OpenLoop, gain: float, values: NDArray) -> NDArray:
    """Return for each root at one gain the open-loop pole that its branch leaves from."""
    path = np.linspace(0, 1, 33)[:-1] ** 3 * gain
    sets = np.concatenate([loop.eigenvalues(path), values[None]])[::-1]
    ends = continuous_branches(sets)[-1]
    nearest = np.abs(ends[:, None] - loop.poles[None, :]).argmin(axis=1)
    return loop.poles[nearest]


def root_locus(
    system: System,
    gains: ArrayLike | None = None,
    *,
    sign: int = 1,
    axes: Axes | None = None,
    tolerance: float = 0.25,
) -> RootLocus:
    """Return the root locus of 1 + k G(s) = 0.

    Parameters
    ----------
    system : StateSpace, TransferFunction or (A, B, C)
        The open loop G, single input and output, continuous and proper.
    gains : array_like, shape (K,), optional
        Gains of either sign, in the order wanted.  Without them gains of one sign
        are chosen so that the polyline of each branch stays within ``tolerance`` of
        the true curve; break-away points and axis crossings are among them.
    sign : int
        1 for gains from 0 up, -1 for gains from 0 down, where gains are chosen.
    axes : tuple of float, optional
        Left, right, bottom and top (1/s) of the picture; by default all poles and zeros with some room.
    tolerance : float
        Largest error (pixels, on a picture of 800 by 600).

    Returns
    -------
    RootLocus

    Raises
    ------
    TypeError
        If the system is no LTI system, or the gains are no real numbers.
    ValueError
        If the system is not single-input, single-output, continuous and proper, or a number is not
        finite, or a gain sends a root to infinity.
    """
    loop = open_loop(system)
    breaks, crosses = break_aways(loop), crossings(loop)
    if gains is None:
        marks = sign * np.array([mark.gain for mark in (*breaks, *crosses)])
        view = _default_axes(loop) if axes is None else axes
        limit = checks.positive("tolerance", tolerance, "root_locus")
        chosen, values = _picture(loop, marks[marks > 0], view, limit, sign)
    else:
        chosen = checks.frozen_array("gains", np.atleast_1d(np.asarray(gains)), "root_locus")
        if chosen.ndim != 1:
            raise ValueError(f"gains in root_locus: got shape {chosen.shape}, wanted one dimension")
        values = _solve(loop, chosen)
    return RootLocus(chosen, values, loop.poles, loop.zeros, breaks, crosses, loop)


def parameter_locus(
    closed_loop: Callable[[float], control.StateSpace | control.TransferFunction], values: ArrayLike
) -> RootLocus:
    """Return the closed-loop roots as any parameter runs: a gain, an actuator's pole, a station.

    Parameters
    ----------
    closed_loop : callable
        Returns the closed loop (LTI) for one value of the parameter.
    values : array_like, shape (K,)

    Returns
    -------
    RootLocus
        ``gains`` holds the values; there are no open-loop poles or zeros.

    Raises
    ------
    ValueError
        If a value is not finite or the order of the closed loop changes on the way.
    """
    run = checks.frozen_array("values", np.atleast_1d(np.asarray(values)), "parameter_locus")
    sets = [np.asarray(closed_loop(float(value)).poles(), dtype=complex) for value in run]
    for at, found in enumerate(sets):
        if found.size != sets[0].size:
            raise ValueError(
                f"parameter_locus: got {found.size} poles at values[{at}] = {run[at]:g}, "
                f"wanted {sets[0].size} as at {run[0]:g}"
            )
    nothing = np.zeros(0, complex)
    return RootLocus(run, continuous_branches(np.array(sets)), nothing, nothing)
