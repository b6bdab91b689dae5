"""The ladder of models: how far a loop is from the axis on each rung."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from rlswaim.figures.style import COLORS

LOOKS = (("o", "rigid"), ("D", "corrected"), ("^", "mode 1"))


def draw_rungs(ax: Axes, rungs: Sequence[str], abscissas: Mapping[str, Sequence[float]]) -> Axes:
    """Draw largest real parts, one line a rung, the first rung above.

    Parameters
    ----------
    ax : Axes
    rungs : sequence of str
    abscissas : mapping of str to sequence of float
        Largest real part (1/s) on each rung, by name in the legend.

    Returns
    -------
    Axes
    """
    y = np.arange(len(rungs))[::-1]
    for (marker, color), (name, values) in zip(LOOKS, abscissas.items(), strict=False):
        ax.plot(values, y, marker, ms=7, mfc="none", mew=1.6, color=COLORS[color], label=name)
    ax.axvline(0.0, color=COLORS["neutral"], lw=0.9)
    ax.set_yticks(y, rungs)
    ax.set(xlabel="largest real part (1/s), a slow real root apart")
    ax.legend(fontsize=8, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    return ax
