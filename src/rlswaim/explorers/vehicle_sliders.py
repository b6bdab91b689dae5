"""The vehicle under the loop: its sliders beside a control system's, and what the browser closes loops from.

Python sends the closed loop's matrices as sums of products of gains and of Eq. 29's coefficients, and each
coefficient as a sum of products of the vehicle's data.  The browser multiplies out.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from math import prod
from typing import Any

import numpy as np

from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.vehicle_parameters import own_values
from rlswaim.explorers.vehicle_parameters import parameters as vehicle_parameters
from rlswaim.loops.control_systems import ControlSystem
from rlswaim.loops.vehicle_family import GRAVITY, jet_factors, vehicle_family
from rlswaim.practice.dispersed import drawn
from rlswaim.source import checks
from rlswaim.vehicle import eq_29
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import OUTPUTS, PerturbationEquations
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.other_data import with_other_data

DATA = ("q_D", "C_payload", "C_fins", "omega_1", "omega_2")
WEIGHT = ("left out", "kept")
"""Eq. 1's weight across the path, as Eq. 29 has it and as Eq. 1 has it."""
DRAWS = 100
DISPERSED = {
    "q_D": "q_D",
    "C_payload": "lift_1",
    "C_fins": "lift_2",
    "omega_1": "omega_1",
    "omega_2": "omega_2",
}
"""Data that the cloud disperses, and their names in ``data/dispersions.csv``."""


def _weight(name: str, value: object, where: str) -> str:
    return checks.one_of(name, value, WEIGHT, where)


def data_parameters() -> tuple[Parameter, ...]:
    """Return the folded sliders: q_D, slopes of the normal forces, frequencies, and the weight's choice."""
    known = {p.name: p for p in vehicle_parameters(swaim_booster())}
    gravity = Parameter("gravity", "Weight", "", "weight across the path", WEIGHT, _weight, folded=True)
    return (*(replace(known[name], folded=True) for name in DATA), gravity)


def data_values(eqs: PerturbationEquations) -> dict[str, Value]:
    """Return where the sliders start: the report's vehicle, with the weight as ``eqs`` have it."""
    own = own_values(swaim_booster())
    return {**{name: own[name] for name in DATA}, "gravity": WEIGHT[eqs.gravity != 0]}


def vehicle_at(eqs: PerturbationEquations, values: dict[str, Any]) -> PerturbationEquations:
    """Return the equations at the vehicle's sliders, which are taken out of ``values``.

    Parameters
    ----------
    eqs : PerturbationEquations
    values : dict
        By parameter; what is not the vehicle's stays in it.
    """
    start = data_values(eqs)
    given = {name: values.pop(name, start[name]) for name in start}
    if given == start:
        return eqs
    data = {name: float(given[name]) for name in DATA if given[name] != start[name]}
    return with_other_data(eqs, gravity=given["gravity"] == "kept", **data)


def coefficient_sums(eqs: PerturbationEquations, booster: Booster) -> dict[str, list[list[Any]]]:
    """Return each coefficient of ``eqs`` as a sum of products of `DATA`, as `with_other_data` changes it.

    Parameters
    ----------
    eqs : PerturbationEquations
    booster : Booster
        Its surfaces stay where they are.
    """
    own, shapes = own_values(booster), _shapes_at_surfaces(booster)
    found: dict[str, list[list[Any]]] = _fixed(eqs.coefficients)
    for name, products in eq_29.products(booster).items():
        for weight, factors in products:
            held = weight * prod(shapes[f] for f in factors if f in shapes)
            free = [f for f in factors if f not in shapes]
            if free:
                found[name][0][0] -= held * prod(float(own[f]) for f in free)
                found[name].append([held, free])
    return {**found, GRAVITY: [[1.0, ["gravity"]]], **_fixed(jet_factors(eqs))}


def _fixed(values: Mapping[str, float]) -> dict[str, list[list[Any]]]:
    return {name: [[value, []]] for name, value in values.items()}


def _shapes_at_surfaces(booster: Booster) -> dict[str, float]:
    names = ["arm", *(f"{kind}_{i + 1}" for i in range(len(booster.modes)) for kind in ("phi", "sigma"))]
    at = partial(eq_29.shape_at, modes=booster.modes, l_CG=booster.l_CG)
    return {f"{n}_{s.name}": float(at(n, stations=s.station)) for n in names for s in booster.surfaces}


def matrices(system: ControlSystem, U: float) -> dict[str, Any]:
    """Return the closed loop's matrices [A B; C D] for the script: row, column, weight, factors.

    Parameters
    ----------
    system : ControlSystem
    U : float
        Speed (ft/s).
    """
    family = vehicle_family(system, U)
    n, outputs = len(family.states), [*family.outputs]
    shown = {n + outputs.index(name): n + i for i, name in enumerate(system.outputs)}
    entries = [
        [shown.get(row, row), column, term[row, column] / 2**family.exponent, list(product)]
        for product, term in family.terms.items()
        for row, column in np.argwhere(term).tolist()
        if row < n or row in shown
    ]
    return {
        "states": [state.removeprefix("x_") for state in family.states],
        "inputs": family.inputs,
        "outputs": system.outputs,
        "initial": OUTPUTS,
        "entries": entries,
    }


def plant(system: ControlSystem, eqs: PerturbationEquations) -> dict[str, Any]:
    """Return what the browser closes loops around changed vehicles from.

    Parameters
    ----------
    system : ControlSystem
    eqs : PerturbationEquations
        The report's vehicle, printed or from its data.
    """
    booster = swaim_booster()
    return {
        **matrices(system, eqs.U),
        "coefficients": coefficient_sums(eqs, booster),
        "parameters": [*DATA, "gravity"],
        "folded": [*DATA, "gravity"],
        "own": data_values(eqs),
        "weights": dict(zip(WEIGHT, (0.0, booster.flight.weight_across), strict=True)),
    }


def nodes(mode: BendingMode) -> dict[str, list[float]]:
    """Return the ends of the cubic pieces of a mode's deflection: stations, values and slopes there."""
    x = mode.shape.x
    return {"x": x.tolist(), "y": mode.shape(x).tolist(), "slope": mode.shape(x, 1).tolist()}


def dispersed_data() -> dict[str, list[float]]:
    """Return the factors of the cloud of dispersed vehicles, drawn with a seed, by parameter."""
    draws = [drawn(i) for i in range(DRAWS)]
    return {name: [round(draw[factor], 5) for draw in draws] for name, factor in DISPERSED.items()}
