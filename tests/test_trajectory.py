"""Section II's ascent: closed forms against each other, integration, and the printed condition."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from rlswaim import ledger
from rlswaim.edition.section_2 import computed
from rlswaim.vehicle.trajectory import (
    Ascent,
    closed_form,
    density,
    dynamic_pressure,
    fly,
    level_at_burnout,
    mean_sine,
    speed_for,
    swaim_ascent,
    turn,
)

ASCENT = swaim_ascent()
times = st.floats(0.5, 110)
sines = st.floats(0, 1)


@given(times, sines)
def test_speed_is_the_integral_of_acceleration(t, sine):
    integral, _ = quad(lambda tau: float(ASCENT.acceleration(tau, sine)), 0, t)
    assert ASCENT.speed(t, sine) == pytest.approx(integral, rel=1e-9, abs=1e-6)


@given(times, sines)
def test_both_writings_of_the_altitude_agree(t, sine):
    assert ASCENT.altitude(t, sine) == pytest.approx(
        ASCENT.altitude_before_collecting(t, sine), rel=1e-9, abs=1e-6
    )


@given(st.floats(0.2, np.pi / 2))
def test_straight_climb_makes_the_closed_forms_exact(gamma):
    run = np.linspace(0, 100, 5)
    flown, closed = (way(ASCENT, lambda t: gamma, run) for way in (fly, closed_form))
    np.testing.assert_allclose(flown.U, closed.U, rtol=1e-6)
    np.testing.assert_allclose(flown.h, closed.h, rtol=1e-6, atol=1e-3)


def test_a_bent_path_is_put_too_high_by_the_closed_form():
    run = np.linspace(0, 100, 201)
    program = level_at_burnout(ASCENT)
    flown, closed = fly(ASCENT, program, run), closed_form(ASCENT, program, run)
    np.testing.assert_allclose(flown.U, closed.U, rtol=1e-6)
    assert (closed.h[1:] > flown.h[1:]).all()


def test_program_is_vertical_at_launch_and_level_at_burnout():
    program = level_at_burnout(ASCENT)
    assert [program(0), program(ASCENT.t_burn)] == pytest.approx([np.pi / 2, 0])
    assert mean_sine(program, ASCENT.t_burn) == pytest.approx(2 / np.pi)
    assert mean_sine(program, 0) == 1


def test_no_one_mean_sine_gives_the_printed_speed_and_altitude():
    for_speed = ASCENT.mean_sine_for_speed(57.5, 1860)
    for_altitude = ASCENT.mean_sine_for_altitude(57.5, 35800)
    assert ASCENT.speed(57.5, for_speed) == pytest.approx(1860)
    assert ASCENT.altitude(57.5, for_altitude) == pytest.approx(35800)
    assert (for_speed, for_altitude) == pytest.approx((0.939, 0.541), abs=1e-3)


def test_standard_atmosphere():
    # U.S. Standard Atmosphere: sea level, and the tropopause at 11,019 m (36,152 ft) above the ground
    np.testing.assert_allclose(density([0, 36152]), [0.0023769, 0.00070610], rtol=2e-4)
    assert dynamic_pressure(35800, speed_for(1340, 35800)) == pytest.approx(1340)


def test_printed_flight_condition_is_not_consistent():
    entries = {entry.id: entry for entry in ledger()}
    assert entries["fig3-q_D"].percent == pytest.approx(-7.6, abs=0.1)
    assert entries["fig4-U"].percent == pytest.approx(4.8, abs=0.1)
    assert entries["fig3-h"].percent == pytest.approx(2.7, abs=0.1)
    assert computed()["fig3-t"] == pytest.approx(57.05, abs=0.1)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Ascent(1e5, 0, 1e7, 32.2, 60), "m_p in Ascent: got 0, wanted a number above 0"),
        (lambda: Ascent(1e5, 2000, 1e7, 32.2, 60), "mass at burnout in Ascent: got -20000"),
        (lambda: ASCENT.mass(120), "t in Ascent: got 120 s, wanted 0 to 110 s"),
        (lambda: ASCENT.mean_sine_for_altitude(57.5, 60000), "h: got 60000 ft, wanted 0 to"),
        (lambda: fly(ASCENT, lambda t: float("nan"), [0, 1]), "gamma_0 in fly at t = 0 s: got nan"),
        (lambda: density(-1), "h in density: got -1 ft, wanted 0 to 265000 ft"),
    ],
)
def test_bad_input_is_named(call, words):
    with pytest.raises(ValueError, match="^" + words.replace("(", r"\(")):
        call()


def test_a_turn_is_upright_at_first_then_even_and_level_at_last():
    program = turn(10.0, 90.0)
    angles = [program(t) for t in (0.0, 10.0, 30.0, 50.0, 90.0, 110.0)]
    assert np.degrees(angles) == pytest.approx([90, 90, 67.5, 45, 0, 0])
