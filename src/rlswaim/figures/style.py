"""One look for every figure: colours, markers and the settings of the book's SVG."""

import matplotlib as mpl
from matplotlib_inline.backend_inline import set_matplotlib_formats

COLORS = {
    "rigid": "#0072B2",
    "mode 1": "#D55E00",
    "mode 2": "#009E73",
    "actuator": "#CC79A7",
    "jet": "#56B4E9",
    "printed": "#000000",
    "corrected": "#E69F00",
    "neutral": "#7F7F7F",
}
"""Okabe and Ito's colors, told apart by color-blind readers; a mode keeps its own in every figure."""


def use_book_style() -> None:
    """Draw the notebook's figures as SVG that is the same file at every run."""
    set_matplotlib_formats("svg", metadata={"Date": None, "Creator": None})
    mpl.rcParams.update(
        {
            "svg.hashsalt": "rlswaim",
            "svg.fonttype": "none",
            "figure.figsize": (7.0, 4.3),
            "font.size": 10,
            "font.family": "sans-serif",
            "axes.grid": True,
            "grid.alpha": 0.3,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "legend.frameon": False,
            "lines.linewidth": 1.6,
        }
    )
