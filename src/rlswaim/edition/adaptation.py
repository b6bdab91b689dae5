"""Evolution by adaptation of a covariance matrix (CMA-ES, Hansen and Ostermeier) in the unit cube.

It serves the searches as a second way beside differential evolution: its steps follow the narrow valleys
along which several roots stay equally far right, where an abscissa has no gradient.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

OUTSIDE = 10.0
"""Cost of the squared distance from the cube."""
PATIENCE = 120
"""Generations without a better place after which it ends."""


def adapted(
    cost: Callable[[NDArray], NDArray],
    start: NDArray,
    step: float,
    rng: np.random.Generator,
    rounds: int,
) -> tuple[NDArray, float]:
    """Return the best place that one evolution finds, and its cost.

    Parameters
    ----------
    cost : callable
        Takes places as columns, shape (n, S), and returns their costs, shape (S,).
    start : ndarray, shape (n,)
        Where the mean starts, in the unit cube.
    step : float
        Standard deviation at the start.
    rng : numpy.random.Generator
    rounds : int
        Generations at most.

    Returns
    -------
    ndarray, float
        The start itself where nothing better is found.
    """
    n, people = start.size, 4 * start.size + 16
    weights = np.log(people / 2 + 0.5) - np.log(np.arange(1, people // 2 + 1))
    weights /= weights.sum()
    mass = 1 / (weights**2).sum()
    c_path, c_step = (4 + mass / n) / (n + 4 + 2 * mass / n), (mass + 2) / (n + mass + 5)
    c_one = 2 / ((n + 1.3) ** 2 + mass)
    c_many = min(1 - c_one, 2 * (mass - 2 + 1 / mass) / ((n + 2) ** 2 + mass))
    usual = np.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n))
    C, path, step_path, mean = np.eye(n), np.zeros(n), np.zeros(n), start
    best, least, since = start, float(cost(start[:, None])[0]), 0
    for _ in range(rounds):
        axes = np.linalg.eigh(C)
        scale, B = np.sqrt(np.maximum(axes.eigenvalues, 1e-30)), axes.eigenvectors
        y = B @ (scale[:, None] * rng.standard_normal((n, people)))
        x = mean[:, None] + step * y
        inside = np.clip(x, 0, 1)
        costs = cost(inside)
        since += 1
        if costs.min() < least - 1e-9:
            since, best, least = 0, inside[:, costs.argmin()], float(costs.min())
        order = np.argsort(costs + OUTSIDE * ((x - inside) ** 2).sum(axis=0))[: people // 2]
        move = y[:, order] @ weights
        mean = mean + step * move
        step_path = (1 - c_step) * step_path + np.sqrt(c_step * (2 - c_step) * mass) * (
            B @ ((B.T @ move) / scale)
        )
        path = (1 - c_path) * path + np.sqrt(c_path * (2 - c_path) * mass) * move
        spread = (y[:, order] * weights) @ y[:, order].T
        C = (1 - c_one - c_many) * C + c_one * np.outer(path, path) + c_many * spread
        step *= np.exp(min(1.0, c_step / (1 + c_step) * (np.linalg.norm(step_path) / usual - 1)))
        if since > PATIENCE:
            break
    return best, least
