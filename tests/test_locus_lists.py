"""Poles, zeros, break-aways and crossings beside a locus: kinds of loops that are hard, and completeness."""

from itertools import pairwise

import control
import mpmath
import numpy as np
import pytest
from scipy.signal import ZerosPolesGain

import rlswaim as rl
from exact import exact_roots, relative_errors
from rlswaim.edition.printed_closures import final_design
from rlswaim.loops.closures import closure_1_open_loop
from rlswaim.loops.transfer_functions import inner_loop
from systems import mismatch

S = control.tf("s")
Z = control.tf([1, 0], [1], True)


def diagonal(n):
    """Return poles -1 to -n as a state space whose locus has real and simple roots at gains from 0 up."""
    return -np.diag(np.arange(1.0, n + 1)), np.ones((n, 1)), np.ones((1, n))


def gains_of(marks):
    return [mark.gain for mark in marks]


def exact_break_aways(numerator, denominator):
    """Return gains and points of N D' - D N' = 0 with real gains, to 60 digits; constant terms first."""
    with mpmath.workdps(80):
        N, D = ([mpmath.mpf(float(c)) for c in p] for p in (numerator, denominator))

        def slope(p):
            return [i * c for i, c in enumerate(p)][1:]

        def value(p, s):
            return sum(c * s**i for i, c in enumerate(p))

        def product(p, q):
            total = [mpmath.mpf(0)] * (len(p) + len(q) - 1)
            for i, a in enumerate(p):
                for j, b in enumerate(q):
                    total[i + j] += a * b
            return total

        left, right = product(N, slope(D)), product(D, slope(N)) if len(N) > 1 else []
        q = [a - (right[i] if i < len(right) else 0) for i, a in enumerate(left)]
        while q[-1] == 0:
            q.pop()
        points = mpmath.polyroots(q, asc=True, maxsteps=2000, extraprec=600)
        pairs = [(-value(D, s) / value(N, s), s) for s in points if s.imag >= -(mpmath.mpf(10) ** -40)]
        real = [(k.real, s) for k, s in pairs if abs(k.imag) <= mpmath.mpf(10) ** -30 * abs(k)]
        return sorted(((float(k), complex(s)) for k, s in real), key=lambda pair: pair[0])


# ---- state space and high order


@pytest.mark.parametrize("order", [12, 20])
def test_a_diagonal_state_space_keeps_its_poles(order):
    locus = rl.root_locus(diagonal(order))
    assert relative_errors(locus.poles, np.diag(diagonal(order)[0]).astype(complex)).max() < 1e-15
    assert locus.break_aways == ()
    assert (locus.gains >= 0).sum() > 20
    assert (locus.roots[locus.gains >= 0].imag == 0).all()


def test_a_matrix_in_other_coordinates_keeps_them_too():
    """An orthogonal change of coordinates makes A full; rounding of A moves the poles by some 1e-15."""
    A, B, C = diagonal(20)
    Q = np.linalg.qr(np.random.default_rng(3).standard_normal((20, 20)))[0]
    locus = rl.root_locus((Q @ A @ Q.T, Q @ B, C @ Q.T), [0.0])
    assert relative_errors(locus.poles, np.diag(A).astype(complex)).max() < 1e-12
    assert locus.break_aways == ()


@pytest.mark.parametrize("order", [10, 20])
def test_simple_poles_of_high_order_are_not_swallowed(order):
    """1/((s + 1)...(s + n)): one break-away between each two poles; as polynomial, as factors, as matrix."""
    poles = -np.arange(1.0, order + 1)
    D = np.poly(poles)
    wanted = exact_break_aways([1.0], D[::-1])
    assert len(wanted) == order - 1
    found = rl.root_locus(control.tf([1], D), [0.0]).break_aways
    assert gains_of(found) == pytest.approx([k for k, _ in wanted], rel=1e-9)
    places = sorted(s.real for _, s in wanted)
    assert sorted(b.point.real for b in found) == pytest.approx(places, rel=1e-9)
    factors = rl.root_locus(([], poles, 1.0), [0.0]).break_aways
    middle = np.prod(poles[:, None] - [b.point.real for b in factors], axis=0) * -((-1) ** order)
    assert gains_of(factors) == pytest.approx(middle, rel=1e-12)
    assert len(factors) == order - 1
    if order == 20:
        assert (found[0].gain, found[-1].gain) == pytest.approx((-8.035e14, 1.183e16), rel=1e-3)


# ---- common factors


