"""An explorer: the live view of one control system, with its closed loop and poles in Python."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import control
import traitlets
from numpy.typing import NDArray

from rlswaim.explorers.live import LiveView
from rlswaim.explorers.multiaffine import MultiAffine
from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.scripts import module
from rlswaim.explorers.still import still
from rlswaim.tables import script


class Explorer(LiveView):
    """A control system under sliders; it displays itself with them.

    Each parameter is an attribute that can be read and set: ``explorer.K_A = 1.8``.

    Raises
    ------
    ValueError
        If a value is not finite or out of range, or a choice is unknown.
    TypeError
        If a value is not of its kind, or a parameter is unknown.
    """

    _esm = module("explorer")
    _css = script("explorer.css")
    magnify = traitlets.Float(1.0, help="of the small window about the origin; 1: none").tag(sync=True)

    def __init__(
        self,
        system: str,
        parameters: Sequence[Parameter],
        form: MultiAffine,
        payload: Mapping[str, Any],
        closed_loop: Callable[..., control.StateSpace],
        values: Mapping[str, Value],
    ) -> None:
        self.system, self._form, self._closed_loop = system, form, closed_loop
        super().__init__(parameters, payload, values)

    def closed_loop(self) -> control.StateSpace:
        """Return the closed loop under the sliders."""
        return self._closed_loop(**self.values())

    def poles(self) -> NDArray:
        """Return the closed-loop poles under the sliders (1/s)."""
        return self.closed_loop().poles()

    def _factors(self) -> dict[str, Any]:
        """Return the values of the polynomial's factors: parameters, and shapes at their stations."""
        values = self.values()
        shapes = {name: s["values"][int(values[s["at"]])] for name, s in self.payload["shapes"].items()}
        choice = self.payload["choice"]
        out = choice["zero"][values[choice["name"]]] if choice else ()
        known = {**values, **shapes, **dict.fromkeys(out, 0.0)}
        return {name: known[name] for name in self._form.factors}

    def still(self) -> str:
        """Return the root locus in the gain that is closed last, as base64 of a PNG."""
        running = self.payload["closing"][-1]
        gain, factors = getattr(self, running), self._factors()
        D = self._form(**{**factors, running: 0.0})
        N = self._form(**{**factors, running: -1.0 if gain < 0 else 1.0}) - D
        return still(D, N, self.poles(), f"poles at {running} = {gain:g}")

    def _repr_mimebundle_(self, **kwargs: object) -> Any:
        still = {"image/png": self.still()} if "closing" in self.payload else {}
        return {**super()._repr_mimebundle_(**kwargs), **still}
