"""Root loci: where the closed-loop roots go as a gain, or any other parameter, runs.

Convention: negative feedback, 1 + k G(s) = 0, with k of either sign.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from numbers import Real

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eig
from scipy.optimize import linear_sum_assignment

from rlswaim.rootlocus.adaptive_gains import Axes, default_axes, picture
from rlswaim.rootlocus.branches import branch_order
from rlswaim.rootlocus.break_aways import BreakAway, break_aways
from rlswaim.rootlocus.closed_loop import ClosedLoop
from rlswaim.rootlocus.continuation import solve
from rlswaim.rootlocus.crossings import Crossing, crossings
from rlswaim.rootlocus.open_loop import OpenLoop, System, open_loop
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
        Closed-loop roots (1/s; in z without unit); column j is one continuous branch, however
        coarse the gains.  Roots that stand still are the last columns.
    poles, zeros : ndarray of complex
        Open-loop poles and zeros, common ones too; empty for a locus in another parameter than the gain.
    break_aways : tuple of BreakAway
    """

    gains: NDArray
    roots: NDArray
    poles: NDArray
    zeros: NDArray
    break_aways: tuple[BreakAway, ...] = ()
    loop: OpenLoop | None = None
    sensitivity: NDArray | None = None

    @property
    def discrete(self) -> bool:
        """Whether the roots are in z, stable within the unit circle; else in s, stable left of the axis."""
        return self.loop is not None and self.loop.discrete

    @property
    def dt(self) -> float | bool | None:
        """Sampling period (s) of a discrete loop, True where it is not told; 0 or None in continuous time."""
        return 0 if self.loop is None else self.loop.dt

    @property
    def stable(self) -> NDArray:
        """Whether all roots are within the unit circle, or left of the imaginary axis, shape (K,)."""
        inside = np.abs(self.roots) < 1 if self.discrete else self.roots.real < 0
        return np.asarray(inside.all(axis=1))

    @cached_property
    def crossings(self) -> tuple[Crossing, ...]:
        """Where branches cross the border of stability; found when first asked for."""
        return () if self.loop is None else crossings(self.loop)

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
        leaves = self.roots[start] if self.loop is None else _leaves(self, self.loop, start)
        return tuple(mode_name(pole, self.discrete) for pole in leaves)


def mode_name(pole: complex, discrete: bool = False) -> str:
    """Return a name for a pole, the same for both of a pair.

    Parameters
    ----------
    pole : complex
        In s (1/s), or of a discrete loop in z.
    discrete : bool
    """
    if discrete:
        sides = f" ± j{abs(pole.imag):.3g}" if pole.imag else ""
        return f"pole at z = {pole.real:.3g}{sides}"
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


def _leaves(locus: "RootLocus", loop: OpenLoop, start: int) -> NDArray:
    """Return for each column of a locus the open-loop pole that its branch leaves from.

    Parameters
    ----------
    locus : RootLocus
    loop : OpenLoop
    start : int
        Which root set the way to the gain 0 starts from.

    Returns
    -------
    ndarray of complex, shape (n,)
    """
    gain = locus.gains[start]
    if gain == 0:
        return locus.roots[start]
    moving = loop.moving_poles.size
    way = solve(ClosedLoop(loop, locus.break_aways), np.array([0.0, gain]), _meetings(locus.break_aways))
    poles = np.concatenate([way[0], loop.resting])
    column = linear_sum_assignment(np.abs(locus.roots[start, :moving, None] - way[1]))[1]
    return poles[np.append(column, np.arange(moving, poles.size))]


def _meetings(breaks: tuple[BreakAway, ...]) -> NDArray:
    """Return the gains at which branches meet or, at 0, may meet."""
    return np.unique([0.0, *(b.gain for b in breaks)])


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
    system : StateSpace, TransferFunction, ZerosPolesGain, (A, B, C) or (zeros, poles, gain)
        The open loop G, single input and output, proper.  Continuous or discrete as its ``dt`` says.
        Factors are given as scipy.signal.ZerosPolesGain or as three: then repeated poles stay exact.
        python-control's own ``zpk`` multiplies them out.
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
        If the system is no LTI system, or not real, or the gains are no real numbers.
    ValueError
        If the system is not single-input, single-output and proper, or has no poles, or is zero, or a
        number is not finite, or a gain sends a root to infinity, or sign or axes are none.

    Notes
    -----
    Poles and zeros of a state space are eigenvalues, those of a transfer function are roots of its
    polynomials; equal ones but for rounding are one repeated pole or zero.  All else follows from zeros,
    poles and gain.  A factor common to both, but for rounding, is a root that stands still.  A discrete
    system's roots are in z, and its crossings are those of the unit circle.  A branch that leaves from a
    pole on the border of stability does not cross it.  An improper loop is refused: the roots of
    1 + k G = 0 are those of 1 + (1/k) (1/G) = 0, so give 1/G.
    """
    loop = open_loop(system)
    side = _checked_sign(sign)
    view = default_axes(loop) if axes is None else _checked_axes(axes)
    limit = checks.positive("tolerance", tolerance, "root_locus")
    breaks = break_aways(loop)
    closed = ClosedLoop(loop, breaks)
    if gains is None:
        marks = side * np.array([b.gain for b in breaks] + [c.gain for c in crossings(loop)])
        if loop.D:  # a root passes through infinity: go close on either side
            lost = -side / loop.D
            near = lost * (1 + np.array([-1e-7, 1e-7]))
            marks = np.append(marks[np.abs(marks - lost) > 1e-7 * abs(lost)], near)
        chosen, moving = picture(closed, marks[marks > 0], view, limit, side)
    else:
        chosen = np.atleast_1d(checks.frozen_array("gains", gains, "root_locus"))
        if chosen.ndim != 1 or not chosen.size:
            raise ValueError(
                f"gains in root_locus: got shape {chosen.shape}, wanted one dimension and at least one gain"
            )
        moving = solve(closed, chosen, _meetings(breaks))
    values = np.concatenate([moving, np.tile(loop.resting, (chosen.size, 1))], axis=1)
    return RootLocus(chosen, values, loop.poles, loop.zeros, breaks, loop)


def _checked_sign(sign: object) -> int:
    """Return a ``sign`` of gains if it is 1 or -1; raise an error otherwise."""
    if isinstance(sign, bool) or not isinstance(sign, Real) or sign not in (1, -1):
        raise ValueError(f"sign in root_locus: got {sign!r}, wanted 1 or -1")
    return 1 if sign == 1 else -1


def _checked_axes(axes: Axes) -> Axes:
    """Return left, right, bottom and top if they are a picture's ``axes``; raise an error otherwise."""
    sides = checks.frozen_array("axes", axes, "root_locus", shape=(4,))
    left, right, bottom, top = sides.tolist()
    if left >= right or bottom >= top:
        raise ValueError(
            f"axes in root_locus: got {tuple(sides.tolist())}, wanted left < right and bottom < top"
        )
    return left, right, bottom, top


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
