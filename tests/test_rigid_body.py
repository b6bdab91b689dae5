"""The rigid-body design of Section IV, with and without the division by U."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rlswaim as rl
from rlswaim.loops.rigid_body_design import RigidBody, rigid_body, rigid_design
from rlswaim.loops.transfer_functions import theta_loop

EQS = rl.printed_equations()


def numbers(low, high):
    return st.floats(low, high, allow_nan=False, allow_infinity=False)


@given(omega=numbers(0.8, 3), zeta=numbers(0.1, 0.9), K_C=numbers(9, 40))
def test_the_design_puts_the_short_period_where_it_is_wanted(omega, zeta, K_C):
    gains = rigid_design(rigid_body(EQS), omega=omega, zeta=zeta, K_C=K_C)
    roots = rl.root_locus(theta_loop(EQS, K_C, gains.K_R, None, order=2), [gains.K_A]).roots[0]
    wanted = omega * complex(-zeta, np.sqrt(1 - zeta**2))
    for root in (wanted, -gains.a, -gains.b):
        assert np.abs(roots - root).min() < 1e-7 * max(1, abs(gains.a))


def test_leaving_out_the_division_changes_the_amplifier_gain_alone_and_by_U():
    wrong = rigid_design(rigid_body(EQS, divided=False), omega=2, zeta=0.5, K_C=10)
    right = rigid_design(rigid_body(EQS), omega=2, zeta=0.5, K_C=10)
    assert abs(right.K_A / wrong.K_A - EQS.U) < 1e-6
    assert (right.K_R, right.a, right.b) == pytest.approx((wrong.K_R, wrong.a, wrong.b))
    assert abs(wrong.K_A - 0.0016) < 5e-5
    assert abs(right.K_A - 2.99) < 0.005


def test_the_undivided_terms_are_the_printed_1940_and_44_53():
    body = rigid_body(EQS, divided=False)
    assert body.g_1 == pytest.approx(1940, rel=2e-3)
    assert body.g_0 == pytest.approx(44.53, rel=1e-3)


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"omega": 0.0}, ValueError, "omega in rigid_design: got 0"),
        ({"K_C": float("nan")}, ValueError, "K_C in rigid_design: got nan"),
        ({"zeta": "half"}, TypeError, "zeta in rigid_design: got 'half'"),
    ],
)
def test_bad_wishes_are_refused_by_name(change, error, words):
    with pytest.raises(error, match=words):
        rigid_design(rigid_body(EQS), **({"omega": 2.0, "zeta": 0.5, "K_C": 10.0} | change))


def test_a_pair_in_place_of_two_real_roots_is_refused():
    body = RigidBody(c_0=-3.4, c_1=1.9, g_0=4.8, g_1=2.2)
    with pytest.raises(ValueError, match="wanted real roots"):
        rigid_design(body, omega=1.6, zeta=0.5, K_C=6.5)


@pytest.mark.parametrize(("ratio", "real"), [(3.5, False), (4.5, True)])
def test_the_two_other_roots_are_refused_where_they_turn_complex(ratio, real):
    """A body is put together whose a + b and a b are given: complex if (a + b)^2 is below 4 a b."""
    product, total, c_0 = 1.0, np.sqrt(ratio), 2.0  # with omega = 1, zeta = 1/2, c_1 = 0, g_0 = 1
    K_C, x = total + 1, product
    s2, s1 = 1 + total + product, total + product  # of (s^2 + s + 1)(s^2 + total s + product)
    g_1 = np.roots([x, -(s1 - c_0 * K_C), s2 - c_0])[0].real
    body = RigidBody(c_0=c_0, c_1=0.0, g_0=1.0, g_1=g_1)
    if real:
        found = rigid_design(body, omega=1.0, zeta=0.5, K_C=K_C)
        assert (found.a + found.b, found.a * found.b) == pytest.approx((total, product))
    else:
        with pytest.raises(ValueError, match="wanted real roots"):
            rigid_design(body, omega=1.0, zeta=0.5, K_C=K_C)
