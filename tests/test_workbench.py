"""The workbench in a browser: everything that a hand, a keyboard or a link can do to a live view."""

import csv
import gzip
import io
import json
import statistics
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import rlswaim as rl
from rlswaim import explorers
from rlswaim.explorers import Explorer
from standin import MODEL, model_state, opened, paired, show, table

EQUATIONS = rl.printed_equations()
VIEWS = {
    "IV": explorers.rate_attitude_explorer,
    "V": explorers.single_sensor_explorer,
    "VI": explorers.two_sensor_explorer,
    "VII": explorers.dual_actuation_explorer,
}
SCREENSHOTS = Path(__file__).parent.parent / "screenshots"
POLICY = (
    "default-src 'none'; script-src 'self' blob:; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:"
)
SITE = "http://workbench.test/"


@pytest.fixture(scope="module", params=VIEWS, ids=VIEWS)
def any_view(request) -> Explorer:
    return VIEWS[request.param](EQUATIONS)


@pytest.fixture(scope="module")
def explorer() -> Explorer:
    return VIEWS["IV"](EQUATIONS)


@pytest.fixture
def page(browser: Browser, explorer: Explorer) -> Iterator[Page]:
    with opened(browser, explorer) as page:
        page.wait_for_timeout(50)
        yield page


def locus(page: Page):
    return page.locator("canvas[data-plane=locus]")


def picture(page: Page, plane: str = "locus") -> str:
    return page.evaluate("plane => el.querySelector(`[data-plane=${plane}]`).toDataURL()", plane)


def marks(page: Page) -> np.ndarray:
    """Return where the poles stand on the page, px: shape (n, 2), nan where they are not shown."""
    return np.array(
        page.evaluate(
            """() => [...el.querySelectorAll('.handles button')].map((button) => {
                 const { x, y, width, height } = button.getBoundingClientRect();
                 return button.hidden ? [NaN, NaN] : [x + width / 2, y + height / 2];
               })"""
        ),
        dtype=float,
    )


def to_pixels(page: Page, pole: complex) -> tuple[float, float]:
    """Return where a pole stands on the page: two shown marks fix the scale."""
    at, poles = marks(page), table(page)
    shown = [i for i in range(len(poles)) if not np.isnan(at[i, 0])]
    i, j = max(shown, key=lambda k: poles[k].real), min(shown, key=lambda k: poles[k].real)
    scale = (at[i, 0] - at[j, 0]) / (poles[i].real - poles[j].real)
    x = at[i, 0] + scale * (pole.real - poles[i].real)
    return x, at[i, 1] - scale * (pole.imag - poles[i].imag)


def scale_of(page: Page) -> float:
    return abs(to_pixels(page, 1j)[1] - to_pixels(page, 0j)[1])


def one(page: Page, act) -> None:
    """Do something and wait for the drawing that follows."""
    page.evaluate("() => { window.next = drawn(); }")
    act()
    page.evaluate("() => window.next")


def mode_2(**gains: float) -> complex:
    """Return the upper pole near mode 2."""
    given = {"K_A": 1.8, "K_C": 10, "K_R": 0.618, "gyro": 60, **gains}  # else those of Figure 8
    poles = rl.rate_attitude(EQUATIONS, **given).poles()
    return min((p for p in poles if p.imag > 0), key=lambda p: abs(p - (0.5 + 3j)))


