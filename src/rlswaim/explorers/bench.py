"""The bench of chapters I to III: the control systems of Sections IV to VII around the chapter's own vehicle.

It stands folded under the chapter's view; the browser makes a workbench of it when a reader opens it.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from rlswaim.explorers.burn_tables import burn_plant
from rlswaim.explorers.control_systems import loop_payload, vehicle_scales
from rlswaim.explorers.criteria_card import STATIONS, sent_criteria
from rlswaim.explorers.parameter import Parameter
from rlswaim.explorers.system_views import VIEWS, View
from rlswaim.explorers.vehicle_parameters import own_values
from rlswaim.explorers.vehicle_sliders import coefficient_sums, data_parameters, data_values, matrices, nodes
from rlswaim.loops.vehicle_family import GRAVITY, jet_factors
from rlswaim.practice.burn import equations_at
from rlswaim.vehicle import eq_29
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations

START = "single-sensor"
MIDDLE = 58
"""The second of the burn (s) that chapter II's bench starts at: one that the flights are sent for."""


def _system(view: View, eqs: PerturbationEquations, stations: tuple[float, ...]) -> dict[str, Any]:
    """Return what one control system adds: no polynomial, which the browser finds from the matrices."""
    sent = loop_payload(view, eqs)
    # Printed roots belong to the printed numbers, which are not quite those of the data.
    presets = [{**preset, "printed": []} for preset in sent["presets"]]
    return {
        **sent,
        "presets": presets,
        "parameters": [p.name for p in view.parameters(eqs)],
        "shapes": {
            factor: {"at": station, "kind": kind, "mode": mode}
            for station, entering in view.system.stations.items()
            for factor, (kind, mode) in entering.items()
        },
        "matrices": matrices(view.system, swaim_booster().flight.U),
        "criteria": sent_criteria(view.system, eqs, stations),
    }


def _bench(
    eqs: PerturbationEquations,
    vehicle: Mapping[str, Any],
    own: Sequence[Parameter] = (),
    stations: tuple[float, ...] = (),
) -> dict[str, Any]:
    """Return the bench around the vehicle of ``eqs``, which ``vehicle`` changes.

    Parameters
    ----------
    eqs : PerturbationEquations
    vehicle : mapping
        Coefficients as sums of products, parameters, and where they start.
    own : sequence of Parameter
        The vehicle's sliders that the bench itself has; the others are those of the view above it.
    stations : tuple of float
        Where its criteria ask for the bending moment (ft).
    """
    known = {p.name: p.told for view in VIEWS.values() for p in view.parameters(eqs)}
    folded = [p.name for p in own if p.folded]
    return {
        "start": START,
        "systems": {view.name: _system(view, eqs, stations) for view in VIEWS.values()},
        "parameters": known | {p.name: p.told for p in own},
        "own": [p.name for p in own],
        "vehicle": vehicle_scales(eqs),
        "plant": {"folded": folded, "curves": [nodes(m) for m in eqs.modes], **vehicle},
    }


def own_bench(booster: Booster) -> dict[str, Any]:
    """Return the bench of chapter I: the vehicle from its data, under the sliders of chapters IV to VII.

    Parameters
    ----------
    booster : Booster
    """
    eqs = perturbation_equations(booster)
    parameters = data_parameters()
    vehicle = {
        "coefficients": coefficient_sums(eqs, booster),
        "parameters": [p.name for p in parameters],
        "own": data_values(eqs),
        "weights": {"left out": 0.0, "kept": booster.flight.weight_across},
    }
    return _bench(eqs, vehicle, parameters, STATIONS)


def coupled_bench(booster: Booster) -> dict[str, Any]:
    """Return the bench of chapter III: its view's sliders change the vehicle under the loop.

    Parameters
    ----------
    booster : Booster
    """
    eqs = perturbation_equations(booster)
    fixed = {**jet_factors(eqs), GRAVITY: 0.0} | {
        f"{row}_delta": eqs.coefficients[f"{row}_delta"] for row in eqs.rows
    }
    sums = {
        name: [list(product) for product in products] for name, products in eq_29.products(booster).items()
    }
    own = own_values(booster)
    vehicle = {
        "coefficients": sums | {name: [[value, []]] for name, value in fixed.items()},
        "parameters": [*own],
        "own": own,
        "l_CG": booster.l_CG,
        "places": {s.name: f"l_{s.name}" for s in booster.surfaces},
    }
    return _bench(eqs, vehicle)


def burn_bench(tables: Mapping[str, Any], program: Mapping[str, int], time: Parameter) -> dict[str, Any]:
    """Return the bench of chapter II: a slider of the time moves the vehicle through the burn.

    Parameters
    ----------
    tables : mapping
        ``nodes``, ``times`` and ``curves`` of the view's flights, as the browser gets them.
    program : mapping of str to int
        The book's pitch program, upright and level (s).
    time : Parameter
        The slider of the time (s).
    """
    at = [tables["nodes"][name].index(value) for name, value in program.items()]
    here = tables["times"].index(MIDDLE)
    U, q_D = (tables["curves"][name][at[0]][at[1]][here] for name in ("U", "q_D"))
    eqs = equations_at(MIDDLE, U=U, q_D=q_D)
    found = _bench(eqs, {**burn_plant(), "own": {"t": MIDDLE, **program}}, (time,))
    for system in found["systems"].values():
        system["maps"] = ["t", *system["maps"]]
        system["running"] = {
            **system["running"],
            "t": {"ends": [time.grid[0], time.grid[-1]], "step": 5, "unit": "s", "every": 10},
        }
        system["python"] = {
            **system["python"],
            "equations": "equations_at",
            "module": "rlswaim.practice.burn",
        }
    return found
