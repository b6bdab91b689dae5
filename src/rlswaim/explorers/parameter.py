"""One parameter of a live view: its values, its slider and its checks.

Each slider runs over a grid of round numbers and is joined to the view in the browser, so it works with a
kernel and without one; a value off the grid (typed into the box, or set from Python) stays as it is while
the slider shows the nearest place.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import anywidget
import ipywidgets as widgets
import traitlets

from rlswaim.source import checks
from rlswaim.vehicle.stations import LENGTH, as_station

Value = float | int | str


FEET = tuple(range(int(LENGTH) + 1))
"""The places of a station's slider."""


def whole_station(name: str, value: object, where: str) -> int:
    """Return a station in whole feet, checked.

    Parameters
    ----------
    name : str
        Name of the parameter, for the error.
    value : object
        Station (ft from the nose).
    where : str
        The view, for the error.

    Returns
    -------
    int

    Raises
    ------
    ValueError, TypeError
        If it is not whole, not on the vehicle, or no number.
    """
    station = as_station(name, value, where)
    if station != int(station):
        raise ValueError(f"{name} in {where}: got station {station:g} ft, wanted a whole number of feet")
    return int(station)


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
    folded : bool
        Whether the view itself makes the slider, folded away, and not the widget beside it.
    """

    name: str
    label: str
    unit: str
    meaning: str
    grid: tuple[Value, ...]
    check: Callable[[str, object, str], Value] = checks.real
    folded: bool = False

    @property
    def description(self) -> str:
        """Label and unit."""
        return f"{self.label} ({self.unit})" if self.unit else self.label

    @property
    def told(self) -> dict[str, Any]:
        """What the script knows of the parameter."""
        return {"name": self.name, "grid": self.grid, "unit": self.unit, "meaning": self.meaning}

    def nearest(self, value: Value) -> int:
        """Return the place on the grid nearest to a value."""
        return min(range(len(self.grid)), key=lambda i: _distance(self.grid[i], value))

    def controls(self, view: anywidget.AnyWidget) -> widgets.Widget:
        """Return the slider and a box for numbers in its range, or a choice's buttons, joined to the view."""
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
        whole, least, most = isinstance(self.grid[0], int), self.grid[0], self.grid[-1]
        box = (widgets.BoundedIntText if whole else widgets.FloatText)(
            value=getattr(view, self.name),
            tooltip=f"{self.meaning}: {'whole numbers' if whole else 'any value'} from {least:g} to {most:g}",
            layout={"flex": "0 0 auto", "width": "7.8rem"},
            **({"min": least, "max": most} if whole else {}),
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

    def validate(self, obj: Any, value: object) -> Value:
        """Return a value that the parameter allows.

        Parameters
        ----------
        obj : LiveView
            The view that holds the trait.
        value : object
            What is set.

        Returns
        -------
        float, int or str

        Raises
        ------
        ValueError, TypeError
            If the parameter doesn't allow it.
        """
        return self.parameter.check(self.parameter.name, value, f"{obj.system} explorer")
