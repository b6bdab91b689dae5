"""The sliders of the comparison's two designs: values, poles of both, one window for both, address, undo."""

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Page

import rlswaim as rl
from rlswaim.explorers import Comparison, comparison_explorer
from standin import SITE, opened, paired

EQUATIONS = rl.printed_equations()
SIDES = ("left", "right")


@pytest.fixture(scope="module")
def compared() -> Comparison:
    return comparison_explorer(EQUATIONS)


@pytest.fixture
def wide(browser, compared) -> Iterator[Page]:
    with opened(browser, compared, viewport={"width": 1280, "height": 900}) as page:
        page.wait_for_timeout(300)
        yield page


def poles(page: Page, side: int) -> np.ndarray:
    rows = page.evaluate(
        """side => [...el.querySelectorAll('.side')[side].querySelectorAll('.poles tbody tr')]
             .map(row => [+row.dataset.re, +row.dataset.im])""",
        side,
    )
    return np.array(rows) @ [1, 1j]


def row(page: Page, side: int, name: str):
    return page.locator(".side").nth(side).locator(f"[data-parameter={name}]")


def put(page: Page, side: int, name: str, text: str) -> None:
    """Type a value into the box of a slider."""
    box = row(page, side, name).locator("input[type=text]")
    box.fill(text)
    box.press("Enter")
    page.wait_for_timeout(100)


@pytest.mark.parametrize("side", [0, 1])
def test_sliders_give_the_librarys_poles_on_their_side_alone(wide, side):
    other = poles(wide, 1 - side)
    put(wide, side, "K_A", "2,5")
    put(wide, side, "gyro", "100")
    row(wide, side, "feedback").locator("select").select_option("total")
    loop = rl.rate_attitude(EQUATIONS, **{**_gains(wide, side), "K_A": 2.5, "gyro": 100})
    found, wanted = paired(poles(wide, side), loop.poles())
    assert abs(found - wanted).max() < 1e-8
    assert (poles(wide, 1 - side) == other).all()


def _gains(page: Page, side: int) -> dict[str, float]:
    read = {name: row(page, side, name).locator("input[type=text]").input_value() for name in ("K_C", "K_R")}
    return {name: float(text) for name, text in read.items()}


def test_a_slider_moves_by_keys_and_its_box_keeps_to_the_range(wide):
    slider = row(wide, 0, "K_C").locator("input[type=range]")
    put(wide, 0, "K_C", "7")
    slider.press("ArrowRight")
    assert row(wide, 0, "K_C").locator("input[type=text]").input_value() == "8"
    slider.press("Shift+ArrowRight")
    assert row(wide, 0, "K_C").locator("input[type=text]").input_value() == "10"
    put(wide, 0, "K_C", "1e308")
    assert row(wide, 0, "K_C").locator("input[type=text]").input_value() == "100"
    put(wide, 0, "K_C", "nonsense")
    assert row(wide, 0, "K_C").locator("input[type=text]").input_value() == "100"
    slider.press("Home")
    assert row(wide, 0, "K_C").locator("input[type=text]").input_value() == "0.1"


def scales(page: Page) -> list[list[float]]:
    """Return where the picture of each side has its real axis and how long 1/s is, from two poles."""
    return page.evaluate(
        """() => [...el.querySelectorAll('.side')].map((side) => {
             const rows = [...side.querySelectorAll('.poles tbody tr')].map(({ dataset }) => dataset);
             const places = [...side.querySelectorAll('.handles button')].map((button) => {
               const { x, y } = button.getBoundingClientRect();
               const own = side.querySelector('canvas[data-plane=locus]').getBoundingClientRect();
               return button.hidden ? null : [x - own.x, y - own.y];
             });
             const at = rows.map(({ re, im }, i) => [+re, +im, places[i]]).filter(([, , place]) => place);
             at.sort((a, b) => a[0] - b[0]);
             const [a, b] = [at[0], at.at(-1)];
             const scale = (b[2][0] - a[2][0]) / (b[0] - a[0]);
             return [scale, a[2][0] - scale * a[0], a[2][1] + scale * a[1]];
           })"""
    )


def test_both_planes_have_the_same_scales_wherever_they_go(wide):
    def same() -> list[float]:
        wide.wait_for_timeout(250)
        left, right = scales(wide)
        assert left == pytest.approx(right, abs=1.0)
        return left

    start = same()
    put(wide, 1, "K_C", "100")
    wider = same()
    assert wider[0] < 0.7 * start[0]
    wide.locator(".side").first.get_by_role("button", name="zoom in").click()
    closer = same()
    assert closer[0] > 1.2 * wider[0]
    wide.locator(".side").nth(1).get_by_role("button", name="Fit").click()
    assert same() == pytest.approx(wider, abs=1.0)


def test_undo_and_address_keep_a_moved_slider(browser, compared, wide):
    before = poles(wide, 1)
    put(wide, 1, "K_R", "0.3")
    wide.wait_for_timeout(600)
    moved = poles(wide, 1)
    assert abs(moved - before).max() > 1e-3
    address = wide.evaluate("location.hash")
    assert "right-" in address
    assert "K_R=0.3" in address
    with opened(browser, compared, f"{SITE}{address}", viewport={"width": 1280, "height": 900}) as page:
        page.wait_for_timeout(400)
        assert (poles(page, 1) == moved).all()
        assert row(page, 1, "K_R").locator("input[type=text]").input_value() == "0.3"
    wide.locator(".side").nth(1).get_by_role("button", name="undo").click()
    wide.wait_for_timeout(200)
    assert (poles(wide, 1) == before).all()
    assert row(wide, 1, "K_R").locator("input[type=text]").input_value() != "0.3"


def test_sliders_are_long_enough_on_a_phone(browser, compared):
    with opened(browser, compared, viewport={"width": 360, "height": 740}) as page:
        page.wait_for_timeout(200)
        widths = page.evaluate("() => [...el.querySelectorAll('input[type=range]')].map(s => s.clientWidth)")
        assert len(widths) >= 8
        assert min(widths) >= 220
        assert page.evaluate("() => document.documentElement.scrollWidth") <= 360
