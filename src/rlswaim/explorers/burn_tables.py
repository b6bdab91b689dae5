"""The vehicle of each second of the burn for the browser, and Eq. 29's coefficients as products of its data.

The vehicles are those of `practice.burn`: a mode's shape at a time is a sum of a line along the vehicle and
of the two shapes at 57.5 s, so that four weights a mode tell it.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from rlswaim.explorers.vehicle_sliders import nodes
from rlswaim.practice.burn import booster_at
from rlswaim.practice.dispersed import consistent_booster
from rlswaim.vehicle import eq_29
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.modes import BendingMode

END = 100
"""The last second (s) that the flights of chapter II's view reach."""
DIGITS = 12


def _as_seen_by(mode: BendingMode, other: BendingMode) -> BendingMode:
    """Return the curve through another mode's values at the places where this mode's are given."""
    return replace(
        mode,
        deflections=np.asarray(other.deflection(mode.stations)),
        slopes=np.asarray(other.slope(mode.slope_stations)),
    )


def _weights(mode: BendingMode, basis: list[BendingMode]) -> list[float]:
    """Return the sum of 1, l and the curves of ``basis`` that a mode is."""
    x = mode.stations
    columns = np.column_stack([np.ones(x.size), x, *(each.deflection(x) for each in basis)])
    return np.linalg.lstsq(columns, mode.deflections)[0].tolist()


@cache
def seconds() -> dict[str, Any]:
    """Return the vehicle at each whole second up to `END`: a row of numbers a second, and what they weigh.

    Returns
    -------
    dict
        ``rows``: M (slug), I_y (slug ft^2), l_CG (ft), omega_1, omega_2 (rad/s), then the four weights of
        each mode; ``curves``: by mode, the two that the last weights multiply.
    """
    own = consistent_booster()
    curves = [[_as_seen_by(mode, other) for other in own.modes] for mode in own.modes]
    rows = []
    for t in range(END + 1):
        vehicle = booster_at(t)
        numbers = [vehicle.M, vehicle.I_y, vehicle.l_CG, *(mode.omega for mode in vehicle.modes)]
        for mode, basis in zip(vehicle.modes, curves, strict=True):
            numbers += _weights(mode, basis)
        rows.append([float(f"{value:.{DIGITS}g}") for value in numbers])
    return {"rows": rows, "curves": [[nodes(mode) for mode in basis] for basis in curves]}


def places(booster: Booster) -> dict[str, float]:
    """Return the stations (ft) where forces act: the surfaces by name, and the thrust at G."""
    return {**{s.name: s.station for s in booster.surfaces}, "G": booster.thrust_station}


def coefficient_products(booster: Booster) -> dict[str, list[list[Any]]]:
    """Return Eq. 29's coefficients as sums of products of the data that change through the burn.

    Parameters
    ----------
    booster : Booster
        Its thrust, slopes, damping ratios and generalized masses stay.

    Returns
    -------
    dict
        Factors: q_D, per_U, per_M, per_I_y, omega_i and ``<shape>_<place>``.  Row Z is Eq. 29's times
        ``booster``'s U over the U of the time, as it enters the state equations.
    """
    count = len(booster.modes)
    found: dict[str, list[list[Any]]] = {name: [] for name in eq_29.coefficient_names(count)}
    for row, lever in eq_29.levers(count).items():
        weight, inertia = _per_inertia(booster, row)
        for column, products in _columns(booster, row, lever):
            found[f"{row}_{column}"] += [[weight * w, [*inertia, *factors]] for w, factors in products]
    for name, (weight, factors) in eq_29.structure(booster.modes).items():
        found[name].append([weight, list(factors)])
    return found


def _per_inertia(booster: Booster, row: str) -> tuple[float, list[str]]:
    if row == "Z":
        return booster.flight.U, ["per_U", "per_M"]
    if row == "M":
        return 1.0, ["per_I_y"]
    return 1 / booster.modes[int(row[1:]) - 1].mass, []


def _columns(
    booster: Booster, row: str, lever: eq_29.Shaped
) -> Iterator[tuple[str, list[tuple[float, list[str]]]]]:
    """Yield the air's and the thrust's parts of one row of Eq. 29, by column, without the inertia."""
    count, T = len(booster.modes), booster.T

    def at(place: str, *shapes: str) -> list[str]:
        return [f"{shape}_{place}" for shape in shapes if shape != "one"]

    for motion, incidence in eq_29.incidences(count).items():
        sign = lever.sign * incidence.sign * booster.S
        rate = ["per_U"] if incidence.rate else []
        yield (
            motion,
            [
                (sign * s.C_Nalpha, ["q_D", *rate, *at(s.name, lever.shape, incidence.shape)])
                for s in booster.surfaces
            ],
        )
    for i in range(1, count + 1):
        beside = [(T, at("G", f"phi_{i}"))] if row == "M" else []
        yield f"q{i}", [(T * lever.sign, at("G", lever.shape, f"sigma_{i}")), *beside]
    yield "delta", [(-T * lever.sign, at("G", lever.shape))]


def jet_products(booster: Booster) -> dict[str, list[list[Any]]]:
    """Return the jet's responses of Eq. 125 as such products."""
    generalized = {f"jet_F{i}": [[1 / m.mass, []]] for i, m in enumerate(booster.modes, start=1)}
    own = booster.flight.U
    return {"jet_Z": [[own, ["per_U", "per_M"]]], "jet_M": [[1.0, ["per_I_y"]]], **generalized}


def burn_plant() -> dict[str, Any]:
    """Return what the browser makes the vehicle of any time of the burn from."""
    booster = consistent_booster()
    return {
        "coefficients": {**coefficient_products(booster), **jet_products(booster), "Z_theta": [[0.0, []]]},
        "parameters": ["t", "upright", "level"],
        "burn": {**seconds(), "places": places(booster)},
    }
