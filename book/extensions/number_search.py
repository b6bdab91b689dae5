r"""Let the book's search find numbers: 1940, 0.618 and 6.545e-10, also where a page has them as TeX.

Each number becomes one word of the index, ``=`` and its value as JavaScript writes it, whatever
form a page prints: ``=6.545e-10`` for ``6.545 \times 10^{-10}``.  The sign keeps parts of numbers
apart from whole ones: a search for 0.61 without a match finds 0.618, never 10.61.
``number_search.js`` reads what is typed with the same pattern.  Source code is not indexed.
"""

import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.search.en import SearchEnglish

SCRIPT = Path(__file__).parent / "number_search.js"
SPACE = r"(?:\s|\\[,;:! ])*"
EXPONENT = r"\{?([+\u2212-]?[0-9]+)\}?"
TEN_TO_THE = rf"10{SPACE}(?:\^|\*\*){SPACE}{EXPONENT}"
GROUPED = r"[1-9][0-9]{0,2}(?:(?:,|\{,\}|\\,)[0-9]{3})+(?![0-9])"
MANTISSA = rf"((?:{GROUPED}|[0-9]+)(?:\.[0-9]+)?|(?<!\w)\.[0-9]+)"
TIMES = rf"{SPACE}(?:\\times|\\cdot|[\u00d7\u00b7*x]){SPACE}"
PATTERN = rf"{TEN_TO_THE}|{MANTISSA}(?:[eE]([+\u2212-]?[0-9]+)|{TIMES}{TEN_TO_THE})?|\w+"
"""A power of ten, a number, or a word: the groups are a power, a mantissa, and its exponent in two forms."""

PARTS = re.compile(PATTERN)
CLASS = re.compile(r"\\class\{[^}]*\}")
BETWEEN = re.compile(r"</?(?:t[dhr]|p|div|br|li|dt|dd|text|tspan)\b[^>]*>")


def as_javascript(value: float) -> str:
    """Return a number that is not negative with the digits that JavaScript's ``String`` gives it."""
    if value == 0 or 1e-6 <= value < 1e21:
        return np.format_float_positional(value, trim="-")
    return np.format_float_scientific(value, trim="-", exp_digits=1)


def index_word(found: re.Match[str]) -> str:
    """Return the index's word for a match of the pattern."""
    power, mantissa, *exponents = found.groups(default="")
    if not power and not mantissa:
        return found[0]
    digits = re.sub("[^0-9.]", "", mantissa) or "1"
    exponent = "".join([power, *exponents]).replace("\N{MINUS SIGN}", "-") or "0"
    return f"={as_javascript(float(f'{digits}e{exponent}'))}"


class SearchWordsAndNumbers(SearchEnglish):
    """English, with each number as a word."""

    js_splitter_code = (
        f"var WORDS_AND_NUMBERS = new RegExp({json.dumps(PATTERN)}"
        r".replaceAll('\\w', '[\\p{L}\\p{N}_]'), 'gu');"
    )

    def split(self, input: str) -> list[str]:
        """Return a text's words and numbers."""
        return [index_word(found) for found in PARTS.finditer(input)]


def searched(doctree: nodes.document) -> nodes.document:
    """Return a page's text as indexed: without code and names of classes in TeX, ``^`` before powers."""
    page = doctree.deepcopy()
    for code in list(page.findall(nodes.literal_block)):
        code.parent.remove(code)
    for math in [*page.findall(nodes.math), *page.findall(nodes.math_block)]:
        math[:] = [nodes.Text(CLASS.sub("", math.astext()))]
    for raw in page.findall(nodes.raw):
        raw[:] = [nodes.Text(BETWEEN.sub(" ", raw.astext().replace("<sup>", "^")))]
    raised = list(page.findall(nodes.superscript))
    for power in raised:
        power.insert(0, nodes.Text("^"))
    for text in {id(power.parent): power.parent for power in raised}.values():
        text[:] = [nodes.Text(text.astext())]
    return page


def index_searched_text(app: Sphinx) -> None:
    """Give the builder's index the text of ``searched`` for each page."""
    if app.builder.format == "html":
        index_page = app.builder.index_page  # type: ignore[attr-defined]
        app.builder.index_page = lambda name, doctree, title: index_page(name, searched(doctree), title)  # type: ignore[attr-defined]


def load(app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any) -> None:
    """Load the script on the page of the search, after Sphinx's own."""
    if pagename == "search":
        app.add_js_file(SCRIPT.name, loading_method="defer")


def copy(app: Sphinx, exception: Exception | None) -> None:
    """Put the script beside the other static files of the built pages."""
    if exception is None and app.builder.format == "html":
        shutil.copy(SCRIPT, Path(app.outdir) / "_static" / SCRIPT.name)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the language of the search, its script and what is indexed with Sphinx."""
    app.add_search_language(SearchWordsAndNumbers)
    app.connect("builder-inited", index_searched_text)
    app.connect("html-page-context", load)
    app.connect("build-finished", copy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
