"""The ledger as a picture: how far each printed number is from ours."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import NullLocator

from rlswaim.edition.ledger import VERDICTS, Entry
from rlswaim.figures.style import COLORS

FLOOR = 1e-4
"""Smaller differences (percent), zero among them, are drawn at this value."""

MARKS = {
    "agrees": (".", COLORS["neutral"]),
    "rounding": ("o", COLORS["jet"]),
    "plot reading": ("s", COLORS["rigid"]),
    "misread or misprint": ("D", COLORS["actuator"]),
    "arithmetic slip": ("^", COLORS["mode 1"]),
    "carried over from a slip": ("v", COLORS["corrected"]),
    "not reproducible": ("x", COLORS["printed"]),
}
"""Marker and color of each verdict; the markers differ in shape as well."""


def draw_differences(ax: Axes, entries: Sequence[Entry]) -> Axes:
    """Draw the size of each entry's difference in percent, on a log scale, in the order of the report.

    Parameters
    ----------
    ax : Axes
    entries : sequence of Entry
        Those that print zero have no relative difference and are left out.

    Returns
    -------
    Axes
    """
    percent = np.array([abs(e.percent) for e in entries])
    for verdict in VERDICTS:
        marker, color = MARKS[verdict]
        at = np.array([i for i, e in enumerate(entries) if e.verdict == verdict and e.value], dtype=int)
        if at.size:
            ax.plot(at, np.maximum(percent[at], FLOOR), marker, color=color, ms=5, label=verdict)
    sections = [e.section for e in entries]
    starts = [i for i, s in enumerate(sections) if i == 0 or sections[i - 1] != s]
    for start in starts[1:]:
        ax.axvline(start - 0.5, color=COLORS["neutral"], lw=0.8)
    middles = [(a + b) / 2 for a, b in zip(starts, [*starts[1:], len(entries)], strict=True)]
    ax.set_xticks(middles, [sections[i] for i in starts])
    ax.xaxis.set_minor_locator(NullLocator())
    ax.tick_params(axis="x", length=0)
    ax.grid(False, axis="x")
    ax.set(yscale="log", xlim=(-3, len(entries) + 2))
    ax.set_xlabel("section of the report, numbers in its order")
    ax.set_ylabel("difference from the printed number (%)")
    return ax
