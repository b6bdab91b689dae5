"""The map of all pairs of stations beside its workbench, on the page of Section VII."""

from collections.abc import Iterator

import pytest

from live_tables import every
from livepage import LivePage, live, poles_of, relative_mismatch


@pytest.fixture(scope="module")
def shown(visit, request) -> Iterator[LivePage]:
    """A live view on its page, shared by the tests of one view."""
    with live(visit, request.param) as found:
        yield found


@every("station-map")
class TestStationMap:
    def test_comes_in_levels(self, shown):
        shown.root.locator("canvas[data-plane=stations]").scroll_into_view_if_needed()
        shown.page.wait_for_function(
            "root => root.dataset.step === 'complete'", arg=shown.root.element_handle(), timeout=30000
        )
        steps = shown.page.evaluate(
            """async root => {
                 const seen = [];
                 const note = () => seen.push(root.dataset.step);
                 root.addEventListener('rlswaim:drawn', note);
                 const named = b => b.textContent === 'Figure 25, K_A = 3';
                 [...root.querySelectorAll('button')].find(named).click();
                 const until = performance.now() + 30000;
                 do await new Promise(next => setTimeout(next, 20));
                 while ((root.dataset.step !== 'complete' || seen.length < 3) && performance.now() < until);
                 root.removeEventListener('rlswaim:drawn', note);
                 return [...new Set(seen)].filter(s => s !== '0').map(s => s === 'complete' ? 0 : +s);
               }""",
            shown.root.element_handle(),
        )
        assert steps == sorted(steps, reverse=True)
        assert steps[-1] == 0
        assert "All 177,241 pairs" in shown.root.locator(".crossings").inner_text()

    def test_a_click_picks_the_pair_and_the_workbench_follows_and_back(self, shown, request):
        page = shown.page
        bench = page.locator("[data-explorer=dual-actuation]")
        panel = page.locator(".live-view", has=bench)
        twin = LivePage("dual-actuation", page, bench, panel)
        shown.root.get_by_role("button", name="The pair that works").click()
        canvas = shown.root.locator("canvas[data-plane=stations]")
        canvas.scroll_into_view_if_needed()
        box = canvas.bounding_box()
        left, right, top, bottom = 50, 12, 10, 36
        x = left + (100.5 / 421) * (box["width"] - left - right)
        y = box["height"] - bottom - (300.5 / 421) * (box["height"] - top - bottom)
        canvas.click(position={"x": x, "y": y})
        page.wait_for_timeout(300)
        values = twin.values()
        assert (values["sensor"], values["jet"]) == (100, 300)
        view = twin.library_at()
        assert relative_mismatch(poles_of(twin.rows("table.poles")), view.closed_loop()) < 1e-6
        told = "root => +root.querySelector('.verdict').dataset.value"
        assert shown.root.evaluate(told) == pytest.approx(view.poles().real.max(), rel=1e-6, abs=1e-9)
        panel.evaluate("panel => panel.scrollIntoView()")
        twin.moved("jet", [64], "table.poles")
        page.wait_for_timeout(300)
        worst = twin.library_at().poles().real.max()
        assert shown.root.evaluate(told) == pytest.approx(worst, rel=1e-6, abs=1e-9)
        assert "the jet at 64 ft" in shown.root.locator(".verdict").inner_text()
