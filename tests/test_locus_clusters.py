"""Roots nearer to each other than sqrt(eps): factors fix them all the same, and 60 digits say where."""

import control
import mpmath
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.rootlocus.polynomials import misfit
from rlswaim.rootlocus.repeated_roots import points_of_polynomial
from systems import mismatch


def roots_of_factors(zeros, poles, gain):
    """Return the roots of prod(s - p) + gain prod(s - z), multiplied out and solved with 60 digits."""
    with mpmath.workdps(60):

        def product(points):
            p = [mpmath.mpf(1)]
            for x in points:
                p = [a - x * b for a, b in zip([*p, 0], [0, *p], strict=True)]
            return p

        D, N = product(map(mpmath.mpf, poles)), product(map(mpmath.mpf, zeros))
        N = [mpmath.mpf(0)] * (len(D) - len(N)) + [mpmath.mpf(gain) * c for c in N]
        ascending = [a + b for a, b in zip(D, N, strict=True)][::-1]
        found = mpmath.polyroots(ascending, asc=True, maxsteps=2000, extraprec=400)
        return [complex(s) for s in found]


@pytest.mark.parametrize("apart", [1e-6, 1e-8, 1e-9, 1e-10, 1e-12])
def test_two_poles_meet_where_they_should(apart):
    """1/((s + 1)(s + 1 + e)(s + 3)): the roots are right to a unit in the last place."""
    poles = [-1.0, -1.0 - apart, -3.0]
    break_gain = (poles[0] - poles[1]) ** 2 / 2
    gains = break_gain * np.array([0.1, 0.5, 0.99, 2.0, 100.0])
    locus = rl.root_locus(([], poles, 1.0), gains)
    assert min(abs(b.gain / break_gain - 1) for b in locus.break_aways) < 1e-3
    for gain, roots in zip(gains, locus.roots, strict=True):
        assert mismatch(roots, roots_of_factors([], poles, gain)) < 1e-15
        assert (roots.imag != 0).any() == (gain > break_gain)


@pytest.mark.parametrize("seed", [1, 7, 11, 17, 20])
def test_clusters_of_poles_and_zeros(seed):
    """Poles and zeros 1e-11 to 1e-3 from each other, at 60 gains and more from 1e-20 to 1e4."""
    rng = np.random.default_rng(seed)
    poles = -rng.uniform(0.5, 5, 7)
    poles[1::2] = poles[:-1:2] * (1 + 10.0 ** rng.uniform(-11, -3, 3))
    zeros = poles[[0, 2, 4]] * (1 + 10.0 ** rng.uniform(-10, -2, 3))
    marks = [b.gain for b in rl.root_locus((zeros, poles, 1.0), [0.0]).break_aways if b.gain > 0]
    gains = np.unique([*(m * part for m in marks for part in (0.3, 0.9, 1.1, 3)), *np.logspace(-20, 4, 60)])
    locus = rl.root_locus((zeros, poles, 1.0), gains)
    for at in rng.choice(gains.size, 8, replace=False):
        wanted = roots_of_factors(zeros, poles, gains[at])
        assert mismatch(locus.roots[at], wanted) < 3e-15


@pytest.mark.parametrize("count", [2, 3, 4])
def test_pairs_repeated_beside_each_other_fit_all_coefficients(count):
    """(s^2 + 2 a s + a^2 (1 + b^2))^count, where b is down to .01: one pair."""
    rng = np.random.default_rng(count)
    for a, b in zip(10 ** rng.uniform(0, 2, 60), 10 ** rng.uniform(-2, 0, 60), strict=True):
        p = np.poly(np.repeat([-a + 1j * a * b, -a - 1j * a * b], count)).real
        poles = points_of_polynomial(p[::-1]).values
        assert misfit(p[::-1], poles) < 1e-13, (a, b)
        assert mismatch(poles, np.repeat([-a + 1j * a * b, -a - 1j * a * b], count)) < 1e-8, (a, b)


def test_a_triple_pair_near_the_axis_carries_its_locus():
    """The poles' polynomial is the given one, so that the branches leave along the given one too."""
    p = np.array([1.0])
    for _ in range(3):
        p = np.convolve(p, [1, 200, 10000.01])
    locus = rl.root_locus(control.tf([1], p))
    assert mismatch(locus.poles, np.repeat([-100 + 0.1j, -100 - 0.1j], 3)) < 1e-10
    for gain, roots in zip(locus.gains, locus.roots, strict=True):
        assert misfit(p[::-1] + gain * np.eye(7)[0], roots) < 1e-13


@pytest.mark.parametrize("seed", range(5))
def test_groups_of_any_kind_fit_all_coefficients(seed):
    """Real and complex roots of any multiplicity, down to a thousandth of their size from each other."""
    rng = np.random.default_rng(seed)
    for _ in range(40):
        size, roots = 10 ** rng.uniform(-1, 2), []
        for _ in range(rng.integers(1, 4)):
            x = -size * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-3, 0))
            y = size * 10 ** rng.uniform(-3, 0) * rng.integers(0, 2)
            roots += [x + 1j * y, x - 1j * y][: 2 if y else 1] * int(rng.integers(1, 4))
        p = np.poly(roots).real[::-1]
        assert misfit(p, points_of_polynomial(p).values) < 1e-13, roots


