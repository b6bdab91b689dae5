"""Root sets along the gain: eigenvalues, Aberth's iteration from neighboring sets, continuous branches.

Where numba is installed the compiled way is tried first; what it doesn't trust is done here with numpy.
"""

from types import ModuleType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus import fast
from rlswaim.rootlocus.branches import continuous_branches, partners
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.polynomials import horner, roots

ANCHOR = 16
"""Of a long run of gains each sixteenth is solved by eigenvalues, and the others from these."""
FEW = 500
"""So few roots are found soonest as eigenvalues."""


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


def polished(loop: OpenLoop, gains: NDArray, values: NDArray) -> NDArray:
    """Return root sets ``values`` (K, n) at ``gains``, from Aberth where the polynomial knows them better.

    An eigenvalue's error is about 2^-52 times the norm of the matrix, so a small root beside
    large ones, or at a large gain, is better taken from the polynomial; and every one of a companion matrix.
    """
    polynomials, sizes = loop.polynomials(gains)
    found = _aberth(polynomials, sizes, values.T)
    fixed, moved = norms(loop)
    better = found.trusted & (found.terms < (fixed + np.abs(gains) * moved) * np.abs(found.slope))
    best = np.where(better.T, _symmetric(found.roots.T, partners(values)), values)
    for at in np.flatnonzero(~found.trusted):
        best[at] = _rescued(polynomials[:, at], sizes[:, at], best[at])
    return best


def _rescued(polynomial: NDArray, sizes: NDArray, values: NDArray) -> NDArray:
    """Return roots (n,), anew from the scaled polynomial where eigenvalues at a huge gain satisfy nothing."""
    p, _, terms = horner(polynomial, values, sizes)
    return values if (np.abs(p) <= 1e-10 * terms).all() else roots(polynomial)


def inserted(loop: OpenLoop, known: NDArray, values: NDArray, gains: NDArray) -> NDArray:
    """Return root sets (m, n) at gains inside the span of ``known`` rising gains with branches ``values``.

    Aberth's iteration starts from the neighbors' mean, weighted; where they differ in which
    roots are conjugates of which, or the iteration is not to be trusted, or the work is small,
    eigenvalues serve.
    """
    if gains.size * values.shape[1] < FEW:
        return polished(loop, gains, loop.eigenvalues(gains))
    right = np.clip(np.searchsorted(known, gains), 1, known.size - 1)
    partner = partners(values)
    alike = (partner[right - 1] == partner[right]).all(axis=1)
    t = ((gains - known[right - 1]) / (known[right] - known[right - 1]))[:, None]
    guess = ((1 - t) * values[right - 1] + t * values[right])[alike]
    corrected = _aberth(*loop.polynomials(gains[alike]), guess.T)
    found = np.empty((gains.size, values.shape[1]), dtype=complex)
    found[alike] = _symmetric(corrected.roots.T, partner[right[alike]])
    alike[alike] = corrected.trusted
    found[~alike] = polished(loop, gains[~alike], loop.eigenvalues(gains[~alike]))
    return found


def _from_anchors(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return root sets (K, n) for rising gains: eigenvalues at anchors, Aberth between them."""
    at = np.unique(np.append(np.arange(0, gains.size, ANCHOR), gains.size - 1))
    inner = np.setdiff1d(np.arange(gains.size), at)
    values = np.empty((gains.size, loop.denominator.size - 1), dtype=complex)
    values[at] = polished(loop, gains[at], continuous_branches(loop.eigenvalues(gains[at])))
    values[inner] = inserted(loop, gains[at], values[at], gains[inner])
    return values


def solve(loop: OpenLoop, gains: NDArray) -> NDArray:
    """Return the closed-loop roots (K, n) for gains in any order, as branches continuous in the gain."""
    distinct, place = np.unique(gains, return_inverse=True)
    loop.refuse_infinite(distinct)
    if module := compiled(loop):
        values = joined(loop, *module.follow(*moving(loop), distinct, norms(loop)))
        if values is not None:
            return values[place]
    long = distinct.size > 4 * ANCHOR and distinct.size * (loop.denominator.size - 1) > 2 * FEW
    if long and not loop.fixed_at_origin:
        return continuous_branches(_from_anchors(loop, distinct))[place]
    return continuous_branches(polished(loop, distinct, loop.eigenvalues(distinct)))[place]


def compiled(loop: OpenLoop) -> ModuleType | None:
    """Return the compiled functions if they are to be used for this loop: some of its roots move."""
    return fast.compiled() if loop.fixed_at_origin < loop.denominator.size - 1 else None


def moving(loop: OpenLoop) -> tuple[NDArray, NDArray]:
    """Return N and D, of one length, without the roots that stay at the origin."""
    N, D = np.zeros(loop.denominator.size), loop.denominator
    N[: loop.numerator.size] = loop.numerator
    return N[loop.fixed_at_origin :], D[loop.fixed_at_origin :]


def norms(loop: OpenLoop) -> NDArray:
    """Return the norms of A and of B C, which say how well eigenvalues know the roots."""
    if loop.companion:
        return np.array([1e100, 0.0])  # as good as never
    return np.array([np.linalg.norm(loop.A), np.linalg.norm(loop.B) * np.linalg.norm(loop.C)])


def joined(loop: OpenLoop, states: NDArray, trusted: bool, sign: int = 1) -> NDArray | None:
    """Return compiled states (K, 6, n) as root sets, those not firm from eigenvalues; None if too many.

    Nothing is joined that is not ``trusted``.  The states' gains are ``sign`` times the loop's.
    """
    if not trusted:
        return None
    soft = np.flatnonzero(states[:, 5, 0] == 0)
    if soft.size > 8 + len(states) // 4:
        return None
    values = np.zeros((len(states), loop.denominator.size - 1), dtype=complex)
    values[:, loop.fixed_at_origin :] = states[:, 0] + 1j * states[:, 1]
    if soft.size:
        gains = sign * states[soft, 4, 0]
        pairs = np.stack([values[soft], loop.eigenvalues(gains)], axis=1)
        values[soft] = polished(loop, gains, np.array([continuous_branches(pair)[1] for pair in pairs]))
    without = np.flatnonzero(states[:, 4, 0] == 0)
    integrators = np.flatnonzero(loop.denominator)[0]
    for at in without:  # poles at the origin are there exactly
        values[at, np.abs(values[at]).argsort()[:integrators]] = 0.0
    return values
