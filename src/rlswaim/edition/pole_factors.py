"""The least abscissa near a closed loop, with the factors of its polynomial among the unknowns.

At the best loops several pairs of roots meet, and there an abscissa falls like a root of the gains' change:
a search by gains alone stalls.  With quadratic factors (s - sigma)^2 - kappa as unknowns beside the gains,
and their product as equations, all is smooth: minimize t with sigma <= t and kappa <= (t - sigma)^2.
"""

from functools import lru_cache, reduce
from math import prod

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from rlswaim.edition.search import Problem
from rlswaim.edition.slow_roots import slow_bound
from rlswaim.loops.control_systems import ControlSystem
from rlswaim.loops.multiaffine import Term
from rlswaim.vehicle.equations import PerturbationEquations

H = 1e-6
"""Step of the differences by the gains."""
TRIES, ROUNDS = 2, 60
"""Fresh starts from where the last ended, and rounds of each."""
MET = 1e-9
"""Largest relative difference of coefficients that ends the tries."""
SLOW = 0.9999
"""Part of `slow_bound` that a slow root may use, so that rounding does not lose it."""


def _quadratics(poles: NDArray) -> tuple[NDArray, NDArray, list[float]]:
    """Return sigmas and kappas of factors of two poles each, and the fastest pole if one is left."""
    pairs, real = poles[poles.imag > 0], np.sort(poles.real[poles.imag == 0])
    left = [float(x) for x in real[: real.size % 2]]
    first, second = real[len(left) :: 2], real[len(left) + 1 :: 2]
    sigma = np.concatenate([pairs.real, (first + second) / 2])
    return sigma, np.concatenate([-(pairs.imag**2), ((second - first) / 2) ** 2]), left


@lru_cache(maxsize=8)
def _terms(system: ControlSystem, eqs: PerturbationEquations) -> tuple[Term, ...]:
    return system.polynomial(eqs).terms


def _product(factors: list[NDArray]) -> NDArray:
    return reduce(np.convolve, factors, np.ones(1))


