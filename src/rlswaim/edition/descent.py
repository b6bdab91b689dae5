"""Descents of a cost with kinks from many places of the unit cube at once.

The method is BFGS with a line search that asks for no more than a slope less steep, which Lewis and Overton
found to work where a function is smooth almost everywhere, but not at its minima.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

LESS, FLATTER = 1e-4, 0.5
"""Of a line search: what a step must bring of the foretold gain, and what may stay of the slope."""
TRIALS = 30
"""Steps along a line at most."""
FIRST, AGAIN = 0.05, 1e-3
"""Length of the first step of a descent, and of one that starts anew from a kink."""

Costs = Callable[[NDArray], tuple[NDArray, NDArray]]


class _Walk:
    """The state of all descents: places on angles, costs, slopes, inverse curvatures and lines."""

    def __init__(self, costs: Costs, start: NDArray) -> None:
        self.costs, self.x = costs, 2 / np.pi * np.arcsin(np.sqrt(start))
        self.f, self.g = self.at(self.x)
        n, count = start.shape
        self.B, self.d = np.zeros((n, n, count)), np.zeros((n, count))
        self.low, self.high, self.t = np.zeros(count), np.full(count, np.inf), np.ones(count)
        self.tried, self.fresh = np.zeros(count, int), np.ones(count, bool)
        self.renew(np.ones(count, bool), FIRST)

    def at(self, x: NDArray) -> tuple[NDArray, NDArray]:
        """Return costs and slopes on angles: u = sin(pi x/2)^2 leaves no bounds."""
        f, g = self.costs(np.sin(np.pi / 2 * x) ** 2)
        return f, g * np.pi / 2 * np.sin(np.pi * x)

    def renew(self, which: NDArray, length: float) -> None:
        """Forget the curvature of some descents, go straight downhill by a length."""
        n = len(self.x)
        size = np.maximum(np.linalg.norm(self.g[:, which], axis=0), 1e-12)
        self.B[:, :, which] = np.eye(n)[:, :, None] * length / size
        self.fresh[which] = True
        self.aim(which)

    def aim(self, which: NDArray) -> None:
        """Begin a new line."""
        self.d[:, which] = -np.einsum("ijs,js->is", self.B[:, :, which], self.g[:, which])
        self.low[which], self.high[which], self.t[which], self.tried[which] = 0, np.inf, 1, 0

    def curve(self, which: NDArray, s: NDArray, y: NDArray) -> None:
        """Update inverse curvatures by steps and changes of slope."""
        B, sy = self.B[:, :, which], (s * y).sum(axis=0)
        B = np.where(self.fresh[which], np.eye(len(s))[:, :, None] * sy / (y * y).sum(axis=0), B)
        By = np.einsum("ijs,js->is", B, y)
        outer = s[:, None] * By[None]
        ss = (1 + (y * By).sum(axis=0) / sy) / sy * s[:, None] * s[None]
        self.B[:, :, which] = B - (outer + outer.transpose(1, 0, 2)) / sy + ss

    def step(self) -> NDArray:
        """Try one place on every line; return which descents have come to their end."""
        x = self.x + self.t * self.d
        f, g = self.at(x)
        slope = (self.g * self.d).sum(axis=0)
        lower = f <= self.f + LESS * self.t * slope
        done = lower & ((g * self.d).sum(axis=0) >= FLATTER * slope)
        self.high[~lower] = self.t[~lower]
        self.low[lower & ~done] = self.t[lower & ~done]
        self.tried += 1
        narrow = self.high - self.low < 1e-14 * np.where(np.isfinite(self.high), self.high, 0)
        stuck = ~done & ((self.tried >= TRIALS) | narrow)
        s, y = x - self.x, g - self.g
        bent = done & ((s * y).sum(axis=0) > 1e-300)
        self.curve(bent, s[:, bent], y[:, bent])
        taken = done | (stuck & lower)
        self.x, self.g = np.where(taken, x, self.x), np.where(taken, g, self.g)
        self.f = np.where(taken, f, self.f)
        ended = stuck & ~taken & self.fresh
        self.fresh[done] = False
        going = ~taken & ~stuck
        half = (self.low + self.high) / 2
        self.t[going] = np.where(np.isfinite(half), half, 2 * self.low)[going]
        self.aim(done)
        uphill = done & ((self.g * self.d).sum(axis=0) >= 0)
        self.renew((stuck & ~ended) | uphill, AGAIN)
        return ended

    def keep(self, which: NDArray) -> None:
        """Go on with some descents alone."""
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                setattr(self, name, value[..., which])


def descended(
    costs: Costs, start: NDArray, rounds: int, enough: float = -np.inf
) -> tuple[NDArray, NDArray, int]:
    """Return where descents from many places end.

    Parameters
    ----------
    costs : callable
        Takes places as columns, shape (n, S); returns their costs, shape (S,), and slopes, shape (n, S).
    start : ndarray, shape (n, S)
        Places inside the unit cube.
    rounds : int
        Costs of each descent at most.
    enough : float
        A cost at which all end.

    Returns
    -------
    ndarray, shape (n, S)
    ndarray, shape (S,)
        The costs there.
    int
        The number of costs in all.
    """
    walk, alive = _Walk(costs, start), np.arange(start.shape[1])
    x, f, count = walk.x.copy(), walk.f.copy(), start.shape[1]
    for _ in range(rounds):
        ended = walk.step()
        x[:, alive], f[alive] = walk.x, walk.f
        count += alive.size
        walk.keep(~ended)
        alive = alive[~ended]
        if not alive.size or f.min() <= enough:
            break
    return np.sin(np.pi / 2 * x) ** 2, f, count
