"""An explorer: a live view of one control system, its sliders and its values in Python.

The view holds the parameters.  Each slider runs over a grid of round numbers
and is joined to the view in the browser, so it works with a kernel and without
one; a value off the grid (typed into the box, or set from Python) stays as it
is while the slider shows the nearest place.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import anywidget
import control
import ipywidgets as widgets
import traitlets
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim import checks
from rlswaim.explorers.still import draw_locus, still
from rlswaim.tables import script

Value = float | int | str
SOURCES = (
    "roots",
    "locus",
    "response",
    "modes",
    "window",
    "dom",
    "svg",
    "picture",
    "planes",
    "charts",
    "bent",
    "table",
    "words",
    "history",
    "address",
    "export",
    "interact",
    "desk",
    "locusplane",
    "panels",
    "modepanel",
    "workbench",
)
"""The workbench, each script after those that it imports."""


def module(*views: str) -> str:
    """Return the workbench and ``views`` as one ES module: joined in this order, without imports."""
    sources = (script("js", f"{name}.js") for name in (*SOURCES, *views))
    return "\n".join(re.sub(r"^import [^;]*;\n", "", source, flags=re.MULTILINE) for source in sources)


@dataclass(frozen=True)
class Parameter:
    """One parameter of a control system and the places of its slider.

    Attributes
    ----------
    name, label, unit, meaning : str
        The label is TeX; the unit is empty for a pure number.
    grid : tuple of float, int or str
        The slider's places, in order; texts make it a choice.
    check : callable
        Takes name, value and place; returns the value or raises.
    """

    name: str
    label: str
    unit: str
    meaning: str
    grid: tuple[Value, ...]
    check: Callable[[str, object, str], Value] = checks.real

    @property
    def description(self) -> str:
        """Label and unit."""
        return f"{self.label} ({self.unit})" if self.unit else self.label

    def nearest(self, value: Value) -> int:
        """Return the place on the grid nearest to a value."""
        return min(range(len(self.grid)), key=lambda i: _distance(self.grid[i], value))

    def controls(self, view: "Explorer") -> widgets.Widget:
        """Return the slider and a box for any value, or the buttons of a choice, joined to the view."""
        choice = isinstance(self.grid[0], str)
        kind = widgets.ToggleButtons if choice else widgets.SelectionSlider
        control = kind(
            options=[place if isinstance(place, str) else f"{place:g}" for place in self.grid],
            index=getattr(view, f"{self.name}_at"),
            description=self.description,
            tooltip=self.meaning,
            style={"description_width": "5.5rem"},
        )
        widgets.jslink((view, f"{self.name}_at"), (control, "index"))
        if choice:
            control.style.button_width = "auto"
            return control
        control.readout, control.layout = False, {"flex": "1 1 12rem", "width": "auto", "min_width": "0"}
        whole = isinstance(self.grid[0], int)
        box = (widgets.BoundedIntText if whole else widgets.FloatText)(
            value=getattr(view, self.name),
            tooltip=f"{self.meaning}: any value",
            layout={"flex": "0 0 auto", "width": "7rem"},
            **({"min": self.grid[0], "max": self.grid[-1]} if whole else {}),
        )
        widgets.jslink((view, self.name), (box, "value"))
        row = {"width": "100%", "max_width": "46rem", "flex_flow": "row nowrap"}
        return widgets.HBox([control, box], layout=row)


def _distance(place: Value, value: Value) -> float:
    return float(place != value) if isinstance(place, str) or isinstance(value, str) else abs(place - value)


class Checked(traitlets.TraitType):
    """A trait whose errors say what, where, got and wanted."""

    def __init__(self, parameter: Parameter, default: Value) -> None:
        super().__init__(default_value=default)
        self.parameter = parameter

    def validate(self, obj: "Explorer", value: object) -> Value:
        """Return the value for ``obj``; ValueError or TypeError where the parameter doesn't allow it."""
        return self.parameter.check(self.parameter.name, value, f"{obj.system} explorer")


class Explorer(anywidget.AnyWidget):
    """A control system under sliders; it displays itself with them.

    Each parameter is an attribute that can be read and set: ``explorer.K_A = 1.8``.

    Raises
    ------
    ValueError
        If a value is not finite or out of range, or a choice is unknown.
    TypeError
        If a value is not of its kind, or a parameter is unknown.
    """

    _esm = module("sliders", "explorer")
    _css = script("explorer.css")
    payload = traitlets.Dict().tag(sync=True)
    magnify = traitlets.Float(1.0, help="of the small window about the origin; 1: none").tag(sync=True)

    def __init__(
        self,
        system: str,
        parameters: Sequence[Parameter],
        payload: Mapping[str, Any],
        closed_loop: Callable[..., control.StateSpace],
        values: Mapping[str, Value],
    ) -> None:
        self.system, self.parameters = system, tuple(parameters)
        self._closed_loop = closed_loop
        wrong = sorted(set(values) ^ {p.name for p in parameters})
        if wrong:
            known = ", ".join(p.name for p in parameters)
            raise TypeError(f"{system} explorer: got a missing or unknown {wrong[0]!r}, wanted {known}")
        # All traits before the model opens: a front end gets the values that it opens with.
        start = {p.name: p.check(p.name, values[p.name], f"{system} explorer") for p in parameters}
        for p in parameters:
            place = traitlets.Int(p.nearest(start[p.name])).tag(sync=True)
            self.add_traits(**{p.name: Checked(p, start[p.name]).tag(sync=True), f"{p.name}_at": place})
        super().__init__(payload={**payload, "initial": start})
        for p in parameters:
            self.observe(lambda change, p=p: self.set_trait(f"{p.name}_at", p.nearest(change["new"])), p.name)
        self.panel = widgets.VBox(
            [*(p.controls(self) for p in self.parameters), self], layout={"width": "100%"}
        )

    def values(self) -> dict[str, Value]:
        """Return the parameters by name."""
        return {p.name: getattr(self, p.name) for p in self.parameters}

    def closed_loop(self) -> control.StateSpace:
        """Return the closed loop under the sliders."""
        return self._closed_loop(**self.values())

    def poles(self) -> NDArray:
        """Return the closed-loop poles under the sliders (1/s)."""
        return self.closed_loop().poles()

    def __repr__(self) -> str:
        """Return system and values in one line."""
        shown = ", ".join(f"{name} = {value}" for name, value in self.values().items())
        return f"{self.system} explorer: {shown}"

    def draw(self, ax: Axes) -> Axes:
        """Draw the root locus in the gain that is closed last."""
        running, values = self.payload["closing"][-1], self.values()

        def loop(gain: float) -> control.StateSpace:
            return self._closed_loop(**{**values, running: gain})

        return draw_locus(ax, loop, float(values[running]), running)

    def _repr_mimebundle_(self, **kwargs: object) -> Any:
        bundle = self.panel._repr_mimebundle_(**kwargs)
        still_there = {"image/png": still(self.draw)} if "closing" in self.payload else {}
        return {**bundle, **still_there, "text/plain": repr(self)}
