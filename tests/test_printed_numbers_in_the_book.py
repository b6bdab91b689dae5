"""The built chapters: each equation of the report stands once, its numbers tied to the rows of the ledger."""

from collections import Counter
from pathlib import Path

import pytest

from rlswaim.edition.tables_as_printed import printed_table
from rlswaim.source.equations import templates

BOOK = Path(__file__).parent.parent / "book"
CHAPTERS = [f"book/{path.stem}.html" for path in sorted(BOOK.glob("0[1-7]-*.ipynb"))]
NUMBERED = {key: found.entries for key, found in templates().items() if found.numbered}

SHOWN = """() => ({
  equations: [...document.querySelectorAll('div.report-equation')].map((el) => [
    el.id.replace('equation-eq-', ''),
    [...el.querySelectorAll('.printed')].map((number) => number.dataset.entry),
  ]),
  tables: [...document.querySelectorAll('table.report-table')].map((el) => [
    el.id, [...el.querySelectorAll('.printed')].map((number) => number.dataset.entry),
  ]),
})"""


@pytest.fixture(scope="module")
def shown(visit):
    """What all chapters show: equations and tables with the entries of their numbers."""
    found = {"equations": [], "tables": []}
    for path in CHAPTERS:
        with visit(path) as (page, outside, errors):
            page.wait_for_function("() => document.documentElement.dataset.printedNumbers")
            for kind, rows in page.evaluate(SHOWN).items():
                found[kind] += [(name, tuple(entries)) for name, entries in rows]
            assert (outside, errors) == ([], [])
    return found


def test_each_equation_of_the_report_stands_once_with_its_numbers(shown):
    assert len(CHAPTERS) == 7
    counts = Counter(name for name, _ in shown["equations"] if name)
    assert counts == dict.fromkeys(NUMBERED, 1)
    assert {name: entries for name, entries in shown["equations"] if name} == NUMBERED


def test_what_has_no_number_stands_once_too(shown):
    wanted = Counter(found.entries for found in templates().values() if not found.numbered)
    assert Counter(entries for name, entries in shown["equations"] if not name) == wanted


def test_each_table_of_the_report_stands_once_with_its_numbers(shown):
    assert shown["tables"] == [(f"tab-{n}", printed_table(n).entries) for n in (1, 2, 3)]


@pytest.mark.parametrize(("number", "entry"), [(38, "eq38-M_q1"), (137, "eq137-pole-c4-im")])
def test_a_card_s_link_arrives_at_its_row(visit, number, entry):
    (chapter,) = (path for path in CHAPTERS if path[5:7] == ("03" if number == 38 else "07"))
    with visit(chapter) as (page, outside, errors):
        page.wait_for_function("() => document.documentElement.dataset.printedNumbers")
        page.locator(f"[id='equation-eq-{number}'] .printed[data-entry='{entry}']").first.dispatch_event(
            "click"
        )
        page.locator(".printed-card a").click()
        row = page.locator("#printed-numbers tr.printed-row-found")
        row.wait_for()
        assert row.get_attribute("id") == entry
        assert row.locator("td").first.text_content() == entry
        page.wait_for_function(
            "() => document.querySelector('.printed-row-found').getBoundingClientRect().top > 0"
        )
        assert row.evaluate("el => el.getBoundingClientRect().top < innerHeight")
        assert (outside, errors) == ([], [])
