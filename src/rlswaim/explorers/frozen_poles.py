"""The live view of the burn: the poles of the fixed and the scheduled design at each second, with a trail."""

from collections.abc import Callable
from functools import cache, partial
from typing import Any

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.explorers.ascent import whole_seconds
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.still import Drawing
from rlswaim.figures.designs import draw_frozen_poles
from rlswaim.figures.style import COLORS
from rlswaim.practice import burn

END = 110
"""The second (s) of burnout."""
WITHIN = 10.0
"""Poles that the browser gets: up to this distance from the origin (rad/s)."""
WAYS: dict[str, Callable[[float], control.StateSpace]] = {"fixed": burn.fixed, "scheduled": burn.scheduled}
DIGITS, ZERO = 8, 1e-9
"""Digits that the browser gets of a pole, and what counts as no real part (1/s)."""


def poles_at(t: float, name: str) -> NDArray:
    """Return the poles (1/s) of a design's loop, the vehicle frozen, by their real parts, the largest first.

    Parameters
    ----------
    t : float
        In s.
    name : str
        One of `WAYS`.

    Returns
    -------
    ndarray of complex
    """
    found = burn.loop_at(float(t), WAYS[name]).poles()
    real = np.where(np.abs(found.real) < ZERO, 0.0, found.real)
    return (real + 1j * found.imag)[np.lexsort((found.imag, -real))]


@cache
def table() -> dict[str, list[list[list[float]]]]:
    """Return the poles of each second within `WITHIN`, im >= 0: by design, second, pole, its two parts."""
    found: dict[str, list[list[list[float]]]] = {}
    for name in WAYS:
        seconds = [poles_at(t, name) for t in range(END + 1)]
        kept = [poles[(abs(poles) <= WITHIN) & (poles.imag >= 0)] for poles in seconds]
        found[name] = [
            [[float(f"{part:.{DIGITS}g}") for part in (p.real, p.imag)] for p in poles] for poles in kept
        ]
    return found


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: time of flight and length of the trail, in whole seconds."""
    seconds, check = tuple(range(END + 1)), partial(whole_seconds, low=0, high=END)
    return (
        Parameter("t", r"\(t\)", "s", "time of flight (s)", seconds, check),
        Parameter("trail", "Trail", "s", "how far back the trail of the poles goes (s)", seconds, check),
    )


class FrozenPoles(LiveView):
    """Frozen poles of the burn under sliders; ``poles()`` are the library's at their time."""

    view, system = "frozen-poles", "whole-burn"

    def __init__(self, **values: Value) -> None:
        start: dict[str, Value] = {"t": 58, "trail": 10}
        first, second = (round(t) for t in [*burn.switched()][1:])
        presets = [
            ("Largest dynamic pressure", "the moment that the report designs for", start),
            ("Lift-off", "without air a root is zero under any design", {"t": 0, "trail": 10}),
            ("First switch", "from the first design to the second", {"t": first, "trail": first}),
            ("Second switch", "from the second design to the third", {"t": second, "trail": 10}),
            ("Burnout", "with the trail of the whole burn", {"t": END, "trail": END}),
        ]
        payload: dict[str, Any] = {
            "poles": table(),
            "within": WITHIN,
            "switched": [[begins, made_for] for begins, made_for in burn.switched().items()],
            "colors": {"fixed": COLORS["mode 1"], "scheduled": COLORS["rigid"]},
            "presets": [{"name": n, "label": label, "values": v} for n, label, v in presets],
        }
        super().__init__(parameters(), payload, {**start, **values})

    def poles(self) -> dict[str, NDArray]:
        """Return all poles (1/s) under the sliders, by design."""
        return {name: poles_at(float(self.values()["t"]), name) for name in WAYS}

    def drawings(self) -> list[Drawing]:
        """Return the poles with their trail."""
        t, trail = (int(self.values()[name]) for name in ("t", "trail"))
        times = np.arange(max(0, t - trail), t + 1)
        poles = {name: burn.frozen_poles(times.tolist(), way) for name, way in WAYS.items()}

        def draw(ax: Any) -> object:
            ax.set(xlim=(-2.2, 0.6), ylim=(-0.2, 8.0))
            return draw_frozen_poles(ax, times, poles)

        return [draw]


def frozen_poles_explorer(**values: Value) -> FrozenPoles:
    """Return the live view of the frozen poles through the burn.

    Parameters
    ----------
    **values : int
        Where the sliders start: t (time of flight, s), trail (how far back the trail goes, s).

    Returns
    -------
    FrozenPoles

    Raises
    ------
    ValueError
        If a time is not a whole number of seconds from 0 to 110.
    TypeError
        If a time is not a real number or a parameter is unknown.
    """
    return FrozenPoles(**values)
