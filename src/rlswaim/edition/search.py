"""Bounded global searches over all gains and stations of a control system [Sections IV to VII].

The bounds stand in ``data/search_bounds.csv`` (two equal ones fix a parameter), the winners of the
long searches in ``data/searches.csv``, which `rlswaim.edition.long_searches` prints.  A search
that finds something proves that it exists; one that finds nothing has not found it within these bounds.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import differential_evolution

from rlswaim.edition.slow_roots import abscissas, slow_roots
from rlswaim.edition.spreads import place as _place
from rlswaim.edition.spreads import spread as _spread
from rlswaim.loops.closed_loops import LOOPS, polynomial, state_space
from rlswaim.loops.control_systems import ControlledVehicle
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source import checks
from rlswaim.source.tables import read_table
from rlswaim.vehicle.equations import PerturbationEquations

OBJECTIVES = {
    "all": "all roots",
    "apart": "all but a slow real root",
    "pair-all": "all roots, a pair held at 2 rad/s and .5",
    "pair-apart": "all but a slow one, the pair held",
}
"""The roots whose largest real part a search minimizes; ``pair``: K_A and K_R put a pair at `WANTED`."""
OUT_OF_BOUNDS = 1e6
"""Cost (1/s) of gains beyond the bounds, so that the search leaves them."""
ROUNDS, PEOPLE = 1000, 15
"""Of an evolution: generations; loops in each for each unknown."""


class Found(NamedTuple):
    """The best closed loop of a search: abscissa (1/s) by its objective, and how it was found.

    ``evolution`` and ``adaptation`` are the least that each of two independent ways found by itself,
    ``descents`` and ``worst`` what the best and the least good of the runs by descents found; nan for a
    way that was not gone.
    """

    system: str
    objective: str
    gains: dict[str, float]
    abscissa: float
    seed: int
    evaluations: int
    evolution: float = float("nan")
    adaptation: float = float("nan")
    descents: float = float("nan")
    worst: float = float("nan")


def bounds(system: str) -> dict[str, dict[str, str]]:
    """Return the rows of ``search_bounds`` of a ``system``, by parameter."""
    checks.one_of("system", system, tuple(LOOPS), "search")
    return {row["parameter"]: row for row in read_table("search_bounds") if row["system"] == system}


def _objective(loops: ControlledVehicle, gains: Mapping[str, NDArray], objective: str) -> NDArray:
    """Return the abscissas (1/s) that a search minimizes, at many gains.

    Parameters
    ----------
    loops : ControlledVehicle
    gains : mapping of str to ndarray, shape (S,)
        Gains and stations.
    objective : str
        One of `OBJECTIVES`.

    Returns
    -------
    ndarray, shape (S,)
    """
    return abscissas(np.linalg.eigvals(loops.matrices(**gains)), objective.endswith("apart"))


class Problem:
    """One system with one objective: costs over the unit cube of what is sought.

    Parameters
    ----------
    eqs : PerturbationEquations
    system, objective : str
        One of `LOOPS` and one of `OBJECTIVES`.
    """

    def __init__(self, eqs: PerturbationEquations, system: str, objective: str) -> None:
        checks.one_of("objective", objective, tuple(OBJECTIVES), "search")
        self.eqs, self.system, self.objective, self.rows = eqs, system, objective, bounds(system)
        self.loops, self.pair = LOOPS[system].around(eqs), objective.startswith("pair")
        self.fixed = [name for name, row in self.rows.items() if row["low"] == row["high"]]
        kept = {*self.fixed, *(("K_A", "K_R") if self.pair else ())}
        self.sought = [name for name in self.rows if name not in kept]

    def gains(self, u: NDArray) -> dict[str, NDArray]:
        """Return gains and stations at places ``u``, shape (n, S), of the cube."""
        chosen = {name: _spread(self.rows[name], x) for name, x in zip(self.sought, u, strict=True)}
        chosen |= {name: _spread(self.rows[name], np.zeros(u.shape[1])) for name in self.fixed}
        return self.loops.with_pair(chosen) if self.pair else chosen

    def cost(self, u: NDArray) -> NDArray:
        """Return the abscissas (1/s) at places ``u``, shape (n, S); `OUT_OF_BOUNDS` where K_A or K_R is."""
        g = self.gains(u)
        outside = np.any([~(np.abs(g[n]) <= float(self.rows[n]["high"])) for n in ("K_A", "K_R")], axis=0)
        inside = {name: np.where(outside, 1.0, x) for name, x in g.items()}
        return np.where(outside, OUT_OF_BOUNDS, _objective(self.loops, inside, self.objective))

    def place(self, gains: Mapping[str, float]) -> NDArray:
        """Return the place in the cube of given ``gains`` and stations."""
        return np.array([_place(self.rows[name], gains[name]) for name in self.sought])

    def rounded(self, u: NDArray, digits: int = 9) -> dict[str, float]:
        """Return gains and stations at one place.

        Parameters
        ----------
        u : ndarray, shape (n,)
        digits : int
            Significant ones that are kept.
        """
        return {name: float(f"{x[0]:.{digits}g}") for name, x in self.gains(u[:, None]).items()}


def search(
    eqs: PerturbationEquations,
    system: str,
    objective: str,
    seed: int = 1964,
    rounds: int = ROUNDS,
    people: int = PEOPLE,
) -> Found:
    """Return the closed loop with the least abscissa that one differential evolution finds within the bounds.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        One of `LOOPS`.
    objective : str
        One of `OBJECTIVES`.
    seed : int
        Seed of the evolution's random numbers.
    rounds : int
        Number of generations.
    people : int
        Number of loops in each generation for each unknown.

    Returns
    -------
    Found
        Its gains are rounded to nine digits.

    Raises
    ------
    ValueError
        If the system or the objective is unknown.
    """
    problem = Problem(eqs, system, objective)
    winner, count = evolved(problem, rounds, people, seed)
    value = _objective(problem.loops, {name: np.array([x]) for name, x in winner.items()}, objective)
    return Found(system, objective, winner, float(value[0]), seed, count)


def evolution(problem: Problem, rounds: int, people: int, seed: int, start: NDArray | None = None) -> NDArray:
    """Return the people of a differential evolution at its end, the best one first; shape (n, S).

    Parameters
    ----------
    problem : Problem
    rounds, people : int
        Generations, and loops in each for each unknown.
    seed : int
    start : ndarray, optional
        A place to begin with, each unknown from 0 to 1.
    """
    best = differential_evolution(
        problem.cost,
        [(0.0, 1.0)] * len(problem.sought),
        seed=seed,
        popsize=people,
        maxiter=rounds,
        tol=0,
        polish=False,
        vectorized=True,
        updating="deferred",
        x0=start,
    )
    return np.column_stack([best.x, best.population.T])


def evolved(
    problem: Problem, rounds: int, people: int, seed: int, start: NDArray | None = None
) -> tuple[dict[str, float], int]:
    """Return the best gains of an `evolution`, rounded to nine digits, and how many loops it tried.

    Parameters
    ----------
    problem, rounds, people, seed, start
        As those of `evolution`.
    """
    best = evolution(problem, rounds, people, seed, start)[:, 0]
    return problem.rounded(best), (rounds + 1) * people * len(problem.sought)


def winners() -> tuple[Found, ...]:
    """Return the winners of the long searches [data/searches.csv]."""
    table: dict[tuple[str, str], dict[str, float]] = {}
    for row in read_table("searches"):
        table.setdefault((row["system"], row["objective"]), {})[row["parameter"]] = float(row["value"])
    return tuple(
        Found(
            *key,
            {n: v for n, v in g.items() if n in bounds(key[0])},
            g["abscissa"],
            int(g["seed"]),
            int(g["evaluations"]),
            g.get("evolution", np.nan),
            *(g.get(way, np.nan) for way in ("adaptation", "descents", "worst")),
        )
        for key, g in table.items()
    )


def searches() -> dict[tuple[str, str], Found]:
    """Return the winners of the long searches, the best closed loops that were found within the bounds.

    Returns
    -------
    dict of (str, str) to Found
        By system and objective: ``abscissa`` (1/s), and ``gains`` named as the arguments of the system's
        function.
    """
    return {(found.system, found.objective): found for found in winners()}


def beside_bounds(eqs: PerturbationEquations, system: str) -> dict[str, dict[str, str]]:
    """Return the winners of one system as columns of texts, the bounds in the first.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        One of `LOOPS`.

    Returns
    -------
    dict of str to dict of str to str
        Column, row, text.  The rows are the gains and stations; the objective's abscissa (1/s), stored
        and from determinants in floats; what each of two ways found by itself; the slow root (1/s)
        and its time constant (s).
    """
    rows = bounds(system)
    columns = {"between": {_named(n, r): _between(r) for n, r in rows.items()}}
    for found in (w for w in winners() if w.system == system):
        gains = {_named(n, r): f"{found.gains[n]:.5g}" for n, r in rows.items()}
        columns[OBJECTIVES[found.objective]] = gains | _judged(eqs, found)
    return columns


def _named(name: str, row: Mapping[str, str]) -> str:
    """Return a row's name and unit, a gain's name as formula."""
    letter, _, index = name.partition("_")
    words = f"${letter}_{{{index}}}$" if letter in ("K", "kK") else name.replace("_", " ")
    unit = "" if row["unit"] == "1" else f" ({row['unit']})"
    return ("$b$" if name == "b" else words) + unit


def _between(row: Mapping[str, str]) -> str:
    return f"{row['low']} to {row['high']}" if row["low"] != row["high"] else f"fixed: {row['low']}"


def _by_descents(found: Found) -> dict[str, str]:
    """Return what the runs by descents found, where there are some."""
    told = {"best run of descents found (1/s)": found.descents, "least good run found (1/s)": found.worst}
    return {name: f"{value:.4f}" for name, value in told.items() if not np.isnan(value)}


def _judged(eqs: PerturbationEquations, found: Found) -> dict[str, str]:
    poles = state_space(eqs, found.system, found.gains).poles()
    others = roots(polynomial(eqs, found.system, found.gains))
    second = abscissas(others[None], found.objective.endswith("apart"))[0]
    slow = slow_roots(poles[None])[0]
    return {
        "largest real part (1/s)": f"{found.abscissa:.4f}",
        "from determinants (1/s)": f"{round(second, 3) + 0:.3f}",  # no more is sure where roots nearly meet
        "evolution alone found (1/s)": f"{found.evolution:.4f}",
        "adaptation alone found (1/s)": f"{found.adaptation:.4f}",
        **_by_descents(found),
        "slow real root (1/s)": "none" if np.isnan(slow) else f"{slow:+.2g}",
        "its time constant (s)": f"{1 / abs(slow):.0f}" if abs(slow) > 0 else "",
    }
