"""Root loci against 50-digit roots, against python-control, and against what a locus must be."""

from functools import cache

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import polynomial as npp
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from exact import count_of_marks, exact_roots, off_the_chord
from systems import closed_loop, factors, mismatch

S = control.tf("s")


@cache
def loops():
    """Open loops by name: textbook ones with known answers, and the report's of Figures 8 to 11."""
    eqs = rl.printed_equations()

    def report(K_C, K_R, gyro):
        sigma = np.zeros(2) if gyro is None else [mode.slope(gyro) for mode in eqs.modes]
        poles = npp.polymul(eqs.characteristic_polynomial(), [K_C, 1])
        numerator = eqs.numerator("theta", "delta")
        for s, q in zip(sigma, ("q1", "q2"), strict=True):
            numerator = numerator - s * eqs.numerator(q, "delta")
        zeros = K_C * npp.polymul(numerator, [1, K_R])
        return control.tf(zeros[:8][::-1], poles[::-1])

    return {
        "third order": 1 / (S * (S + 1) * (S + 2)),
        "double integrator": (S + 1) / S**2,
        "circle": (S + 2) / (S * (S + 1)),
        "complex poles": (S + 3) / (S * (S**2 + 2 * S + 5)),
        "right half plane zero": (S - 1) / ((S + 1) * (S + 4) * (S + 5)),
        "figure 8": report(10.0, 0.618, 60.0),
        "figure 9": report(10.0, -0.33, 60.0),
        "figure 10": report(0.5, 0.12, 60.0),
        "figure 11": report(1.75, -0.286, None),
    }


NAMES = list(loops())
places = factors(-5.0, 5.0).map(lambda x: round(x, 4))
GAINS = np.concatenate([[0.0], np.logspace(-4, 3, 120)])


MARKS = dict(zip(NAMES, (2, 1, 2, 1, 2, 4, 2, 3, 4), strict=True))  # at positive gains
CHANGES = dict(zip(NAMES, (1, 0, 0, 1, 2, 3, 1, 2, 2), strict=True))  # of the count of unstable roots


@pytest.fixture(params=NAMES)
def name(request):
    return request.param


@pytest.fixture
def system(name):
    return loops()[name]


def polynomial(system, gain):
    """Return the closed loop's polynomial, constant term first."""
    return npp.polyadd(system.den[0][0][::-1], gain * system.num[0][0][::-1])


# ---- values


@pytest.mark.parametrize("gain", [0.0, 1e-3, 0.7, 1.8, 60.0, -0.3, -3.14, -40.0])
def test_roots_agree_with_fifty_digits(system, gain):
    found = rl.root_locus(system, [gain]).roots[0]
    assert mismatch(found, exact_roots(polynomial(system, gain))) < 1e-9


def test_roots_agree_with_python_control(system):
    theirs = control.root_locus_map(system, gains=GAINS).loci
    ours = rl.root_locus(system, GAINS).roots
    assert max(mismatch(a, b) for a, b in zip(ours, theirs, strict=True)) < 1e-6


def test_state_space_and_transfer_function_give_the_same_locus(system):
    realized = control.ss(system)
    gains = [0.0, 0.5, 5.0]
    pairs = zip(rl.root_locus(system, gains).roots, rl.root_locus(realized, gains).roots, strict=True)
    assert max(mismatch(a, b) for a, b in pairs) < 1e-7


def test_arrays_are_a_loop_too():
    A, B, C = [[0.0, 1.0], [0.0, -3.0]], [[0.0], [1.0]], [[2.0, 0.0]]
    assert mismatch(rl.root_locus((A, B, C), [1.0]).roots[0], [-1.0, -2.0]) < 1e-12


def test_report_s_loop_is_the_report_s_system():
    """Minus the gain on the open loop of Figure 8 gives the poles of the closed loop."""
    eqs = rl.printed_equations()
    for gain in (1.8, -3.14):
        wanted = rl.rate_attitude(eqs, K_A=gain, K_C=10.0, K_R=0.618, gyro=60.0).poles()
        assert mismatch(rl.root_locus(loops()["figure 8"], [gain]).roots[0], wanted) < 1e-7


@given(
    zeros=st.lists(places, max_size=3),
    poles=st.lists(places, min_size=4, max_size=6),
    gain=factors(-50.0, 50.0),
)
def test_each_root_satisfies_its_polynomial(zeros, poles, gain):
    system = control.tf(np.atleast_1d(np.poly(zeros)), np.poly(poles))
    roots = rl.root_locus(system, [gain]).roots[0]
    p = polynomial(system, gain)
    size = np.maximum(np.abs(roots), 1.0)[:, None] ** np.arange(len(p)) @ np.abs(p)
    assert (np.abs(npp.polyval(roots, p)) / size).max() < 1e-10


