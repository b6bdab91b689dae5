"""Section VII's closed loop at many pairs of stations at once: the map over sensor and jet."""

import os
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Self

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from rlswaim.loops.sweep import sweep
from rlswaim.loops.systems import dual_actuation
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.stations import LENGTH, as_stations

SAMPLES = np.linspace(0, LENGTH, 9)
"""Stations (ft) at which closed loops are built; four would do."""


def _basis(modes: tuple[BendingMode, ...], stations: ArrayLike) -> NDArray:
    """Return what a station enters the equations by: 1, l, phi_1, phi_2; shape (m, 4)."""
    x = np.atleast_1d(np.asarray(stations, dtype=float))
    return np.column_stack([np.ones(x.size), x, *(mode.deflection(x) for mode in modes)])


@dataclass(frozen=True, eq=False)
class DualActuationFamily:
    """Closed-loop state matrices of `dual_actuation` at fixed gains, as functions of the two stations.

    The sensor's station enters one row of the matrix and the jet's one column, both affinely in
    l, phi_1 and phi_2: a few closed loops fix them.
    """

    modes: tuple[BendingMode, ...]
    matrix: NDArray
    jet_state: int
    rows: NDArray
    columns: NDArray

    @classmethod
    def of(cls, eqs: PerturbationEquations, **gains: float) -> Self:
        """Return the family of `dual_actuation` at gains K_A, K_C, K_R, kK_z, K_r and b."""

        def matrices(where: Callable[[float], dict[str, float]]) -> NDArray:
            return np.array([dual_actuation(eqs, **gains, **where(x)).A for x in SAMPLES])

        by_sensor = matrices(lambda x: {"sensor": x, "jet": SAMPLES[0]})
        by_jet = matrices(lambda x: {"sensor": SAMPLES[0], "jet": x})
        jet_state = by_sensor.shape[1] - 1
        basis = _basis(eqs.modes, SAMPLES)
        rows = np.linalg.lstsq(basis, by_sensor[:, jet_state, :], rcond=None)[0]
        columns = np.linalg.lstsq(basis, by_jet[:, :, jet_state], rcond=None)[0]
        return cls(eqs.modes, by_sensor[0], jet_state, rows, columns)

    def matrices(self, sensor: ArrayLike, jet: ArrayLike) -> NDArray:
        """Return the state matrices (m, 9, 9) at m sensor and m jet stations (ft)."""
        x = as_stations("sensor", np.atleast_1d(sensor), "DualActuationFamily")
        y = as_stations("jet", np.atleast_1d(jet), "DualActuationFamily")
        A = np.repeat(self.matrix[None], x.size, axis=0)
        A[:, :, self.jet_state] = _basis(self.modes, y) @ self.columns
        A[:, self.jet_state, :] = _basis(self.modes, x) @ self.rows
        return A

    def __call__(self, sensor: NDArray, jet: NDArray) -> NDArray:
        """Return the largest real part of the poles (1/s) at each pair of stations; shape (m,)."""
        return np.linalg.eigvals(self.matrices(sensor, jet)).real.max(axis=1)


def station_map(
    eqs: PerturbationEquations,
    sensors: ArrayLike,
    jets: ArrayLike,
    *,
    executor: Executor | None = None,
    path: str | os.PathLike[str] | None = None,
    progress: bool = False,
    **gains: float,
) -> xr.DataArray:
    """Return the largest real part of Section VII's closed-loop poles over sensor and jet stations.

    Parameters
    ----------
    eqs : PerturbationEquations
    sensors, jets : array_like
        Stations (ft); all pairs are computed.
    executor : concurrent.futures.Executor, optional
        Where chunks run.
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
    family = DualActuationFamily.of(eqs, **gains)
    return sweep(
        family,
        {
            "sensor": as_stations("sensors", sensors, "station_map"),
            "jet": as_stations("jets", jets, "station_map"),
        },
        executor,
        name="spectral_abscissa",
        unit="1/s",
        units={"sensor": "ft", "jet": "ft"},
        path=path,
        key=f"{sorted(gains.items())} {eqs.source} {sorted(eqs.coefficients.items())}",
        progress=progress,
    )
