"""The vehicle's data as parameters of live views: frequencies, dynamic pressure, surfaces."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from rlswaim.explorers.parameter import FEET, Parameter, Value, whole_station
from rlswaim.source import checks
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.other_data import own_data


def own_values(booster: Booster) -> dict[str, Value]:
    """Return the vehicle's own values of the sliders."""
    own = own_data(booster)
    return {name: int(value) if name.startswith("l_") else value for name, value in own.items()}


def parameters(booster: Booster) -> tuple[Parameter, ...]:
    """Return the sliders, and the choice of what runs along the paths."""
    own = own_values(booster)

    def grid(name: str, places: ArrayLike) -> tuple[float, ...]:
        return tuple(np.union1d([float(f"{place:.3g}") for place in np.ravel(places)], [own[name]]).tolist())

    found = [
        Parameter(
            f"omega_{i}",
            rf"\(\omega_{i}\)",
            "rad/s",
            f"omega_{i}, frequency of mode {i} in still air (rad/s)",
            grid(f"omega_{i}", np.geomspace(0.3, 30, 121)),
            checks.positive,
        )
        for i in (1, 2)
    ]
    found.append(
        Parameter(
            "q_D",
            r"\(q_D\)",
            "lb/ft²",
            "q_D, dynamic pressure (lb/ft²)",
            grid("q_D", np.arange(0, 2001, 20)),
            checks.not_negative,
        )
    )
    for s in booster.surfaces:
        C, meaning = f"C_{s.name}", f"slope of the normal force of the {s.name} (1/rad)"
        places = grid(C, np.linspace(0, 3 * s.C_Nalpha, 121))
        found.append(Parameter(C, rf"\(C_{{N\alpha {s.name[0]}}}\)", "", meaning, places))
    for s in booster.surfaces:
        where = f"station of the {s.name} (ft)"
        found.append(Parameter(f"l_{s.name}", rf"\(l_{s.name[0]}\)", "ft", where, FEET, whole_station))
    known = ("coupling", *own)
    check = partial(_one_of, known=known)
    return (*found, Parameter("running", "Paths for", "", "what runs along the paths", known, check))


def _one_of(name: str, value: object, where: str, known: Sequence[str]) -> str:
    return checks.one_of(name, value, known, where)
