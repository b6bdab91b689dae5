"""The workbench's card of criteria: what the browser evaluates `practice.criteria` from, and its rows."""

from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import Any

import control

from rlswaim.explorers.parameter import FEET
from rlswaim.explorers.vehicle_sliders import DATA, vehicle_at
from rlswaim.loops.control_systems import ControlSystem
from rlswaim.loops.cut_loop import cut_loop
from rlswaim.practice import criteria, gusts
from rlswaim.practice.loads import moment_terms, section_loads, with_moments
from rlswaim.practice.margins import NEAR
from rlswaim.practice.optimal import MIDDLE
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations
from rlswaim.vehicle.other_data import with_data

STATIONS = (100.0, MIDDLE, 300.0)
"""Where the bending moment is asked (ft)."""
BENDING = {"bending 1": ("omega_1", 1.0), "bending 2": ("omega_2", 1.0)}
"""The bending modes by name: the parameter that is the frequency of each, and rad/s in one unit of it."""
SAYS = {
    "settling": ("theta", "settles"),
    "alpha_deg": ("alpha", "with the gust, largest"),
    "delta_deg": ("delta", "largest"),
    "delta_rate_deg_s": ("delta", "rate, largest"),
    "jet_lb": ("delta_r", "largest"),
    "drift_ft_s": ("", "drift, largest"),
    "drift_m_s": ("", "drift, largest"),
}
"""Each criterion in time: its symbol, and what is asked of it."""
MARGINS = {"gain_dB": "gain margin", "phase_deg": "phase margin", "delay_s": "delay margin"}

NOTE = (
    "Bounds and rows are those of chapter XVI. The loop is linear: the card cannot tell what limits of the "
    "engine and of the jet do."
)
ROUGH = "The forces on this vehicle do not balance, so its bending moment is a rough size."
WITHOUT = (
    "The bending moment is left out: it is known only where masses and surfaces stay as the report has them."
)
"""What the card says of its own limits."""


def engine_gains(system: ControlSystem) -> list[str]:
    """Return the gains whose signals make the engine's command: without them, its loop is open.

    Parameters
    ----------
    system : ControlSystem
    """
    return [name for name in ("K_A", "K_z", "K_za", "K_zb") if name in system.gains]


def _peaks(
    system: ControlSystem, booster: Booster, eqs: PerturbationEquations, stations: tuple[float, ...]
) -> list[dict[str, Any]]:
    """Return the criteria in a gust: the outputs, derivatives and data that make each, with its words."""
    motions: dict[str, list[tuple[str, int, float, tuple[str, ...]]]] = {
        "incidence": [("alpha", 0, 1.0, ()), ("alpha_g", 0, 1.0, ())],
        "delta": [("delta", 0, 1.0, ())],
        "delta_rate": [("delta", 1, 1.0, ())],
        "delta_r": [("delta_r", 0, 1.0, ())],
        "drift": [("alpha", 0, 1.0, ("U",)), ("theta", 0, -1.0, ("U",))],
    }
    found: list[dict[str, Any]] = [
        {"name": name, "terms": motions[output], "factor": factor, "unit": criteria.UNITS[name]}
        for name, (output, factor) in criteria.GUST_PEAKS.items()
        if output != "delta_r" or output in system.outputs
    ]
    for station in stations:
        terms = [t for t in moment_terms(booster, eqs, station) if t.quantity in (*system.outputs, "alpha_g")]
        lever = {"lever": [max(station - x, 0.0) for x in FEET]} if "jet" in system.stations else {}
        found.append({"name": f"moment {station:g}", "terms": terms, "factor": 1.0, "unit": "lb ft", **lever})
    return found


def _words(name: str) -> dict[str, str]:
    """Return the symbol of a criterion in time, and what is asked of it."""
    said = f"bending moment at {name.removeprefix('moment ')} ft, largest"
    symbol, says = SAYS.get(name, ("", said))
    return {"symbol": symbol, "says": says}


def sent_criteria(
    system: ControlSystem, eqs: PerturbationEquations, stations: tuple[float, ...] = STATIONS
) -> dict[str, Any]:
    """Return what the browser evaluates the criteria from; it knows the loop itself already.

    Parameters
    ----------
    system : ControlSystem
    eqs : PerturbationEquations
    stations : tuple of float
        Where the bending moment is asked (ft): nowhere if the vehicle's masses or surfaces move.
    """
    return {
        **told_card(
            _peaks(system, swaim_booster(), eqs, stations), ROUGH if stations else WITHOUT, "alpha_g", "ft/s"
        ),
        "wanted": asdict(criteria.wanted()),
        "engine": engine_gains(system),
        "modes": BENDING,
    }


def told_card(peaks: list[dict[str, Any]], limits: str, gust: str, unit: str) -> dict[str, Any]:
    """Return what is the same in the cards of all vehicles, with what goes into it.

    Parameters
    ----------
    peaks : list of dict
        The criteria in a gust: ``name``, ``terms``, ``factor`` and ``unit``.
    limits : str
        What this vehicle's card cannot tell.
    gust : str
        The input that is the gust.
    unit : str
        Of speeds.
    """
    wanted_gust = f"gust_{unit.replace('/', '_')}"
    return {
        "settling": {"horizon": criteria.HORIZON, "samples": criteria.SAMPLES, **_words("settling")},
        "gusts": {
            "input": gust,
            "peak": wanted_gust,
            "unit": unit,
            "durations": gusts.DURATIONS,
            "count": gusts.COUNT,
            "fine": gusts.FINE,
            "step": criteria.GUST_STEP,
        },
        "peaks": [{**each, **_words(each["name"])} for each in peaks],
        "stable": criteria.STABLE,
        "near": NEAR,
        "margins": MARGINS,
        "note": f"{NOTE} {limits}",
    }


def judged(
    system: ControlSystem,
    eqs: PerturbationEquations,
    closed_loop: Callable[..., control.StateSpace],
    values: Mapping[str, Any],
) -> tuple[criteria.Criterion, ...]:
    """Return all criteria of a loop at the sliders' values, with the moments, opened at the engine's command.

    Parameters
    ----------
    system : ControlSystem
    eqs : PerturbationEquations
        The vehicle that the view began with.
    closed_loop : callable
        Takes the sliders' values.
    values : mapping of str to float or str

    Returns
    -------
    tuple of Criterion
    """
    booster = with_data(swaim_booster(), **{name: values[name] for name in DATA})
    loads = section_loads(booster, vehicle_at(eqs, dict(values)), STATIONS, values.get("jet", JET_STATION))
    closed = closed_loop(**values)

    def at_scale(scale: float) -> control.StateSpace:
        return closed_loop(**{**values, **{name: scale * values[name] for name in engine_gains(system)}})

    modes = {name: unit * float(values[omega]) for name, (omega, unit) in BENDING.items()}
    return criteria.evaluate(with_moments(closed, loads), eqs.U, cut_loop(at_scale, 1.0), modes)
