"""Limits of performance: bounds over the stations, and what controllers reach beside them."""

from collections.abc import Mapping

from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim.figures.style import COLORS

LOOKS = (("-", "rigid"), ("--", "mode 1"), ("-.", "mode 2"), (":", "actuator"))


def draw_bounds(ax: Axes, stations: NDArray, bounds: Mapping[str, NDArray]) -> Axes:
    """Draw the least peak of the sensitivity over stations, on a logarithmic scale.

    Parameters
    ----------
    ax : Axes
    stations : ndarray, shape (n,)
        In ft.
    bounds : mapping of str to ndarray, shape (n,)
        By their name in the legend.

    Returns
    -------
    Axes
    """
    for (style, color), (name, values) in zip(LOOKS, bounds.items(), strict=False):
        ax.semilogy(stations, values, style, color=COLORS[color], label=name)
    ax.axhline(2.0, color=COLORS["corrected"], lw=1.2, ls=(0, (3, 3)), label="2, as is usually asked for")
    ax.set(xlabel="station (ft)", ylabel="least peak of |S|", xlim=(0, 420), ylim=(1, None))
    ax.legend(fontsize=8)
    return ax


def draw_sensitivities(ax: Axes, omega: NDArray, found: Mapping[str, tuple[NDArray, float]]) -> Axes:
    """Draw sensitivities over frequency, each with the least peak that any controller reaches.

    Parameters
    ----------
    ax : Axes
    omega : ndarray, shape (n,)
        In rad/s.
    found : mapping of str to (ndarray of shape (n,), float)
        |S| and the bound of its peak, by what is measured.

    Returns
    -------
    Axes
    """
    for (style, color), (name, (size, bound)) in zip(LOOKS, found.items(), strict=False):
        ax.loglog(omega, size, style, color=COLORS[color], label=name)
        ax.axhline(bound, color=COLORS[color], lw=0.7, ls=style)
    ax.set(xlabel="frequency (rad/s)", ylabel="|S|", xlim=(omega[0], omega[-1]))
    ax.legend(fontsize=8)
    return ax
