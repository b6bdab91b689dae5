"""Two paths beside each other: loci whose roots lie decades apart, and how Table 3 depends on readings."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rlswaim.edition.table_3_readings import Readings
from rlswaim.figures.loci import draw_poles, draw_printed_roots
from rlswaim.figures.style import COLORS
from rlswaim.rootlocus.locus import RootLocus


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


def draw_readings(ax: Axes, groups: Sequence[Sequence[Readings]], labels: Sequence[str]) -> Axes:
    """Draw which share of the readings stiffens both modes throughout, for each pair of Table 3.

    Parameters
    ----------
    ax : Axes
    groups : sequence of sequence of Readings
        One for each box of readings, all with the same pairs.
    labels : sequence of str
        What the boxes are.

    Returns
    -------
    Axes
    """
    width = 0.8 / len(groups)
    looks = (("mode 2", None), ("rigid", "//"), ("mode 1", ".."))
    for i, (group, label, (color, hatch)) in enumerate(zip(groups, labels, looks, strict=False)):
        x = np.array([r.nominal.case for r in group]) + (i - (len(groups) - 1) / 2) * width
        shares = [100 * r.rises / r.total for r in group]
        ax.bar(x, shares, width, color=COLORS[color], hatch=hatch, edgecolor="white", label=label)
        barred = [at for at, r in zip(x, group, strict=True) if r.barred]
        text = "none, exactly" if not i else None
        ax.plot(barred, np.zeros(len(barred)), "x", color=COLORS["printed"], ms=4, label=text, clip_on=False)
    ax.set(xlabel="case of Table 3", ylabel="readings that stiffen both modes (%)", ylim=(0, 100))
    ax.set_xticks([r.nominal.case for r in groups[0]])
    ax.grid(False, axis="x")
    ax.legend(ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1.0), fontsize=8)
    return ax
