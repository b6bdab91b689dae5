"""Descents of the searches: slopes against differences, kinks, bounds, and pairs that meet."""

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import search
from rlswaim.edition.abscissa_slopes import costs_and_slopes
from rlswaim.edition.descent import descended
from rlswaim.edition.pole_factors import settled
from rlswaim.loops.closed_loops import LOOPS

EQS = rl.printed_equations()


def problem_at(system, objective, n=3):
    """Return a problem and places of its cube."""
    problem = search.Problem(EQS, system, objective)
    return problem, np.random.default_rng(1964).uniform(0.05, 0.95, (len(problem.sought), n))


@pytest.mark.parametrize("objective", search.OBJECTIVES)
@pytest.mark.parametrize("system", LOOPS)
def test_costs_of_a_descent_are_those_of_the_search_and_their_slopes_are_differences(system, objective):
    problem, u = problem_at(system, objective)
    f, slopes = costs_and_slopes(problem, u)
    cost = problem.cost(u)
    same = cost < search.OUT_OF_BOUNDS
    if objective.endswith("apart"):  # a root that is not slow costs its size beyond the bound, no more
        assert (f[same] <= cost[same] + 1e-9).all()
    else:
        assert f[same] == pytest.approx(cost[same], rel=1e-9)
    assert (f[~same] > -1e3).all()
    h = 1e-5
    for i, e in enumerate(np.eye(len(u))):
        up, down = (costs_and_slopes(problem, u + sign * h * e[:, None])[0] for sign in (1, -1))
        smooth = np.abs(up + down - 2 * f) < 1e-5 * np.maximum(np.abs(f), 1)  # no kink between
        assert slopes[i, smooth] == pytest.approx(
            (up - down)[smooth] / (2 * h), rel=2e-3, abs=2e-4 * np.abs(slopes).max()
        )


def test_a_descent_follows_a_valley_to_its_kink():
    """The least of the largest of four slopes lies at a kink, narrower one way than the other."""
    wanted, steep = np.array([0.3, 0.8, 0.41, 0.52]), np.array([1.0, 3.0, 9.0, 2.0])
    rows = steep[:, None] * (np.eye(4) + 1)

    def costs(u):
        parts = rows @ (u - wanted[:, None])
        k = np.abs(parts).argmax(axis=0)
        signed = parts[k, np.arange(u.shape[1])]
        return np.abs(signed), rows[k].T * np.sign(signed)

    start = np.random.default_rng(1964).random((4, 8))
    ends, least, count = descended(costs, start, 600)
    assert least.max() < 1e-6
    assert ends == pytest.approx(np.repeat(wanted[:, None], 8, axis=1), abs=1e-5)
    assert 8 < count <= 8 * 601


def test_a_descent_stays_in_the_cube_and_ends_when_it_is_told_enough():
    def costs(u):
        return -u.sum(axis=0), -np.ones_like(u)

    start = np.full((3, 2), 0.2)
    ends, least, _ = descended(costs, start, 300)
    assert least == pytest.approx([-3, -3], abs=1e-6)
    assert (ends <= 1).all()
    _, some, few = descended(costs, start, 300, enough=-1.0)
    assert some.min() <= -1 < -0.6
    assert few < 20


def test_where_four_pairs_meet_the_factors_find_what_gains_alone_miss():
    """Near the best loop of the modest jet an abscissa falls like the fourth root of the gains' change."""
    winner = rl.searches()["modest_jet", "all"]
    problem = search.Problem(EQS, "modest_jet", "all")
    off = problem.place(winner.gains) + 2e-3 * np.random.default_rng(1964).standard_normal(8)
    start = np.clip(off, 1e-6, 1 - 1e-6)
    place = settled(problem, start)
    before, after = (problem.cost(u[:, None])[0] for u in (start, place))
    assert before > -1.6
    assert after == pytest.approx(-1.629, abs=2e-3)
    poles = np.linalg.eigvals(problem.loops.matrices(**problem.gains(place[:, None])))[0]
    assert (np.abs(poles - (-1.629 + 1.413j)) < 0.05).sum() == 4


def test_settling_never_gets_worse_and_leaves_the_cube_never():
    for system, objective in (("single_sensor", "apart"), ("two_sensor", "all"), ("figure_25", "all")):
        problem, u = problem_at(system, objective, 2)
        for start in u.T:
            place = settled(problem, start)
            assert ((place >= 0) & (place <= 1)).all()
            assert problem.cost(place[:, None])[0] <= problem.cost(start[:, None])[0]
