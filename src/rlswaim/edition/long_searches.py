"""The long searches that ``python -m rlswaim.edition.long_searches`` prints as ``data/searches.csv``.

Two ways that share no start search each problem: differential evolution, and adaptation from random places.
The best of both, the winner in the last table, and the winners of all problems that are this one with a
constraint more, compete as the place to adapt from with small steps.  So no winner is worse than the last
one, or than one that is more constrained; the table tells what each way found without these starts.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.adaptation import adapted
from rlswaim.edition.search import OBJECTIVES, Found, Problem, bounds, search, searches
from rlswaim.edition.slow_roots import abscissas
from rlswaim.loops.closed_loops import LOOPS, state_space
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations
from rlswaim.vehicle.stations import LENGTH

SEEDS, ROUNDS = (1964, 1965), 50
"""Of the differential evolutions: one for each seed, and generations for each unknown."""
ADAPTATIONS, ADAPTED = (1966, 1967), 75
"""Seeds of the adaptations from random places, and generations for each unknown."""
STEPS, LAST = (0.03, 0.01, 0.1, 0.03, 0.01), 100
"""Steps of the adaptations from the best place, one after another, and generations for each unknown."""
NO_MORE = -1.0
"""Abscissa (1/s) of a held pair itself: with it no loop has a lesser one."""
WITHIN = {
    "single_sensor": "rigid_angle",
    "two_sensor": "single_sensor",
    "dual_actuation": "modest_jet figure_25",
}
"""Systems of which one is the other with a gain at 0 or within narrower bounds."""
HARDER = {"all": ("pair-all",), "apart": ("all", "pair-apart"), "pair-all": (), "pair-apart": ("pair-all",)}
"""Objectives whose loops are at least as good by another."""
ORDER = (
    "rate_attitude",
    "rigid_angle",
    "single_sensor",
    "two_sensor",
    "figure_25",
    "modest_jet",
    "dual_actuation",
)
"""Systems such that what lies within one comes before it."""
Key = tuple[str, str]


def constrained(system: str, objective: str) -> list[Key]:
    """Return the problems that are a given one with one constraint more.

    Parameters
    ----------
    system, objective : str
        One of `LOOPS` and one of `OBJECTIVES`.
    """
    within = [(inner, objective) for inner in WITHIN.get(system, "").split()]
    return [*((system, harder) for harder in HARDER[objective]), *within]


def embedded(gains: Mapping[str, float], system: str) -> dict[str, float]:
    """Return the gains of a more constrained system as gains of another.

    Parameters
    ----------
    gains : mapping of str to float
    system : str
        The other; it has one sensor or two.
    """
    given = dict(gains)
    if system == "single_sensor":
        given = {"K_z": 0.0, "sensor": 0.0, **given}
    if system == "two_sensor" and "K_z" in given:
        given |= {"K_za": given.pop("K_z"), "K_zb": 0.0}
        first = given.pop("sensor")
        given |= {"sensor_a": first, "sensor_b": LENGTH if first < LENGTH / 2 else 0.0}
    return given


def exact_abscissa(eqs: PerturbationEquations, key: Key, gains: Mapping[str, float]) -> float:
    """Return the abscissa (1/s) by an objective from a polynomial whose coefficients are correctly rounded.

    Parameters
    ----------
    eqs : PerturbationEquations
    key : tuple of str
        System and objective.
    gains : mapping of str to float
    """
    poles = roots(characteristic_polynomial(state_space(eqs, key[0], gains).A))
    return float(abscissas(poles[None], key[1].endswith("apart"))[0])


class _Try(NamedTuple):
    """One place that was found: its abscissa (1/s), gains and the seed of the way there."""

    abscissa: float
    gains: dict[str, float]
    seed: int


def _abscissa(found: _Try) -> float:
    return found.abscissa


def _by_adaptation(problem: Problem, seed: int, start: NDArray | None = None) -> tuple[dict[str, float], int]:
    """Return gains that adaptation finds from a place or, without one, a good random one; and its loops."""
    rng, n = np.random.default_rng(seed), len(problem.sought)
    people, count = 4 * n + 16, 0
    if start is None:
        some = rng.random((n, 2000))
        found, _ = adapted(problem.cost, some[:, problem.cost(some).argmin()], 0.25, rng, ADAPTED * n)
        return problem.rounded(found), 2000 + ADAPTED * n * people
    found = start
    for step in STEPS:
        found, value = adapted(problem.cost, found, step, rng, LAST * n)
        count += LAST * n * people
        if problem.pair and value <= NO_MORE + 1e-9:
            break
    return problem.rounded(found), count


def long_search(
    eqs: PerturbationEquations, key: Key, done: Mapping[Key, Found], last: Found | None = None
) -> Found:
    """Return the best of all ways for one problem.

    Parameters
    ----------
    eqs : PerturbationEquations
    key : tuple of str
        System and objective.
    done : mapping of tuple of str to Found
        The winners of the problems that `constrained` names.
    last : Found, optional
        The winner of an earlier search.

    Returns
    -------
    Found
        Its abscissas are those of `exact_abscissa`.
    """
    problem, count = Problem(eqs, *key), 0

    def tried(gains: dict[str, float], seed: int) -> _Try:
        return _Try(exact_abscissa(eqs, key, gains), gains, seed)

    one, other = [], []
    for seed in SEEDS:
        evolved = search(eqs, *key, seed=seed, rounds=ROUNDS * len(problem.sought))
        one.append(tried(evolved.gains, seed))
        count += evolved.evaluations
    for seed in ADAPTATIONS:
        gains, more = _by_adaptation(problem, seed)
        other.append(tried(gains, seed))
        count += more
    starts = [*(done[inner] for inner in constrained(*key)), *([last] if last else [])]
    alone = [min(map(_abscissa, ways)) for ways in (one, other)]
    tries = [*one, *other, *(tried(embedded(s.gains, key[0]), s.seed) for s in starts)]
    best = min(tries, key=_abscissa)
    gains, more = _by_adaptation(problem, best.seed, problem.place(best.gains))
    best = min(best, tried(gains, best.seed), key=_abscissa)
    return Found(*key, best.gains, best.abscissa, best.seed, count + more, *alone)


def long_searches(eqs: PerturbationEquations) -> Iterator[Found]:
    """Yield the winners for each system of ``eqs`` and each objective, in their order."""
    done: dict[Key, Found] = {}
    last = searches()
    for system in ORDER:
        for objective in ("pair-all", "pair-apart", "all", "apart"):
            done[system, objective] = long_search(
                eqs, (system, objective), done, last.get((system, objective))
            )
    for system in LOOPS:
        for objective in OBJECTIVES:
            yield done[system, objective]


def main() -> None:
    """Print the table ``data/searches.csv``."""
    print("system,objective,parameter,value,unit")
    for found in long_searches(printed_equations()):
        units = {name: row["unit"] for name, row in bounds(found.system).items()}
        rows = [(name, f"{found.gains[name]:.9g}", unit) for name, unit in units.items()]
        rows += [
            (name, f"{getattr(found, name):.5g}", "1/s") for name in ("abscissa", "evolution", "adaptation")
        ]
        rows += [("seed", f"{found.seed}", "1"), ("evaluations", f"{found.evaluations}", "1")]
        for row in rows:
            print(found.system, found.objective, *row, sep=",", flush=True)


if __name__ == "__main__":
    main()
