"""Serve the script of searchable tables (itables' DataTables) with the book, once, from its own files.

A table is one of the page, written by its notebook; the script makes those of cells with the tag
``searchable`` searchable.  Without scripts, and on paper, all rows stand there.
"""

import shutil
from pathlib import Path
from typing import Any

import itables
from sphinx.application import Sphinx

HERE = Path(__file__).parent
BUNDLE = Path(itables.__file__).parent / "html"
FILES = (
    BUNDLE / "dt_bundle.js",
    BUNDLE / "dt_bundle.css",
    HERE / "searchable_tables.css",
    HERE / "searchable_tables.js",
)


def copy(app: Sphinx, exception: Exception | None) -> None:
    """Put scripts and styles beside the other static files of the built pages."""
    if exception is None and app.builder.format == "html":
        for path in FILES:
            shutil.copy(path, Path(app.outdir) / "_static" / path.name)


def load(app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any) -> None:
    """Load scripts and style on pages that have such a table."""
    if doctree is not None and "tag_searchable" in context.get("body", ""):
        app.add_js_file("searchable_tables.js", type="module")
        app.add_css_file("dt_bundle.css")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the copying with Sphinx, and our style with every page."""
    app.connect("build-finished", copy)
    app.add_css_file("searchable_tables.css")
    app.connect("html-page-context", load)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
