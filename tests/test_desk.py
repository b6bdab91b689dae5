"""The desk of a workbench on its page: all in sight together, in panels that are chosen and resized."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import cache

import pytest
from playwright.sync_api import Page

from livepage import PAGES, WORKBENCHES

CHAPTERS = (*WORKBENCHES, "bent-vehicle")
SENSELESS = ["", "52", "52_57", "5_57_", "52_99_map", "52_57_map..poles", "1e3_50_map", "a_b_c"]
SMALL = [(1000, 800), (768, 1024), (360, 740)]
PARTS = {
    "sliders": ".rlswaim-sliders",
    "locus": "canvas[data-plane=locus]",
    "poles": "table.poles",
    "responses": "canvas[data-plane=responses]",
    "map": "canvas[data-plane=map]",
}
IN_SIGHT = """([name, parts]) => {
  const view = document.querySelector(`[data-explorer=${name}]`);
  const panel = view.closest('.widget-vbox');
  return Object.fromEntries(Object.entries(parts).map(([part, at]) => {
    const node = panel.querySelector(at);
    const { left, top, right, bottom, width, height } = node.getBoundingClientRect();
    const cell = (node.closest('.panel') ?? node.closest('.rlswaim-desk')).getBoundingClientRect();
    const whole = left >= 0 && top >= 0 && right <= Math.min(innerWidth, cell.right) + 1 &&
      bottom <= Math.min(innerHeight, cell.bottom) + 1;
    const over = document.elementFromPoint(left + width / 2, top + height / 2);
    const open = node.contains(over) || node.closest('.stage')?.contains(over);
    return [part, { whole, open, width, height }];
  }));
}"""


@contextmanager
def at_desk(browser, plain_site: str, name: str, address: str = "&desk", **size: int) -> Iterator[Page]:
    """Open a workbench at an address on a screen of some size; an error on the page is a failure."""
    page = browser.new_page(viewport={"width": 1280, "height": 800, **size})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    page.goto(f"{plain_site}/{PAGES[name]}#{name}:{address}")
    page.locator(f"[data-explorer={name}] canvas").first.wait_for()
    page.wait_for_timeout(300)
    yield page
    assert errors == []
    page.close()


@pytest.fixture(scope="module")
def sized(browser, plain_site) -> Iterator[Callable[..., Page]]:
    """Return a workbench on a screen of some size, at its top: tests that only look share its page."""
    with ExitStack() as pages:
        opened = cache(lambda name, address: pages.enter_context(at_desk(browser, plain_site, name, address)))

        def at(name: str, width: int, height: int, address: str = "") -> Page:
            page = opened(name, address)
            page.set_viewport_size({"width": width, "height": height})
            page.evaluate("scrollTo(0, 0)")
            page.wait_for_timeout(300)
            return page

        yield at


def address_of(page: Page, name: str) -> str:
    """Return what the address says of a view, once the hand rests."""
    page.wait_for_timeout(400)
    return page.evaluate("decodeURIComponent(location.hash)").partition(f"{name}:")[2]


def is_open(page: Page) -> bool:
    return page.locator(".rlswaim-desk").count() == 1


@pytest.mark.parametrize("size", [(1280, 800), (1920, 1080)], ids=lambda size: "x".join(map(str, size)))
@pytest.mark.parametrize("name", WORKBENCHES)
def test_sliders_locus_poles_responses_and_map_are_in_sight_together(sized, name, size):
    page = sized(name, *size, "&desk")
    found = page.evaluate(IN_SIGHT, [name, PARTS])
    assert {part: (at["whole"], at["open"]) for part, at in found.items()} == dict.fromkeys(
        PARTS, (True, True)
    )
    assert found["locus"]["width"] * found["locus"]["height"] > 0.12 * size[0] * size[1]
    assert min(found[part]["height"] for part in ("responses", "map")) >= 150


def test_a_button_opens_it_and_escape_leaves_with_focus_and_place_kept(browser, plain_site):
    with at_desk(browser, plain_site, "rate-attitude", "K_A=3", width=1280, height=800) as page:
        assert not is_open(page)
        page.get_by_role("button", name="Desk", exact=True).click()
        page.wait_for_timeout(300)
        assert is_open(page)
        before = page.evaluate("scrollY")
        handle = page.locator(".rlswaim-desk [role=slider]").first
        handle.press("ArrowRight")
        assert page.evaluate("getComputedStyle(document.documentElement).overflow") == "hidden"
        page.keyboard.press("Escape")
        page.wait_for_timeout(300)
        assert not is_open(page)
        assert page.evaluate("document.activeElement.getAttribute('role')") == "slider"
        assert abs(page.evaluate("scrollY") - before) <= 2
        assert "view.desk" not in address_of(page, "rate-attitude")
        assert page.locator("[inert]").count() == 0


def test_tab_stays_at_the_desk(browser, plain_site):
    with at_desk(browser, plain_site, "two-sensor") as page:
        page.locator(".rlswaim-desk [role=slider]").first.focus()
        reached = set()
        for _ in range(70):
            page.keyboard.press("Tab")
            at = "a => a === document.body ? 'page' : a.closest('.rlswaim-desk') ? 'desk' : 'behind'"
            reached.add(page.evaluate(f"({at})(document.activeElement)"))
        assert reached <= {"desk", "page"}


def test_panels_are_chosen_and_stand_in_the_address(browser, plain_site):
    name = "single-sensor"
    with at_desk(browser, plain_site, name) as page:
        choices = page.get_by_role("group", name="Panels")
        choices.get_by_role("button", name="Closed-loop poles").click()
        choices.get_by_role("button", name="Mode shape").click()
        page.wait_for_timeout(200)
        assert not page.locator("[data-panel=poles]").is_visible()
        assert page.locator("canvas[data-plane=mode]").is_visible()
        written = address_of(page, name)
        assert written.endswith("view.desk=52_57_map.responses.mode")
    with at_desk(browser, plain_site, name, written) as page:
        assert is_open(page)
        assert not page.locator("[data-panel=poles]").is_visible()
        assert page.locator("canvas[data-plane=mode]").is_visible()
        assert address_of(page, name) == written


def test_panels_are_resized_by_keys_and_by_dragging(browser, plain_site):
    name = "rate-attitude"
    with at_desk(browser, plain_site, name) as page:
        locus = page.locator("canvas[data-plane=locus]")
        width = locus.bounding_box()["width"]
        line = page.get_by_role("separator", name="Width of the locus")
        line.press("ArrowRight")
        line.press("ArrowRight")
        page.wait_for_timeout(200)
        assert line.get_attribute("aria-valuenow") == "56"
        assert locus.bounding_box()["width"] == pytest.approx(width + 0.04 * 1256, abs=2)
        assert page.evaluate("document.querySelector('canvas[data-plane=locus]').width") == pytest.approx(
            locus.bounding_box()["width"], abs=1
        )
        lying = page.get_by_role("separator", name="Height of the first row")
        box = lying.bounding_box()
        x, y = box["x"] + 300, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x, y - 60, steps=4)
        page.mouse.up()
        page.wait_for_timeout(200)
        assert int(lying.get_attribute("aria-valuenow")) < 50
        assert address_of(page, name).startswith(f"view.desk=56_{lying.get_attribute('aria-valuenow')}_")
        for _ in range(60):
            line.press("ArrowLeft")
        assert line.get_attribute("aria-valuenow") == "20"
        lying.dblclick(position={"x": 300, "y": 4})
        assert lying.get_attribute("aria-valuenow") == "57"


def test_a_pole_is_dragged_at_the_desk(browser, plain_site):
    with at_desk(browser, plain_site, "rate-attitude") as page:
        mark = page.locator(".handles button:not([hidden])").first.bounding_box()
        x, y = mark["x"] + mark["width"] / 2, mark["y"] + mark["height"] / 2
        before = page.locator(".widget-hbox input").first.input_value()
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + 12, y - 12, steps=4)
        page.mouse.up()
        page.wait_for_timeout(200)
        assert page.locator(".widget-hbox input").first.input_value() != before


def test_a_layout_without_sense_is_left_out(browser, plain_site):
    """The first is that of a page as it opens, the others come by a change of the address."""
    name = "rate-attitude"
    with at_desk(browser, plain_site, name, f"K_A=2,view.desk={SENSELESS[0]}") as page:
        for K_A, text in enumerate(SENSELESS, start=2):
            page.evaluate("text => { location.hash = text; }", f"{name}:K_A={K_A},view.desk={text}")
            page.wait_for_timeout(100)
            assert float(page.locator(".widget-hbox input").first.input_value()) == K_A
            assert not is_open(page), text
            said = page.locator("output").first.inner_text()
            assert "view.desk from the address is not one that can be shown" in said, text


@pytest.mark.parametrize("size", SMALL, ids=lambda size: "x".join(map(str, size)))
@pytest.mark.parametrize("name", ["rate-attitude", "dual-actuation", "bent-vehicle"])
def test_sliders_stay_in_sight_while_the_view_scrolls(sized, name, size):
    page = sized(name, *size)
    view = page.locator(f"[data-explorer={name}]")
    page.evaluate("view => view.closest('.widget-vbox').scrollIntoView()", view.element_handle())
    page.evaluate("view => scrollBy(0, view.offsetHeight / 2)", view.element_handle())
    page.wait_for_timeout(300)
    stuck = page.evaluate(
        """view => {
          const panel = view.closest('.widget-vbox');
          const boxes = [...panel.querySelectorAll('.rlswaim-sliders > *')];
          const rows = boxes.map((row) => row.getBoundingClientRect());
          const header = document.querySelector('.bd-header-article').getBoundingClientRect().bottom;
          const seen = rows.filter(({ top, bottom }) => top >= header - 1 && bottom < innerHeight);
          const top = Math.min(...seen.map((row) => row.top)) - header;
          const height = Math.max(...seen.map((row) => row.bottom)) - header;
          return { count: seen.length, all: rows.length, top, height };
        }""",
        view.element_handle(),
    )
    assert stuck["count"] >= 1
    assert stuck["top"] <= 4
    assert stuck["height"] <= 0.45 * size[1]
    assert stuck["count"] in (1, stuck["all"])


@pytest.mark.parametrize("name", ["two-sensor", "dual-actuation"])
def test_the_slider_in_use_is_the_one_that_stays_on_a_telephone(browser, plain_site, name):
    with at_desk(browser, plain_site, name, "", width=360, height=740) as page:
        rows = page.locator(".rlswaim-sliders > .widget-hbox")
        rows.nth(2).locator("[role=slider]").press("ArrowRight")
        page.evaluate("document.querySelector('canvas[data-plane=locus]').scrollIntoView()")
        page.wait_for_timeout(300)
        header = page.locator(".bd-header-article").bounding_box()["height"]
        assert rows.nth(2).bounding_box()["y"] == pytest.approx(header, abs=60)
        assert rows.nth(2).locator("[role=slider]").is_visible()


@pytest.mark.parametrize("name", CHAPTERS)
def test_on_a_telephone_a_slider_is_long_and_its_number_stands_under_it(sized, name):
    page = sized(name, 360, 740)
    rows = page.locator(".live-view").first.locator(".widget-hbox")
    for row in rows.all():
        track, box = row.locator(".noUi-target").bounding_box(), row.locator("input").bounding_box()
        assert track["width"] >= 210, "the line, without the handle's halves"
        assert row.locator(".slider-container").bounding_box()["width"] >= 220
        assert box["y"] >= track["y"] + track["height"]
        assert max(track["x"] + track["width"], box["x"] + box["width"]) <= 360


@pytest.mark.parametrize("name", WORKBENCHES)
def test_on_a_telephone_the_pole_table_shows_that_it_scrolls_and_what_each_row_is(sized, name):
    page = sized(name, 360, 740)
    table = page.locator("table.poles").first
    table.scroll_into_view_if_needed()
    box = table.locator("xpath=..")
    assert box.evaluate("b => getComputedStyle(b).backgroundImage").count("gradient") == 4
    box.evaluate("b => b.scrollTo(b.scrollWidth, 0)")
    page.wait_for_timeout(100)
    last = table.locator("tbody tr").first
    assert last.locator("td").last.bounding_box()["x"] + 20 < 360
    assert last.locator("th").bounding_box()["x"] == pytest.approx(box.bounding_box()["x"], abs=1)


@pytest.mark.parametrize("path", ["notation", "12-agreement", "04-rate-and-attitude-feedback"])
def test_on_a_telephone_a_wide_table_shows_that_it_scrolls(browser, site, path):
    page = browser.new_page(viewport={"width": 360, "height": 740})
    page.goto(f"{site}/book/{path}.html")
    boxes = page.locator(".pst-scrollable-table-container")
    wide = [box for box in boxes.all() if box.evaluate("b => b.scrollWidth > b.clientWidth + 1")]
    assert wide or path != "notation"
    for box in wide:
        assert box.evaluate("b => getComputedStyle(b).backgroundImage").count("gradient") == 4
        grounds = "b => [...b.querySelectorAll('td, th, tr')].map(c => getComputedStyle(c).backgroundColor)"
        assert set(box.evaluate(grounds)) == {"rgba(0, 0, 0, 0)"}
    page.close()
