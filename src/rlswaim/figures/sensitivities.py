"""How much each root moves with each coefficient, as a map."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm

from rlswaim.edition.conditioning import LoopInCoefficients, sensitivity
from rlswaim.source.tables import read_table


def draw_sensitivities(ax: Axes, loops: Mapping[str, LoopInCoefficients]) -> Axes:
    """Draw |c ds/dc| over |s| of each root of some ``loops`` but those at the origin, for each coefficient.

    Parameters
    ----------
    ax : Axes
    loops : mapping of str to LoopInCoefficients

    Returns
    -------
    Axes
    """
    rows, names = [], []
    for name, loop in loops.items():
        slopes = np.abs(sensitivity(loop))
        for k in np.flatnonzero((loop.roots.imag >= 0) & (np.abs(loop.roots) > 1e-9)):
            rows.append(slopes[k] / abs(loop.roots[k]))
            root = loop.roots[k]
            pair = f" ± j{root.imag:.4g}" if root.imag else ""
            names.append(f"{name}: {root.real:.4g}{pair}".replace("-", "−"))
    latex = [row["latex"] for row in read_table("coefficients")]
    shown = ax.pcolormesh(np.array(rows), norm=LogNorm(1e-3, 1e3), cmap="viridis", edgecolors="w", lw=0.3)
    ax.set_xticks(np.arange(len(latex)) + 0.5, [f"${symbol}$" for symbol in latex], rotation=90, fontsize=8)
    ax.set_yticks(np.arange(len(names)) + 0.5, names, fontsize=8)
    ax.invert_yaxis()
    ax.grid(False)
    ax.set(xlabel="coefficient of Eq. (38)", ylabel="root (1/s)")
    ax.figure.colorbar(shown, ax=ax, label="percent of |s| per percent of the coefficient", extend="min")
    return ax
