"""Say how to cite the edition and the report, from CITATION.cff.

``:::{how-to-cite}`` and ``:::`` set each of both as a line of text and as a BibTeX entry.
"""

from pathlib import Path
from typing import Any

import yaml
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

FILE = Path(__file__).parents[2] / "CITATION.cff"


def authors(work: dict[str, Any], joint: str) -> str:
    """Return a work's authors, the names of persons with the first name in front."""
    names = [one.get("name") or f"{one['given-names']} {one['family-names']}" for one in work["authors"]]
    return joint.join(names)


def fields(work: dict[str, Any]) -> dict[str, str]:
    """Return the fields of a work's BibTeX entry; a name that is no person's stands in braces."""
    person = "family-names" in work["authors"][0]
    publisher = work.get("institution", {})
    found = {
        "author": authors(work, " and ") if person else f"{{{authors(work, ' and ')}}}",
        "title": f"{{{work['title']}}}",
        "institution": publisher.get("name"),
        "address": publisher.get("location"),
        "version": work.get("version"),
        "year": work.get("year"),
    }
    return {name: str(value) for name, value in found.items() if value}


def bibtex(work: dict[str, Any], key: str) -> str:
    """Return a ``work`` of CITATION.cff as a BibTeX entry under a ``key``."""
    kind = {"report": "techreport"}.get(work["type"], work["type"])
    lines = [f"  {name} = {{{value}}}" for name, value in fields(work).items()]
    return "\n".join([f"@{kind}{{{key},", ",\n".join(lines), "}"])


def sentence(work: dict[str, Any]) -> nodes.paragraph:
    """Return a ``work`` of CITATION.cff as a line of a list of references."""
    publisher = work.get("institution", {})
    version = f"Version {work['version']}" if "version" in work else ""
    parts = [version, publisher.get("name"), publisher.get("location"), work.get("year")]
    rest = ", ".join(str(part) for part in parts if part)
    title = nodes.emphasis("", work["title"])
    return nodes.paragraph("", "", nodes.Text(f"{authors(work, ', ')}. "), title, nodes.Text(f". {rest}."))


class HowToCite(SphinxDirective):
    """The edition and the report, as CITATION.cff has them."""

    def run(self) -> list[nodes.Node]:
        """Run the directive."""
        self.env.note_dependency(str(FILE))
        cff = yaml.safe_load(FILE.read_text(encoding="utf-8"))
        found: list[nodes.Node] = []
        for key, work in {"rlswaim": cff, "swaim1964": cff["references"][0]}.items():
            entry = bibtex(work, key)
            found += [
                sentence(work),
                nodes.literal_block(entry, entry, language="bibtex"),
            ]
        return found


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directive with Sphinx."""
    app.add_directive("how-to-cite", HowToCite)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
