"""From the top of each page its first live view is in reach: within two screens, or by a button."""

import pytest

from livepage import PAGES

FIRST = sorted(set(PAGES.values()))
COUNT_FORMULAS = """addEventListener('rlswaim:drawn', () => {
  globalThis.formulas ??= document.querySelectorAll('mjx-container').length;
}, true);"""


@pytest.mark.parametrize("path", FIRST)
def test_the_first_view_is_in_reach_and_comes_before_the_formulas(browser, site, path):
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.add_init_script(COUNT_FORMULAS)
    page.goto(f"{site}/{path}")
    page.wait_for_function("() => document.querySelectorAll('mjx-container').length > 3")
    assert page.evaluate("formulas") == 0
    view = page.locator(".live-view").first
    view.wait_for()
    button = page.locator("a.to-view")
    if button.count() == 0:
        assert view.bounding_box()["y"] < 1600
    else:
        assert button.bounding_box()["y"] < 800
        button.click()
        page.wait_for_timeout(300)
        assert 0 <= view.bounding_box()["y"] < 800
    page.close()


def test_the_first_page_moves_at_once_and_leads_to_a_workbench(browser, site):
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"{site}/book/preface.html")
    loop = page.locator("[data-explorer=moving-loop]")
    loop.wait_for()
    assert loop.locator("canvas").bounding_box()["y"] < 600
    before = loop.locator("output").inner_text()
    page.wait_for_function(
        "before => document.querySelector('.rlswaim-moving output').textContent !== before", arg=before
    )
    loop.get_by_role("button", name="Pause").click()
    gain = loop.locator("output").inner_text()
    loop.get_by_role("link", name="Move all gains in chapter IV").click()
    page.wait_for_url("**/04-rate-and-attitude-feedback.html#**")
    page.locator("[data-explorer=rate-attitude] canvas").first.wait_for()
    page.wait_for_timeout(300)
    assert float(page.locator(".widget-hbox input").first.input_value()) == float(gain)
    assert 0 <= page.locator(".live-view").first.bounding_box()["y"] < 400
    page.close()


def test_the_comparison_scrolls_to_itself_when_its_link_is_opened(browser, site):
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"{site}/{PAGES['comparison']}#comparison:left=3,right=8")
    view = page.locator("[data-explorer=comparison]")
    view.locator("canvas").first.wait_for()
    page.wait_for_timeout(500)
    assert -100 <= view.bounding_box()["y"] < 400
    assert "A shared state was opened." in view.locator("output").first.inner_text()
    page.close()
