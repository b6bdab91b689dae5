"""The rate limit: its describing function by quadrature, its motion by a solver with its own steps."""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from rlswaim.practice import rate_limit as r
from rlswaim.practice.conclusions_on_rungs import CONCLUSIONS
from rlswaim.practice.ladder import Rung, dual_actuation_on
from rlswaim.practice.ladder_search import modest_gains
from rlswaim.practice.rungs import ladder_steps

EQS = ladder_steps()["as printed"].eqs
LOOP = r.modest_loop()


@pytest.mark.parametrize("amplitude", [0.5, 1.0, 1.01, 2.0, 30.0])
def test_describing_function_is_the_first_harmonic(amplitude):
    def passed(x):
        return np.clip(amplitude * np.sin(x), -1, 1) * np.sin(x)

    corner = np.arcsin(min(1.0, 1 / amplitude))
    parts = [quad(passed, *ends)[0] for ends in ((0, corner), (corner, np.pi / 2))]
    first = 4 * sum(parts) / np.pi / amplitude
    assert r.limit_function(amplitude, 1.0) == pytest.approx(first, rel=1e-7)


def test_without_the_limit_it_is_the_loop():
    closed = dual_actuation_on(EQS, Rung(), **modest_gains()).closed
    assert np.allclose(LOOP.A + np.outer(LOOP.b, LOOP.c), closed.A)
    assert pytest.approx(np.radians(10.0)) == LOOP.most


def test_swing_solves_the_loop_with_its_gain():
    amplitude, omega = r.foretold(LOOP)
    gain = r.limit_function(amplitude, LOOP.most)
    poles = np.linalg.eigvals(LOOP.A + gain * np.outer(LOOP.b, LOOP.c))
    assert np.abs(poles - 1j * omega).min() < 1e-6
    for more, right in ((1.02, False), (0.98, True)):
        poles = np.linalg.eigvals(LOOP.A + more * gain * np.outer(LOOP.b, LOOP.c))
        assert (poles.real.max() > 0) == right


def by_solver(start, wind, until):
    """Return whether an ordinary solver's motion is at rest at the end, by its own steps."""

    def slope(t, x):
        return LOOP.A @ x + LOOP.b * np.clip(LOOP.c @ x, -LOOP.most, LOOP.most) + LOOP.g * wind(t)

    def lost(t, x):
        return np.abs(x[:3]).max() - r.LOST

    lost.terminal = True
    run = solve_ivp(slope, (0, until), start, max_step=0.02, rtol=1e-8, atol=1e-10, events=lost)
    return run.status == 0 and np.abs(LOOP.c @ run.y[:, -1]) < LOOP.most


def test_largest_gust_by_another_solver():
    duration = 4.0
    peak = r.largest_gust(LOOP, EQS.U, duration)
    for factor, well in ((0.98, True), (1.02, False)):

        def wind(t, size=factor * peak):
            return size / EQS.U / 2 * (1 - np.cos(2 * np.pi * t / duration)) if t < duration else 0.0

        assert by_solver(np.zeros(len(LOOP.A)), wind, 44.0) == well


def test_describing_function_foretells_the_border_to_a_tenth():
    """The limit's higher harmonics pass through a loop that falls off: the foretold border is near."""
    ratio = r.found_beside_foretold(LOOP)
    assert 0.9 < ratio < 1.1
    amplitude, omega = r.foretold(LOOP)
    passed = r.limit_function(amplitude, LOOP.most) * amplitude
    swing = np.linalg.solve(1j * omega * np.eye(len(LOOP.A)) - LOOP.A, LOOP.b * passed).real
    for factor, well in ((0.98, True), (1.02, False)):
        assert by_solver(factor * ratio * swing, lambda t: 0.0, 60.0) == well


def test_worst_duration_is_inside_and_the_row_says_so():
    peak, duration = r.worst_gust_held()
    assert r.DURATIONS[0] < duration < r.DURATIONS[-1]
    row = r.cells()
    assert list(row) == list(CONCLUSIONS)
    assert (row["modest"].verdict, row["modest"].number) == ("depends", peak)


def test_refused():
    closed = dual_actuation_on(EQS, Rung(actuator=40.0), **modest_gains()).closed
    with pytest.raises(ValueError, match="closed in rate_limited: got 3 states of the engine, wanted 1"):
        r.rate_limited(closed, 0.2)
    plain = dual_actuation_on(EQS, Rung(), **modest_gains()).closed
    with pytest.raises(ValueError, match="most in rate_limited: got 0"):
        r.rate_limited(plain, 0.0)
