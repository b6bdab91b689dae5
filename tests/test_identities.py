"""What must hold for every vehicle and every gain, whatever the numbers."""

from dataclasses import replace

import control
import numpy as np
import pytest
from hypothesis import given
from numpy.polynomial import polynomial as npp
from scipy.linalg import block_diag

import rlswaim as rl
from exact import exact_roots
from systems import (
    LOOPS,
    boosters,
    closed_loop,
    gains,
    mismatch,
    poles,
    polynomial_at,
    same_poles,
    stations,
)

INPUTS = ("delta", "delta_r", "alpha_g")
OUTPUTS = ("alpha", "theta", "q1", "q2")


@pytest.fixture(scope="module", params=["data", "printed"])
def eqs(request):
    if request.param == "printed":
        return rl.printed_equations()
    return rl.perturbation_equations(rl.swaim_booster())


def around(polynomial):
    """Return points outside all roots of a polynomial [Cauchy's bound]."""
    bound = 1 + np.abs(polynomial[:-1] / polynomial[-1]).max()
    return bound * np.exp(2j * np.pi * np.arange(3) / 3.3)


# ---- the vehicle: state space against determinant


@given(booster=boosters())
def test_determinant_is_the_state_space_s_characteristic_polynomial(booster):
    eqs = rl.perturbation_equations(booster)
    p = eqs.characteristic_polynomial()
    A = eqs.state_space().A
    for s in around(p):
        wanted = np.linalg.det(s * np.eye(7) - A)
        assert npp.polyval(s, p) == pytest.approx(wanted, rel=1e-9)


@given(booster=boosters(), jet=stations)
def test_cramer_agrees_with_solving_the_state_space(booster, jet):
    eqs = rl.perturbation_equations(booster)
    system = eqs.state_space(jet)
    p = eqs.characteristic_polynomial()
    for s in around(p):
        solved = np.linalg.solve(s * np.eye(7) - system.A, system.B)
        for j, signal in enumerate(INPUTS):
            cramer = np.array([npp.polyval(s, eqs.numerator(name, signal, jet)) for name in OUTPUTS])
            wanted = solved[[0, 1, 3, 5], j]
            small = 1e-9 * np.abs(wanted).max()
            assert cramer / npp.polyval(s, p) == pytest.approx(wanted, rel=1e-7, abs=small)


@given(booster=boosters())
def test_poles_satisfy_the_characteristic_polynomial(booster):
    eqs = rl.perturbation_equations(booster)
    assert polynomial_at(eqs.characteristic_polynomial(), eqs.state_space().poles()).max() < 1e-9


@given(booster=boosters())
def test_poles_come_in_conjugate_pairs(booster):
    found = rl.perturbation_equations(booster).state_space().poles()
    assert mismatch(found, found.conj()) == 0


@given(booster=boosters())
def test_one_pole_lies_at_the_origin(booster):
    assert rl.perturbation_equations(booster).characteristic_polynomial()[0] == 0


@pytest.mark.parametrize("order", [2, 3, 4])
def test_roots_agree_with_fifty_digits(eqs, order):
    p = eqs.characteristic_polynomial(order)
    assert mismatch(npp.polyroots(p), exact_roots(p)) < 1e-9


def test_poles_agree_with_fifty_digits(eqs):
    assert mismatch(eqs.state_space().poles(), exact_roots(eqs.characteristic_polynomial())) < 1e-9


# ---- limits in which the answer is known


@given(booster=boosters())
def test_in_vacuum_without_thrust_each_mode_keeps_its_own_frequency_and_damping(booster):
    still = replace(booster, T=0.0, flight=replace(booster.flight, q_D=0.0))
    found = rl.perturbation_equations(still).state_space().poles()
    own = [root for m in still.modes for root in np.roots([1, 2 * m.zeta * m.omega, m.omega**2])]
    assert mismatch(found, [0, 0, 0, *own]) < 1e-6  # the rigid body: a triple root at the origin


@given(booster=boosters())
def test_in_vacuum_thrust_alone_leaves_the_rigid_body_neutral(booster):
    vacuum = replace(booster, flight=replace(booster.flight, q_D=0.0))
    p = rl.perturbation_equations(vacuum).characteristic_polynomial()
    c = rl.perturbation_equations(vacuum).coefficients
    mode_1 = [c["F1_q1"], c["F1_q1dot"], 1]
    mode_2 = [c["F2_q2"], c["F2_q2dot"], 1]
    through_thrust = c["F1_q2"] * c["F2_q1"]
    wanted = npp.polymul([0, 0, 0, 1], npp.polysub(npp.polymul(mode_1, mode_2), [through_thrust]))
    assert p == pytest.approx(wanted, rel=1e-9, abs=1e-12)


