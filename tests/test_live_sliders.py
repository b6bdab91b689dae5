"""Each slider of a live view on the built book: the page shows what the library computes."""

import numpy as np
import pytest

from live_tables import SLID, TABLES, assert_rows, every
from livepage import poles_of


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
    for p in fresh.beside():
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
