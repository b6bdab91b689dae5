"""The rungs of the ladder: the report's equations, truer vehicles, and truer loops around them."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from rlswaim.practice.ladder import Rung
from rlswaim.source.tables import constants
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations, printed_equations
from rlswaim.vehicle.modes import BendingMode, purified
from rlswaim.vehicle.stations import LENGTH

BETA_3 = 10.9956078
"""Third root of cosh(x) cos(x) = 1: the third bending mode of a uniform free-free beam."""


class Step(NamedTuple):
    """One rung: the equations of the vehicle, and what its loop has."""

    eqs: PerturbationEquations
    rung: Rung


def third_mode(booster: Booster) -> BendingMode:
    """Return an assumed third bending mode of a booster that has two.

    Its shape is that of a uniform free-free beam, less its parts along the rigid motions and the
    first two modes (the masses as weights), 1 at the thrust point; frequency and damping ratio are
    those of ``data/ladder.csv``.

    Parameters
    ----------
    booster : Booster

    Returns
    -------
    BendingMode
    """
    c, second = constants("ladder"), booster.modes[1]
    share = (np.cosh(BETA_3) - np.cos(BETA_3)) / (np.sinh(BETA_3) - np.sin(BETA_3))
    x, at = (BETA_3 * stations / LENGTH for stations in (second.stations, second.slope_stations))
    uniform = replace(
        second,
        deflections=np.cosh(x) + np.cos(x) - share * (np.sinh(x) + np.sin(x)),
        slopes=-BETA_3 / LENGTH * (np.sinh(at) - np.sin(at) - share * (np.cosh(at) + np.cos(at))),
        omega=c["mode_3_ratio"] * second.omega,
        zeta=c["mode_3_zeta"],
        name="bending mode 3, assumed",
    )
    mode = purified(uniform, booster.stations, booster.masses, booster.modes)
    one = mode.deflection(booster.thrust_station)
    mode = replace(mode, deflections=mode.deflections / one, slopes=mode.slopes / one)
    phi = np.asarray(mode.deflection(booster.stations))
    return replace(mode, mass=float(booster.masses @ phi**2))


def with_third_mode(booster: Booster) -> Booster:
    """Return a ``booster`` with `third_mode` beside its own two."""
    return replace(booster, modes=(*booster.modes, third_mode(booster)), name=f"{booster.name}, three modes")


def hardware() -> dict[str, Rung]:
    """Return truer parts of the loop by name, with the numbers of ``data/ladder.csv``."""
    c = constants("ladder")
    return {
        "second-order actuator": Rung(actuator=c["actuator_omega"]),
        "gyro dynamics": Rung(gyro=c["gyro_omega"]),
        "20 ms delay": Rung(delay=c["delay"]),
        "notches": Rung(notch=c["notch_zeta_poles"]),
        "realizable filters": Rung(low_pass=c["low_pass"], high_pass=c["high_pass"]),
    }


def curved(booster: Booster, drag: float) -> Rung:
    """Return the rung with the path's curvature and the x-equation.

    Parameters
    ----------
    booster : Booster
        Its flight has gamma_0.
    drag : float
        Derivative of the drag by the speed over the mass (1/s).
    """
    gamma_0 = booster.flight.gamma_0
    if gamma_0 is None:
        raise ValueError("gamma_0 in curved: got None, wanted the angle of the path (rad)")
    return Rung(level=float(constants("vehicle")["g"] * np.cos(gamma_0)), drag=drag)


def ladder_steps() -> dict[str, Step]:
    """Return the ladder by name, each part alone and then all of the loop's with gravity.

    Returns
    -------
    dict of str to Step
    """
    booster, printed, heavy = swaim_booster(), printed_equations(), printed_equations(gravity=True)
    c = constants("ladder")
    vehicles = {
        "as printed": Step(printed, Rung()),
        "gravity": Step(heavy, Rung()),
        "path and speed, no drag": Step(heavy, curved(booster, 0.0)),
        "path and speed, drag": Step(heavy, curved(booster, c["drag"])),
        "orthogonal modes": Step(perturbation_equations(booster.orthogonalized()), Rung()),
        "third mode": Step(perturbation_equations(with_third_mode(booster)), Rung()),
    }
    parts = hardware()
    every = {name: value for part in parts.values() for name, value in vars(part).items() if value}
    loops = {name: Step(printed, part) for name, part in parts.items()}
    loops["complementary filter"] = Step(printed, Rung(blend=c["blend"]))
    return vehicles | loops | {"all of the loop, gravity": Step(heavy, Rung(**every))}
