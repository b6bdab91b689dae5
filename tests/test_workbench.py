"""The workbench of Section IV in a browser: panels, idle time, content security policy, speed."""

import json
import statistics
from pathlib import Path

import control
import numpy as np
import pytest

import rlswaim as rl
from standin import MODEL, model_state, opened, table
from workbench_page import EQUATIONS, mode_2, one, picture, to_pixels

POLICY = (
    "default-src 'none'; script-src 'self' blob:; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:"
)
SITE = "http://workbench.test/"


def test_rehearsing_shows_nothing(browser, explorer):
    with opened(browser, explorer) as page:
        page.wait_for_timeout(50)
        before = picture(page), table(page).tolist(), page.evaluate("[location.hash, JSON.stringify(state)]")
        page.evaluate("() => new Promise((done) => setTimeout(() => requestIdleCallback(done), 1500))")
        after = picture(page), table(page).tolist(), page.evaluate("[location.hash, JSON.stringify(state)]")
        assert after == before


class TestPanels:
    def test_responses_are_the_librarys(self, page):
        page.locator("canvas[data-plane=responses]").scroll_into_view_if_needed()
        page.wait_for_function("el.querySelector('[data-plane=responses]').ariaLabel?.includes('theta')")
        label = page.locator("canvas[data-plane=responses]").get_attribute("aria-label")
        words = {part.split(":")[0].split(". ")[-1]: part for part in label.split("; ")}
        loop = rl.rate_attitude(EQUATIONS, K_A=1.8, K_C=10, K_R=0.618, gyro=60)
        theta_c = loop.input_labels.index("theta_c")
        step = control.forced_response(loop[:, theta_c], np.linspace(0, 5, 501), np.full(501, np.pi / 180))
        for name, unit in (("theta", 180 / np.pi), ("q1", 1), ("delta", 180 / np.pi)):
            end = float(words[name].rsplit(" ", 2)[-2])
            at = loop.output_labels.index(name)
            assert end == pytest.approx(np.atleast_2d(step.outputs)[at, -1] * unit, rel=0.01)

    def test_a_click_on_a_pole_opens_its_mode(self, page):
        assert not page.locator("canvas[data-plane=mode]").is_visible()
        one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
        page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
        page.wait_for_function("el.querySelector('[data-plane=mode]').ariaLabel?.includes('mode 2')")
        shares = [float(text.strip(" %")) for text in page.locator(".shares b").all_inner_texts()]
        assert sum(shares) == pytest.approx(100, abs=2)
        assert shares == sorted(shares, reverse=True)

    def test_the_mode_moves_until_it_is_paused(self, page):
        one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
        page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
        page.wait_for_timeout(150)
        before = picture(page, "mode")
        page.wait_for_timeout(150)
        assert picture(page, "mode") != before
        page.get_by_role("button", name="Pause").click()
        page.wait_for_timeout(100)
        before = picture(page, "mode")
        page.wait_for_timeout(150)
        assert picture(page, "mode") == before

    def test_reduced_motion_is_respected(self, browser, explorer):
        with opened(browser, explorer, reduced_motion="reduce") as page:
            page.wait_for_timeout(50)
            one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
            page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
            page.wait_for_timeout(150)
            before = picture(page, "mode")
            page.wait_for_timeout(150)
            assert picture(page, "mode") == before
            assert page.get_by_role("button", name="Pause").is_hidden()

    def test_margins_are_told(self, page):
        words = page.locator(".crossings").inner_text().replace("−", "-")
        assert "Gain margins: " in words
        assert "Phase margins: " in words


def test_works_under_a_policy_without_eval(browser, explorer):
    page = browser.new_context().new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    state = json.dumps([explorer._esm, explorer._css, model_state(explorer)])
    script = f"globalThis.opened = ({MODEL.strip().rstrip(';')})({state});"
    files = {
        SITE: (
            "text/html",
            '<!doctype html><html lang="en"><title>t</title><body><script src="/run.js"></script>',
        ),
        f"{SITE}run.js": ("text/javascript", script),
    }

    def answer(route) -> None:
        kind, text = files.get(route.request.url, ("text/plain", ""))
        route.fulfill(
            body=text, content_type=f"{kind}; charset=utf-8", headers={"Content-Security-Policy": POLICY}
        )

    page.route("**/*", answer)
    page.goto(SITE)
    rows = page.locator("[data-explorer=rate-attitude] table.poles tbody tr")
    rows.first.wait_for()
    assert rows.count() == 8
    page.locator("[data-panel=takeaway] summary").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="Picture (SVG)").click()
    assert Path(download.value.path()).read_text(encoding="utf-8").startswith("<svg")
    assert errors == []
    page.context.close()


def test_speed(page):
    """Compute and draw together; the machine is shared, so the median alone is held to the frame."""
    times = page.evaluate(
        """async () => {
             const { grid } = state.payload.parameters[0];
             const times = [];
             for (let k = 0; k < 80; k++) {
               const done = drawn();
               model.set('K_A', grid[grid.length - 100 + k]);
               times.push((await done).ms);
             }
             return times.slice(20);
           }"""
    )
    assert statistics.median(times) < 8
