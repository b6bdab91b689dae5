"""Break-aways and crossings of random loops against a dense trace of eigenvalues, both ways."""

import control
import numpy as np
import pytest

import rlswaim as rl


def random_loop(order, seed):
    """Return A, B, C of a random loop: full, of given modes, or modes with poles repeated nearly."""
    rng = np.random.default_rng([order, seed, 7])
    if seed % 2:
        A = rng.standard_normal((order, order)) * 10 ** rng.uniform(-1, 1)
        return A, rng.standard_normal((order, 1)), rng.standard_normal((1, order))
    A = np.zeros((order, order))
    for i in range(0, order - 1, 2):
        omega, zeta = 10 ** rng.uniform(-1, 1), rng.uniform(-0.3, 1)
        A[i : i + 2, i : i + 2] = [[0, omega], [-omega, -2 * zeta * omega]]
    if order % 2:
        A[-1, -1] = rng.uniform(-3, 3)
    return A, rng.standard_normal((order, 1)), rng.standard_normal((1, order))


LOOPS = [(order, seed) for order in (2, 3, 5, 8, 12, 20) for seed in range(4)]


@pytest.mark.parametrize("discrete", [False, True], ids=["continuous", "discrete"])
@pytest.mark.parametrize(("order", "seed"), LOOPS)
def test_the_lists_agree_with_a_dense_trace(order, seed, discrete):
    """Between each two gains roots change sides as the crossings say, and pairs as the break-aways say."""
    A, B, C = random_loop(order, seed)
    A = A / np.abs(np.linalg.eigvals(A)).max() if discrete else A
    locus = rl.root_locus(control.ss(A, B, C, 0, discrete), [0.0])
    steps = np.geomspace(1e-4, 1e4, 1201) * np.linalg.norm(A) / np.linalg.norm(B @ C)
    gains = np.concatenate([-steps[::-1], steps])
    roots = np.linalg.eigvals(A - gains[:, None, None] * (B @ C))
    outside = ((np.abs(roots) > 1) if discrete else (roots.real > 0)).sum(axis=1)
    real = (roots.imag == 0).sum(axis=1)
    crossed, met = np.zeros(gains.size - 1, int), np.zeros(gains.size - 1, int)
    for gain, omega, direction in locus.crossings:
        if gains[0] < gain < gains[-1]:
            crossed[np.searchsorted(gains, gain) - 1] += direction * (1 if omega in (0.0, np.pi) else 2)
    for gain, point in locus.break_aways:
        if gains[0] < gain < gains[-1] and point.imag == 0:
            met[np.searchsorted(gains, gain) - 1] += 1
    around_zero = gains.size // 2 - 1  # poles on the border leave it there, and do not cross
    assert np.array_equal(*(np.delete(part, around_zero) for part in (np.diff(outside), crossed)))
    changes = np.abs(np.diff(real))
    assert (changes[met == 0] == 0).all()
    assert (changes[met == 1] == 2).all()
