"""Closed-loop roots at given gains: eigenvalues as first guesses, Aberth's iteration on the factors."""

from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import EPS, MEET, Slopes, aberth, real_and_conjugate, starting_points
from rlswaim.rootlocus.branches import squared_distances
from rlswaim.rootlocus.break_aways import BreakAway
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.polynomials import misfit

BLOCK = 20_000
"""So many pairs of roots at a time: they stay in the processor's cache."""
BLURRED = 64
"""Where F is at most so many times its rounding, of two roots that meet the middle alone is fixed."""
REPEATED = 6
"""Poles and zeros repeated more often than this make matrices whose eigenvalues are no good guesses."""


class RootSets(NamedTuple):
    """Roots (K, n) at gains (K,), their tangents ds/dk, 0 where not known, and kinds as `kinds_of` says."""

    gains: NDArray
    roots: NDArray
    tangents: NDArray
    kinds: NDArray

    def at(self, which: NDArray | slice) -> "RootSets":
        """Return the sets of which the numbers, or a slice, are given."""
        return RootSets(*(part[which] for part in self))

    def in_columns(self, order: NDArray) -> "RootSets":
        """Return the sets with their roots in a given ``order`` (K, n)."""
        if (order == np.arange(order.shape[1])).all():
            return self
        rows = np.arange(len(order))[:, None]
        return RootSets(self.gains, *(part[rows, order] for part in self[1:]))


def kinds_of(roots: NDArray, real: NDArray) -> NDArray:
    """Return 1 or -1 for complex roots, by their side of the real axis, and 2, 3, ... for real ones in order.

    Parameters
    ----------
    roots : ndarray of complex, shape (K, n)
    real : ndarray of bool, shape (K, n)

    Returns
    -------
    ndarray, shape (K, n)
    """
    rank = np.where(real, roots.real, np.inf).argsort(axis=1).argsort(axis=1)
    return np.where(real, 2 + rank, np.sign(roots.imag))