class _Factored:
    """One local problem.

    Its unknowns are the place u, sigma/w and kappa/w^2 of each factor, the real pole without a partner over
    its size at the start, the slow root over its bound if one is set apart, and t.
    """

    def __init__(self, problem: Problem, u: NDArray) -> None:
        self.problem, self.n = problem, u.size
        poles = np.linalg.eigvals(problem.loops.matrices(**problem.gains(u[:, None])))[0]
        near = np.abs(poles).argmin()
        self.slow = problem.objective.endswith("apart") and poles[near].imag == 0
        sigma, kappa, left = _quadratics(np.delete(poles, near) if self.slow else poles)
        self.m, self.w, size = sigma.size, np.sqrt(sigma**2 + np.abs(kappa)) + 1e-9, slow_bound()
        single = [*left, *([np.clip(poles[near].real, -size, size)] if self.slow else [])]
        self.units = np.array([*(abs(x) for x in left), *([size] if self.slow else [])])
        self.free = len(left)
        t = max([*(sigma + np.sqrt(np.maximum(kappa, 0))), *left])
        self.start = np.concatenate([u, sigma / self.w, kappa / self.w**2, single / self.units, [t]])
        ones = [np.array([w * w, 2 * w, 1]) for w in self.w] + [np.array([x, 1]) for x in self.units]
        self.scale = _product(ones)[:-1]

    def coefficients(self, u: NDArray) -> NDArray:
        """Return the polynomials' coefficients over their scale at places of the cube, shape (S, order)."""
        loops, one = self.problem.loops, np.ones(u.shape[1])
        given = loops.factors(**self.problem.gains(np.clip(u, 0, 1)))
        terms = _terms(loops.system, self.problem.eqs)
        weights = np.array([one * prod(given[name] for name in term.factors) for term in terms])
        return weights.T @ np.array([term.coefficients[:-1] for term in terms]) / self.scale

    def factors(self, x: NDArray) -> list[NDArray]:
        """Return the factors at the unknowns."""
        n, m, w = self.n, self.m, self.w
        sigma, kappa, rest = x[n : n + m] * w, x[n + m : n + 2 * m] * w**2, x[n + 2 * m : -1] * self.units
        pairs = [np.array([s * s - k, -2 * s, 1.0]) for s, k in zip(sigma, kappa, strict=True)]
        return pairs + [np.array([-r, 1.0]) for r in rest]

    def difference(self, x: NDArray) -> NDArray:
        """Return the product of the factors less the loop's polynomial."""
        return _product(self.factors(x))[:-1] / self.scale - self.coefficients(x[: self.n, None])[0]

    def slopes(self, x: NDArray) -> NDArray:
        """Return the slopes of `difference`, shape (order, unknowns)."""
        n, m, order, factors = self.n, self.m, self.scale.size, self.factors(x)
        J, u = np.zeros((x.size, order + 1)), np.clip(x[:n], 0, 1)[:, None]
        up, down = np.minimum(u + H * np.eye(n), 1), np.maximum(u - H * np.eye(n), 0)
        both = self.coefficients(np.hstack([up, down]))
        J[:n, :-1] = -(both[:n] - both[n:]) * self.scale / np.diag(up - down)[:, None]
        for i, factor in enumerate(factors):
            rest = _product(factors[:i] + factors[i + 1 :])
            if i < m:
                by_sigma = np.convolve(rest, [-factor[1], -2.0])
                J[n + i, : by_sigma.size] = by_sigma * self.w[i]
                J[n + m + i, : rest.size] = -rest * self.w[i] ** 2
            else:
                J[n + m + i, : rest.size] = -rest * self.units[i - m]
        return J[:, :-1].T / self.scale[:, None]

    def room(self, x: NDArray) -> NDArray:
        """Return what must not be negative: t beyond each factor's roots."""
        n, m = self.n, self.m
        off, kappa = x[-1] / self.w - x[n : n + m], x[n + m : n + 2 * m]
        rest = x[-1] / self.units[: self.free] - x[n + 2 * m :][: self.free]
        return np.concatenate([off, off * off - kappa, rest])

    def room_slopes(self, x: NDArray) -> NDArray:
        """Return the slopes of `room`."""
        n, m = self.n, self.m
        off, at = x[-1] / self.w - x[n : n + m], np.arange(m)
        J = np.zeros((2 * m + self.free, x.size))
        J[at, n + at], J[:m, -1] = -1, 1 / self.w
        J[m + at, n + at], J[m + at, n + m + at], J[m : 2 * m, -1] = -2 * off, -1, 2 * off / self.w
        for i in range(self.free):
            J[2 * m + i, n + 2 * m + i], J[2 * m + i, -1] = -1, 1 / self.units[i]
        return J

    def settled(self) -> tuple[NDArray, float]:
        """Return the place of the least t that is found, and how far the product is off."""
        e = np.zeros(self.start.size)
        e[-1] = 1
        free = [(None, None)] * (2 * self.m + self.free)
        slow = [(-SLOW, SLOW)] if self.slow else []
        found = minimize(
            lambda x: x[-1],
            self.start,
            jac=lambda x: e,
            method="SLSQP",
            bounds=[(0, 1)] * self.n + free + slow + [(None, None)],
            constraints=[
                {"type": "eq", "fun": self.difference, "jac": self.slopes},
                {"type": "ineq", "fun": self.room, "jac": self.room_slopes},
            ],
            options={"maxiter": ROUNDS, "ftol": 1e-9},
        )
        return np.clip(found.x[: self.n], 0, 1), float(np.abs(self.difference(found.x)).max())


def settled(problem: Problem, u: NDArray) -> NDArray:
    """Return the place with the least abscissa that is found downhill of a place; that one if none is.

    Parameters
    ----------
    problem : Problem
        No pair is held.
    u : ndarray, shape (n,)

    Returns
    -------
    ndarray, shape (n,)
    """
    places, off = [u], np.inf
    for _ in range(TRIES):
        if off > MET and np.isfinite(places[-1]).all():
            place, off = _Factored(problem, places[-1]).settled()
            places.append(place)
    tried = np.nan_to_num(np.array(places).T, nan=0.5)
    return np.asarray(tried[:, problem.cost(tried).argmin()])
