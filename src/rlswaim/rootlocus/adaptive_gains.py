"""The gains of a picture: chosen so that drawn branches stay true to the curve within a part of a pixel."""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.branches import continuous_branches
from rlswaim.rootlocus.continuation import compiled, inserted, joined, moving, norms, polished, solve
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.polynomials import horner

SCREEN = (800, 600)
"""Size (pixels) of the picture for which gains are chosen."""
DECADES = np.logspace(-6, 7, 32)
"""First gains, times the size of D over that of N."""
MOST = 4000
"""No picture takes more gains than this."""

Axes: TypeAlias = tuple[float, float, float, float]


def default_axes(loop: OpenLoop) -> Axes:
    """Return left, right, bottom, top (1/s) of a picture that shows all poles and zeros with some room."""
    points = np.concatenate([loop.poles, loop.zeros, [0.0]])
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


def _deviation(loop: OpenLoop, gains: NDArray, values: NDArray, axes: Axes) -> NDArray:
    """Return how far (pixels) the curve strays from its chord between neighbors, worst branch in view.

    A cubic with slopes a, b against its chord strays at most 4/27 (|a| + |b|) times the chord.
    The tangent is ds/dk = -N/p'; at a double root, where p' = 0, the slope of the other end serves.
    """
    scale = SCREEN[0] / (axes[1] - axes[0]), SCREEN[1] / (axes[3] - axes[2])
    polynomials, sizes = loop.polynomials(gains)
    _, slope, terms = horner(polynomials, values.T, sizes)
    known = (np.abs(slope * values.T) > 1e-6 * terms).T
    with np.errstate(divide="ignore", invalid="ignore"):
        tangent = -np.sign(gains[-1]) * horner(loop.numerator, values)[0] / slope.T
    tangent = scale[0] * tangent.real + 1j * scale[1] * tangent.imag
    chord = np.diff(values, axis=0)
    chord = scale[0] * chord.real + 1j * scale[1] * chord.imag
    turned = [t * chord.conj() for t in (tangent[:-1], tangent[1:])]
    with np.errstate(divide="ignore", invalid="ignore"):
        steep = [np.where(t.real > 0, np.minimum(np.abs(t.imag) / t.real, 10), 10) for t in turned]
    left = np.where(known[:-1], steep[0], steep[1])
    right = np.where(known[1:], steep[1], steep[0])
    seen = _in_view(values[:-1], axes) | _in_view(values[1:], axes)
    stray = 4 / 27 * (left + right) * np.abs(chord)
    return np.where(seen & (known[:-1] | known[1:]), stray, 0.0).max(axis=1, initial=0.0)


def _cut(low: NDArray, high: NDArray, pieces: NDArray, offset: float) -> NDArray:
    """Return the inner points of intervals of gains, each cut evenly in ln(k + offset)."""
    which = np.repeat(np.arange(low.size), pieces - 1)
    number = np.arange(which.size) - np.repeat(np.cumsum(pieces - 1) - (pieces - 1), pieces - 1) + 1
    a, b = low[which] + offset, high[which] + offset
    return a * (b / a) ** (number / pieces[which]) - offset


def picture(
    loop: OpenLoop, marks: NDArray, axes: Axes, tolerance: float, sign: int
) -> tuple[NDArray, NDArray]:
    """Return gains of one ``sign``, ``marks`` among them, and branches true to the curve on ``axes``.

    The ``tolerance`` is in pixels, on a picture of 800 by 600.
    """
    if not loop.numerator.any():  # nothing moves
        gains = np.array([0.0, sign])
        return gains, solve(loop, gains)
    lead = np.abs(loop.denominator).max() / max(np.abs(loop.numerator).max(), 1e-300)
    first = np.unique(np.concatenate([[0.0], lead * DECADES, marks]))
    loop.refuse_infinite(sign * first)
    parts = loop, first, axes, tolerance, sign, lead * DECADES[0]
    gains, values = _compiled(*parts) or _refined(*parts)
    return sign * gains, values


def _compiled(
    loop: OpenLoop, first: NDArray, axes: Axes, tolerance: float, sign: int, offset: float
) -> tuple[NDArray, NDArray] | None:
    """Return what `_refined` does, compiled; None where that can't be, or is not to be trusted."""
    module = compiled(loop)
    if module is None:
        return None
    (N, D), lost = moving(loop), -sign / loop.D if loop.D else np.nan
    scale = SCREEN[0] / (axes[1] - axes[0]), SCREEN[1] / (axes[3] - axes[2])
    view = np.array([*axes, *scale, tolerance, lost])
    falling = np.array(first[::-1])
    states, trusted = module.picture(sign * N, D, falling, norms(loop), view, offset, MOST)
    values = joined(loop, states, trusted, sign)
    return None if values is None else (states[:, 4, 0], values)


def _refined(
    loop: OpenLoop, first: NDArray, axes: Axes, tolerance: float, sign: int, offset: float
) -> tuple[NDArray, NDArray]:
    """Return gains >= 0, the first ones among them, and branches true to the curve within the tolerance."""
    start = polished(loop, sign * first, loop.eigenvalues(sign * first))
    gains, values = first, continuous_branches(start)
    while gains.size < MOST:
        stray = _deviation(loop, sign * gains, values, axes)
        bad = (
            (stray > tolerance) & ~_through_infinity(loop, sign * gains) & (np.diff(gains) > 1e-9 * gains[1:])
        )
        if not bad.any():
            break
        # The deviation falls with the square of the step.
        pieces = np.clip(np.ceil(1.25 * np.sqrt(stray[bad] / tolerance)), 2, 12).astype(int)
        gains, values = _merged(
            loop, sign, gains, values, _cut(gains[:-1][bad], gains[1:][bad], pieces, offset)
        )
    return gains, values


def _through_infinity(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return in which intervals of gains a root passes through infinity: k = -1/D lies there."""
    side = np.sign(1 + gains * loop.D)
    return side[:-1] != side[1:]


def _merged(
    loop: OpenLoop, sign: int, gains: NDArray, values: NDArray, more: NDArray
) -> tuple[NDArray, NDArray]:
    """Return gains >= 0 and branches with those of some more gains."""
    if sign > 0:
        found = inserted(loop, gains, values, more)
    else:
        found = inserted(loop, -gains[::-1], values[::-1], -more)
    order = np.argsort(np.concatenate([gains, more]), kind="stable")
    branches = continuous_branches(np.concatenate([values, found])[order])
    return np.concatenate([gains, more])[order], branches