class TestPointer:
    def test_a_pole_is_dragged_along_its_locus(self, page, explorer):
        start, wanted = mode_2(), mode_2(K_A=3.0)
        page.mouse.move(*to_pixels(page, start))
        page.mouse.down()
        page.mouse.move(*to_pixels(page, start + 0.3 * (wanted - start)), steps=3)
        one(page, lambda: page.mouse.move(*to_pixels(page, wanted)))
        page.mouse.up()
        K_A = page.evaluate("state.K_A")
        assert pytest.approx(3.0, rel=0.03) == K_A
        assert explorer.parameters[0].grid[page.evaluate("state.K_A_at")] == pytest.approx(K_A, rel=0.04)
        library = rl.rate_attitude(EQUATIONS, K_A=K_A, K_C=10, K_R=0.618, gyro=60).poles()
        ours, theirs = paired(library, table(page))
        assert (abs(ours - theirs) <= 1e-8 * np.maximum(1, abs(ours))).all()

    def test_hover_reads_gain_frequency_and_damping(self, page):
        pole = mode_2(K_A=1.0)
        page.mouse.move(*to_pixels(page, pole))
        tip = page.locator(".tip")
        assert tip.is_visible()
        assert tip.get_attribute("aria-live") == "off"
        words = tip.inner_text().replace("−", "-")
        assert words.startswith("mode 2")
        gain, omega, zeta = (part.split()[-2 if "rad" in part else -1] for part in words.split(" · "))
        assert float(gain) == pytest.approx(1.0, rel=0.1)
        assert float(omega) == pytest.approx(abs(pole), rel=0.02)
        assert float(zeta) == pytest.approx(-pole.real / abs(pole), abs=0.02)
        page.mouse.move(*to_pixels(page, -8 + 5j))
        assert tip.is_hidden()

    def test_a_click_on_the_locus_sets_the_gain(self, page):
        one(page, lambda: page.mouse.click(*to_pixels(page, mode_2(K_A=0.6))))
        assert page.evaluate("state.K_A") == pytest.approx(0.6, rel=0.03)

    def test_wheel_zooms_about_the_pointer(self, page):
        at = to_pixels(page, mode_2())
        before = scale_of(page)
        page.mouse.move(*at, steps=3)
        one(page, lambda: page.mouse.wheel(0, -300))
        assert scale_of(page) > 1.4 * before
        assert to_pixels(page, mode_2()) == pytest.approx(at, abs=1)

    def test_scrolling_past_does_not_zoom(self, page):
        page.mouse.move(450, 20)
        page.mouse.wheel(0, 100)
        page.wait_for_function("scrollY > 0")
        page.evaluate("scrollTo(0, 0)")
        page.wait_for_timeout(100)
        before = scale_of(page)
        x, y = to_pixels(page, -3 + 3j)
        page.mouse.move(x, y)
        page.mouse.wheel(0, 60)
        page.wait_for_function("scrollY > 0")
        page.wait_for_timeout(100)
        page.mouse.wheel(0, 60)
        page.wait_for_timeout(200)
        assert scale_of(page) == pytest.approx(before, rel=2e-3)

    def test_drag_pans_and_double_click_fits(self, page):
        before, at = picture(page), np.array(to_pixels(page, -8 + 5j))
        page.mouse.move(*at)
        page.mouse.down()
        page.mouse.move(at[0] + 30, at[1] + 5)
        one(page, lambda: page.mouse.move(at[0] + 60, at[1] + 20))
        page.mouse.up()
        assert np.array(to_pixels(page, -8 + 5j)) - at == pytest.approx((60, 20), abs=1)
        one(page, lambda: page.mouse.dblclick(*at))
        assert picture(page) == before

    def test_locked_axes_stay_while_sliders_move(self, page):
        lock = page.get_by_role("button", name="Lock axes")
        before = scale_of(page)
        one(page, lock.click)
        assert lock.get_attribute("aria-pressed") == "true"
        show(page, K_C=60.0)
        assert scale_of(page) == pytest.approx(before, rel=2e-3)
        one(page, lock.click)
        assert scale_of(page) < 0.5 * before

    def test_the_small_window_enlarges_the_origin(self, page):
        before = picture(page)
        one(page, lambda: page.locator(".bar select").nth(1).select_option("100"))
        assert page.evaluate("state.magnify") == 100
        assert picture(page) != before

    def test_a_click_on_the_pole_map_picks_the_station(self, page):
        page.locator("canvas[data-plane=map]").scroll_into_view_if_needed()
        end = page.evaluate(
            """() => {
                 const { left, top } = el.querySelector('[data-plane=map]').getBoundingClientRect();
                 return [left, top];
               }"""
        )
        box = page.locator("canvas[data-plane=map]").bounding_box()
        assert (box["x"], box["y"]) == pytest.approx(tuple(end))
        # Somewhere on the picture a click finds the curve.
        for share in np.linspace(0.3, 0.9, 25):
            page.mouse.click(box["x"] + share * box["width"], box["y"] + 0.56 * box["height"])
        page.wait_for_function("state.gyro !== 60")
        assert page.evaluate("Number.isInteger(state.gyro)")


