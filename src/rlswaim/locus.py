"""Root loci: where the closed-loop roots go as a gain, or any other parameter, runs.

Convention: negative feedback, 1 + k G(s) = 0, with k of either sign.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eig

from rlswaim import checks
from rlswaim.branches import branch_order, continuous_branches, partners
from rlswaim.openloop import BreakAway, Crossing, OpenLoop, System, break_aways, crossings, open_loop
from rlswaim.polynomials import horner

SCREEN = (800, 600)
"""Size (pixels) of the picture for which gains are chosen."""
ANCHOR = 8
"""Of a long run of gains each eighth is solved by eigenvalues, and the others from these."""
MOST = 4000
"""No picture takes more gains than this."""

Axes = tuple[float, float, float, float]


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


class _Corrected(NamedTuple):
    """Aberth's roots (n, K), p' and the sizes of p's terms there, and which sets (K,) are to be trusted."""

    roots: NDArray
    slope: NDArray
    terms: NDArray
    trusted: NDArray


def _aberth(polynomials: NDArray, sizes: NDArray, guess: NDArray, steps: int = 6) -> _Corrected:
    """Return roots corrected by Aberth's iteration until rounding is all that is left of p."""
    s, slope, terms = guess.copy(), np.empty_like(guess), np.empty(guess.shape)
    n, busy = guess.shape[0], np.arange(guess.shape[1])
    itself = np.eye(n, dtype=bool)[..., None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(steps):
            z = s[:, busy]
            p, slope[:, busy], terms[:, busy] = horner(polynomials[:, busy], z, sizes[:, busy])
            good = np.abs(p) <= 4e-16 * n * terms[:, busy]
            left = ~good.all(axis=0)
            p, z, good, busy = p[:, left], z[:, left], good[:, left], busy[left]
            if not busy.size:
                break
            newton = p / slope[:, busy]
            push = np.where(itself, 0, 1 / np.where(itself, 1, z[:, None] - z[None])).sum(axis=1)
            s[:, busy] = z - np.where(good, 0, newton / (1 - newton * push))
        total = -polynomials[-2] / polynomials[-1]
        trusted = np.abs(s.sum(axis=0) - total) <= 1e-12 * np.abs(s).sum(axis=0)
    trusted[busy] = False
    return _Corrected(s, slope, terms, trusted)


def _symmetric(values: NDArray, partner: NDArray) -> NDArray:
    """Return root sets (K, n) with exact conjugate pairs and exactly real roots."""
    return (values + np.take_along_axis(values, partner, axis=1).conj()) / 2


def _polished(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return root sets (K, n) with Aberth's roots where the polynomial knows them better.

    An eigenvalue's error is about 2^-52 times the norm of the matrix, so a small root beside
    large ones, or at a large gain, is better taken from the polynomial.
    """
    found = _aberth(*loop.polynomials(gains), values.T)
    norm = np.linalg.norm(loop.A) + np.abs(gains) * np.linalg.norm(loop.B) * np.linalg.norm(loop.C)
    better = found.trusted & (found.terms < norm * np.abs(found.slope))
    return np.where(better.T, _symmetric(found.roots.T, partners(values)), values)


def _inserted(loop: OpenLoop, known: NDArray, values: NDArray, gains: NDArray) -> NDArray:
    """Return root sets (m, n) at gains inside the span of known rising gains with continuous branches.

    Aberth's iteration starts from the neighbors' mean, weighted; where they differ in which
    roots are conjugates of which, or the iteration is not to be trusted, or the work is small,
    eigenvalues serve.
    """
    if gains.size * values.shape[1] < 500:
        return loop.eigenvalues(gains)
    right = np.clip(np.searchsorted(known, gains), 1, known.size - 1)
    partner = partners(values)
    alike = (partner[right - 1] == partner[right]).all(axis=1)
    t = ((gains - known[right - 1]) / (known[right] - known[right - 1]))[:, None]
    guess = ((1 - t) * values[right - 1] + t * values[right])[alike]
    corrected = _aberth(*loop.polynomials(gains[alike]), guess.T)
    found = np.empty((gains.size, values.shape[1]), dtype=complex)
    found[alike] = _symmetric(corrected.roots.T, partner[right[alike]])
    alike[alike] = corrected.trusted
    found[~alike] = loop.eigenvalues(gains[~alike])
    return found


def _from_anchors(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return root sets (K, n) for rising gains: eigenvalues at anchors, Aberth between them."""
    at = np.unique(np.append(np.arange(0, gains.size, ANCHOR), gains.size - 1))
    inner = np.setdiff1d(np.arange(gains.size), at)
    values = np.empty((gains.size, loop.denominator.size - 1), dtype=complex)
    values[at] = continuous_branches(loop.eigenvalues(gains[at]))
    values[inner] = _inserted(loop, gains[at], values[at], gains[inner])
    return values


def _solve(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return the closed-loop roots (K, n) for gains in any order, as branches continuous in the gain."""
    distinct, place = np.unique(gains, return_inverse=True)
    long = distinct.size > 8 * ANCHOR and not loop.fixed_at_origin
    values = _from_anchors(loop, distinct) if long else loop.eigenvalues(distinct)
    return continuous_branches(_polished(loop, distinct, values))[place]


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


def _picture(
    loop: OpenLoop, marks: NDArray, axes: Axes, tolerance: float, sign: int
) -> tuple[NDArray, NDArray]:
    """Return gains of one sign, marks among them, and branches true to the curve within the tolerance."""
    if not loop.numerator.any():  # nothing moves
        gains = np.array([0.0, sign])
        return gains, _solve(loop, gains)
    lead = np.abs(loop.denominator).max() / max(np.abs(loop.numerator).max(), 1e-300)
    offset = 1e-6 * lead
    gains = np.unique(np.concatenate([[0.0], lead * np.logspace(-6, 7, 32), marks]))
    values = continuous_branches(loop.eigenvalues(sign * gains))
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
    return sign * gains, _polished(loop, sign * gains, values)


def _through_infinity(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return in which intervals of gains a root passes through infinity: k = -1/D lies there."""
    side = np.sign(1 + gains * loop.D)
    return side[:-1] != side[1:]


def _merged(
    loop: OpenLoop, sign: int, gains: NDArray, values: NDArray, more: NDArray
) -> tuple[NDArray, NDArray]:
    """Return gains >= 0 and branches with those of some more gains."""
    if sign > 0:
        found = _inserted(loop, gains, values, more)
    else:
        found = _inserted(loop, -gains[::-1], values[::-1], -more)
    order = np.argsort(np.concatenate([gains, more]), kind="stable")
    branches = continuous_branches(np.concatenate([values, found])[order])
    return np.concatenate([gains, more])[order], branches


def _relative_condition(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return sum |c_i| |s|^i / (|s| |p'(s)|) for each root (K, n); 1 for a root that rests at the origin."""
    polynomials, sizes = loop.polynomials(gains)
    _, slope, terms = horner(polynomials, values.T, sizes)
    with np.errstate(divide="ignore", invalid="ignore"):
        condition = terms / (np.abs(values.T) * np.abs(slope))
    return np.where(values == 0, 1.0, condition.T)


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
        chosen, values = _picture(loop, marks[marks > 0], view, limit, sign)
    else:
        chosen = checks.frozen_array("gains", np.atleast_1d(np.asarray(gains)), "root_locus")
        if chosen.ndim != 1:
            raise ValueError(f"gains in root_locus: got shape {chosen.shape}, wanted one dimension")
        values = _solve(loop, chosen)
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
