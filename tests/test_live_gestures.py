"""What a hand, a keyboard and a link do to a workbench on the built book."""

import csv
import io
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from live_tables import assert_rows, every
from livepage import WORKBENCHES, LivePage, live, poles_of, relative_mismatch


def handles(found: LivePage) -> np.ndarray:
    """Return where the poles stand on the page, px; nan where they are not shown."""
    return np.array(
        found.root.evaluate(
            """root => [...root.querySelectorAll('.handles button')].map(button => {
                 const { x, y, width, height } = button.getBoundingClientRect();
                 return button.hidden ? [NaN, NaN] : [x + width / 2, y + height / 2];
               })"""
        ),
        dtype=float,
    )


def runs(found: LivePage) -> str:
    """Return the parameter that runs along the locus."""
    label = found.root.locator("canvas[data-plane=locus]").get_attribute("aria-label")
    return label.removeprefix("Root locus in ").split()[0]


FAR = 12
"""So many pixels a pole moves before the place of the hand tells the gain to four steps of its slider."""


def farthest(found: LivePage, name: str, values: list[float], at: np.ndarray) -> tuple:
    """Return how far each pole moves (px) at the first value that moves one far, that value, and places."""
    for wanted in values:
        found.moved(name, [wanted], "table.poles")
        to = handles(found)
        far = np.nan_to_num(np.hypot(*(to - at).T), nan=-1.0)
        if far.max() > FAR:
            break
    return far, wanted, to


@every(*WORKBENCHES)
def test_a_pole_is_dragged_and_the_slider_follows_and_undo_takes_it_back(fresh):
    found, page = fresh, fresh.page
    found.redrawn(found.root.get_by_role("button", name="Lock axes").click)
    page.wait_for_timeout(200)
    name = runs(found)
    grid = next(p.grid for p in found.view.parameters if p.name == name)
    start = found.values()[name]
    found.root.locator("canvas[data-plane=locus]").scroll_into_view_if_needed()
    at = handles(found)
    here = found.view.parameters[found.numbers().index(name)].nearest(start)
    beside = [*grid[here + 8 :: 8], *grid[here - 8 : 0 : -8]]
    worth = [v for v in beside if abs(v) > abs(start) / 10]  # small ones lie within a pixel
    far, wanted, to = farthest(found, name, worth, at)
    found.moved(name, [start], "table.poles")
    page.wait_for_timeout(500)
    pole = int(far.argmax())
    assert far[pole] > FAR, "no pole of this locus moves enough to be dragged"
    page.mouse.move(*at[pole])
    page.mouse.down()
    page.mouse.move(*(at[pole] + 0.5 * (to[pole] - at[pole])))
    page.mouse.move(*(at[pole] + 0.9 * (to[pole] - at[pole])))
    found.redrawn(lambda: page.mouse.move(*to[pole]))
    page.mouse.up()
    dragged = found.values()[name]
    assert dragged != start
    assert abs(grid.index(min(grid, key=lambda g: abs(g - dragged))) - grid.index(wanted)) <= 4
    assert_rows(found.name, found.rows("table.poles"), found.library_at())
    found.redrawn(found.root.get_by_role("button", name="undo").click)
    assert found.values()[name] == start
    found.redrawn(found.root.get_by_role("button", name="redo").click)
    assert found.values()[name] == dragged
    found.control(name).locator(".noUi-handle").focus()
    found.redrawn(lambda: page.keyboard.press("Control+z"))
    assert found.values()[name] == start