class TestTouch:
    @pytest.fixture
    def page(self, browser, explorer):
        with opened(browser, explorer, viewport={"width": 390, "height": 800}, has_touch=True) as page:
            page.wait_for_timeout(50)
            yield page

    def touch(self, page: Page, kind: str, *points: tuple[float, float]) -> None:
        session = self.session = getattr(self, "session", None) or page.context.new_cdp_session(page)
        places = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})
        page.wait_for_timeout(40)

    def test_a_finger_drags_a_pole(self, page):
        at, to = np.array(to_pixels(page, mode_2())), np.array(to_pixels(page, mode_2(K_A=8.0)))
        self.touch(page, "touchStart", tuple(at))
        for share in (0.2, 0.6, 1.0):
            self.touch(page, "touchMove", tuple(at + share * (to - at)))
        self.touch(page, "touchEnd")
        assert page.evaluate("state.K_A") == pytest.approx(8.0, rel=0.1)

    def test_two_fingers_zoom(self, page):
        before, (x, y) = scale_of(page), to_pixels(page, 1 + 1j)
        self.touch(page, "touchStart", (x - 20, y), (x + 20, y))
        for out in (30, 45, 60):
            self.touch(page, "touchMove", (x - out, y), (x + out, y))
        self.touch(page, "touchEnd")
        assert scale_of(page) > 2 * before


class TestKeyboard:
    def test_steps_the_running_parameter(self, page, explorer):
        grid = explorer.parameters[0].grid
        locus(page).focus()
        place = grid.index(1.8)
        for key, by in (("ArrowRight", 1), ("ArrowLeft", -1), ("PageUp", 10), ("ArrowDown", -1)):
            one(page, lambda key=key: page.keyboard.press(key))
            place += by
            assert page.evaluate("state.K_A") == grid[place]

    def test_zooms_pans_and_fits(self, page):
        locus(page).focus()
        before, scale = picture(page), scale_of(page)
        one(page, lambda: page.keyboard.press("+"))
        assert scale_of(page) == pytest.approx(1.25 * scale, rel=1e-3)
        one(page, lambda: page.keyboard.press("-"))
        assert scale_of(page) == pytest.approx(scale, rel=1e-3)
        here = to_pixels(page, -3j)[0]
        one(page, lambda: page.keyboard.press("Shift+ArrowRight"))
        assert to_pixels(page, -3j)[0] == pytest.approx(here - 40, abs=1)
        one(page, lambda: page.keyboard.press("0"))
        assert picture(page) == before

    def test_alone_it_reaches_a_mode_shape_and_every_panel(self, page):
        reached = []
        page.locator("body").evaluate("body => body.focus()")
        for _ in range(60):
            page.keyboard.press("Tab")
            name = page.evaluate(
                """() => { const a = document.activeElement;
                     return (a.getAttribute('aria-label') ?? a.textContent).slice(0, 40); }"""
            )
            if "Enter shows its mode" in page.evaluate("document.activeElement.ariaLabel ?? ''"):
                page.keyboard.press("Enter")
            reached.append(name)
        for wanted in (
            "Figure 9",
            "Reset",
            "Copy link",
            "Root locus in K_A",
            "zoom in",
            "Lock axes",
            "mode 2 at",
        ):
            assert any(name.startswith(wanted) for name in reached), wanted
        for title in ("Pole map", "Responses", "Mode shape", "Take away", "Keys and gestures"):
            assert any(name.startswith(title) for name in reached), title
        assert page.evaluate("el.querySelector('[data-panel=mode]').open")

    def test_undo_and_redo(self, page):
        locus(page).focus()
        for K_A in (5.0, 7.0):
            show(page, K_A=K_A)
            page.wait_for_timeout(500)
        for keys, K_A in (("Control+z", 5.0), ("Control+z", 1.8), ("Control+Shift+Z", 5.0)):
            one(page, lambda keys=keys: page.keyboard.press(keys))
            assert page.evaluate("state.K_A") == K_A
        one(page, page.get_by_role("button", name="redo").click)
        assert page.evaluate("state.K_A") == 7.0
        assert page.get_by_role("button", name="redo").is_disabled()
        one(page, page.get_by_role("button", name="undo").click)
        show(page, K_C=3.0)  # a new way: what was undone is gone
        page.wait_for_timeout(500)
        assert page.get_by_role("button", name="redo").is_disabled()

    def test_a_drag_is_one_step(self, page):
        page.mouse.move(2, 2)
        page.mouse.down()
        for K_A in np.linspace(2, 4, 9):
            show(page, K_A=float(K_A))
            page.wait_for_timeout(500 if K_A == 3 else 0)  # the hand may rest
        page.mouse.up()
        page.wait_for_timeout(500)
        one(page, page.get_by_role("button", name="undo").click)
        assert page.evaluate("state.K_A") == 1.8


