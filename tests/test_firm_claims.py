"""Proofs of Sections IV to VI with gravity and without, and with their last digits moved."""

from functools import cache

import mpmath
import numpy as np
import pytest

import rlswaim as rl
from exact import exact_roots
from rlswaim.edition import conclusions, firm_claims
from rlswaim.edition.firm_claims import CLAIMS
from rlswaim.edition.search import winners
from rlswaim.edition.slow_roots import abscissas, slow_bound
from rlswaim.loops import certificates, closed_loops
from rlswaim.loops.closed_loops import LOOPS
from rlswaim.rootlocus.exact_polynomials import exact_characteristic_polynomial
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.equations import printed_coefficients

PLAIN, WITH = rl.printed_equations(), rl.printed_equations(gravity=True)
SPARSE = (*map(float, range(0, 421, 7)), 139.0, 141.0)


@cache
def judged(claim, gravity):
    return firm_claims.judged(claim, gravity, None if claim.startswith("VI") else SPARSE)


def test_gravity_moves_the_pole_at_the_origin_to_the_right():
    assert roots(PLAIN.characteristic_polynomial()).real.max() == pytest.approx(1.3097, abs=1e-4)
    slow, fast = np.sort(roots(WITH.characteristic_polynomial()).real)[-2:]
    assert slow == pytest.approx(0.0118, abs=5e-5)
    assert fast == pytest.approx(1.3072, abs=5e-5)


@pytest.mark.parametrize(("objective", "least"), [("apart", 0.05), ("pair-apart", 0.08)])
def test_gravity_makes_the_slow_root_of_one_sensor_too_fast_to_be_set_apart(objective, least):
    """The stored winners of Section V rest on a root that gravity moves by far more than its size."""
    gains = next(w.gains for w in winners() if (w.system, w.objective) == ("single_sensor", objective))
    slow, moved = (LOOPS["single_sensor"].around(e).abscissas(**gains) for e in (PLAIN, WITH))
    assert 0 < slow < 1e-3
    assert least < moved < 0.1
    assert (
        abscissas(np.linalg.eigvals(LOOPS["single_sensor"].around(WITH).matrices(**gains))[None], True)
        == moved
    )


@pytest.mark.parametrize("claim", CLAIMS)
def test_with_gravity_every_claim_is_firm(claim):
    found = judged(claim, True)
    assert found.firm
    assert found.ruled_out == found.stations
    assert 0.9 * found.holds_by < found.last_digits <= found.holds_by


@pytest.mark.parametrize(
    ("claim", "proved", "firm"),
    [
        ("IV: no gains stabilize", True, True),
        ("IV: no gains leave only a slow root", True, True),
        ("V: no gains stabilize", True, False),
        ("V: no gains leave only a slow root", False, False),
        ("VI: no gains stabilize", True, False),
        ("VI: no gains leave only a slow root", False, False),
    ],
)
def test_without_gravity_the_theorems_of_v_and_vi_hang_on_a_last_digit(claim, proved, firm):
    found = judged(claim, False)
    assert (found.ruled_out == found.stations) == proved
    assert found.firm == firm
    if claim.endswith("stabilize") and not firm:
        assert 0 < found.holds_by < 1.0e-3


def test_one_coefficient_within_its_last_digit_ends_the_theorem_without_gravity():
    """The report prints M_q1 = -.087."""
    near = {"M_q1": (-0.0873 + 0.087) / 0.001}
    assert printed_coefficients()["M_q1"] == "-.087"
    assert firm_claims.moved(PLAIN, near).coefficients["M_q1"] == pytest.approx(-0.0873)
    both = [
        certificates.stability_certificate(firm_claims.moved(eqs, near), None, firm_claims.ANY_PAIR).margin
        for eqs in (PLAIN, WITH)
    ]
    assert both[0] == np.inf
    assert both[1] == pytest.approx(-0.096, abs=5e-4)


