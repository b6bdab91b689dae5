"""Gains sought again on each rung of the ladder, stations kept; run as a module it prints the winners.

``python -m rlswaim.practice.ladder_search > src/rlswaim/source/data/ladder_found.csv`` takes some minutes.
"""

import sys
from collections.abc import Callable
from functools import cache, partial
from typing import NamedTuple

import control
from numpy.typing import ArrayLike, NDArray
from tqdm import tqdm

from rlswaim.edition.search import Problem, bounds, evolved, winners
from rlswaim.edition.slow_roots import abscissas
from rlswaim.loops.family import Family
from rlswaim.practice.ladder import dual_actuation_on, inner_loops_on, rate_attitude_on
from rlswaim.practice.rungs import Step, ladder_steps
from rlswaim.source.tables import read_table

ROUNDS, PEOPLE, SEED = 300, 12, 1964
ROUNDING = 1e-9
"""Largest deviation from a multi-affine form that is rounding in a family of closed loops."""


class SearchedLoop(NamedTuple):
    """A control system with its stations: the rows of its bounds, its factors, and its closed loop."""

    system: str
    groups: tuple[tuple[str, ...], ...]
    closed_loop: Callable[..., control.StateSpace]


@cache
def modest_gains() -> dict[str, float]:
    """Return gains and stations of Section VII's modest loop, which holds a pair at 2 rad/s and .5."""
    return next(w.gains for w in winners() if (w.system, w.objective) == ("modest_jet", "pair-all"))


def _attitude(step: Step, **gains: float) -> control.StateSpace:
    return rate_attitude_on(step.eqs, step.rung, gyro=60.0, **gains).closed


def _one_sensor(step: Step, K_z: float, **gains: float) -> control.StateSpace:
    return inner_loops_on(step.eqs, step.rung, sensors={140.0: K_z}, **gains).closed


def _two_sensors(step: Step, K_za: float, K_zb: float, **gains: float) -> control.StateSpace:
    return inner_loops_on(step.eqs, step.rung, sensors={300.0: K_za, 140.0: K_zb}, **gains).closed


def _jet(step: Step, **gains: float) -> control.StateSpace:
    at = {name: modest_gains()[name] for name in ("sensor", "jet")}
    return dual_actuation_on(step.eqs, step.rung, **gains, **at).closed


SEARCHED = {
    "IV": SearchedLoop("rate_attitude", (("K_A", "K_C"), ("K_R",)), _attitude),
    "V": SearchedLoop("single_sensor", (("K_C",), ("K_A", "K_R"), ("K_z",)), _one_sensor),
    "VI": SearchedLoop("two_sensor", (("K_C",), ("K_A", "K_R"), ("K_za",), ("K_zb",)), _two_sensors),
    "VII": SearchedLoop("modest_jet", (("K_A", "K_C"), ("K_R",), ("kK_z", "b"), ("K_r",)), _jet),
}
"""Section IV with its gyro at 60 ft, V and VI with sensors at 140 and at 300 ft, VII as the modest loop."""


class OnARung(Problem):
    """The search of `rlswaim.edition.search` for a loop on a rung; a slow real root is set apart.

    Parameters
    ----------
    step : Step
    searched : SearchedLoop
    """

    def __init__(self, step: Step, searched: SearchedLoop) -> None:
        names = [name for group in searched.groups for name in group]
        self.rows = {name: bounds(searched.system)[name] for name in names}
        self.family = Family.of(partial(searched.closed_loop, step), searched.groups, ROUNDING)
        self.objective, self.pair, self.fixed, self.sought = "apart", False, [], names
        self.loops = self  # type: ignore[assignment]

    def matrices(self, **given: ArrayLike) -> NDArray:
        """Return the state matrices at ``given`` gains."""
        return self.family.matrices(given)


class Best(NamedTuple):
    """The best gains found on one rung: largest real part of all roots but a slow real one (1/s)."""

    rung: str
    section: str
    gains: dict[str, float]
    abscissa: float
    evaluations: int


def sought(rung: str, section: str, rounds: int = ROUNDS, people: int = PEOPLE) -> Best:
    """Return the best gains that a differential evolution finds on a rung.

    Parameters
    ----------
    rung : str
        One of `rlswaim.practice.rungs.ladder_steps`.
    section : str
        One of `SEARCHED`.
    rounds, people : int
        Generations, and loops in each for each gain.

    Returns
    -------
    Best
    """
    step, searched = ladder_steps()[rung], SEARCHED[section]
    problem = OnARung(step, searched)
    start = problem.place(modest_gains()) if section == "VII" else None
    gains, count = evolved(problem, rounds, people, SEED, start)
    poles = searched.closed_loop(step, **gains).poles()
    value = float(abscissas(poles[None], apart=True)[0])
    return Best(rung, section, gains, value, count)


def stored() -> dict[tuple[str, str], Best]:
    """Return the stored winners by rung and section [data/ladder_found.csv]."""
    table: dict[tuple[str, str], dict[str, float]] = {}
    for row in read_table("ladder_found"):
        table.setdefault((row["rung"], row["section"]), {})[row["parameter"]] = float(row["value"])
    return {key: Best(*key, g, g.pop("abscissa"), int(g.pop("evaluations"))) for key, g in table.items()}


def main() -> None:
    """Print the winners of all rungs and loops as the table ``ladder_found``."""
    print("rung,section,parameter,value")
    pairs = [(rung, section) for rung in ladder_steps() for section in SEARCHED]
    for pair in tqdm(pairs, file=sys.stderr):
        best = sought(*pair)
        values = {**best.gains, "abscissa": f"{best.abscissa:.9g}", "evaluations": best.evaluations}
        for name, value in values.items():
            print(f'"{best.rung}",{best.section},{name},{value}')


if __name__ == "__main__":
    main()
