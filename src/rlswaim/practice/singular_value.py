"""An upper bound of the structured singular value for real factors that stand any number of times.

mu of M is one over the least size of real d_i for which det(I - M diag(d_i I)) = 0.  It is at most b if there
are Hermitian D_i > 0 and G_i with M* D M + j (G M - M* G) - b^2 D negative [Fan, Tits, Doyle 1991].  The
least such b^2 is the largest eigenvalue of the first two terms against D; a descent makes it small.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh
from scipy.optimize import minimize

EFFORT = {"maxiter": 120, "maxcor": 30}
"""Of each descent."""
EXACT = 1e12
"""Sharpness with which the smooth eigenvalue is the eigenvalue."""
SHARPNESS = (10.0, 50.0, 250.0)
"""Of the smooth largest eigenvalue, from round to sharp, in one over the value itself."""


class _Scales:
    """Hermitian blocks D = T T* (T lower triangular) and G, one for each factor, as a row of real numbers."""

    def __init__(self, sizes: tuple[int, ...]) -> None:
        self.sizes, self.ends = sizes, np.cumsum([0, *sizes])
        self.count = sum(r * r for r in sizes)
        self.identity = np.concatenate([np.eye(r).ravel() for r in sizes])

    def blocks(self, x: NDArray) -> list[NDArray]:
        """Return for r^2 real numbers a block each: real parts in and below the diagonal, imaginary above."""
        found, at = [], 0
        for r in self.sizes:
            square = x[at : at + r * r].reshape(r, r)
            found.append(np.tril(square) + 1j * np.triu(square, 1).T)
            at += r * r
        return found

    def whole(self, blocks: list[NDArray]) -> NDArray:
        """Return the block-diagonal matrix of some blocks."""
        found = np.zeros((self.ends[-1],) * 2, dtype=complex)
        for block, a, b in zip(blocks, self.ends, self.ends[1:], strict=False):
            found[a:b, a:b] = block
        return found

    def row(self, gradients: list[NDArray]) -> NDArray:
        """Return the gradient by the real numbers, from that by each complex block."""
        return np.concatenate(
            [(np.tril(g.real) + np.triu(np.tril(g.imag, -1).T, 1)).ravel() for g in gradients]
        )


def _smooth(M: NDArray, scales: _Scales, x: NDArray, sharp: float) -> tuple[float, NDArray]:
    """Return the smooth largest eigenvalue of M* D M + j (G M - M* G) against D, and its gradient.

    sharp bounds it from above by log(n)/sharp; the eigenvectors v count D v as 1.
    """
    T, H = scales.blocks(x[: scales.count]), scales.blocks(x[scales.count :])
    small = 1e-9
    D = scales.whole([t @ t.conj().T + small * np.eye(len(t)) for t in T])
    G = scales.whole([h + h.conj().T for h in H])
    left = M.conj().T @ D @ M + 1j * (G @ M - M.conj().T @ G)
    values: NDArray
    values, v = eigh((left + left.conj().T) / 2, D)
    top = values[-1]
    weights = np.exp(sharp * (values - top))
    smooth = float(top + np.log(weights.sum()) / sharp)
    weights /= weights.sum()
    Mv = M @ v
    dD = (Mv * weights) @ Mv.conj().T - (v * (weights * values)) @ v.conj().T
    dG = (Mv * weights) @ v.conj().T
    dG = 1j * (dG - dG.conj().T)
    D_row, G_row = [], []
    for t, a, b in zip(T, scales.ends, scales.ends[1:], strict=False):
        D_row.append(2 * dD[a:b, a:b] @ t)
        G_row.append(2 * dG[a:b, a:b])
    return smooth, np.concatenate([scales.row(D_row), scales.row(G_row)])


def _balanced(M: NDArray, scales: _Scales) -> NDArray:
    """Return M with each factor's rows and columns scaled by one number, so that their norms are alike."""
    for _ in range(30):
        for a, b in zip(scales.ends, scales.ends[1:], strict=False):
            into, out = float(np.linalg.norm(M[a:b])), float(np.linalg.norm(M[:, a:b]))
            share = np.sqrt(max(out, 1e-12) / max(into, 1e-12))
            weight = np.ones(len(M))
            weight[a:b] = share
            M = weight[:, None] * M / weight
    return M


def upper_bound(M: NDArray, sizes: tuple[int, ...]) -> float:
    """Return an upper bound of mu for real factors.

    Parameters
    ----------
    M : ndarray, shape (n, n), complex
    sizes : tuple of int
        How many columns each factor has, in order; of sum n.

    Returns
    -------
    float
        Any scales give a bound; those here are the best that a descent from the identity finds.
    """
    scales = _Scales(sizes)
    M = _balanced(M, scales)
    x = np.concatenate([scales.identity, np.zeros(scales.count)])
    best = _smooth(M, scales, x, EXACT)[0]
    for sharp in SHARPNESS:
        scale = sharp / max(abs(best), 1e-9)
        found = minimize(
            lambda y, k=scale: _smooth(M, scales, y, k), x, jac=True, method="L-BFGS-B", options=EFFORT
        )
        value = _smooth(M, scales, found.x, EXACT)[0]
        if value < best:
            best, x = value, found.x
    return float(np.sqrt(max(best, 0.0)))
