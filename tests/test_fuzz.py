"""Whatever is passed in: finite, conjugate roots of the polynomial, or an error that explains itself.

500 cases with ``make test``; ``make fuzz`` runs 10,000.
"""

from dataclasses import replace

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rlswaim as rl
from rlswaim.rootlocus.polynomials import horner
from systems import LOOPS, boosters, closed_loop, gains, mismatch, poles, stations

BAD = st.sampled_from([float("nan"), float("inf"), -float("inf"), 1 + 2j, "1", None, True, [1.0, 2.0], {}])
OUTSIDE = st.sampled_from([-1e-9, -1.0, 420.0000001, 1e9, float("nan"), "60", 60j, None])
STATIONS = {"gyro", "sensor", "sensor_a", "sensor_b", "jet"}


def sound(roots):
    """Roots are finite and each has its exact conjugate among them."""
    assert np.isfinite(roots).all()
    for row in np.atleast_2d(roots):
        assert sorted(zip(row.real, row.imag, strict=True)) == sorted(zip(row.real, -row.imag, strict=True))


def satisfied(locus):
    """Every root of the locus satisfies its polynomial to rounding, within the conditioning of its data."""
    p, sizes = locus.loop.polynomials(locus.gains)
    value, _, terms = horner(p, locus.roots.T, sizes)
    assert (np.abs(value) <= 1e-7 * terms).all()


# ---- the report's systems


@pytest.mark.parametrize("name", LOOPS)
@given(booster=boosters(), data=st.data())
def test_closed_loops_have_sound_poles(name, booster, data):
    drawn = {key: data.draw(stations if key in STATIONS else gains, key) for key in LOOPS[name]}
    system = closed_loop(name, rl.perturbation_equations(booster), **drawn)
    sound(system.poles())


@pytest.mark.parametrize("name", LOOPS)
@given(data=st.data())
def test_bad_numbers_are_refused(name, data):
    key = data.draw(st.sampled_from(sorted(LOOPS[name])))
    value = data.draw(OUTSIDE if key in STATIONS else BAD)
    if key == "gyro" and value is None:  # the rigid-body angle alone
        return
    with pytest.raises((ValueError, TypeError), match=rf"{key}.*got .*wanted"):
        closed_loop(name, rl.printed_equations(), **{key: value})


@given(data=st.data())
def test_bad_vehicles_are_refused(data):
    key = data.draw(st.sampled_from(["M", "I_y", "l_G", "S"]))
    value = data.draw(BAD | st.sampled_from([0.0, -1.0]))
    with pytest.raises((ValueError, TypeError), match=rf"{key}.*got .*wanted"):
        replace(rl.swaim_booster(), **{key: value})


@given(data=st.data())
def test_bad_arrays_are_refused(data):
    booster = rl.swaim_booster()
    masses = booster.masses.copy()
    kind = data.draw(
        st.sampled_from(["short", "nan", "zero", "negative", "complex", "text", "repeated station"])
    )
    at = data.draw(st.integers(0, masses.size - 1))
    change = {"nan": np.nan, "zero": 0.0, "negative": -1.0}
    if kind in change:
        masses[at] = change[kind]
        wrong = {"masses": masses}
    elif kind == "repeated station":
        wrong = {"stations": np.where(np.arange(masses.size) <= at, booster.stations[0], booster.stations)}
        if at == 0:
            return
    else:
        wrong = {"masses": {"short": masses[:at], "complex": masses * 1j, "text": masses.astype(str)}[kind]}
    with pytest.raises((ValueError, TypeError), match=r"(masses|stations).*got .*wanted"):
        replace(booster, **wrong)


@given(pole=poles)
def test_without_air_and_thrust_the_modes_are_their_own(pole):
    booster = rl.swaim_booster()
    still = replace(booster, T=0.0, flight=replace(booster.flight, q_D=0.0))
    found = rl.rate_attitude(rl.perturbation_equations(still), K_A=1, K_C=pole, K_R=1, gyro=60).poles()
    own = [-m.zeta * m.omega + 1j * m.omega * np.sqrt(1 - m.zeta**2) for m in booster.modes]
    assert mismatch(found, [0, 0, 0, -pole, *own, *np.conj(own)]) < 1e-6  # the origin is a triple root


