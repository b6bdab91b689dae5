"""The compensator of a workbench: added, typed, dragged, taken out, in the address, in the copied Python."""

import numpy as np
import pytest
from playwright.sync_api import Page

from rlswaim.explorers.greensite import greensite_explorer
from standin import opened, paired, show, table
from workbench_page import EQUATIONS, VIEWS, one, to_pixels

PANEL = "[data-panel=compensator]"
RING = ".stage .grips button:not([hidden])"


def open_panel(page: Page) -> None:
    page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)


def add(page: Page, *kinds: str) -> None:
    for kind in kinds:
        page.locator(f"{PANEL} select").first.select_option(kind)
        one(page, lambda: page.locator(PANEL).get_by_role("button", name="Add").click())


def type_in(page: Page, row: int, field: int, value: str) -> None:
    box = page.locator(f"{PANEL} li").nth(row).locator("input").nth(field)
    box.fill(value)
    one(page, lambda: box.press("Enter"))


def python_poles(page: Page) -> np.ndarray:
    """Return the poles of the copied Python, run as it stands."""
    page.wait_for_timeout(400)
    names: dict = {}
    exec(page.locator("[data-panel=takeaway] code").text_content(), names)
    return names["loop"].poles()


def assert_like_python(page: Page) -> None:
    ours, theirs = paired(python_poles(page), table(page))
    assert (abs(ours - theirs) <= 1e-7 * np.maximum(1, abs(ours))).all()


@pytest.fixture
def bench(browser, explorer):
    with opened(browser, explorer) as page:
        open_panel(page)
        yield page


@pytest.mark.parametrize("section", [*VIEWS, "Greensite"])
def test_the_copied_python_has_the_poles_shown(browser, section):
    view = greensite_explorer() if section == "Greensite" else VIEWS[section](EQUATIONS)
    with opened(browser, view) as page:
        open_panel(page)
        before = len(table(page))
        if section != "Greensite":
            show(page, K_A=0.7)
        add(page, "notch", "lead", "delay")
        assert len(table(page)) == before + 5
        assert_like_python(page)
        type_in(page, 0, 0, "2,5")
        type_in(page, 2, 1, "4")
        assert len(table(page)) == before + 7
        assert_like_python(page)


class TestPanel:
    def test_sections_are_added_typed_and_removed(self, bench):
        before = table(bench)
        add(bench, "poles")
        assert bench.evaluate("[...el.querySelectorAll('.poles tbody tr')].at(-1).dataset.branch") in (
            "compensator",
            "actuator",
        )
        names = bench.evaluate("[...el.querySelectorAll('.poles tbody tr')].map((row) => row.dataset.branch)")
        assert names.count("compensator") == 2
        type_in(bench, 0, 1, "7")  # beyond its bounds
        assert bench.locator(f"{PANEL} li input").nth(1).input_value() == "1"
        one(bench, lambda: bench.locator(PANEL).get_by_role("button", name="Remove").click())
        assert (table(bench) == before).all()

    def test_a_gain_multiplies_the_loop(self, bench):
        show(bench, K_A=3.6)
        wanted = table(bench)
        show(bench, K_A=1.8)
        add(bench, "pole")
        one(bench, lambda: bench.locator(PANEL).get_by_role("button", name="Remove").click())
        gain = bench.locator(f"{PANEL} label", has_text="gain").locator("input")
        gain.fill("2")
        one(bench, lambda: gain.press("Enter"))
        ours, theirs = paired(table(bench), wanted)
        assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-12)

    def test_more_zeros_than_poles_are_left_out_and_told(self, bench):
        before = table(bench)
        add(bench, "zero")
        assert (table(bench) == before).all()
        assert "more zeros than poles" in bench.locator(f"{PANEL} .told").inner_text()
        add(bench, "pole")
        assert len(table(bench)) == len(before) + 1
        assert "in the path of K_A, before its actuator" in bench.locator(f"{PANEL} .told").inner_text()

    def test_undo_and_reset(self, bench):
        before = table(bench)
        add(bench, "notch")
        bench.wait_for_timeout(500)
        bench.get_by_role("button", name="undo").click()
        bench.wait_for_function("n => el.querySelectorAll('.poles tbody tr').length === n", arg=len(before))
        add(bench, "notch")
        bench.get_by_role("button", name="Reset").click()
        bench.wait_for_function("n => el.querySelectorAll('.poles tbody tr').length === n", arg=len(before))
        assert (table(bench) == before).all()

    def test_a_design_with_it_is_not_the_reports(self, bench):
        assert "Printed roots" in bench.locator(".crossings").first.inner_text()
        add(bench, "notch")
        assert "Printed roots" not in bench.locator(".crossings").first.inner_text()
        assert bench.locator(".buttons [aria-pressed=true]").count() == 0


