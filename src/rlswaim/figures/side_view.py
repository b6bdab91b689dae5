"""Figure 1: the vehicle from the side, with its axes, surfaces and instruments, above its masses."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from rlswaim.figures.style import COLORS
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.stations import LENGTH

LIMITS = (-84.0, LENGTH + 62)
"""Stations between which the figure is drawn (ft)."""
BODY, NOSE, FINS = 13.0, 46.0, 34.0
"""Half the body's width, the payload's end, and the fins' reach: an outline of our own, not to scale."""
ROWS = {"gyros": ("^", "mode 1", 62), "linear sensors": ("D", "mode 2", 82), "jet": ("v", "jet", 102)}
"""Mark, color and height of each row of instruments."""
ROOM = 40.0
"""What a station's number needs beside its mark (ft); with less room it stands on the left."""
ARROW = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0}


def draw_side_view(ax: Axes, booster: Booster, instruments: Mapping[str, Sequence[float]]) -> Axes:
    """Draw the vehicle, nose to the left: outline, surfaces, axes, angles, and stations [Figure 1].

    Parameters
    ----------
    ax : Axes
    booster : Booster
    instruments : mapping of str to sequence of float
        Stations (ft) of ``"gyros"``, ``"linear sensors"`` and ``"jet"``.

    Returns
    -------
    Axes
    """
    _outline(ax, booster)
    _surfaces(ax, booster)
    _axes_and_angles(ax, booster)
    _lengths(ax, booster)
    for name, (mark, color, height) in ROWS.items():
        ax.text(LIMITS[0], height, name, va="center", fontsize="small")
        ax.plot(instruments[name], [height] * len(instruments[name]), mark, color=COLORS[color])
        lines = [at for row, (*_, top) in ROWS.items() if top >= height for at in instruments[row]]
        for station in instruments[name]:
            left = any(0 < at - station < ROOM for at in lines)
            side: dict[str, Any] = {"ha": "right" if left else "left", "va": "center"}
            ax.text(station + (-8 if left else 8), height, f"{station:g}", fontsize="small", **side)
            ax.plot([station] * 2, [0, height - 4], color=COLORS[color], linewidth=0.6, alpha=0.6, zorder=1)
    ax.set(xlim=LIMITS, ylim=(-76, 112))
    ax.set_axis_off()
    return ax


def _outline(ax: Axes, booster: Booster) -> None:
    """Draw payload, body, fins and nozzle; the body is divided where the masses of Table 1 change."""
    look: dict[str, Any] = {"edgecolor": COLORS["printed"], "linewidth": 1, "zorder": 2}
    payload = [(0, -2), (NOSE, -BODY), (NOSE, BODY), (0, 2)]
    body = [(NOSE, -BODY), (LENGTH, -BODY), (LENGTH, BODY), (NOSE, BODY)]
    ax.add_patch(Polygon(body, facecolor="#eeeeee", **look))
    ax.add_patch(Polygon(payload, facecolor="#cfe4f2", **look))
    for side in (1, -1):
        fin = [
            (LENGTH - 32, side * BODY),
            (LENGTH - 10, side * FINS),
            (LENGTH, side * FINS),
            (LENGTH, side * BODY),
        ]
        ax.add_patch(Polygon(fin, facecolor="#cfe4f2", **look))
    nozzle = [(LENGTH, -5), (LENGTH + 11, -9), (LENGTH + 11, 9), (LENGTH, 5)]
    ax.add_patch(Polygon(nozzle, facecolor="#eed5e4", **look))
    steps = np.flatnonzero(np.diff(booster.masses) > 0.5 * booster.masses[:-1])
    for at in (booster.stations[steps] + booster.stations[steps + 1]) / 2:
        ax.plot([at, at], [-BODY, BODY], color=COLORS["printed"], linewidth=1, zorder=3)


