"""The frequency panel of a workbench: its pictures, its words, its links with the locus, its gestures."""

import re
from pathlib import Path
from xml.etree import ElementTree

import control
import numpy as np
import pytest
from playwright.sync_api import Page

from livepage import number
from rlswaim.explorers.greensite import greensite_explorer
from rlswaim.practice.greensite import greensite
from rlswaim.practice.margins import margins
from standin import opened, show
from workbench_page import EQUATIONS, VIEWS, one, picture, to_pixels

PANEL = "[data-panel=frequency]"
CANVAS = "canvas[data-plane=frequency]"
GAINS = ["K_p", "K_d", "K_z", "K_zdot"]


def open_panel(page: Page, kind: str = "bode") -> None:
    page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)
    page.locator(CANVAS).scroll_into_view_if_needed()
    page.locator(f"{PANEL} select").first.select_option(kind)
    page.wait_for_function(f"el.querySelector('{CANVAS}').ariaLabel?.includes('loop cut at')")
    page.wait_for_timeout(250)


def words(page: Page) -> str:
    return page.locator(f"{PANEL} .told").inner_text().replace("−", "-")


def box_of(page: Page) -> dict:
    return page.locator(CANVAS).bounding_box()


@pytest.fixture
def bench(browser):
    """Greensite's loop, which is stable."""
    with opened(browser, greensite_explorer(), accept_downloads=True) as page:
        open_panel(page)
        yield page


def cut(page: Page) -> control.StateSpace:
    """Return the library's open loop at the sliders."""
    state = page.evaluate("state")
    return greensite(**{name: state["k"] * state[name] for name in GAINS})


class TestWords:
    def test_margins_are_the_librarys_and_the_governing_one_is_first(self, bench):
        found = margins(cut(bench))
        said = words(bench)
        phase = re.search(r"Governing phase margin: (\S+)° \((.+?), ω (\S+) rad/s\)", said)
        nearest = min(found.phase, key=lambda m: abs(m.deg))
        assert (number(phase[1]), number(phase[3])) == pytest.approx((nearest.deg, nearest.omega), rel=0.01)
        gain = re.search(r"Governing gain margin: (\S+) dB \((.+?), ω (\S+) rad/s\)", said)
        nearest = min(found.gain, key=lambda m: abs(m.dB))
        assert (number(gain[1]), number(gain[3])) == pytest.approx((nearest.dB, nearest.omega), rel=0.01)
        assert phase[2] == gain[2] == "rigid body"
        delay = re.search(r"Delay margin: (\S+) s", said)
        assert number(delay[1]) == pytest.approx(min(m.delay for m in found.phase), rel=0.01)

    def test_a_margin_at_a_mode_has_its_name(self, browser):
        with opened(browser, greensite_explorer()) as page:
            open_panel(page)
            show(page, omega=101)
            assert re.search(r"dB \(mode 1, ω 19\S* rad/s\)", words(page))

    def test_an_unstable_loop_has_no_margins(self, bench):
        show(bench, k=100.0)
        assert words(bench) == "No margins: the closed loop is not stable."

    def test_without_gain_there_is_no_loop(self, browser, explorer):
        with opened(browser, explorer) as page:
            open_panel(page)
            show(page, K_A=0.0)
            assert words(page) == "K_A = 0: nothing is fed back, so there is no loop to cut."

    def test_the_picture_is_told_with_its_lobes(self, browser, explorer):
        with opened(browser, explorer) as page:
            open_panel(page)
            label = page.locator(CANVAS).get_attribute("aria-label").replace("−", "-")
            assert label.startswith("Bode diagram of the loop cut at K_A = 1.8. No margins")
            for mode, (re_, im) in {"mode 1": (-0.01178, 1.15037), "mode 2": (-0.03072, 3.05103)}.items():
                told = re.search(rf"{mode}: ω (\S+) rad/s: \+(\S+) dB", label)
                assert number(told[1]) == pytest.approx(im, rel=0.01)
                assert number(told[2]) > 20, re_


