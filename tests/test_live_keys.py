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


@pytest.mark.parametrize(
    ("name", "text", "value", "said"),
    [
        ("K_A", "1e308", 1e3, "K_A as typed is beyond its range −1,000 to 1,000: 1,000 is shown."),
        ("K_A", "-1e400", -1e3, "K_A as typed is beyond its range −1,000 to 1,000: −1,000 is shown."),
        ("K_C", "0", 0.1, "K_C as typed is beyond its range 0.1 to 100: 0.1 is shown."),
        ("gyro", "9999", 420, "gyro as typed is beyond its range 0 to 420: 420 is shown."),
        ("gyro", "60.5", 60, "gyro as typed is not a whole number and is left out."),
        ("K_A", "-1e-320", 0, "K_A as typed is too small to tell from 0: 0 is shown."),
        ("K_R", "0,x", 0.618, "K_R as typed is not a number and is left out."),
    ],
)
def test_a_typed_number_is_bounded_and_the_view_says_so(shown, name, text, value, said):
    shown.reset()
    box = shown.control(name).locator("input")
    box.evaluate(
        """(box, text) => {
             box.value = text;
             box.dispatchEvent(new Event('change', { bubbles: true }));
           }""",
        text,
    )
    shown.page.wait_for_timeout(200)
    assert float(box.input_value()) == value
    assert shown.root.locator("output").first.inner_text() == said
    assert_rows(shown.name, shown.rows("table.poles"), shown.library_at())
    shown.moved("K_R", [0.5], "table.poles")
    assert shown.root.locator("output").first.inner_text() == ""


def test_a_boxs_tip_tells_its_range(shown):
    assert "any value from -1000 to 1000" in shown.control("K_A").locator("input").get_attribute("aria-label")
    assert "whole numbers from 0 to 420" in shown.control("gyro").locator("input").get_attribute("aria-label")
