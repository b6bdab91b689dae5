"""A page on paper: pictures that nobody has scrolled to, no controls, solutions and folded tables."""

import pytest

PAPER = ("book/05-single-sensor.html", "book/02-trajectory-and-modes.html")
FOLDED = "details.sd-dropdown, .tag_hide-cell details.hide"
CODE = ".bd-article details.hide .cell_input"
CONTROLS = ".live-view :is(button, select, [type=range], .slider-container, [role=slider])"
DRAWN = """canvas => {
  const { width, height } = canvas;
  const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
  return new Uint32Array(data.buffer).some((pixel, _, all) => pixel !== all[0]);
}"""
SETTLED = """() => [...document.querySelectorAll('[data-explorer]')].every(
  view => view.querySelector('table tbody tr'))"""


@pytest.fixture(scope="module", params=PAPER)
def paper(visit, request):
    """A page that is loaded, and never scrolled, at the moment in which it is printed."""
    with visit(request.param) as (page, _, errors):
        page.wait_for_function(SETTLED)
        page.emulate_media(media="print")
        page.evaluate("() => void window.dispatchEvent(new Event('beforeprint'))")
        yield page
        assert errors == []


def shown(page, selector):
    """Return those of the elements that can be seen."""
    return [found for found in page.locator(selector).all() if found.is_visible()]


def test_each_picture_is_drawn(paper):
    canvases = shown(paper, ".live-view canvas")
    assert canvases
    assert [canvas.get_attribute("data-plane") for canvas in canvases if not canvas.evaluate(DRAWN)] == []


def test_map_and_responses_of_a_workbench_are_drawn(paper):
    if "single-sensor" not in paper.url:
        assert shown(paper, "[data-plane]")
        return
    planes = {canvas.get_attribute("data-plane") for canvas in shown(paper, ".live-view canvas")}
    assert planes >= {"locus", "map", "responses"}
    assert paper.locator("[data-plane=map]").first.evaluate("map => !map.classList.contains('stale')")


def test_no_control_is_printed(paper):
    assert paper.locator(CONTROLS).count() > 0
    assert shown(paper, CONTROLS) == []


def test_solutions_and_tables_are_printed_without_code(paper):
    text = paper.locator("body").inner_text()
    folds = paper.locator(FOLDED).all()
    assert folds
    for fold in folds:
        last = fold.locator("p:visible, td:visible").last.inner_text().strip()
        assert last
        assert last in text
    assert shown(paper, CODE) == []


def test_folds_close_again(visit):
    with visit(PAPER[1]) as (page, _, errors):
        state = f"() => [...document.querySelectorAll('{FOLDED}')].map(fold => fold.open)"
        page.locator(FOLDED).last.evaluate("fold => { fold.open = true; }")
        before = page.evaluate(state)
        page.evaluate("() => void window.dispatchEvent(new Event('beforeprint'))")
        assert all(page.evaluate(state))
        page.evaluate("() => void window.dispatchEvent(new Event('afterprint'))")
        assert page.evaluate(state) == before
        assert set(before) == {True, False}
        assert errors == []
