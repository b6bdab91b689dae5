"""What a pointer, a finger and a keyboard do to a workbench in the browser."""

import numpy as np
import pytest
from playwright.sync_api import Page

import rlswaim as rl
from standin import opened, paired, show, table
from workbench_page import EQUATIONS, locus, mode_2, one, picture, scale_of, to_pixels


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
