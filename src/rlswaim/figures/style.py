"""Colors of every figure and every live view, and how a figure sets the symbols in its words."""

from rlswaim.edition.notation import with_formulas

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
"""Okabe and Ito's colors, which color-blind readers can tell apart; a mode has one color in all figures."""


def labelled(text: str) -> str:
    r"""Return a label with the names of symbols set as formulas; one that holds formulas stays as it is.

    Examples
    --------
    >>> labelled("theta (deg)")
    '$\\theta$ (deg)'
    """
    return text if "$" in text else with_formulas(text)
