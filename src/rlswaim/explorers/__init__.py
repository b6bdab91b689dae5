"""Live views: Python owns the physics, the browser evaluates the polynomials that Python sends."""

from rlswaim.explorers.ascent import ascent_explorer
from rlswaim.explorers.bent_vehicle import bent_vehicle_explorer
from rlswaim.explorers.comparison import Comparison, comparison_explorer
from rlswaim.explorers.control_systems import (
    dual_actuation_explorer,
    rate_attitude_explorer,
    single_sensor_explorer,
    two_sensor_explorer,
)
from rlswaim.explorers.coupled_vehicle import coupled_vehicle_explorer
from rlswaim.explorers.frozen_poles import frozen_poles_explorer
from rlswaim.explorers.greensite import greensite_explorer
from rlswaim.explorers.moving_loop import MovingLoop, moving_loop
from rlswaim.explorers.own_loop import OwnLoop, explore
from rlswaim.explorers.peak_bound import peak_bound_explorer
from rlswaim.explorers.presets import COMPARED, designs
from rlswaim.explorers.station_map import station_map_explorer
from rlswaim.explorers.workbench import Explorer
from rlswaim.loops.multiaffine import MultiAffine, multiaffine_forms

__all__ = [
    "COMPARED",
    "Comparison",
    "Explorer",
    "MovingLoop",
    "MultiAffine",
    "OwnLoop",
    "ascent_explorer",
    "bent_vehicle_explorer",
    "comparison_explorer",
    "coupled_vehicle_explorer",
    "designs",
    "dual_actuation_explorer",
    "explore",
    "frozen_poles_explorer",
    "greensite_explorer",
    "moving_loop",
    "multiaffine_forms",
    "peak_bound_explorer",
    "rate_attitude_explorer",
    "single_sensor_explorer",
    "station_map_explorer",
    "two_sensor_explorer",
]
