"""What the printed digits fix: derivatives against differences, spread against first order, both by seed."""

from dataclasses import replace

import matplotlib as mpl
import mpmath
import numpy as np
import pytest
from matplotlib import pyplot as plt
from numpy.polynomial import polynomial as npp

import rlswaim as rl
from rlswaim.edition import conditioning, printed_closures
from rlswaim.edition.conclusions import closed_loop
from rlswaim.figures.sensitivities import draw_sensitivities
from rlswaim.loops import closures
from rlswaim.loops.gain_terms import gain_terms
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.equations import COEFFICIENTS

EQS = rl.printed_equations()
LOOPS = conditioning.printed_loops(EQS)
TABLE = conditioning.root_spreads(LOOPS)
JET, KK_Z = printed_closures.final_design()


def figure_8(eqs):
    one, K_C, x, y = gain_terms(eqs, 60).values()
    return one + 10 * (K_C + 1.8 * (x + 0.618 * y))


POLYNOMIALS = {
    "Eq. 41": lambda eqs: eqs.characteristic_polynomial()[1:],
    "Eq. 92, zeros": lambda eqs: eqs.numerator("theta", "delta")[:6],
    "Figure 8": figure_8,
    "closure 1": lambda eqs: closures.closure_1_polynomial(eqs, JET, KK_Z)[1:],
    "closure 2": lambda eqs: closures.theta_numerator(eqs, JET, KK_Z)[:7],
}
"""The same roots by determinants, which share no line with the state matrices."""


def moved(changes):
    return replace(EQS, coefficients=dict(EQS.coefficients) | changes)


def exact(polynomial):
    coefficients = [mpmath.mpf(c) for c in polynomial]
    return np.array(mpmath.polyroots(coefficients, maxsteps=500, extraprec=300, asc=True), dtype=complex)


def nearest(found, wanted):
    return found[np.abs(found[:, None] - wanted).argmin(axis=0)]


@pytest.mark.parametrize("name", POLYNOMIALS)
def test_roots_are_those_of_the_determinants(name):
    found = LOOPS[name].roots
    wanted = exact(POLYNOMIALS[name](EQS))
    assert found.size == wanted.size
    np.testing.assert_allclose(nearest(wanted, found), found, rtol=1e-8, atol=1e-13)


@pytest.mark.parametrize("name", POLYNOMIALS)
@pytest.mark.parametrize("coefficient", ["Z_delta", "M_q1", "F1_alpha", "F1_q2", "F2_q2", "F1_delta"])
def test_slopes_are_those_of_central_differences(name, coefficient):
    value, step = EQS.coefficients[coefficient], 1e-5
    ends = [
        nearest(exact(POLYNOMIALS[name](moved({coefficient: value * f}))), LOOPS[name].roots)
        for f in (1 + step, 1 - step)
    ]
    slopes = conditioning.sensitivity(LOOPS[name])[:, COEFFICIENTS.index(coefficient)]
    difference = (ends[0] - ends[1]) / (2 * step)
    np.testing.assert_allclose(slopes, difference, rtol=1e-4, atol=1e-6)


@pytest.mark.parametrize("name", LOOPS)
def test_family_is_the_loop_at_other_coefficients_too(name):
    rng = np.random.default_rng(38)
    values = LOOPS[name].coefficients * rng.uniform(0.5, 1.5, len(COEFFICIENTS))
    other = conditioning.printed_loops(moved(dict(zip(COEFFICIENTS, values, strict=True))))[name]
    np.testing.assert_allclose(
        LOOPS[name].matrices(values), other.matrices(other.coefficients), rtol=1e-9, atol=1e-9
    )


