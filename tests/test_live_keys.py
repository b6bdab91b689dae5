"""Keys on the sliders of the built pages step to round numbers; boxes take a comma and powers of ten."""

import pytest

from live_tables import assert_rows
from livepage import live


@pytest.fixture(scope="module")
def shown(visit):
    """The workbench of chapter IV on its page."""
    with live(visit, "rate-attitude") as found:
        yield found


@pytest.mark.parametrize(
    ("start", "keys", "wanted"),
    [
        (1.8, "ArrowRight", 2.0),
        (1.8, "ArrowLeft", 1.0),
        (1.8, "Shift+ArrowUp", 10.0),
        (1.8, "Shift+ArrowDown", 1.0),
        (0.0, "ArrowRight", 1e-4),
        (1e-4, "ArrowLeft", 0.0),
        (-2.0, "ArrowRight", -1.0),
        (3.0, "Alt+ArrowRight", 3.2),
    ],
)
def test_an_arrow_steps_to_a_round_number(shown, start, keys, wanted):
    shown.reset()
    if shown.values()["K_A"] != start:
        shown.moved("K_A", [start], "table.poles")
    handle = shown.control("K_A").locator(".noUi-handle")
    handle.focus()
    shown.redrawn(lambda: handle.press(keys))
    assert shown.values()["K_A"] == wanted
    assert_rows(shown.name, shown.rows("table.poles"), shown.library_at())


@pytest.mark.parametrize(("text", "wanted"), [("0,25", 0.25), ("1e-3", 1e-3), ("-2,5e-1", -0.25), ("3", 3.0)])
def test_a_box_takes_numbers_as_people_write_them(shown, text, wanted):
    shown.reset()
    box = shown.control("K_A").locator("input")
    box.click()
    box.fill("")
    box.press_sequentially(text)
    box.press("Enter")
    shown.page.wait_for_function(
        "([box, wanted]) => Number(box.value) === wanted", arg=[box.element_handle(), wanted]
    )
    shown.page.wait_for_timeout(100)
    assert_rows(shown.name, shown.rows("table.poles"), shown.library_at())


def test_the_box_of_a_station_keeps_whole_numbers(shown):
    assert shown.control("gyro").locator("input").get_attribute("type") == "number"
