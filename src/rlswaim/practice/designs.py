"""Designs side by side: the report's loops with corrected gains, and controllers that it recommends to try.

Each design is made for the consistent vehicle and can be closed around any other.  Those of the report have
its ideal filters, sensors and actuators; the rest have the hardware of
``data/ladder.csv`` and instruments that can be built.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache

import control

from rlswaim.edition.designs import found_gains
from rlswaim.edition.search import searches
from rlswaim.practice.criteria import Criterion, evaluate
from rlswaim.practice.dispersed import consistent_booster, with_gravity
from rlswaim.practice.h_infinity import h_infinity
from rlswaim.practice.hardware import closed_loop, plant
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.practice.ladder import Rung, dual_actuation_on
from rlswaim.practice.loads import SectionLoads, section_loads, with_moments
from rlswaim.practice.margins import margins
from rlswaim.practice.optimal import MIDDLE, Wishes, lqg
from rlswaim.practice.structures import NOSE, STRUCTURES
from rlswaim.practice.synthesis import slowest
from rlswaim.source.tables import number, read_table
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations

BASE = {"theta": 0.02, "thetadot": 0.04, "integral": 0.05, "q1dot": 1.0, "q2dot": 1.0}
"""Sizes that count as 1 (rad, rad/s, rad s, ft/s, ft/s)."""
WISHES = {
    "LQG, nose jet": Wishes(BASE),
    "LQG with recovery, nose jet": Wishes(BASE, recovery=1.0),
    "load relief": Wishes(BASE | {f"moment {MIDDLE:g}": 2e6}, recovery=1.0),
    "minimum drift": Wishes(BASE | {"drift": 3.0}, recovery=1.0),
}
THRUST = Wishes(BASE, recovery=10.0)
BOUNDED = Wishes(
    {name: size for name, size in BASE.items() if name != "integral"}, delta=0.005, jet=3e4, recovery=2.0
)


@dataclass(frozen=True, eq=False)
class Design:
    """A design that can be closed around any vehicle, or opened at one of its commands.

    Attributes
    ----------
    name, reads : str
        What it is called, and what it measures.
    closed : callable
        Takes the equations; returns the loop from theta_c and alpha_g.
    opened : callable
        Takes the equations and a command; returns L(s).
    commands : tuple of str
    jet : float or None
        Station of the jet (ft).
    order : int
        States of the controller; those of the effectors and instruments do not count.
    """

    name: str
    reads: str
    closed: Callable[[PerturbationEquations], control.StateSpace]
    opened: Callable[[PerturbationEquations, str], control.StateSpace]
    commands: tuple[str, ...]
    jet: float | None
    order: int


def _ideal(name: str, gains: Mapping[str, float]) -> Design:
    """Return a design of Section VII with its ideal filters and sensors; it is opened at the engine alone."""

    def loop(eqs: PerturbationEquations) -> tuple[control.StateSpace, control.StateSpace]:
        return dual_actuation_on(eqs, Rung(), **gains)

    return Design(
        name,
        f"rigid angle, elastic displacement at {gains['sensor']:.0f}",
        lambda eqs: loop(eqs)[0],
        lambda eqs, command: loop(eqs)[1],
        ("delta_c",),
        gains["jet"],
        2,
    )


def flown(
    name: str, made: control.StateSpace, instruments: tuple[Instrument, ...], jet: float | None
) -> Design:
    """Return a controller with its instruments as a design.

    Parameters
    ----------
    name : str
    made : control.StateSpace
        The controller, as `hardware.closed_loop` wants it.
    instruments : tuple of Instrument
    jet : float or None
        Station of the jet (ft).

    Returns
    -------
    Design
    """

    def whole(eqs: PerturbationEquations) -> control.StateSpace:
        return plant(eqs, instruments, jet=jet)

    stations = {
        one.station: "gyro" if one.kind == "attitude" else one.kind
        for one in instruments
        if one.kind != "rate"
    }
    return Design(
        name,
        ", ".join(f"{kind} {station:g}" for station, kind in stations.items()),
        lambda eqs: closed_loop(whole(eqs), made),
        lambda eqs, command: closed_loop(whole(eqs), made, command),
        tuple(made.output_labels),
        jet,
        made.nstates,
    )


def synthesized() -> dict[str, dict[str, float]]:
    """Return the gains of ``data/synthesis.csv`` by structure, with their cost and those of the starts."""
    found: dict[str, dict[str, float]] = {}
    for row in read_table("synthesis"):
        found.setdefault(row["structure"], {})[row["parameter"]] = number(row["value"])
    return found


@cache
def designs() -> dict[str, Design]:
    """Return all designs by name."""
    booster = consistent_booster()
    found = [
        _ideal("VII, case 1, ideal", found_gains("dual_actuation")),
        _ideal("VII, modest jet, ideal", searches()["modest_jet", "pair-all"].gains),
    ]
    two = gyros(60.0, 304.0)
    found.append(flown("LQG with recovery, thrust", lqg(booster, two, THRUST), two, None))
    for structure, gains in synthesized().items():
        kind = STRUCTURES[structure]
        found.append(flown(structure, kind.controller(gains), kind.instruments(gains), gains["jet"]))
    read = (*gyros(60.0), Instrument("accelerometer", NOSE))
    for name, wishes in WISHES.items():
        found.append(flown(name, lqg(booster, read, wishes, NOSE), read, NOSE))
    bounded = h_infinity(booster, read, BOUNDED, NOSE)[0]
    found.append(flown("H-infinity, nose jet", bounded, read, NOSE))
    return {design.name: design for design in found}


@lru_cache(maxsize=8)
def _loads_at_middle(booster: Booster, jet: float) -> SectionLoads:
    return section_loads(booster, with_gravity(booster), [MIDDLE], jet)


def moved(design: Design, booster: Booster) -> control.StateSpace:
    """Return a design's closed loop around a booster with the bending moment in the middle as an output.

    Parameters
    ----------
    design : Design
    booster : Booster
    """
    loads = _loads_at_middle(booster, JET_STATION if design.jet is None else design.jet)
    return with_moments(design.closed(with_gravity(booster)), loads)


def judged(design: Design, booster: Booster) -> tuple[Criterion, ...]:
    """Return all criteria of a design around a booster, with the margins at the engine.

    Parameters
    ----------
    design : Design
    booster : Booster

    Returns
    -------
    tuple of Criterion
    """
    eqs = with_gravity(booster)
    modes = {f"bending {i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    return evaluate(moved(design, booster), eqs.U, design.opened(eqs, "delta_c"), modes, allowed=slowest())


def disk_at(design: Design, booster: Booster, command: str) -> float:
    """Return the disk margin of a design at one command, the rest closed.

    Parameters
    ----------
    design : Design
    booster : Booster
    command : str
    """
    return margins(design.opened(with_gravity(booster), command)).disk
