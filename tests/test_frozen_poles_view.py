"""The live view of the burn: its poles are the library's at each second, in the table and in words."""

import numpy as np
import pytest

from rlswaim import explorers
from rlswaim.explorers import frozen_poles
from rlswaim.practice import burn
from small_views import mismatch, opened, show, view_of


@pytest.mark.parametrize("t", [0, 10, 25, 26, 58, 88, 89, 110])
def test_what_is_sent_is_what_numpy_finds_and_what_is_left_out_decays(t):
    for name, way in frozen_poles.WAYS.items():
        wanted = np.linalg.eigvals(burn.loop_at(float(t), way).A)
        near = wanted[np.abs(wanted) <= frozen_poles.WITHIN]
        sent = np.array([complex(*pole) for pole in frozen_poles.table()[name][t]])
        assert mismatch(sent, near[near.imag >= -1e-12]) < 1e-6
        assert wanted[np.abs(wanted) > frozen_poles.WITHIN].real.max() < -1
        assert list(sent.real) == sorted(sent.real, reverse=True)


def test_the_table_and_the_words_follow_the_time(browser):
    view = explorers.frozen_poles_explorer()
    with opened(browser, view) as page:
        page.wait_for_function("document.querySelector('table.poles tbody tr')")
        for t, said in ((10, "fixed: lost"), (30, "fixed: held"), (100, "fixed: lost"), (0, "on the axis")):
            show(page, t=t)
            rows = page.evaluate(
                """[...document.querySelectorAll('table.poles tbody tr')]
                     .map(({ dataset: { branch, re, im } }) => [branch, +re, +im])"""
            )
            view.t = t
            for name, poles in view.poles().items():
                found = np.array([complex(re, im) for branch, re, im in rows if branch == name])
                assert mismatch(found, poles[np.abs(poles) <= frozen_poles.WITHIN]) < 1e-6
            words = page.locator(".verdict").inner_text()
            assert said in words
            begins = [b for b in burn.switched() if b <= t][-1]
            assert f"made for {burn.switched()[begins]:g} s" in words


def test_the_trail_is_drawn(browser):
    with opened(browser, view_of("whole-burn")) as page:
        page.wait_for_function("document.querySelector('table.poles tbody tr')")
        picture = "el.querySelector('canvas').toDataURL()"
        show(page, t=100, trail=0)
        bare = page.evaluate(picture)
        show(page, trail=60)
        assert page.evaluate(picture) != bare


@pytest.mark.parametrize(("t", "error"), [(111, ValueError), (0.5, ValueError), ("x", TypeError)])
def test_refused(t, error):
    with pytest.raises(error, match="t in whole-burn explorer"):
        explorers.frozen_poles_explorer(t=t)
