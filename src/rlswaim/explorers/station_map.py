"""The live view over all sensor and jet stations of Section VII: where the closed loop is stable."""

from collections.abc import Iterator, Sequence
from functools import partial, reduce
from itertools import product
from typing import Any

import control
import ipywidgets as widgets
import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex
from numpy.typing import ArrayLike, NDArray

from rlswaim.dual import coupling_numerator, final_design
from rlswaim.evidence.conclusions import found_gains
from rlswaim.explorers.live import LiveView, module, whole_between
from rlswaim.explorers.multiaffine import MultiAffine, Term, with_shapes
from rlswaim.explorers.still import Drawing
from rlswaim.explorers.widget import Parameter, Value
from rlswaim.figures.stations import draw_station_map
from rlswaim.figures.style import COLORS
from rlswaim.perturbation import PerturbationEquations
from rlswaim.stations import station_map
from rlswaim.systems import dual_actuation
from rlswaim.tables import column, constants

FACTORS = ("K_A", "K_C", "K_R", "kK_z", "K_r", "b", "phi_1_z", "phi_2_z", "arm_r", "phi_1_r", "phi_2_r")
"""Gains, deflections at the sensor (z), and the jet's arm l_r - l_CG and deflections there (r)."""
Part = tuple[tuple[str, ...], NDArray]
"""Some factors and the polynomial that they multiply, constant term first."""


def _multiplied(*sums: Sequence[Part]) -> Iterator[Part]:
    """Yield the terms of a product of sums."""
    for parts in product(*sums):
        yield sum((names for names, _ in parts), ()), reduce(np.convolve, (p for _, p in parts))


def _by_jet(eqs: PerturbationEquations, output: str, thrust: str | None = None) -> Iterator[Part]:
    """Yield what the jet enters a numerator by, or with ``thrust`` the coupling numerator: by factor."""

    def numerator(arm: float, phi_1: float, phi_2: float) -> NDArray:
        at = eqs.l_CG + arm
        here = with_shapes(eqs, deflections={at: (phi_1, phi_2)})
        if thrust:
            return coupling_numerator(here, thrust, output, at)
        return here.numerator(output, "delta_r", at)

    alone = numerator(0, 0, 0)
    yield (), alone
    for name, where in {"arm_r": (1, 0, 0), "phi_1_r": (0, 1, 0), "phi_2_r": (0, 0, 1)}.items():
        yield (name,), numerator(*where) - alone


def form(eqs: PerturbationEquations) -> MultiAffine:
    """Return Section VII's characteristic polynomial in FACTORS, as a sum of terms [Eqs. 129, 133, 134].

    It is (s + K_C) times closure 1's polynomial plus K_A K_C (K_R s + 1) times that of closure 2 over Delta.
    """

    def lag(name: str) -> list[Part]:
        return [((), np.array([0.0, 1.0])), ((name,), np.array([1.0]))]

    def with_jet(base: NDArray, numerators: Sequence[Sequence[Part]]) -> list[Part]:
        loop: list[Part] = [(("kK_z", "K_r"), np.array([-1.0]))]
        found = [*_multiplied(lag("K_r"), [((), base)])]
        for name, parts in zip(("phi_1_z", "phi_2_z"), numerators, strict=True):
            found += _multiplied(loop, lag("b"), [((name,), np.array([1.0]))], parts)
        return found

    modes = ("q1", "q2")
    jet = with_jet(eqs.characteristic_polynomial(), [[*_by_jet(eqs, q)] for q in modes])
    thrust = with_jet(eqs.numerator("theta", "delta"), [[*_by_jet(eqs, q, "theta")] for q in modes])
    attitude: list[Part] = [(("K_A", "K_C"), np.array([1.0])), (("K_A", "K_C", "K_R"), np.array([0.0, 1.0]))]
    return _collected([*_multiplied(lag("K_C"), jet), *_multiplied(attitude, thrust)])


def _collected(parts: Sequence[Part]) -> MultiAffine:
    """Return the parts as one form: terms of the same factors added, all of order nine."""
    sums: dict[tuple[str, ...], NDArray] = {}
    for names, polynomial in parts:
        key = tuple(f for f in FACTORS if f in names)
        padded = np.zeros(10)
        padded[: min(10, polynomial.size)] = polynomial[:10]
        sums[key] = sums.get(key, np.zeros(10)) + padded
    return MultiAffine(FACTORS, tuple(Term(key, tuple(c.tolist())) for key, c in sums.items() if c.any()))


