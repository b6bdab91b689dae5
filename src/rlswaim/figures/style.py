"""One look for every figure: colours, markers and the SVG settings.

The colours are Okabe and Ito's, told apart by colour-blind readers; a mode has
the same colour in every figure and in the live views.
"""

COLOURS = {
    "rigid": "#0072B2",
    "mode 1": "#D55E00",
    "mode 2": "#009E73",
    "actuator": "#CC79A7",
    "jet": "#56B4E9",
    "printed": "#000000",
    "computed": "#0072B2",
    "corrected": "#E69F00",
    "neutral": "#7F7F7F",
}
