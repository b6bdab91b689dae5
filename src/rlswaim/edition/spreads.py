"""How the searches spread a parameter over the unit interval, by its row of a table of bounds."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray


def spread(row: Mapping[str, str], u: NDArray) -> NDArray:
    """Return the values of one parameter at ``u`` in 0..1, spread evenly, in the logarithm or in arcsinh.

    Parameters
    ----------
    row : mapping of str to str
        The parameter's row, of ``data/search_bounds.csv`` for instance.
    u : ndarray
        Places between the lower bound, 0, and the upper one, 1.
    """
    low, high, spread = float(row["low"]), float(row["high"]), row["spread"]
    if spread == "even":
        return low + (high - low) * u
    if spread == "log":
        return low * (high / low) ** u
    return float(spread) * np.sinh((2 * u - 1) * np.arcsinh(high / float(spread)))


def place(row: Mapping[str, str], value: float) -> float:
    """Return where in 0..1 `spread` has a value of one parameter.

    Parameters
    ----------
    row : mapping of str to str
        The parameter's row, of ``data/search_bounds.csv`` for instance.
    value : float
    """
    low, high, spread = float(row["low"]), float(row["high"]), row["spread"]
    if spread == "even":
        return (value - low) / (high - low)
    if spread == "log":
        return float(np.log(value / low) / np.log(high / low))
    return float((np.arcsinh(value / float(spread)) / np.arcsinh(high / float(spread)) + 1) / 2)
