"""The live view of Chapter VIII: any two designs met so far, side by side."""

from functools import partial
from typing import Any

import control
import ipywidgets as widgets
import traitlets
from matplotlib.axes import Axes

from rlswaim.explorers.control_systems import payload
from rlswaim.explorers.live_view import ScriptedView
from rlswaim.explorers.parameter import Value
from rlswaim.explorers.presets import COMPARED
from rlswaim.explorers.still import Drawing, draw_locus
from rlswaim.explorers.system_views import VIEWS
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations

SIDES = ("left", "right")
SHARED = ("dispersed", "vehicle", "poles")
"""What the payloads of all control systems have alike."""


def _without_shared(sent: dict[str, Any]) -> dict[str, Any]:
    """Return a payload without what is sent once."""
    return {name: value for name, value in sent.items() if name not in SHARED}


class Comparison(ScriptedView):
    """Two designs side by side, each on a workbench; ``left`` and ``right`` choose from ``designs``.

    Raises
    ------
    TraitError
        If ``left`` or ``right`` is no place of ``designs``.
    """

    left = traitlets.Int().tag(sync=True)
    right = traitlets.Int().tag(sync=True)

    def __init__(self, eqs: PerturbationEquations) -> None:
        checks.instance("eqs", eqs, PerturbationEquations, "comparison")
        self._eqs = eqs
        systems = {
            section: payload(view, eqs, view.system.polynomial(eqs)) for section, view in VIEWS.items()
        }
        chosen = [(section, at) for section, sent in systems.items() for at in range(len(sent["presets"]))]
        self._presets: list[tuple[str, dict[str, Any]]] = [
            (section, systems[section]["presets"][at]) for section, at in chosen
        ]
        self.designs = [
            f"{section}: {preset['name']} ({preset['note']})" for section, preset in self._presets
        ]
        shared = {name: systems["IV"][name] for name in SHARED}
        sent = {
            "view": "comparison",
            "shared": shared,
            "systems": {section: _without_shared(sent) for section, sent in systems.items()},
            "designs": [{"system": s, "preset": at} for s, at in chosen],
        }
        left, right = (self._place("IV", name) for name in COMPARED["IV"])
        super().__init__(payload=sent, left=left, right=right)
        self.panel = widgets.VBox(
            [self._choice("left"), self._choice("right"), self], layout={"width": "100%"}
        )

    def _place(self, section: str, name: str) -> int:
        return [(s, preset["name"]) for s, preset in self._presets].index((section, name))

    def _choice(self, side: str) -> widgets.Dropdown:
        """Return the list of designs for one side, joined to the view."""
        chooser = widgets.Dropdown(
            options=self.designs,
            index=getattr(self, side),
            description=side.capitalize(),
            layout={"width": "100%", "max_width": "30rem"},
        )
        widgets.jslink((self, side), (chooser, "index"))
        return chooser

    @traitlets.validate("left", "right")
    def _known(self, proposal: Any) -> int:
        at = int(proposal["value"])
        if not 0 <= at < len(self.designs):
            raise traitlets.TraitError(
                f"{proposal['trait'].name} in comparison: got {at}, wanted 0 to {len(self.designs) - 1}"
            )
        return at

    def values(self, side: str) -> dict[str, Value]:
        """Return the parameters of the design on a ``side``, "left" or "right"."""
        return dict(self._presets[getattr(self, checks.one_of("side", side, SIDES))][1]["values"])

    def closed_loop(self, side: str) -> control.StateSpace:
        """Return the closed loop of the design on a ``side``, "left" or "right"."""
        return self._varied(side)

    def _varied(self, side: str, **changes: float) -> control.StateSpace:
        section = self._presets[getattr(self, checks.one_of("side", side, SIDES))][0]
        return VIEWS[section].closed_loop(self._eqs, **{**self.values(side), **changes})

    def draw(self, ax: Axes, side: str) -> Axes:
        """Draw the root locus of one design in the gain K_A, which is closed last.

        Parameters
        ----------
        ax : Axes
        side : str
            "left" or "right".

        Returns
        -------
        Axes
        """
        gain = float(self.values(side)["K_A"])
        ax.set_title(self.designs[getattr(self, side)], fontsize=8)
        return draw_locus(ax, lambda K_A: self._varied(side, K_A=K_A), gain, "K_A")

    def drawings(self) -> list[Drawing]:
        """Return the loci of both designs."""
        return [partial(self.draw, side=side) for side in SIDES]

    def __repr__(self) -> str:
        """Return both designs in one line."""
        return f"comparison: {self.designs[self.left]} beside {self.designs[self.right]}"


def comparison_explorer(eqs: PerturbationEquations) -> Comparison:
    """Return the live view of two designs of Sections IV to VII side by side.

    Parameters
    ----------
    eqs : PerturbationEquations

    Returns
    -------
    Comparison
        ``left`` and ``right`` are places in ``designs``; it starts with the rigid-body design of
        Section IV as printed and corrected [Eqs. 61 to 78].

    Raises
    ------
    TypeError
        If ``eqs`` are no PerturbationEquations.
    """
    return Comparison(eqs)
