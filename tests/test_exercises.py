"""Each chapter has three exercises with folded solutions, one of them on its live view."""

import re
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote

import nbformat
import numpy as np
import pytest

from exact import paired
from livepage import PAGES, LivePage, library, live

BOOK = Path(__file__).parent.parent / "book"
CHAPTERS = sorted([*BOOK.glob("0[1-8]-*.ipynb"), *BOOK.glob("1[5-9]-*.ipynb"), *BOOK.glob("20-*.ipynb")])
ELSEWHERE = {
    "16-designs-and-loads": "dual-actuation",
    "17-ladder-of-models": "dual-actuation",
    "20-own-loop": "own-loop",
}
"""Chapters whose view has another page in `PAGES`, or none."""
EXERCISE = re.compile(r"^:::\{admonition\} Exercise (\d)\n:class: exercise\n(.+?)\n:::$", re.M | re.S)
SOLUTION = re.compile(r"^:::\{dropdown\} Solution of exercise (\d)\n(.+?)\n:::$", re.M | re.S)
BUILT = """() => [...document.querySelectorAll('article .admonition.exercise')].map(el => {
  const next = el.nextElementSibling;
  return [el.querySelector('.admonition-title').textContent.trim(), next.matches('details.sd-dropdown'),
    next.open, next.querySelector('summary').textContent.trim(),
    [...el.querySelectorAll('a.view-state')].map(link => link.getAttribute('href'))];
})"""
CHOSEN = "panel => [...panel.querySelectorAll('.widget-dropdown select')].map(list => list.selectedIndex)"


class State(NamedTuple):
    """A view, and its parameters as an address names them."""

    view: str
    texts: dict[str, str]


def state_of(address: str) -> State:
    view, _, values = address.removeprefix("#").partition(":")
    return State(view, {key: unquote(text) for key, text in (pair.split("=") for pair in values.split(","))})


def is_a_value(grid: tuple, text: str) -> bool:
    """Whether a view takes this text for a parameter, and does not leave it as it is."""
    if isinstance(grid[0], str):
        return text in grid
    whole = all(isinstance(place, int) for place in grid)
    return bool(re.fullmatch(r"\d+", text) or not whole) and grid[0] <= float(text) <= grid[-1]


@pytest.fixture(scope="module")
def built(browser, site):
    """What the built chapters hold before any script runs, by the chapter's name."""
    page = browser.new_context(java_script_enabled=False).new_page()
    found = {}
    for path in CHAPTERS:
        page.goto(f"{site}/book/{path.stem}.html", wait_until="commit")
        page.wait_for_load_state("domcontentloaded")
        found[path.stem] = page.evaluate(BUILT)
    page.context.close()
    return found


def test_there_are_fourteen_chapters():
    assert len(CHAPTERS) == 14


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_each_solution_holds_computed_numbers(path):
    cells = nbformat.read(path, as_version=4).cells
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    assert [number for number, _ in EXERCISE.findall(text)] == ["1", "2", "3"]
    solutions = SOLUTION.findall(text)
    assert [number for number, _ in solutions] == ["1", "2", "3"]
    assert [number for number, solution in solutions if "{glue:text}`" not in solution] == []


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_each_exercise_is_followed_by_its_folded_solution(built, path):
    shown = [row[:4] for row in built[path.stem]]
    assert shown == [[f"Exercise {i}", True, False, f"Solution of exercise {i}"] for i in (1, 2, 3)]


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_one_exercise_opens_a_state_that_the_view_takes(visit, built, path):
    """The address names each parameter of a view of this page, within its slider's ends, and opens it."""
    (address,) = [link for *_, links in built[path.stem] for link in links]
    view, texts = state_of(address)
    here = f"book/{path.stem}.html"
    assert ELSEWHERE.get(path.stem) == view or PAGES[view] == here
    with live(visit, view, at=here) as opened:
        assert opened.page.locator("article a[href^='#'][href*=':']").count() == 1
        opened.page.locator("a.view-state").scroll_into_view_if_needed()
        opened.page.locator("a.view-state").click()
        opened.page.wait_for_function(
            "panel => Math.abs(panel.getBoundingClientRect().top) < innerHeight / 2",
            arg=opened.panel.element_handle(),
        )
        CHECKS.get(view, shown_values)(opened, texts)


def chosen_designs(opened: LivePage, texts: dict[str, str]) -> None:
    assert list(texts) == ["left", "right"]
    assert all(int(text) in range(len(library("comparison").designs)) for text in texts.values())
    assert opened.panel.evaluate(CHOSEN) == [int(text) for text in texts.values()]


def typed_loop(opened: LivePage, texts: dict[str, str]) -> None:
    """Check the loop and the gain that the workbench says it shows."""
    assert list(texts) == ["loop", "k"]
    address = f"#own-loop:loop={texts['loop']},k={texts['k']}"
    opened.page.wait_for_function("told => decodeURIComponent(location.hash) === told", arg=address)
    opened.page.wait_for_function("() => document.querySelectorAll('table.poles tbody tr').length === 3")
    poles = [complex(float(row["re"]), float(row["im"])) for _, row in opened.rows("table.poles")]
    gain = float(texts["k"])
    assert paired(np.array(poles), np.roots([1, 2, 2, gain])) == pytest.approx(np.array(poles), abs=1e-9)


def shown_values(opened: LivePage, texts: dict[str, str]) -> None:
    grids = {parameter.name: parameter.grid for parameter in opened.beside()}
    assert set(texts) == set(grids)
    assert [name for name, text in texts.items() if not is_a_value(grids[name], text)] == []
    for name, value in opened.values().items():
        assert value == (texts[name] if isinstance(value, str) else float(texts[name])), name


CHECKS = {"comparison": chosen_designs, "own-loop": typed_loop}


@pytest.mark.parametrize(
    ("grid", "good", "bad"),
    [((0, 1, 2), "2", "3"), ((0, 1, 2), "1", "1.5"), ((-1.0, 1.0), "0.25", "-2"), (("total",), "total", "x")],
)
def test_what_a_view_takes_is_told_from_what_it_does_not(grid, good, bad):
    assert is_a_value(grid, good)
    assert not is_a_value(grid, bad)
