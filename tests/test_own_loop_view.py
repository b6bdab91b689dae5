"""The view of one's own loop in Chromium: typed, stepped, undone, shared, copied."""

import control
import numpy as np
import pytest

import rlswaim as rl
from own_loops import LOOPS
from rlswaim.explorers.gallery import gallery
from rlswaim.explorers.own_loop import loop_text
from standin import opened, paired, show, table

START = control.tf([1], [1, 2, 2, 0])


@pytest.fixture(scope="module")
def page(browser):
    with opened(browser, rl.explore(START)) as page:
        page.evaluate("[...el.querySelectorAll('details')].forEach((panel) => (panel.open = true))")
        yield page


def type_in(page, text):
    """Type a loop and wait until it has been taken, or refused."""
    page.locator("textarea").fill(text)
    page.wait_for_function("(text) => model.get('loop') === text", arg=text)
    page.wait_for_timeout(250)


def assert_poles(page, loop, k, relative=1e-8):
    ours, theirs = paired(table(page), rl.root_locus(loop, [k]).roots[0])
    assert (abs(ours - theirs) <= relative * np.maximum(abs(theirs), 1e-6)).all(), (ours, theirs)


def test_the_contract(page):
    assert page.locator("[data-explorer=own-loop] table.poles").count() == 1
    heads = page.locator("table.poles thead").inner_text().split("\t")
    assert [head.strip() for head in heads][1:] == [
        "real (1/s)",
        "imaginary (1/s)",
        "ω (rad/s)",
        "ζ",
        "stability",
    ]


def test_the_gain_and_a_typed_loop(page):
    show(page, k=2.5)
    assert_poles(page, START, 2.5)
    type_in(page, "5 (s+1)/(s (s+2) (s^2 + 2 s + 5))")
    assert_poles(page, ([-1], [0, -2, -1 + 2j, -1 - 2j], 5.0), 2.5)
    assert "read as zeros, poles, gain, continuous: 4 poles, 1 zero" in page.locator(".form").inner_text()


def test_a_discrete_loop_is_judged_by_the_unit_circle(page):
    type_in(page, "1/((z-1)(z-0.5))")
    show(page, k=0.3)
    assert page.locator(".verdict").inner_text().startswith("Stable: all roots lie within the unit circle")
    assert (
        "unit circle crossed at 0.5 (angle 0.7227 rad, to the outside)"
        in page.locator(".crossings").inner_text()
    )
    heads = page.locator("table.poles thead").inner_text()
    assert "rad/sample" in heads
    assert "1/s" not in heads
    assert_poles(page, control.tf([1], [1, -1.5, 0.5], True), 0.3)
    show(page, k=0.6)
    assert page.locator(".verdict").inner_text().startswith("Unstable")


def test_what_is_wrong_is_told_and_the_loop_before_stays(page):
    type_in(page, "1/(s^2+s+1)")
    before = table(page)
    type_in(page, "A = [1 2; 3]\nB = 1\nC = 1")
    assert page.locator(".wrong").inner_text() == (
        "A, row 2: got 1 numbers, wanted 2, as in row 1. The loop before is shown."
    )
    assert page.locator("textarea").get_attribute("aria-invalid") == "true"
    assert (table(page) == before).all()
    type_in(page, "1/(s^2+s+2)")
    assert page.locator(".wrong").inner_text() == ""


def test_a_dragged_pole_sets_the_gain_and_undo_goes_back(page):
    type_in(page, "1/(s (s^2 + 2 s + 2))")
    show(page, k=1.25)
    before = page.evaluate("model.get('k')")
    page.wait_for_timeout(600)
    page.locator("canvas[data-plane=locus]").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function("(before) => model.get('k') !== before", arg=before)
    page.get_by_role("button", name="undo").click()
    page.wait_for_function("(before) => model.get('k') === before", arg=before)


@pytest.mark.parametrize("case", gallery(), ids=lambda case: case.name)
def test_the_gallery(page, case):
    """Each button loads its loop, whose poles are the library's, and says what is right."""
    page.get_by_role("button", name=case.name, exact=True).click()
    page.wait_for_function("(text) => model.get('loop') === text", arg=loop_text(case.system))
    page.wait_for_timeout(300)
    assert page.locator(".case").inner_text() == case.line()
    condition = rl.root_locus(case.system, [case.k]).condition[0]
    assert_poles(page, case.system, case.k, 1e-8 if condition[np.isfinite(condition)].max() < 1e6 else 1e-5)


@pytest.mark.parametrize("name", ["twelve states", "discrete, factors", "six at z = 1", "biproper states"])
def test_link_and_python_give_the_loop_again(browser, page, name):
    text = loop_text(LOOPS[name])
    type_in(page, text)
    show(page, k=0.123456789)
    page.wait_for_timeout(400)
    names: dict = {}
    exec(page.locator("[data-panel=takeaway] code").inner_text(), names)
    ours, theirs = paired(table(page), names["locus"].roots[0])
    assert (abs(ours - theirs) <= 1e-6 * np.maximum(abs(theirs), 1e-6)).all()
    mine, again = (rl.root_locus(loop, [0.5]) for loop in (LOOPS[name], names["loop"]))
    assert (mine.poles == again.poles).all()
    with opened(browser, rl.explore(START), page.url) as other:
        other.wait_for_timeout(300)
        assert other.evaluate("model.get('loop')") == text
        assert (table(other) == table(page)).all()


def test_refused():
    with pytest.raises(
        ValueError, match=r"order of the loop in own-loop explorer: got 31, wanted at most 30"
    ):
        rl.explore(([], [-1.0] * 31, 1.0))
    with pytest.raises(
        ValueError, match="k in own-loop explorer: got 1e\\+31, wanted at most 1e\\+30 in size"
    ):
        rl.explore(START, k=1e31)
    with pytest.raises(TypeError, match="root_locus: got int, wanted a StateSpace"):
        rl.explore(3)
    with pytest.raises(ValueError, match="got a numerator of order 2 over one of order 1"):
        rl.explore(control.tf([1, 6, 5], [1, 2]))
