"""Give each page a description, and what a link to it shows elsewhere: title, description and picture.

The descriptions stand in ``page_descriptions`` of ``_config.yml``, by the page's name.  The picture is the
vehicle from the side, drawn when the book is built.  With ``html_baseurl`` its address is absolute, as most
readers of such data want it.
"""

from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from matplotlib.figure import Figure
from sphinx.application import Sphinx
from sphinx.util import logging

import rlswaim as rl
from rlswaim.edition.designs import instrument_stations
from rlswaim.figures.side_view import draw_side_view

PICTURE = "_static/preview.png"
SIZE = (12.0, 6.3)
"""Inches of 100 pixels: 1200 by 630, as previews of links are shown."""


def tags(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document) -> None:
    """Add the description and the preview's data to the head of a page that has a text."""
    if doctree is None:
        return
    told = app.config.page_descriptions.get(page)
    if told is None:
        where = "page_descriptions in _config.yml"
        logging.getLogger(__name__).warning("%s: got none for %s, wanted a sentence", where, page)
        return
    base = app.config.html_baseurl
    picture = f"{base.rstrip('/')}/{PICTURE}" if base else context["pathto"](PICTURE, resource=True)
    properties = {
        "og:type": "article",
        "og:site_name": app.config.html_title,
        "og:title": nodes.document.astext(app.env.titles[page]),
        "og:description": told,
        "og:image": picture,
        "og:image:width": f"{SIZE[0] * 100:.0f}",
        "og:image:height": f"{SIZE[1] * 100:.0f}",
        "og:image:alt": "A long booster from the side, with its axes, surfaces and sensors",
    }
    lines = [f'<meta name="description" content="{escape(told)}" />']
    lines += [f'<meta property="{name}" content="{escape(text)}" />' for name, text in properties.items()]
    context["metatags"] = "\n".join([context.get("metatags", ""), *lines])


def draw(app: Sphinx, exception: Exception | None) -> None:
    """Draw the picture beside the other static files of the built pages."""
    if exception is None and app.builder.format == "html":
        figure = Figure(figsize=SIZE, dpi=100, layout="constrained")
        axes = figure.add_subplot()
        draw_side_view(axes, rl.swaim_booster(), instrument_stations())
        axes.set_title(f"{app.config.html_title}\nan executable, critical edition", fontsize=24)
        figure.savefig(Path(app.outdir) / PICTURE, metadata={"Software": None})


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the descriptions and what is made of them."""
    app.add_config_value("page_descriptions", {}, "html")
    app.connect("html-page-context", tags)
    app.connect("build-finished", draw)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
