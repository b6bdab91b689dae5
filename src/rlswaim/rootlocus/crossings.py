"""Crossings: where branches of a root locus pass the imaginary axis or, in discrete time, the unit circle."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.real_phase import Phases, real_frequencies

SURE = 8.0
"""A pole or zero is on the border if it is nearer than so many times its error."""
ROUND = 64
"""Rounding of a sum of P terms counts as so many times P EPS at most."""


class Crossing(NamedTuple):
    """A crossing of the border of stability; direction +1 is out of the stable side.

    ``omega`` is the frequency (rad/s) of the crossing at s = j omega; of a discrete loop it is
    the angle (rad) of the crossing at z = exp(j omega), from 0 to pi.
    """

    gain: float
    omega: float
    direction: int


@lru_cache(maxsize=8)
def crossings(loop: OpenLoop) -> tuple[Crossing, ...]:
    """Return where branches cross the imaginary axis, or the unit circle: 1 + k G = 0 with real k.

    A crossing has a root on either side of the border just before and just after its gain.
    So a pole on the border is no crossing: its branch leaves at the gain 0.  A pole or zero counts as
    on the border if rounding of the data could put it there.  Branches that touch the border or run
    along it do not cross it, nor do common factors of numerator and denominator.  A crossing is left
    out if rounding of the data moves its gain or its frequency by more than its size.
    The last few loops' are kept: a picture needs them, and its reader asks for them again.

    Parameters
    ----------
    loop : OpenLoop

    Returns
    -------
    tuple of Crossing
        By rising gain; of a conjugate pair the upper point alone.
    """
    places = loop.places
    if not loop.gain or places.points.size == 0:
        return ()
    border = _on_axis(loop)
    return tuple(sorted(_at(loop, border, *_frequencies(border))))


class _Border(NamedTuple):
    """Places as seen from the border, mapped to the imaginary axis, and whether infinity is a point of it."""

    points: NDArray
    weights: NDArray
    errors: NDArray
    on_it: NDArray
    infinity: bool


def _on_axis(loop: OpenLoop) -> _Border:
    """Return the places of a loop; of a discrete one mapped by w = (z - 1)/(z + 1)."""
    x, weights, errors = loop.places
    if not loop.discrete:
        return _Border(x, weights, errors, np.abs(x.real) <= SURE * errors, False)
    on_it = np.abs(np.abs(x) - 1) <= SURE * errors
    at_end = np.abs(x + 1) <= SURE * errors
    x, w, e, on = (part[~at_end] for part in (x, weights, errors, on_it))
    size = np.abs(x + 1) ** 2
    mapped = (np.abs(x) ** 2 - 1) / size + 2j * x.imag / size
    # A zero at z = infinity for each pole more than zeros is one at w = 1.
    excess = -weights.sum()
    if excess:
        mapped, w = np.append(mapped, 1.0), np.append(w, excess)
        e, on = np.append(2 * e / size, 0.0), np.append(on, False)
    else:
        e = 2 * e / size
    return _Border(mapped, w, e, on, not at_end.any())


def _without_mirrored(border: _Border) -> tuple[NDArray, NDArray]:
    """Return places off the axis and their weights, without pairs x, -conj(x): their phases cancel."""
    x, errors = border.points[~border.on_it], border.errors[~border.on_it]
    w = border.weights[~border.on_it].astype(float)
    near = np.abs(x[:, None] + x.conj()) <= SURE * (errors[:, None] + errors)
    for i, j in np.argwhere(near):
        if i < j and w[i] * w[j] > 0:
            both = min(abs(w[i]), abs(w[j])) * np.sign(w[i])
            w[i], w[j] = w[i] - both, w[j] - both
    return x[w != 0], w[w != 0]


def _frequencies(border: _Border) -> tuple[NDArray, NDArray]:
    """Return the frequencies (M,) from 0 up at which G is real, and the phase's slope (M,) there."""
    x, w = _without_mirrored(border)
    if x.size == 0:
        return np.zeros(0), np.zeros(0)
    middle = float(np.exp(np.log(np.abs(x)).mean())) * 1.0123
    on_axis = float(border.weights[border.on_it].sum())
    # With v = 1/omega a place x is one at -1/x, and turns the phase by a right angle more.
    both, turns = np.stack([x, -1 / x], axis=1), np.array([on_axis, on_axis + w.sum()])
    phases = Phases(both.real, both.imag, w[:, None], np.pi / 2 * (turns % 2))
    found, beyond = real_frequencies(phases, np.array([middle, 1 / middle]))
    beyond = 1 / beyond
    omega = np.concatenate([[0.0], found, beyond[beyond > middle * (1 + 1e-12)]])
    slope = phases.at(np.zeros(omega.size, int)).slope(omega)
    if border.infinity:
        omega = np.append(omega, np.inf)
        slope = np.append(slope, -phases.slope(np.zeros(2))[1])
    return omega, slope


def _at(loop: OpenLoop, border: _Border, omega: NDArray, slope: NDArray) -> list[Crossing]:
    """Return the crossings at frequencies on the border, if there are some and the data fix them.

    Parameters
    ----------
    loop : OpenLoop
    border : _Border
    omega, slope : ndarray, shape (M,)
        As from `_frequencies`.

    Returns
    -------
    list of Crossing
    """
    angle = 2 * np.arctan(omega)
    point = np.where(angle == np.pi, -1, np.exp(1j * angle)) if loop.discrete else 1j * omega
    x, weights, errors = (part[:, None] for part in loop.places)
    distance = point - x
    with np.errstate(all="ignore"):
        gain = -np.exp(-(weights * np.log(distance)).sum(axis=0)).real / loop.gain
        relative = (np.abs(weights / distance) * errors).sum(axis=0) + _moved(border, omega, slope)
    fixed = np.isfinite(gain) & (relative < 1) & (np.abs(distance) > SURE * errors).all(axis=0)
    direction = (-np.sign(gain) * np.sign(slope))[fixed].astype(int)
    where = (angle if loop.discrete else omega)[fixed]
    return [Crossing(*c) for c in zip(gain[fixed].tolist(), where.tolist(), direction.tolist(), strict=True)]


def _moved(border: _Border, omega: NDArray, slope: NDArray) -> NDArray:
    """Return the relative change of gain or frequency by rounding of the data; infinity if all is open.

    Parameters
    ----------
    border : _Border
    omega, slope : ndarray, shape (M,)

    Returns
    -------
    ndarray, shape (M,)
    """
    x, weights, errors = (part[:, None] for part in border[:3])
    rounding = ROUND * x.size * EPS
    distance = 1j * omega - x
    toward = weights / distance
    inverse = np.abs(toward)
    open_slope = (inverse * errors / np.abs(distance)).sum(axis=0)
    open_slope += rounding * np.abs(toward.real).sum(axis=0)
    step = ((inverse * errors).sum(axis=0) + x.size * EPS) / np.abs(slope)  # the phase is rounded as well
    moved = step * np.maximum(np.abs(toward.sum(axis=0)), np.where(omega > 0, 1 / omega, 0))
    # At infinity the phase is known, and its slope by 1/omega is the sum of weights times Re x.
    beyond = (np.abs(weights) * (errors + rounding * np.abs(x.real))).sum()
    open_slope, moved = np.where(omega == np.inf, [[beyond], [0]], [open_slope, moved])
    return np.where(open_slope < np.abs(slope), moved, np.inf)
