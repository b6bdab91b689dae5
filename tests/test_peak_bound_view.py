"""The live view of the limits: what the browser finds is what the library does."""

import numpy as np
import pytest

from rlswaim.practice.limits import least_peak_over_band
from small_views import MAKERS, opened, random_states, show, view_of

BOUND = """([payload, states]) => states.map(s => {
  const { zeros, peak, interlaced } = module.default.bound(payload, s);
  return [[...zeros.x], [...zeros.y], peak, interlaced];
})"""


def test_bounds_agree_with_python_on_300_states(browser):
    view = MAKERS["peak-bound"]()
    states = random_states(view, 300, seed=22)
    with opened(browser, view) as page:
        found = page.evaluate(BOUND, [view.payload, states])
    for state, (x, y, peak, interlaced) in zip(states, found, strict=True):
        for name, value in state.items():
            setattr(view, name, value)
        ours = view.limits()
        assert len(ours.zeros) == len(x), state
        apart = np.abs(np.subtract.outer(np.array(ours.zeros), np.array(x) + 1j * np.array(y)))
        assert not x or np.all(apart.min(axis=0) <= 1e-6 * np.maximum(1, np.hypot(x, y))), state
        assert peak == pytest.approx(ours.peak, rel=1e-4), state
        assert interlaced == ours.stable_controller, state


def test_the_table_follows(browser):
    view = view_of("peak-bound")
    with opened(browser, view) as page:
        show(page, gyro_a=135, bandwidth=10.0)
        at = "name => Number(el.querySelector(`[data-quantity=${name}]`).dataset.value)"
        assert page.evaluate(at, "peak") == pytest.approx(1697.09, rel=1e-5)
        bode = view.limits().log_integral
        assert page.evaluate(at, "band") == pytest.approx(least_peak_over_band(bode, 10.0))
        assert "No stable controller" in page.locator(".verdict").inner_text()
