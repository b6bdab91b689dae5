"""Limits of performance: what no controller can do, whatever its order and its gains.

They follow from the vehicle's poles p and zeros z right of the imaginary axis alone.  With S = 1/(1 + L)
and T = 1 - S, every controller that stabilizes the loop has

- S(z) = 1 and T(p) = 1, so the peaks of S and of T are at least `peak_bound`;
- with one pole p and one zero z, (p + z)/|p - z|; with one pole and more zeros, their product over the
  zeros (Blaschke's product); in general the bound of Chen, from the directions of poles and zeros too;
- the integral of ln|S| over frequency is pi times the sum of the poles, if L falls at least as 1/s^2;
- a stable controller exists if and only if between any two real zeros right of the axis, infinity among
  them, the number of real poles is even (parity interlacing).

Poles and zeros on the axis itself set no bound, but they do make one when a term that the model leaves
out (gravity, for instance) moves them to the right; `Limits` lists all of them so that a reader sees it.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eig, solve

from rlswaim.source import checks

AXIS = 1e-7
"""Distance from the axis (1/s) below which a pole or a zero counts as on it."""
FAR = 1e4
"""Size (1/s) above which a zero counts as infinite: those at infinity come out near 1e7 by rounding."""


class Directed(NamedTuple):
    """A pole or a zero (1/s) with its direction among the outputs, a complex unit vector."""

    value: complex
    direction: NDArray


@dataclass(frozen=True)
class Limits:
    """The limits that a plant's poles and zeros right of the axis set."""

    poles: tuple[complex, ...]
    zeros: tuple[complex, ...]
    peak: float
    """Least possible peak of S and of T, over all frequencies and controllers (1)."""
    stable_controller: bool | None
    """Whether a stable controller can stabilize the plant; None with several inputs and outputs."""

    @property
    def log_integral(self) -> float:
        """The integral of ln|S| over frequency, pi times the sum of the poles (rad/s) [Bode, Freudenberg]."""
        return float(np.pi * sum(p.real for p in self.poles))


def output_poles(plant: control.StateSpace) -> list[Directed]:
    """Return the poles of a ``plant`` right of the axis with their output directions C x."""
    values, vectors = np.linalg.eig(plant.A)
    found = []
    for value, vector in zip(values, vectors.T, strict=True):
        if value.real > AXIS:
            direction = plant.C @ vector
            found.append(Directed(complex(value), direction / np.linalg.norm(direction)))
    return found


def output_zeros(plant: control.StateSpace) -> list[Directed]:
    """Return the zeros of a square ``plant`` right of the axis with their output directions y: y* G(z) = 0.

    They are the finite generalized eigenvalues of [A B; C D] against [I 0; 0 0], of the transposed system,
    so that a left null vector comes with each.
    """
    if plant.ninputs != plant.noutputs:
        raise ValueError(
            f"plant in output_zeros: got {plant.ninputs} inputs, {plant.noutputs} outputs, wanted as many"
        )
    n, m = plant.nstates, plant.ninputs
    size_in, size_out = np.linalg.norm(plant.B, axis=0), np.linalg.norm(plant.C, axis=1)
    B, C = plant.B / size_in, plant.C / size_out[:, None]
    system = np.block([[plant.A, B], [C, plant.D / size_in / size_out[:, None]]])
    weight = np.zeros((n + m, n + m))
    weight[:n, :n] = np.eye(n)
    (above, below), vectors = eig(system.T, weight.T, homogeneous_eigvals=True)
    finite = np.abs(below) > 1e-10 * np.abs(above)
    found = []
    for value, vector in zip(above[finite] / below[finite], vectors.T[finite], strict=True):
        if value.real > AXIS and abs(value) < FAR:
            direction = np.conj(vector[n:]) / size_out
            found.append(Directed(complex(value), direction / np.linalg.norm(direction)))
    return found


def peak_bound(zeros: list[Directed], poles: list[Directed]) -> float:
    """Return the least peak of S and of T that a controller can reach.

    sqrt(1 + s^2), where s is the largest singular value of Q_z^-1/2 Q_zp Q_p^-1/2, with
    Q_z = y_i* y_j/(z_i + conj z_j), Q_p = y_i* y_j/(conj p_i + p_j), Q_zp = y_i* y_j/(z_i - p_j)
    [Chen 2000; for one pole and one zero it is (p + z)/|p - z|].

    Parameters
    ----------
    zeros, poles : list of Directed
        Right of the axis, each one simple.

    Returns
    -------
    float
        1 if there are no zeros, or no poles: then the peak can come as near to 1 as is wanted, if the
        loop may be as fast as is wanted.
    """
    if not zeros or not poles:
        return 1.0
    z, p = (np.array([item.value for item in items]) for items in (zeros, poles))
    y_z, y_p = (np.array([item.direction for item in items]) for items in (zeros, poles))
    Q_z = (y_z.conj() @ y_z.T) / (z[:, None] + z.conj())
    Q_p = (y_p.conj() @ y_p.T) / (p.conj()[:, None] + p)
    Q_zp = (y_z.conj() @ y_p.T) / (z[:, None] - p)
    # The largest eigenvalue of Q_p^-1 Q_zp* Q_z^-1 Q_zp is s^2.
    product = solve(Q_p, Q_zp.conj().T @ solve(Q_z, Q_zp))
    return float(np.sqrt(1 + max(np.linalg.eigvals(product).real)))