def _surfaces(ax: Axes, booster: Booster) -> None:
    """Draw the force that an angle of attack makes at each surface's center of pressure."""
    for surface in booster.surfaces:
        aft = surface.station > booster.l_CG
        start = FINS if aft else 9
        arrow = ARROW | {"color": COLORS["rigid"], "linewidth": 1.8}
        ax.annotate("", (surface.station, 52), (surface.station, start), arrowprops=arrow, zorder=4)
        name = f"{surface.name} at {surface.station:g}\n$C_{{N_\\alpha}}$ = {surface.C_Nalpha:g}/rad"
        where, side = (LENGTH - 36, "right") if aft else (4, "left")
        ax.text(where, -26, name, color=COLORS["rigid"], ha=side, va="center", fontsize="small")


def _axes_and_angles(ax: Axes, booster: Booster) -> None:
    """Draw the axes at the center of gravity, the pitch angle, the flow and the deflection of the thrust."""
    G, CG = booster.thrust_station, booster.l_CG
    black = ARROW | {"color": COLORS["printed"], "linewidth": 1.2}
    ax.plot([LIMITS[0] + 4, G + 56], [0, 0], color=COLORS["neutral"], linestyle=":", zorder=3)
    ax.plot(CG, 0, "P", color=COLORS["printed"], markersize=9, zorder=5)
    ax.text(CG + 7, -6, "CG", va="center", zorder=5)
    for tip, name, place in (((CG - 62, 0), "$x$", (CG - 70, 6)), ((CG, -36), "$z$", (CG - 9, -30))):
        ax.annotate("", tip, (CG, 0), arrowprops=black, zorder=4)
        ax.text(*place, name, ha="center", va="center", zorder=5)
    turn = ARROW | {"color": COLORS["rigid"], "connectionstyle": "arc3,rad=-.4"}
    ax.annotate("", (CG - 54, 17), (CG - 106, 17), arrowprops=turn)
    ax.text(CG - 80, 36, r"$\theta$, nose up", ha="center", va="center", color=COLORS["rigid"])
    flow = ARROW | {"color": COLORS["rigid"], "linewidth": 1.2}
    ax.annotate("", (-4, -3), (LIMITS[0] + 14, -27), arrowprops=flow)
    ax.text(LIMITS[0] + 3, -8, r"$\alpha$", color=COLORS["rigid"], va="center")
    ax.text(LIMITS[0], -36, r"air, $U$", color=COLORS["rigid"], va="center", fontsize="small")
    thrust = ARROW | {"color": COLORS["actuator"], "linewidth": 1.8}
    ax.annotate("", (G + 50, 17), (G + 11, 0), arrowprops=thrust, zorder=4)
    ax.text(G + 53, 8, r"$\delta$", color=COLORS["actuator"], va="center")
    ax.plot(G, 0, "o", color=COLORS["actuator"], markersize=5, zorder=5)
    ax.text(G + 16, -14, "G", color=COLORS["actuator"], va="center")


def _lengths(ax: Axes, booster: Booster) -> None:
    """Draw the lengths from the nose to the center of gravity and on to the thrust point."""
    CG, G = booster.l_CG, booster.thrust_station
    both = {"arrowstyle": "<|-|>", "shrinkA": 0, "shrinkB": 0, "color": COLORS["neutral"], "linewidth": 0.8}
    for start, end, name in ((0.0, CG, r"\ell_{CG}"), (CG, G, r"\ell_G")):
        ax.annotate("", (end, -52), (start, -52), arrowprops=both)
        ax.text((start + end) / 2, -63, f"${name}$ = {end - start:g} ft", ha="center", va="center")
    for at in (0.0, CG, G):
        ax.plot([at, at], [-57, -40], color=COLORS["neutral"], linewidth=0.8)


def draw_masses(ax: Axes, booster: Booster) -> Axes:
    """Draw the concentrated masses over the stations of `draw_side_view` [Figure 1, Table 1].

    Parameters
    ----------
    ax : Axes
    booster : Booster

    Returns
    -------
    Axes
    """
    ax.bar(booster.stations, booster.masses / 1000, width=14, color=COLORS["neutral"], alpha=0.6)
    ax.axvline(booster.l_CG, color=COLORS["printed"], linestyle="--", linewidth=1)
    ax.set(xlim=LIMITS, xlabel="station $\\ell$ (ft from the nose)", ylabel="mass (1000 slug)")
    ax.set_xticks(np.arange(0, LENGTH + 1, 60))
    return ax