@pytest.mark.parametrize(
    "loop",
    [
        S / (S * (S + 1) * (S + 2)),
        (S + 5) / ((S + 5) * (S + 1) * (S + 2)),
        (S**2 + 2 * S + 5) / ((S**2 + 2 * S + 5) * (S + 1) * (S + 2)),
        (S + 0.3) ** 2 / ((S + 0.3) ** 2 * (S + 1) * (S + 2)),
        control.ss(np.diag([-1.0, -2, -7]), [[1.0], [1], [1]], [[1.0, -1, 0]], 0),
    ],
    ids=["origin", "real", "pair", "double", "unobservable"],
)
def test_a_common_factor_stands_still_and_meets_nothing(loop):
    locus = rl.root_locus(loop)
    assert [(b.gain, b.point) for b in locus.break_aways] == [pytest.approx((0.25, -1.5), rel=1e-9)]
    still = (locus.roots == locus.roots[0]).all(axis=0)
    assert still.sum() == locus.roots.shape[1] - 2
    assert [c.omega for c in locus.crossings] == [0]


def test_the_report_s_own_cancellations_make_no_break_away():
    """The attitude angle is a common factor s of the report's inner loops."""
    eqs = rl.printed_equations()
    loops = (inner_loop(eqs, 10, 140), closure_1_open_loop(eqs, final_design()[0]))
    for loop, count in zip(loops, (1, 3), strict=True):
        locus = rl.root_locus(loop)
        assert len(locus.break_aways) == count
        assert (0.0 + 0j) in locus.zeros
        assert all(abs(b.point) > 1e-9 for b in locus.break_aways)


# ---- the border of stability


@pytest.mark.parametrize(
    ("loop", "through_origin"),
    [
        ((S + 1) / ((S**2 + 0.49) * (S**2 + 9.61) * (S + 2)), [-2 * 0.49 * 9.61]),
        (1 / (S * (S**2 + 0.3) * (S**2 + 7.7) * (S + 2)), []),
        (1 / (S**2 + 4), []),
        (1 / (S**2 * (S + 1)), []),
    ],
    ids=["two pairs", "origin too", "undamped", "double integrator"],
)
def test_poles_on_the_axis_leave_at_gain_zero_and_are_no_crossing(loop, through_origin):
    found = rl.root_locus(loop).crossings
    assert [(c.gain, c.omega) for c in found] == [pytest.approx((gain, 0)) for gain in through_origin]


def test_branches_along_the_axis_do_not_cross_it():
    assert rl.root_locus(1 / (S**2 - 1)).crossings == ()
    assert rl.root_locus(1 / S**2).crossings == ()


def test_a_near_cancellation_at_the_axis():
    """Zeros at 1e-8 +- 5j on poles at +- 5j: besides the pair's own crossing the true ones, to ten digits."""
    loop = ((S - 1e-8) ** 2 + 25) / ((S**2 + 25) * (S + 1) * (S + 2) * (S + 3))
    found = rl.root_locus(loop).crossings
    assert [c.omega for c in found] == pytest.approx([0.0, np.sqrt(11), 5.0], rel=1e-7)
    assert gains_of(found) == pytest.approx([-6.0, 60.0, 144.0], rel=1e-7)
    for gain, omega, direction in found:
        N, D = loop.num[0][0], loop.den[0][0]
        sides = [exact_roots(np.polyadd(D, gain * (1 + d) * N)[::-1]) for d in (-1e-5, 1e-5)]
        real = [side[np.abs(side - 1j * omega).argmin()].real for side in sides]
        assert np.sign(gain) * np.sign(real[1] - real[0]) == direction


def test_a_crossing_that_rounding_of_the_data_moves_at_will_is_left_out():
    """Poles within rounding of the axis: their branches would cross at gains of the size of the rounding."""
    D = np.polymul([1, 2e-17, 4.0], [1, 3.0])
    assert gains_of(rl.root_locus(control.tf([1], D)).crossings) == pytest.approx([-12])


# ---- repeated poles and zeros


@pytest.mark.parametrize(
    ("place", "count"), [(-1.0, 3), (0.1, 6), (-0.3, 5), (1.0, 6), (-7.7, 4), (-1 / 3, 2), (2.0, 8)]
)
def test_repeated_poles_are_one_cluster(place, count):
    """Whatever the coefficients round to, the poles are equal and real, and one break-away at gain 0."""
    locus = rl.root_locus(control.tf([1], np.poly([place] * count)))
    assert (locus.poles == locus.poles[0]).all()
    assert locus.poles[0] == pytest.approx(place, rel=1e-14)
    assert [(b.gain, b.point) for b in locus.break_aways] == [(0.0, locus.poles[0])]


def test_repeated_pairs_and_zeros():
    pair = S**2 + 2 * S + 5
    locus = rl.root_locus((S + 0.7) ** 3 / (pair**2 * (S + 3)))
    assert mismatch(locus.poles, [-3, -1 + 2j, -1 + 2j, -1 - 2j, -1 - 2j]) < 1e-14
    assert np.unique(locus.poles).size == 3
    assert mismatch(locus.zeros, [-0.7] * 3) < 1e-14


