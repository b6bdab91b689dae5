"""Put a button beside a page's reading time, to its first live view and called as that view's section."""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

VIEW = "application/vnd.jupyter.widget-view+json"
BEGINS, PLACE = "Reading time", "live-view"


def is_live(node: nodes.Node) -> bool:
    """Return whether a node is one of the forms of an output that is shown as a live view."""
    return isinstance(node, nodes.container) and node.get("mime_type") == VIEW


class FirstView(SphinxPostTransform):
    """Add the button, before one of the forms of each output is selected."""

    default_priority = 2
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Run the transform."""
        times = (p for p in self.document.findall(nodes.paragraph) if p.astext().startswith(BEGINS))
        view, paragraph = next(self.document.findall(is_live), None), next(times, None)
        if view is None or paragraph is None:
            return
        cell, section = view.parent.parent, view.parent
        while not isinstance(section, nodes.section):
            section = section.parent
        cell["ids"].append(PLACE)
        title = next(section.findall(nodes.title)).astext()
        button = nodes.reference("", title, refid=PLACE, classes=["to-view"], internal=True)
        paragraph.insert(0, [button, nodes.Text(" ")])


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the transform with Sphinx."""
    app.add_post_transform(FirstView)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
