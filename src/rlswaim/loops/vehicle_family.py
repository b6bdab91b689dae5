"""A control system around any vehicle: its closed loop's matrices in the gains and Eq. 29's coefficients."""

from dataclasses import replace
from functools import lru_cache
from typing import Any

import control

from rlswaim.loops.control_systems import ControlSystem
from rlswaim.loops.family import Family
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations

GRAVITY = "Z_theta"
ROUNDING = 1e-12
"""Eq. 29 has Z_thetadot - U over U, so that the factors' coefficients are exact but for rounding."""


def jet_factors(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the jet's responses of Eq. 125 as factors, jet_Z, jet_M and so on."""
    return {f"jet_{row}": value for row, value in eqs.jet.items()}


@lru_cache(maxsize=16)
def vehicle_family(system: ControlSystem, U: float) -> Family:
    """Return the closed loops of a control system around vehicles with the speed ``U`` (ft/s).

    Parameters
    ----------
    system : ControlSystem
    U : float

    Returns
    -------
    Family
        Factors: those of the system, Eq. 29's coefficients, ``Z_theta`` (gravity) and `jet_factors`.
    """
    eqs = replace(printed_equations(), U=U)  # its coefficients do not count
    names = [*eqs.coefficients, GRAVITY]
    jets = jet_factors(eqs) if "jet" in system.stations else {}

    def closed_loop(**factors: float) -> control.StateSpace:
        coefficients = {name: factors.pop(name) for name in eqs.coefficients}
        own: dict[str, Any] = {"coefficients": coefficients, "gravity": factors.pop(GRAVITY)}
        if jets:
            own["jet"] = {row: factors.pop(f"jet_{row}") for row in eqs.jet}
        return system.at_factors(replace(eqs, **own), **factors)

    swung = [f"{row}_delta" for row in eqs.rows]
    alone = [(name,) for name in names if name not in swung]
    return Family.of(closed_loop, (*_groups(system, swung, [*jets]), *alone), ROUNDING)


def _groups(system: ControlSystem, swung: list[str], jets: list[str]) -> list[tuple[str, ...]]:
    """Return the system's groups: the actuators' outputs are multiplied by what they do to the vehicle.

    The thrust enters each equation by one coefficient, the jet by a response and a lever.
    """
    found = [group for group in system.groups if "K_r" not in group]
    found += [(*group, name) for group in found if "K_C" in group for name in swung]
    levers = ((), ("arm",), *((f"phi_{i}r",) for i in range(1, len(jets) - 1)))
    return found + [("K_r", *lever, jet) for lever, jet in zip(levers, jets, strict=False)]