class TestAddress:
    def test_a_link_gives_the_same_view(self, browser, page, explorer):
        show(page, K_A=-2.5, K_R=0.25, gyro=96, feedback="total")
        one(page, lambda: page.locator(".bar select").first.select_option("K_C"))
        one(page, lambda: page.locator("[data-panel=responses] select").first.select_option("1"))
        locus(page).focus()
        one(page, lambda: page.keyboard.press("+"))
        page.wait_for_function("location.hash.includes('view.window')")
        address = page.evaluate("location.href")
        assert address.split("#")[1].startswith(
            "rate-attitude:K_A=-2.5,K_C=10,K_R=0.25,gyro=96,feedback=total"
        )
        with opened(browser, explorer, address) as other:
            other.wait_for_function("state.gyro === 96")
            other.wait_for_timeout(100)
            assert (table(other) == table(page)).all()
            assert picture(other) == picture(page)
            for plane in ("map", "responses"):
                for where in (page, other):
                    where.locator(f"canvas[data-plane={plane}]").scroll_into_view_if_needed()
                    where.wait_for_timeout(100)
                    where.wait_for_function("!el.querySelector('.stale')")
                assert picture(other, plane) == picture(page, plane)

    def test_other_parts_and_nonsense_are_left_alone(self, browser, explorer):
        address = (
            "about:blank#single-sensor:K_z=2&rate-attitude:K_A=nan,gyro=3.5,K_R=0.25,feedback=%ZZ,K_C=%E0%A4"
        )
        with opened(browser, explorer, address) as page:
            page.wait_for_function("state.K_R === 0.25")
            assert page.evaluate("[state.K_A, state.gyro, state.feedback, state.K_C]") == [
                1.8,
                60,
                "total",
                10,
            ]
            show(page, K_A=4.0)
            page.wait_for_function("location.hash.includes('K_A=4')")
            assert page.evaluate("location.hash").startswith("#single-sensor:K_z=2&rate-attitude:K_A=4,")
            page.get_by_role("button", name="Reset").click()
            page.wait_for_function("location.hash === '#single-sensor:K_z=2'")

    def test_an_untouched_view_leaves_the_address(self, browser, explorer):
        with opened(browser, explorer, "about:blank#fig-8") as page:
            page.wait_for_timeout(300)
            assert page.evaluate("location.hash") == "#fig-8"


