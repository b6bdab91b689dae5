"""A root locus that is redrawn in a kernel: axes and artists stay, only the data change."""

from itertools import cycle
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from numpy.typing import NDArray

from rlswaim.figures.style import COLORS
from rlswaim.rootlocus.locus import RootLocus
from rlswaim.source import checks


class LocusPicture:
    """A root locus on axes whose limits, ticks and labels stay as they are.

    The axes are drawn once; each `update` puts the branches over that picture.

    Parameters
    ----------
    ax : Axes
        On an Agg canvas, as the inline, widget and Qt or Tk Agg backends have.
    locus : RootLocus
        The first one; later ones have as many branches.
    """

    def __init__(self, ax: Axes, locus: RootLocus) -> None:
        self.ax = ax
        self.canvas = checks.instance("canvas", ax.figure.canvas, FigureCanvasAgg, "LocusPicture")
        ax.set(xlabel="real part (1/s)", ylabel="imaginary part (1/s)")
        colors = cycle(COLORS.values())
        styles: list[dict[str, Any]] = [{"color": next(colors)} for _ in locus.roots.T]
        styles += [{"color": "k", "marker": marker, "mfc": "none", "ls": ""} for marker in "xo"]
        self.artists = [ax.plot([], [], animated=True, **style)[0] for style in styles]
        self.canvas.draw()
        self.background = self.canvas.copy_from_bbox(ax.figure.bbox)
        self.update(locus)

    def update(self, locus: RootLocus) -> Axes:
        """Draw another locus in place of the last; ValueError if it has another number of branches."""
        if locus.roots.shape[1] + 2 != len(self.artists):
            raise ValueError(
                f"LocusPicture: got {locus.roots.shape[1]} branches, wanted {len(self.artists) - 2}"
            )
        self.canvas.restore_region(self.background)
        points: list[NDArray] = [*locus.roots.T, locus.poles, locus.zeros]
        for artist, at in zip(self.artists, points, strict=True):
            artist.set_data(at.real, at.imag)
            self.ax.draw_artist(artist)
        self.canvas.blit(self.ax.bbox)
        return self.ax
