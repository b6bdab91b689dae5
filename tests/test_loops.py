"""Open loops against the closed loops as state space, and what no gains can change."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.polynomial import polynomial as npp
from scipy.optimize import minimize_scalar

import rlswaim as rl
from rlswaim.edition import section_4, section_5, section_6
from rlswaim.loops import certificates, factors, gain_terms, named_branches
from rlswaim.loops import transfer_functions as tf
from rlswaim.loops.rigid_body_design import rigid_body, rigid_design
from rlswaim.rootlocus.polynomials import roots

EQS = rl.printed_equations()
STATION = st.one_of(st.none(), st.integers(0, 420).map(float))
SENSOR = st.integers(0, 420).map(float)


def gain(size):
    return st.floats(-size, size, allow_nan=False).filter(lambda x: abs(x) > 1e-3)


def same_roots(found, expected):
    """Compare root sets as polynomials, around all of them: multiple roots move too much one by one."""
    found, expected = np.asarray(found), np.asarray(expected)
    s = 2 * max(np.abs(expected).max(), 1) * np.exp(2j * np.pi * np.arange(4) / 4.3)
    ratio = np.prod((s[:, None] - found) / (s[:, None] - expected), axis=1)
    return found.shape == expected.shape and np.allclose(ratio, 1, atol=1e-8)


def closed_roots(loop, K_A):
    return rl.root_locus(loop, [K_A]).roots[0]


@given(K_A=gain(20), K_C=gain(20), K_R=gain(2), gyro=STATION)
def test_the_attitude_loop_closes_as_the_state_space_does(K_A, K_C, K_R, gyro):
    system = rl.rate_attitude(EQS, K_A=K_A, K_C=K_C, K_R=K_R, gyro=gyro)
    assert same_roots(closed_roots(tf.theta_loop(EQS, K_C, K_R, gyro), K_A), system.poles())


@given(K_A=gain(20), K_C=gain(20), K_R=gain(2), K_z=gain(0.5), sensor=SENSOR)
def test_the_outer_loop_closes_as_the_state_space_does(K_A, K_C, K_R, K_z, sensor):
    system = rl.single_sensor(EQS, K_A=K_A, K_C=K_C, K_R=K_R, K_z=K_z, sensor=sensor)
    found = closed_roots(tf.outer_loop(EQS, K_C, K_R, [(K_z, sensor)]), K_A)
    assert same_roots(found, system.poles())


@given(K_C=gain(20), K_za=gain(0.5), K_zb=gain(0.5), a=SENSOR, b=SENSOR)
def test_two_inner_loops_close_in_either_order(K_C, K_za, K_zb, a, b):
    one = tf.inner_loop(EQS, K_C, b, closed=[(K_za, a)])
    other = tf.inner_loop(EQS, K_C, a, closed=[(K_zb, b)])
    system = rl.two_sensor(EQS, K_A=0, K_C=K_C, K_R=0, K_za=K_za, K_zb=K_zb, sensor_a=a, sensor_b=b)
    assert same_roots(closed_roots(one, K_zb), closed_roots(other, K_za))
    assert same_roots(closed_roots(one, K_zb), system.poles())


@given(K_A=gain(20), K_C=gain(20), K_R=gain(2), K_z=gain(0.5), sensor=SENSOR)
def test_the_terms_in_the_gains_add_up_to_the_characteristic_polynomial(K_A, K_C, K_R, K_z, sensor):
    terms = gain_terms.gain_terms(EQS, None, [sensor])
    values = (1, K_C, K_A * K_C, K_A * K_C * K_R, K_C * K_z)
    total = sum(value * term for value, term in zip(values, terms.values(), strict=True))
    loop = tf.outer_loop(EQS, K_C, K_R, [(K_z, sensor)])
    expected = npp.polyadd(loop.den[0][0][::-1], K_A * loop.num[0][0][::-1])
    assert total == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max())


@given(real=st.floats(-3, 3), imag=st.floats(0.2, 5), K_C=st.floats(0.5, 30), gyro=STATION)
def test_gains_for_a_pole_put_it_there(real, imag, K_C, gyro):
    K_A, K_R = gain_terms.gains_for_pole(EQS, complex(real, imag), K_C, gyro)
    assume(1e-2 < abs(K_A) < 1e3 and abs(K_A * K_R) < 1e3)
    found = closed_roots(tf.theta_loop(EQS, K_C, K_R, gyro), K_A)
    assert np.abs(found - complex(real, imag)).min() < 1e-4


def test_a_real_pole_leaves_a_gain_free():
    with pytest.raises(ValueError, match="off the real axis"):
        gain_terms.gains_for_pole(EQS, 1.0, 10, 60)


def exact_certificate(terms, support):
    """Solve the weights of a certificate in rational numbers, from the floats as they are."""
    free, *others = ([Fraction(float(p[i])) for i in support] for p in terms.values())
    rows = [*others, [Fraction(1)] * len(support)]
    right = [Fraction(0)] * len(others) + [Fraction(1)]
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    for i in range(len(table)):
        pivot = next(k for k in range(i, len(table)) if table[k][i])
        table[i], table[pivot] = table[pivot], table[i]
        table[i] = [x / table[i][i] for x in table[i]]
        for k in range(len(table)):
            if k != i:
                table[k] = [x - table[k][i] * y for x, y in zip(table[k], table[i], strict=True)]
    weights = [row[-1] for row in table]
    return weights, sum(w * f for w, f in zip(weights, free, strict=True))


@pytest.mark.parametrize(
    ("gyro", "sensors"),
    [(60.0, ()), (400.0, ()), (304.0, ()), (None, ()), (None, (140.0,)), (None, (300.0, 140.0))],
    ids=["gyro 60", "gyro 400", "gyro 304", "rigid angle", "sensor 140", "sensors 300 and 140"],
)
def test_no_gains_stabilize_proved_in_rational_numbers(gyro, sensors):
    found = certificates.stability_certificate(EQS, gyro, sensors)
    support = np.flatnonzero(found.weights > 1e-12)
    weights, rest = exact_certificate(gain_terms.gain_terms(EQS, gyro, sensors), support)
    assert all(w >= 0 for w in weights)
    assert rest < 0
    assert float(rest) == pytest.approx(found.margin, rel=1e-6)


def test_a_certificate_is_not_found_for_a_loop_that_can_be_stabilized(monkeypatch):
    stable = np.array([2.0, 3.0, 1.0])  # any small gain keeps it stable
    terms = {"1": np.pad(stable, (0, 6)), "K_C": np.pad([1.0], (0, 8))}
    terms["1"][:8] = npp.polyfromroots([-1.0] * 8)[:8]
    monkeypatch.setattr(certificates, "gain_terms", lambda *_: terms)
    assert certificates.stability_certificate(EQS, None).margin > 0


@given(K_A=gain(1000), K_C=gain(100), K_R=gain(10), station=STATION)
def test_every_loop_of_section_iv_is_unstable(K_A, K_C, K_R, station):
    assert closed_roots(tf.theta_loop(EQS, K_C, K_R, station), K_A).real.max() > -1e-9


@given(station=SENSOR)
def test_the_zeros_of_a_sensor_satisfy_eq_119(station):
    phi = [mode.deflection(station) for mode in EQS.modes]
    p = phi[0] * EQS.numerator("q1", "delta") + phi[1] * EQS.numerator("q2", "delta")
    for zero in tf.sensor_zeros(EQS, [station])[0]:
        assert abs(npp.polyval(zero, p)) < 1e-7 * npp.polyval(abs(zero), np.abs(p))


@pytest.mark.parametrize("station", [30.0, 40.0, 140.0, 300.0, 410.0])
def test_the_stiffening_is_the_slope_of_the_locus(station):
    step = 1e-7
    loop, starts = (
        tf.inner_loop(EQS, 10, station),
        named_branches.open_loop_parts(EQS, 10),
    )
    after = named_branches.named_locus(loop, step, starts).ends
    for name, slope in tf.frequency_rates(EQS, 10, [station]).items():
        rise = (np.abs(after[name]).max() - np.abs(starts[name]).max()) / step
        assert rise == pytest.approx(slope[0], rel=1e-3, abs=1e-3)


@pytest.mark.parametrize(("station", "K_z"), [(40.0, 0.1), (140.0, 0.054), (300.0, -0.144)])
def test_one_sensor_stiffens_both_modes(station, K_z):
    starts = named_branches.open_loop_parts(EQS, 10)
    ends = named_branches.named_locus(tf.inner_loop(EQS, 10, station), K_z, starts).ends
    for mode in ("mode 1", "mode 2"):
        assert np.abs(ends[mode]).max() > np.abs(starts[mode]).max()


def test_both_modes_stay_stiffened_with_the_outer_loop_closed():
    starts = named_branches.open_loop_parts(EQS, 10)
    inner = named_branches.named_locus(tf.inner_loop(EQS, 10, 140), 0.054, starts)
    outer = named_branches.named_locus(tf.outer_loop(EQS, 10, 0.625, [(0.054, 140)]), 39, inner.ends)
    sizes = [np.abs(outer.ends[mode]).max() for mode in ("mode 1", "mode 2")]
    assert sizes == pytest.approx([2.583, 17.82], abs=5e-3)
    assert outer.poles.real.max() == pytest.approx(1.169, abs=5e-4)


def test_the_printed_zeros_lead_to_eq_118_and_not_to_figure_16():
    poles = rl.root_locus(section_6.printed_first_loop(), [-0.144]).roots[0]
    for printed in (-0.9, 2.8 + 2.25j, -2.55 + 6.8j, -5 + 4.3j):
        assert np.abs(poles - printed).min() < 0.03 * abs(printed) + 0.1
    loop = section_5.printed_outer_loop()
    K_A, place = section_5.nearest_gain(loop, section_4.WANTED, least=1.0, most=1e3)
    assert abs(K_A - 154.276) < 5e-4
    assert abs(place - section_4.WANTED) == pytest.approx(0.0104, abs=5e-5)
    assert f"{K_A / 4:.2g}" == "39"


def distance_to_the_wanted_place(loop, gain):
    top, bottom = loop.num[0][0], loop.den[0][0]
    return np.abs(np.roots(np.polyadd(bottom, gain * top)) - section_4.WANTED).min()


@pytest.mark.parametrize("loop", ["printed", "ours"])
def test_no_gain_comes_nearer_to_the_wanted_place(loop):
    """Beside a gain found to all its digits, each way is farther, near by and over all gains allowed."""
    printed = section_5.printed_outer_loop()
    loop = printed if loop == "printed" else tf.outer_loop(EQS, 10, 0.625, [(0.054, 140)])
    K_A, place = section_5.nearest_gain(loop, section_4.WANTED, least=0.1, most=1e4)
    best = distance_to_the_wanted_place(loop, K_A)
    assert best == pytest.approx(abs(place - section_4.WANTED), rel=1e-6)
    others = np.concatenate([K_A * (1 + np.array([-1e-2, -1e-4, 1e-4, 1e-2])), np.geomspace(0.1, 1e4, 300)])
    assert min(distance_to_the_wanted_place(loop, gain) for gain in others) >= best * (1 - 1e-9)
    found = minimize_scalar(
        lambda gain: distance_to_the_wanted_place(loop, gain),
        bounds=(0.9 * K_A, 1.1 * K_A),
        method="bounded",
        options={"xatol": 1e-9 * K_A},
    )
    assert found.x == pytest.approx(K_A, rel=1e-6)


def test_a_gain_at_its_bound_is_the_nearest_if_the_way_leads_on():
    loop = section_5.printed_outer_loop()
    assert section_5.nearest_gain(loop, section_4.WANTED, least=1.0, most=100.0)[0] == 100.0


def test_one_mode_less_is_the_smaller_determinant():
    found = section_4.closed_loop_roots(EQS, 0.0, 0.618, 60, order=3)
    assert same_roots(found, [*roots(EQS.characteristic_polynomial(3)), -10.0])


def test_factors_and_latex_give_the_loop_back():
    loop = tf.theta_loop(EQS, 10, 0.618, 60)
    again = factors.from_factors(*factors.factored(loop))
    s = np.array([0.3 + 1j, -2.0, 5j])
    assert again(s) == pytest.approx(loop(s), rel=1e-9)
    assert factors.as_latex(factors.from_factors(-2.0, [0, 1.5], [-1 + 2j])) == (
        r"\frac{-2\,s(s - 1.5)}{(s + 1 \pm j\,2)}"
    )
    assert factors.as_latex(factors.from_factors(1.23456, [], [-9.87654])) == r"\frac{1.235\,}{(s + 9.877)}"
    assert factors.as_text([-1 + 2j, -1 - 2j, 0.5]) == "0.5, −1.000 ± j2.000"


@pytest.mark.parametrize("call", [tf.theta_loop, tf.inner_loop])
def test_bad_gains_and_stations_are_refused(call):
    extra = (0.6, 60) if call is tf.theta_loop else (60,)
    with pytest.raises(ValueError, match="K_C in denominator: got nan"):
        call(EQS, float("nan"), *extra)
    with pytest.raises(ValueError, match="wanted 0 to 420 ft"):
        call(EQS, 10, *extra[:-1], 500.0)


def test_poles_have_the_names_of_the_motions_that_become_them():
    """Rigid body, first and second mode in the order of their size: Eq. 41's roots, two of them real."""
    named = named_branches.named_poles(EQS)
    by_name = {name: [pole for pole, own in named if own == name] for _, name in named}
    found = roots(EQS.characteristic_polynomial())
    first, second = sorted(found[found.imag > 0], key=abs)
    assert by_name["attitude"] == [0]
    assert sorted(p.real for p in by_name["short period"]) == pytest.approx([-1.543, 1.310], abs=5e-4)
    for name, pole in (("mode 1", first), ("mode 2", second)):
        assert by_name[name] == pytest.approx([pole, pole.conjugate()]) or by_name[name] == pytest.approx(
            [pole.conjugate(), pole]
        )