@given(booster=boosters())
def test_rigid_body_alone_ignores_the_modes(booster):
    stiff = replace(booster, modes=tuple(replace(m, omega=m.omega * 2) for m in booster.modes))
    rigid = [rl.perturbation_equations(b).characteristic_polynomial(2) for b in (booster, stiff)]
    assert np.array_equal(*rigid)


@given(booster=boosters())
def test_very_stiff_modes_leave_the_rigid_body_alone(booster):
    stiff = replace(booster, modes=tuple(replace(m, omega=1e5) for m in booster.modes))
    eqs = rl.perturbation_equations(stiff)
    slow = sorted(eqs.state_space().poles(), key=abs)[:3]
    assert mismatch(slow, npp.polyroots(eqs.characteristic_polynomial(2))) < 1e-3


def test_summing_the_tables_keeps_the_thrust_point():
    booster = rl.swaim_booster()
    assert booster.recomputed().thrust_station == pytest.approx(booster.thrust_station, abs=1e-9)


# ---- the control systems


@pytest.mark.parametrize("name", LOOPS)
def test_without_gains_the_loop_is_open(eqs, name):
    off = {gain: 0.0 for gain in LOOPS[name] if gain.startswith(("K_A", "K_z", "kK_z"))}
    system = closed_loop(name, eqs, **off)
    actuators = [-LOOPS[name][pole] for pole in ("K_C", "K_r") if pole in LOOPS[name]]
    assert mismatch(system.poles(), [*eqs.state_space().poles(), *actuators]) < 1e-9


@pytest.mark.parametrize("name", LOOPS)
def test_closed_loop_is_a_state_space_with_named_signals(eqs, name):
    system = closed_loop(name, eqs)
    assert isinstance(system, control.StateSpace)
    assert system.input_labels == ["theta_c", "alpha_g"]
    actuators = {"delta", "delta_r"} if name == "dual_actuation" else {"delta"}
    assert {"alpha", "theta", "q1", "q2", *actuators} <= set(system.output_labels)
    assert system.nstates == (9 if name == "dual_actuation" else 8)


@given(booster=boosters(), K_A=gains, K_C=poles, K_R=gains, sensor=stations)
def test_a_linear_sensor_without_gain_is_no_sensor(booster, K_A, K_C, K_R, sensor):
    eqs = rl.perturbation_equations(booster)
    one = rl.single_sensor(eqs, K_A=K_A, K_C=K_C, K_R=K_R, K_z=0.0, sensor=sensor)
    none = rl.rate_attitude(eqs, K_A=K_A, K_C=K_C, K_R=K_R, gyro=None)
    assert same_poles(one.A, none.A)


@given(booster=boosters(), K_A=gains, K_C=poles, K_z=gains, a=stations, b=stations)
def test_two_sensors_are_one_if_one_is_off_or_both_are_together(booster, K_A, K_C, K_z, a, b):
    eqs = rl.perturbation_equations(booster)
    loop = {"K_A": K_A, "K_C": K_C, "K_R": 0.5}
    one = rl.single_sensor(eqs, **loop, K_z=K_z, sensor=a)
    off = rl.two_sensor(eqs, **loop, K_za=K_z, K_zb=0.0, sensor_a=a, sensor_b=b)
    together = rl.two_sensor(eqs, **loop, K_za=0.25 * K_z, K_zb=0.75 * K_z, sensor_a=a, sensor_b=a)
    swapped = rl.two_sensor(eqs, **loop, K_za=0.0, K_zb=K_z, sensor_a=b, sensor_b=a)
    for other in (off, together, swapped):
        assert same_poles(other.A, one.A)


@given(booster=boosters(), K_A=gains, K_C=poles, K_r=poles, b=gains, sensor=stations, jet=stations)
def test_a_jet_without_gain_leaves_the_thrust_vector_s_loop(booster, K_A, K_C, K_r, b, sensor, jet):
    eqs = rl.perturbation_equations(booster)
    loop = {"K_A": K_A, "K_C": K_C, "K_R": 0.5}
    with_jet = rl.dual_actuation(eqs, **loop, kK_z=0.0, K_r=K_r, b=b, sensor=sensor, jet=jet)
    without = rl.rate_attitude(eqs, **loop, gyro=None)
    assert same_poles(with_jet.A, block_diag(without.A, [[-K_r]]))


@pytest.mark.parametrize("station", [27.0, 60.0, 200.5, 304.0, 400.0])
def test_total_angle_is_the_rigid_one_where_the_modes_have_no_slope(eqs, station):
    loop = {"K_A": 1.8, "K_C": 10.0, "K_R": 0.618}
    total = rl.rate_attitude(eqs, **loop, gyro=station).A
    rigid = rl.rate_attitude(eqs, **loop, gyro=None).A
    level = all(mode.slope(station) == pytest.approx(0, abs=1e-12) for mode in eqs.modes)
    assert np.allclose(total, rigid, rtol=0, atol=1e-12) == level == (station == 304.0)


