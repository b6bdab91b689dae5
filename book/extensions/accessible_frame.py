"""Mend the names by which a screen reader knows the theme's buttons and folds: the words that show."""

import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

MENDED = (
    # A fold is called by its title.
    (re.compile(r'<summary aria-label="[^"]*">'), "<summary>"),
    # The search button's words are its name.
    (re.compile(r'(<button class="btn search-button-field[^>]*?) aria-label="[^"]*"'), r"\1"),
    # The list of references has entries of a role of their own, which a list may not have.
    (re.compile(r'<div role="list" class="citation-list">'), '<div class="citation-list">'),
    # The button of the color mode has a name; its pictures need none.
    (re.compile(r'(<i class="theme-switch[^>]*?) title="[^"]*"'), r"\1"),
)


def mended(page: str) -> str:
    """Return a page whose buttons and folds are called by the words that show."""
    for pattern, replacement in MENDED:
        page = pattern.sub(replacement, page)
    return page


def write(app: Sphinx, exception: Exception | None) -> None:
    """Mend all pages; of a page that is mended already nothing changes."""
    if exception is None and app.builder.format == "html":
        for path in Path(app.outdir).rglob("*.html"):
            path.write_text(mended(path.read_text(encoding="utf-8")), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx, after all that writes into pages."""
    app.connect("build-finished", write, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
