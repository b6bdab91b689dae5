"""Designs beyond the report: forces over the stations, spreads of many draws, poles over the burn."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim.figures.style import COLORS

LOOKS = (("-", "rigid"), ("--", "mode 1"), ("-.", "mode 2"), (":", "actuator"))


def draw_forces(ax: Axes, stations: NDArray, forces: Mapping[str, NDArray]) -> Axes:
    """Draw the size of the jet's force that holds a degree of wind, over the jet's station.

    Parameters
    ----------
    ax : Axes
    stations : ndarray, shape (n,)
        In ft.
    forces : mapping of str to ndarray, shape (n,)
        In lb, with their sign, by vehicle.

    Returns
    -------
    Axes
    """
    for (style, color), (name, values) in zip(LOOKS, forces.items(), strict=False):
        ax.semilogy(stations, np.abs(values), style, color=COLORS[color], label=name)
    ax.set(xlabel="station of the jet (ft)", ylabel="force for one degree of wind (lb)", xlim=(0, 420))
    ax.legend(fontsize=8)
    return ax


def draw_spreads(ax: Axes, spreads: Mapping[str, tuple[float, ...]], xlabel: str) -> Axes:
    """Draw a range and its middle for each design.

    Parameters
    ----------
    ax : Axes
    spreads : mapping of str to tuple of float
        Low, middle, high and far end by design, all above 0.
    xlabel : str
        With its unit.

    Returns
    -------
    Axes
    """
    for at, (low, middle, high, far) in enumerate(spreads.values()):
        ax.plot([high, far], [at, at], color=COLORS["neutral"], lw=1.0)
        ax.plot([low, high], [at, at], color=COLORS["rigid"], lw=3.5, solid_capstyle="butt")
        ax.plot(middle, at, "o", color=COLORS["mode 1"], ms=5)
    ax.set_yticks(range(len(spreads)), list(spreads))
    ax.invert_yaxis()
    ax.set_xscale("log")
    ax.set_xlabel(xlabel)
    return ax


def draw_frozen_poles(ax: Axes, times: NDArray, poles: Mapping[str, NDArray]) -> Axes:
    """Draw the poles of loops frozen at many times, each time in its color.

    Parameters
    ----------
    ax : Axes
        Its limits are set.
    times : ndarray, shape (n,)
        In s.
    poles : mapping of str to ndarray of complex, shape (n, states)
        By design, two at most (1/s).

    Returns
    -------
    Axes
    """
    for marker, size, (name, found) in zip("o+", (9, 26), poles.items(), strict=False):
        at = np.repeat(times, found.shape[1])
        shown = ax.scatter(
            found.real.ravel(), found.imag.ravel(), c=at, marker=marker, s=size, cmap="viridis", lw=0.8
        )
        ax.plot([], [], marker, color="0.3", ls="", ms=4, label=name)
    ax.figure.colorbar(shown, ax=ax, label="time (s)")
    ax.axvline(0, color=COLORS["neutral"], lw=0.8)
    ax.set(xlabel="real part (1/s)", ylabel="imaginary part (1/s)")
    ax.legend(fontsize=8)
    return ax
