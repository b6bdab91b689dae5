"""The margins that the browser computes are those of `control`."""

import math
from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page

from browser_maths import maths_page, presets_of, run, sections, sent
from running_value import polynomial_along


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


class TestMargins:
    @sections
    @pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")  # control's, at a pole and zero at 0
    def test_agree_with_control(self, page, section):
        gains = phases = 0
        for state in presets_of(section):
            for what in [w for w in sent(section)["loci"] if w["of"] == "poles"]:
                found = run(page, "module.margins", section, state, what)
                k = state[what["running"]]
                if k == 0:
                    assert found is None
                    continue
                p = polynomial_along(section, state, what)
                D, N = p(0.0), k * (p(1.0) - p(0.0))
                loop = control.tf(np.trim_zeros(N[::-1], "f").tolist(), D[::-1].tolist())
                gain, phase, _, w_gain, w_phase, _ = control.stability_margins(loop, returnall=True)
                ours = sorted((m["omega"], m["factor"]) for m in found["gain"] if m["omega"] > 1e-3)
                theirs = sorted((w, g) for w, g in zip(w_gain, gain, strict=True) if w > 1e-3)
                assert np.array(ours) == pytest.approx(np.array(theirs), rel=1e-5)
                ours = sorted((m["omega"], m["degrees"]) for m in found["phase"] if m["omega"] > 1e-3)
                theirs = sorted(
                    (w, (g + 180) % 360 - 180) for w, g in zip(w_phase, phase, strict=True) if w > 1e-3
                )
                assert np.array(ours) == pytest.approx(np.array(theirs), rel=1e-5)
                gains, phases = gains + len(found["gain"]), phases + len(found["phase"])
                for margin in found["gain"]:
                    assert margin["dB"] == pytest.approx(20 * math.log10(margin["factor"]))
                for margin in found["phase"]:
                    lag = math.degrees(margin["delay"] * margin["omega"])
                    assert 0 <= lag < 360
                    assert (lag - margin["degrees"]) % 360 == pytest.approx(
                        0, abs=1e-9
                    ) or lag == pytest.approx(margin["degrees"] % 360)
        assert (gains, phases) == {"IV": (10, 12), "V": (5, 15), "VI": (7, 14), "VII": (9, 21)}[section]

    def test_none_for_stations_and_zeros(self, page):
        state = presets_of("VII")[0]
        for what in (sent("VII")["loci"][1], {"running": "sensor", "off": [], "of": "poles"}):
            assert run(page, "module.margins", "VII", state, what) is None