class TestLinks:
    def test_a_frequency_is_marked_in_all_pictures_and_on_the_locus(self, bench):
        open_panel(bench, "all")
        box = box_of(bench)
        before = picture(bench, "frequency")
        bench.mouse.move(box["x"] + 200, box["y"] + 80)
        bench.mouse.move(box["x"] + 201, box["y"] + 80)
        readout = bench.locator(f"{PANEL} .reading").inner_text().replace("−", "-")
        omega, dB, degrees = map(number, re.fullmatch(r"ω (\S+) rad/s: (\S+) dB, (\S+)°", readout).groups())
        value = complex(cut(bench)(1j * omega))
        assert dB == pytest.approx(20 * np.log10(abs(value)), abs=0.15)
        assert (degrees - np.degrees(np.angle(value))) % 360 == pytest.approx(0, abs=1) or (
            degrees - np.degrees(np.angle(value))
        ) % 360 == pytest.approx(360, abs=1)
        assert picture(bench, "frequency") != before
        bench.mouse.move(box["x"] + 200, 1)
        assert bench.locator(f"{PANEL} .reading").inner_text() == ""
        assert picture(bench, "frequency") == before

    def test_the_axis_of_the_locus_reads_a_frequency_too(self, bench):
        bench.locator("canvas[data-plane=locus]").scroll_into_view_if_needed()
        x, y = to_pixels(bench, 3j)
        bench.mouse.move(x - 40, y)
        assert bench.locator("[data-spot=frequency]").is_hidden()
        bench.mouse.move(x + 2, y)
        assert bench.locator("[data-spot=frequency]").is_visible()
        read = bench.locator(f"{PANEL} .reading").text_content()
        assert number(re.match(r"ω (\S+) rad/s", read)[1]) == pytest.approx(3, rel=0.02)

    @pytest.mark.parametrize("section", VIEWS)
    def test_every_locus_has_its_pictures(self, browser, section):
        with opened(browser, VIEWS[section](EQUATIONS), viewport={"width": 1280, "height": 900}) as page:
            open_panel(page, "all")
            lists = page.locator(".bar select").first
            for name in lists.locator("option").evaluate_all("all => all.map((o) => o.value)"):
                lists.select_option(name)
                page.wait_for_timeout(220)
                label = page.locator(CANVAS).get_attribute("aria-label")
                assert "NaN" not in label
                assert "loop cut at" in label


class TestGestures:
    @pytest.mark.parametrize(("kind", "lowest"), [("bode", 0.5), ("nichols", 0.88)])
    def test_dragged_up_the_curve_raises_the_gain(self, bench, kind, lowest):
        open_panel(bench, kind)
        box = box_of(bench)
        at = found_on_curve(bench, box, 0.3, lowest)
        bench.mouse.move(*at)
        bench.mouse.down()
        bench.mouse.move(at[0], at[1] - 8)
        one(bench, lambda: bench.mouse.move(at[0], at[1] - 20))
        bench.mouse.up()
        assert bench.evaluate("state.k") > 1.2

    def test_the_held_point_follows_the_pointer_in_decibels(self, bench):
        before = bench.evaluate("state.k")
        box = box_of(bench)
        x, y = found_on_curve(bench, box, 0.4)
        each = []
        bench.mouse.move(x, y)
        bench.mouse.down()
        for step in (-10, -20):
            moved = step + box["y"] - box_of(bench)["y"]  # words above may take a line more
            one(bench, lambda step=step: bench.mouse.move(x, y + step))
            each.append(np.log(bench.evaluate("state.k") / before) / moved)
        bench.mouse.up()
        assert each[1] == pytest.approx(each[0], rel=0.01)
        assert each[0] < 0

    def test_a_finger_drags_it_too(self, browser):
        with opened(browser, greensite_explorer(), has_touch=True) as page:
            open_panel(page)
            box = box_of(page)
            x, y = found_on_curve(page, box, 0.4)
            client = page.context.new_cdp_session(page)
            point = lambda dy: [{"x": x, "y": y + dy}]  # noqa: E731
            client.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": point(0)})
            for dy in (-8, -16, -24):
                client.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": point(dy)})
            client.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
            page.wait_for_function("state.k > 1.2")

    def test_keys_step_the_gain_and_the_marked_frequency(self, bench):
        bench.locator(CANVAS).focus()
        before = bench.evaluate("state.k")
        one(bench, lambda: bench.keyboard.press("ArrowUp"))
        assert bench.evaluate("state.k") > before
        read = []
        for _ in range(6):
            bench.keyboard.press("ArrowRight")
            read.append(number(bench.locator(f"{PANEL} .reading").inner_text().split()[1]))
        assert read == sorted(read)
        assert read[0] < read[-1]

    def test_undo_takes_a_drag_back(self, bench):
        x, y = found_on_curve(bench, box_of(bench), 0.4)
        bench.mouse.move(x, y)
        bench.mouse.down()
        bench.mouse.move(x, y - 10)
        one(bench, lambda: bench.mouse.move(x, y - 25))
        bench.mouse.up()
        assert bench.evaluate("state.k") != 1
        bench.get_by_role("button", name="undo").click()
        bench.wait_for_function("state.k === 1")


