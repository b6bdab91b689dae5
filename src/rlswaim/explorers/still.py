"""The still of a live view: the picture that a reader sees where no script runs, as on paper."""

from base64 import b64encode
from collections.abc import Callable
from io import BytesIO

import control
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rlswaim.figures.loci import draw_poles, draw_root_locus
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial
from rlswaim.rootlocus.locus import root_locus

Drawing = Callable[[Axes], object]


def still(*drawings: Drawing) -> str:
    """Return one or more drawings side by side as base64 of a PNG, with a line that says what it is."""
    figure = Figure(figsize=(7.0 if len(drawings) == 1 else 9.0, 4.3), layout="constrained")
    for ax, draw in zip(figure.subplots(1, len(drawings), squeeze=False)[0], drawings, strict=True):
        draw(ax)
    figure.suptitle("A still of the live view, which needs a browser with scripts", fontsize=9)
    png = BytesIO()
    figure.savefig(png, dpi=90, metadata={"Software": None})
    return b64encode(png.getvalue()).decode()


def draw_locus(ax: Axes, closed_loop: Callable[[float], control.StateSpace], gain: float, name: str) -> Axes:
    """Draw the root locus in a gain from 0 on, to the side of its present value, and the poles there.

    Parameters
    ----------
    ax : Axes
    closed_loop : callable
        Of the gain, in which its characteristic polynomial is linear.
    gain : float
        Its present value; from 0 the locus runs to positive gains.
    name : str
        Of the gain.

    Returns
    -------
    Axes
    """
    D = characteristic_polynomial(closed_loop(0.0).A)
    N = characteristic_polynomial(closed_loop(gain or 1.0).A) - D
    locus = root_locus(control.tf(np.trim_zeros(N[::-1], "f"), D[::-1]))
    poles = closed_loop(gain).poles()
    around = np.hstack([poles, locus.poles])
    top = 1.2 * abs(around.imag).max() + 0.3
    left, right = 1.2 * around.real.min() - 0.3, 1.4 * around.real.max() + 0.3
    side = max(0, top - (right - left)) / 2
    draw_root_locus(ax, locus, (left - side, right + side, -top, top))
    draw_poles(ax, poles, f"poles at {name} = {gain:g}").legend(loc="upper left", fontsize=7)
    return ax
