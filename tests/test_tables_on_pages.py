"""Tables of the built pages: symbols are set as symbols, and what the search field finds by its name."""

import json
import re
import sys
from html import unescape
from pathlib import Path

import pytest

from conftest import HTML

sys.path.insert(0, str(Path(__file__).parent.parent / "book" / "extensions"))
from typeset_tables import in_html, typeset

BOOK = Path(__file__).parent.parent / "book"
PAGES = sorted(path.stem for path in BOOK.iterdir() if path.suffix in (".ipynb", ".md"))
BARE = re.compile(
    r"\b(?:omega|phi|zeta|alpha|theta|gamma|delta|sigma)(?:_\w)?\b|\b(?<!\w-)[A-Zl]_\w|\^\d|\b\w+_\w+"
)


def set_as(text: str) -> str:
    return "".join(map(str, typeset(text)))


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("omega_1", "<emphasis>ω</emphasis><subscript>1</subscript>"),
        ("slug ft^2", "slug ft<superscript>2</superscript>"),
        ("K_A (rad/rad)", "<emphasis>K</emphasis><subscript><emphasis>A</emphasis></subscript> (rad/rad)"),
        ("s^8", "<emphasis>s</emphasis><superscript>8</superscript>"),
        ("delta rate", "<emphasis>δ</emphasis> rate"),
        ("pade_order of jet_lb", "pade_order of jet_lb"),
        ("eq75-K_A", "eq75-K_A"),
        ("no symbol, 10 percent", "no symbol, 10 percent"),
        ("alpha_deg", "<emphasis>α</emphasis>"),
        ("bending 1 delay_s", "bending 1 delay margin"),
        ("sensor_a (a choice)", "first sensor (a choice)"),
        (
            "mode_3_ratio",
            "<emphasis>ω</emphasis><subscript>3</subscript> / <emphasis>ω</emphasis><subscript>2</subscript>",
        ),
    ],
)
def test_a_cell_sets_its_symbols(text, wanted):
    assert set_as(text) == wanted


def test_a_table_of_pandas_is_set_too():
    table = '<table class="dataframe"><tr><th>K_A</th><td>ft &lt; s^2</td><td>&nbsp;</td></tr></table>'
    wanted = "<th><em>K</em><sub><em>A</em></sub></th><td>ft &lt; s<sup>2</sup></td>"
    assert wanted in in_html(table)


def test_indices_stand_below_each_other():
    inner = "<subscript><emphasis>N</emphasis><subscript><emphasis>α</emphasis></subscript></subscript>"
    assert set_as("C_N_alpha") == f"<emphasis>C</emphasis>{inner}"
    assert "θ\N{COMBINING DOT ABOVE}" in set_as("M_thetadot")


@pytest.mark.parametrize("path", sorted(BOOK.glob("*.ipynb")), ids=lambda path: path.stem)
def test_no_words_in_a_stored_figure_have_bare_symbols(path):
    """Titles, labels and legends set a symbol as a formula, in which no Greek letter is spelled."""
    stored = json.loads(path.read_text(encoding="utf-8"))
    outputs = [output for cell in stored["cells"] for output in cell.get("outputs", [])]
    pictures = ["".join(output.get("data", {}).get("image/svg+xml", "")) for output in outputs]
    texts = [
        text for picture in pictures for text in re.findall(r"<text\b[^>]*>(.*?)</text>", picture, re.DOTALL)
    ]
    words = [unescape(re.sub(r"<[^>]+>", "", text)).strip() for text in texts]
    assert [text for text in words if BARE.search(text)] == []


def cells(page: str) -> list[str]:
    """Return the texts of a built page's table cells, without formulas and code."""
    html = (HTML / "book" / f"{page}.html").read_text(encoding="utf-8")
    html = re.sub(r"<(noscript|script|code)\b.*?</\1>", "", html, flags=re.DOTALL)
    html = re.sub(r'<span class="math[^"]*">.*?</span>', "", html, flags=re.DOTALL)
    tables = re.findall(r"<table.*?</table>", html, flags=re.DOTALL)
    found = [
        cell for table in tables for cell in re.findall(r"<t[dh]\b[^>]*>(.*?)</t[dh]>", table, re.DOTALL)
    ]
    return [unescape(re.sub(r"<[^>]+>", "", cell)).strip() for cell in found]


@pytest.mark.parametrize("page", PAGES)
def test_no_table_of_a_page_has_bare_symbols(site, page):
    names_of_rows = re.compile(r"[a-z]+\d*-\S+(, [a-z]+\d*-\S+)*")
    texts = [cell for cell in cells(page) if not names_of_rows.fullmatch(cell)]
    assert [cell for cell in texts if BARE.search(cell)] == []


@pytest.mark.parametrize("typed", ["K_A", "omega", "phi_1"])
def test_the_search_of_all_numbers_finds_a_symbol_as_it_is_typed(visit, typed):
    with visit("book/12-agreement.html", plain=True) as (page, _, errors):
        field = page.get_by_role("searchbox").last
        field.fill(typed)
        page.wait_for_timeout(400)
        rows = page.locator("#printed-numbers tbody tr")
        assert rows.count() >= 3
        assert errors == []
