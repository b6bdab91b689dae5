"""Designs in the winds of ``data/winds.csv``: a wind shear with a gust on top, and turbulence."""

import numpy as np

from rlswaim.practice.criteria import DEG, with_motion
from rlswaim.practice.designs import Design, moved
from rlswaim.practice.gusts import dryden, response, rms, shear_with_gust
from rlswaim.practice.optimal import MIDDLE
from rlswaim.source.tables import constants
from rlswaim.vehicle.booster import Booster

SHOWN = {
    "incidence": DEG,
    "theta": DEG,
    "delta": DEG,
    "delta_r": 1.0,
    f"moment {MIDDLE:g}": 1.0,
    "drift": 1.0,
}
"""Outputs, and what one unit of them counts: deg, lb, lb ft, ft/s."""
SHEAR = ("wind", "build_up", "gust", "edge", "plateau")


def in_shear(design: Design, booster: Booster, horizon: float = 60.0) -> dict[str, float]:
    """Return the peaks of a design in the wind shear with the gust on top, the vehicle frozen.

    Parameters
    ----------
    design : Design
    booster : Booster
    horizon : float
        In s.

    Returns
    -------
    dict of str to float
        By the outputs of `SHOWN` that there are.
    """
    system, given = with_motion(moved(design, booster), booster.flight.U), constants("winds")
    t = np.arange(0, horizon, 0.02)
    wind = shear_with_gust(t, **{name: given[name] for name in SHEAR}) / booster.flight.U
    found = response(system, t, wind)
    return {name: float(np.abs(found[name]).max()) * unit for name, unit in SHOWN.items() if name in found}


def in_turbulence(design: Design, booster: Booster) -> dict[str, float]:
    """Return the RMS of a design's outputs in turbulence.

    Parameters
    ----------
    design : Design
    booster : Booster

    Returns
    -------
    dict of str to float
        As in `in_shear`; nan for a loop with a root right of the axis, be it slow.
    """
    system, given, U = (
        with_motion(moved(design, booster), booster.flight.U),
        constants("winds"),
        booster.flight.U,
    )
    names = [name for name in SHOWN if name in system.output_labels]
    if system.poles().real.max() >= 0:
        return dict.fromkeys(names, float("nan"))
    found = rms(system, dryden(given["sigma"] / U, given["length"], U))
    return {name: found[name] * SHOWN[name] for name in names}
