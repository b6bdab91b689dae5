"""Serve the script of searchable tables (itables' DataTables) with the book, once, from its own files.

The notebooks name ``../_static/dt_bundle.js``; it and its style are copied there from the
installed itables, so that no page asks another server and no page carries a copy.
"""

import shutil
from pathlib import Path
from typing import Any

import itables
from sphinx.application import Sphinx

HERE = Path(__file__).parent
BUNDLE = Path(itables.__file__).parent / "html"
FILES = (BUNDLE / "dt_bundle.js", BUNDLE / "dt_bundle.css", HERE / "searchable_tables.css")


def copy(app: Sphinx, exception: Exception | None) -> None:
    """Put scripts and styles beside the other static files of the built pages."""
    if exception is None and app.builder.format == "html":
        for path in FILES:
            shutil.copy(path, Path(app.outdir) / "_static" / path.name)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the copying with Sphinx, and our style with every page."""
    app.connect("build-finished", copy)
    app.add_css_file("searchable_tables.css")
    return {"parallel_read_safe": True, "parallel_write_safe": True}