def designs() -> dict[str, dict[str, Value]]:
    """Return the pair that works and the report's own design, as values of the sliders."""
    loop, kK_z = final_design()
    chosen = constants("section_7")
    report = {"kK_z": kK_z, **loop._asdict(), "K_C": chosen["K_C"], "K_R": chosen["K_R"]}
    named = {
        "The pair that works": found_gains("dual_actuation"),
        "Figure 24": {**report, "K_A": 0.0},
        "Figure 25, K_A = 3": {**report, "K_A": 3.0},
    }
    whole = ("sensor", "jet")
    return {n: {k: int(v) if k in whole else v for k, v in d.items()} for n, d in named.items()}


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: the gains of Section VII and both stations."""

    def signed(low: float, high: float, count: int) -> NDArray:
        size = np.geomspace(low, high, count)
        return np.concatenate([-size, [0.0], size])

    def grid(name: str, places: ArrayLike) -> tuple[float, ...]:
        rounded = [float(f"{place:.3g}") for place in np.ravel(places)]
        return tuple(np.union1d(rounded, [float(d[name]) for d in designs().values()]).tolist())

    station = partial(whole_between, low=0, high=420, unit="ft")
    gains = {
        "K_A": (r"\(K_A\)", "", "amplifier gain (rad/rad)", signed(0.01, 100, 121)),
        "K_C": (r"\(K_C\)", "1/s", "actuator gain (1/s)", np.geomspace(0.1, 100, 121)),
        "K_R": (r"\(K_R\)", "s", "rate gyro gain (s)", np.linspace(-1, 1, 101)),
        "kK_z": (r"\(kK_z\)", "lb s/ft", "jet times sensor gain (lb s/ft)", signed(1e3, 1e10, 141)),
        "K_r": (r"\(K_r\)", "1/s", "gain of the jet's valve (1/s)", np.geomspace(0.1, 100, 121)),
        "b": (r"\(b\)", "1/s", "ratio of displacement to rate (1/s)", np.linspace(0, 10, 101)),
    }
    return (
        *(Parameter(n, label, unit, f"{n}, {m}", grid(n, at)) for n, (label, unit, m, at) in gains.items()),
        Parameter("sensor", "Sensor", "ft", "station of the sensor (ft)", tuple(range(421)), station),
        Parameter("jet", "Jet", "ft", "station of the jet (ft)", tuple(range(421)), station),
    )


class StationMap(LiveView):
    """The map over all pairs of stations at the sliders' gains; ``closed_loop()`` is that of the pair."""

    system = "station-map"
    _esm = module("roots", "abscissa", "live", "plot", "station_map")

    def __init__(
        self, eqs: PerturbationEquations, beside: widgets.Widget | None = None, **values: Value
    ) -> None:
        self._eqs, feet, presets = eqs, np.arange(421.0), designs()
        phi = {f"phi_{i}": mode.deflection(feet) for i, mode in enumerate(eqs.modes, start=1)}
        shapes = {"arm_r": ("jet", feet - eqs.l_CG)}
        for name, deflection in phi.items():
            shapes |= {f"{name}_z": ("sensor", deflection), f"{name}_r": ("jet", deflection)}
        cases = zip(*(column("table3", name) for name in ("case", "sensor_ft", "jet_ft")), strict=True)
        payload = {
            "terms": [term._asdict() for term in form(eqs).terms],
            "shapes": {n: {"at": at, "values": values.tolist()} for n, (at, values) in shapes.items()},
            "worker": module("roots", "abscissa", "map_worker"),
            "pairs": [{"case": int(c), "sensor": int(s), "jet": int(j)} for c, s, j in cases],
            "palette": [to_hex(colormaps["PuOr_r"](place)) for place in np.linspace(0, 1, 129)],
            "colors": {"pair": COLORS["rigid"], "table": COLORS["neutral"]},
            "presets": [{"name": n, "label": "gains and stations", "values": v} for n, v in presets.items()],
        }
        super().__init__(parameters(), payload, {**presets["The pair that works"], **values}, beside)

    def drawings(self) -> list[Drawing]:
        """Return the map at every tenth foot, with the pair under the sliders."""
        gains: dict[str, Any] = {name: float(value) for name, value in self.values().items()}
        sensor, jet = gains.pop("sensor"), gains.pop("jet")
        feet = np.arange(0.0, 421.0, 10.0)
        abscissa = station_map(self._eqs, feet, feet, **gains)
        return [lambda ax: draw_station_map(ax, abscissa).plot(sensor, jet, "k+", ms=12, mew=2)]

    def closed_loop(self) -> control.StateSpace:
        """Return the closed loop of the pair and the gains under the sliders."""
        return dual_actuation(self._eqs, **{name: float(value) for name, value in self.values().items()})


def station_map_explorer(
    eqs: PerturbationEquations, beside: widgets.Widget | None = None, **values: Value
) -> StationMap:
    """Return the live map of the largest real part of Section VII's poles over all pairs of stations.

    Parameters
    ----------
    eqs : PerturbationEquations
    beside : Widget, optional
        The workbench of Section VII on the same page: gains and stations then are its.
    **values : float
        Where the sliders start: K_A, K_C (1/s), K_R (s), kK_z (lb s/ft), K_r (1/s), b (1/s),
        sensor and jet (ft, whole); what is not given is that of the pair that works.

    Returns
    -------
    StationMap

    Raises
    ------
    ValueError
        If a gain is not finite or a station is not a whole number of feet on the vehicle.
    TypeError
        If a value is not a real number or a parameter is unknown.

    Notes
    -----
    Table 3, Figures 24 and 25, Eqs. 129 to 137.
    """
    return StationMap(eqs, beside, **values)
