"""Each step of a descent beside the textbook's, and the local problem in factors beside differences."""

import numpy as np
import pytest
from numpy.polynomial import polynomial as npp

import rlswaim as rl
from rlswaim.edition import search
from rlswaim.edition.descent import AGAIN, FIRST, FLATTER, LESS, TRIALS, descended
from rlswaim.edition.pole_factors import _Factored
from rlswaim.edition.slow_roots import slow_bound
from rlswaim.loops import closed_loops

EQS = rl.printed_equations()


# ---- descents: BFGS with the line search of Lewis and Overton, written for one place


def on_angles(function):
    """Return costs and slopes over the cube of a function of angles x, where u = sin(pi x/2)^2."""

    def costs(u):
        x = 2 / np.pi * np.arcsin(np.sqrt(u))
        pairs = [function(column) for column in x.T]
        slopes = np.array([pair[1] for pair in pairs]).T
        return np.array([pair[0] for pair in pairs]), slopes / (np.pi / 2 * np.sin(np.pi * x))

    return costs


def line(function, x, f, g, d):
    """Return all trials along a line, and the last one that is taken; None where none is."""
    low, high, t, tried = 0.0, np.inf, 1.0, []
    while True:
        at, slope = x + t * d, g @ d
        value, gradient = function(at)
        tried.append(at)
        lower = value <= f + LESS * t * slope
        if lower and gradient @ d >= FLATTER * slope:
            return tried, (at, value, gradient), True
        low, high = (t, high) if lower else (low, t)
        if len(tried) == TRIALS or (np.isfinite(high) and high - low < 1e-14 * high):
            return tried, (at, value, gradient) if lower else None, False
        t = (low + high) / 2 if np.isfinite(high) else 2 * low


def by_the_textbook(function, x, rounds):
    """Return the places that one descent tries, in angles."""
    f, g = function(x)
    one, asked = np.eye(len(x)), [x]
    H, fresh = one * FIRST / np.linalg.norm(g), True
    while len(asked) <= rounds:
        tried, taken, good = line(function, x, f, g, -H @ g)
        asked += tried
        if taken is None and fresh:
            break
        if good:
            s, y = taken[0] - x, taken[2] - g
            if s @ y > 0:
                H = one * (s @ y) / (y @ y) if fresh else H
                left = one - np.outer(s, y) / (s @ y)
                H = left @ H @ left.T + np.outer(s, s) / (s @ y)
            fresh = False
        if taken is not None:
            x, f, g = taken
        if not good or -g @ H @ g >= 0:
            H, fresh = one * AGAIN / np.linalg.norm(g), True
    return asked[: rounds + 1]


def bowl(x):
    """Return a smooth function of angles, curved unlike in each direction, and its slope."""
    Q, at = np.array([[9.0, 2.0, 0.0], [2.0, 1.0, 0.3], [0.0, 0.3, 30.0]]), np.array([0.4, 0.6, 0.5])
    off = x - at
    return off @ Q @ off + (off**4).sum(), 2 * Q @ off + 4 * off**3


def bend(x):
    """Return a function with a kink across which its slope jumps, and its slope."""
    off, steep = x - np.array([0.45, 0.55, 0.5]), np.array([1.0, 7.0, 2.0])
    return np.abs(off) @ steep + off @ off, np.sign(off) * steep + 2 * off


def wall(x):
    """Return a function that falls evenly up to a wall, so that no place on a line is flat enough."""
    return 10.0 * (x.sum() > 1.7) - x.sum(), -np.ones(3)


def wrong(x):
    """Return a function that falls by half of what a step must bring of its slope: no trial is taken."""
    return -0.5 * LESS * x.sum(), -np.ones(3)


@pytest.mark.parametrize(("function", "rounds"), [(bowl, 16), (bend, 60), (wall, 70), (wrong, 60)])
def test_every_place_is_the_textbook_s(function, rounds):
    start = np.array([[0.2, 0.5], [0.3, 0.35], [0.7, 0.4]])
    asked = []

    def costs(u):
        asked.append(u.copy())
        return on_angles(function)(u)

    ends, least, count = descended(costs, start, rounds)
    ways = [by_the_textbook(function, 2 / np.pi * np.arcsin(np.sqrt(u)), rounds) for u in start.T]
    assert count == sum(map(len, ways))
    alive = [0, 1]
    for k, places in enumerate(asked):
        alive = [i for i in alive if len(ways[i]) > k]
        wanted = np.array([np.sin(np.pi / 2 * ways[i][k]) ** 2 for i in alive]).T
        np.testing.assert_allclose(places, wanted, rtol=1e-5, atol=1e-7)
    np.testing.assert_allclose(on_angles(function)(ends)[0], least, rtol=1e-9)


# ---- the local problem: factors of the polynomial as unknowns


LOCAL = [
    ("single_sensor", "apart"),
    ("two_sensor", "all"),
    ("rate_attitude", "apart"),
    ("modest_jet", "all"),
    ("dual_actuation", "apart"),
]


def local(system, objective, seed):
    """Return a problem, a place of its cube and the local problem there."""
    problem = search.Problem(EQS, system, objective)
    u = np.random.default_rng(seed).uniform(0.1, 0.9, len(problem.sought))
    return problem, u, _Factored(problem, u)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(("system", "objective"), LOCAL)
def test_the_start_is_the_loop_itself(system, objective, seed):
    """Its factors multiply to the loop's polynomial from determinants, and t is the abscissa."""
    problem, u, at = local(system, objective, seed)
    gains = {name: float(value[0]) for name, value in problem.gains(u[:, None]).items()}
    poles = np.concatenate([npp.polyroots(p) for p in at.factors(at.start)])
    polynomial = closed_loops.polynomial(EQS, system, gains)
    size = npp.polyval(np.abs(poles), np.abs(polynomial))
    near = np.abs(poles).argmin()
    exact = np.abs(npp.polyval(poles, polynomial)) < 1e-7 * size
    slow = objective == "apart" and poles[near].imag == 0
    assert exact.sum() >= len(poles) - slow
    if exact.all():
        product = np.array([1.0])
        for factor in at.factors(at.start):
            product = npp.polymul(product, factor)
        np.testing.assert_allclose(product, polynomial, rtol=1e-6, atol=1e-6)
        assert np.abs(at.difference(at.start)).max() < 1e-9
    else:
        assert abs(poles[near]) == pytest.approx(slow_bound())
    others = np.delete(poles, near) if slow else poles
    assert at.start[-1] == pytest.approx(others.real.max())
    assert at.room(at.start).min() == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(("system", "objective"), LOCAL)
def test_slopes_of_the_local_problem_are_differences(system, objective, seed):
    _, _, at = local(system, objective, seed)
    shaken = at.start * (1 + 0.01 * np.random.default_rng(seed).standard_normal(at.start.size))
    for function, slopes in ((at.difference, at.slopes), (at.room, at.room_slopes)):
        found, h = slopes(shaken), 1e-5 * np.eye(shaken.size)
        wanted = np.array([(function(shaken + e) - function(shaken - e)) / 2e-5 for e in h]).T
        np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=1e-6 * np.abs(wanted).max())
