"""Slow real roots, whose time constant outlasts the burn, and the abscissas that set them apart."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.source.tables import constants


def slow_bound() -> float:
    """Return the size (1/s) below which a real root is slow: its time constant is longer than the burn."""
    return 1 / constants("vehicle")["t_burn"]


def slow_roots(poles: NDArray) -> NDArray:
    """Return the slow real root (1/s) in each row of ``poles`` (S, n), nan where there is none."""
    nearest = np.take_along_axis(poles, np.abs(poles).argmin(axis=1)[:, None], axis=1)[:, 0]
    return np.where((nearest.imag == 0) & (np.abs(nearest) <= slow_bound()), nearest.real, np.nan)


def abscissas(poles: NDArray, apart: bool) -> NDArray:
    """Return the largest real part (1/s) in each row of poles, with or without a slow real pole.

    Parameters
    ----------
    poles : ndarray of complex, shape (S, n)
        In 1/s.
    apart : bool
        Whether a slow real root is left out.

    Returns
    -------
    ndarray, shape (S,)
    """
    at, slow = np.abs(poles).argmin(axis=1)[:, None], apart & ~np.isnan(slow_roots(poles))[:, None]
    return np.where(slow & (np.arange(poles.shape[1]) == at), -np.inf, poles.real).max(axis=1)