def test_samples_stay_within_the_last_digit_and_repeat():
    half = dict(zip(COEFFICIENTS, conditioning.half_units(), strict=True))
    assert (half["Z_delta"], half["M_q1"], half["F2_q1dot"]) == pytest.approx((0.05, 0.0005, 0.000005))
    first, again = (conditioning.monte_carlo(LOOPS["Eq. 41"], 50) for _ in range(2))
    assert np.array_equal(first, again)
    assert not np.array_equal(first, conditioning.monte_carlo(LOOPS["Eq. 41"], 50, seed=1))
    assert conditioning.monte_carlo(LOOPS["Eq. 41"]).shape == (2000, 6)  # as the book says


def test_spread_is_first_order_where_a_root_is_well_conditioned():
    """Within 6 percent: four deviations of a spread from 2000 samples, and a little curvature."""
    good = TABLE[TABLE.spread < 0.02]
    assert len(good) > 0.8 * len(TABLE)
    np.testing.assert_allclose(good.spread, good["first order"], rtol=0.06)


def test_digits_fix_every_root_but_the_one_at_the_origin():
    slow = TABLE.root.abs() < 1e-3
    assert slow.sum() == 8
    assert (TABLE.spread[slow] > 0.7).all()
    assert TABLE.spread[~slow].max() == pytest.approx(0.0104, abs=2e-4)
    assert TABLE["real part"][~slow].max() < 0.011
    assert set(TABLE.right[~slow]) == {0.0, 1.0}
    zero = TABLE[slow & (TABLE.loop == "Eq. 92, zeros")].iloc[0]
    assert (zero.coefficient, round(zero.factor)) == ("Z_delta", 754)
    assert 0.2 < zero.right < 0.4


def test_unstable_root_moves_by_a_fifth_of_each_coefficient():
    row = TABLE[(TABLE.loop == "Eq. 41") & (TABLE.right == 1)].iloc[0]
    assert (row.coefficient, row.factor) == ("F1_alpha", pytest.approx(0.197, abs=1e-3))
    assert row.spread == pytest.approx(6.7e-4, abs=2e-5)


def test_loop_that_works_stays_stable_within_the_digits():
    works = conditioning.root_spreads(
        {"it": conditioning.loop_in_coefficients(EQS, lambda e: closed_loop(e, "dual_actuation"))}
    )
    assert (works.right == 0).all()
    assert works.spread.max() == pytest.approx(0.057, abs=0.003)
    assert works.spread.nsmallest(len(works) - 1).max() < 0.002


def test_table_as_texts():
    shown = conditioning.as_texts(TABLE[TABLE.loop == "Eq. 41"])
    assert list(shown.iloc[1][["loop", "root (1/s)", "moved most by"]]) == [
        "Eq. 41",
        "1.30967",
        r"$F_{1\alpha}$",
    ]
    assert float(shown.iloc[1]["spread (%)"]) == pytest.approx(0.067, abs=0.002)


def test_sum_of_slopes_is_what_a_common_factor_does():
    """Euler: all coefficients and U scaled alike leave the zeros of a homogeneous determinant alone."""
    family = LOOPS["Eq. 92, zeros"]
    columns = [COEFFICIENTS.index(f"{row}_delta") for row in ("Z", "M", "F1", "F2")]
    assert np.abs(conditioning.sensitivity(family)[:, columns].sum(axis=1)).max() < 1e-9


def test_map_has_a_row_for_each_root():
    with mpl.rc_context():
        fig, ax = plt.subplots()
        assert draw_sensitivities(ax, {"Eq. 41": LOOPS["Eq. 41"]}) is ax
        assert [t.get_text() for t in ax.get_yticklabels()][1] == "Eq. 41: 1.31"
        assert len(ax.get_xticklabels()) == len(COEFFICIENTS)
        values = ax.collections[0].get_array()
        assert values.shape == (4, 28)
        assert values[1].max() == pytest.approx(0.197, abs=1e-3)
        plt.close(fig)


def test_polynomials_here_are_those_of_the_systems():
    poles = rl.rate_attitude(EQS, K_A=1.8, K_C=10, K_R=0.618, gyro=60).poles()
    assert np.abs(npp.polyval(poles, figure_8(EQS))).max() < 1e-6
    assert roots(figure_8(EQS)).size == poles.size
