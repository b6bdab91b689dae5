"""The live view of the limits: the least peak of the sensitivity over the station of a gyro, or of two."""

from functools import partial

import numpy as np

from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import FEET, Parameter, Value, whole_station
from rlswaim.explorers.still import Drawing
from rlswaim.explorers.system_views import values_at_feet
from rlswaim.figures.limits import draw_bounds
from rlswaim.figures.style import COLORS
from rlswaim.practice.limits import AXIS, FAR, Limits, limits
from rlswaim.practice.measurements import blended
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations

GRAVITY = ("left out", "kept")
"""Eq. 29 leaves out the weight across the path; Eq. 1 has it."""


def _gravity(name: str, value: object, where: str) -> str:
    return checks.one_of(name, value, GRAVITY, where)


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: two stations (ft), the second gyro's share, the bandwidth (rad/s), gravity."""
    shares, bands = np.linspace(-2, 3, 101), np.geomspace(1, 100, 81)
    share = "share of gyro b in the sum; gyro a has the rest"
    band = "bandwidth that is at hand (rad/s)"
    return (
        Parameter("gyro_a", "Gyro a", "ft", "station of gyro a (ft)", FEET, whole_station),
        Parameter("gyro_b", "Gyro b", "ft", "station of gyro b (ft)", FEET, whole_station),
        Parameter("share", "Share of b", "", share, tuple(shares.round(2).tolist())),
        Parameter(
            "bandwidth",
            r"\(\Omega\)",
            "rad/s",
            band,
            tuple(float(f"{w:.2g}") for w in bands),
            checks.positive,
        ),
        Parameter("gravity", "Gravity", "", "the weight across the path", GRAVITY, _gravity),
    )


def case(eqs: PerturbationEquations) -> dict[str, list]:
    """Return the numerators over delta, constant term first, and the poles right of the axis (1/s)."""
    poles = limits(blended(eqs, {})).poles
    if len(poles) > 2 or any(pole.imag for pole in poles):
        raise ValueError(f"eqs in peak-bound explorer: got poles {poles}, wanted one or two real ones")
    outputs = [name for name in eqs.outputs if name != "alpha"]
    return {
        "numerators": [eqs.numerator(name, "delta").tolist() for name in outputs],
        "poles": [pole.real for pole in poles],
    }


class PeakBound(LiveView):
    """The bound under sliders; ``limits()`` are the library's limits at their values."""

    view, system = "peak-bound", "peak-bound"

    def __init__(self, **values: Value) -> None:
        self._eqs = {name: printed_equations(name == "kept") for name in GRAVITY}
        start: dict[str, Value] = {"gyro_a": 60, "gyro_b": 420, "share": 0.0, "bandwidth": 6.0}
        start["gravity"] = GRAVITY[0]
        eqs = self._eqs[GRAVITY[0]]
        presets = [
            ("Gyro at 60 ft", "the report's gyro", start),
            ("At 135 ft", "where a zero all but cancels the pole", {**start, "gyro_a": 135}),
            ("At the tail", "beside the engine", {**start, "gyro_a": 420}),
            ("Two gyros", "60 ft and the tail, in equal parts", {**start, "share": 0.5}),
        ]
        payload = {
            "cases": {name: case(one) for name, one in self._eqs.items()},
            "slopes": [values_at_feet(eqs, "slope", i) for i in range(len(eqs.modes))],
            "axis": AXIS,
            "far": FAR,
            "colors": {name: COLORS[name] for name in ("rigid", "mode 1", "corrected")},
            "presets": [{"name": n, "label": label, "values": v} for n, label, v in presets],
        }
        super().__init__(parameters(), payload, {**start, **values})

    def _gyros(self, gyro_a: float) -> dict[float, float]:
        """Return the weights of both gyros by station, the first at another one."""
        b, share = float(self.gyro_b), float(self.share)
        return {gyro_a: 1.0} if gyro_a == b else {gyro_a: 1 - share, b: share}

    def limits(self, gyro_a: float | None = None) -> Limits:
        """Return the limits under the sliders, or with ``gyro_a`` at another station (ft)."""
        at = float(self.gyro_a if gyro_a is None else gyro_a)
        return limits(blended(self._eqs[str(self.gravity)], self._gyros(at)))

    def drawings(self) -> list[Drawing]:
        """Return the bound over the station of gyro a."""
        stations = np.arange(0.0, 421.0, 3.0)
        peaks = np.array([self.limits(x).peak for x in stations])
        return [partial(draw_bounds, stations=stations, bounds={"bound": peaks})]


def peak_bound_explorer(**values: Value) -> PeakBound:
    """Return the live view of the least peak of the sensitivity, for the report's vehicle.

    Parameters
    ----------
    **values : float or str
        Where the sliders start: gyro_a, gyro_b (ft, whole), share (of gyro b), bandwidth (rad/s),
        gravity ("left out" or "kept").

    Returns
    -------
    PeakBound

    Raises
    ------
    ValueError
        If a value is not finite or out of range.
    TypeError
        If a value is not of its kind or a parameter is unknown.
    """
    return PeakBound(**values)
