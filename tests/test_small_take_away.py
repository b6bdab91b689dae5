"""What a reader takes away from a view beside the workbenches: its link, its pictures, its table."""

import csv
import io
from pathlib import Path
from xml.etree import ElementTree

import pytest
from playwright.sync_api import Page

from small_views import MAKERS, opened, show, view_of

SPACE = "{http://www.w3.org/2000/svg}"
OTHER = {
    "bent-vehicle": {"theta": 2.0},
    "trajectory": {"upright": 5},
    "coupling": {"omega_1": 4.0},
    "station-map": {"sensor": 100},
    "peak-bound": {"gyro_a": 100},
    "whole-burn": {"t": 20},
}


@pytest.fixture(params=MAKERS)
def taken(browser, request):
    """A view off its start, with its panel open."""
    with opened(browser, view_of(request.param)) as page:
        show(page, **OTHER[request.param])
        page.locator("[data-panel=takeaway] summary").click()
        yield page, view_of(request.param), OTHER[request.param]


def saved(page: Page, name: str) -> tuple[str, str]:
    """Press a button; return name and text of the file that it gives."""
    with page.expect_download() as download:
        page.get_by_role("button", name=name).click()
    return download.value.suggested_filename, Path(download.value.path()).read_text(encoding="utf-8")


def test_the_pictures_are_one_svg(taken):
    page, view, values = taken
    page.wait_for_function("(el.dataset.step ?? 'complete') === 'complete'")  # the map comes in rows
    before = page.evaluate("el.querySelector('canvas').toDataURL()")
    name, text = saved(page, "Pictures (SVG)")
    assert name.startswith(f"{view.system}_")
    assert name.endswith("_pictures.svg")
    for key, value in values.items():
        assert f"_{key}={value:g}_" in name
    root = ElementTree.fromstring(text)
    assert "NaN" not in text
    captions = page.evaluate("[...el.querySelectorAll('figcaption')].map(each => each.textContent)")
    told = [each.text for each in root.iter(f"{SPACE}text")]
    assert [caption for caption in captions if caption not in told] == []
    assert page.evaluate("el.querySelector('canvas').toDataURL()") == before
    ink = page.evaluate(
        """async (svg) => {
             const image = new Image();
             image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
             await image.decode();
             return [image.naturalWidth, image.naturalHeight];
           }""",
        text,
    )
    heights = page.evaluate("[...el.querySelectorAll('canvas')].map(each => each.clientHeight)")
    assert ink[1] == pytest.approx(sum(heights) + 22 * len(heights), abs=2)


def test_the_table_is_csv_with_the_parameters(taken):
    page, _, values = taken
    page.wait_for_function("el.querySelector('table').tBodies[0].rows.length > 0")
    _, text = saved(page, "Table (CSV)")
    rows = list(csv.reader(io.StringIO(text)))
    shown = page.evaluate(
        "[...el.querySelector('table').rows].map(row => [...row.cells].map(cell => cell.textContent.trim()))"
    )
    assert len(rows) == len(shown)
    heads = rows[0]
    assert heads[: len(shown[0])] == shown[0]
    for row in rows[1:]:
        for key, value in values.items():
            assert float(row[heads.index(key)]) == value
    numbers = [cell for row in rows[1:] for cell in row if cell.strip("+-")[:1].isdigit()]
    assert numbers
    for cell in numbers:
        float(cell)


def test_the_link_is_copied(taken):
    page, view, values = taken
    page.evaluate(
        """() => {
             const value = { writeText: async (text) => { window.got = text; } };
             Object.defineProperty(navigator, 'clipboard', { value });
           }"""
    )
    page.get_by_role("button", name="Copy link").click()
    page.wait_for_function("window.got")
    for key, value in values.items():
        assert f"{key}={value:g}" in page.evaluate("window.got").split(f"#{view.system}:")[1]
