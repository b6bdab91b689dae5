"""Grids behind poles and root loci: equal damping ratio and natural frequency, in s and in z."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim.figures.style import COLORS


def draw_damping_grid(ax: Axes, zetas: Sequence[float] = (0.2, 0.5, 0.8)) -> Axes:
    """Draw rays of equal damping ratio over the left half plane.

    Parameters
    ----------
    ax : Axes
        Its limits are set, and stay.
    zetas : sequence of float
        The damping ratios.

    Returns
    -------
    Axes
    """
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    reach = np.hypot(left, top)
    for zeta in zetas:
        x, y = -zeta * reach, np.sqrt(1 - zeta**2) * reach
        ax.plot([0, x], [0, y], color=COLORS["neutral"], lw=0.6, ls=(0, (2, 3)), zorder=0)
        inside = min(left / x, top / y) * 0.93
        ax.text(x * inside, y * inside, rf"$\zeta$ = {zeta:g}", fontsize=7, color=COLORS["neutral"])
    ax.axhline(0, color="0.4", lw=0.6, zorder=0)
    ax.axvline(0, color="0.4", lw=0.6, zorder=0)
    ax.set(xlim=(left, right), ylim=(bottom, top))
    return ax


def draw_z_grid(
    ax: Axes, zetas: Sequence[float] = (0.2, 0.5, 0.8), parts: Sequence[float] = (0.25, 0.5, 0.75)
) -> Axes:
    """Draw the unit circle, and within it curves of equal damping ratio and of equal natural frequency.

    They are the images of rays and circles in s by z = exp(s T).  python-control's ``zgrid`` sets limits and
    opens a figure of its own, so it does not serve here.

    Parameters
    ----------
    ax : Axes
        Its limits are set, and stay.
    zetas : sequence of float
        The damping ratios.
    parts : sequence of float
        The natural frequencies, times T/pi (T is the sampling period).

    Returns
    -------
    Axes
    """
    limits, turn = (ax.get_xlim(), ax.get_ylim()), np.linspace(0, np.pi, 121)
    label: dict[str, Any] = {"fontsize": 7, "color": COLORS["neutral"], "clip_on": True}
    curves: list[tuple[NDArray, Any]] = [(np.exp(1j * turn), "-")]
    for zeta in zetas:
        curve = np.exp(turn * (1j - zeta / np.sqrt(1 - zeta**2)))
        curves.append((curve, (0, (2, 3))))
        at = curve[30]
        ax.text(at.real, at.imag, rf"$\zeta$ = {zeta:g}", **label)
    for part in parts:
        curves.append((np.exp(part * np.pi * np.exp(0.5j * (np.pi + turn))), (0, (1, 3))))
        at = 1.03 * np.exp(1j * np.pi * part)
        ax.text(at.real, at.imag, rf"{part:g} $\pi/T$", ha="right" if part > 0.5 else "left", **label)
    for curve, style in curves:
        both = np.concatenate([curve.conj()[::-1], curve])
        ax.plot(both.real, both.imag, color=COLORS["neutral"], lw=0.6, ls=style, zorder=0)
    ax.axhline(0, color="0.4", lw=0.6, zorder=0)
    ax.set(xlim=limits[0], ylim=limits[1])
    return ax
