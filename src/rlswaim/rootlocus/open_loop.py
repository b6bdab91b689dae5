"""The open loop of a root locus: state space and polynomials, closed-loop roots, special gains."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.rootlocus.polynomials import (
    characteristic_polynomial,
    derivative,
    horner,
    roots,
    trimmed,
    values,
)
from rlswaim.source import checks

System: TypeAlias = control.StateSpace | control.TransferFunction | Sequence[ArrayLike]
EPS = np.finfo(float).eps


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
class OpenLoop:
    """A single loop G as state space and as ratio of polynomials, constant term first.

    A ``companion`` matrix is made of the polynomials: it knows the roots no better than they do.
    """

    A: NDArray
    B: NDArray
    C: NDArray
    D: float
    numerator: NDArray
    denominator: NDArray
    companion: bool = False

    @cached_property
    def poles(self) -> NDArray:
        """Open-loop poles (1/s)."""
        return roots(self.denominator)

    @cached_property
    def zeros(self) -> NDArray:
        """Open-loop zeros (1/s)."""
        return roots(self.numerator)

    @cached_property
    def fixed_at_origin(self) -> int:
        """How many closed-loop roots stay at the origin at every gain."""
        return min(
            int(np.flatnonzero(p)[0]) if p.any() else p.size for p in (self.numerator, self.denominator)
        )

    def polynomials(self, gains: NDArray) -> tuple[NDArray, NDArray]:
        """Return D + k N for gains k (K,), and |D| + |k N|: each (n + 1, K), constant term first."""
        N = np.zeros(self.denominator.size)
        N[: self.numerator.size] = self.numerator
        D, kN = self.denominator[:, None], np.multiply.outer(N, gains)
        return D + kN, np.abs(D) + np.abs(kN)

    def refuse_infinite(self, gains: NDArray) -> None:
        """Raise a ValueError if one of the gains (K,) sends a root to infinity: k = -1/D."""
        if (np.abs(1 + gains * self.D) <= EPS).any():
            raise ValueError(
                f"root_locus: got the gain {-1 / self.D:g} = -1/D, at which a root is at infinity; "
                "wanted another gain"
            )

    def eigenvalues(self, gains: NDArray) -> NDArray:
        """Return the closed-loop roots (K, n) for gains (K,) as eigenvalues, unordered.

        Raises
        ------
        ValueError
            If a gain sends a root to infinity: k = -1/D.
        """
        self.refuse_infinite(gains)
        closed = self.A - (gains / (1 + gains * self.D))[:, None, None] * (self.B @ self.C)
        found = np.linalg.eigvals(closed).astype(complex)
        if self.fixed_at_origin:
            smallest = np.abs(found).argsort(axis=1)[:, : self.fixed_at_origin]
            np.put_along_axis(found, smallest, 0.0, axis=1)
        return found


def open_loop(system: System) -> OpenLoop:
    """Return the loop of a python-control LTI system, or of arrays (A, B, C).

    Parameters
    ----------
    system : StateSpace, TransferFunction or (A, B, C)

    Returns
    -------
    OpenLoop

    Raises
    ------
    TypeError
        If the system is no LTI system.
    ValueError
        If it has more than one input or output, no poles, or is improper or not finite.
    """
    if isinstance(system, (tuple, list)):
        system = _from_arrays(system)
    if not isinstance(system, (control.StateSpace, control.TransferFunction)):
        raise TypeError(
            f"root_locus: got {type(system).__name__}, wanted a StateSpace, a TransferFunction "
            "or arrays (A, B, C)"
        )
    if (system.ninputs, system.noutputs) != (1, 1):
        raise ValueError(
            f"root_locus: got {system.ninputs} inputs and {system.noutputs} outputs, wanted one of each"
        )
    return (
        _from_transfer(system) if isinstance(system, control.TransferFunction) else _from_state_space(system)
    )


def _from_arrays(arrays: Sequence[ArrayLike]) -> control.StateSpace:
    """Return arrays (A, B, C) as a state space without feed-through."""
    if len(arrays) != 3:
        raise ValueError(f"root_locus: got {len(arrays)} arrays, wanted three: (A, B, C)")
    A, B, C = (
        checks.frozen_array(name, value, "root_locus") for name, value in zip("ABC", arrays, strict=True)
    )
    n = A.shape[0] if A.ndim else 0
    for name, array, shape in (("A", A, (n, n)), ("B", B, (n, 1)), ("C", C, (1, n))):
        if array.shape != shape:
            raise ValueError(f"{name} in root_locus: got shape {array.shape}, wanted {shape}")
    return control.ss(A, B, C, 0.0)


def _from_transfer(system: control.TransferFunction) -> OpenLoop:
    numerator = trimmed(checks.frozen_array("numerator", system.num[0][0][::-1], "root_locus"))
    denominator = trimmed(checks.frozen_array("denominator", system.den[0][0][::-1], "root_locus"))
    n = denominator.size - 1
    if n == 0:
        raise ValueError("root_locus: got a system without poles, wanted at least one")
    if numerator.size > n + 1:
        raise ValueError(
            f"root_locus: got a numerator of order {numerator.size - 1} over one of order {n}, "
            "wanted a proper system"
        )
    numerator, denominator = numerator / denominator[-1], denominator / denominator[-1]
    D = float(numerator[n]) if numerator.size == n + 1 else 0.0
    A, B = np.eye(n, k=1), np.zeros((n, 1))
    A[-1:], B[-1:] = -denominator[:n], 1.0
    C = -D * denominator[:n]
    C[: numerator.size] += numerator[:n]
    return OpenLoop(A, B, C[None, :], D, numerator, denominator, True)


def _from_state_space(system: control.StateSpace) -> OpenLoop:
    A, B, C = (checks.frozen_array(name, getattr(system, name), "root_locus") for name in "ABC")
    D = checks.real("D", float(system.D[0, 0]), "root_locus")
    if not A.size:
        raise ValueError("root_locus: got a system without poles, wanted at least one")
    denominator = characteristic_polynomial(A)
    numerator = characteristic_polynomial(A, B, C) + D * denominator
    return OpenLoop(A, B, C, D, trimmed(numerator), denominator)


def break_aways(loop: OpenLoop) -> tuple[BreakAway, ...]:
    """Return the double roots for real gains: N D' - D N' = 0, k = -D/N.

    Parameters
    ----------
    loop : OpenLoop

    Returns
    -------
    tuple of BreakAway
        By rising gain; of a conjugate pair the upper point alone.
    """
    N, D = loop.numerator, loop.denominator
    q = np.convolve(N, derivative(D))
    q[: D.size + N.size - 2] -= np.convolve(D, derivative(N)) if N.size > 1 else 0.0
    q = trimmed(q)
    points = roots(q) if q.any() else np.zeros(0, complex)
    points = points[points.imag >= 0]
    at, _, terms = horner(D, points)
    with np.errstate(divide="ignore", invalid="ignore"):
        # A multiple open-loop pole is met at the gain 0, not at the rounding of D there, of its coefficients
        # and of the point: with a zero on it too, D/N would be a gain of any size.
        gains = np.where(np.abs(at) <= 100 * D.size * EPS * terms, 0.0, -at / values(N, points))
    real = np.isfinite(gains) & (np.abs(gains.imag) <= 1e-7 * np.abs(gains))
    pairs = zip(gains[real].real.tolist(), points[real].tolist(), strict=True)
    return tuple(sorted((BreakAway(k, p) for k, p in pairs), key=lambda b: b.gain))


def _crossing_frequencies(N: NDArray, D: NDArray) -> NDArray:
    """Return the frequencies w >= 0 (rad/s) where D/N is real: Im D(jw) conj N(jw) = w p(w^2) = 0."""
    turn = 1j ** np.arange(D.size)
    odd = trimmed(np.convolve(N * turn[: N.size], (D * turn).conj()).imag[1::2])
    squares = roots(odd) if odd.any() else np.zeros(0, complex)
    real = (np.abs(squares.imag) <= 1e-9 * np.abs(squares)) & (squares.real >= 0)
    return np.union1d(np.sqrt(squares[real].real), [0.0])


def crossings(loop: OpenLoop) -> tuple[Crossing, ...]:
    """Return the crossings of the imaginary axis: 1 + k G(jw) = 0 with real k.

    Parameters
    ----------
    loop : OpenLoop

    Returns
    -------
    tuple of Crossing
        By rising gain; roots that rest at the origin at every gain are no crossing.
    """
    m = loop.fixed_at_origin
    N, D = loop.numerator[m:], loop.denominator[m:]
    omega = _crossing_frequencies(N, D) if N.any() else np.zeros(0)
    n_at, d_at, n_slope, d_slope = (values(p, 1j * omega) for p in (N, D, derivative(N), derivative(D)))
    with np.errstate(divide="ignore", invalid="ignore"):
        k = -(d_at / n_at).real
        ways = np.sign((-n_at / (d_slope + k * n_slope)).real)
    known = (n_at != 0) & (d_at != 0) & np.isfinite(k) & np.isfinite(ways)
    found = zip(k[known].tolist(), omega[known].tolist(), ways[known].astype(int).tolist(), strict=True)
    return tuple(sorted(Crossing(*crossing) for crossing in found))
