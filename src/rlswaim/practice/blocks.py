"""Blocks of real loops: gains, filters of first and second order, delays, each with its signal names."""

from collections.abc import Sequence
from typing import Any

import control
import numpy as np
from numpy.typing import ArrayLike

from rlswaim.source import checks


def gain(matrix: ArrayLike, **names: Any) -> control.StateSpace:
    """Return a block without states.

    Parameters
    ----------
    matrix : array_like, shape (outputs, inputs), or a number
    **names
        ``name``, ``inputs`` and ``outputs``, as `control.ss` takes them.

    Returns
    -------
    control.StateSpace
    """
    D = np.atleast_2d(np.asarray(matrix, dtype=float))
    return control.ss([], np.zeros((0, D.shape[1])), np.zeros((D.shape[0], 0)), D, **names)


def first_order(zeros: Sequence[float], poles: Sequence[float], **names: Any) -> control.StateSpace:
    """Return (b1 s + b0)/(a1 s + a0).

    Parameters
    ----------
    zeros, poles : sequence of float
        Coefficients, the highest power first; a numerator of one number has no zero.
    **names
        As in `gain`.

    Returns
    -------
    control.StateSpace
    """
    b1, b0 = ([0.0, *zeros])[-2:]
    a1, a0 = poles
    return control.ss([[-a0 / a1]], [[1.0]], [[b0 / a1 - a0 * b1 / a1**2]], [[b1 / a1]], **names)


def second_order(zeros: Sequence[float], poles: Sequence[float], **names: Any) -> control.StateSpace:
    """Return (b2 s^2 + b1 s + b0)/(a2 s^2 + a1 s + a0) with states of like size.

    Parameters
    ----------
    zeros, poles : sequence of float
        Coefficients, the highest power first; shorter numerators lack the high powers.
    **names
        As in `gain`.

    Returns
    -------
    control.StateSpace
    """
    b2, b1, b0 = ([0.0, 0.0, *zeros])[-3:]
    a2, a1, a0 = poles
    w = checks.positive("last over first coefficient of the poles", a0 / a2, "second_order") ** 0.5
    A = [[0.0, w], [-w, -a1 / a2]]
    C = [(b0 - a0 * b2 / a2) / (a2 * w), (b1 - a1 * b2 / a2) / a2]
    return control.ss(A, [[0.0], [1.0]], [C], [[b2 / a2]], **names)


def low_pass(omega: float, zeta: float, **names: Any) -> control.StateSpace:
    """Return w^2/(s^2 + 2 zeta w s + w^2): a low-pass, or the motion of an actuator or of a gyro.

    Parameters
    ----------
    omega : float
        Its corner w (rad/s); 0 leaves a wire.
    zeta : float
        Its damping ratio (1).
    **names
        As in `gain`.

    Returns
    -------
    control.StateSpace
    """
    if not omega:
        return gain(1.0, **names)
    return second_order([omega**2], [1.0, 2 * zeta * omega, omega**2], **names)


def notch(omega: float, zeta_zeros: float, zeta_poles: float, **names: Any) -> control.StateSpace:
    """Return (s^2 + 2 zeta_zeros w s + w^2)/(s^2 + 2 zeta_poles w s + w^2).

    Parameters
    ----------
    omega : float
        Its frequency w (rad/s), above 0.
    zeta_zeros, zeta_poles : float
        Damping ratios (1).
    **names
        As in `gain`.

    Returns
    -------
    control.StateSpace
    """
    zeros, poles = ([1.0, 2 * zeta * omega, omega**2] for zeta in (zeta_zeros, zeta_poles))
    return second_order(zeros, poles, **names)


def delay(seconds: float, order: int, **names: Any) -> control.StateSpace:
    """Return Pade's approximation of a delay; its error is all phase.

    Parameters
    ----------
    seconds : float
        The delay (s), above 0.
    order : int
        Of numerator and denominator, 1 or more.
    **names
        As in `gain`.

    Returns
    -------
    control.StateSpace
        In factors of second order at most, so that numbers of like size stand in its matrices.
    """
    checks.positive("seconds", seconds, "delay")
    if order < 1:
        raise ValueError(f"order in delay: got {order}, wanted 1 or more")
    poles = np.roots(control.pade(1.0, order)[1]) / seconds
    blocks = [gain((-1.0) ** order)]
    for pole in poles[poles.imag >= 0]:
        if pole.imag:
            square = [1.0, -2 * pole.real, abs(pole) ** 2]
            blocks.append(second_order([1.0, 2 * pole.real, abs(pole) ** 2], square))
        else:
            blocks.append(first_order([1.0, pole.real], [1.0, -pole.real]))
    return control.ss(control.series(*blocks), **names)
