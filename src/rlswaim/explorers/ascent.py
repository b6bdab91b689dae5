"""The live view of Section II: the ascent for other pitch programs than the one that the book assumes."""

from collections.abc import Sequence
from functools import cache, partial
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rlswaim.explorers.bench import burn_bench
from rlswaim.explorers.burn_tables import END
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.still import Drawing
from rlswaim.figures.style import COLORS
from rlswaim.figures.vehicle import draw_history
from rlswaim.source import checks
from rlswaim.vehicle.booster import FlightCondition
from rlswaim.vehicle.trajectory import Ascent, Trajectory, fly, turn

UPRIGHT = (0, 6, 12, 18)
LEVEL = (100, 102, 104, 107, 110, 114, 118, 123, 128, 134, 141, 150, 160, 170, 180)
"""Pitch programs (s) whose flights Python integrates; the view interpolates linearly between them."""
FINE = np.linspace(0.0, 100.0, 1001)
TIMES = FINE[::20]
"""FINE holds the times (s) of the integrated flights, TIMES those at which the browser gets them."""
CURVES = {"U": 1, "h": 0, "q_D": 1}
"""The quantities that the browser gets, each with its number of decimals."""


def whole_seconds(name: str, value: object, where: str, *, low: int, high: int) -> int:
    """Return a time in whole seconds, checked.

    Parameters
    ----------
    name : str
        Name of the parameter, for the error.
    value : object
        Time (s).
    where : str
        The view, for the error.
    low, high : int
        The earliest and the latest time (s).

    Returns
    -------
    int

    Raises
    ------
    ValueError, TypeError
        If it is not whole, not from ``low`` to ``high``, or no number.
    """
    number = checks.real(name, value, where)
    if number != int(number) or not low <= number <= high:
        raise ValueError(f"{name} in {where}: got {number:g} s, wanted a whole number from {low} to {high} s")
    return int(number)


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: whole seconds until which the path is vertical, and at which it is level."""

    def slider(name: str, label: str, meaning: str, nodes: Sequence[int]) -> Parameter:
        low, high = nodes[0], nodes[-1]
        check = partial(whole_seconds, low=low, high=high)
        return Parameter(name, label, "s", meaning, tuple(range(low, high + 1)), check)

    return (
        slider("upright", "Upright", "time until which the path is vertical (s)", UPRIGHT),
        slider("level", "Level at", "time at which the path is level (s)", LEVEL),
    )


def time_of_flight() -> Parameter:
    """Return the slider of the time (s) that the bench has."""
    check = partial(whole_seconds, low=0, high=END)
    return Parameter("t", r"\(t\)", "s", "time of flight (s)", tuple(range(END + 1)), check)


@cache
def flights(ascent: Ascent, uprights: tuple[float, ...], levels: tuple[float, ...]) -> dict[str, NDArray]:
    """Fly all pairs of pitch programs.

    Parameters
    ----------
    ascent : Ascent
    uprights : tuple of float
        Times until which the path is vertical (s).
    levels : tuple of float
        Times at which the path is level (s).

    Returns
    -------
    dict
        U (ft/s), h (ft) and q_D (lb/ft^2) at TIMES, shape (uprights, levels, times).
        ``peak`` holds time (s) and size (lb/ft^2) of the largest q_D; shape (uprights, levels, 2).
    """
    flown = [[fly(ascent, turn(u, v), FINE) for v in levels] for u in uprights]
    tables = {name: np.array([[getattr(f, name)[::20] for f in row] for row in flown]) for name in CURVES}
    return {**tables, "peak": np.array([[f.peak for f in row] for row in flown])}


def between_nodes(tables: dict[str, NDArray], name: str) -> NDArray:
    """Return a table's values in the middle of each cell of programs: the mean of the cell's four corners.

    Parameters
    ----------
    tables : dict
        As `flights` returns them.
    name : str
        The table: U, h, q_D or peak.

    Returns
    -------
    array, shape (uprights - 1, levels - 1, ...)
    """
    t = tables[name]
    return (t[:-1, :-1] + t[1:, :-1] + t[:-1, 1:] + t[1:, 1:]) / 4


def _middles(nodes: Sequence[float]) -> tuple[float, ...]:
    return tuple((a + b) / 2 for a, b in pairwise(nodes))


def nearest_program(tables: dict[str, NDArray], flight: FlightCondition) -> tuple[int, int]:
    """Return the pitch program whose flight comes nearest to a printed flight condition.

    At the printed time U, h and q_D of a flight each differ from the printed value by some share of it.
    The largest of these three shares is the flight's distance, and the program with the least distance
    is returned.

    Parameters
    ----------
    tables : dict
        As `flights` returns them for all of UPRIGHT and LEVEL.
    flight : FlightCondition
        The printed flight condition.

    Returns
    -------
    tuple of int
        Upright until, level at (s).
    """

    def difference(name: str) -> NDArray:
        """Return by what share each flight differs from the printed ``name``."""
        wanted = getattr(flight, name)
        at = int(np.searchsorted(TIMES, flight.t))
        share = (flight.t - TIMES[at - 1]) / (TIMES[at] - TIMES[at - 1])
        there = tables[name][..., at - 1] * (1 - share) + tables[name][..., at] * share
        return np.abs(there / wanted - 1)

    distance = np.max([difference(name) for name in CURVES], axis=0)
    i, k = np.unravel_index(distance.argmin(), distance.shape)
    return UPRIGHT[i], LEVEL[k]


class AscentView(LiveView):
    """The ascent under sliders; ``trajectory()`` flies the program that they show."""

    view, system = "ascent", "trajectory"

    def __init__(self, ascent: Ascent, flight: FlightCondition, **values: Value) -> None:
        self._ascent, self._flight = ascent, flight
        tables = flights(ascent, UPRIGHT, LEVEL)
        middle = flights(ascent, _middles(UPRIGHT), _middles(LEVEL))
        off = {name: float(abs(between_nodes(tables, name) - middle[name]).max()) for name in CURVES}
        start = {"upright": 0, "level": round(ascent.t_burn)}
        upright, level = nearest_program(tables, flight)
        presets = [
            ("The book’s program", "vertical at launch, level at burnout", start),
            (
                "Nearest to the report",
                "U, h and q_D differ least from the printed ones",
                {"upright": upright, "level": level},
            ),
            ("Steep", "the steepest program of this view", {"upright": 18, "level": 180}),
            ("Flat", "the flattest program of this view", {"upright": 0, "level": 100}),
        ]
        payload: dict[str, Any] = {
            "nodes": {"upright": UPRIGHT, "level": LEVEL},
            "times": TIMES.tolist(),
            "curves": {name: np.round(tables[name], digits).tolist() for name, digits in CURVES.items()},
            "peak": np.round(tables["peak"], 2).tolist(),
            "accuracy": off,
            "printed": {"t": flight.t, **{name: getattr(flight, name) for name in CURVES}},
            "colors": {n: COLORS[n] for n in ("rigid", "corrected", "neutral", "mode 2")},
            "presets": [{"name": n, "label": label, "values": v} for n, label, v in presets],
        }
        payload["bench"] = burn_bench(payload, start, time_of_flight())
        super().__init__(parameters(), payload, {**start, **values})

    def drawings(self) -> list[Drawing]:
        """Return the dynamic pressure and the altitude of the flight under the sliders."""
        flown, flight = self.trajectory(), self._flight
        named = {"q_D": "dynamic pressure $q_D$ (lb/ft²)", "h": "altitude $h$ (ft)"}
        return [
            partial(
                draw_history,
                times=FINE,
                curves={"integrated": getattr(flown, name)},
                quantity=quantity,
                printed=(flight.t, getattr(flight, name)),
            )
            for name, quantity in named.items()
        ]

    def trajectory(self) -> Trajectory:
        """Return the flight under the sliders, integrated, at every tenth of a second up to 100 s."""
        program = turn(float(self.values()["upright"]), float(self.values()["level"]))
        return fly(self._ascent, program, FINE)


def ascent_explorer(ascent: Ascent, flight: FlightCondition, **values: Value) -> AscentView:
    """Return the live view of the ascent.

    Parameters
    ----------
    ascent : Ascent
    flight : FlightCondition
        The printed condition, marked in the pictures.
    **values : int
        Where the sliders start: upright (until when the path is vertical, s), level (when it is level, s).

    Returns
    -------
    AscentView

    Raises
    ------
    ValueError
        If a time is not a whole number of seconds in the view's range.
    TypeError
        If a time is not a real number or a parameter is unknown.

    Notes
    -----
    Figures 3 and 4, Eqs. 30 to 37.
    """
    return AscentView(ascent, flight, **values)
