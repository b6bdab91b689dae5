"""Limits of performance against closed forms, the numerators of Cramer's rule, and loops that reach them."""

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlswaim as rl
from rlswaim.practice import limits
from rlswaim.practice import measurements as m
from rlswaim.practice.greensite import closed_loop, greensite
from rlswaim.practice.margins import frequency_response, margins

EQS = rl.printed_equations()


def numerator(gyro):
    """Return the numerator of the angle that a gyro reads over delta, constant term first."""
    total = EQS.numerator("theta", "delta").copy()
    if gyro is not None:
        for i, mode in enumerate(EQS.modes, start=1):
            total -= mode.slope(gyro) * EQS.numerator(f"q{i}", "delta")
    return total


@pytest.mark.parametrize(
    ("gyro", "said", "within"),
    [(None, 15.25, 0.005), (60.0, 22.3, 0.05), (420.0, 3.2, 0.05), (135.0, 1700, 50)],
)
def test_bounds_that_are_said(gyro, said, within):
    assert abs(limits.limits(m.attitude(EQS, gyro)).peak - said) <= within


@pytest.mark.parametrize("gyro", [None, 0.0, 60.0, 135.0, 210.0, 304.0, 400.0, 420.0])
def test_zeros_and_bound_are_those_of_cramers_rule(gyro):
    found = limits.limits(m.attitude(EQS, gyro))
    zeros = np.polynomial.polynomial.polyroots(np.trim_zeros(numerator(gyro), "b"))
    poles = np.polynomial.polynomial.polyroots(EQS.characteristic_polynomial())
    zeros, (pole,) = zeros[zeros.real > limits.AXIS], poles[poles.real > limits.AXIS].real
    assert len(zeros) == len(found.zeros)
    apart = np.abs(np.subtract.outer(np.array(found.zeros), zeros))
    assert np.all(apart.min(axis=0) < 1e-6 * np.abs(zeros))
    assert np.all(apart.min(axis=1) < 1e-6 * np.abs(found.zeros))
    assert found.peak == pytest.approx(float(limits.blaschke(zeros, pole)), rel=1e-5)
    assert found.poles == (pytest.approx(pole),)
    assert found.log_integral == pytest.approx(np.pi * pole)


def test_map_over_the_stations():
    found = [one.peak for one in m.limits_along(EQS, "gyro", [60.0, 135.0, 420.0])]
    assert found == pytest.approx([22.2667, 1697.09, 3.17049], rel=1e-5)
    assert [one.stable_controller for one in m.limits_along(EQS, "gyro", [133.0, 134.0])] == [True, False]
    (sensor,) = m.limits_along(EQS, "linear sensor", [140.0])
    assert sensor.peak == pytest.approx(83.16, abs=0.01)


@pytest.mark.parametrize("gyros", [{60.0: 0.5, 420.0: 0.5}, {360.0: 1.4, 60.0: -0.4}], ids=str)
@pytest.mark.parametrize("gravity", [False, True])
def test_blends_are_those_of_cramers_rule(gyros, gravity):
    """Of two poles the least peak of T with T(p) = 1 and T(z) = 0 [Nevanlinna, Pick], from the numerators."""
    eqs = rl.printed_equations(gravity=gravity)
    total = eqs.numerator("theta", "delta").copy()
    for i, mode in enumerate(eqs.modes, start=1):
        slope = sum(weight * mode.slope(at) for at, weight in gyros.items())
        total -= slope * eqs.numerator(f"q{i}", "delta")
    roots = [
        np.polynomial.polynomial.polyroots(np.trim_zeros(p, "b"))
        for p in (total, eqs.characteristic_polynomial())
    ]
    zeros, poles = (r[r.real > limits.AXIS] for r in roots)
    p = poles.real
    w = np.array([np.prod((one + zeros.conj()) / (one - zeros)).real for one in p])
    gram = 1 / np.add.outer(p, p)
    largest = np.linalg.eigvals(np.linalg.solve(gram, np.outer(w, w) * gram)).real.max()
    found = limits.limits(m.blended(eqs, gyros))
    assert found.peak == pytest.approx(np.sqrt(largest), rel=1e-4)


POSITIVE = st.floats(0.1, 10.0)


@settings(max_examples=50, deadline=None)
@given(pole=POSITIVE, zeros=st.lists(POSITIVE, min_size=1, max_size=4), pair=st.booleans())
def test_bound_of_one_pole_is_blaschkes_product(pole, zeros, pair):
    zeros = [complex(z) for z in zeros] + ([2 + 3j, 2 - 3j] if pair else [])
    gaps = [abs(a - b) for i, a in enumerate([*zeros, pole]) for b in [*zeros, pole][:i]]
    if min(gaps) < 0.2:
        return
    one = np.ones(1)
    found = limits.peak_bound([limits.Directed(z, one) for z in zeros], [limits.Directed(pole, one)])
    assert found == pytest.approx(float(limits.blaschke(zeros, pole)), rel=1e-4)