@pytest.mark.parametrize(
    ("place", "singles", "pairs"), [(35, 3, 1), (31, 3, 1), (35, 1, 2), (52, 1, 2), (35, 2, 2)]
)
def test_a_real_factor_in_a_group_of_poles_is_cancelled_as_a_real_one(place, singles, pairs):
    """(s - a)/((s - a)^m ((s - a)^2 + .01)^n): what rests is real, what moves keeps its pairs."""
    den = np.poly([place] * singles)
    for _ in range(pairs):
        den = np.polymul(den, [1, -2 * place, place**2 + 0.01])
    locus = rl.root_locus(control.tf([1, -place], den))
    assert locus.loop.resting.size <= 1
    assert (locus.loop.resting.imag == 0).all()
    for roots in locus.roots:
        assert sorted(roots.tolist(), key=lambda s: (s.real, s.imag)) == sorted(
            roots.conj().tolist(), key=lambda s: (s.real, s.imag)
        )


SHARED = {
    "zero-known-better": ([[1, 0, 6400]], [[1, 0, 6400], [1, 0, 6400], [1, -2e-4, 6400 + 1e-8]]),
    "pole-known-better": (
        [[1, 0], [1, 100], [1, 200, 10000.01], [1, 200, 10001]],
        [[1, 0, 0.01], [1, 0, 0.01], [1, 200, 10000.01]],
    ),
    "phase-at-rest": ([[1, 1], [1, 10, 26], [1, 10, 26]], [[1, 2, 2], [1, 10, 26], [1, 10, 26]]),
    "more-zeros-than-poles-there": (
        [[1, -2e-4, 6400 + 1e-8], [1, -2e-4, 6400 + 1e-8]],
        [[1, -2e-4, 6400 + 1e-8], [1, 0, 6400], [1, 0, 6400]],
    ),
    "two-shared-near-each-other": (
        [[1, -2e-4, 6400 + 1e-8], [1, 0, 6400]],
        [[1, -2e-4, 6400 + 1e-8], [1, 0, 6400], [1, 0, 6400]],
    ),
    "repeated-elsewhere-and-shared-at-the-origin": (
        [[1, 0], [1, 0], [1, 100]],
        [[1, 0], [1, 0], [1, 0], [1, 100], [1, 200, 10000.01]] + 2 * [[1, 40.132, 20.066**2 + 9]],
    ),
    "shared-and-a-pair-beside": (
        [[1, 2, 6401], [1, -2]],
        [[1, -2], [1, -4, 4.01], [1, 2, 6401], [1, 2, 6401]],
    ),
}


def product(factors):
    p = np.array([1.0])
    for factor in factors:
        p = np.polymul(p, factor)
    return p


@pytest.mark.parametrize("case", SHARED)
def test_a_common_factor_in_a_group_leaves_the_others_fitting(case):
    """What is known of a common factor from the other polynomial is not put in place of one root alone."""
    num, den = (product(factors) for factors in SHARED[case])
    locus = rl.root_locus(control.tf(num, den))
    assert locus.loop.resting.size >= 2
    for gain, roots in zip(locus.gains, locus.roots, strict=True):
        assert misfit(np.polyadd(den, gain * num)[::-1], roots) < 1e-12


@pytest.mark.parametrize("seed", range(40))
def test_groups_near_each_other_in_both_fit_both(seed):
    """Double roots apart by 1e-2 to 1e-9 of their size, some of them shared: no coefficient is missed."""
    rng = np.random.default_rng(seed)
    x, y = -(10.0 ** rng.uniform(-3, 1)), 10.0 ** rng.uniform(-1, 2)
    step = np.hypot(x, y) * 10.0 ** rng.uniform(-9, -2)
    near = [(x, y), (x + step, y), (x, y + step)]
    pairs = [[1, -2 * re, re**2 + im**2] for re, im in near]
    num = product(pairs[i] for i in rng.integers(0, 3, size=2))
    den = product([*(pairs[i] for i in rng.integers(0, 3, size=3)), [1, 3]])
    locus = rl.root_locus(control.tf(num, den))
    for gain, roots in zip(locus.gains, locus.roots, strict=True):
        assert misfit(np.polyadd(den, gain * num)[::-1], roots) < 1e-12


def test_of_a_group_in_both_only_what_is_common_stands_still():
    """A double zero at one of three pole pairs: multiplied out, the loop crosses where its factors do."""
    pair, other = np.array([-0.002 + 28.05j, -0.002 - 28.05j]), np.array([-0.001 + 28.05j, -0.001 - 28.05j])
    zeros, poles = [*pair, *pair], [*pair, *other, *other, -3]
    wanted = rl.root_locus((zeros, poles, 1.0), [0.0]).crossings
    found = rl.root_locus(control.tf(np.poly(zeros).real, np.poly(poles).real), [0.0])
    assert found.loop.resting.size == 2
    np.testing.assert_allclose(np.array(found.crossings), np.array(wanted), rtol=1e-9)


def test_a_root_that_all_but_vanishes_does_not_decide_which_roots_fit():
    """Where a root passes the origin the last coefficient is rounding alone, and says nothing of others."""
    num = np.array([-2.5, 10.0005, -10.027, 2.0051e-3, -1.0025e-7])
    den = np.array([1, -2.6883, 6419.80714, -50.308142, 115313.524, -240.782604, 518546.337, -51.8546314])
    gain = -517253181.04737985
    roots = rl.root_locus(control.tf(num, den), [gain]).roots[0]
    with mpmath.workdps(60):
        kN = [mpmath.mpf(gain) * c for c in [*num[::-1], 0, 0, 0]]
        ascending = [mpmath.mpf(a) + b for a, b in zip(den[::-1], kN, strict=True)]
        exact = mpmath.polyroots(ascending, asc=True, maxsteps=500, extraprec=300)
    wanted = np.array([complex(s) for s in exact])
    assert mismatch(roots[np.abs(roots) > 1e-9], wanted[np.abs(wanted) > 1e-9]) < 1e-12