class ClosedLoop:
    """The closed loop D + k N of an open loop G = N/D, evaluated by its factors.

    All is scaled: s by ``size``, the mean size of poles and zeros, and the gain accordingly.
    """

    def __init__(self, loop: OpenLoop, breaks: tuple[BreakAway, ...] = ()) -> None:
        self.loop, self.breaks = loop, breaks
        points, weights, _ = loop.places
        sizes = np.abs(points[points != 0])
        self.size = float(np.exp(np.log(sizes).mean())) if sizes.size else 1.0
        self.points, self.counts = points / self.size, np.abs(weights)
        self.poles = int((weights < 0).sum())
        parts = list(zip(self.points.tolist(), self.counts.tolist(), strict=True))
        self.parts = parts[: self.poles], parts[self.poles :]
        every, self.order = np.repeat(self.points, self.counts), loop.moving_poles.size
        self.factors = every[: self.order], every[self.order :]
        self.excess = self.order - self.factors[1].size
        self.gain = loop.gain / self.size**self.excess
        self.sums = tuple(float(part.sum().real) for part in self.factors)
        self.largest = float(np.abs(points).max(initial=0.0)) / self.size

    def values(self, s: NDArray) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """Return D, D', N and N' at scaled points ``s``, any shape."""
        found = []
        for part, lead in zip(self.parts, (1.0, self.gain), strict=True):
            value, slope = np.full(s.shape, lead, dtype=complex), np.zeros(s.shape, dtype=complex)
            for x, count in part:
                distance = s - x
                if count > 1:
                    power = distance ** (count - 1)
                    slope *= power
                    value *= power
                slope *= distance
                slope += value if count == 1 else count * value
                value *= distance
            found += [value, slope]
        D, D_slope, N, N_slope = found
        return D, D_slope, N, N_slope

    def slopes(self, gains: NDArray, tangents: NDArray) -> Slopes:
        """Return the function for `aberth` of the closed loops at given gains.

        At each call it writes the tangents ds/dk = -N / (D' + k N') too, 0 at a double root.

        Parameters
        ----------
        gains : ndarray, shape (K,)
        tangents : ndarray of complex, shape (n, K)

        Returns
        -------
        callable
        """
        rounding = EPS * (self.counts.sum() + 2)

        def slopes(s: NDArray, which: NDArray) -> tuple[NDArray, NDArray, NDArray]:
            k = gains[which]
            D, D_slope, N, N_slope = self.values(s)
            kN = k * N
            F, derivative = D + kN, D_slope + k * N_slope
            terms, size, steep = np.abs(D) + np.abs(kN), np.abs(s), np.abs(derivative)
            double = steep * np.maximum(size, 1e-6) <= 1e-6 * terms
            tangents[:, which] = np.where(double, 0, -self.size * N / derivative)
            left = np.abs(F)
            found = left <= np.maximum(rounding * terms, EPS * size * steep)
            return derivative / F, found, left <= BLURRED * rounding * terms

        return slopes

    def _first(self, gains: NDArray) -> NDArray:
        """Return approximate scaled roots (n, K) at ``gains`` (K,)."""
        if self.counts.max() <= REPEATED:
            found = self.eigenvalues(gains)
            for gain, point in self.breaks:  # eigenvalues know a double root to half of their digits only
                for at in np.flatnonzero(gains == gain):
                    for s in {point / self.size, point.conjugate() / self.size}:
                        two = np.abs(found[:, at] - s).argsort()[:2]
                        found[two, at] = s + 1e-9 * max(abs(s), 1e-9) * np.array([-1, 1])
            return found
        D, N = (np.atleast_1d(np.poly(part)).real[::-1] for part in self.factors)
        N = np.append(N, np.zeros(D.size - N.size)) * self.gain
        return np.stack([starting_points(D + gain * N) for gain in gains], axis=1)

    def eigenvalues(self, gains: NDArray) -> NDArray:
        """Return approximate scaled roots (n, K) as eigenvalues of a real matrix for each of the ``gains``.

        With nodes x_i, where D + k N is v_i times the product of x_i - x_j over the others, the roots are
        the eigenvalues of diag(x) - 1 v^T.  The nodes are the poles; those of a repeated pole
        stand on a circle around it.
        """
        real, upper = self._nodes()
        half = np.concatenate([real, upper])
        apart = half[:, None] - np.concatenate([half, upper.conj()])
        np.fill_diagonal(apart, 1.0)
        D, N = ((half[:, None] - part).prod(axis=1) for part in self.factors)
        fixed, moved = (part / apart.prod(axis=1) for part in (D, self.gain * N))
        leading = 1 + gains * (self.gain if self.excess == 0 else 0.0)
        v = (fixed + gains[:, None] * moved) / leading[:, None]
        # In the place of a pair x, x* stand Re and Im of a vector, in that of v, v* 2 Re v and -2 Im v.
        v[:, real.size :] *= 2
        diagonal = np.diag(np.concatenate([half, upper]).real)
        turning = np.arange(real.size, half.size), np.arange(half.size, self.order)
        diagonal[turning], diagonal[turning[::-1]] = -upper.imag, upper.imag
        matrices = np.tile(diagonal, (gains.size, 1, 1))
        matrices[:, : half.size] -= np.concatenate([v.real, -v.imag[:, real.size :]], axis=1)[:, None]
        return np.linalg.eigvals(matrices).astype(complex).T

    def sets(self, gains: NDArray, guess: NDArray | None = None) -> RootSets:
        """Return the moving roots at given gains, in exact pairs, and their tangents.

        Parameters
        ----------
        gains : ndarray, shape (K,)
        guess : ndarray of complex, shape (K, n), optional
            Without it, eigenvalues are the first guess.

        Returns
        -------
        RootSets
        """
        found, moved = np.empty((2, gains.size, self.order), complex), np.flatnonzero(gains)
        if moved.size < gains.size:
            found[:] = np.array([self.loop.moving_poles, self._leaving])[:, None]
        step = max(16, BLOCK // self.order**2)
        for start in range(0, moved.size, step):
            part = moved[start : start + step]
            if guess is None or self.counts.max() > REPEATED:  # such branches leave faster than a guess tells
                first = self._first(gains[part])
            else:
                first = guess[part].T / self.size
            roots, tangents = self._corrected(gains[part], first)
            found[:, part] = self.size * roots.T, tangents.T
        return RootSets(gains, found[0], found[1], kinds_of(found[0], found[0].imag == 0))

    @cached_property
    def _leaving(self) -> NDArray:
        """The tangents (n,) at the poles; 0 where poles meet."""
        poles = self.loop.moving_poles / self.size
        apart = poles[:, None] - poles
        meet = (np.abs(apart) <= MEET * np.abs(poles)).sum(axis=1) > 1
        np.fill_diagonal(apart, 1.0)
        N = self.gain * (poles[:, None] - self.factors[1]).prod(axis=1)
        with np.errstate(all="ignore"):
            tangents = -self.size * N / apart.prod(axis=1)
        return np.where(meet | ~np.isfinite(tangents), 0, tangents)

    def _corrected(self, gains: NDArray, guess: NDArray) -> tuple[NDArray, NDArray]:
        """Return scaled roots (n, K) by Aberth's iteration, anew where it fails, and tangents (n, K)."""
        tangents = np.empty(guess.shape, complex)
        slopes = self.slopes(gains, tangents)
        roots, found, meet = aberth(slopes, guess, steps=8 if self.counts.max() <= REPEATED else 60)
        roots, paired = _in_pairs(roots)
        for at in np.flatnonzero(~(found & paired & self._complete(gains, roots))):
            anew = self._anew(gains[at : at + 1], guess[:, at])
            roots[:, at] = self._best_fit(gains[at], anew, real_and_conjugate(roots[:, at]))
            with np.errstate(all="ignore"):
                slopes(roots[:, [at]], np.array([at]))
        return roots, np.where(meet | ~np.isfinite(tangents), 0, tangents)

    def _anew(self, gain: NDArray, guess: NDArray) -> NDArray:
        """Return the scaled roots (n,) at one ``gain`` (1,) from a ``guess`` (n,) without symmetry."""
        turns = np.exp(1j * np.arange(guess.size))
        first = guess + 1e-3 * (np.abs(guess) + 1e-3) * turns
        slopes = self.slopes(gain, np.empty((guess.size, 1), complex))
        values, found, _ = aberth(slopes, first[:, None], steps=60)
        if not found[0] or not self._complete(gain, values)[0]:
            circle = 2 * (1 + np.abs(guess).max()) * turns ** (2 * np.pi / guess.size)
            again = aberth(slopes, circle[:, None] * np.exp(0.5j), steps=200)
            values = again.values if again.found[0] else values
        return real_and_conjugate(values[:, 0])

    def _best_fit(self, gain: float, *found: NDArray) -> NDArray:
        """Return of several sets of scaled roots the one that fits the polynomial at a ``gain`` best."""
        D, N = (np.atleast_1d(np.poly(part)).real for part in self.factors)
        kN = gain * self.gain * np.append(np.zeros(D.size - N.size), N)
        return min(found, key=lambda s: misfit((D + kN)[::-1], s, (np.abs(D) + np.abs(kN))[::-1]))

    def _complete(self, gains: NDArray, s: NDArray) -> NDArray:
        """Return for which ``gains`` (K,) the roots ``s`` (n, K) have the right sum: none is missing."""
        kg, (poles, zeros) = gains * self.gain, self.sums
        total = (poles + kg * zeros) / (1 + kg) if self.excess == 0 else poles - kg * (self.excess == 1)
        return np.abs(s.sum(axis=0) - total) <= 1e-7 * (np.abs(s).sum(axis=0) + self.largest)

    def _nodes(self) -> tuple[NDArray, NDArray]:
        """Return as many points as there are poles: real ones, and the upper ones of pairs."""
        poles, counts = self.points[: self.poles], self.counts[: self.poles]
        single = counts == 1
        real, upper = [*poles[single & (poles.imag == 0)]], [*poles[single & (poles.imag > 0)]]
        for pole, count in zip(poles[~single], counts[~single], strict=True):
            if pole.imag < 0:
                continue
            others = np.abs(self.points - pole)
            radius = 0.3 * min(others[others > 0].min(initial=2.0), 2.0)
            circle = pole + radius * np.exp(1j * np.pi * (2 * np.arange(count) + 1) / count)
            upper += [*circle[: count if pole.imag else count // 2]]
            real += [] if pole.imag else [pole.real - radius] * (count % 2)
        return np.array(real, complex), np.array(upper, complex)


def _in_pairs(s: NDArray) -> tuple[NDArray, NDArray]:
    """Return roots ``s`` (n, K) as exact pairs and real ones, and for which columns (K,) that worked."""
    sets, rows = s.T, np.arange(s.shape[1])[:, None]
    partner = squared_distances(sets, sets.conj()).argmin(axis=2)
    paired = (partner[rows, partner] == np.arange(len(s))).all(axis=1)
    return ((sets + sets[rows, partner].conj()) / 2).T, paired