@pytest.mark.parametrize(("p", "z"), [(1.0, 3.0), (2.0, 0.5), (1.30967, 1.14848)])
def test_a_gain_reaches_the_bound(p, z):
    """k (s - z)/(s - p) with k = -2 p/(p + z): S is the bound times an all-pass."""
    k = -2 * p / (p + z)
    loop = control.ss([[p]], [[1.0]], [[k * (p - z)]], [[k]])
    omega = np.geomspace(1e-3, 1e3, 50)
    S = 1 / (1 + frequency_response(loop, omega)[:, 0, 0])
    one = np.ones(1)
    assert np.allclose(np.abs(S), limits.peak_bound([limits.Directed(z, one)], [limits.Directed(p, one)]))
    assert control.feedback(loop, 1).poles().real.max() < 0


def test_no_loop_of_the_rigid_angle_is_below_its_bound():
    plant = m.attitude(EQS, None)
    bound = limits.limits(plant).peak
    for weight in (1e-4, 1e-2, 1.0):
        K = control.lqr(plant.A, plant.B, plant.C.T @ plant.C + 1e-6 * np.eye(7), [[weight]])[0]
        F = control.lqe(plant.A, np.eye(7), plant.C, np.eye(7), [[weight]])[0]
        controller = control.ss(plant.A - plant.B @ K - F @ plant.C, F, K, [[0.0]])
        loop = control.series(controller, control.ss(plant.A, plant.B, plant.C, plant.D))
        assert control.feedback(loop, 1).poles().real.max() < 0
        assert margins(loop).peak_sensitivity >= bound * (1 - 1e-6)
        assert controller.poles().real.max() > 0  # no stable controller can do it


def test_parity():
    assert limits.interlaced([], [1.0])
    assert limits.interlaced([2.0], [1.0])
    assert not limits.interlaced([1.0], [2.0])
    assert limits.interlaced([1.0], [2.0, 3.0])
    assert not limits.interlaced([1.0, 3.0], [2.0])
    assert limits.interlaced([1 + 1j, 1 - 1j], [2.0])
    assert limits.limits(m.attitude(EQS, None)).stable_controller is False
    assert limits.limits(m.attitude(EQS, 60.0)).stable_controller is True


def test_directions_of_zeros_and_poles():
    plant = m.measured(EQS, [{"theta": 1.0}, m.displacement(EQS, 300.0)], ["delta", "delta_r"], 140.0)
    zeros, poles = limits.output_zeros(plant), limits.output_poles(plant)
    assert len(zeros) == len(poles) == 1
    for value, direction in zeros:
        response = plant(value)
        assert np.linalg.norm(direction.conj() @ response / np.linalg.norm(response, axis=0)) < 1e-6
    for value, direction in poles:
        largest = np.linalg.svd(plant(value + 1e-7))[0][:, 0]
        assert abs(abs(direction.conj() @ largest) - 1) < 1e-6


def test_loops_beside_each_other_keep_their_own_bound():
    one = control.ss(control.zpk([3], [1, -2], 1))
    both = control.append(one, control.ss(control.zpk([], [-1, -2], 1)))
    assert limits.limits(both).peak == pytest.approx(2.0)
    assert limits.limits(both).stable_controller is None
    turned = control.ss(both.A, both.B, np.array([[0.6, -0.8], [0.8, 0.6]]) @ both.C, both.D)
    assert limits.limits(turned).peak == pytest.approx(2.0)


def test_two_sensors_on_one_effector_have_no_zero():
    plant = m.measured(EQS, [m.displacement(EQS, 140.0), m.displacement(EQS, 300.0)], ["delta"])
    found = limits.limits(plant)
    assert found.zeros == ()
    assert found.peak == 1.0
    with pytest.raises(ValueError, match="plant in output_zeros: got 1 inputs, 2 outputs, wanted as many"):
        limits.output_zeros(plant)


def test_integral_of_the_logarithm():
    """Of a loop that is stable when closed; its plant has one unstable pole and falls as 1/s^2 at least."""
    loop = greensite(K_p=1.73, K_d=0.69)
    assert closed_loop(K_p=1.73, K_d=0.69).poles().real.max() < 0
    omega = np.unique(np.concatenate([np.geomspace(1e-6, 1e5, 60_001), np.linspace(18, 20, 4001)]))
    S = 1 / (1 + frequency_response(loop, omega)[:, 0, 0])
    integral = np.trapezoid(np.log(np.abs(S)), omega)
    poles = loop.poles()
    assert integral == pytest.approx(np.pi * poles[poles.real > 0].real.sum(), rel=2e-3)


def test_available_bandwidth():
    assert limits.least_peak_over_band(np.pi * 1.5, 3.0) == pytest.approx(np.exp(np.pi / 2))
    assert limits.least_peak_over_band(1.0, 3.0, tail=2.0) == 1.0
    with pytest.raises(ValueError, match="bandwidth in least_peak_over_band: got 0"):
        limits.least_peak_over_band(1.0, 0.0)


def test_peak_with_a_band_is_reached_by_a_step_in_the_sensitivity():
    """Poisson: pi ln B = integral of ln|S| 2 z/(z^2 + w^2); S may be epsilon in the band, M outside."""
    z, p, low, epsilon = 2.0, [0.7], 0.5, 0.1
    peak = limits.least_peak_with_band(z, p, low, epsilon)
    weight = 2 * np.arctan(low / z)
    assert weight * np.log(epsilon) + (np.pi - weight) * np.log(peak) == pytest.approx(
        np.pi * np.log((z + p[0]) / (z - p[0]))
    )


def test_refused():
    with pytest.raises(TypeError, match="plant in limits: got TransferFunction"):
        limits.limits(control.tf([1], [1, -1]))