def found_on_curve(page: Page, box: dict, share: float, lowest: float = 0.5) -> tuple[float, float]:
    """Return a place of the curve on the page, found by its ink in a column of the picture."""
    found = page.evaluate(
        """([canvas, share, lowest]) => {
             const node = el.querySelector(canvas);
             const g = node.getContext('2d');
             const ratio = node.width / node.clientWidth;
             const first = Math.round(share * node.width);
             for (let x = first; x < node.width - 20; x += 3) {
               const column = g.getImageData(x, 0, 1, node.height).data;
               const dark = (y) =>
                 column[4 * y + 3] > 200 && column[4 * y] + column[4 * y + 1] + column[4 * y + 2] < 150;
               for (let y = 14; y < lowest * node.height; y++)
                 if (dark(y) && dark(y + 1) && !dark(y + 8) && !dark(y - 8)) return [x / ratio, y / ratio];
             }
             return null;
           }""",
        [CANVAS, share, lowest],
    )
    return box["x"] + found[0], box["y"] + found[1]


class TestTakeAway:
    def test_the_picture_is_svg_with_its_units(self, bench):
        open_panel(bench, "all")
        with bench.expect_download() as download:
            bench.locator(PANEL).get_by_role("button", name="Picture (SVG)").click()
        text = Path(download.value.path()).read_text(encoding="utf-8")
        root = ElementTree.fromstring(text)
        space = "{http://www.w3.org/2000/svg}"
        assert "NaN" not in text
        shown = {node.text for node in root.iter(f"{space}text")}
        assert {"ω (rad/s)", "|L| (dB)", "phase (°)", "phase of L (°)", "Re L", "Im L", "mode 1"} <= shown
        assert "Governing phase margin" in root.find(f"{space}title").text
        assert download.value.suggested_filename.startswith("greensite_")

    def test_a_link_opens_the_same_picture(self, browser, bench):
        open_panel(bench, "nichols")
        bench.wait_for_function("location.hash.includes('view.frequency=nichols')")
        with opened(browser, greensite_explorer(), bench.evaluate("location.href")) as other:
            other.wait_for_function("panel => el.querySelector(panel).open", arg=PANEL)
            other.locator(CANVAS).scroll_into_view_if_needed()  # a panel is drawn while it is seen
            kind = f"el.querySelector('{PANEL} select').value"
            other.wait_for_function(f"{kind} === 'nichols'")

    def test_an_address_that_names_no_picture_is_told(self, browser):
        address = "http://view.test/#greensite:view.frequency=%3Cb%3E"
        with opened(browser, greensite_explorer(), address) as page:
            page.wait_for_function("el.querySelector('output').innerText")
            assert "view.frequency from the address is not one that can be shown" in (
                page.locator("output").inner_text()
            )


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1280])
def test_fits_the_page(browser, width, theme):
    with opened(browser, greensite_explorer(), viewport={"width": width, "height": 900}) as page:
        page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
        open_panel(page, "all")
        assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_closed_it_costs_nothing(browser, explorer):
    with opened(browser, explorer) as page:
        page.wait_for_timeout(100)
        assert not page.locator(PANEL).evaluate("node => node.open")
        assert page.evaluate(f"el.querySelector('{CANVAS}').style.height") == ""
