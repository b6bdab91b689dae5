"""The picture of a live view where no script runs: on paper, or in a viewer of notebooks."""

from base64 import b64encode
from io import BytesIO

import control
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rlswaim.figures.loci import draw_poles, draw_root_locus
from rlswaim.locus import root_locus


def still(D: NDArray, N: NDArray, poles: NDArray, words: str) -> str:
    """Return the root locus of D + k N as base64 of a PNG.

    Parameters
    ----------
    D, N : ndarray, shape (n + 1,)
        Constant term first; k rises from 0.
    poles : ndarray of complex, shape (n,)
        The poles at present (1/s), to be marked.
    words : str
        What they are the poles at.

    Returns
    -------
    str
    """
    locus = root_locus(control.tf(np.trim_zeros(N[::-1], "f"), D[::-1]))
    around = np.hstack([poles, locus.poles])
    top = 1.2 * abs(around.imag).max() + 0.3
    left, right = 1.2 * around.real.min() - 0.3, 1.4 * around.real.max() + 0.3
    side = max(0, top - (right - left)) / 2
    figure = Figure(figsize=(7.0, 4.3), layout="constrained")
    ax = draw_root_locus(figure.subplots(), locus, (left - side, right + side, -top, top))
    draw_poles(ax, poles, words).legend(loc="upper left", fontsize=7)
    ax.set_title("A still of the live view, which needs a browser with scripts", fontsize=9)
    png = BytesIO()
    figure.savefig(png, dpi=90, metadata={"Software": None})
    return b64encode(png.getvalue()).decode()
