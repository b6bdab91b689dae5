"""What holds for each live view beside the workbenches: words, sliders, presets, history, address."""

import math
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page

from rlswaim.explorers.live_view import LiveView
from small_views import MAKERS, opened, show, view_of


@pytest.fixture(scope="module", params=MAKERS)
def shown(request: pytest.FixtureRequest, browser: Browser) -> Iterator[tuple[Page, LiveView]]:
    with opened(browser, view_of(request.param)) as page:
        yield page, view_of(request.param)


@pytest.fixture(params=MAKERS)
def fresh(request: pytest.FixtureRequest, browser: Browser) -> Iterator[tuple[Page, LiveView]]:
    """The same, on a page that nobody has touched."""
    with opened(browser, view_of(request.param)) as page:
        page.wait_for_function("document.querySelector('table tbody tr')")
        yield page, view_of(request.param)


class TestEveryView:
    def test_is_named_and_told_in_words(self, shown):
        page, view = shown
        assert page.evaluate("el.dataset.explorer") == view.system
        canvases = {"trajectory": 4, "station-map": 2, "peak-bound": 2}.get(view.system, 1)
        assert page.locator("canvas").count() == canvases
        for canvas in page.locator("canvas").all():
            assert len(canvas.get_attribute("aria-label")) > 20
        assert len(page.locator("[role=status]").text_content()) > 20
        assert page.locator("table tbody tr").count() > 2

    def test_every_slider_runs_to_both_ends(self, shown):
        page, view = shown
        assert len(view.parameters) >= 2
        for p in view.parameters:
            for end in (len(p.grid) - 1, 0):
                if page.evaluate(f"state.{p.name}_at") != end:
                    assert show(page, **{f"{p.name}_at": end})["ms"] > 0
                assert page.evaluate(f"state.{p.name}") == p.grid[end]
        text = page.locator("body").inner_text()
        assert "NaN" not in text
        assert "undefined" not in text
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("Object.entries(state.payload.initial).every(([n, v]) => state[n] === v)")

    def test_presets_set_their_values(self, shown):
        page, view = shown
        assert len(view.payload["presets"]) >= 3
        for preset in view.payload["presets"]:
            page.get_by_role("button", name=preset["name"], exact=True).click()
            pressed = "name => document.querySelector('[aria-pressed=true]')?.textContent === name"
            page.wait_for_function(pressed, arg=preset["name"])
            assert page.evaluate("names => names.map(n => state[n])", list(preset["values"])) == list(
                preset["values"].values()
            )
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("Object.entries(state.payload.initial).every(([n, v]) => state[n] === v)")

    def test_a_change_is_drawn_before_its_event_is_over(self, shown):
        page, view = shown
        name, grid = next((p.name, p.grid) for p in view.parameters if not isinstance(p.grid[0], str))
        if view.system == "station-map":  # until all its rows are there each frame has its drawing
            page.wait_for_function("el.dataset.step === 'complete'")
        counts = page.evaluate(
            """async ([name, values]) => {
                 const frame = () => new Promise(requestAnimationFrame);
                 let count = 0;
                 const note = () => count++;
                 el.addEventListener('rlswaim:drawn', note);
                 const counts = [];
                 await frame(); await frame();
                 count = 0;
                 model.set(name, values[0]);
                 await null;
                 counts.push(count);
                 model.set(name, values[1]);
                 model.set(name, values[2]);
                 await null;
                 counts.push(count);
                 await frame(); await frame();
                 counts.push(count);
                 el.removeEventListener('rlswaim:drawn', note);
                 return counts;
               }""",
            [name, [grid[1], grid[2], grid[3]]],
        )
        if view.system == "station-map":  # its rows begin to come
            counts[2] = min(counts[2], 2)
        assert counts == [1, 1, 2], "at once, then once more with the next frame"
        page.get_by_role("button", name="Reset").click()

    def test_undo_redo_and_the_address(self, fresh):
        page, view = fresh
        own = [p for p in view.parameters if not isinstance(p.grid[0], str)]
        start = {p.name: view.payload["initial"][p.name] for p in own}
        values = "names => names.map(name => state[name])"
        first, last = own[0], own[-1]
        places = {p.name: next(v for v in p.grid if v != start[p.name]) for p in (first, last)}
        for name, value in places.items():
            show(page, **{name: value})
            page.wait_for_timeout(900)  # a step of the history ends where the hand rests
        said = page.evaluate("location.hash")
        assert said == f"#{view.system}:" + ",".join(f"{name}={value:g}" for name, value in places.items())
        page.get_by_role("button", name="undo").click()
        assert page.evaluate(values, list(places)) == [places[first.name], start[last.name]]
        page.get_by_role("button", name="undo").click()
        assert page.evaluate(values, list(places)) == [start[first.name], start[last.name]]
        assert page.get_by_role("button", name="undo").is_disabled()
        page.wait_for_function("() => !location.hash")
        page.get_by_role("button", name="redo").click()
        page.locator("canvas").first.press("Control+Shift+z")
        assert page.evaluate(values, list(places)) == list(places.values())
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("() => !location.hash")
        page.evaluate("hash => { location.hash = hash; }", said)
        page.wait_for_function(
            "([names, wanted]) => names.every((name, i) => state[name] === wanted[i])",
            arg=[list(places), list(places.values())],
        )
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("() => !location.hash")

    def test_what_an_address_brings_is_bounded(self, fresh):
        page, view = fresh
        own = [p for p in view.parameters if not isinstance(p.grid[0], str)]
        first, last = own[0], own[-1]
        names, values = [first.name, last.name], "names => names.map(name => state[name])"
        before = page.evaluate(values, names)
        page.evaluate(f"location.hash = '{view.system}:{first.name}=one,{last.name}=two'")
        page.wait_for_timeout(50)
        assert page.evaluate(values, names) == before, "what makes no sense is left"
        page.evaluate(f"location.hash = '{view.system}:{first.name}=1e9,{last.name}=two'")
        wanted = [first.grid[-1], *before[1:]]
        page.wait_for_function(
            "([names, wanted]) => names.every((name, i) => state[name] === wanted[i])", arg=[names, wanted]
        )
        said = page.locator("output").inner_text()
        assert f"{first.name} from the address is beyond its range" in said
        assert f"{last.name} from the address is not a number and is left out." in said
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("() => !location.hash")

    def test_fits_a_narrow_page_and_a_dark_one(self, shown):
        page, _ = shown
        page.evaluate("async () => { const d = drawn(); el.style.width = '328px'; await d; }")
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth && el.scrollWidth <= 328")
        page.evaluate("async () => { const d = drawn(); el.style.width = ''; await d; }")
        light = page.evaluate("getComputedStyle(el).color")
        theme = "async (t) => { const d = drawn(); document.documentElement.dataset.theme = t; await d; }"
        page.evaluate(theme, "dark")
        assert page.evaluate("getComputedStyle(el).color") != light
        page.evaluate(theme, "light")

    @pytest.mark.parametrize("name", MAKERS)
    def test_python_refuses_what_makes_no_sense(self, name):
        first = view_of(name).parameters[0].name
        with pytest.raises(ValueError, match=f"{first} in {name} explorer: got nan"):
            MAKERS[name](**{first: math.nan})
        with pytest.raises(
            TypeError, match=rf"{name} explorer: got a missing or unknown 'K_x', wanted {first}"
        ):
            MAKERS[name](K_x=1.0)
        with pytest.raises(TypeError, match=f"{first} in {name} explorer"):
            setattr(view_of(name), first, "far")

    @pytest.mark.parametrize("name", MAKERS)
    def test_a_value_moves_its_slider(self, name):
        view = MAKERS[name]()
        first = view.parameters[0]
        setattr(view, first.name, first.grid[3])
        assert getattr(view, f"{first.name}_at") == 3
        assert f"{first.name} = {first.grid[3]}" in repr(view)
