"""The workbench of each control system: its code, its loci, its maps, its responses, its size."""

import gzip
import json
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page

from rlswaim.explorers import Explorer
from standin import opened, paired, table
from workbench_page import EQUATIONS, VIEWS, picture

SCREENSHOTS = Path(__file__).parent.parent / "screenshots"


@pytest.fixture(scope="module", params=VIEWS, ids=VIEWS)
def any_view(request) -> Explorer:
    return VIEWS[request.param](EQUATIONS)


class TestEveryControlSystem:
    @pytest.fixture
    def wide(self, browser, any_view):
        with opened(browser, any_view, viewport={"width": 1280, "height": 900}) as page:
            page.evaluate("[...el.querySelectorAll('details')].forEach((panel) => (panel.open = true))")
            page.wait_for_timeout(300)
            yield page

    def presets(self, wide: Page) -> list[dict]:
        return wide.evaluate("state.payload.presets")

    def test_the_call_of_the_library_gives_the_poles_shown(self, wide):
        for preset in self.presets(wide):
            wide.get_by_role("button", name=preset["name"], exact=True).click()
            wide.wait_for_timeout(220)
            names: dict = {}
            exec(wide.locator("[data-panel=takeaway] code").inner_text(), names)
            ours, theirs = paired(names["loop"].poles(), table(wide))
            assert (abs(ours - theirs) <= 1e-6 * np.maximum(1, abs(ours))).all(), preset["name"]

    def test_each_slider_can_run_the_locus(self, wide):
        names = (
            wide.locator(".bar select").first.locator("option").evaluate_all("all => all.map(o => o.value)")
        )
        assert len(names) >= len(wide.evaluate("Object.keys(state.payload.running)"))
        for name in names:
            wide.locator(".bar select").first.select_option(name)
            wide.wait_for_timeout(60)
            assert wide.locator("figcaption").inner_text().startswith(("Root locus", "Zeros of the loop"))
            assert wide.locator(".bar select").first.input_value() == name

    def test_each_station_has_its_map(self, wide):
        wide.locator("canvas[data-plane=map]").scroll_into_view_if_needed()
        wide.wait_for_timeout(100)
        for at, station in enumerate(wide.evaluate("state.payload.maps")):
            if wide.locator("[data-panel=map] select").is_visible():
                wide.locator("[data-panel=map] select").select_option(str(at))
                wide.wait_for_timeout(60)
            wide.wait_for_function(
                "words => el.querySelector('[data-panel=map] small').textContent.startsWith(words)",
                arg=f"{station} from 0 to 420 ft",
            )

    def test_each_input_has_its_responses(self, wide):
        seen = set()
        wide.locator("canvas[data-plane=responses]").scroll_into_view_if_needed()
        for at in range(wide.locator("[data-panel=responses] select").first.locator("option").count()):
            wide.locator("[data-panel=responses] select").first.select_option(str(at))
            wide.wait_for_timeout(220)
            wide.wait_for_function("el.querySelector('[data-plane=responses]').ariaLabel")
            seen.add(picture(wide, "responses"))
            label = wide.locator("canvas[data-plane=responses]").get_attribute("aria-label")
            assert "theta: largest" in label
            assert "NaN" not in label
        assert len(seen) > 4

    def test_weight(self, any_view):
        sent = json.dumps(any_view.payload) + any_view._esm + any_view._css
        assert len(gzip.compress(sent.encode())) < 150_000

    @pytest.mark.parametrize("theme", ["light", "dark"])
    @pytest.mark.parametrize("width", [360, 800])
    def test_fits_the_page(self, browser, any_view, width, theme):
        with opened(browser, any_view, viewport={"width": width, "height": 900}) as page:
            page.evaluate(
                """(theme) => {
                     document.documentElement.dataset.theme = theme;
                     document.body.style.background = theme === 'dark' ? '#121212' : '#fff';
                     [...el.querySelectorAll('details')].forEach((panel) => (panel.open = true));
                   }""",
                theme,
            )
            page.wait_for_timeout(300)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            SCREENSHOTS.mkdir(exist_ok=True)
            page.screenshot(path=SCREENSHOTS / f"{any_view.system}-{width}-{theme}.png", full_page=True)
