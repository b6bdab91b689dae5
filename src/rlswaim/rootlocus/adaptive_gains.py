"""The gains of a picture: chosen so that drawn branches stay true to the curve within a part of a pixel."""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.closed_loop import ClosedLoop, RootSets
from rlswaim.rootlocus.continuation import between, nearly_connected, surely_connected
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.successors import passes_infinity

SCREEN = (800, 600)
"""Size (pixels) of the picture for which gains are chosen."""
DECADES = np.logspace(-6, 7, 32)
"""First gains, times the size of D over that of N."""
MOST = 4000
"""No picture takes more gains than this."""

Axes: TypeAlias = tuple[float, float, float, float]


def default_axes(loop: OpenLoop) -> Axes:
    """Return left, right, bottom, top (1/s) of a picture that shows all poles and zeros with some room.

    In discrete time it shows the unit circle too.
    """
    points = np.concatenate([loop.poles, loop.zeros, [1.0, 1j, -1.0] if loop.discrete else [0.0]])
    left, right = points.real.min(), points.real.max()
    top = np.abs(points.imag).max()
    size = max(right - left, 2 * top, 1e-3)
    room = 0.3 * max(right - left, size / 4)
    return left - room, right + room, -1.3 * max(top, size / 8), 1.3 * max(top, size / 8)


def _in_view(values: NDArray, axes: Axes) -> NDArray:
    """Return which points lie on the picture or close to it."""
    x, y = (axes[0] + axes[1]) / 2, (axes[2] + axes[3]) / 2
    near = np.abs(values.real - x) < 0.55 * (axes[1] - axes[0])
    return near & (np.abs(values.imag - y) < 0.55 * (axes[3] - axes[2]))


def _deviation(sets: RootSets, axes: Axes) -> NDArray:
    """Return how far (pixels) the curve strays from its chord between neighbors, worst branch in view.

    A cubic with slopes a, b against its chord strays at most 4/27 (|a| + |b|) times the chord.
    At a double root, which has no tangent, the slope of the other end serves.
    """
    scale = SCREEN[0] / (axes[1] - axes[0]), SCREEN[1] / (axes[3] - axes[2])
    known = sets.tangents != 0
    tangent, chord = (
        scale[0] * part.real + 1j * scale[1] * part.imag
        for part in (np.sign(sets.gains[-1]) * sets.tangents, sets.roots[1:] - sets.roots[:-1])
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        turned = [t * chord.conj() for t in (tangent[:-1], tangent[1:])]
        steep = [np.where(t.real > 0, np.minimum(np.abs(t.imag) / t.real, 10), 10) for t in turned]
    left = np.where(known[:-1], steep[0], steep[1])
    right = np.where(known[1:], steep[1], steep[0])
    near = _in_view(sets.roots, axes)
    seen = (near[:-1] | near[1:]) & (known[:-1] | known[1:])
    return np.where(seen, 4 / 27 * (left + right) * np.abs(chord), 0.0).max(axis=1, initial=0.0)


def _cut(low: NDArray, high: NDArray, pieces: NDArray, offset: float) -> tuple[NDArray, NDArray]:
    """Return the inner points of intervals of gains, each cut evenly in ln(k + offset), and the intervals."""
    which = np.repeat(np.arange(low.size), pieces - 1)
    number = np.arange(1, which.size + 1) - (np.cumsum(pieces - 1) - pieces + 1)[which]
    a, b = low[which] + offset, high[which] + offset
    return a * (b / a) ** (number / pieces[which]) - offset, which


def picture(
    closed: ClosedLoop, marks: NDArray, axes: Axes, tolerance: float, sign: int
) -> tuple[NDArray, NDArray]:
    """Return gains and branches of the moving roots, true to the curve.

    Parameters
    ----------
    closed : ClosedLoop
    marks : ndarray
        Gains that shall be among those returned, as sizes.
    axes : tuple of float
        Left, right, bottom and top (1/s).
    tolerance : float
        Largest distance from the curve (pixels, on a picture of 800 by 600).
    sign : int
        1 or -1: that of the gains.

    Returns
    -------
    tuple of ndarray, shapes (K,) and (K, n)
    """
    loop = closed.loop
    if closed.order == 0:  # nothing moves
        return np.array([0.0, sign]), np.zeros((2, 0), complex)
    lead = np.abs(loop.denominator).max() / np.abs(loop.numerator).max()
    gains = sign * np.unique(np.concatenate([[0.0], lead * DECADES, marks]))
    loop.refuse_infinite(gains)
    (sets, kinds), offset = nearly_connected(closed, closed.sets(gains)), lead * DECADES[0]
    finer = 1.5
    while sets.gains.size < MOST:
        size, stray = np.abs(sets.gains), _deviation(sets, axes)
        wide = size[1:] - size[:-1] > 1e-9 * (size[1:] + offset)
        bad = (stray > tolerance) & wide
        if loop.D:
            bad &= ~passes_infinity(loop, sets.gains[:-1], sets.gains[1:])
        at = np.flatnonzero(bad)
        if not at.size:
            break
        # The deviation falls with the square of the step.  A further round costs more than some gains.
        at = at[np.sort(stray[at].argsort()[::-1][: MOST - size.size])]
        pieces = np.clip(np.ceil(finer * np.sqrt(stray[at] / tolerance)), 2, 12).astype(int)
        if size.size + (pieces - 1).sum() > MOST:
            pieces[:] = 2
        finer *= 2
        sizes, which = _cut(size[at], size[at + 1], pieces, offset)
        more = between(closed, sets.at(at[which]), sets.at(at[which] + 1), sign * sizes)
        order = np.append(size, sizes).argsort(kind="stable")
        sets = RootSets(*(np.concatenate(parts)[order] for parts in zip(sets, more, strict=True)))
        sets, kinds = nearly_connected(closed, sets)
    return sets.gains, surely_connected(closed, sets, kinds).roots