@pytest.mark.parametrize("gravity", [False, True])
def test_two_sensors_in_general_position_stand_for_every_pair(gravity):
    eqs = rl.printed_equations(gravity)
    pairs = [(0.0, 420.0), (56.0, 207.0), firm_claims.ANY_PAIR]
    margins = [certificates.stability_certificate(eqs, None, pair).margin for pair in pairs]
    assert margins == pytest.approx([margins[0]] * 3, rel=1e-6)


def test_at_station_140_the_reports_own_reading_is_not_ruled_out():
    """With phi = 1.6 and 5.4 some gains may leave only a slow root; with our 1.5895 and 5.3970, none."""
    own = [mode.deflection(140.0) for mode in PLAIN.modes]
    assert own == pytest.approx([1.5895, 5.3970], abs=5e-5)
    assert firm_claims.at_reading(140.0, own)[1] == pytest.approx(0.0083, abs=5e-5)
    stable, but_slow = firm_claims.at_reading(140.0, (1.6, 5.4))
    assert 0 < stable < 1e-3
    assert but_slow == pytest.approx(0, abs=firm_claims.PROVED)
    assert min(firm_claims.at_reading(140.0, (1.6, 5.4), gravity=True)) > 0.1


JETS = {
    "modest_jet-all": (-1.6285, -1.0799),
    "modest_jet-apart": (0.00909, 0.00847),
    "modest_jet-pair-all": (-1.0000, -1.0031),
    "modest_jet-pair-apart": (0.00050, 0.00458),
    "dual_actuation-all": (-4.0269, -1.2500),
    "dual_actuation-apart": (0.00592, 0.01763),
    "dual_actuation-pair-all": (-1.0000, -1.0231),
    "dual_actuation-pair-apart": (-0.00395, -0.00349),
    "figure_25-all": (-0.9605, -0.7349),
    "figure_25-apart": (-0.9605, -0.7349),
    "figure_25-pair-all": (-0.6185, -0.6234),
    "figure_25-pair-apart": (-0.6185, -0.6234),
}
"""Rightmost roots (1/s) of Section VII's winners without the weight and with it."""


@cache
def rightmost(name, gravity):
    """Return the largest real part (1/s) of a winner's roots: exact polynomial, roots to 60 digits."""
    won = next(w for w in winners() if f"{w.system}-{w.objective}" == name)
    A = closed_loops.state_space(WITH if gravity else PLAIN, won.system, won.gains).A
    with mpmath.workdps(60):
        p = [mpmath.mpf(c.numerator) / c.denominator for c in exact_characteristic_polynomial(A)]
    return exact_roots(p).real.max()


@pytest.mark.parametrize("name", JETS)
def test_the_weight_moves_the_rightmost_root_of_each_loop_with_a_jet_so_far(name):
    plain, heavy = (rightmost(name, gravity) for gravity in (False, True))
    assert plain == pytest.approx(JETS[name][0], abs=5.1e-5)
    assert heavy == pytest.approx(JETS[name][1], abs=5.1e-5)
    assert heavy < 0 or plain > 0
    assert (heavy > slow_bound()) == (name == "dual_actuation-apart")


@pytest.mark.parametrize("name", JETS)
def test_floats_find_the_rightmost_root_with_the_weight(name):
    """Chapter VIII prints three decimals of what floats find."""
    won = next(w for w in winners() if f"{w.system}-{w.objective}" == name)
    poles = closed_loops.state_space(WITH, won.system, won.gains).poles()
    assert max(poles.real) == pytest.approx(rightmost(name, True), abs=1e-5)


def test_each_loop_with_a_jet_is_looked_at():
    found = {f"{w.system}-{w.objective}" for w in winners() if LOOPS[w.system] is LOOPS["dual_actuation"]}
    assert found == set(JETS)


def test_the_loop_made_by_hand_keeps_all_roots_left_of_the_axis_with_the_weight():
    for eqs, slow in ((PLAIN, -0.00115), (WITH, -0.00085)):
        poles = np.sort(conclusions.closed_loop(eqs, "dual_actuation").poles().real)
        assert poles[-1] == pytest.approx(slow, abs=5e-6)
        assert poles[-2] < -0.17
