"""Show a live view's still, the PNG of its cell, where no script runs, and in the whole book on paper."""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

VIEW, STILL = "application/vnd.jupyter.widget-view+json", "image/png"
LINE = "This view is live where the browser runs scripts; this is a still of it, without sliders and tables."


class Stills(SphinxPostTransform):
    """Put the still beside the live view, before one of both is selected."""

    default_priority = 3
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Run the transform."""
        for bundle in list(self.document.findall(nodes.container)):
            parts = {part.get("mime_type"): part for part in bundle if isinstance(part, nodes.container)}
            if {VIEW, STILL} <= set(parts):
                (image,) = parts[STILL].findall(nodes.image)
                still = image.deepcopy()
                still["alt"] = "Still of the live view"
                index = bundle.parent.index(bundle)
                if self.app.builder.name == "singlehtml":
                    bundle.parent.insert(index, still)
                else:
                    bundle.parent.insert(
                        index, [_html("<noscript>"), nodes.paragraph("", LINE), still, _html("</noscript>")]
                    )


def _html(text: str) -> nodes.raw:
    return nodes.raw("", text, format="html")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the transform with Sphinx."""
    app.add_post_transform(Stills)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
