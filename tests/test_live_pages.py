"""Every live view on the built book, the network cut: what the pages show is what the library computes."""

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from livepage import (
    ASCENT,
    BOOSTER,
    EQUATIONS,
    PAGES,
    ROWS,
    SCREENSHOTS,
    WORKBENCHES,
    LivePage,
    library,
    live,
    number,
    poles_of,
    relative_mismatch,
)
from rlswaim.explorers import ascent, designs
from rlswaim.explorers.presets import corrected_designs
from rlswaim.loops.rigid_body_design import rigid_body, rigid_design
from rlswaim.vehicle import trajectory

SECTIONS = dict(zip(WORKBENCHES, ("IV", "V", "VI", "VII"), strict=True))
REPRODUCED = {"Figure 8", "Figure 11", "Eq. 78", "Eq. 80", "Eq. 82"}
"""Designs whose printed roots are those of their gains; the others' are errata of the report."""
SLID = ("bent-vehicle", "trajectory", "coupling", *WORKBENCHES)
TABLES = {**dict.fromkeys(PAGES, "table.poles"), "bent-vehicle": "table.values", "trajectory": "table.values"}
"""The table that tells the view in text."""


@pytest.fixture(scope="module")
def shown(visit, request) -> Iterator[LivePage]:
    """A live view on its page, shared by the tests of one view."""
    with live(visit, request.param) as found:
        yield found


@pytest.fixture
def fresh(shown) -> LivePage:
    """The view back at its start."""
    shown.reset()
    return shown


def every(*names: str):
    """Run a test on these views, each on one page for all tests."""
    return pytest.mark.parametrize("shown", names, indirect=True)


# ---- what a table shows, against the library


def assert_loads(rows, view) -> None:
    texts, data = rows[-1]
    for text, (row, wanted) in zip(texts[2:], view.loads().items(), strict=True):
        assert float(data[row]) == pytest.approx(wanted, rel=1e-6, abs=1e-6)
        assert number(text) == pytest.approx(wanted, rel=1e-3, abs=1e-6)


def assert_flight(rows, view) -> None:
    upright, level = (float(v) for v in view.values().values())
    known = upright in ascent.UPRIGHT and level in ascent.LEVEL
    flown = trajectory.fly(ASCENT, trajectory.turn(upright, level), ascent.TIMES)
    for texts, data in rows[:3]:
        name = data["quantity"]
        wanted = flown.at(BOOSTER.flight.t)[name]
        off = 0 if known else 1.3 * view.payload["accuracy"][name]
        assert abs(float(data["value"]) - wanted) <= 0.5 * 10.0 ** -ascent.CURVES[name] * 1.01 + off
        assert number(texts[1]) == pytest.approx(float(data["value"]), rel=1e-3)
        assert number(texts[2]) == pytest.approx(getattr(BOOSTER.flight, name), rel=1e-3)
    _, size = view.trajectory().peak
    assert float(rows[3][1]["value"]) == pytest.approx(size, rel=0.02)


def assert_rows(name: str, rows, view) -> None:
    """Check the text form of a view against the library at the same values."""
    if name == "bent-vehicle":
        assert_loads(rows, view)
    elif name == "trajectory":
        assert_flight(rows, view)
    else:
        loop = view.vehicle() if name == "coupling" else view.closed_loop()
        assert relative_mismatch(poles_of(rows), loop) < 1e-6, view


