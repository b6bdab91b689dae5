"""The loop that one gain closes, cut open at that gain."""

from collections.abc import Callable

import control
import numpy as np

from rlswaim.source import checks

SECOND = 1e-9
"""Part of the gain's effect on the matrix that a second place of it may have: rounding."""


def cut_loop(closed_loop: Callable[[float], control.StateSpace], gain: float) -> control.StateSpace:
    """Return the open loop of a gain, with the gain in it, for negative feedback.

    The closed loop's matrix is affine in a gain that multiplies one signal, and what the gain adds to it has
    rank one: a column in which the signal enters times a row that makes the signal.

    Parameters
    ----------
    closed_loop : callable
        Returns the closed loop at a value of the gain.
    gain : float
        The gain that is in the open loop.

    Returns
    -------
    control.StateSpace
        L(s) with one input and one output: ``control.feedback(L)`` has the closed loop's poles.

    Raises
    ------
    ValueError
        If the gain is not finite, or multiplies more than one signal.
    TypeError
        If it is not a real number.
    """
    k = checks.real("gain", gain, "cut_loop")
    open_matrix = closed_loop(0.0).A
    columns, sizes, rows = np.linalg.svd(closed_loop(k).A - open_matrix)
    places = int(np.sum(sizes > SECOND * sizes[0]))
    if places > 1:
        raise ValueError(f"gain in cut_loop: got one that multiplies {places} signals, wanted one")
    return control.ss(open_matrix, columns[:, :1] * sizes[0], -rows[:1], 0)
