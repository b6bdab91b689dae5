"""The bound of mu against cases whose mu is known, and against points of the cube."""

import numpy as np
import pytest
from scipy.optimize import approx_fprime

from rlswaim.practice import singular_value as sv

RNG = np.random.default_rng(1964)


def random(n):
    return RNG.standard_normal((n, n)) + 1j * RNG.standard_normal((n, n))


def real_mu(M, sizes, count=4000):
    """Return a lower bound of mu: the largest real eigenvalue of M diag(d) over many d of size 1."""
    best = 0.0
    for _ in range(count):
        d = np.where(
            RNG.random(len(sizes)) < 0.7, RNG.choice([-1.0, 1.0], len(sizes)), RNG.uniform(-1, 1, len(sizes))
        )
        values = np.linalg.eigvals(M * np.repeat(d, sizes))
        real = values[np.abs(values.imag) < 1e-3 * np.abs(values)].real
        best = max(best, *np.abs(real)) if real.size else best
    return best


@pytest.mark.parametrize("n", [2, 4, 7])
def test_of_rank_one_the_bound_is_mu(n):
    """det(I - M diag(d)) = 1 - sum c_i d_i, so mu is sum |c_i| if all c_i are real."""
    a, c = random(n)[0], RNG.standard_normal(n)
    M = np.outer(a, c / a)
    assert sv.upper_bound(M, (1,) * n) == pytest.approx(np.abs(c).sum(), rel=0.03)


def test_imaginary_rank_one_has_no_mu():
    a = random(3)[0]
    assert sv.upper_bound(np.outer(a, 1j / a), (1, 1, 1)) < 0.1


def test_one_repeated_factor_meets_real_eigenvalues_alone():
    V = random(4)
    M = V @ np.diag([3.0, -1.0, 8j, 2 + 9j]) @ np.linalg.inv(V)
    found = sv.upper_bound(M, (4,))
    assert 3.0 * (1 - 1e-6) <= found < 4.2  # far below the size 9.2 of the complex ones


@pytest.mark.parametrize("sizes", [(1, 1, 1), (2, 1), (1, 3, 2)], ids=str)
def test_no_point_of_the_cube_is_above(sizes):
    for _ in range(3):
        M = random(sum(sizes))
        found = sv.upper_bound(M, sizes)
        assert real_mu(M, sizes) <= found * (1 + 2e-3)
        assert found <= np.linalg.norm(M, 2) * (1 + 1e-9)


def test_scaling_of_the_factors_alone_changes_nothing():
    M, sizes = random(5), (2, 1, 2)
    weight = np.repeat([1.0, 50.0, 0.02], sizes)
    other = weight[:, None] * M / weight
    scales = sv._Scales(sizes)
    assert np.allclose(sv._balanced(other, scales), sv._balanced(M, scales), rtol=1e-6)
    assert sv.upper_bound(other, sizes) == pytest.approx(sv.upper_bound(M, sizes), rel=0.15)


def test_gradient():
    sizes = (2, 1, 3)
    M, scales = random(6), sv._Scales(sizes)
    x = np.concatenate([scales.identity, np.zeros(scales.count)]) + 0.3 * RNG.standard_normal(
        2 * scales.count
    )
    _, gradient = sv._smooth(M, scales, x, 2.0)
    numeric = approx_fprime(x, lambda y: sv._smooth(M, scales, y, 2.0)[0], 1e-7)
    assert np.allclose(gradient, numeric, rtol=1e-4, atol=1e-4 * np.abs(gradient).max())


def test_smooth_value_is_above_the_eigenvalue():
    sizes = (1, 2)
    M, scales = random(3), sv._Scales(sizes)
    x = np.concatenate([scales.identity, np.zeros(scales.count)])
    exact = np.linalg.norm(M, 2) ** 2
    assert sv._smooth(M, scales, x, sv.EXACT)[0] == pytest.approx(exact, rel=1e-6)
    assert exact < sv._smooth(M, scales, x, 2.0)[0] <= exact + np.log(3) / 2 + 1e-6
