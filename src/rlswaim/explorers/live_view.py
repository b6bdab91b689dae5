"""What all live views share: the script that draws them, their sliders, and the traits joined to these."""

from collections.abc import Mapping, Sequence
from typing import Any

import anywidget
import ipywidgets as widgets
import traitlets

from rlswaim.explorers.parameter import Checked, Parameter, Value
from rlswaim.explorers.scripts import MODULE, STYLE
from rlswaim.explorers.still import Drawing, still


class ScriptedView(anywidget.AnyWidget):
    """A widget that the live views' script draws; it displays itself with its controls, and as a still.

    Attributes
    ----------
    payload : dict
        What the script draws from; ``view`` names the view.
    panel : Widget
        The view with its controls.
    """

    _esm, _css = MODULE, STYLE
    payload = traitlets.Dict().tag(sync=True)
    panel: widgets.Widget

    def drawings(self) -> Sequence[Drawing]:
        """Return what the view's still shows, side by side."""
        raise NotImplementedError

    def _repr_mimebundle_(self, **kwargs: object) -> Any:
        bundle = self.panel._repr_mimebundle_(**kwargs)
        return {**bundle, "image/png": still(*self.drawings()), "text/plain": repr(self)}


def _sliders(controls: Sequence[widgets.Widget]) -> list[widgets.Widget]:
    """Return the box that holds all controls, none without them; the style sheet knows it by its class."""
    if not controls:
        return []
    box = widgets.VBox(controls, layout={"width": "100%"})
    box.add_class("rlswaim-sliders")
    return [box]


class LiveView(ScriptedView):
    """A view under sliders; it displays itself with them, and each parameter is an attribute.

    Parameters
    ----------
    parameters : sequence of Parameter
    payload : mapping
        What the script draws from; ``presets`` is a list of names, labels and values.
    values : mapping of str to float or str
        Where the sliders start.
    beside : Widget, optional
        Another view on the page: parameters of the same name keep each other, and the sliders are its.

    Raises
    ------
    ValueError
        If a value is not finite or out of range, or a choice is unknown.
    TypeError
        If a value is not of its kind, or a parameter is missing or unknown.
    """

    view: str
    system: str

    def __init__(
        self,
        parameters: Sequence[Parameter],
        payload: Mapping[str, Any],
        values: Mapping[str, Value],
        beside: widgets.Widget | None = None,
    ) -> None:
        self.parameters = tuple(parameters)
        where, known = f"{self.system} explorer", [p.name for p in parameters]
        for name in sorted(set(values) ^ set(known)):
            raise TypeError(f"{where}: got a missing or unknown {name!r}, wanted {', '.join(known)}")
        # All traits before the model opens: a front end gets the values that it opens with.
        start = {p.name: p.check(p.name, values[p.name], where) for p in parameters}
        for p in parameters:
            place = traitlets.Int(p.nearest(start[p.name])).tag(sync=True)
            self.add_traits(**{p.name: Checked(p, start[p.name]).tag(sync=True), f"{p.name}_at": place})
        own = [p for p in parameters if beside is None or not beside.has_trait(p.name)]
        given = {
            "view": self.view,
            "system": self.system,
            "parameters": [p.told for p in parameters],
            "own": [p.name for p in own],
        }
        super().__init__(payload={**given, **payload, "initial": start})
        for p in parameters:
            self.observe(lambda change, p=p: self.set_trait(f"{p.name}_at", p.nearest(change["new"])), p.name)
            if p not in own:
                widgets.jslink((beside, p.name), (self, p.name))
        controls = _sliders([p.controls(self) for p in own if not p.folded])
        self.panel = widgets.VBox([*controls, self], layout={"width": "100%"})

    def values(self) -> dict[str, Value]:
        """Return the parameters by name."""
        return {p.name: getattr(self, p.name) for p in self.parameters}

    def __repr__(self) -> str:
        """Return view and values in one line; folded ones where they are not at their start."""
        start, values = self.payload["initial"], self.values()
        told = [p.name for p in self.parameters if not p.folded or values[p.name] != start[p.name]]
        shown = ", ".join(f"{name} = {values[name]}" for name in told)
        return f"{self.system} explorer: {shown}"
