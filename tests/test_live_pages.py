"""The built pages with live views, the network cut: narrow, dark, still, without scripts."""

from collections.abc import Iterator

import pytest

from live_tables import every
from livepage import MORE, PAGES, SCREENSHOTS, LivePage, live

BEYOND = """panel => [...panel.querySelectorAll('*')]
  .filter(el => el.getClientRects().length && !el.closest('.scroll, pre, .unseen, svg'))
  .filter(el => el.getBoundingClientRect().right > innerWidth + 1)
  .map(el => `${el.tagName}.${el.className}`)"""
GROUND = "c => [...c.getContext('2d').getImageData(c.width - 4, c.height / 2, 1, 1).data]"


@pytest.fixture(scope="module")
def shown(visit, request) -> Iterator[LivePage]:
    """A live view on its page, shared by the tests of one view."""
    with live(visit, request.param) as found:
        yield found


@every(*PAGES)
@pytest.mark.parametrize("width", [1280, 360])
def test_fits_the_page_in_both_themes(shown, width):
    page = shown.page
    page.set_viewport_size({"width": width, "height": 900})
    shown.root.evaluate("root => root.querySelectorAll('details').forEach(panel => (panel.open = true))")
    shown.root.scroll_into_view_if_needed()
    SCREENSHOTS.mkdir(exist_ok=True)
    grounds, over = {}, {}
    for theme in ("dark", "light"):
        page.evaluate("theme => (document.documentElement.dataset.theme = theme)", theme)
        page.wait_for_timeout(250)
        path = SCREENSHOTS / f"page-{shown.name}-{width}-{theme}.png"
        shown.panel.screenshot(path=path, animations="disabled")
        over[theme] = shown.panel.evaluate(BEYOND)
        grounds[theme] = shown.root.locator("canvas").first.evaluate(GROUND)
    wide = page.evaluate("() => document.documentElement.scrollWidth")
    page.set_viewport_size({"width": 1280, "height": 900})
    assert wide <= width
    assert over == {"dark": [], "light": []}
    for theme, (*color, alpha) in grounds.items():
        assert not alpha or (max(color) < 100) == (theme == "dark"), (theme, color)


def test_reduced_motion_is_respected(browser, visit):
    with visit(PAGES["rate-attitude"], plain=True) as (page, outside, errors):
        page.emulate_media(reduced_motion="reduce")
        page.reload()
        root = page.locator("[data-explorer=rate-attitude]")
        root.wait_for()
        root.locator("[data-panel=mode]").evaluate("panel => (panel.open = true)")
        canvas = root.locator("canvas[data-plane=mode]")
        canvas.scroll_into_view_if_needed()
        page.wait_for_timeout(400)
        before = canvas.evaluate("c => c.toDataURL()")
        page.wait_for_timeout(200)
        assert canvas.evaluate("c => c.toDataURL()") == before
        assert root.get_by_role("button", name="Pause").is_hidden()
        assert (outside, errors) == ([], [])


@pytest.mark.parametrize("name", PAGES)
def test_without_scripts_a_still_and_a_line_stand_in(browser, site, name):
    context = browser.new_context(java_script_enabled=False, viewport={"width": 1280, "height": 900})
    page = context.new_page()
    page.goto(f"{site}/{PAGES[name]}")
    line, still = page.locator("noscript p"), page.locator("noscript img[alt='Still of the live view']")
    count = sum(path == PAGES[name] for path in PAGES.values()) + len(MORE.get(PAGES[name], ()))
    assert line.count() == still.count() == count
    for part in (*line.all(), *still.all()):
        assert part.is_visible()
    assert "live where the browser runs scripts" in line.first.inner_text()
    for image in still.all():
        image.scroll_into_view_if_needed()
        box = image.bounding_box()
        assert box["width"] > 400
        assert box["height"] > 200
    context.close()


@every(*PAGES)
def test_with_scripts_no_still_is_seen(shown):
    assert shown.page.locator("img[alt='Still of the live view']").count() == 0
