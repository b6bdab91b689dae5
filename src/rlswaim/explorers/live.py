"""A live view that is no root locus: its sliders, its traits and the scripts that draw it.

Like `Explorer` the view holds the parameters, and each slider is joined to it in the browser.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

import anywidget
import ipywidgets as widgets
import traitlets

from rlswaim import checks
from rlswaim.explorers.still import Drawing, still
from rlswaim.explorers.widget import Checked, Parameter, Value
from rlswaim.tables import script


def module(*sources: str) -> str:
    """Return the scripts ``sources`` as one, in this order; each but the last in a scope of its own.

    Parameters
    ----------
    *sources : str
        Names of ES modules with imports from each other alone; what the last exports, the whole exports.

    Returns
    -------
    str
    """
    *parts, view = (_with_imports_bound(script("js", f"{name}.js")) for name in sources)
    scopes = (_scope(name, text) for name, text in zip(sources, parts, strict=False))
    return "\n".join([*scopes, view])


def _with_imports_bound(text: str) -> str:
    """Return a script that takes what it imports from the scopes before it."""
    return re.sub(r"^import (\{[^}]*\}) from '\./(\w+)\.js';$", r"const \1 = $\2;", text, flags=re.MULTILINE)


def _scope(name: str, text: str) -> str:
    """Return a script as an object of what it exports."""
    exported = ", ".join(re.findall(r"^export (?:function\*?|const|class) (\w+)", text, flags=re.MULTILINE))
    body = re.sub(r"^export ", "", text, flags=re.MULTILINE)
    return f"const ${name} = (() => {{\n{body}\nreturn {{ {exported} }};\n}})();"


def whole_between(name: str, value: object, where: str, *, low: int, high: int, unit: str) -> int:
    """Return a whole number in a range.

    Parameters
    ----------
    name, where : str
        For the error's words.
    value : object
    low, high : int
    unit : str

    Returns
    -------
    int

    Raises
    ------
    ValueError, TypeError
        If it is not whole, not in the range, or no number.
    """
    number = checks.real(name, value, where)
    if number != int(number) or not low <= number <= high:
        raise ValueError(
            f"{name} in {where}: got {number:g} {unit}, wanted a whole number from {low} to {high} {unit}"
        )
    return int(number)


class LiveView(anywidget.AnyWidget):
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

    system: ClassVar[str]
    _css = script("explorer.css") + script("live.css")
    payload = traitlets.Dict().tag(sync=True)

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
        sent = {"system": self.system, "initial": start, **payload}
        sent["parameters"] = [
            {"name": p.name, "grid": p.grid, "unit": p.unit, "meaning": p.meaning} for p in parameters
        ]
        super().__init__(payload=sent)
        for p in parameters:
            self.observe(lambda change, p=p: self.set_trait(f"{p.name}_at", p.nearest(change["new"])), p.name)
        shared = [p for p in parameters if beside is not None and beside.has_trait(p.name)]
        for p in shared:
            widgets.jslink((beside, p.name), (self, p.name))
        own = [p.controls(self) for p in parameters if p not in shared]
        self.panel = widgets.VBox([*own, self], layout={"width": "100%"})

    def values(self) -> dict[str, Value]:
        """Return the parameters by name."""
        return {p.name: getattr(self, p.name) for p in self.parameters}

    def drawings(self) -> Sequence[Drawing]:
        """Return what the view's still shows, side by side."""
        raise NotImplementedError

    def __repr__(self) -> str:
        """Return view and values in one line."""
        shown = ", ".join(f"{name} = {value}" for name, value in self.values().items())
        return f"{self.system} explorer: {shown}"

    def _repr_mimebundle_(self, **kwargs: object) -> Any:
        bundle = self.panel._repr_mimebundle_(**kwargs)
        return {**bundle, "image/png": still(*self.drawings()), "text/plain": repr(self)}
