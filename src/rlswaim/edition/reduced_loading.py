"""Section II's claim that what can be handled at the worst condition can be handled at less loading.

Fixed gains are judged over the dynamic pressure, from none to the worst, and over the burn of the first
stage.  Each vehicle is `swaim_booster` in another flight condition.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from rlswaim.edition.designs import designs, found_gains
from rlswaim.edition.search import winners
from rlswaim.edition.slow_roots import abscissas
from rlswaim.loops.closed_loops import state_space
from rlswaim.vehicle.booster import Booster, FlightCondition
from rlswaim.vehicle.equations import perturbation_equations
from rlswaim.vehicle.trajectory import Ascent, PitchProgram, fly

Gains = tuple[str, Mapping[str, float]]
"""A system of `rlswaim.loops.closed_loops.LOOPS`, and its gains and stations."""
VehicleAt = Callable[[float], Booster]


def stable_designs() -> dict[str, Gains]:
    """Return designs of this edition that leave at most a slow root unstable at the worst condition."""
    best = {(w.system, w.objective): (w.system, w.gains) for w in winners()}
    return {
        "jet, by hand": ("dual_actuation", found_gains("dual_actuation")),
        "modest jet, pair held": best["modest_jet", "pair-all"],
        "jet, all free, pair held": best["dual_actuation", "pair-all"],
        "Figure 25's jet": best["figure_25", "all"],
        "one sensor, a slow root apart": best["single_sensor", "apart"],
    }


def report_designs() -> dict[str, Gains]:
    """Return the report's last design of each control system, by the name of its figure."""
    systems = {"IV": "rate_attitude", "V": "single_sensor", "VI": "two_sensor", "VII": "dual_actuation"}
    last = {"IV": "Figure 8", "V": "Figure 16", "VI": "Figure 20", "VII": "Figure 25"}
    chosen = {section: designs(section)[name] for section, name in last.items()}
    numbers = {s: {n: v for n, v in g.items() if not isinstance(v, str)} for s, g in chosen.items()}
    return {last[section]: (systems[section], numbers[section]) for section in last}


def at_less_pressure(booster: Booster) -> VehicleAt:
    """Return the vehicle as a function of the share of its dynamic pressure; speed and masses are kept."""
    return lambda share: replace(booster, flight=replace(booster.flight, q_D=share * booster.flight.q_D))


def along_the_burn(booster: Booster, ascent: Ascent, gamma_0: PitchProgram) -> VehicleAt:
    """Return the vehicle as a function of the time (s) from launch: q_D, U and mass of an integrated flight.

    The source gives no more of the other times: inertia, center of gravity, mode shapes, generalized
    masses and frequencies are those of the worst condition.

    Parameters
    ----------
    booster : Booster
    ascent : Ascent
    gamma_0 : callable
        Pitch program: flight path angle (rad) at time (s).
    """
    flown = fly(ascent, gamma_0, np.arange(0, ascent.t_burn, 0.05))

    def vehicle(t: float) -> Booster:
        at = flown.at(t)
        flight = FlightCondition(at["q_D"], at["U"], at["h"], t, gamma_0(t))
        return replace(booster, M=float(ascent.mass(t)), flight=flight)

    return vehicle


def abscissa(booster: Booster, design: Gains) -> float:
    """Return the largest real part (1/s) of a closed loop's poles, a slow real one left out.

    Parameters
    ----------
    booster : Booster
    design : tuple
        System and gains.
    """
    poles = state_space(perturbation_equations(booster), *design).poles()
    return float(abscissas(poles[None], apart=True)[0])


def course(vehicle_at: VehicleAt, design: Gains, values: ArrayLike) -> NDArray:
    """Return the `abscissa` (1/s) for each value.

    Parameters
    ----------
    vehicle_at : callable
        The vehicle as a function of one number: `at_less_pressure` or `along_the_burn`.
    design : tuple
        System and gains.
    values : array_like, shape (N,)
        Shares of the dynamic pressure, or times (s).

    Returns
    -------
    ndarray, shape (N,)
    """
    return np.array([abscissa(vehicle_at(float(value)), design) for value in np.asarray(values)])


def changes(vehicle_at: VehicleAt, design: Gains, values: ArrayLike) -> list[float]:
    """Return where a loop becomes stable or unstable, solved for between the values.

    Parameters
    ----------
    vehicle_at, design, values
        As in `course`.

    Returns
    -------
    list of float
        Shares or times, increasing.
    """
    points, found = np.asarray(values, dtype=float), course(vehicle_at, design, values) >= 0
    at = np.flatnonzero(found[1:] != found[:-1])
    return [
        float(brentq(lambda x: abscissa(vehicle_at(x), design), points[i], points[i + 1], xtol=1e-9))
        for i in at
    ]