class TestTakeAway:
    @pytest.fixture
    def page(self, browser, explorer):
        with opened(browser, explorer, accept_downloads=True) as page:
            page.locator("[data-panel=takeaway] summary").click()
            yield page

    def saved(self, page: Page, name: str) -> str:
        with page.expect_download() as download:
            page.get_by_role("button", name=name).click()
        return Path(download.value.path()).read_text(encoding="utf-8")

    def test_the_picture_is_svg(self, page):
        page.wait_for_function("el.querySelector('canvas').ariaLabel ?? false")
        show(page, magnify=10)
        text = self.saved(page, "Picture (SVG)")
        root = ElementTree.fromstring(text)
        space = "{http://www.w3.org/2000/svg}"
        assert root.tag == f"{space}svg"
        assert "NaN" not in text
        assert "Root locus in K_A" in root.find(f"{space}title").text
        colors = {path.get("stroke") for path in root.iter(f"{space}path")}
        assert set(page.evaluate("Object.values(state.payload.branches)")) <= {
            (c or "").upper() for c in colors
        } | {c for c in colors if c}
        assert "Re s (1/s)" in {text.text for text in root.iter(f"{space}text")}

    def test_the_svg_looks_like_the_canvas(self, browser, page):
        text = self.saved(page, "Picture (SVG)")
        sizes = page.evaluate(
            """async (svg) => {
                 const image = new Image();
                 image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
                 await image.decode();
                 const shown = el.querySelector('[data-plane=locus]');
                 const { width, height } = shown;
                 const made = Object.assign(document.createElement('canvas'), { width, height });
                 const g = made.getContext('2d');
                 g.drawImage(image, 0, 0, width, height);
                 const both = [g, shown.getContext('2d')];
                 const [a, b] = both.map((c) => c.getImageData(0, 0, width, height).data);
                 let off = 0;
                 for (let k = 0; k < a.length; k += 4) off += b[k + 3] && Math.abs(a[k] - b[k]) > 64 ? 1 : 0;
                 return off / (a.length / 4);
               }""",
            text,
        )
        assert sizes < 0.01

    def test_the_poles_are_those_of_the_table(self, page):
        rows = list(csv.DictReader(io.StringIO(self.saved(page, "Poles (CSV)"))))
        poles = np.array([complex(float(r["real (1/s)"]), float(r["imaginary (1/s)"])) for r in rows])
        assert (poles == table(page)).all()
        assert [r["leaves from"] for r in rows] == page.evaluate(
            "[...el.querySelectorAll('.poles tbody tr')].map((row) => row.dataset.branch)"
        )

    def test_no_clipboard_is_said_in_words(self, page):
        page.evaluate("Object.defineProperty(navigator, 'clipboard', { value: undefined })")
        page.get_by_role("button", name="Copy link").click()
        assert "in the address bar" in page.locator(".said").inner_text()

    def test_the_link_is_copied(self, page):
        page.evaluate(
            """() => {
                 const value = { writeText: async (text) => { window.got = text; } };
                 Object.defineProperty(navigator, 'clipboard', { value });
               }"""
        )
        show(page, K_A=3.0)
        page.get_by_role("button", name="Copy link").click()
        page.wait_for_function("window.got")
        assert "#rate-attitude:K_A=3," in page.evaluate("window.got")


def test_rehearsing_shows_nothing(browser, explorer):
    with opened(browser, explorer) as page:
        page.wait_for_timeout(50)
        before = picture(page), table(page).tolist(), page.evaluate("[location.hash, JSON.stringify(state)]")
        page.evaluate("() => new Promise((done) => setTimeout(() => requestIdleCallback(done), 1500))")
        after = picture(page), table(page).tolist(), page.evaluate("[location.hash, JSON.stringify(state)]")
        assert after == before