def test_factors_stay_factors():
    """As ZerosPolesGain or as (zeros, poles, gain) nothing is multiplied out; other forms lose them."""
    zeros, poles = [-0.3], [-0.1] * 5 + [-2 + 1j, -2 - 1j]
    for system in (ZerosPolesGain(zeros, poles, 2.0), (zeros, poles, 2.0)):
        locus = rl.root_locus(system)
        assert sorted(locus.poles.tolist(), key=abs) == sorted(map(complex, poles), key=abs)
        assert locus.zeros.tolist() == zeros
    assert rl.root_locus(ZerosPolesGain([], [0.5, 0.5], 1.0, dt=0.1)).discrete


def test_close_simple_poles_are_not_made_one():
    locus = rl.root_locus(1 / ((S + 1) * (S + 1.0001) * (S + 3)))
    assert mismatch(locus.poles, [-1, -1.0001, -3]) < 1e-11
    assert len(locus.break_aways) == 2


# ---- gains as given


def test_branches_do_not_jump_however_coarse_the_gains():
    """Whatever branches exchange their places between two gains: columns are those of a fine run."""
    rng = np.random.default_rng(11)
    for order in (3, 4, 5, 6, 8, 10):
        system = tuple(rng.standard_normal(shape) for shape in ((order, order), (order, 1), (1, order)))
        ends = np.array([0.0, 1.0, 30.0, 1e3])
        fine = np.unique(np.concatenate([ends, np.geomspace(1e-3, 1e3, 20_000)]))
        marks = gains_of(rl.root_locus(system, [0.0]).break_aways)
        follow, coarse = rl.root_locus(system, fine), rl.root_locus(system, ends)
        for a, b in pairwise(ends):
            if any(a < k < b for k in marks):
                continue
            i, j = np.searchsorted(fine, [a, b])
            way = dict(zip(follow.roots[i], follow.roots[j], strict=True))
            at = np.searchsorted(ends, a)
            for start, end in zip(coarse.roots[at], coarse.roots[at + 1], strict=True):
                nearest = min(way, key=lambda s, start=start: abs(s - start))
                assert abs(way[nearest] - end) < 1e-6 * max(1, abs(end))


# ---- discrete time


def test_a_discrete_loop_crosses_the_unit_circle():
    locus = rl.root_locus(1 / ((Z - 1) * (Z - 0.5)))
    assert locus.discrete
    assert locus.dt is True
    wanted = (-3.0, np.pi, -1), (0.5, np.arccos(0.75), 1)
    assert [tuple(c) for c in locus.crossings] == [pytest.approx(w, rel=1e-12) for w in wanted]
    assert locus.stable[(locus.gains > 1e-9) & (locus.gains < 0.4999)].all()
    assert not locus.stable[locus.gains > 0.5001].any()
    assert locus.labels == ("pole at z = 0.5", "pole at z = 1")


def test_a_real_root_leaves_the_circle_at_minus_one():
    """z = 0.5 - k: out at z = -1 for k = 1.5, and at z = 1 for k = -.5."""
    found = rl.root_locus(1 / (Z - 0.5)).crossings
    wanted = (-0.5, 0.0, -1), (1.5, np.pi, 1)
    assert [tuple(c) for c in found] == [pytest.approx(w, rel=1e-14) for w in wanted]


@pytest.mark.parametrize("form", ["polynomials", "factors", "state space"])
def test_a_long_delay(form):
    """3.5/(10 s + 1), sampled at .01 s, with 100 samples of delay: 101 branches leave z = 0 and z = .999."""
    a = np.exp(-0.001)
    gain = 3.5 * (1 - a)
    if form == "polynomials":
        system = control.tf([gain], [1, -a] + [0] * 100, 0.01)
    elif form == "factors":
        system = ZerosPolesGain([], [a] + [0.0] * 100, gain, dt=0.01)
    else:
        A = np.eye(101, k=-1)
        A[0, 0] = a
        system = control.ss(A, np.eye(101, 1), gain * np.eye(101)[100:], 0, 0.01)
    locus = rl.root_locus(system, [0.0, 4.0, 5.0])
    assert locus.roots.shape == (3, 101)
    first = min((c for c in locus.crossings if c.gain > 0), key=lambda c: c.gain)
    assert (first.gain, first.omega) == pytest.approx((4.649212172, 0.016241665558), rel=1e-9)
    assert locus.stable.tolist() == [True, True, False]
    assert np.abs(locus.roots**100 * (locus.roots - a) + locus.gains[:, None] * gain).max() < 1e-12