def test_a_loop_that_is_closed_with_no_gain_keeps_its_locus_over_positive_gains():
    loop, starts = tf.inner_loop(EQS, 10, 140), named_branches.open_loop_parts(EQS, 10)
    found = named_branches.named_locus(loop, 0.0, starts)
    wanted = rl.root_locus(loop)
    assert same_roots(found.locus.roots[len(wanted.gains) // 2], wanted.roots[len(wanted.gains) // 2])
    assert same_roots(found.poles, wanted.roots[0])


def test_polynomials_have_a_coefficient_for_each_of_nine_powers():
    """The vehicle's seven states and the actuator's: s^8 with the coefficient 1, which the lag alone has."""
    terms = gain_terms.gain_terms(EQS, 60.0, [140.0])
    assert {p.shape for p in terms.values()} == {(9,)}
    assert [p[8] for p in terms.values()] == pytest.approx([1, 0, 0, 0, 0], abs=1e-12)


def test_where_no_weights_cancel_the_gains_there_are_none():
    front, fins = rl.swaim_booster().surfaces
    halved = replace(front, C_Nalpha=front.C_Nalpha / 2)
    eqs = rl.perturbation_equations(replace(rl.swaim_booster(), surfaces=(halved, fins)))
    found = certificates.stability_certificate(eqs, 370.0)
    assert found.margin == np.inf
    assert found.weights.tolist() == [0] * 8


CALLS = {
    rl.rate_attitude: {"K_A": 1.8, "K_C": 10, "K_R": 0.6, "gyro": 60},
    rl.single_sensor: {"K_A": 1.8, "K_C": 10, "K_R": 0.6, "K_z": 0.1, "sensor": 60},
    rl.two_sensor: {
        **{"K_A": 1.8, "K_C": 10, "K_R": 0.6, "K_za": 0.1, "K_zb": 0.2},
        **{"sensor_a": 60, "sensor_b": 300},
    },
    rl.dual_actuation: {
        **{"K_A": 1.8, "K_C": 10, "K_R": 0.6, "kK_z": 1e4, "K_r": 10, "b": 3},
        **{"sensor": 60, "jet": 56},
    },
    rigid_design: {"omega": 2.0, "zeta": 0.5, "K_C": 10},
}


@pytest.mark.parametrize("function", CALLS, ids=lambda function: function.__name__)
def test_gains_are_given_by_name_and_never_by_place(function):
    start = rigid_body(EQS) if function is rigid_design else EQS
    function(start, **CALLS[function])
    with pytest.raises(TypeError, match="positional"):
        function(start, *CALLS[function].values())