@every(*WORKBENCHES)
def test_a_link_opens_the_same_view(fresh, visit):
    names = fresh.numbers()
    for name in (names[0], names[-1]):
        grid = next(p.grid for p in fresh.view.parameters if p.name == name)
        fresh.moved(name, [grid[len(grid) // 4 + 1]], "table.poles")
    fresh.root.locator(".bar select").first.select_option(names[1])
    fresh.page.wait_for_function(
        "name => location.hash.includes(`${name}:`) && location.hash.includes('view.locus')", arg=fresh.name
    )
    anchor = fresh.page.evaluate("location.hash")
    with live(visit, fresh.name, anchor) as other:
        other.page.wait_for_function(
            "([root, text]) => root.querySelector('table.poles').textContent === text",
            arg=[other.root.element_handle(), fresh.root.locator("table.poles").text_content()],
        )
        assert other.values() == fresh.values()
        assert other.rows("table.poles") == fresh.rows("table.poles")
        assert other.root.locator(".bar select").first.input_value() == names[1]
    fresh.reset()
    fresh.page.wait_for_function("name => !location.hash.includes(`${name}:`)", arg=fresh.name)


@every(*WORKBENCHES)
def test_downloads_are_the_picture_and_the_table(fresh):
    panel = fresh.root.locator("[data-panel=takeaway]")
    panel.evaluate("panel => (panel.open = true)")

    def saved(name: str) -> str:
        with fresh.page.expect_download() as download:
            panel.get_by_role("button", name=name).click()
        return Path(download.value.path()).read_text(encoding="utf-8")

    picture = saved("Picture (SVG)")
    assert ElementTree.fromstring(picture).tag == "{http://www.w3.org/2000/svg}svg"
    assert "NaN" not in picture
    given = list(csv.DictReader(io.StringIO(saved("Poles (CSV)"))))
    rows = fresh.rows("table.poles")
    for row, (texts, data) in zip(given, rows, strict=True):
        assert (float(row["real (1/s)"]), float(row["imaginary (1/s)"])) == (
            float(data["re"]),
            float(data["im"]),
        )
        assert texts[0].endswith(row["leaves from"])
        assert texts[-1] == row["stability"]
    names: dict = {}
    exec(panel.locator("code").inner_text(), names)  # what a reader would paste
    assert relative_mismatch(poles_of(rows), names["loop"]) < 1e-6
    panel.evaluate("panel => (panel.open = false)")


def reached_by_tab(fresh) -> tuple[list[str], bool]:
    """Press Tab from the first slider to the last panel, and use what is reached: its names, all seen."""
    page, root = fresh.page, fresh.root
    told = """() => { const a = document.activeElement;
      const name = a.getAttribute('aria-label') ?? a.labels?.[0]?.textContent ?? a.textContent.trim();
      return [name, a.tagName, a.matches(':focus-visible')]; }"""
    reached, seen = [], True
    for _ in range(75):
        page.keyboard.press("Tab")
        name, tag, visible = page.evaluate(told)
        seen &= visible
        reached.append(name)
        if tag == "CANVAS" and name.startswith("Root locus"):
            before = fresh.rows("table.poles")
            fresh.redrawn(lambda: page.keyboard.press("PageUp"))
            assert fresh.rows("table.poles") != before
        if "Enter shows its mode" in name and not root.locator("[data-panel=mode]").evaluate("p => p.open"):
            fresh.redrawn(lambda: page.keyboard.press("Enter"))
        if name.startswith("Take away"):
            page.keyboard.press("Enter")
            assert root.locator("[data-panel=takeaway]").evaluate("p => p.open")
        if name.startswith("Keys and gestures"):
            break
    return reached, seen


@every("two-sensor")
def test_by_keyboard_alone(fresh):
    """From the first slider on, Tab reaches sliders, boxes, designs, the plane, a pole and each panel."""
    page, root = fresh.page, fresh.root
    fresh.control("K_A").locator(".noUi-handle").focus()
    before = fresh.rows("table.poles")
    fresh.redrawn(lambda: page.keyboard.press("ArrowRight"))
    assert fresh.rows("table.poles") != before
    fresh.redrawn(lambda: page.keyboard.press("ArrowLeft"))
    assert fresh.rows("table.poles") == before
    reached, seen = reached_by_tab(fresh)
    assert seen, "the focus cannot be seen"
    order = ["K A", "K C", "K R", "K za", "K zb", "station of the sensor a", "station of the sensor b"]
    order += [
        "Figure 19",
        "Reset",
        "Locus in",
        "Origin",
        "Copy link",
        "Desk",
        "Root locus in",
        "zoom in",
        "Lock axes",
    ]
    order += ["pole table", "Pole map", "Responses", "Mode shape", "Take away", "Keys and gestures"]
    places = [next((k for k, name in enumerate(reached) if name.startswith(wanted)), -1) for wanted in order]
    assert [wanted for wanted, at in zip(order, places, strict=True) if at < 0] == [], reached
    assert places == sorted(places), dict(zip(order, places, strict=True))
    assert any("Enter shows its mode" in name for name in reached)
    assert root.locator("[data-panel=mode]").evaluate("p => p.open")