def blaschke(zeros: ArrayLike, pole: ArrayLike) -> NDArray:
    """Return the product of |p + conj z|/|p - z| over all zeros.

    Parameters
    ----------
    zeros : array_like, shape (n,)
        Right of the axis.
    pole : array_like
        One pole or several right of the axis.

    Returns
    -------
    ndarray, shape of ``pole``
        The least peak of T if the pole is the only one; at least that with more.
    """
    z, p = np.asarray(zeros)[:, None], np.asarray(pole)
    flat = p.reshape(1, -1)
    return np.prod(np.abs((flat + z.conj()) / (flat - z)), axis=0).reshape(p.shape)


def interlaced(zeros: ArrayLike, poles: ArrayLike) -> bool:
    """Return whether a stable controller can stabilize a plant: the parity interlacing property.

    Parameters
    ----------
    zeros, poles : array_like
        All those right of the axis; the plant is strictly proper, so that infinity is a zero too.

    Returns
    -------
    bool
    """

    def real(values: ArrayLike) -> NDArray:
        values = np.asarray(values, dtype=complex)
        return np.sort(values[(np.abs(values.imag) <= 1e-9 * np.abs(values)) & (values.real > AXIS)].real)

    ends = [*real(zeros), np.inf]
    p = real(poles)
    return all(np.sum((p > low) & (p < high)) % 2 == 0 for low, high in pairwise(ends))


def limits(plant: control.StateSpace) -> Limits:
    """Return the limits of a plant that is measured at its outputs and driven at its inputs.

    Parameters
    ----------
    plant : control.StateSpace
        Strictly proper, with simple poles and zeros right of the axis.  With more outputs than inputs,
        or fewer, it has no zeros in general, and `Limits.zeros` is empty.

    Returns
    -------
    Limits
        With several outputs, S counts each of them in its own unit, and the bound goes with these
        units: weigh the rows of C so that one of each is as bad as one of the others.

    Raises
    ------
    TypeError
        If the plant is no state space.
    """
    checks.instance("plant", plant, control.StateSpace, "limits")
    poles = output_poles(plant)
    zeros = output_zeros(plant) if plant.ninputs == plant.noutputs else []
    z, p = ([item.value for item in items] for items in (zeros, poles))
    return Limits(tuple(p), tuple(z), peak_bound(zeros, poles), interlaced(z, p) if plant.issiso() else None)


def least_peak_over_band(log_integral: float, bandwidth: float, tail: float = 0.0) -> float:
    """Return the least peak of |S| if the loop can only act up to an available bandwidth [Stein].

    The integral of ln|S| must be made up below it, so ln|S| is at least (log_integral - tail)/bandwidth
    in the mean.

    Parameters
    ----------
    log_integral : float
        pi times the sum of the unstable poles (rad/s).
    bandwidth : float
        Above it L is negligible (rad/s).
    tail : float
        Bound of the integral of ln|S| above it (rad/s): 3 d bandwidth/(2 k) if
        |L| <= d (bandwidth/omega)^(1 + k) there, d at most 1/2.

    Returns
    -------
    float
    """
    checks.positive("bandwidth", bandwidth, "least_peak_over_band")
    return float(np.exp(max(log_integral - tail, 0.0) / bandwidth))


def least_peak_with_band(zero: float, poles: ArrayLike, low: float, epsilon: float) -> float:
    """Return the least peak of |S| if |S| <= epsilon below a frequency [Poisson's integral].

    (1/epsilon)^(w/(pi - w)) B^(pi/(pi - w)), w = 2 arctan(low/zero), B the product of |z + p|/|z - p|.

    Parameters
    ----------
    zero : float
        A real zero right of the axis (1/s).
    poles : array_like
        All poles right of the axis (1/s).
    low : float
        The band (rad/s).
    epsilon : float
        The size of S in the band, at most 1.

    Returns
    -------
    float
    """
    z = checks.positive("zero", zero, "least_peak_with_band")
    p = np.asarray(poles, dtype=complex)
    B = float(np.prod(np.abs((z + p.conj()) / (z - p))))
    w = 2 * np.arctan(low / z)
    return float((1 / checks.positive("epsilon", epsilon)) ** (w / (np.pi - w)) * B ** (np.pi / (np.pi - w)))
