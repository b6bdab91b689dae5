"""Section II's claim on reduced loading: fixed gains over the dynamic pressure and over the burn."""

from dataclasses import replace

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import reduced_loading
from rlswaim.loops import closed_loops
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle import eq_29, trajectory

BOOSTER, ASCENT = rl.swaim_booster(), trajectory.swaim_ascent()
LESS = reduced_loading.at_less_pressure(BOOSTER)
BURN = reduced_loading.along_the_burn(BOOSTER, ASCENT, trajectory.level_at_burnout(ASCENT))
OURS, REPORT = reduced_loading.stable_designs(), reduced_loading.report_designs()
SHARES, TIMES = np.linspace(0, 1, 21), np.arange(5.0, 109.0, 2.5)
CHANGES = {  # shares of q_D at which a loop becomes stable or unstable, and times of the burn (s)
    "jet, by hand": ([], []),
    "modest jet, pair held": ([0.1288], [17.48]),
    "jet, all free, pair held": ([], []),
    "Figure 25's jet": ([0.9412], [54.31, 62.51]),
    "one sensor, a slow root apart": ([0.9855], []),
}


@pytest.mark.parametrize("name", OURS)
def test_where_our_loops_change_sides(name):
    shares, times = CHANGES[name]
    found = reduced_loading.changes(LESS, OURS[name], SHARES)
    assert found == pytest.approx(shares, abs=5e-5)
    assert reduced_loading.changes(BURN, OURS[name], TIMES) == pytest.approx(times, abs=5e-3)
    assert reduced_loading.abscissa(BOOSTER, OURS[name]) < 0
    assert all((reduced_loading.abscissa(LESS(x - 1e-4), OURS[name]) > 0) for x in found)


@pytest.mark.parametrize("name", REPORT)
def test_no_design_of_the_report_is_stable_at_the_worst_condition(name):
    """So that its claim says nothing of them."""
    assert reduced_loading.abscissa(BOOSTER, REPORT[name]) > 1


def test_the_modest_loop_is_unstable_without_air_from_determinants_too():
    """Its unstable pair is not slow: the other way to the characteristic polynomial has it as well."""
    system, gains = OURS["modest jet, pair held"]
    for share, sign in ((0.0, 1), (0.12, 1), (0.14, -1), (1.0, -1)):
        eqs = rl.perturbation_equations(LESS(share))
        found = roots(closed_loops.polynomial(eqs, system, gains))
        assert np.sign(found[abs(found) > 1e-6].real.max()) == sign
    still = roots(closed_loops.polynomial(rl.perturbation_equations(LESS(0.0)), system, gains))
    assert still.real.max() == pytest.approx(0.0859, abs=5e-4)


def test_less_pressure_scales_the_air_s_part_of_eq_29_and_nothing_else():
    calm, whole, half = (eq_29.coefficients(LESS(share)) for share in (0.0, 1.0, 0.5))
    for name, value in whole.items():
        assert half[name] == pytest.approx((value + calm[name]) / 2, abs=1e-12), name
    assert calm["M_alpha"] == calm["Z_alpha"] == 0
    assert calm["M_delta"] == whole["M_delta"]
    assert LESS(0.3).flight == replace(BOOSTER.flight, q_D=0.3 * BOOSTER.flight.q_D)


def test_the_burn_has_the_flight_s_pressure_speed_and_mass():
    flown = trajectory.fly(ASCENT, trajectory.level_at_burnout(ASCENT), [0.0, 40.0]).at(40.0)
    there = BURN(40.0)
    assert pytest.approx(flown["U"], rel=1e-6) == there.flight.U
    assert there.flight.q_D == pytest.approx(flown["q_D"], rel=1e-6)
    assert pytest.approx(8e6 / 32.2 - 1690 * 40.0) == there.M
    assert there.flight.gamma_0 == pytest.approx(np.pi / 2 * (1 - 40 / 110))
    assert (there.I_y, there.l_CG, there.modes) == (BOOSTER.I_y, BOOSTER.l_CG, BOOSTER.modes)


def test_course_is_the_abscissa_at_each_value():
    found = reduced_loading.course(LESS, OURS["jet, by hand"], [0.0, 1.0])
    assert found == pytest.approx([-0.1594, -0.1714], abs=5e-4)
