"""Effectors with limits: against Fourier's integral, linear responses, statics and a bound."""

from dataclasses import replace

import control
import numpy as np
import pytest

from rlswaim.practice import designs, nonlinear
from rlswaim.practice.dispersed import consistent_booster, vehicles, with_gravity
from rlswaim.practice.hardware import closed_loop, plant, real_hardware
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.practice.margins import frequency_response, margins
from rlswaim.practice.optimal import lqg

READ = (*gyros(60.0), Instrument("accelerometer", designs.NOSE))
EQS = with_gravity(consistent_booster())
WHOLE = plant(EQS, READ, jet=designs.NOSE)
MADE = lqg(consistent_booster(), READ, designs.WISHES["LQG with recovery, nose jet"], designs.NOSE)
LIMITS = nonlinear.limits()


def test_describing_function_is_the_first_harmonic():
    phase = np.linspace(0, 2 * np.pi, 400_001)[:-1]
    for amplitude in (1.01, 2.0, 10.0):
        command = amplitude * np.sin(phase)
        out = 3.0 * np.sign(command) * (np.abs(command) > 1.0)
        first = 2 * np.mean(out * np.sin(phase)) / amplitude
        assert nonlinear.describing_function(amplitude, 3.0, 1.0) == pytest.approx(first, abs=2e-4)
    assert nonlinear.describing_function(0.5, 3.0, 1.0) == 0.0


def test_foretold_cycles_close_the_loop():
    L = closed_loop(WHOLE, MADE, "delta_r_c")
    cycles = nonlinear.foretold_cycles(margins(L), LIMITS.valve, LIMITS.dead_band)
    assert len(cycles) >= 2
    for amplitude, omega, _ in cycles:
        gain = nonlinear.describing_function(amplitude, LIMITS.valve, LIMITS.dead_band)
        assert abs(1 + gain * frequency_response(L, np.array([omega]))[0, 0, 0]) < 1e-6


def test_without_limits_it_is_linear():
    run = nonlinear.simulate(WHOLE, MADE, lambda u, before: u, {"alpha": 0.01}, 8.0, 0.001)
    both = closed_loop(WHOLE, MADE)
    start = np.zeros(both.nstates)
    start[: WHOLE.nstates] = np.linalg.lstsq(WHOLE.C[:7], [0.01, *np.zeros(6)])[0]
    found = control.initial_response(both, run["t"], start)
    for name in ("alpha", "theta", "delta_r"):
        exact = found.y[both.output_labels.index(name)].ravel()
        assert exact[0] == pytest.approx(0.01 if name == "alpha" else 0.0)
        assert np.allclose(run[name][100:], exact[100:], atol=0.01 * np.abs(exact).max())


@pytest.mark.parametrize("name", [*vehicles()])
def test_authority_holds_the_unstable_root_still(name):
    """With the effector's force and a degree of wind the root's own motion has no drive."""
    eqs = with_gravity(vehicles()[name])
    found, vehicle = nonlinear.authority(eqs, 27.0), eqs.state_space(27.0)
    values, vectors = np.linalg.eig(vehicle.A)
    rows = np.linalg.inv(vectors)
    at = int(values.real.argmax())
    assert found["root"] == pytest.approx(values[at].real)
    drive = rows[at] @ vehicle.B
    assert abs(drive[2] * np.radians(1) + drive[1] * found["jet"]) < 1e-9 * abs(drive[2])
    assert abs(drive[2] + drive[0] * found["engine"]) < 1e-9 * abs(drive[2])


def test_region_stays_within_the_bound_of_any_controller():
    bound = nonlinear.farthest(EQS, designs.NOSE, LIMITS)
    found = nonlinear.region(WHOLE, MADE, LIMITS, 1.2 * bound)
    assert 0.5 * bound < found < 1.002 * bound


def test_limits_are_kept():
    run = nonlinear.simulate(WHOLE, MADE, nonlinear.limited(LIMITS, 0.01), {"alpha": 0.1}, 10.0)
    assert np.abs(run["delta_r"]).max() < 1.3 * LIMITS.jet  # Pade's delay overshoots
    assert np.abs(run["delta"]).max() < 1.1 * LIMITS.engine


def test_cycle_of_a_sine():
    t = np.arange(0, 300, 0.01)
    assert nonlinear.cycle_in(t, 3 * np.sin(1.3 * t) + 1) == pytest.approx((3.0, 1.3), rel=0.03)


def test_delay_is_a_delay():
    late = nonlinear.delayed(lambda u, before: 2 * u, 3)
    found = [late(np.array([k, 1.0]), np.zeros(2))[0] for k in range(1, 7)]
    assert found == [0, 0, 0, 2, 4, 6]


def test_exact_delay_and_pades_agree_on_a_smooth_motion():
    step = 0.005
    bare = plant(EQS, READ, replace(real_hardware(), delay=0.0), jet=designs.NOSE)
    late = nonlinear.delayed(lambda u, before: u, round(real_hardware().delay / step))
    exact = nonlinear.simulate(bare, MADE, late, {"alpha": 0.01}, 8.0, step)
    pade = nonlinear.simulate(WHOLE, MADE, lambda u, before: u, {"alpha": 0.01}, 8.0, step)
    for name in ("alpha", "theta"):
        assert np.allclose(exact[name], pade[name], atol=0.03 * np.abs(pade[name]).max())
