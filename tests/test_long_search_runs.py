"""The runs of the long searches: how many loops, from where, how far, and when they end."""

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import long_searches, pole_factors
from rlswaim.edition.search import Problem

EQS = rl.printed_equations()
N = 3
PAIRED = ("dual_actuation", "pair-all")


class Cube:
    """A problem over a cube of three unknowns whose cost is told by a function."""

    sought, pair = ("a", "b", "c"), False

    def __init__(self, cost):
        self.cost = cost

    def rounded(self, u, digits=9):
        return dict(zip(self.sought, u.tolist(), strict=True))


class Asked(list):
    """What descents are asked for; ``ends`` has for each end that is settled which descents it came from."""

    def __init__(self):
        self.ends = []


@pytest.fixture
def told(monkeypatch):
    """Replace descents by ones that stay where they start and cost ten loops each; return what is asked."""
    asked = Asked()

    def descended(costs, start, rounds, enough):
        asked.append((start, rounds, enough))
        return start, costs(start)[0], 10 * start.shape[1]

    monkeypatch.setattr(long_searches, "descended", descended)
    monkeypatch.setattr(long_searches, "costs_and_slopes", lambda problem, u: (problem.cost(u), None))
    monkeypatch.setattr(long_searches, "settled", lambda problem, u: asked.ends.append(len(asked)) or u)
    return asked


def distance(u):
    """Return the distances from a place."""
    return np.linalg.norm(u - [[0.3], [0.9], [0.05]], axis=0)


def test_a_run_begins_at_the_best_of_many_random_places(told):
    run = long_searches._Run(Cube(distance), 1964).go(evolve=False)
    start, rounds, enough = told[0]
    some = np.random.default_rng(1964).random((N, 20 * 20 * N))
    assert start.shape == (N, 20 * N)
    assert rounds == 150
    assert enough == -np.inf
    assert sorted(distance(start)) == pytest.approx(sorted(distance(some))[: 20 * N])
    assert (
        run.cost == min(distance(s).min() for s, *_ in told) == pytest.approx(distance(run.place[:, None])[0])
    )
    assert run.count == 400 * N + 10 * sum(s.shape[1] for s, *_ in told)


def test_every_way_begins_elsewhere():
    assert len({*long_searches.SEEDS, *long_searches.ADAPTATIONS}) == 4


def test_a_run_may_begin_with_the_people_of_an_evolution(told, monkeypatch):
    people = np.random.default_rng(1).random((N, 15 * N))
    people[:, 0], seen = [0, 1, 0], []
    monkeypatch.setattr(long_searches, "evolution", lambda *given: seen.append(given) or people)
    run = long_searches._Run(Cube(distance), 1965).go(evolve=True)
    assert seen[0][1:] == (10 * N, 15, 1965)
    assert sorted(distance(told[0][0])) == pytest.approx(sorted(distance(people)), abs=1e-5)
    assert ((told[0][0] > 0) & (told[0][0] < 1)).all()  # at a side an angle has no slope
    assert run.count == (10 * N + 1) * 15 * N + 10 * sum(s.shape[1] for s, *_ in told)


def test_jumps_go_around_the_best_and_stay_in_the_cube(told, monkeypatch):
    """Their sizes come in turn: one standard deviation each, apart from what a side turns back."""
    monkeypatch.setattr(long_searches, "evolution", lambda *_: np.full((N, 15 * N), 0.5))
    long_searches._Run(Cube(lambda u: np.abs(u - 0.5).max(axis=0)), 1964).go(evolve=True)
    assert len(told) == 7
    assert [told.ends.count(k) for k in range(1, 8)] == [12, *[4] * 6]
    for hop, (starts, rounds, _) in enumerate(told[1:]):
        assert starts.shape == (N, 6 * N)
        assert rounds == 80
        assert ((starts > 0) & (starts < 1)).all()
        size = (0.03, 0.1, 0.3)[hop % 3]
        assert (starts - 0.5).std() == pytest.approx(min(size, 0.25), rel=0.3)