class TestEveryControlSystem:
    @pytest.fixture
    def wide(self, browser, any_view):
        with opened(browser, any_view, viewport={"width": 1280, "height": 900}) as page:
            page.evaluate("[...el.querySelectorAll('details')].forEach((panel) => (panel.open = true))")
            page.wait_for_timeout(300)
            yield page

    def presets(self, wide: Page) -> list[dict]:
        return wide.evaluate("state.payload.presets")

    def test_the_call_of_the_library_gives_the_poles_shown(self, wide):
        for preset in self.presets(wide):
            wide.get_by_role("button", name=preset["name"], exact=True).click()
            wide.wait_for_timeout(350)
            names: dict = {}
            exec(wide.locator("[data-panel=takeaway] code").inner_text(), names)
            ours, theirs = paired(names["loop"].poles(), table(wide))
            assert (abs(ours - theirs) <= 1e-6 * np.maximum(1, abs(ours))).all(), preset["name"]

    def test_each_slider_can_run_the_locus(self, wide):
        names = (
            wide.locator(".bar select").first.locator("option").evaluate_all("all => all.map(o => o.value)")
        )
        assert len(names) >= len(wide.evaluate("Object.keys(state.payload.running)"))
        for name in names:
            wide.locator(".bar select").first.select_option(name)
            wide.wait_for_timeout(60)
            assert wide.locator("figcaption").inner_text().startswith(("Root locus", "Zeros of the loop"))
            assert wide.locator(".bar select").first.input_value() == name

    def test_each_station_has_its_map(self, wide):
        wide.locator("canvas[data-plane=map]").scroll_into_view_if_needed()
        wide.wait_for_timeout(100)
        for at, station in enumerate(wide.evaluate("state.payload.maps")):
            if wide.locator("[data-panel=map] select").is_visible():
                wide.locator("[data-panel=map] select").select_option(str(at))
                wide.wait_for_timeout(60)
            wide.wait_for_function(
                "words => el.querySelector('[data-panel=map] small').textContent.startsWith(words)",
                arg=f"{station} from 0 to 420 ft",
            )

    def test_each_input_has_its_responses(self, wide):
        seen = set()
        wide.locator("canvas[data-plane=responses]").scroll_into_view_if_needed()
        for at in range(wide.locator("[data-panel=responses] select").first.locator("option").count()):
            wide.locator("[data-panel=responses] select").first.select_option(str(at))
            wide.wait_for_timeout(300)
            wide.wait_for_function("el.querySelector('[data-plane=responses]').ariaLabel")
            seen.add(picture(wide, "responses"))
            label = wide.locator("canvas[data-plane=responses]").get_attribute("aria-label")
            assert "theta: largest" in label
            assert "NaN" not in label
        assert len(seen) > 4

    def test_weight(self, any_view):
        sent = json.dumps(any_view.payload) + any_view._esm + any_view._css
        assert len(gzip.compress(sent.encode())) < 150_000

    @pytest.mark.parametrize("theme", ["light", "dark"])
    @pytest.mark.parametrize("width", [360, 800])
    def test_fits_the_page(self, browser, any_view, width, theme):
        with opened(browser, any_view, viewport={"width": width, "height": 900}) as page:
            page.evaluate(
                """(theme) => {
                     document.documentElement.dataset.theme = theme;
                     document.body.style.background = theme === 'dark' ? '#121212' : '#fff';
                     [...el.querySelectorAll('details')].forEach((panel) => (panel.open = true));
                   }""",
                theme,
            )
            page.wait_for_timeout(300)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            SCREENSHOTS.mkdir(exist_ok=True)
            page.screenshot(path=SCREENSHOTS / f"{any_view.system}-{width}-{theme}.png", full_page=True)


