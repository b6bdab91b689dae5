"""The live view over all sensor and jet stations of Section VII: where the closed loop is stable."""

from typing import Any

import control
import ipywidgets as widgets
import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex

from rlswaim.edition import table_3
from rlswaim.edition.conclusions import found_gains
from rlswaim.explorers import presets
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import Value
from rlswaim.explorers.still import Drawing
from rlswaim.explorers.system_views import DUAL_ACTUATION
from rlswaim.figures.stations import draw_station_map
from rlswaim.figures.style import COLORS
from rlswaim.loops.station_maps import station_map
from rlswaim.vehicle.equations import PerturbationEquations


def designs() -> dict[str, dict[str, Value]]:
    """Return the pair that works and the report's own design, as values of the sliders."""
    printed = presets.designs("VII")
    return {
        "The pair that works": {**found_gains("dual_actuation")},
        "Figure 24": printed["Figure 24"],
        "Figure 25, K_A = 3": {**printed["Figure 25"], "K_A": 3.0},
    }


class StationMap(LiveView):
    """The map over all pairs of stations at the sliders' gains; ``closed_loop()`` is that of the pair."""

    view, system = "station-map", "station-map"

    def __init__(
        self, eqs: PerturbationEquations, beside: widgets.Widget | None = None, **values: Value
    ) -> None:
        self._eqs, chosen = eqs, designs()
        payload = {
            "terms": [term._asdict() for term in DUAL_ACTUATION.system.polynomial(eqs).terms],
            "shapes": DUAL_ACTUATION.shape_values(eqs),
            "pairs": [{"case": case, "sensor": int(z), "jet": int(r)} for case, z, r in table_3.pairs()],
            "palette": [to_hex(colormaps["PuOr_r"](place)) for place in np.linspace(0, 1, 129)],
            "colors": {"pair": COLORS["rigid"], "table": COLORS["neutral"]},
            "presets": [{"name": n, "label": "gains and stations", "values": v} for n, v in chosen.items()],
        }
        start = {**chosen["The pair that works"], **values}
        super().__init__(DUAL_ACTUATION.parameters(eqs), payload, start, beside)

    def drawings(self) -> list[Drawing]:
        """Return the map at every tenth foot, with the pair under the sliders."""
        gains: dict[str, Any] = {name: float(value) for name, value in self.values().items()}
        sensor, jet = gains.pop("sensor"), gains.pop("jet")
        feet = np.arange(0.0, 421.0, 10.0)
        abscissa = station_map(self._eqs, feet, feet, **gains)
        return [lambda ax: draw_station_map(ax, abscissa).plot(sensor, jet, "k+", ms=12, mew=2)]

    def closed_loop(self) -> control.StateSpace:
        """Return the closed loop of the pair and the gains under the sliders."""
        return DUAL_ACTUATION.closed_loop(self._eqs, **self.values())


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
