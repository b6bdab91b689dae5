"""Give each page the live views' script as a file that all pages share, in place of a copy for each view.

The state of a view's widget holds the script that draws it and its style sheet.  The page loads
both from ``_static``, and a line that refers to the loaded script takes their place in the state.
"""

import json
from typing import Any

from sphinx.application import Sphinx

SHARED = {"_esm": "export default globalThis.rlswaimViews;", "_css": ""}


def share(app: Sphinx, pagename: str, *_: object) -> None:
    """Replace script and style in the state of a page's widgets, before it is written into the page."""
    files = app.env.nb_metadata.get(pagename, {}).get("js_files", {})  # type: ignore[attr-defined]
    if "ipywidgets_state" not in files:
        return
    address, attributes = files["ipywidgets_state"]
    state = json.loads(attributes["body"])
    for model in state["state"].values():
        if model["state"].get("_anywidget_id", "").startswith("rlswaim."):
            model["state"] |= SHARED
    body = json.dumps(state, separators=(",", ":")).replace("</", r"<\/")
    files["ipywidgets_state"] = (address, {**attributes, "body": body})
    app.add_css_file("rlswaim-views.css")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx: after the notebooks are read, before their widgets are put into the pages."""
    app.connect("html-page-context", share, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