@every(*SLID)
def test_each_slider_to_both_ends_by_the_keyboard(fresh):
    for name in fresh.numbers():
        fresh.reset()
        grid = next(p.grid for p in fresh.view.parameters if p.name == name)
        for end in ("Home", "End"):
            handle = fresh.control(name).locator(".noUi-handle")
            if fresh.values()[name] == grid[0 if end == "Home" else -1]:
                fresh.moved(name, [grid[len(grid) // 3]], TABLES[fresh.name])
            handle.focus()
            fresh.redrawn(lambda handle=handle, end=end: handle.press(end))
            limit = handle.get_attribute("aria-valuemin" if end == "Home" else "aria-valuemax")
            assert handle.get_attribute("aria-valuenow") == limit
            view = fresh.library_at()
            assert getattr(view, name) == grid[0 if end == "Home" else -1]
            assert_rows(fresh.name, fresh.rows(TABLES[fresh.name]), view)


@every(*SLID)
def test_each_slider_to_ten_random_places(fresh):
    rng = np.random.default_rng(1964)
    for p in fresh.view.parameters:
        if isinstance(p.grid[0], str):
            continue
        fresh.reset()
        here = fresh.values()
        places = [v for v in rng.choice(p.grid, 11, replace=False).tolist() if v != here[p.name]][:10]
        for value, rows in zip(places, fresh.moved(p.name, places, TABLES[fresh.name]), strict=True):
            view = fresh.library_at({**here, p.name: type(p.grid[0])(value)})
            assert_rows(fresh.name, rows, view)
        handle = fresh.control(p.name).locator(".noUi-handle")
        assert int(float(handle.get_attribute("aria-valuenow"))) == p.grid.index(places[-1])


@every("rate-attitude")
@pytest.mark.parametrize("end", ["Home", "End"])
def test_with_the_rigid_body_alone_fed_back(fresh, end):
    fresh.redrawn(fresh.panel.get_by_role("button", name="rigid body").click)
    for name in ("K_A", "K_C", "K_R"):
        handle = fresh.control(name).locator(".noUi-handle")
        handle.focus()
        fresh.redrawn(lambda handle=handle: handle.press(end))
        assert_rows(fresh.name, fresh.rows("table.poles"), fresh.library_at())
    poles = poles_of(fresh.rows("table.poles"))
    before = fresh.values()["gyro"]
    fresh.moved("gyro", [before + 1], "table.poles")
    assert poles_of(fresh.rows("table.poles")) == poles


@every("coupling")
def test_each_path_of_the_vehicle_without_control(fresh):
    buttons = fresh.control("running").get_by_role("button").all()
    canvas = fresh.root.locator("canvas[data-plane=paths]")
    seen = set()
    for button in reversed(buttons):
        fresh.redrawn(button.click)
        seen.add(canvas.evaluate("c => c.toDataURL()"))
        assert_rows(fresh.name, fresh.rows("table.poles"), fresh.library_at())
    assert len(seen) == len(buttons)


@every(*SLID)
def test_a_redraw_says_how_long_it_took(fresh):
    name = fresh.numbers()[0]
    handle = fresh.control(name).locator(".noUi-handle")
    handle.focus()
    handle.press("Home")
    fresh.page.wait_for_timeout(100)
    times = [fresh.redrawn(lambda: handle.press("ArrowRight")) for _ in range(12)]
    assert sorted(times)[6] < 200


# ---- presets


@every(*SLID)
def test_each_preset_sets_its_values(fresh):
    for preset in fresh.view.payload["presets"]:
        button = fresh.root.get_by_role("button", name=preset["name"], exact=True)
        button.click()
        fresh.page.wait_for_function(
            "button => button.getAttribute('aria-pressed') === 'true'", arg=button.element_handle()
        )
        view = fresh.library_at()
        assert view.values() == {**view.values(), **preset["values"]}
        assert_rows(fresh.name, fresh.rows(TABLES[fresh.name]), view)


@every(*WORKBENCHES)
def test_each_preset_tells_the_printed_roots_beside_its_own(fresh):
    section = SECTIONS[fresh.name]
    corrected = corrected_designs(section, EQUATIONS)
    assert [p["name"] for p in fresh.view.payload["presets"]] == [*designs(section), *corrected]
    for preset in fresh.view.payload["presets"]:
        fresh.press(preset["name"])
        words = fresh.root.locator(".crossings").inner_text()
        button = fresh.root.get_by_role("button", name=preset["name"], exact=True)
        assert button.get_attribute("title").endswith(
            "corrected" if preset["name"] in corrected else "as printed"
        )
        if not preset["printed"]:
            assert "Printed roots" not in words
            continue
        printed = np.array([complex(r["re"], r["im"]) for r in preset["printed"]])
        poles = np.array(poles_of(fresh.rows("table.poles")))
        off = abs(printed[:, None] - poles).min(axis=1) > 0.05 * np.maximum(abs(printed), 0.1)
        if preset["name"] in REPRODUCED:
            assert not off.any(), preset["name"]
            assert (
                f"Printed roots (+): {len(printed)}, all within a plot’s reading of the roots here." in words
            )
        else:
            assert f"Printed roots (+): {len(printed)}, of which " in words
            assert " more than a plot’s reading off: " in words
            if preset["locus"] == len(fresh.view.payload["loci"]) - 1:  # the whole loop, as in the table
                assert f"of which {off.sum()} more" in words


@every("rate-attitude")
def test_the_corrected_design_is_that_of_the_corrected_equation(fresh):
    fresh.press("Eq. 75, divided by U")
    wanted = rigid_design(rigid_body(EQUATIONS), omega=2, zeta=0.5, K_C=10)
    assert fresh.values()["K_A"] == pytest.approx(wanted.K_A, rel=1e-9)
    assert fresh.values()["K_R"] == pytest.approx(wanted.K_R, rel=1e-9)


# ---- a hand, a keyboard, a link


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
    wanted = next(
        v
        for v in (
            grid[k]
            for k in range(found.view.parameters[found.numbers().index(name)].nearest(start) + 8, len(grid))
        )
        if v > 0
    )
    found.moved(name, [wanted], "table.poles")
    to = handles(found)
    found.moved(name, [start], "table.poles")
    page.wait_for_timeout(500)
    far = np.nan_to_num(np.hypot(*(to - at).T), nan=-1.0)
    pole = int(far.argmax())
    assert far[pole] > 3, "no pole of this locus moves enough to be dragged"
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
    assert seen, "the focus cannot be seen"
    order = ["K A", "K C", "K R", "K za", "K zb", "station of the sensor a", "station of the sensor b"]
    order += ["Figure 19", "Reset", "Locus in", "Origin", "Root locus in", "zoom in", "Lock axes"]
    order += ["pole table", "Pole map", "Responses", "Mode shape", "Take away", "Keys and gestures"]
    places = [next((k for k, name in enumerate(reached) if name.startswith(wanted)), -1) for wanted in order]
    assert [wanted for wanted, at in zip(order, places, strict=True) if at < 0] == [], reached
    assert places == sorted(places), dict(zip(order, places, strict=True))
    assert any("Enter shows its mode" in name for name in reached)
    assert root.locator("[data-panel=mode]").evaluate("p => p.open")


# ---- pages: narrow, dark, still, without scripts


@every(*PAGES)
@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 360])
def test_fits_the_page_in_both_themes(shown, width, theme):
    page = shown.page
    page.set_viewport_size({"width": width, "height": 900})
    page.evaluate("theme => (document.documentElement.dataset.theme = theme)", theme)
    shown.root.evaluate("root => root.querySelectorAll('details').forEach(panel => (panel.open = true))")
    shown.root.scroll_into_view_if_needed()
    page.wait_for_timeout(250)
    SCREENSHOTS.mkdir(exist_ok=True)
    shown.panel.screenshot(path=SCREENSHOTS / f"page-{shown.name}-{width}-{theme}.png", animations="disabled")
    wide = page.evaluate("() => document.documentElement.scrollWidth")
    over = shown.panel.evaluate(
        """panel => [...panel.querySelectorAll('*')]
             .filter(el => el.getClientRects().length && !el.closest('.scroll, pre, .unseen, svg'))
             .filter(el => el.getBoundingClientRect().right > innerWidth + 1)
             .map(el => `${el.tagName}.${el.className}`)"""
    )
    ground = shown.root.locator("canvas").first.evaluate(
        "c => [...c.getContext('2d').getImageData(c.width - 4, c.height / 2, 1, 1).data]"
    )
    page.set_viewport_size({"width": 1280, "height": 900})
    page.evaluate("() => (document.documentElement.dataset.theme = 'light')")
    assert wide <= width
    assert over == []
    if ground[3]:
        assert (max(ground[:3]) < 100) == (theme == "dark"), ground


def test_reduced_motion_is_respected(browser, visit):
    with visit(PAGES["rate-attitude"]) as (page, outside, errors):
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
    assert line.count() == still.count() == sum(path == PAGES[name] for path in PAGES.values())
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


@pytest.mark.parametrize("path", sorted(set(PAGES.values())))
def test_the_first_view_comes_before_the_formulas(browser, site, path):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.add_init_script(
        """addEventListener('rlswaim:drawn', () => {
             globalThis.formulas ??= document.querySelectorAll('mjx-container').length;
           }, true);"""
    )
    page.goto(f"{site}/{path}")
    page.wait_for_function("() => document.querySelectorAll('mjx-container').length > 3")
    assert page.evaluate("formulas") == 0
    page.close()


# ---- chapter VII: the map beside the workbench


@every("station-map")
class TestStationMap:
    def test_comes_in_levels(self, shown):
        shown.root.locator("canvas[data-plane=stations]").scroll_into_view_if_needed()
        shown.page.wait_for_function(
            "root => root.dataset.step === 'complete'", arg=shown.root.element_handle(), timeout=30000
        )
        steps = shown.page.evaluate(
            """async root => {
                 const seen = [];
                 const note = () => seen.push(root.dataset.step);
                 root.addEventListener('rlswaim:drawn', note);
                 const named = b => b.textContent === 'Figure 25, K_A = 3';
                 [...root.querySelectorAll('button')].find(named).click();
                 const until = performance.now() + 30000;
                 do await new Promise(next => setTimeout(next, 20));
                 while ((root.dataset.step !== 'complete' || seen.length < 3) && performance.now() < until);
                 root.removeEventListener('rlswaim:drawn', note);
                 return [...new Set(seen)].filter(s => s !== '0').map(s => s === 'complete' ? 0 : +s);
               }""",
            shown.root.element_handle(),
        )
        assert steps == sorted(steps, reverse=True)
        assert steps[-1] == 0
        assert "All 177,241 pairs" in shown.root.locator(".crossings").inner_text()

    def test_a_click_picks_the_pair_and_the_workbench_follows_and_back(self, shown, request):
        page = shown.page
        bench = page.locator("[data-explorer=dual-actuation]")
        panel = page.locator(".live-view", has=bench)
        twin = LivePage("dual-actuation", page, bench, panel)
        shown.root.get_by_role("button", name="The pair that works").click()
        canvas = shown.root.locator("canvas[data-plane=stations]")
        canvas.scroll_into_view_if_needed()
        box = canvas.bounding_box()
        left, right, top, bottom = 50, 12, 10, 36
        x = left + (100.5 / 421) * (box["width"] - left - right)
        y = box["height"] - bottom - (300.5 / 421) * (box["height"] - top - bottom)
        canvas.click(position={"x": x, "y": y})
        page.wait_for_timeout(300)
        values = twin.values()
        assert (values["sensor"], values["jet"]) == (100, 300)
        view = twin.library_at()
        assert relative_mismatch(poles_of(twin.rows("table.poles")), view.closed_loop()) < 1e-6
        told = "root => +root.querySelector('.verdict').dataset.value"
        assert shown.root.evaluate(told) == pytest.approx(view.poles().real.max(), rel=1e-6, abs=1e-9)
        panel.evaluate("panel => panel.scrollIntoView()")
        twin.moved("jet", [64], "table.poles")
        page.wait_for_timeout(300)
        worst = twin.library_at().poles().real.max()
        assert shown.root.evaluate(told) == pytest.approx(worst, rel=1e-6, abs=1e-9)
        assert "the jet at 64 ft" in shown.root.locator(".verdict").inner_text()


# ---- chapter VIII: two designs side by side


@every("comparison")
class TestComparison:
    def choose(self, shown: LivePage, side: int, at: int) -> None:
        chooser = shown.panel.locator(".widget-dropdown select").nth(side)
        if chooser.evaluate("s => s.selectedIndex") != at:
            shown.redrawn(lambda: chooser.select_option(index=at))

    def rows(self, shown: LivePage, side: int):
        return shown.root.locator(".side").nth(side).locator("table.poles").evaluate(ROWS)

    def step(self, shown: LivePage, side: int, key: str = "PageUp") -> None:
        canvas = shown.root.locator(".side").nth(side).locator("canvas[data-plane=locus]")
        canvas.focus()
        shown.redrawn(lambda: shown.page.keyboard.press(key))

    @pytest.fixture
    def view(self, shown):
        view = library("comparison")
        for side, name in enumerate(("IV: Eq. 78 (as printed)", "IV: Eq. 75, divided by U (corrected)")):
            self.choose(shown, side, view.designs.index(name))
        shown.page.wait_for_timeout(200)
        return view

    @pytest.mark.parametrize("side", [0, 1])
    def test_a_design_chosen_shows_the_librarys_poles(self, shown, view, side):
        other = self.rows(shown, 1 - side)
        name = ("left", "right")[side]
        for at in range(len(view.designs) - 1, -1, -1):
            self.choose(shown, side, at)
            setattr(view, name, at)
            assert relative_mismatch(poles_of(self.rows(shown, side)), view.closed_loop(name)) < 1e-6
            assert self.rows(shown, 1 - side) == other

    def test_a_link_keeps_both_sides_apart(self, shown, view, visit):
        self.choose(shown, 0, view.designs.index("V: Search (corrected)"))
        self.choose(shown, 1, view.designs.index("V: Figure 16 (as printed)"))
        self.step(shown, 0)
        self.step(shown, 1, "PageDown")
        shown.page.wait_for_function(
            "() => location.hash.includes('left-') && location.hash.includes('right-')"
        )
        shown.page.wait_for_timeout(300)
        tables = [self.rows(shown, side) for side in (0, 1)]
        assert tables[0] != tables[1]
        with live(visit, "comparison", shown.page.evaluate("location.hash")) as other:
            other.page.wait_for_timeout(400)
            assert [self.rows(other, side) for side in (0, 1)] == tables
        self.choose(shown, 0, view.designs.index("VI: Search (corrected)"))
        shown.page.wait_for_timeout(300)
        address = shown.page.evaluate("location.hash")
        assert "left-" not in address
        assert "right-" in address

    def test_undo_on_one_side_leaves_the_other(self, shown, view):
        start = [self.rows(shown, side) for side in (0, 1)]
        self.step(shown, 0)
        shown.page.wait_for_timeout(500)
        self.step(shown, 1)
        shown.page.wait_for_timeout(500)
        moved = [self.rows(shown, side) for side in (0, 1)]
        assert all(a != b for a, b in zip(start, moved, strict=True))
        left = shown.root.locator(".side").first
        shown.redrawn(left.get_by_role("button", name="undo").click)
        assert [self.rows(shown, side) for side in (0, 1)] == [start[0], moved[1]]
        shown.root.locator(".side").nth(1).locator("canvas[data-plane=locus]").focus()
        shown.redrawn(lambda: shown.page.keyboard.press("Control+z"))
        assert [self.rows(shown, side) for side in (0, 1)] == start
