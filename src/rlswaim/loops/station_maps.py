"""Section VII's closed loop at many pairs of stations at once: the map over sensor and jet."""

import os
from functools import partial

import xarray as xr
from numpy.typing import ArrayLike

from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.loops.sweep import sweep
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.stations import as_stations


def station_map(
    eqs: PerturbationEquations,
    sensors: ArrayLike,
    jets: ArrayLike,
    *,
    path: str | os.PathLike[str] | None = None,
    progress: bool = False,
    **gains: float,
) -> xr.DataArray:
    """Return the largest real part of Section VII's closed-loop poles over sensor and jet stations.

    Parameters
    ----------
    eqs : PerturbationEquations
    sensors, jets : array_like
        Stations (ft); all pairs are computed, where `joblib.parallel_config` says.
    path : path-like, optional
        NetCDF file that keeps the result, and lets a killed run go on.
    progress : bool
        Whether a progress bar is shown.
    **gains : float
        K_A, K_C, K_R, kK_z, K_r and b of `dual_actuation`.

    Returns
    -------
    xarray.DataArray
        Dimensions sensor and jet (ft); values in 1/s.

    Raises
    ------
    ValueError
        If a station lies outside 0..420 ft or a gain is not finite.
    TypeError
        If a gain is missing, unknown or no real number.
    """
    return sweep(
        partial(DUAL_ACTUATION.around(eqs).abscissas, **gains),
        {
            "sensor": as_stations("sensors", sensors, "station_map"),
            "jet": as_stations("jets", jets, "station_map"),
        },
        name="spectral_abscissa",
        unit="1/s",
        units={"sensor": "ft", "jet": "ft"},
        path=path,
        key=f"{sorted(gains.items())} {eqs.source} {sorted(eqs.coefficients.items())}",
        progress=progress,
    )
