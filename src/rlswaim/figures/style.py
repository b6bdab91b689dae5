"""Colors of every figure and every live view."""

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