# ---- order and form


def test_gains_keep_their_order_and_sign(system):
    gains = np.array([3.0, -1.0, 0.0, 0.5, -20.0, 0.5])
    locus = rl.root_locus(system, gains)
    assert np.array_equal(locus.gains, gains)
    assert locus.roots.shape == (6, len(system.den[0][0]) - 1)
    for gain, roots in zip(gains, locus.roots, strict=True):
        assert mismatch(roots, exact_roots(polynomial(system, gain))) < 1e-9


def test_roots_are_conjugate_symmetric(system):
    found = rl.root_locus(system, GAINS).roots
    assert len(found) == GAINS.size
    for roots in found:
        assert mismatch(roots, roots.conj()) < 1e-12


def test_locus_starts_at_the_poles_and_names_the_zeros(system):
    locus = rl.root_locus(system, [0.0])
    numerator = np.trim_zeros(system.num[0][0], "f")[::-1]
    assert mismatch(locus.roots[0], locus.poles) < 1e-9
    assert mismatch(locus.poles, exact_roots(system.den[0][0][::-1])) < 1e-9
    assert mismatch(locus.zeros, exact_roots(numerator)) < 1e-9


def test_locus_ends_at_the_zeros(system):
    locus = rl.root_locus(system, [1e12])
    assert locus.zeros.size == np.trim_zeros(system.num[0][0], "f").size - 1
    for zero in locus.zeros:
        assert np.abs(locus.roots[0] - zero).min() < 1e-3 * max(1.0, abs(zero))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_branches_are_continuous(system, sign):
    """On a fine grid of gains, no re-pairing of neighboring root sets is closer than the one given."""
    roots = rl.root_locus(system, sign * np.linspace(0.0, 5.0, 4001)).roots
    step = np.abs(np.diff(roots, axis=0)).sum(axis=1)
    for k in range(0, 4000, 7):
        paired = np.abs(roots[k][:, None] - roots[k + 1][None, :])
        assert step[k] <= paired[linear_sum_assignment(paired)].sum() * (1 + 1e-9) + 1e-12


# ---- gains chosen for a picture


def test_chosen_gains_include_break_aways_and_crossings(system, name):
    locus = rl.root_locus(system)
    marks = [m.gain for m in (*locus.break_aways, *locus.crossings) if m.gain > 0]
    assert len(marks) == MARKS[name]
    for gain in marks:
        assert np.abs(locus.gains - gain).min() <= 1e-12 * gain
    assert (locus.gains >= 0).all()
    assert (np.diff(locus.gains) > 0).all()


def test_drawn_polyline_stays_within_a_quarter_pixel(system):
    """Roots between neighboring gains lie on the drawn chord, on 800 by 600 pixels of the axes asked for."""
    axes = (-8.0, 4.0, -9.0, 9.0)
    locus = rl.root_locus(system, axes=axes, tolerance=0.25)
    pixel = np.array([(axes[1] - axes[0]) / 800, (axes[3] - axes[2]) / 600])
    assert len(locus.gains) < 600
    worst = 0.0
    for k in range(0, len(locus.gains) - 1, 3):
        low, high = locus.gains[k : k + 2]
        between = rl.root_locus(system, np.linspace(low, high, 9)).roots
        for a, m, b in zip(between[0], between[1:-1].T, between[-1], strict=True):
            ends = np.array([a, b])
            if ((ends.real > axes[0]) & (ends.real < axes[1]) & (np.abs(ends.imag) < axes[3])).all():
                start, middle, end = (z.real / pixel[0] + 1j * z.imag / pixel[1] for z in (a, m, b))
                worst = max(worst, *(off_the_chord(point, start, end) for point in middle))
    assert worst < 0.25


# ---- break-away points and crossings


def test_break_aways_are_double_roots(system):
    """To 50 digits, the polynomial and its derivative vanish there."""
    marks = rl.root_locus(system, [0.0]).break_aways
    assert len(marks) == count_of_marks(system)[0]
    for mark in marks:
        p = polynomial(system, mark.gain)
        size = np.abs(p).max() * max(1.0, abs(mark.point)) ** 7
        assert abs(npp.polyval(mark.point, npp.polyder(p))) < 1e-5 * size
        pair = np.sort(np.abs(exact_roots(p) - mark.point))[:2]
        assert pair.max() < 1e-3 * max(1.0, abs(mark.point))


