"""Set the symbols in tables as symbols: K_A with its index, omega_1 as a Greek letter, ft^2 with a raised 2.

A table's cells are plain texts, as the library names things; a formula or code among them stays as it is.
A cell that is a name of the library and no symbol (alpha_deg, "rigid gain_dB") says what
`source/data/names.csv` has for it.
"""

import re
import unicodedata
from collections.abc import Iterator
from html import escape, unescape
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

from rlswaim.edition.notation import GREEK
from rlswaim.source.tables import read_table

LETTERS = "|".join(sorted(GREEK, key=len, reverse=True))
INDEX = rf"(?:\d?(?:{LETTERS}|q)?\d?[a-z]?(?:dot)?|CG|sp|fl|ins|tvc|[A-Za-z]{{1,2}}\d?)"
SYMBOL = rf"\b(?<!\w-)(?:(?:[A-Za-z]|kK|calM|[FQ][12]|{LETTERS})(?:_{INDEX})+|{LETTERS})(?:dot)?\b"
POWER = r"(?<=[\w)])\^-?\d+"
PARTS = re.compile(f"(?P<symbol>{SYMBOL})|(?P<power>{POWER})")
WORDS = {row["name"]: row["shown"] for row in read_table("names")}
CHOICE = " (a choice)"
KEPT = (nodes.math, nodes.literal, nodes.raw, nodes.emphasis, nodes.subscript)
DOT = "\N{COMBINING DOT ABOVE}"


def letter(name: str) -> list[nodes.Node]:
    """Return a letter, a Greek one by its name, with a dot for a rate and its number below."""
    plain = name.removesuffix("dot")
    count, found, digits = re.fullmatch(r"(\d*)([A-Za-z]*)(\w*)", plain).groups()  # type: ignore[union-attr]
    if found in GREEK:
        size = "SMALL" if found.islower() else "CAPITAL"
        found = unicodedata.lookup(f"GREEK {size} LETTER {found.upper()}")
    before = [nodes.Text(count)] if count else []
    below = [nodes.subscript("", digits)] if digits else []
    at = [nodes.emphasis("", found + (DOT if plain != name else ""))] if found else []
    return [*before, *at, *below]


def symbol(name: str) -> list[nodes.Node]:
    """Return a name such as C_N_alpha as letters, each index below its letter."""
    head, _, rest = name.partition("_")
    index = [nodes.subscript("", "", *symbol(rest))] if rest else []
    return [*letter(head), *index]


def said(text: str) -> str:
    """Return a cell's text with a name of the library in words: one that is all of it, or beside a mode."""
    *before, name = text.split(" ")
    if text.endswith(CHOICE):
        return said(text.removesuffix(CHOICE)) + CHOICE
    return " ".join([*before, WORDS.get(name, name)]) if all(map(str.isalnum, before)) else text


def typeset(text: str) -> Iterator[nodes.Node]:
    """Give the parts of a text: its symbols and powers as such, the rest as it is."""
    text = said(text)
    if re.fullmatch(r"[spz]\^\d", text):
        yield from (nodes.emphasis("", text[0]), nodes.superscript("", text[2:]))
        return
    end = 0
    for found in PARTS.finditer(text):
        if found.start() > end:
            yield nodes.Text(text[end : found.start()])
        yield from symbol(found[0]) if found["symbol"] else [nodes.superscript("", found[0][1:])]
        end = found.end()
    if end < len(text):
        yield nodes.Text(text[end:])


TAGS = {nodes.emphasis: "em", nodes.subscript: "sub", nodes.superscript: "sup"}
CELL = re.compile(r"(<t[dh]\b[^>]*>)([^<]+)(?=</t[dh]>)")


def as_html(node: nodes.Node) -> str:
    """Return a part of a text as HTML."""
    inner = "".join(map(as_html, node.children))
    return f"<{TAGS[type(node)]}>{inner}</{TAGS[type(node)]}>" if type(node) in TAGS else escape(str(node))


def in_html(table: str) -> str:
    """Return a table that is HTML already, such as one of pandas, with the symbols in its cells set."""
    return CELL.sub(lambda cell: cell[1] + "".join(map(as_html, typeset(unescape(cell[2])))), table)


class TypesetTables(SphinxPostTransform):
    """Set the symbols in all cells."""

    default_priority = 4
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Run the transform."""
        for entry in list(self.document.findall(nodes.entry)):
            for text in list(entry.findall(nodes.Text)):
                if not isinstance(text.parent, KEPT) and (PARTS.search(text) or said(str(text)) != text):
                    text.parent.replace(text, list(typeset(str(text))))
        for raw in list(self.document.findall(nodes.raw)):
            if "<table" in raw.astext():
                raw.parent.replace(raw, nodes.raw("", in_html(raw.astext()), **raw.attributes))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the transform with Sphinx."""
    app.add_post_transform(TypesetTables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
