"""What is asked of a loop on a workbench: told to hold or not, hatched in the s plane, in the address."""

import numpy as np
import pytest
from playwright.sync_api import Page

from livepage import number
from rlswaim.explorers.greensite import greensite_explorer
from standin import opened, show, table
from workbench_page import one, picture

PANEL = "[data-panel=requirements]"


def row(page: Page, kind: str):
    return page.locator(f"{PANEL} [data-asked={kind}]")


def ask(page: Page, kind: str, bound: float) -> str:
    box = row(page, kind).locator("input[type=text]")
    box.fill(f"{bound:g}")
    one(page, lambda: box.press("Enter"))
    return row(page, kind).locator(".reading").inner_text()


@pytest.fixture
def bench(browser):
    with opened(browser, greensite_explorer()) as page:
        page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)
        yield page


def test_each_holds_up_to_what_the_loop_has(bench):
    poles = table(bench)
    zeta = (-poles.real / abs(poles)).min()
    sigma = (-poles.real).min()
    limits = {"zeta": zeta, "sigma": sigma, "gain": 5.99, "phase": 30.2}
    for kind, limit in limits.items():
        assert ask(bench, kind, 0.98 * limit).startswith("holds: ")
        said = ask(bench, kind, 1.02 * limit)
        assert said.startswith("does not hold: ")
        assert number(said.split(": ")[1].split(" ")[0].strip("°")) == pytest.approx(limit, rel=0.01)
    settling = np.log(50) / sigma
    assert ask(bench, "settling", 1.02 * settling).startswith("holds")
    assert ask(bench, "settling", 0.98 * settling).startswith("does not hold")
    overshoot = 100 * np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2))
    assert ask(bench, "overshoot", overshoot - 0.5).startswith("does not hold")
    assert ask(bench, "overshoot", overshoot + 0.2).startswith("holds")
    summary = bench.locator(f"{PANEL} .told").first.inner_text()
    assert summary.startswith("Requirements: 5 of 6 not met")


def test_the_region_is_hatched_and_goes_again(bench):
    before = picture(bench)
    ask(bench, "sigma", 2)
    hatched = picture(bench)
    assert hatched != before
    one(bench, lambda: row(bench, "sigma").locator("input[type=checkbox]").uncheck())
    assert picture(bench) == before


def test_words_follow_the_sliders(bench):
    assert ask(bench, "phase", 20).startswith("holds")
    show(bench, k=100.0)
    assert row(bench, "phase").locator(".reading").inner_text() == "does not hold: the loop is not stable"


def test_a_link_brings_them_along(browser, bench):
    ask(bench, "zeta", 0.25)
    ask(bench, "phase", 45)
    bench.wait_for_function("location.hash.includes('view.requirements=zeta_0.25~phase_45')")
    with opened(browser, greensite_explorer(), bench.evaluate("location.href")) as other:
        other.wait_for_function("panel => el.querySelector(panel).open", arg=PANEL)
        other.wait_for_timeout(200)
        assert row(other, "zeta").locator("input[type=text]").input_value() == "0.25"
        assert row(other, "phase").locator(".reading").inner_text().startswith("does not hold")


@pytest.mark.parametrize("text", ["zeta_2", "x_1", "__proto___1", "sigma_1e308", "zeta_NaN"])
def test_nonsense_is_left_out(browser, text):
    with opened(
        browser, greensite_explorer(), f"http://view.test/#greensite:view.requirements={text}"
    ) as page:
        page.wait_for_function("el.querySelector('output').innerText")
        assert (
            "view.requirements from the address is not one that can be shown"
            in page.locator("output").inner_text()
        )


def test_required_margins_are_hatched_in_the_nichols_diagram(bench):
    bench.evaluate("el.querySelector('[data-panel=frequency]').open = true")
    bench.locator("canvas[data-plane=frequency]").scroll_into_view_if_needed()
    bench.locator("[data-panel=frequency] select").first.select_option("nichols")
    bench.wait_for_timeout(300)
    before = picture(bench, "frequency")
    ask(bench, "phase", 40)
    bench.locator("canvas[data-plane=frequency]").scroll_into_view_if_needed()
    bench.wait_for_timeout(300)
    assert picture(bench, "frequency") != before