@pytest.mark.parametrize(
    ("name", "point", "gain"),
    [
        ("third order", -1 + 1 / np.sqrt(3), 2 / (3 * np.sqrt(3))),
        ("third order", -1 - 1 / np.sqrt(3), -2 / (3 * np.sqrt(3))),
        ("double integrator", -2.0, 4.0),
        ("circle", -2 + np.sqrt(2), 3 - 2 * np.sqrt(2)),
        ("circle", -2 - np.sqrt(2), 3 + 2 * np.sqrt(2)),
    ],
)
def test_known_break_away_points(name, point, gain):
    marks = rl.root_locus(loops()[name], [0.0]).break_aways
    nearest = min(marks, key=lambda mark: abs(mark.point - point))
    assert nearest.point == pytest.approx(point, rel=1e-9)
    assert nearest.gain == pytest.approx(gain, rel=1e-9)


def test_known_crossing():
    crossing = next(c for c in rl.root_locus(loops()["third order"], [0.0]).crossings if c.omega > 0)
    assert crossing == pytest.approx((6.0, np.sqrt(2), 1), rel=1e-12)


def test_crossings_lie_on_the_axis_and_go_the_way_they_say(system):
    crossings = rl.root_locus(system, [0.0]).crossings
    assert len(crossings) == count_of_marks(system)[1]
    for gain, omega, direction in crossings:
        exact = exact_roots(polynomial(system, gain))
        assert np.abs(exact - 1j * omega).min() < 1e-8 * max(1.0, omega)
        before, after = (
            min(exact_roots(polynomial(system, gain + d)), key=lambda s: abs(s - 1j * omega)).real
            for d in (-1e-6 * abs(gain), 1e-6 * abs(gain))
        )
        assert np.sign(after - before) == direction


def test_no_crossing_is_missed(system, name):
    """Wherever the count of unstable roots changes between two gains, a crossing lies between them."""
    gains = np.linspace(-30.013, 30.007, 1501)
    marks = sorted(c.gain for c in rl.root_locus(system, [0.0]).crossings)
    counts = [(npp.polyroots(np.trim_zeros(polynomial(system, k), "b")).real > 0).sum() for k in gains]
    # Where the gain is 0 a pole on the axis leaves it: the locus's start, no crossing.
    changes = [k for k in np.flatnonzero(np.diff(counts)) if not gains[k] <= 0 <= gains[k + 1]]
    assert len(changes) == CHANGES[name]
    for k in changes:
        assert any(gains[k] <= mark <= gains[k + 1] for mark in marks)


# ---- any parameter


def test_a_gain_as_parameter_is_the_locus():
    eqs = rl.printed_equations()
    gains = np.linspace(0.0, 4.0, 41)
    swept = rl.parameter_locus(lambda k: closed_loop("rate_attitude", eqs, K_A=k), gains)
    direct = rl.root_locus(loops()["figure 8"], gains)
    assert np.array_equal(swept.gains, gains)
    assert max(mismatch(a, b) for a, b in zip(swept.roots, direct.roots, strict=True)) < 1e-7


@pytest.mark.parametrize(
    ("name", "station"),
    [
        ("rate_attitude", "gyro"),
        ("single_sensor", "sensor"),
        ("two_sensor", "sensor_b"),
        ("dual_actuation", "jet"),
    ],
)
def test_a_station_as_parameter(name, station):
    eqs = rl.printed_equations()
    stations = np.arange(0.0, 421.0, 4.0)
    locus = rl.parameter_locus(lambda x: closed_loop(name, eqs, **{station: x}), stations)
    for x, roots in zip(stations[::15], locus.roots[::15], strict=True):
        assert mismatch(roots, closed_loop(name, eqs, **{station: x}).poles()) < 1e-12
    jumps = np.abs(np.diff(locus.roots, axis=0))
    for k in range(0, len(jumps), 5):
        paired = np.abs(locus.roots[k][:, None] - locus.roots[k + 1][None, :])
        assert jumps[k].sum() <= paired[linear_sum_assignment(paired)].sum() * (1 + 1e-9) + 1e-12


def test_one_value_is_a_locus_too():
    locus = rl.parameter_locus(loops()["circle"].feedback, 2.0)
    assert locus.roots.shape == (1, 2)


# ---- accuracy at a double root


def test_a_double_root_is_as_good_as_double_precision_allows():
    """(s + 1)^2 moves as the square root of the rounding: 1e-8, no worse."""
    found = rl.root_locus(loops()["double integrator"], [4.0]).roots[0]
    assert mismatch(found, [-2.0, -2.0]) < 1e-7
