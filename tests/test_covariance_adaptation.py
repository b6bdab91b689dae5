"""Evolution by adaptation beside Hansen's formulas (The CMA Evolution Strategy, a tutorial), one by one."""

import numpy as np
import pytest

from rlswaim.edition.adaptation import OUTSIDE, PATIENCE, adapted


def seen(cost, start, step, rounds, seed=1964):
    """Return all places whose cost is asked for, generation by generation, the best place and its cost."""
    asked = []

    def told(u):
        asked.append(u.copy())
        return cost(u)

    best, least = adapted(told, start, step, np.random.default_rng(seed), rounds)
    return asked, best, least


def by_the_tutorial(cost, start, step, rounds, seed=1964):
    """Return the same places by the tutorial's formulas, sums written out; those outside cost more."""
    rng, n = np.random.default_rng(seed), len(start)
    count = 4 * n + 16
    raw = [np.log((count + 1) / 2) - np.log(i) for i in range(1, count // 2 + 1)]
    w = [value / sum(raw) for value in raw]
    mu_eff = sum(w) ** 2 / sum(value**2 for value in w)
    c_sigma = (mu_eff + 2) / (n + mu_eff + 5)
    c_c = (4 + mu_eff / n) / (n + 4 + 2 * mu_eff / n)
    c_1 = 2 / ((n + 1.3) ** 2 + mu_eff)
    c_mu = min(1 - c_1, 2 * (mu_eff - 2 + 1 / mu_eff) / ((n + 2) ** 2 + mu_eff))
    damping = 1 + c_sigma  # without the tutorial's summand for many people, which slows the step further
    length = n**0.5 * (1 - 1 / (4 * n) + 1 / (21 * n**2))
    m, C, p_sigma, p_c = np.array(start), np.eye(n), np.zeros(n), np.zeros(n)
    asked = [m[:, None]]
    for _ in range(rounds):
        values, B = np.linalg.eigh(C)
        y = B @ np.diag(values**0.5) @ rng.standard_normal((n, count))
        x = m[:, None] + step * y
        inside = np.minimum(np.maximum(x, 0), 1)
        asked.append(inside)
        distance = np.linalg.norm(x - inside, axis=0)
        best = np.argsort(cost(inside) + OUTSIDE * distance**2)[: count // 2]
        moved = sum(weight * y[:, k] for weight, k in zip(w, best, strict=True))
        m = m + step * moved
        whitened = B @ np.diag(values**-0.5) @ B.T @ moved
        p_sigma = (1 - c_sigma) * p_sigma + (c_sigma * (2 - c_sigma) * mu_eff) ** 0.5 * whitened
        p_c = (1 - c_c) * p_c + (c_c * (2 - c_c) * mu_eff) ** 0.5 * moved
        parents = sum(weight * np.outer(y[:, k], y[:, k]) for weight, k in zip(w, best, strict=True))
        C = (1 - c_1 - c_mu) * C + c_1 * np.outer(p_c, p_c) + c_mu * parents
        step *= np.exp(min(1, c_sigma / damping * (np.linalg.norm(p_sigma) / length - 1)))
    return asked


def valley(u):
    """Return costs that are kinked, steeper one way than the other, and least near a corner of the cube."""
    wanted = np.linspace(0.05, 0.9, len(u))
    return np.abs((u - wanted[:, None]) * np.arange(1, len(u) + 1)[:, None]).max(axis=0) + u.sum(axis=0) / 9


@pytest.mark.parametrize(("n", "step"), [(1, 0.1), (2, 0.3), (5, 0.2)])
def test_every_generation_is_that_of_the_tutorial(n, step):
    start = np.full(n, 0.3)
    asked, best, least = seen(valley, start, step, 15)
    wanted = by_the_tutorial(valley, start, step, 15)
    assert len(asked) == len(wanted) == 16
    for ours, theirs in zip(asked, wanted, strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=1e-7, atol=1e-9)
    everywhere = np.hstack(wanted)
    assert least == pytest.approx(valley(everywhere).min(), abs=2e-9)
    assert valley(best[:, None])[0] == least


def test_it_ends_when_nothing_better_comes_for_long():
    asked, best, least = seen(lambda u: np.ones(u.shape[1]), np.full(2, 0.5), 0.1, 1000)
    assert (len(asked), least) == (1 + PATIENCE + 1, 1)
    assert (best == 0.5).all()


def test_it_goes_on_while_something_better_comes():
    """Each generation costs less than the one before, so that patience never runs out."""
    calls = []

    def less_and_less(u):
        calls.append(u.shape[1])
        return np.full(u.shape[1], -float(len(calls)))

    _, least = adapted(less_and_less, np.full(2, 0.5), 0.01, np.random.default_rng(1), 3 * PATIENCE)
    assert len(calls) == 1 + 3 * PATIENCE
    assert least == -len(calls)
