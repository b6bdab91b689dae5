"""The long searches that ``python -m rlswaim.edition.long_searches`` prints as ``data/searches.csv``.

Two ways that share no start search each problem: differential evolution, and adaptation from random places.
With a jet, where several pairs of roots meet at the best loops and both stall, four runs more go on by
descents from many places at once, by the factors of the polynomial (`pole_factors`), and by jumps around
the best: two from the people of short evolutions, two from random places.  The best of all, the winner in
the last table, and the winners of all problems that are this one with a constraint more, compete as the
place to adapt from with small steps.  So no winner is worse than the last one, or than one that is more
constrained; the table tells what each way found without these starts.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.abscissa_slopes import costs_and_slopes
from rlswaim.edition.adaptation import adapted
from rlswaim.edition.descent import descended
from rlswaim.edition.pole_factors import settled
from rlswaim.edition.search import OBJECTIVES, Found, Problem, bounds, evolution, search, searches
from rlswaim.edition.slow_roots import abscissas
from rlswaim.loops.closed_loops import LOOPS, state_space
from rlswaim.rootlocus.exact_polynomials import exact_characteristic_polynomial
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations
from rlswaim.vehicle.stations import LENGTH

SEEDS, ROUNDS = (1964, 1965), 50
"""Of the differential evolutions: one for each seed, and generations for each unknown."""
ADAPTATIONS, ADAPTED = (1966, 1967), 75
"""Seeds of the adaptations from random places, and generations for each unknown."""
STEPS, LAST = (0.03, 0.01, 0.1, 0.03, 0.01), 100
"""Steps of the adaptations from the best place, one after another, and generations for each unknown."""
SHORT_ROUNDS, PEOPLE = 10, 15
"""Of the evolutions that a run of descents begins with: generations, and loops in each, for each unknown."""
STARTS, DESCENTS, SETTLED = 20, 150, 12
"""Of a run: its first descents for each unknown, loops on each at most, and how many ends are settled."""
HOPS, PATIENCE, AROUND, SHORT, FEW = 24, 6, 6, 80, 4
"""Jumps of a run, and jumps for nothing that end it; places around the best for each unknown; loops on each
descent at most; ends that are settled."""
BETTER = 1e-4
"""What a jump must bring (1/s)."""
JUMPS = (0.03, 0.1, 0.3)
"""Standard deviations of the jumps in the unit cube, in turn."""
DIGITS = 15
"""Of stored gains: where roots meet, nine digits would move them by their square or fourth root."""
KEPT = 1e-4
"""What another must be better by (1/s) to take the place of the last winner, which later chapters use."""
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
    """Return the abscissa (1/s) by an objective, from the exact polynomial's roots to sixty digits.

    Where four roots meet, a coefficient's last digit moves them by its fourth root.  Needs mpmath, which
    the tests have.

    Parameters
    ----------
    eqs : PerturbationEquations
    key : tuple of str
        System and objective.
    gains : mapping of str to float
    """
    import mpmath  # noqa: PLC0415

    polynomial = exact_characteristic_polynomial(state_space(eqs, key[0], gains).A)
    with mpmath.workdps(60):
        exact = [mpmath.mpf(c.numerator) / c.denominator for c in polynomial]
        found = mpmath.polyroots(exact, maxsteps=500, extraprec=600, asc=True)
        poles = np.array([complex(root) for root in found])
    return float(abscissas(poles[None], key[1].endswith("apart"))[0])


class _Run:
    """One run of one way: its generator, its best place so far, and the number of its loops."""

    def __init__(self, problem: Problem, seed: int) -> None:
        self.problem, self.seed, self.rng = problem, seed, np.random.default_rng(seed)
        self.n, self.count = len(problem.sought), 0
        self.place, self.cost = np.full(self.n, 0.5), np.inf

    def improve(self, starts: NDArray, rounds: int, few: int) -> None:
        """Descend from places, settle the best ends, and keep the best of all."""
        enough = NO_MORE + 1e-9 if self.problem.pair else -np.inf
        ends, costs, count = descended(
            lambda u: costs_and_slopes(self.problem, u), np.clip(starts, 1e-6, 1 - 1e-6), rounds, enough
        )
        best = [ends[:, i] for i in np.argsort(costs)[:few]]
        self.settle(np.array(best if self.problem.pair else [settled(self.problem, u) for u in best]).T)
        self.count += count

    def settle(self, places: NDArray) -> None:
        """Keep the best of places."""
        costs = self.problem.cost(places)
        if costs.min() < self.cost:
            self.place, self.cost = places[:, costs.argmin()], float(costs.min())

    def go(self, evolve: bool) -> "_Run":
        """Search from an evolution's people or from random places, then jump around the best."""
        if evolve:
            starts = evolution(self.problem, SHORT_ROUNDS * self.n, PEOPLE, self.seed)
            self.count += (SHORT_ROUNDS * self.n + 1) * PEOPLE * self.n
        else:
            starts = self.rng.random((self.n, 20 * STARTS * self.n))
            self.count += 20 * STARTS * self.n
        self.improve(starts[:, np.argsort(self.problem.cost(starts))[: STARTS * self.n]], DESCENTS, SETTLED)
        idle = 0
        for hop in range(HOPS):
            if idle == PATIENCE or (self.problem.pair and self.cost <= NO_MORE + 1e-9):
                break
            before = self.cost
            jumps = JUMPS[hop % len(JUMPS)] * self.rng.standard_normal((self.n, AROUND * self.n))
            self.improve(1 - np.abs(1 - np.abs(self.place[:, None] + jumps)), SHORT, FEW)
            idle = 0 if self.cost < before - BETTER else idle + 1
        return self


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
    runs: list[_Run] = []
    if "jet" in problem.rows:
        runs = [_Run(problem, seed).go(evolve) for evolve in (True, False) for seed in SEEDS]
    ends = [tried(problem.rounded(run.place, DIGITS), run.seed) for run in runs]
    starts = [*(done[inner] for inner in constrained(*key)), *([last] if last else [])]
    alone = [min(map(_abscissa, ways)) for ways in (one, other)]
    if ends:
        alone += [min(map(_abscissa, ends)), max(map(_abscissa, ends))]
    tries = [*one, *other, *ends, *(tried(embedded(s.gains, key[0]), s.seed) for s in starts)]
    best = min(tries, key=_abscissa)
    gains, loops = _by_adaptation(problem, best.seed, problem.place(best.gains))
    best = min(best, tried(gains, best.seed), key=_abscissa)
    if last:
        before = tried(last.gains, last.seed)
        best = best if best.abscissa < before.abscissa - KEPT else before
    count += loops + sum(run.count for run in runs)
    return Found(*key, best.gains, best.abscissa, best.seed, count, *alone)


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
        rows = [(name, f"{found.gains[name]:.{DIGITS}g}", unit) for name, unit in units.items()]
        rows += [
            (name, f"{getattr(found, name):.5g}", "1/s")
            for name in ("abscissa", "evolution", "adaptation", "descents", "worst")
            if not np.isnan(getattr(found, name))
        ]
        rows += [("seed", f"{found.seed}", "1"), ("evaluations", f"{found.evaluations}", "1")]
        for row in rows:
            print(found.system, found.objective, *row, sep=",", flush=True)


if __name__ == "__main__":
    main()
