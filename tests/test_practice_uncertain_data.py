"""Bounds of mu of the designs: the first order, the stored vehicles that are lost, the draws beside them."""

import numpy as np
import pytest

from rlswaim.practice import uncertain_data as s
from rlswaim.practice.designs import designs
from rlswaim.practice.dispersed import drawn, factor_names, factors_at
from rlswaim.practice.monte_carlo import spreads

STORED, COUNT = s.stored(), len(factor_names())
NAME = "LQG with recovery, nose jet"


@pytest.fixture(scope="module")
def system():
    return s.uncertain(designs()[NAME])


def test_first_order_is_the_tangent(system):
    rng = np.random.default_rng(1)
    zero = np.sort_complex(np.linalg.eigvals(s.matrix_at(designs()[NAME], np.zeros(COUNT))))
    assert np.allclose(np.sort_complex(np.linalg.eigvals(system.A)), zero, atol=1e-6)
    d = rng.uniform(-1, 1, COUNT)
    errors = []
    for size in (0.02, 0.01):
        full = np.linalg.eigvals(s.matrix_at(designs()[NAME], size * d)).sum()
        errors.append(abs(full - np.trace(system.at(size * d))))
    assert errors[1] < 0.3 * errors[0]  # the rest is of second order


def test_determinant_vanishes_where_a_root_is(system):
    """det(I - M diag(d)) = det(s I - A(d))/det(s I - A)."""
    d = np.random.default_rng(2).uniform(-1, 1, COUNT)
    at = 0.01 + 1.7j
    sizes = [E.shape[1] for E in system.E]
    left = np.linalg.det(np.eye(sum(sizes)) - system.M(at) * np.repeat(d, sizes))
    ratio = (at - np.linalg.eigvals(system.at(d))) / (at - np.linalg.eigvals(system.A))
    assert left == pytest.approx(np.prod(ratio), rel=1e-6)


def test_factors_at_the_ends_are_the_spreads():
    assert factors_at(np.zeros(COUNT)) == dict.fromkeys(factor_names(), 1.0)
    high, low = (
        factors_at(np.ones(COUNT)),
        factors_at(-np.ones(COUNT)),
    )
    for index in range(20):
        assert all(low[name] <= value <= high[name] for name, value in drawn(index).items())


def test_all_that_are_named_are_stored():
    assert tuple(STORED) == tuple(name for name in designs() if name in s.JUDGED)
    assert set(STORED) == set(s.JUDGED)


@pytest.mark.parametrize("name", STORED)
def test_lower_bound_is_a_vehicle_that_is_lost(name):
    found, design = STORED[name], designs()[name]
    d = np.array([found.lost[factor] for factor in factor_names()])
    assert np.abs(d).max() == pytest.approx(1 / found.lower, rel=1e-4)
    assert s._right(s.matrix_at(design, 1.001 * d)) > 0
    assert s._right(s.matrix_at(design, 0.9 * d)) < 0


@pytest.mark.parametrize("name", STORED)
def test_bounds_are_in_order_to_the_first_order(name):
    found = STORED[name]
    assert found.first_order <= found.upper
    assert found.upper == pytest.approx(found.curve[1].max(), rel=1e-5)
    assert found.upper < 6 * found.first_order


@pytest.mark.parametrize("at", [0, 10])
def test_curve_comes_out_again(at, system):
    omega, values = STORED[NAME].curve
    again = s.upper_bound(system.M(s.slowest() + 1j * omega[at]), tuple(E.shape[1] for E in system.E))
    assert again == pytest.approx(values[at], rel=0.1)  # a descent ends nearer or farther with rounding


@pytest.mark.parametrize("name", STORED)
def test_draws_agree(name):
    """With mu below 1 to the first order few draws are lost; where one is lost well inside, some are."""
    found, share = STORED[name], spreads()[name]
    if found.upper < 1:
        assert share.stable >= 0.995 * share.draws
    if found.lower > 3:
        assert share.stable < share.draws
