"""Root loci: where the closed-loop roots go as a gain, or any other parameter, runs.

Convention: unity negative feedback, 1 + k G(s) = 0, with k of either sign.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import linear_sum_assignment

from rlswaim import checks
from rlswaim.polynomials import characteristic_polynomial, roots, trimmed

SCREEN = (800, 600)
"""Size (pixels) of the picture for which gains are chosen."""


class Crossing(NamedTuple):
    """A crossing of the imaginary axis at s = j omega (rad/s); direction +1 is to the right."""

    gain: float
    omega: float
    direction: int


class BreakAway(NamedTuple):
    """A point where branches meet: a double root at ``point`` (1/s) for ``gain``."""

    gain: float
    point: complex


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


@dataclass(frozen=True, eq=False)
class OpenLoop:
    """A single loop as state space and as ratio of polynomials, constant term first."""

    A: NDArray
    B: NDArray
    C: NDArray
    D: float
    numerator: NDArray
    denominator: NDArray

    def roots(self, gains: NDArray) -> NDArray:
        """Return the closed-loop roots (K, n) for gains (K,), unordered."""
        feedback = gains / (1 + gains * self.D)
        return np.linalg.eigvals(self.A - feedback[:, None, None] * (self.B @ self.C)).astype(complex)


def open_loop(system: control.StateSpace | control.TransferFunction | Sequence[ArrayLike]) -> OpenLoop:
    """Return the loop of a python-control LTI system, or of arrays (A, B, C).

    Raises
    ------
    TypeError
        If the system is no LTI system.
    ValueError
        If it has more than one input or output, or is improper, discrete or not finite.
    """
    if isinstance(system, (tuple, list)):
        system = control.ss(*system, np.zeros((1, 1)))
    if not isinstance(system, (control.StateSpace, control.TransferFunction)):
        raise TypeError(f"root_locus: got {type(system).__name__}, wanted a StateSpace or TransferFunction")
    if (system.ninputs, system.noutputs) != (1, 1):
        raise ValueError(
            f"root_locus: got {system.ninputs} inputs and {system.noutputs} outputs, wanted one of each"
        )
    if system.dt not in (0, None):
        raise ValueError(f"root_locus: got a discrete system with dt = {system.dt}, wanted continuous time")
    return (
        _from_transfer(system) if isinstance(system, control.TransferFunction) else _from_state_space(system)
    )


def _from_transfer(system: control.TransferFunction) -> OpenLoop:
    numerator = trimmed(checks.frozen_array("numerator", system.num[0][0][::-1], "root_locus"))
    denominator = trimmed(checks.frozen_array("denominator", system.den[0][0][::-1], "root_locus"))
    n = denominator.size - 1
    if numerator.size > n + 1:
        raise ValueError(
            f"root_locus: got a numerator of order {numerator.size - 1} over {n}, wanted a proper system"
        )
    numerator, denominator = numerator / denominator[-1], denominator / denominator[-1]
    D = float(numerator[n]) if numerator.size == n + 1 else 0.0
    rest = np.zeros(n)
    rest[: min(n, numerator.size)] = numerator[:n]
    rest -= D * denominator[:n]
    A = np.eye(n, k=1)
    if n:
        A[-1] = -denominator[:n]
    B = np.zeros((n, 1))
    B[n - 1 :] = 1.0
    return OpenLoop(A, B, rest[None, :], D, numerator, denominator)


def _from_state_space(system: control.StateSpace) -> OpenLoop:
    A, B, C = (checks.frozen_array(name, getattr(system, name), "root_locus") for name in "ABC")
    D = checks.real("D", float(system.D[0, 0]), "root_locus")
    denominator = characteristic_polynomial(A)
    numerator = characteristic_polynomial(A - B @ C) + (D - 1) * denominator
    return OpenLoop(A, B, C, D, trimmed(numerator), denominator)


def _conjugate_symmetric(values: NDArray) -> NDArray:
    """Return roots with real ones exactly real: LAPACK gives exact pairs for real matrices."""
    return np.where(np.abs(values.imag) <= 1e-14 * np.abs(values), values.real + 0j, values)


def continuous_branches(values: NDArray) -> NDArray:
    """Return root sets (K, n) re-ordered so that each column is a continuous branch.

    Neighbouring sets are paired by the assignment of least total distance.
    Where each root has a nearest successor of its own, that pairing is the
    assignment, and no optimization is needed.
    """
    if values.shape[0] < 2 or values.shape[1] < 2:
        return values
    distance = np.abs(values[:-1, :, None] - values[1:, None, :])
    successor = distance.argmin(axis=2)
    clear = (np.sort(successor, axis=1) == np.arange(values.shape[1])).all(axis=1)
    for i in np.flatnonzero(~clear):
        successor[i] = linear_sum_assignment(distance[i])[1]
    order = np.empty(values.shape, dtype=int)
    order[0] = np.arange(values.shape[1])
    for i, step in enumerate(successor):
        order[i + 1] = step[order[i]]
    return np.take_along_axis(values, order, axis=1)


def _break_aways(loop: OpenLoop) -> tuple[BreakAway, ...]:
    """Return the double roots for real gains: N D' - D N' = 0, k = -D/N."""
    N, D = loop.numerator, loop.denominator
    points = roots(npp.polysub(npp.polymul(N, npp.polyder(D)), npp.polymul(D, npp.polyder(N))))
    with np.errstate(divide="ignore", invalid="ignore"):
        gains = -npp.polyval(points, D) / npp.polyval(points, N)
    real = np.isfinite(gains) & (np.abs(gains.imag) <= 1e-7 * np.abs(gains)) & (points.imag >= 0)
    return tuple(BreakAway(float(k.real), complex(p)) for k, p in zip(gains[real], points[real], strict=True))


def _crossing_frequencies(N: NDArray, D: NDArray) -> NDArray:
    """Return the frequencies w >= 0 (rad/s) where D/N is real: Im D(jw) conj N(jw) = w p(w^2) = 0."""
    turn = 1j ** np.arange(D.size)
    odd = npp.polymul(N * turn[: N.size], (D * turn).conj()).imag[1::2]
    squares = roots(odd) if np.any(odd) else np.zeros(0, complex)
    real = (np.abs(squares.imag) <= 1e-9 * np.abs(squares)) & (squares.real >= 0)
    return np.union1d(np.sqrt(squares[real].real), [0.0])


def _crossings(loop: OpenLoop) -> tuple[Crossing, ...]:
    """Return the crossings of the imaginary axis: 1 + k G(jw) = 0 with real k."""
    N, D = loop.numerator, loop.denominator
    found = []
    for omega in _crossing_frequencies(N, D):
        s = 1j * omega
        n_at, d_at = npp.polyval(s, N), npp.polyval(s, D)
        if abs(n_at) == 0 or abs(d_at) == 0:
            continue
        k = float((-d_at / n_at).real)
        slope = npp.polyval(s, npp.polyadd(npp.polyder(D), k * npp.polyder(N)))
        if slope != 0:
            found.append(Crossing(k, float(omega), int(np.sign((-n_at / slope).real))))
    return tuple(sorted(found))


def _window(poles: NDArray, zeros: NDArray) -> tuple[float, float]:
    """Return the width and height (1/s) of a picture that shows all poles and zeros with some room."""
    points = np.concatenate([poles, zeros])
    spread = [np.ptp(points.real), 2 * np.abs(points.imag).max(initial=0.0)] if points.size else [0.0, 0.0]
    size = max(max(spread), 1e-3)
    return 1.6 * max(spread[0], size / 4), 1.6 * max(spread[1], size / 4)


def _chord_error(left: NDArray, middle: NDArray, right: NDArray, window: tuple[float, float]) -> NDArray:
    """Return how far (pixels) the middle roots lie off the chord between their neighbours, worst branch."""
    scale = np.array([SCREEN[0] / window[0], SCREEN[1] / window[1]])
    a, m, b = (np.stack([z.real, z.imag], axis=-1) * scale for z in (left, middle, right))
    chord, offset = b - a, m - a
    length2 = np.maximum((chord**2).sum(-1), 1e-300)
    along = np.clip((chord * offset).sum(-1) / length2, 0, 1)
    miss = np.linalg.norm(offset - along[..., None] * chord, axis=-1)
    visible = (np.abs(m) < 2 * np.array(SCREEN)).all(-1)
    return np.where(visible, miss, 0.0).max(axis=1, initial=0.0)


def _chosen_gains(loop: OpenLoop, marks: NDArray, window: tuple[float, float], tolerance: float) -> NDArray:
    """Return positive gains for which the drawn polyline is within ``tolerance`` pixels of the curve."""
    scale = np.abs(loop.denominator).max() / np.abs(loop.numerator).max()
    gains = np.concatenate([[0.0], scale * np.logspace(-5, 6, 45), marks])
    gains = np.unique(gains)
    for _ in range(14):
        middle = np.where(gains[:-1] > 0, np.sqrt(gains[:-1] * gains[1:]), gains[1:] / 2)
        both = np.sort(np.concatenate([gains, middle]))
        r = continuous_branches(loop.roots(both))
        coarse = _chord_error(r[:-2:2], r[1::2], r[2::2], window) > tolerance
        if not coarse.any():
            return both
        gains = np.sort(np.concatenate([gains, middle[coarse]]))
    return gains


def root_locus(
    system: control.StateSpace | control.TransferFunction | Sequence[ArrayLike],
    gains: ArrayLike | None = None,
    tolerance: float = 0.25,
) -> RootLocus:
    """Return the root locus of 1 + k G(s) = 0.

    Parameters
    ----------
    system : StateSpace, TransferFunction or (A, B, C)
        The open loop G, single input and output, continuous and proper.
    gains : array_like, shape (K,), optional
        Gains of either sign, in the order wanted.  Without them positive gains are
        chosen so that the polyline of each branch stays within ``tolerance`` of
        the true curve; break-away points and axis crossings are among them.
    tolerance : float
        Largest error (pixels, on a picture of 800 by 600 that shows all poles and zeros).

    Returns
    -------
    RootLocus

    Raises
    ------
    TypeError
        If the system is no LTI system, or the gains are no real numbers.
    ValueError
        If the system is not single-input, single-output, continuous and proper, or a number is not finite.
    """
    loop = open_loop(system)
    poles, zeros = roots(loop.denominator), roots(loop.numerator)
    breaks, crossings = _break_aways(loop), _crossings(loop)
    if gains is None:
        marks = np.array([k for k in (*(b.gain for b in breaks), *(c.gain for c in crossings)) if k > 0])
        chosen = _chosen_gains(loop, marks, _window(poles, zeros), checks.positive("tolerance", tolerance))
    else:
        chosen = checks.frozen_array("gains", np.atleast_1d(gains), "root_locus")
        if chosen.ndim != 1:
            raise ValueError(f"gains in root_locus: got shape {chosen.shape}, wanted one dimension")
    branches = continuous_branches(_conjugate_symmetric(loop.roots(chosen)))
    return RootLocus(chosen, branches, poles, zeros, breaks, crossings)


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
    run = checks.frozen_array("values", np.atleast_1d(values), "parameter_locus")
    sets = [np.asarray(closed_loop(float(value)).poles(), dtype=complex) for value in run]
    for at, found in enumerate(sets):
        if found.size != sets[0].size:
            raise ValueError(
                f"parameter_locus: got {found.size} poles at values[{at}] = {run[at]:g}, "
                f"wanted {sets[0].size} as at {run[0]:g}"
            )
    nothing = np.zeros(0, complex)
    return RootLocus(run, continuous_branches(np.array(sets)), nothing, nothing)
