"""Abscissas of many closed loops and their slopes, for searches that go downhill.

The slope of a root is y dA x/(y x), x and y its eigenvectors of both sides.  What makes the searches' cost
jump is continued here without a jump, so that a descent comes back: gains beyond their bounds, and a slow
root that is no longer slow.
"""

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.search import OUT_OF_BOUNDS, Problem
from rlswaim.edition.slow_roots import slow_bound

H = 1e-6
"""Step of the differences that give the slope of a matrix; the slopes of its roots are exact."""
TOO_LARGE, TOO_FAST = 10.0, 100.0
"""Cost of a gain's logarithm beyond its bound (1/s), and of a slow root's size beyond its own."""


def _beyond(problem: Problem, gains: dict[str, NDArray]) -> NDArray:
    """Return the cost (1/s) of K_A and K_R beyond their bounds."""
    highs = {name: float(problem.rows[name]["high"]) for name in ("K_A", "K_R")}
    over = [np.log(np.maximum(np.abs(gains[n]) / high, 1)) for n, high in highs.items()]
    return TOO_LARGE * sum(over, start=np.zeros(()))


def _matrices(problem: Problem, u: NDArray) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Return matrices (S, m, m), their slopes (n, S, m, m), costs of gains (S,) and their slopes (n, S)."""
    n, count = u.shape
    places = np.repeat(u[:, None], 2 * n + 1, axis=1)
    for i in range(n):
        places[i, 2 * i + 1], places[i, 2 * i + 2] = np.minimum(u[i] + H, 1), np.maximum(u[i] - H, 0)
    width = np.array([places[i, 2 * i + 1] - places[i, 2 * i + 2] for i in range(n)])
    gains = problem.gains(places.reshape(n, -1))
    A = problem.loops.matrices(**gains)
    A = A.reshape(2 * n + 1, count, *A.shape[1:])
    over = np.broadcast_to(_beyond(problem, gains), places[0].size).reshape(2 * n + 1, count)
    return (
        A[0],
        (A[1::2] - A[2::2]) / width[..., None, None],
        over[0],
        (over[1::2] - over[2::2]) / width,
    )


def costs_and_slopes(problem: Problem, u: NDArray) -> tuple[NDArray, NDArray]:
    """Return the continued costs (1/s) at places of the cube, and their slopes.

    Parameters
    ----------
    problem : Problem
    u : ndarray, shape (n, S)

    Returns
    -------
    ndarray, shape (S,)
        The largest real part; by an objective ``apart`` that of all roots but the nearest to 0 if its size
        beyond `slow_bound`, times `TOO_FAST`, leaves a lesser sum.
    ndarray, shape (n, S)
    """
    A, slopes, over, over_slopes = _matrices(problem, u)
    bad = ~(np.isfinite(A).all(axis=(1, 2)) & np.isfinite(slopes).all(axis=(0, 2, 3)))
    A, slopes = np.where(bad[:, None, None], np.eye(A.shape[-1]), A), np.where(bad[:, None, None], 0, slopes)
    poles, right = np.linalg.eig(A)
    left = np.linalg.inv(right + 1e-14 * np.eye(A.shape[-1]))  # so that a multiple root has an inverse too
    at = np.arange(A.shape[0])

    def slope(k: NDArray) -> NDArray:
        return np.einsum("si,nsij,sj->ns", left[at, k], slopes, right[at, :, k])

    k = poles.real.argmax(axis=1)
    cost, down = poles.real[at, k], slope(k).real
    if problem.objective.endswith("apart"):
        near = np.abs(poles).argmin(axis=1)
        others = np.where(np.arange(A.shape[-1]) == near[:, None], -np.inf, poles.real)
        k, slow = others.argmax(axis=1), poles[at, near]
        fast = np.maximum(np.abs(slow) - slow_bound(), 0)
        size = (slow.conj() * slope(near)).real / np.maximum(np.abs(slow), 1e-300)
        apart = others[at, k] + TOO_FAST * fast
        down = np.where(apart < cost, slope(k).real + TOO_FAST * (fast > 0) * size, down)
        cost = np.minimum(cost, apart)
    cost, down = np.where(bad, OUT_OF_BOUNDS, cost + over), np.where(bad, 0, down + over_slopes)
    return cost, np.nan_to_num(down, posinf=0.0, neginf=0.0)
