"""The whole book as one PDF, printed of a small book: contents, links, outline, and folds that are open."""

import re
import subprocess
import sys
import threading
from io import BytesIO
from pathlib import Path

import nbformat
import pytest
from pypdf import PdfReader
from pypdf.generic import Destination

import whole_book
from serve import server
from whole_book import at_the_root, main

EXTENSIONS = Path(whole_book.__file__).parent / "extensions"
CONF = """
extensions = ["myst_nb", "sphinx_design"]
root_doc = "book/preface"
myst_enable_extensions = ["colon_fence"]
nb_execution_mode = "off"
html_theme = "sphinx_book_theme"
html_static_path = [{extensions!r} + "/print.css", {extensions!r} + "/folds_on_paper.js"]
html_css_files, html_js_files = ["print.css"], ["folds_on_paper.js"]
"""
PREFACE = """# The booster

## How to read

See [what helps](#the-gains).

```{toctree}
first
second
```
"""
FIRST = "# I. Motion\n\n## Axes\n\n" + "A line.\n\n" * 150 + "## What follows\n\nText.\n"
SECOND = """# II. Loops

(the-gains)=
## Gains

:::{dropdown} Solution
The root moves by seven.
:::
"""
HEADINGS = ["The booster", "How to read", "I. Motion", "Axes", "What follows", "II. Loops", "Gains"]
TABLE = "<table><tr><td>a hidden 8.25</td></tr></table>"


@pytest.fixture(scope="module")
def built(tmp_path_factory) -> Path:
    """A small book, built as the whole one is."""
    folder = tmp_path_factory.mktemp("book")
    source = folder / "source" / "book"
    source.mkdir(parents=True)
    (source.parent / "conf.py").write_text(CONF.format(extensions=str(EXTENSIONS)), encoding="utf-8")
    (source / "preface.md").write_text(PREFACE, encoding="utf-8")
    (source / "first.md").write_text(FIRST, encoding="utf-8")
    output = nbformat.v4.new_output("display_data", {"text/html": TABLE, "text/plain": "8.25"})
    cell = nbformat.v4.new_code_cell("secret = 1", outputs=[output], metadata={"tags": ["hide-cell"]}, id="b")
    text = nbformat.v4.new_markdown_cell(SECOND, id="a")
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(nbformat.v4.new_notebook(cells=[text, cell], metadata=kernel), source / "second.ipynb")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "-n", "-b", "singlehtml"]
    subprocess.run([*command, str(source.parent), str(folder / "html")], check=True)
    return folder / "html"


@pytest.fixture(scope="module")
def book(built) -> PdfReader:
    """The PDF of the small book."""
    output = built.parent / "book.pdf"
    main(str(built), str(output))
    return PdfReader(output)


def headings(outline: list) -> list[Destination]:
    """Return the entries of an outline, those under others too."""
    return [e for part in outline for e in (headings(part) if isinstance(part, list) else [part])]


def targets(book: PdfReader, page: int) -> list[str]:
    """Return the names of the places within the PDF to which links of a page lead."""
    links = [note.get_object() for note in book.pages[page].get("/Annots", [])]
    return [str(link["/Dest"]).removeprefix("/") for link in links if "/Dest" in link]


def test_contents_stand_before_the_text_with_numbers_of_pages(book):
    title, _, contents = book.pages[0].extract_text().partition("Contents\n")
    assert title == "The booster\n"
    lines = dict(re.findall(r"^(.+?) (\d+)$", contents, re.MULTILINE))
    assert list(lines) == HEADINGS
    for words, number in lines.items():
        assert words in book.pages[int(number) - 1].extract_text()
    assert int(lines["Gains"]) > int(lines["Axes"]) > 1


def test_each_line_of_the_contents_leads_to_its_page(book):
    places = {name.removeprefix("/"): place for name, place in book.named_destinations.items()}
    pages = [book.get_destination_page_number(places[name]) + 1 for name in targets(book, 0)]
    numbers = re.findall(r" (\d+)$", book.pages[0].extract_text(), re.MULTILINE)
    assert len(pages) == len(HEADINGS)
    assert pages == [int(number) for number in numbers]


def test_a_link_of_the_text_leads_within_the_book(book):
    places = {name.removeprefix("/") for name in book.named_destinations}
    assert "the-gains" in targets(book, 1)
    assert "the-gains" in places


def test_the_outline_has_the_headings(book):
    title, *rest = HEADINGS
    assert [entry.title for entry in headings(book.outline)] == [title, "Contents", *rest]


def assert_folds_are_printed(text: str) -> None:
    """The solution and the folded table are there, the table's code is not."""
    assert "The root moves by seven." in text
    assert "a hidden 8.25" in text
    assert "secret" not in text


def test_folds_are_printed_in_the_whole_book(book):
    assert_folds_are_printed(book.pages[-1].extract_text())


def test_folds_are_printed_as_a_reader_prints_a_page(built, browser):
    with server(built) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        page = browser.new_page()
        page.goto(f"http://127.0.0.1:{running.server_port}/{at_the_root(built)}")
        paper = PdfReader(BytesIO(page.pdf(format="A4")))
        page.close()
        running.shutdown()
    assert_folds_are_printed(paper.pages[-1].extract_text())
