"""Root loci: where the closed-loop roots go as a gain, or any other parameter, runs.

Convention: negative feedback, 1 + k G(s) = 0, with k of either sign.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eig

from rlswaim.rootlocus.adaptive_gains import Axes, default_axes, picture
from rlswaim.rootlocus.branches import branch_order, continuous_branches
from rlswaim.rootlocus.continuation import solve
from rlswaim.rootlocus.open_loop import (
    BreakAway,
    Crossing,
    OpenLoop,
    System,
    break_aways,
    crossings,
    open_loop,
)
from rlswaim.rootlocus.polynomials import horner
from rlswaim.source import checks


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
    sensitivity: NDArray | None = None

    @cached_property
    def condition(self) -> NDArray:
        """Relative change of each root per relative change of the data, shape (K, n).

        The data are the coefficients of N and D or, for a locus in a general parameter, the entries
        of the closed loop's state matrix.  Above 1e3 three digits do not fix a root, above 1e13 double
        precision does not.
        """
        if self.loop is None:
            return np.ones(self.roots.shape) if self.sensitivity is None else self.sensitivity
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


def _relative_condition(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return sum |c_i| |s|^i / (|s| |p'(s)|) for each root (K, n).

    A root that rests at the origin has 1, one that passes it infinity.
    """
    polynomials, sizes = loop.polynomials(gains)
    _, slope, terms = horner(polynomials, values.T, sizes)
    with np.errstate(divide="ignore", invalid="ignore"):
        condition = terms / (np.abs(values.T) * np.abs(slope))
    return np.where(values == 0, np.where(sizes[:1].T > 0, np.inf, 1.0), condition.T)


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
        The open loop G, single input and output, proper.
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
        If the system is not single-input, single-output and proper, or has no poles, or a number is
        not finite, or a gain sends a root to infinity.

    Notes
    -----
    A discrete system's roots are in z; ``crossings`` are those of the imaginary axis all the same.
    """
    loop = open_loop(system)
    breaks, crosses = break_aways(loop), crossings(loop)
    if gains is None:
        marks = sign * np.array([b.gain for b in breaks] + [c.gain for c in crosses])
        if loop.D:  # a root passes through infinity: go close on either side
            lost = -sign / loop.D
            near = lost * (1 + np.array([-1e-7, 1e-7]))
            marks = np.append(marks[np.abs(marks - lost) > 1e-7 * abs(lost)], near)
        view = default_axes(loop) if axes is None else axes
        limit = checks.positive("tolerance", tolerance, "root_locus")
        chosen, values = picture(loop, marks[marks > 0], view, limit, sign)
    else:
        chosen = checks.frozen_array("gains", np.atleast_1d(np.asarray(gains)), "root_locus")
        if chosen.ndim != 1:
            raise ValueError(f"gains in root_locus: got shape {chosen.shape}, wanted one dimension")
        values = solve(loop, chosen)
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
    TypeError
        If the closed loop is no LTI system.
    """
    run = checks.frozen_array("values", np.atleast_1d(np.asarray(values)), "parameter_locus")
    sets = [_eigensystem(closed_loop(float(value))) for value in run]
    for at, found in enumerate(sets):
        if found[0].size != sets[0][0].size:
            raise ValueError(
                f"parameter_locus: got {found[0].size} poles at values[{at}] = {run[at]:g}, "
                f"wanted {sets[0][0].size} as at {run[0]:g}"
            )
    poles, vectors, condition = (np.array(part) for part in zip(*sets, strict=True))
    order = branch_order(poles, vectors)
    poles, condition = (np.take_along_axis(part, order, axis=1) for part in (poles, condition))
    nothing = np.zeros(0, complex)
    return RootLocus(run, poles, nothing, nothing, sensitivity=condition)


def _eigensystem(system: control.StateSpace | control.TransferFunction) -> tuple[NDArray, NDArray, NDArray]:
    """Return poles (n,), unit eigenvectors in columns (n, n), and the poles' relative conditions (n,)."""
    if not isinstance(system, (control.StateSpace, control.TransferFunction)):
        raise TypeError(
            f"parameter_locus: got {type(system).__name__} from closed_loop, "
            "wanted a StateSpace or TransferFunction"
        )
    A = system.A if isinstance(system, control.StateSpace) else control.ss(system).A
    poles, left, right = eig(A, left=True)
    with np.errstate(divide="ignore"):
        along = np.abs((left.conj() * right).sum(axis=0))
        condition = np.linalg.norm(A) / (np.abs(poles) * along)
    return poles, right, condition
