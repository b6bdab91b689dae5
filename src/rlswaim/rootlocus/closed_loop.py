"""Closed-loop roots at given gains: eigenvalues as first guesses, Aberth's iteration on the factors."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.aberth import Slopes, aberth, real_and_conjugate, starting_points
from rlswaim.rootlocus.open_loop import OpenLoop
from rlswaim.rootlocus.repeated_roots import EPS

BLOCK = 7_000
"""So many numbers at a time: they stay in the processor's cache."""
REPEATED = 6
"""Poles and zeros repeated more often than this make matrices whose eigenvalues are no good guesses."""
NEVER_ZERO = 1e-150
"""In place of the distance 0 from a root to a pole or zero; its square is no zero either."""


class _Values(NamedTuple):
    """D and N at points (n, K), and their logarithmic derivatives D'/D and N'/N."""

    D: NDArray
    N: NDArray
    D_slope: NDArray
    N_slope: NDArray


class ClosedLoop:
    """The closed loop D + k N of an open loop G = N/D, evaluated by its factors.

    All is scaled: s by ``size``, the mean size of poles and zeros, and the gain accordingly.
    """

    def __init__(self, loop: OpenLoop) -> None:
        self.loop = loop
        points, weights, _ = loop.places
        sizes = np.abs(points[points != 0])
        self.size = float(np.exp(np.log(sizes).mean())) if sizes.size else 1.0
        self.points, self.counts = points / self.size, np.abs(weights)
        self.poles = int((weights < 0).sum())
        self.order = loop.moving_poles.size
        self.excess = self.order - int(self.counts[self.poles :].sum())
        self.gain = loop.gain / self.size**self.excess
        self.repeated = bool((self.counts > 1).any())

    def values(self, s: NDArray) -> _Values:
        """Return `_Values` at scaled points ``s`` (n, K)."""
        distance = s - self.points[:, None, None]
        square = distance.real**2 + distance.imag**2
        if not square.min():
            distance[square == 0] = NEVER_ZERO
            square[square == 0] = NEVER_ZERO**2
        inverse = distance.conj()
        inverse *= 1 / square
        if self.repeated:
            inverse *= self.counts[:, None, None]
            with np.errstate(over="ignore", invalid="ignore"):
                distance = distance ** self.counts[:, None, None]
        a = self.poles
        D, N = distance[:a].prod(axis=0), distance[a:].prod(axis=0)
        return _Values(D, self.gain * N, inverse[:a].sum(axis=0), inverse[a:].sum(axis=0))

    def tangents(self, gains: NDArray, roots: NDArray) -> tuple[NDArray, NDArray]:
        """Return ds/dk = -N / (D' + k N') at roots, and where it is known: at no double root.

        Parameters
        ----------
        gains : ndarray, shape (K,)
        roots : ndarray of complex, shape (K, n)

        Returns
        -------
        tuple of ndarray, both of shape (K, n)
        """
        D, N, D_slope, N_slope = self.values(roots.T / self.size)
        with np.errstate(all="ignore"):
            derivative = D * D_slope + gains * N * N_slope
            tangent = (-self.size * N / derivative).T
            terms = np.abs(D) + np.abs(gains * N)
            known = np.abs(derivative) * np.maximum(np.abs(roots.T / self.size), 1e-6) > 1e-6 * terms
        known = known.T & (np.abs(tangent) < 1e100)
        return np.where(known, tangent, 0), known

    def slopes(self, gains: NDArray) -> Slopes:
        """Return the function for `aberth` of the closed loops at ``gains`` (K,)."""
        rounding = EPS * (self.counts.sum() + 2)

        def slopes(s: NDArray, which: NDArray) -> tuple[NDArray, NDArray]:
            D, N, D_slope, N_slope = self.values(s)
            kN = gains[which] * N
            F, derivative = D + kN, D * D_slope + kN * N_slope
            error = np.maximum(rounding * (np.abs(D) + np.abs(kN)), EPS * np.abs(s * derivative))
            return derivative / F, np.abs(F) <= error

        return slopes

    def _first(self, gains: NDArray) -> NDArray:
        """Return approximate scaled roots (n, K) at ``gains`` (K,)."""
        if self.counts.max() <= REPEATED:
            return self.eigenvalues(gains)
        D, N = (
            np.atleast_1d(np.poly(np.repeat(x, m))).real[::-1]
            for x, m in zip(
                *(np.split(part, [self.poles]) for part in (self.points, self.counts)), strict=True
            )
        )
        N = np.append(N, np.zeros(D.size - N.size)) * self.gain
        return np.stack([starting_points(D + gain * N) for gain in gains], axis=1)

    def eigenvalues(self, gains: NDArray) -> NDArray:
        """Return approximate scaled roots (n, K) as eigenvalues of a real matrix for each of the ``gains``.

        With nodes x_i, where D + k N is v_i times the product of x_i - x_j over the others, the roots are
        the eigenvalues of diag(x) - 1 v^T.  The nodes are the poles; those of a repeated pole
        stand on a circle around it.
        """
        nodes = self._nodes()
        apart = nodes[:, None] - nodes
        np.fill_diagonal(apart, 1.0)
        D, N, *_ = self.values(nodes[:, None])
        fixed, moved = (part[:, 0] / apart.prod(axis=1) for part in (D, N))
        leading = 1 + gains * (self.gain if self.excess == 0 else 0.0)
        rows = (fixed + gains[:, None] * moved) / leading[:, None]
        real = _real_form(nodes)
        diagonal = (real.conj().T @ (nodes[:, None] * real)).real
        ones = real.conj().sum(axis=0).real
        matrices = diagonal - ones[:, None] * (rows @ real).real[:, None, :]
        return np.linalg.eigvals(matrices).astype(complex).T

    def roots(self, gains: NDArray, guess: NDArray | None = None) -> NDArray:
        """Return the moving roots at given gains, in exact pairs.

        Parameters
        ----------
        gains : ndarray, shape (K,)
        guess : ndarray of complex, shape (K, n), optional
            Without it, eigenvalues are the first guess.

        Returns
        -------
        ndarray of complex, shape (K, n)
        """
        found = np.tile(self.loop.moving_poles, (gains.size, 1))
        moved = np.flatnonzero(gains)
        step = max(1, BLOCK // (self.points.size * self.order))
        for start in range(0, moved.size, step):
            part = moved[start : start + step]
            first = self._first(gains[part]) if guess is None else guess[part].T / self.size
            found[part] = self.size * self._corrected(gains[part], first).T
        return found

    def _corrected(self, gains: NDArray, guess: NDArray) -> NDArray:
        """Return scaled roots (n, K) by Aberth's iteration, anew from other guesses where it fails."""
        values, found = aberth(self.slopes(gains), guess, steps=8 if self.counts.max() <= REPEATED else 60)
        values, paired = _in_pairs(values)
        for at in np.flatnonzero(~(found & paired & self._complete(gains, values))):
            values[:, at] = self._anew(gains[at : at + 1], guess[:, at])
        return values

    def _anew(self, gain: NDArray, guess: NDArray) -> NDArray:
        """Return the scaled roots (n,) at one ``gain`` (1,) from a ``guess`` (n,) without symmetry."""
        turns = np.exp(1j * np.arange(guess.size))
        first = guess + 1e-3 * (np.abs(guess) + 1e-3) * turns
        values, found = aberth(self.slopes(gain), first[:, None], steps=60)
        if not found[0] or not self._complete(gain, values)[0]:
            circle = 2 * (1 + np.abs(guess).max()) * turns ** (2 * np.pi / guess.size)
            again = aberth(self.slopes(gain), circle[:, None] * np.exp(0.5j), steps=200)
            values = again.values if again.found[0] else values
        return real_and_conjugate(values[:, 0])

    def _complete(self, gains: NDArray, s: NDArray) -> NDArray:
        """Return for which ``gains`` (K,) the roots ``s`` (n, K) have the right sum: none is missing."""
        poles, zeros = (
            (x * m).sum().real
            for x, m in zip(
                *(np.split(part, [self.poles]) for part in (self.points, self.counts)), strict=True
            )
        )
        kg = gains * self.gain
        total = (poles + kg * zeros) / (1 + kg) if self.excess == 0 else poles - kg * (self.excess == 1)
        return np.abs(s.sum(axis=0) - total) <= 1e-7 * (np.abs(s).sum(axis=0) + np.abs(self.points).max())

    def _nodes(self) -> NDArray:
        """Return as many distinct points as there are poles: reals, then pairs, the upper one first."""
        poles, counts = self.points[: self.poles], self.counts[: self.poles]
        nodes = []
        for pole, count in zip(poles[poles.imag >= 0], counts[poles.imag >= 0], strict=True):
            others = np.abs(self.points - pole)
            radius = 0.3 * min(others[others > 0].min(initial=2.0), 2.0) if count > 1 else 0.0
            circle = pole + radius * np.exp(1j * np.pi * (2 * np.arange(count) + 1) / count)
            if pole.imag == 0:
                half = circle[: count // 2]
                nodes += [*half, *half.conj()] + [pole.real - radius] * (count % 2)
            else:
                nodes += [*circle, *circle.conj()]
        found = np.array(nodes, complex)
        real, upper = found[found.imag == 0], found[found.imag > 0]
        return np.concatenate([real, np.stack([upper, upper.conj()], axis=1).ravel()])


def _in_pairs(s: NDArray) -> tuple[NDArray, NDArray]:
    """Return roots ``s`` (n, K) as exact pairs and real ones, and for which columns (K,) that worked."""
    across = np.abs(s[:, None] - s.conj())
    partner = across.argmin(axis=1)
    paired = (np.take_along_axis(partner, partner, axis=0) == np.arange(len(s))[:, None]).all(axis=0)
    return (s + np.take_along_axis(s, partner, axis=0).conj()) / 2, paired


def _real_form(nodes: NDArray) -> NDArray:
    """Return the unitary matrix that makes a diagonal one of nodes (reals, then pairs) real."""
    form = np.eye(nodes.size, dtype=complex)
    for i in range(int((nodes.imag == 0).sum()), nodes.size, 2):
        form[i : i + 2, i : i + 2] = np.array([[1, 1j], [1, -1j]]) / np.sqrt(2)
    return form