class TestAddress:
    def test_a_link_brings_it_along(self, browser, explorer, bench):
        add(bench, "notch", "delay")
        bench.wait_for_function("/view.compensator=K_A~1~notch_.*~delay_/.test(location.hash)")
        with opened(browser, explorer, bench.evaluate("location.href")) as other:
            other.wait_for_function("n => el.querySelectorAll('.poles tbody tr').length === n", arg=12)
            assert (table(other) == table(bench)).all()
            assert other.locator(PANEL).evaluate("node => node.open")

    @pytest.mark.parametrize(
        "text", ["K_A~1e308", "K_A~1~pole_1e308", "__proto__~1", "K_A~1~delay_0_0", "%3Cb%3E"]
    )
    def test_nonsense_is_left_out(self, browser, explorer, text):
        with opened(browser, explorer, f"http://view.test/#rate-attitude:view.compensator={text}") as page:
            page.wait_for_function("el.querySelector('output').innerText")
            assert "view.compensator from the address is not one that can be shown" in (
                page.locator("output").inner_text()
            )
            assert len(table(page)) == 8


class TestGrips:
    def test_a_pole_is_dragged_in_the_s_plane(self, bench):
        add(bench, "pole")
        ring = bench.locator(RING).first
        ring.scroll_into_view_if_needed()
        box = ring.bounding_box()
        x, y = to_pixels(bench, -6 + 0j)
        bench.mouse.move(box["x"] + 13, box["y"] + 13)
        bench.mouse.down()
        bench.mouse.move((x + box["x"]) / 2, y, steps=3)
        one(bench, lambda: bench.mouse.move(x, y))
        bench.mouse.up()
        bench.wait_for_timeout(100)
        assert float(bench.locator(f"{PANEL} li input").first.input_value()) == pytest.approx(-6, rel=0.05)
        assert_like_python(bench)

    def test_keys_move_it(self, bench):
        add(bench, "poles")
        before = float(bench.locator(f"{PANEL} li input").first.input_value())
        ring = bench.locator(RING).first
        ring.focus()
        one(bench, lambda: ring.press("ArrowRight"))
        after = float(bench.locator(f"{PANEL} li input").first.input_value())
        assert after == pytest.approx(1.05 * before, rel=1e-3)
        assert "pole of the compensator’s pole pair at" in bench.locator(RING).first.get_attribute(
            "aria-label"
        )

    def test_on_the_bode_diagram_it_goes_with_its_frequency(self, bench):
        bench.evaluate("el.querySelector('[data-panel=frequency]').open = true")
        bench.locator("canvas[data-plane=frequency]").scroll_into_view_if_needed()
        bench.wait_for_timeout(300)
        add(bench, "notch")
        bench.wait_for_timeout(200)
        before = float(bench.locator(f"{PANEL} li input").first.input_value())
        ring = bench.locator("[data-panel=frequency] .grips button:not([hidden])").first
        ring.scroll_into_view_if_needed()
        box = ring.bounding_box()
        bench.mouse.move(box["x"] + 13, box["y"] + 13)
        bench.mouse.down()
        bench.mouse.move(box["x"] + 40, box["y"] + 13)
        one(bench, lambda: bench.mouse.move(box["x"] + 63, box["y"] + 13))
        bench.mouse.up()
        assert float(bench.locator(f"{PANEL} li input").first.input_value()) > 1.3 * before
