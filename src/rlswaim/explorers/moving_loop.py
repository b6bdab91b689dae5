"""The small live view of the first page: Section IV's root locus, whose gain runs by itself."""

import ipywidgets as widgets

from rlswaim.explorers.control_systems import payload
from rlswaim.explorers.live_view import ScriptedView
from rlswaim.explorers.still import Drawing, draw_locus
from rlswaim.explorers.system_views import RATE_ATTITUDE
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations

RANGE = (0.02, 20.0)
"""Least and largest gain K_A of the run (rad/rad)."""
WINDOW = {"x": -4.5, "y": -0.4, "w": 19.0}
"""Middle, lower border and width of the part of the s plane (1/s) that is shown."""
PAGE = "04-rate-and-attitude-feedback.html"
"""The page of the book with the workbench of this loop."""
SENT = (
    *("parameters", "terms", "shapes", "choice", "poles", "actuators", "branches"),
    *("locus_gains", "loci"),
)
"""What of a workbench's payload a locus needs, beside the range of its gain."""


class MovingLoop(ScriptedView):
    """Section IV's loop at Figure 8's design, with a gain K_A that runs to and fro.

    Parameters
    ----------
    eqs : PerturbationEquations
    """

    def __init__(self, eqs: PerturbationEquations) -> None:
        checks.instance("eqs", eqs, PerturbationEquations, "moving loop")
        whole = payload(RATE_ATTITUDE, eqs, RATE_ATTITUDE.system.polynomial(eqs))
        self._eqs, self._values = eqs, whole["presets"][0]["values"]
        own = {"view": "moving-loop", "system": "moving-loop", "workbench": RATE_ATTITUDE.name, "page": PAGE}
        super().__init__(
            payload={
                **{name: whole[name] for name in SENT},
                "running": {"K_A": whole["running"]["K_A"]},
                "range": RANGE,
                "window": WINDOW,
                "initial": self._values,
                **own,
            }
        )
        self.panel = widgets.VBox([self], layout={"width": "100%"})

    def drawings(self) -> list[Drawing]:
        """Return the root locus, with the poles at Figure 8."""
        start = dict(self._values)
        gain = float(start.pop("K_A"))
        return [
            lambda ax: draw_locus(
                ax, lambda K_A: RATE_ATTITUDE.closed_loop(self._eqs, **start, K_A=K_A), gain, "K_A"
            )
        ]

    def __repr__(self) -> str:
        """Return what runs in one line."""
        return f"moving loop: K_A from {RANGE[0]} to {RANGE[1]:g}"


def moving_loop(eqs: PerturbationEquations) -> MovingLoop:
    """Return the loop of Section IV whose gain runs by itself.

    Parameters
    ----------
    eqs : PerturbationEquations

    Returns
    -------
    MovingLoop

    Raises
    ------
    TypeError
        If ``eqs`` are no PerturbationEquations.
    """
    return MovingLoop(eqs)
