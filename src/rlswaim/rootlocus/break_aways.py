"""Break-aways: the points where branches of a root locus meet."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS, aberth, real_and_conjugate
from rlswaim.rootlocus.open_loop import OpenLoop, Places
from rlswaim.rootlocus.repeated_roots import linked

ROUND = 64
"""Rounding of a sum or product of P terms counts as so many times P EPS at most."""


class BreakAway(NamedTuple):
    """A point where branches meet: a repeated root at ``point`` (1/s) for ``gain``."""

    gain: float
    point: complex


def break_aways(loop: OpenLoop) -> tuple[BreakAway, ...]:
    """Return the repeated roots for real gains: G' = 0, k = -1/G.

    At a repeated root the logarithmic derivative of G, sum w_i/(s - x_i) over its poles and
    zeros x_i with their counts w_i, vanishes.  A repeated open-loop pole is one too, at the gain 0.
    Common factors of numerator and denominator stand still and meet nothing.  A point is left out
    if rounding of the data moves its gain by more than its size.

    Parameters
    ----------
    loop : OpenLoop

    Returns
    -------
    tuple of BreakAway
        By rising gain; of a conjugate pair the upper point alone.
    """
    places = loop.places
    if not loop.gain or places.points.size == 0:
        return ()
    repeated = places.points[(places.weights < -1) & (places.points.imag >= 0)]
    found = [BreakAway(0.0, point) for point in repeated.tolist()]
    points = _stationary(places)
    points = points[points.imag >= 0]
    gains, fixed = _gains(loop, points)
    found += [BreakAway(*b) for b in zip(gains[fixed].tolist(), points[fixed].tolist(), strict=True)]
    return tuple(sorted(found, key=lambda b: (b.gain, b.point.real, b.point.imag)))


def _gains(loop: OpenLoop, at: NDArray) -> tuple[NDArray, NDArray]:
    """Return the gains -1/G at points (M,) where G' = 0, and which of them are real and fixed by the data."""
    points, weights, errors = (part[:, None] for part in loop.places)
    distance = at - points
    with np.errstate(all="ignore"):
        sizes = np.abs(weights / distance)
        relative = (errors * sizes).sum(axis=0)
        # The gain is stationary here: an error of the point counts with its square.
        slope_error = (errors * np.abs(sizes / distance)).sum(axis=0) + points.size * EPS * sizes.sum(axis=0)
        relative += slope_error**2 / np.abs((weights / distance**2).sum(axis=0))
        gains = -np.exp(-(weights * np.log(distance)).sum(axis=0)) / loop.gain
        limit = ROUND * points.size * EPS + np.minimum(4 * relative, 1e-6)
        real = np.abs(gains.imag) <= limit * np.abs(gains)
    return gains.real, real & (relative < 1) & np.isfinite(gains)


def _stationary(places: Places) -> NDArray:
    """Return the zeros of sum w_i/(s - x_i), exact pairs and real ones, a repeated one once."""
    sizes = np.abs(places.points[places.points != 0])
    size = float(np.exp(np.log(sizes).mean())) if sizes.size else 1.0
    x, w = places.points / size, places.weights.astype(float)
    guess = _approximate(x, w)
    if guess.size == 0:
        return guess

    def terms(s: NDArray) -> tuple[NDArray, NDArray]:
        distance = s - x[:, None]
        return distance, w[:, None] / distance

    def slopes(s: NDArray, _: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        distance, term = terms(s[:, 0])
        value, inverse = term.sum(axis=0), 1 / distance
        slope = inverse.sum(axis=0) - (term * inverse).sum(axis=0) / value
        done = np.abs(value) <= x.size * EPS * np.abs(term).sum(axis=0)
        done |= np.abs(slope * s[:, 0]) >= 1 / EPS
        return slope[:, None], done[:, None], np.ones((s.size, 1), bool)

    found = real_and_conjugate(aberth(slopes, guess[:, None], steps=40).values[:, 0])
    for group in linked(found, 1e-4 * np.abs(found)):
        center = found[group].mean()
        with np.errstate(all="ignore"):  # the center may be a place
            distance, term = terms(np.array([center]))
            error = np.abs(term.sum()), np.abs((term / distance).sum()) * np.abs(found[group] - center).max()
        if max(error) <= ROUND * x.size * EPS * np.abs(term).sum():
            found[group] = center
    return size * np.unique(found)


def _approximate(x: NDArray, w: NDArray) -> NDArray:
    """Return the zeros of sum w_i/(s - x_i) as eigenvalues, where x are points and w their counts.

    With M the first of the moments sum w_i x_i^r that is not 0, they are the eigenvalues of
    diag(x) - 1 v^T / M with v_i = w_i x_i^(r + 1), without r + 1 that are 0.
    """
    for r in range(x.size - 1):
        powers = w * x**r
        moment = powers.sum().real
        if abs(moment) > ROUND * x.size * EPS * np.abs(powers).sum():
            matrix = np.diag(x) - (powers * x)[None] / moment
            found = np.linalg.eigvals(matrix)
            return found[np.abs(found).argsort()[r + 1 :]]
    return np.zeros(0, complex)