class TestPanels:
    def test_responses_are_the_librarys(self, page):
        page.locator("canvas[data-plane=responses]").scroll_into_view_if_needed()
        page.wait_for_function("el.querySelector('[data-plane=responses]').ariaLabel?.includes('theta')")
        label = page.locator("canvas[data-plane=responses]").get_attribute("aria-label")
        words = {part.split(":")[0].split(". ")[-1]: part for part in label.split("; ")}
        loop = rl.rate_attitude(EQUATIONS, K_A=1.8, K_C=10, K_R=0.618, gyro=60)
        theta_c = loop.input_labels.index("theta_c")
        step = control.forced_response(loop[:, theta_c], np.linspace(0, 5, 501), np.full(501, np.pi / 180))
        for name, unit in (("theta", 180 / np.pi), ("q1", 1), ("delta", 180 / np.pi)):
            end = float(words[name].rsplit(" ", 2)[-2])
            at = loop.output_labels.index(name)
            assert end == pytest.approx(np.atleast_2d(step.outputs)[at, -1] * unit, rel=0.01)

    def test_a_click_on_a_pole_opens_its_mode(self, page):
        assert not page.locator("canvas[data-plane=mode]").is_visible()
        one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
        page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
        page.wait_for_function("el.querySelector('[data-plane=mode]').ariaLabel?.includes('mode 2')")
        shares = [float(text.strip(" %")) for text in page.locator(".shares b").all_inner_texts()]
        assert sum(shares) == pytest.approx(100, abs=2)
        assert shares == sorted(shares, reverse=True)

    def test_the_mode_moves_until_it_is_paused(self, page):
        one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
        page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
        page.wait_for_timeout(150)
        before = picture(page, "mode")
        page.wait_for_timeout(150)
        assert picture(page, "mode") != before
        page.get_by_role("button", name="Pause").click()
        page.wait_for_timeout(100)
        before = picture(page, "mode")
        page.wait_for_timeout(150)
        assert picture(page, "mode") == before

    def test_reduced_motion_is_respected(self, browser, explorer):
        with opened(browser, explorer, reduced_motion="reduce") as page:
            page.wait_for_timeout(50)
            one(page, lambda: page.mouse.click(*to_pixels(page, mode_2())))
            page.locator("canvas[data-plane=mode]").scroll_into_view_if_needed()
            page.wait_for_timeout(150)
            before = picture(page, "mode")
            page.wait_for_timeout(150)
            assert picture(page, "mode") == before
            assert page.get_by_role("button", name="Pause").is_hidden()

    def test_margins_are_told(self, page):
        words = page.locator(".crossings").inner_text().replace("−", "-")
        assert "Gain margins: " in words
        assert "Phase margins: " in words


def test_works_under_a_policy_without_eval(browser, explorer):
    page = browser.new_context().new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    state = json.dumps([explorer._esm, explorer._css, model_state(explorer)])
    script = f"globalThis.opened = ({MODEL.strip().rstrip(';')})({state});"
    files = {
        SITE: (
            "text/html",
            '<!doctype html><html lang="en"><title>t</title><body><script src="/run.js"></script>',
        ),
        f"{SITE}run.js": ("text/javascript", script),
    }

    def answer(route) -> None:
        kind, text = files.get(route.request.url, ("text/plain", ""))
        route.fulfill(
            body=text, content_type=f"{kind}; charset=utf-8", headers={"Content-Security-Policy": POLICY}
        )

    page.route("**/*", answer)
    page.goto(SITE)
    rows = page.locator("[data-explorer=rate-attitude] table.poles tbody tr")
    rows.first.wait_for()
    assert rows.count() == 8
    page.locator("[data-panel=takeaway] summary").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="Picture (SVG)").click()
    assert Path(download.value.path()).read_text(encoding="utf-8").startswith("<svg")
    assert errors == []
    page.context.close()


def test_speed(page):
    """Compute and draw together; the machine is shared, so the median alone is held to the frame."""
    times = page.evaluate(
        """async () => {
             const { grid } = state.payload.parameters[0];
             const times = [];
             for (let k = 0; k < 80; k++) {
               const done = drawn();
               model.set('K_A', grid[250 + k]);
               times.push((await done).ms);
             }
             return times.slice(20);
           }"""
    )
    assert statistics.median(times) < 8
