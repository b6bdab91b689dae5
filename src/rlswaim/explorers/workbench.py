"""An explorer: the live view of one control system, with its closed loop and poles in Python."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import control
import traitlets
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.still import Drawing, draw_locus
from rlswaim.practice.criteria import Criterion


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

    view = "workbench"
    magnify = traitlets.Float(1.0, help="how much the inset enlarges the origin; 1: no inset").tag(sync=True)

    def __init__(
        self,
        system: str,
        parameters: Sequence[Parameter],
        payload: Mapping[str, Any],
        closed_loop: Callable[..., control.StateSpace],
        values: Mapping[str, Value],
        judged: Callable[[Mapping[str, Value]], tuple[Criterion, ...]],
    ) -> None:
        self.system, self._closed_loop, self._judged = system, closed_loop, judged
        super().__init__(parameters, payload, values)

    def closed_loop(self) -> control.StateSpace:
        """Return the closed loop under the sliders."""
        return self._closed_loop(**self.values())

    def poles(self) -> NDArray:
        """Return the closed-loop poles under the sliders (1/s)."""
        return self.closed_loop().poles()

    def criteria(self) -> tuple[Criterion, ...]:
        """Return the criteria of the closed loop under the sliders, those of the view's card."""
        return self._judged(self.values())

    def draw(self, ax: Axes) -> Axes:
        """Draw the root locus in the gain that is closed last."""
        running, values = self.payload["locus_gains"][-1], self.values()

        def loop(gain: float) -> control.StateSpace:
            return self._closed_loop(**{**values, running: gain})

        return draw_locus(ax, loop, float(values[running]), running)

    def drawings(self) -> list[Drawing]:
        """Return `draw` alone."""
        return [self.draw]
