"""Crossings: where branches of a root locus pass the imaginary axis or, in discrete time, the unit circle."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.real_phase import Phase, real_frequencies
from rlswaim.rootlocus.repeated_roots import EPS

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


def crossings(loop: OpenLoop) -> tuple[Crossing, ...]:
    """Return where branches cross the imaginary axis, or the unit circle: 1 + k G = 0 with real k.

    A crossing has a root on either side of the border just before and just after its gain.
    So a pole on the border is no crossing: its branch leaves at the gain 0.  A pole or zero counts as
    on the border if rounding of the data could put it there.  Branches that touch the border or run
    along it do not cross it, nor do common factors of numerator and denominator.  A crossing is left
    out if rounding of the data moves its gain or its frequency by more than its size.

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
    found = []
    for omega, slope in _frequencies(border):
        crossing = _crossing(loop, border, omega, slope)
        if crossing is not None:
            found.append(crossing)
    return tuple(sorted(found))


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
    for i, j in zip(*np.nonzero(np.triu(near, 1)), strict=True):
        if w[i] * w[j] > 0:
            both = min(abs(w[i]), abs(w[j])) * np.sign(w[i])
            w[i], w[j] = w[i] - both, w[j] - both
    return x[w != 0], w[w != 0]


def _frequencies(border: _Border) -> list[tuple[float, float]]:
    """Return the frequencies from 0 up at which G is real, with the phase's slope there."""
    x, w = _without_mirrored(border)
    if x.size == 0:
        return []
    middle = float(np.exp(np.log(np.abs(x)).mean())) * 1.0123
    on_axis = float(border.weights[border.on_it].sum())
    low = Phase(x.real, x.imag, w, np.pi / 2 * (on_axis % 2))
    # With v = 1/omega a place x is one at -1/x, and turns the phase by a right angle more.
    inverse = -1 / x
    high = Phase(inverse.real, inverse.imag, w, np.pi / 2 * ((on_axis + w.sum()) % 2))
    found = real_frequencies(low, middle)
    beyond = 1 / real_frequencies(high, 1 / middle)
    beyond = beyond[beyond > middle * (1 + 1e-12)]
    omega = np.concatenate([[0.0], found, beyond])
    pairs = list(zip(omega.tolist(), low.slope(omega).tolist(), strict=True))
    if border.infinity:
        pairs.append((np.inf, -float(high.slope(np.zeros(1))[0])))
    return pairs


def _crossing(loop: OpenLoop, border: _Border, omega: float, slope: float) -> Crossing | None:
    """Return the crossing at a frequency on the border; None if there is none, or the data do not fix it."""
    angle = 2 * np.arctan(omega)
    point = np.exp(1j * angle) if loop.discrete else 1j * omega
    if angle == np.pi:
        point = -1.0 + 0j
    x, weights, errors = loop.places
    distance = point - x
    if (np.abs(distance) <= SURE * errors).any():
        return None
    gain = -np.exp(-(weights * np.log(distance)).sum()).real / loop.gain
    relative = (np.abs(weights / distance) * errors).sum()
    if not np.isfinite(gain) or relative + _moved(border, omega, slope) >= 1:
        return None
    return Crossing(
        float(gain), float(angle if loop.discrete else omega), int(-np.sign(gain) * np.sign(slope))
    )


def _moved(border: _Border, omega: float, slope: float) -> float:
    """Return the relative change of gain or frequency by rounding of the data; infinity if all is open."""
    x, weights, errors, *_ = border
    if omega == np.inf:  # the phase is known there, its slope by 1/omega is the sum of weights times Re x
        open_slope = (np.abs(weights) * (errors + ROUND * x.size * EPS * np.abs(x.real))).sum()
        return 0.0 if open_slope < abs(slope) else np.inf
    distance = 1j * omega - x
    inverse = np.abs(weights / distance)
    turned = (inverse * errors).sum()
    open_slope = (inverse * errors / np.abs(distance)).sum()
    open_slope += ROUND * x.size * EPS * np.abs((weights / distance).real).sum()
    if open_slope >= abs(slope):
        return np.inf
    step = turned / abs(slope)
    return float(max(step * np.abs((weights / distance).sum()), step / omega if omega else 0.0))
