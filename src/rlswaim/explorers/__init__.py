"""Live views: Python owns the physics, the browser evaluates the polynomials that Python sends."""

from rlswaim.explorers.control_systems import (
    dual_actuation_explorer,
    rate_attitude_explorer,
    single_sensor_explorer,
    two_sensor_explorer,
)
from rlswaim.explorers.multiaffine import MultiAffine, multiaffine_forms
from rlswaim.explorers.presets import COMPARED, designs
from rlswaim.explorers.widget import Explorer

__all__ = [
    "COMPARED",
    "Explorer",
    "MultiAffine",
    "designs",
    "dual_actuation_explorer",
    "multiaffine_forms",
    "rate_attitude_explorer",
    "single_sensor_explorer",
    "two_sensor_explorer",
]