@pytest.mark.parametrize("name", LOOPS)
def test_closed_loop_poles_come_in_conjugate_pairs(eqs, name):
    found = closed_loop(name, eqs).poles()
    assert mismatch(found, found.conj()) == 0


# ---- the closed loops once more, by the report's polynomials instead of the state space


def elastic(eqs, signal, weights, jet=140.0):
    """Return the sum of weight times numerator of q1 and q2 for one input."""
    return sum(w * eqs.numerator(q, signal, jet) for w, q in zip(weights, ("q1", "q2"), strict=True))


def characteristic(eqs, *terms):
    """Return the sum of products of polynomials."""
    total = np.zeros(1)
    for term in terms:
        product = np.ones(1)
        for factor in term:
            product = npp.polymul(product, np.atleast_1d(factor))
        total = npp.polyadd(total, product)
    return total


def phi(eqs, station):
    return np.array([mode.deflection(station) for mode in eqs.modes])


def sigma(eqs, station):
    return np.array([mode.slope(station) for mode in eqs.modes])


def by_equation_89(eqs, K_A, K_C, K_R, gyro):
    """Delta (s + K_C) + K_A K_C (K_R s + 1) (N_theta - sigma_1 N_q1 - sigma_2 N_q2) [Eqs. 89, 91]."""
    seen = eqs.numerator("theta", "delta") - elastic(eqs, "delta", sigma(eqs, gyro))
    return characteristic(eqs, (eqs.characteristic_polynomial(), [K_C, 1]), (K_A * K_C, [1, K_R], seen))


def by_inner_loops(eqs, K_A, K_C, K_R, sensors):
    """Delta (s + K_C) + K_C [K_A (K_R s + 1) N_theta - sum K_z (s + 1) sum phi_i N_qi] [Eq. 110]."""
    inner = [(-K_C * K_z, [1, 1], elastic(eqs, "delta", phi(eqs, at))) for K_z, at in sensors]
    outer = (K_A * K_C, [1, K_R], eqs.numerator("theta", "delta"))
    return characteristic(eqs, (eqs.characteristic_polynomial(), [K_C, 1]), outer, *inner)


def by_equation_130(eqs, K_A, K_C, K_R, kK_z, K_r, b, sensor, jet):
    """Two loops closed at once: thrust vector by theta, jet by the elastic displacement [Eqs. 120-130].

    The product of both loops takes the determinant of theta and z over delta and delta_r, which
    Delta divides; it is got here from that 2 by 2 determinant, divided out.
    """
    delta = eqs.characteristic_polynomial()
    weights = kK_z * phi(eqs, sensor)
    theta_d, theta_r = (eqs.numerator("theta", signal, jet) for signal in ("delta", "delta_r"))
    z_d, z_r = (elastic(eqs, signal, weights, jet) for signal in ("delta", "delta_r"))
    both = npp.polysub(npp.polymul(theta_d, z_r), npp.polymul(theta_r, z_d))
    start = int(np.flatnonzero(np.abs(delta) > 0)[0])
    minor, rest = npp.polydiv(npp.polytrim(both[start:]), delta[start:])
    assert np.abs(rest).max() < 1e-9 * np.abs(both).max()
    outer, valve = K_A * K_C, -K_r  # the jet obeys delta_r = +kK_z K_r/(s + K_r) (s + b) sum phi q
    law_outer, law_jet = [1, K_R], [b, 1]
    return characteristic(
        eqs,
        (delta, [K_C, 1], [K_r, 1]),
        (outer, law_outer, theta_d, [K_r, 1]),
        (valve, law_jet, z_r, [K_C, 1]),
        (outer * valve, law_outer, law_jet, minor),
    )


@given(booster=boosters(), K_A=gains, K_C=poles, K_R=gains, gyro=stations)
def test_rate_attitude_is_equation_89(booster, K_A, K_C, K_R, gyro):
    eqs = rl.perturbation_equations(booster)
    loop = {"K_A": K_A, "K_C": K_C, "K_R": K_R, "gyro": gyro}
    p = by_equation_89(eqs, **loop)
    assert polynomial_at(p, rl.rate_attitude(eqs, **loop).poles()).max() < 1e-8


ROUTES = {
    "rate_attitude": by_equation_89,
    "single_sensor": lambda eqs, K_z, sensor, **outer: by_inner_loops(eqs, **outer, sensors=[(K_z, sensor)]),
    "two_sensor": lambda eqs, K_za, K_zb, sensor_a, sensor_b, **outer: by_inner_loops(
        eqs, **outer, sensors=[(K_za, sensor_a), (K_zb, sensor_b)]
    ),
    "dual_actuation": by_equation_130,
}


@pytest.mark.parametrize("name", LOOPS)
def test_closed_loop_poles_are_the_roots_of_the_report_s_polynomial(eqs, name):
    wanted = exact_roots(ROUTES[name](eqs, **LOOPS[name]))
    assert mismatch(closed_loop(name, eqs).poles(), wanted) < 1e-7
