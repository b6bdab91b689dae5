"""The open loop of a root locus: zeros, poles and gain, whatever form it was given in."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.signal import ZerosPolesGain

from rlswaim.rootlocus.aberth import EPS, real_and_conjugate
from rlswaim.rootlocus.common_factors import agreeing, common_factors
from rlswaim.rootlocus.polynomials import trimmed
from rlswaim.rootlocus.repeated_roots import Points, points_of_polynomial
from rlswaim.rootlocus.state_space import transfer_of_state_space
from rlswaim.source import checks

System: TypeAlias = control.StateSpace | control.TransferFunction | ZerosPolesGain | Sequence[ArrayLike]
WHERE = "root_locus"
SMALLEST = 1e-100
"""The gain of a loop is of this size at least, and of its inverse at most."""


class Places(NamedTuple):
    """Distinct poles and zeros (P,), their counts (zeros +, poles -), and how far rounding moves each."""

    points: NDArray
    weights: NDArray
    errors: NDArray


@dataclass(frozen=True, eq=False)
class OpenLoop:
    """A single loop G = gain prod(s - zeros) / prod(s - poles).

    ``dt`` is python-control's: 0 or None for continuous time, otherwise the sampling period (s) or True.
    ``shared`` are the numbers of the zeros, and of the poles, that are the same points; without it those
    are that differ by no more than their errors.
    """

    zero_points: Points
    pole_points: Points
    gain: float
    numerator: NDArray
    denominator: NDArray
    dt: float | bool | None = 0
    shared: tuple[NDArray, NDArray] | None = None

    @property
    def poles(self) -> NDArray:
        """Open-loop poles (1/s; in discrete time without unit)."""
        return self.pole_points.values

    @property
    def zeros(self) -> NDArray:
        """Open-loop zeros (1/s; in discrete time without unit)."""
        return self.zero_points.values

    @property
    def discrete(self) -> bool:
        """Whether the roots are in z, stable within the unit circle."""
        return bool(self.dt)

    @property
    def D(self) -> float:
        """The gain at infinite frequency: 0 for a strictly proper loop."""
        return self.gain if self.zeros.size == self.poles.size else 0.0

    @cached_property
    def common(self) -> tuple[NDArray, NDArray]:
        """Which poles (n,) and which zeros (m,) are factors of both, but for rounding."""
        found, at = self.shared or common_factors(self.zero_points, self.pole_points)
        gone_poles, gone = np.zeros(self.poles.size, bool), np.zeros(self.zeros.size, bool)
        gone_poles[at] = gone[found] = True
        return gone_poles, gone

    @cached_property
    def resting(self) -> NDArray:
        """The closed-loop roots that stand still at every gain: common factors, or all if the gain is 0."""
        return self.poles[self.common[0]] if self.gain else self.poles

    @cached_property
    def moving_poles(self) -> NDArray:
        """The poles that the moving branches leave from, repeated ones repeated."""
        return self.poles[~self.common[0]] if self.gain else np.zeros(0, complex)

    @cached_property
    def places(self) -> Places:
        """The distinct poles, then the distinct zeros, without common factors."""
        found, (common_poles, common_zeros) = [], self.common
        for kind, points, common in (-1, self.pole_points, common_poles), (1, self.zero_points, common_zeros):
            values, errors = (part[~common] for part in points)
            distinct, first, counts = np.unique(values, return_index=True, return_counts=True)
            found.append((distinct, kind * counts, errors[first]))
        return Places(*(np.concatenate(part) for part in zip(*found, strict=True)))

    def polynomials(self, gains: NDArray) -> tuple[NDArray, NDArray]:
        """Return D + k N for ``gains`` k (K,), and |D| + |k N|: each (n + 1, K), constant term first."""
        N = np.zeros(self.denominator.size)
        N[: self.numerator.size] = self.numerator
        D, kN = self.denominator[:, None], np.multiply.outer(N, gains)
        return D + kN, np.abs(D) + np.abs(kN)

    def refuse_infinite(self, gains: NDArray) -> None:
        """Raise a ValueError if one of the ``gains`` sends a root to infinity, or beyond what floats hold."""
        if (np.abs(1 + gains * self.D) <= EPS).any():
            raise ValueError(
                f"{WHERE}: got the gain {-1 / self.D:g} = -1/D, at which a root is at infinity; "
                "wanted another gain"
            )
        most = 1e100 / max(abs(self.gain), 1e-100)
        if (np.abs(gains) > most).any():
            at = int(np.flatnonzero(np.abs(gains) > most)[0])
            raise ValueError(f"gains[{at}] in {WHERE}: got {gains[at]:g}, wanted at most {most:.3g} in size")


def open_loop(system: System) -> OpenLoop:
    """Return the loop of an LTI system, of arrays (A, B, C), or of factors (zeros, poles, gain).

    Parameters
    ----------
    system : StateSpace, TransferFunction, ZerosPolesGain, (A, B, C) or (zeros, poles, gain)

    Returns
    -------
    OpenLoop

    Raises
    ------
    TypeError
        If the system is no LTI system, or not real.
    ValueError
        If it has more than one input or output, no poles, a zero numerator, or is improper or not finite.
    """
    loop = _loop(system)
    if loop.gain and not SMALLEST <= abs(loop.gain) <= 1 / SMALLEST:
        raise ValueError(
            f"gain in {WHERE}: got {loop.gain:g} for large s, "
            f"wanted a size from {SMALLEST:g} to {1 / SMALLEST:g}"
        )
    return loop


def _loop(system: System) -> OpenLoop:
    """Return the loop of a ``system``; raise errors as `open_loop` says."""
    if isinstance(system, ZerosPolesGain):
        return _from_factors(system.zeros, system.poles, system.gain, system.dt or 0)
    if isinstance(system, (tuple, list)):
        if [_dimensions(part) for part in system] == [1, 1, 0]:
            zeros, poles, gain = system
            return _from_factors(zeros, poles, gain, 0)
        system = _from_arrays(system)
    if not isinstance(system, (control.StateSpace, control.TransferFunction)):
        raise TypeError(
            f"{WHERE}: got {type(system).__name__}, wanted a StateSpace, a TransferFunction, "
            "a ZerosPolesGain, arrays (A, B, C) or factors (zeros, poles, gain)"
        )
    if (system.ninputs, system.noutputs) != (1, 1):
        raise ValueError(
            f"{WHERE}: got {system.ninputs} inputs and {system.noutputs} outputs, wanted one of each"
        )
    if isinstance(system, control.TransferFunction):
        return _from_transfer(system)
    return _from_state_space(system)


def _dimensions(part: ArrayLike) -> int:
    """Return how many dimensions an array has, -1 if it is ``part`` of none: rows of unequal lengths."""
    try:
        return np.ndim(part)
    except ValueError:
        return -1


def _from_arrays(arrays: Sequence[ArrayLike]) -> control.StateSpace:
    """Return ``arrays`` (A, B, C) as a state space without feed-through."""
    if len(arrays) != 3:
        raise ValueError(f"{WHERE}: got {len(arrays)} arrays, wanted three: (A, B, C)")
    A, B, C = (checks.frozen_array(name, value, WHERE) for name, value in zip("ABC", arrays, strict=True))
    n = A.shape[0] if A.ndim else 0
    for name, array, shape in (("A", A, (n, n)), ("B", B, (n, 1)), ("C", C, (1, n))):
        if array.shape != shape:
            raise ValueError(f"{name} in {WHERE}: got shape {array.shape}, wanted {shape}")
    return control.ss(A, B, C, 0.0)


def _refuse_order(zeros: int, poles: int) -> None:
    """Raise a ValueError if a loop with so many ``zeros`` and ``poles`` has none of these, or more zeros."""
    if poles == 0:
        raise ValueError(f"{WHERE}: got a system without poles, wanted at least one")
    if zeros > poles:
        raise ValueError(
            f"{WHERE}: got a numerator of order {zeros} over one of order {poles}, wanted a proper system; "
            "the roots of 1 + k G = 0 are those of 1 + (1/k) (1/G) = 0: give 1/G, and 1/k for the gain"
        )


def _from_transfer(system: control.TransferFunction) -> OpenLoop:
    numerator = trimmed(checks.frozen_array("numerator", system.num[0][0][::-1], WHERE))
    denominator = trimmed(checks.frozen_array("denominator", system.den[0][0][::-1], WHERE))
    if not numerator.any():
        raise ValueError(f"numerator in {WHERE}: got 0, wanted a transfer function that is not zero")
    _refuse_order(numerator.size - 1, denominator.size - 1)
    with np.errstate(over="ignore"):
        numerator, denominator = numerator / denominator[-1], denominator / denominator[-1]
    if not np.isfinite(numerator).all() or not np.isfinite(denominator).all():
        raise ValueError(
            f"denominator in {WHERE}: got a leading coefficient too small beside the others, "
            "wanted ratios that floats hold"
        )
    zeros, poles = points_of_polynomial(numerator), points_of_polynomial(denominator)
    zeros, poles, shared = agreeing(zeros, poles, (numerator, denominator))
    return OpenLoop(zeros, poles, float(numerator[-1]), numerator, denominator, system.dt, shared)


def _from_state_space(system: control.StateSpace) -> OpenLoop:
    A, B, C, D = (checks.frozen_array(name, getattr(system, name), WHERE) for name in "ABCD")
    if not A.size:
        raise ValueError(f"{WHERE}: got a system without poles, wanted at least one")
    return OpenLoop(*transfer_of_state_space(A, B, C, D), system.dt)


def _from_factors(zeros: ArrayLike, poles: ArrayLike, gain: object, dt: float | bool) -> OpenLoop:
    zero_points, pole_points = _factor_points("zeros", zeros), _factor_points("poles", poles)
    _refuse_order(zero_points.values.size, pole_points.values.size)
    size = checks.real("gain", gain, WHERE)
    if size == 0:
        raise ValueError(f"gain in {WHERE}: got 0, wanted a transfer function that is not zero")
    N, D = (np.atleast_1d(np.poly(part.values)).real[::-1] for part in (zero_points, pole_points))
    return OpenLoop(zero_points, pole_points, size, size * N, D, dt)


def _factor_points(name: str, given: ArrayLike) -> Points:
    """Return ``given`` zeros or poles as points, exact conjugate pairs; errors speak of them by ``name``."""
    x = np.asarray(given)
    if x.dtype.kind not in "iufc":
        raise TypeError(f"{name} in {WHERE}: got an array of {x.dtype}, wanted numbers")
    x = x.astype(complex)
    if x.ndim != 1 or not np.isfinite(x).all():
        raise ValueError(f"{name} in {WHERE}: got {given!r}, wanted a row of finite numbers")
    pairs = real_and_conjugate(x) if x.size else x
    if (np.abs(pairs - x) > 1e-12 * np.abs(x)).any():
        at = int(np.abs(pairs - x).argmax())
        raise ValueError(f"{name}[{at}] in {WHERE}: got {x[at]} without its conjugate, wanted pairs")
    return Points(pairs, EPS * np.abs(pairs))