@pytest.mark.parametrize(
    ("gain", "jumps"), [(0.0, 6), (0.5e-4, 6), (2e-4, 24)], ids=["nothing", "too little", "enough"]
)
def test_a_run_ends_when_jumps_bring_no_more(told, gain, jumps):
    """Each jump brings a little: six that bring less than 1e-4 end a run, else 24 are made."""
    less = Cube(lambda u: np.full(u.shape[1], -gain * len(told)))
    long_searches._Run(less, 1964).go(evolve=False)
    assert len(told) == 1 + jumps


def test_a_held_pair_that_nothing_can_better_ends_a_run(told):
    class Held(Cube):
        pair = True

    run = long_searches._Run(Held(lambda u: np.full(u.shape[1], -1.0)), 1964).go(evolve=False)
    assert len(told) == 1
    assert told[0][2] == pytest.approx(-1, abs=1e-8)
    assert run.cost == -1


@pytest.fixture
def adaptations(monkeypatch):
    """Replace adaptation by one that stays where it starts; return what is asked."""
    asked = []

    def adapted(cost, start, step, rng, rounds):
        asked.append((start, step, rounds))
        return start, float(cost(start[:, None])[0])

    monkeypatch.setattr(long_searches, "adapted", adapted)
    return asked


def test_an_adaptation_begins_at_the_best_of_two_thousand_places(adaptations):
    gains, count = long_searches._by_adaptation(Cube(distance), 1966)
    some = np.random.default_rng(1966).random((N, 2000))
    ((start, step, rounds),) = adaptations
    assert distance(start[:, None])[0] == distance(some).min()
    assert (step, rounds, count) == (0.25, 75 * N, 2000 + 75 * N * (4 * N + 16))
    assert list(gains.values()) == start.tolist()


def test_adaptations_from_the_best_place_take_ever_other_steps(adaptations):
    place = np.array([0.1, 0.2, 0.3])
    _, count = long_searches._by_adaptation(Cube(distance), 1, place)
    assert [step for _, step, _ in adaptations] == [0.03, 0.01, 0.1, 0.03, 0.01]
    assert {rounds for *_, rounds in adaptations} == {100 * N}
    assert count == 5 * 100 * N * (4 * N + 16)


def test_adaptations_of_a_held_pair_end_at_the_pair_itself(adaptations):
    held = Cube(lambda u: np.full(u.shape[1], -1.0))
    held.pair = True
    _, count = long_searches._by_adaptation(held, 1, np.full(N, 0.5))
    assert len(adaptations) == 1
    assert count == 100 * N * (4 * N + 16)


@pytest.mark.parametrize("digits", [9, 15])
def test_stored_gains_have_the_digits_that_are_asked_for(digits):
    problem = Problem(EQS, *PAIRED)
    u = np.full(len(problem.sought), 1 / 3)
    found = problem.rounded(u, digits)
    for name, value in problem.gains(u[:, None]).items():
        assert found[name] == pytest.approx(value[0], rel=10.0 ** (1 - digits))
        assert float(f"{found[name]:.{digits - 1}e}") == found[name]


def test_one_sensor_less_is_a_gain_of_zero_somewhere_else():
    alone = {"K_A": 1.0, "K_C": 10.0, "K_R": 0.5}
    one = long_searches.embedded(alone, "single_sensor")
    assert one == {**alone, "K_z": 0.0, "sensor": 0.0}
    for station, other in ((39.0, 420.0), (300.0, 0.0)):
        two = long_searches.embedded({**alone, "K_z": 0.2, "sensor": station}, "two_sensor")
        assert two == {**alone, "K_za": 0.2, "K_zb": 0.0, "sensor_a": station, "sensor_b": other}


def test_settling_keeps_the_place_if_the_way_from_it_is_lost(monkeypatch):
    """A step that ends at no number is not gone on from."""
    problem = Problem(EQS, "single_sensor", "all")
    place = np.full(len(problem.sought), 0.4)

    class Lost:
        def __init__(self, problem, u):
            assert np.isfinite(u).all()

        def settled(self):
            return np.full(len(problem.sought), np.nan), 1.0

    monkeypatch.setattr(pole_factors, "_Factored", Lost)
    monkeypatch.setattr(problem, "cost", lambda u: np.arange(u.shape[1], dtype=float))
    assert pole_factors.settled(problem, place).tolist() == place.tolist()
