"""Roots nearer to each other than sqrt(eps): factors fix them all the same, and 60 digits say where."""

import mpmath
import numpy as np
import pytest

import rlswaim as rl
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
