"""Bounded global searches over all gains and stations of a control system [Sections IV to VII].

The bounds stand in ``data/search_bounds.csv`` (two equal ones fix a parameter), the winners of the
long searches in ``data/searches.csv``, which ``python -m rlswaim.edition.search`` prints.  A search
that finds something proves that it exists; one that finds nothing has not found it within these bounds.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import differential_evolution

from rlswaim.loops.closed_loops import LOOPS, polynomial, state_space
from rlswaim.loops.control_systems import ControlledVehicle
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source import checks
from rlswaim.source.tables import constants, read_table
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations

OBJECTIVES = {
    "all": "all roots",
    "apart": "all but a slow real root",
    "pair-all": "all roots, a pair held at 2 rad/s and .5",
    "pair-apart": "all but a slow one, the pair held",
}
"""Whose abscissa shall be least; ``pair``: with the K_A and K_R that put a pair at `WANTED`."""
OUT_OF_BOUNDS = 1e6
SEEDS, ROUNDS, PEOPLE = range(1964, 1970), 1000, 15
"""Of the long searches: an evolution for each seed; generations; loops in each for each unknown."""


class Found(NamedTuple):
    """The best closed loop of a search: abscissa (1/s) by its objective, and how it was found."""

    system: str
    objective: str
    gains: dict[str, float]
    abscissa: float
    seed: int
    evaluations: int


def slow_bound() -> float:
    """Return the size (1/s) below which a real root counts as slow: its time constant outlasts the burn."""
    return 1 / constants("vehicle")["t_burn"]


def bounds(system: str) -> dict[str, dict[str, str]]:
    """Return the rows of ``search_bounds`` of a ``system``, by parameter."""
    checks.one_of("system", system, tuple(LOOPS), "search")
    return {row["parameter"]: row for row in read_table("search_bounds") if row["system"] == system}


def slow_roots(poles: NDArray) -> NDArray:
    """Return the slow real root (1/s) in each row of ``poles`` (S, n), nan where there is none."""
    nearest = np.take_along_axis(poles, np.abs(poles).argmin(axis=1)[:, None], axis=1)[:, 0]
    return np.where((nearest.imag == 0) & (np.abs(nearest) <= slow_bound()), nearest.real, np.nan)


def abscissas(poles: NDArray, apart: bool) -> NDArray:
    """Return the largest real part (1/s) in each row of poles, a slow real one set apart or not.

    Parameters
    ----------
    poles : ndarray of complex, shape (S, n)
        In 1/s.
    apart : bool
        Whether a slow real root does not count.

    Returns
    -------
    ndarray, shape (S,)
    """
    at, slow = np.abs(poles).argmin(axis=1)[:, None], apart & ~np.isnan(slow_roots(poles))[:, None]
    return np.where(slow & (np.arange(poles.shape[1]) == at), -np.inf, poles.real).max(axis=1)


def _spread(row: Mapping[str, str], u: NDArray) -> NDArray:
    """Return the values of one parameter at ``u`` in 0..1: even, even in the logarithm, or in arcsinh."""
    low, high, spread = float(row["low"]), float(row["high"]), row["spread"]
    if spread == "even":
        return low + (high - low) * u
    if spread == "log":
        return low * (high / low) ** u
    return float(spread) * np.sinh((2 * u - 1) * np.arcsinh(high / float(spread)))


def _objective(loops: ControlledVehicle, gains: Mapping[str, NDArray], objective: str) -> NDArray:
    """Return the abscissas (1/s) at many gains; shape (S,)."""
    return abscissas(np.linalg.eigvals(loops.matrices(**gains)), objective.endswith("apart"))


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
    system, objective : str
        One of `LOOPS` and one of `OBJECTIVES`.
    seed, rounds, people : int
        Of the evolution: seed, generations, and loops in each for each unknown.

    Returns
    -------
    Found
        Its gains rounded to nine digits.
    """
    rows = bounds(system)
    checks.one_of("objective", objective, tuple(OBJECTIVES), "search")
    loops, pair = LOOPS[system].around(eqs), objective.startswith("pair")
    fixed = {name for name, row in rows.items() if row["low"] == row["high"]}
    sought = [name for name in rows if name not in fixed | ({"K_A", "K_R"} if pair else set())]

    def gains(u: NDArray) -> dict[str, NDArray]:
        chosen = {name: _spread(rows[name], x) for name, x in zip(sought, u, strict=True)}
        chosen |= {name: _spread(rows[name], np.zeros(u.shape[1])) for name in fixed}
        return loops.with_pair(chosen) if pair else chosen

    def cost(u: NDArray) -> NDArray:
        g = gains(u)
        outside = np.any([~(np.abs(g[n]) <= float(rows[n]["high"])) for n in ("K_A", "K_R")], axis=0)
        inside = {name: np.where(outside, 1.0, x) for name, x in g.items()}
        return np.where(outside, OUT_OF_BOUNDS, _objective(loops, inside, objective))

    cube = [(0.0, 1.0)] * len(sought)
    best = differential_evolution(
        cost,
        cube,
        seed=seed,
        popsize=people,
        maxiter=rounds,
        tol=0,
        polish=False,
        vectorized=True,
        updating="deferred",
    )
    winner = {name: float(f"{x[0]:.9g}") for name, x in gains(best.x[:, None]).items()}
    value = _objective(loops, {name: np.array([x]) for name, x in winner.items()}, objective)
    return Found(system, objective, winner, float(value[0]), seed, (rounds + 1) * people * len(sought))


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
        )
        for key, g in table.items()
    )


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
        The rows are the gains and stations, then the largest real part counted, from the wired
        state space and from determinants, the slow root and its time constant.
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


def _judged(eqs: PerturbationEquations, found: Found) -> dict[str, str]:
    poles = state_space(eqs, found.system, found.gains).poles()
    ways, apart = (
        (poles, roots(polynomial(eqs, found.system, found.gains))),
        found.objective.endswith("apart"),
    )
    first, second = (f"{abscissas(p[None], apart)[0]:.4f}" for p in ways)
    slow = slow_roots(poles[None])[0]
    return {
        "largest real part (1/s)": first,
        "from determinants (1/s)": second,
        "slow real root (1/s)": "none" if np.isnan(slow) else f"{slow:+.2g}",
        "its time constant (s)": f"{1 / abs(slow):.0f}" if abs(slow) > 0 else "",
    }


def long_searches(eqs: PerturbationEquations) -> Iterator[Found]:
    """Yield the best of the long searches for each system of ``eqs`` and each objective."""
    for system in LOOPS:
        for objective in OBJECTIVES:
            tries = [search(eqs, system, objective, seed) for seed in SEEDS]
            yield min(tries, key=lambda found: found.abscissa)


def main() -> None:
    """Print the table ``data/searches.csv``."""
    print("system,objective,parameter,value,unit")
    for found in long_searches(printed_equations()):
        units = {name: row["unit"] for name, row in bounds(found.system).items()}
        rows = [(name, f"{value:.9g}", units[name]) for name, value in found.gains.items()]
        rows += [("abscissa", f"{found.abscissa:.5g}", "1/s"), ("seed", f"{found.seed}", "1")]
        for row in [*rows, ("evaluations", f"{found.evaluations * len(SEEDS)}", "1")]:
            print(found.system, found.objective, *row, sep=",", flush=True)


if __name__ == "__main__":
    main()
