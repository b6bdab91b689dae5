"""Figures 2 to 5: the vehicle's bent axis, its ascent and other histories, its mode shapes."""

from collections.abc import Mapping
from itertools import cycle

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from rlswaim.figures.style import COLORS, labelled
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.stations import LENGTH


def _along_the_vehicle(ax: Axes) -> Axes:
    ax.set_xlim(-8, LENGTH + 14)
    ax.set_xlabel("station $l$ (ft from the nose)")
    return ax


def draw_elastic_axis(
    ax: Axes, booster: Booster, q_1: float = 0.0, q_2: float = 0.0, theta: float = 0.0, delta: float = 0.0
) -> Axes:
    """Draw the bent elastic axis and the deflected exhaust [Figure 2].

    Parameters
    ----------
    ax : Axes
    booster : Booster
    q_1, q_2 : float
        The modes' coordinates (ft, up).
    theta, delta : float
        Pitch angle and thrust deflection (rad).

    Returns
    -------
    Axes
    """
    x = np.linspace(0, LENGTH, 421)

    def height(at: ArrayLike) -> NDArray:
        place = np.asarray(at, dtype=float)
        bent = q_1 * booster.modes[0].deflection(place) + q_2 * booster.modes[1].deflection(place)
        return np.asarray(theta * (booster.l_CG - place) + bent)

    G = booster.thrust_station
    slope = float(-theta - q_1 * booster.modes[0].slope(G) - q_2 * booster.modes[1].slope(G))
    ax.axhline(0, color=COLORS["neutral"], linestyle=":", label="undisturbed axis")
    rigid = theta * (booster.l_CG - x)
    ax.plot(x, rigid, color=COLORS["rigid"], linestyle="--", label=r"rigid axis, turned by $\theta$")
    ax.plot(x, height(x), color=COLORS["mode 1"], label="elastic axis")
    sizes = booster.masses / booster.masses.max()
    ax.scatter(booster.stations, height(booster.stations), s=160 * sizes, color=COLORS["neutral"], zorder=3)
    ax.plot(booster.l_CG, 0, "P", color=COLORS["printed"], markersize=9, zorder=4, label="center of gravity")
    start, reach = float(height(G)), 45.0
    for angle, style in ((slope, ":"), (slope + delta, "-")):
        ax.plot([G, G + reach], [start, start + reach * angle], color=COLORS["actuator"], linestyle=style)
    ax.text(G + reach, start + reach * (slope + delta), r" exhaust, $\delta$ up", color=COLORS["actuator"])
    ax.set_ylabel("displacement, up (ft)")
    ax.legend(loc="lower left", fontsize="small")
    _along_the_vehicle(ax).set_xlim(-8, LENGTH + 120)
    return ax


def draw_mode_shapes(ax: Axes, booster: Booster, slopes: bool = False) -> Axes:
    """Draw the deflections phi of up to three modes, or their slopes sigma, with their points [Figure 5].

    Parameters
    ----------
    ax : Axes
    booster : Booster
    slopes : bool
        Draw the slopes.

    Returns
    -------
    Axes
    """
    x = np.linspace(0, LENGTH, 421)
    for number, (mode, marker, style) in enumerate(
        zip(booster.modes, "os^", ("-", "--", "-."), strict=False), start=1
    ):
        symbol = rf"$\sigma_{number}$" if slopes else rf"$\phi_{number}$"
        at, points = (mode.slope_stations, mode.slopes) if slopes else (mode.stations, mode.deflections)
        curve = mode.slope(x) if slopes else mode.deflection(x)
        given = "assumed" if "assumed" in mode.name else "printed"
        color = COLORS.get(f"mode {number}", COLORS["actuator"])
        ax.plot(x, curve, style, color=color, label=f"{symbol}, least bending")
        ax.plot(at, points, marker, color=color, markeredgecolor="black", label=f"{symbol}, {given}")
    ax.axhline(0, color=COLORS["neutral"], linewidth=0.8)
    ax.set_ylabel(r"slope $\sigma=-d\phi/dl$ (1/ft)" if slopes else r"deflection $\phi$ (ft per ft of $q$)")
    ax.legend(ncols=2, fontsize="small")
    return _along_the_vehicle(ax)


def draw_history(
    ax: Axes,
    times: NDArray,
    curves: Mapping[str, NDArray],
    quantity: str,
    printed: tuple[float, float] | None = None,
) -> Axes:
    """Draw curves over the time, and one printed point [Figures 3, 4].

    Parameters
    ----------
    ax : Axes
    times : ndarray, shape (K,)
        s.
    curves : mapping of str to ndarray, shape (K,)
        By name.
    quantity : str
        What is drawn, with its unit.
    printed : tuple of float, optional
        A time (s) and the value that the report prints.

    Returns
    -------
    Axes
    """
    looks = cycle((("rigid", "-"), ("corrected", "--"), ("mode 2", "-."), ("actuator", ":")))
    for (name, values), (color, style) in zip(curves.items(), looks, strict=False):
        ax.plot(times, values, style, color=COLORS[color], label=labelled(name))
    if printed:
        ax.plot(
            *printed,
            "D",
            label=f"printed: {printed[1]:g} at {printed[0]:g} s",
            color=COLORS["printed"],
            linestyle="none",
        )
    ax.set_xlabel("time (s)")
    ax.set_ylabel(labelled(quantity))
    ax.legend(fontsize="small")
    return ax
