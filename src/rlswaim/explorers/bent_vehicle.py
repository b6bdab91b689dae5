"""The live view of Section I: the bent vehicle and the forces that bend and turn it."""

from collections.abc import Mapping
from dataclasses import replace
from math import degrees, radians

import numpy as np

from rlswaim.explorers.bench import own_bench
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import FEET, Parameter, Value
from rlswaim.explorers.still import Drawing
from rlswaim.figures.style import COLORS
from rlswaim.figures.vehicle import draw_elastic_axis
from rlswaim.source.tables import constants
from rlswaim.vehicle import trajectory
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import ROWS, perturbation_equations

ANGLES = ("theta", "alpha", "delta")
MOTIONS = {"q_1": "q1", "q_2": "q2", "alpha": "alpha", "delta": "delta"}
"""Sliders that change a force, and the columns of Eq. 29 that hold their coefficients."""
FIGURE_2 = {"q_1": 3.0, "q_2": 2.0, "theta": 4.0, "alpha": 0.0, "delta": 15.0}


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: q_1, q_2 (ft), theta, alpha and delta (degrees)."""
    feet, small = np.linspace(-3, 3, 61), np.linspace(-6, 6, 61)

    def slider(name: str, label: str, unit: str, meaning: str, places: np.ndarray) -> Parameter:
        return Parameter(name, label, unit, meaning, tuple(places.round(3).tolist()))

    return (
        slider("q_1", r"\(q_1\)", "ft", "q_1, first bending mode, positive up (ft)", feet),
        slider("q_2", r"\(q_2\)", "ft", "q_2, second bending mode, positive up (ft)", feet),
        slider("theta", r"\(\theta\)", "deg", "theta, pitch angle, nose up (degrees)", small),
        slider("alpha", r"\(\alpha\)", "deg", "alpha, angle of attack (degrees)", small),
        slider("delta", r"\(\delta\)", "deg", "delta, thrust deflection, exhaust up (degrees)", 2.5 * small),
    )


def forces(booster: Booster) -> dict[str, dict[str, dict[str, float]]]:
    """Return what each source gives to F_z, M_y, Q_1z and Q_2z for one unit of each motion.

    Parameters
    ----------
    booster : Booster

    Returns
    -------
    dict
        ``[source][row][motion]``: source "thrust" or a surface's name; row Z (F_z in lb, down), M (M_y
        in ft lb, nose up), F1 or F2 (Q_iz in lb); motions q_1, q_2 (per ft), alpha, delta (per degree)
        [Eqs. 14-17, 22-28].
    """
    alone = {"thrust": replace(booster, surfaces=())}
    alone |= {s.name: replace(booster, surfaces=(s,), T=0.0) for s in booster.surfaces}
    return {name: _loads(vehicle) for name, vehicle in alone.items()}


def _loads(booster: Booster) -> dict[str, dict[str, float]]:
    """Return Eq. 29's coefficients times the inertias: the loads, without the structure's stiffness."""
    inertia = (-booster.M, -booster.I_y, *(mode.mass for mode in booster.modes))
    c = dict(perturbation_equations(booster).coefficients)
    for i, mode in enumerate(booster.modes, start=1):
        c[f"F{i}_q{i}"] -= mode.omega**2
    return {
        row: {
            motion: weight * c[f"{row}_{column}"] * (radians(1) if motion in ANGLES else 1.0)
            for motion, column in MOTIONS.items()
        }
        for row, weight in zip(ROWS, inertia, strict=True)
    }


def _source(booster: Booster, name: str, rows: Mapping[str, Mapping[str, float]]) -> dict:
    """Return one source for the script: place, loads, and degrees of local angle of attack for each unit."""
    at = {s.name: s.station for s in booster.surfaces}.get(name, booster.thrust_station)
    turn = {f"q_{i}": degrees(mode.slope(at)) for i, mode in enumerate(booster.modes, start=1)}
    return {"name": name, "station": at, "rows": rows, "incidence": {"alpha": 1.0, **turn}}


class BentVehicle(LiveView):
    """The vehicle of Section I under sliders; ``loads()`` are the sums behind the picture."""

    view, system = "bent-vehicle", "bent-vehicle"

    def __init__(self, booster: Booster, **values: Value) -> None:
        self._booster, self.forces, feet = booster, forces(booster), np.array(FEET, float)
        W, gamma_0 = (
            booster.M * constants("vehicle")["g"],
            trajectory.level_at_burnout(trajectory.swaim_ascent()),
        )
        straight = dict.fromkeys(FIGURE_2, 0.0)
        one = {**straight, "q_1": 1.0}
        against = degrees(booster.modes[0].slope(booster.thrust_station))
        presets = [
            ("Straight", "no motion: no force across", straight),
            ("Mode 1", "the first mode alone, by one foot", one),
            ("Mode 2", "the second mode alone, by one foot", {**straight, "q_2": 1.0}),
            (
                "Thrust straight",
                "the thrust swung back as far as mode 1 turns it",
                {**one, "delta": against},
            ),
            ("Wind", "two degrees of angle of attack", {**straight, "alpha": 2.0}),
            ("Figure 2", "the motions of the printed figure", FIGURE_2),
        ]
        payload = {
            "shapes": {
                f"phi_{i}": np.round(m.deflection(feet), 5).tolist() for i, m in enumerate(booster.modes, 1)
            },
            "sources": [_source(booster, name, rows) for name, rows in self.forces.items()],
            "thrust": booster.T,
            "l_CG": booster.l_CG,
            "weight": {"force": W, "gamma_0": degrees(gamma_0(booster.flight.t))},
            "colors": {n: COLORS[n] for n in ("rigid", "mode 1", "mode 2", "actuator", "neutral")},
            "presets": [{"name": n, "label": label, "values": v} for n, label, v in presets],
            "bench": own_bench(booster),
        }
        super().__init__(parameters(), payload, {**FIGURE_2, "delta": 6.0, **values})

    def drawings(self) -> list[Drawing]:
        """Return the elastic axis under the sliders."""
        at = {name: float(value) for name, value in self.values().items() if name != "alpha"}
        turned = {name: radians(value) if name in ANGLES else value for name, value in at.items()}
        return [lambda ax: draw_elastic_axis(ax, self._booster, **turned)]

    def loads(self) -> dict[str, float]:
        """Return the sums under the sliders: F_z (lb), M_y (ft lb), Q_1z and Q_2z (lb) as Z, M, F1, F2."""
        at = self.values()
        return {
            row: sum(
                rows[row][motion] * float(at[motion]) for rows in self.forces.values() for motion in MOTIONS
            )
            for row in ROWS
        }


def bent_vehicle_explorer(booster: Booster, **values: Value) -> BentVehicle:
    """Return the live view of the bent vehicle with its forces.

    Parameters
    ----------
    booster : Booster
    **values : float
        Where the sliders start: q_1, q_2 (ft, up), theta, alpha, delta (degrees).

    Returns
    -------
    BentVehicle

    Raises
    ------
    ValueError
        If a value is not finite.
    TypeError
        If a value is not a real number or a parameter is unknown.

    Notes
    -----
    Figure 2, Eqs. 10 to 28.
    """
    return BentVehicle(booster, **values)
