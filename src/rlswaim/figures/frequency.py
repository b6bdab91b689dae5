"""Open loops over frequency, and how far from the axis a loop's roots are as one thing varies."""

from collections.abc import Mapping

import control
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim.figures.style import COLORS

LOOKS = (("-", "rigid"), ("--", "mode 1"), ("-.", "mode 2"), (":", "actuator"))


def draw_bode(gain: Axes, phase: Axes, omega: NDArray, loops: Mapping[str, control.StateSpace]) -> Axes:
    """Draw size and phase of open loops over frequency.

    Parameters
    ----------
    gain, phase : Axes
        One above the other.
    omega : ndarray, shape (n,)
        In rad/s, increasing.
    loops : mapping of str to control.StateSpace
        With one input and one output each, by their name in the legend.

    Returns
    -------
    Axes
        That of the phase.
    """
    for (style, color), (name, loop) in zip(LOOKS, loops.items(), strict=False):
        found = control.frequency_response(loop, omega)
        size, angle = found.magnitude.ravel(), np.degrees(np.unwrap(found.phase.ravel()))
        angle -= 360 * np.round((angle[angle.size // 2] + 180) / 360)  # near -180 deg in the middle
        gain.semilogx(omega, 20 * np.log10(size), style, color=COLORS[color], label=name)
        phase.semilogx(omega, angle, style, color=COLORS[color])
    gain.axhline(0.0, color=COLORS["neutral"], lw=0.8)
    phase.axhline(-180.0, color=COLORS["neutral"], lw=0.8)
    gain.set(ylabel="|L| (dB)", xlim=(omega[0], omega[-1]))
    phase.set(ylabel="phase of L (deg)", xlabel="frequency (rad/s)", xlim=(omega[0], omega[-1]))
    gain.legend(fontsize=8)
    return phase


def draw_abscissas(ax: Axes, values: NDArray, abscissas: Mapping[str, NDArray], what: str) -> Axes:
    """Draw the largest real part of loops as something varies.

    Parameters
    ----------
    ax : Axes
    values : ndarray, shape (n,)
        What varies.
    abscissas : mapping of str to ndarray, shape (n,)
        Largest real parts (1/s), by their name in the legend.
    what : str
        The label of ``values``, with its unit.

    Returns
    -------
    Axes
    """
    for (style, color), (name, found) in zip(LOOKS, abscissas.items(), strict=False):
        ax.plot(values, found, style, color=COLORS[color], label=name)
    ax.axhline(0.0, color=COLORS["neutral"], lw=0.8)
    ax.set(xlabel=what, ylabel="largest real part (1/s)", xlim=(values[0], values[-1]))
    ax.legend(fontsize=8)
    return ax
