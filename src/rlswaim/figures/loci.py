"""Root loci: branches, open-loop poles and zeros, closed-loop roots, the report's roots."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from rlswaim.figures.pole_grids import draw_damping_grid, draw_z_grid
from rlswaim.figures.style import COLORS, labelled
from rlswaim.loops.named_branches import NamedLocus
from rlswaim.rootlocus.locus import RootLocus

STYLES = {"rigid": "-", "mode 1": "--", "mode 2": "-.", "actuator": ":", "jet": (0, (5, 1, 1, 1, 1, 1))}
"""A line style for each part, so that a locus can be read without its colors."""

PART_NAMES = {"rigid": "rigid body", "mode 1": "first mode", "mode 2": "second mode"}

Window = tuple[float, float, float, float]


def draw_poles(ax: Axes, poles: ArrayLike, label: str, marker: str = "s", color: str = "0.15") -> Axes:
    """Mark poles.

    Parameters
    ----------
    ax : Axes
    poles : array_like of complex, shape (n,)
        1/s.
    label : str
        For the legend.
    marker, color : str
        As matplotlib names them.

    Returns
    -------
    Axes
    """
    at = np.asarray(poles, dtype=complex)
    ax.plot(at.real, at.imag, marker, ms=5.5, mfc="white", mec=color, mew=1.4, ls="", label=label, zorder=4)
    return ax


def draw_printed_roots(ax: Axes, roots: ArrayLike, label: str = "printed in the report") -> Axes:
    """Mark roots that the report prints, and their conjugates.

    Parameters
    ----------
    ax : Axes
    roots : array_like of complex, shape (n,)
        One of each pair (1/s).
    label : str
        For the legend.

    Returns
    -------
    Axes
    """
    at = np.asarray(roots, dtype=complex)
    both = np.concatenate([at, at[at.imag != 0].conj()])
    ax.plot(both.real, both.imag, "D", ms=9, mfc="none", mec=COLORS["printed"], ls="", label=label, zorder=5)
    return ax


def _arrow(ax: Axes, branch: NDArray, color: str, window: Window) -> None:
    """Draw an arrow in the direction of rising gain, halfway along the visible part of one branch."""
    left, right, bottom, top = window
    seen = (
        (branch.real > left) & (branch.real < right) & (branch.imag >= max(bottom, 0)) & (branch.imag < top)
    )
    length = np.cumsum(np.abs(np.diff(branch)) * (seen[1:] & seen[:-1]))
    if not length.size or length[-1] < 0.04 * (right - left):
        return
    i = int(np.searchsorted(length, length[-1] / 2))
    while i > 0 and abs(branch[i + 1] - branch[i]) < 1e-3 * (right - left):
        i -= 1
    a, b = branch[i], branch[i + 1]
    ax.annotate(
        "", (b.real, b.imag), (a.real, a.imag), arrowprops={"arrowstyle": "-|>", "color": color, "lw": 1.2}
    )


def draw_root_locus(
    ax: Axes, locus: RootLocus, window: Window, parts: Mapping[str, Sequence[int]] | None = None
) -> Axes:
    """Draw a root locus with its open-loop poles and zeros and arrows for rising gain.

    Behind it are rays of equal damping ratio, or a discrete loop's unit circle with its curves in z.

    Parameters
    ----------
    ax : Axes
    locus : RootLocus
        Its first gain is 0.
    window : tuple of float
        Left, right, bottom and top of the picture (1/s; in z without unit).
    parts : mapping of str to sequence of int, optional
        Which branches (columns of ``locus.roots``) start from the rigid body, a mode, the actuator.

    Returns
    -------
    Axes
    """
    part_of = {j: name for name, columns in (parts or {}).items() for j in columns}
    for j, branch in enumerate(locus.roots.T):
        name = part_of.get(j, "neutral")
        ax.plot(branch.real, branch.imag, color=COLORS[name], ls=STYLES.get(name, "-"), zorder=2)
        _arrow(ax, branch, COLORS[name], window)
    for name in parts or {}:
        ax.plot([], [], color=COLORS[name], ls=STYLES[name], label=f"from the {PART_NAMES.get(name, name)}")
    ax.plot(locus.poles.real, locus.poles.imag, "kx", ms=7, mew=1.5, label="open-loop poles", zorder=3)
    ax.plot(locus.zeros.real, locus.zeros.imag, "ko", ms=7, mfc="none", label="open-loop zeros", zorder=3)
    unit = "of z" if locus.discrete else "(1/s)"
    ax.set(xlim=window[:2], ylim=window[2:], xlabel=f"real part {unit}", ylabel=f"imaginary part {unit}")
    return draw_z_grid(ax) if locus.discrete else draw_damping_grid(ax)


def draw_ill_determined(ax: Axes, locus: RootLocus, limit: float = 1e3) -> Axes:
    """Mark the roots that a small change of the coefficients moves far.

    Parameters
    ----------
    ax : Axes
    locus : RootLocus
    limit : float
        Roots with a larger condition number are marked.

    Returns
    -------
    Axes
    """
    at = locus.roots[locus.condition > limit]
    ax.plot(at.real, at.imag, "o", ms=11, mfc="0.6", mec="none", alpha=0.5, ls="", label="ill-determined")
    return ax


def draw_named_locus(ax: Axes, named: NamedLocus, window: Window, label: str) -> Axes:
    """Draw a locus with names, and the closed-loop poles at its end.

    Parameters
    ----------
    ax : Axes
    named : NamedLocus
    window : tuple of float
        As in `draw_root_locus`.
    label : str
        Of the poles.

    Returns
    -------
    Axes
    """
    draw_root_locus(ax, named.locus, window, named.parts)
    return draw_poles(ax, named.poles, label)


def draw_far_locus(ax: Axes, locus: RootLocus, closed: ArrayLike, printed: ArrayLike) -> Axes:
    """Draw a locus on axes that are linear to 1 1/s and logarithmic beyond.

    Parameters
    ----------
    ax : Axes
    locus : RootLocus
        Its first gain is 0.
    closed, printed : array_like of complex
        Roots where the loop is closed, computed and as the report prints them (1/s).

    Returns
    -------
    Axes
    """
    for branch in locus.roots.T:
        ax.plot(branch.real, branch.imag, color=COLORS["neutral"], zorder=2)
    ax.plot(locus.poles.real, locus.poles.imag, "kx", ms=7, mew=1.5, label="open-loop poles", zorder=3)
    draw_poles(ax, closed, "closed loop, computed")
    draw_printed_roots(ax, printed)
    ax.axvline(0, color="0.4", lw=0.6, zorder=0)
    ax.set_xscale("symlog", linthresh=1.0)
    ax.set_yscale("symlog", linthresh=1.0)
    ax.set(xlim=(-1e9, 1e4), ylim=(-0.15, 300), xlabel="real part (1/s)", ylabel="imaginary part (1/s)")
    ax.set_xticks([-1e8, -1e6, -1e4, -1e2, 0, 1e2, 1e4])
    return ax


def draw_pole_paths(ax: Axes, locus: RootLocus, parameter: str) -> Axes:
    """Draw each path of a pole: a circle where it starts, a cross where it ends.

    Parameters
    ----------
    ax : Axes
    locus : RootLocus
        Its ``gains`` are the values of the parameter.
    parameter : str
        Its symbol, for the legend.

    Returns
    -------
    Axes
    """
    for path in locus.roots.T[np.argsort(abs(locus.roots[0].imag), kind="stable")]:
        order = np.searchsorted([0.5, 2.0], abs(path[0].imag))
        color, style = (COLORS["rigid"], COLORS["mode 1"], COLORS["mode 2"])[order], ("-", "--", "-.")[order]
        ax.plot(path.real, path.imag, style, color=color)
        ax.plot(path[0].real, path[0].imag, "o", color=color, markerfacecolor="none", markersize=8)
        ax.plot(path[-1].real, path[-1].imag, "x", color=color, markersize=8)
    for name, (color, style) in {
        "rigid body": ("rigid", "-"),
        "mode 1": ("mode 1", "--"),
        "mode 2": ("mode 2", "-."),
    }.items():
        ax.plot([], [], style, color=COLORS[color], label=name)
    ax.plot(
        [],
        [],
        "o",
        color="black",
        markerfacecolor="none",
        linestyle="none",
        label=f"{parameter} = {locus.gains[0]:g}",
    )
    ax.plot([], [], "x", color="black", linestyle="none", label=f"{parameter} = {locus.gains[-1]:g}")
    ax.axvline(0, color=COLORS["neutral"], linewidth=0.8)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (rad/s)")
    ax.legend(fontsize="small")
    return ax


def draw_over(ax: Axes, x: ArrayLike, curves: Mapping[str, ArrayLike], xlabel: str, ylabel: str) -> Axes:
    """Draw named curves.

    Parameters
    ----------
    ax : Axes
    x : array_like, shape (K,)
    curves : mapping of str to array_like, shape (K,)
        By name; a part of the vehicle keeps its color.
    xlabel, ylabel : str
        With units.

    Returns
    -------
    Axes
    """
    others = ("printed", "corrected", "jet", "neutral")
    for i, (name, y) in enumerate(curves.items()):
        color = COLORS.get(name, COLORS[others[i % 4]])
        ax.plot(x, y, ("-", "--", "-.", ":")[i % 4], color=color, label=labelled(PART_NAMES.get(name, name)))
    ax.axhline(0, color="0.4", lw=0.6)
    ax.set(xlabel=labelled(xlabel), ylabel=labelled(ylabel))
    ax.legend()
    return ax