# ---- any loop


@st.composite
def transfer_functions(draw):
    """Loops from given poles and zeros: repeated ones, integrators, cancellations, equal orders."""
    real = st.sampled_from([0.0, -1.0, -1.0, 2.0, -100.0, 1e-4]) | st.floats(-50, 50).map(
        lambda x: round(x, 3)
    )
    pair = st.tuples(real, st.sampled_from([0.1, 1.0, 3.0, 80.0]))

    def polynomial(reals, pairs):
        p = np.array([1.0])
        for x in reals:
            p = np.convolve(p, [1.0, -x])
        for x, y in pairs:
            p = np.convolve(p, [1.0, -2 * x, x * x + y * y])
        return p

    den = polynomial(draw(st.lists(real, max_size=4)), draw(st.lists(pair, max_size=3)))
    num = draw(st.sampled_from([0.0, 1.0, -2.5, 1e-6, 1e6])) * polynomial(
        draw(st.lists(real, max_size=3)), draw(st.lists(pair, max_size=2))
    )
    return num, den


@given(parts=transfer_functions(), sign=st.sampled_from([1, -1]))
def test_any_loop_is_solved_or_refused(parts, sign):
    num, den = parts
    # python-control makes the constant 0 of any system with a zero numerator: it has no poles
    if den.size == 1 or num.size > den.size or not num.any():
        with pytest.raises(ValueError, match=r"got .*wanted"):
            rl.root_locus(control.tf(num, den))
        return
    locus = rl.root_locus(control.tf(num, den), sign=sign)
    sound(locus.roots)
    satisfied(locus)
    assert (np.diff(sign * locus.gains) > 0).all()
    assert len(locus.labels) == den.size - 1


@given(
    order=st.integers(1, 30),
    seed=st.integers(0, 2**32 - 1),
    size=st.floats(-3, 3),
    given_gains=st.lists(st.floats(-1e4, 1e4), min_size=1, max_size=6),
)
def test_arrays_up_to_order_30(order, seed, size, given_gains):
    rng = np.random.default_rng(seed)
    A = rng.standard_normal((order, order)) * 10**size
    locus = rl.root_locus((A, rng.standard_normal((order, 1)), rng.standard_normal((1, order))), given_gains)
    sound(locus.roots)
    assert np.array_equal(locus.gains, given_gains)


@given(gains_=st.lists(st.floats(-1e4, 1e4), min_size=1, max_size=4), order=st.integers(1, 6))
def test_a_loop_without_gain_stands_still(gains_, order):
    A = -np.diag(np.arange(1.0, order + 1))
    for given_gains in (gains_, None):
        locus = rl.root_locus((A, np.ones((order, 1)), np.zeros((1, order))), given_gains)
        assert all(mismatch(row, np.diag(A)) < 1e-9 for row in locus.roots)


@given(data=st.data())
def test_bad_gains_are_refused(data):
    value = data.draw(
        st.sampled_from([float("nan"), float("inf"), 1j, "1", None, [[1.0]], [1.0, float("nan")], {}])
    )
    if value is None:  # gains are chosen
        return
    with pytest.raises((ValueError, TypeError), match=r"gains.*got .*wanted"):
        rl.root_locus(control.tf([1], [1, 1]), value)


@given(
    system=st.sampled_from(
        [
            1.0,
            "s",
            None,
            (1,),
            ([[1.0]], [[1.0]], [[1.0, 2.0]]),
            (np.eye(2), np.ones((2, 1)), None),
            control.ss([], np.zeros((0, 1)), np.zeros((1, 0)), [[1.0]]),
        ]
    )
)
def test_bad_systems_are_refused(system):
    with pytest.raises((ValueError, TypeError), match=r"got .*wanted"):
        rl.root_locus(system)
