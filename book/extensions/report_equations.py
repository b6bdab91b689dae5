"""Set the report's equations and tables with a verdict on each number, and a card that tells its ledger row.

``:::{report-equation} 38`` and ``:::`` set Eq. 38, numbered (38) and labelled ``eq-38``.  Several numbers
set several equations; ``46a`` sets what the report prints below Eq. 46 without a number.
``:::{report-table} 1`` and ``:::`` set Table 1 as the report lays it out, labelled ``tab-1``.
``:::{verdict-legend}`` and ``:::`` list the marks.

The card's script and style are served with the book from its own files; what the cards say is written
from the ledger into ``printed_numbers.js`` when the book is built.
"""

import json
import shutil
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.directives.patches import MathDirective
from sphinx.util.docutils import SphinxDirective

from rlswaim.edition.equations_as_printed import as_tex, classes, slug, template
from rlswaim.edition.ledger import VERDICTS, as_frame, ledger
from rlswaim.edition.tables_as_printed import printed_table, row_of

HERE = Path(__file__).parent
FILES = ("report_equations.js", "report_equations.css")
CELLS = ("where", "quantity", "printed", "computed", "unit", "difference (%)", "verdict", "why")


class ReportEquation(SphinxDirective):
    """Equations of the report, by their numbers."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Run the directive."""
        keys = " ".join([*self.arguments, *self.content]).replace(",", " ").split()
        if not keys:
            raise self.error("report-equation: got no number, wanted one from 1 to 137")
        return [node for key in keys for node in self._equation(key)]

    def _equation(self, key: str) -> list[nodes.Node]:
        """Return one equation's nodes: target, formula, and the note on the reading."""
        try:
            found, tex = template(key), as_tex(key)
        except ValueError as wrong:
            raise self.error(str(wrong)) from None
        options: dict[str, Any] = {"class": ["report-equation"]}
        if found.numbered:
            options["label"] = f"eq-{key}"
        content = StringList(tex.splitlines(), source=f"equation {key}")
        where = (self.lineno, self.content_offset, self.block_text, self.state, self.state_machine)
        math = MathDirective("math", [], options, content, *where).run()
        note = [nodes.paragraph("", found.note, classes=["reading-note"])] if found.note else []
        return [*math, *note]


class ReportTable(SphinxDirective):
    """A table of the report, by its number."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Run the directive."""
        try:
            found = printed_table(self.arguments[0])
        except ValueError as wrong:
            raise self.error(str(wrong)) from None
        name = f"tab-{self.arguments[0]}"
        group = nodes.tgroup("", cols=len(found.heads))
        group += [nodes.colspec(colwidth=1) for _ in found.heads]
        group += nodes.thead("", nodes.row("", *[nodes.entry("", _head(head)) for head in found.heads]))
        lines = [nodes.row("", *[nodes.entry("", _cell(cell)) for cell in line]) for line in found.lines]
        group += nodes.tbody("", *lines)
        table = nodes.table("", nodes.title("", found.caption), group, names=[name], classes=["report-table"])
        self.set_source_info(table)
        self.state.document.note_explicit_target(table)
        return [table]


def _head(text: str) -> nodes.paragraph:
    """Return a column's head; TeX stands between dollars."""
    parts = text.split("$")
    inner = [nodes.math("", part) if i % 2 else nodes.Text(part) for i, part in enumerate(parts) if part]
    return nodes.paragraph("", "", *inner)


def _cell(cell: str) -> nodes.paragraph:
    """Return a cell: a printed number with its mark, or a text."""
    row = row_of(cell)
    if row is None:
        return nodes.paragraph("", cell)
    mantissa, _, power = row["printed"].partition("e")
    number = nodes.inline("", classes=classes(cell))
    number += nodes.Text(f"{mantissa} × 10" if power else mantissa)
    if power:
        number += nodes.superscript("", power)
    return nodes.paragraph("", "", number)


class VerdictLegend(SphinxDirective):
    """The marks of the verdicts, side by side."""

    def run(self) -> list[nodes.Node]:
        """Run the directive."""
        samples = (
            f'<li><span class="printed-sample {slug(v)}">1.31</span> {escape(v)}</li>' for v in VERDICTS
        )
        return [nodes.raw("", f'<ul class="verdict-legend">{"".join(samples)}</ul>', format="html")]


def card_data() -> str:
    """Return the script with what the cards say: cells, kind and first print by id; each reason once."""
    shown = as_frame(ledger())[[*CELLS]]
    reasons = list(dict.fromkeys(shown["why"]))
    cells = {
        entry.id: [*row[:-1], reasons.index(row[-1]), entry.kind, entry.of]
        for entry, row in zip(ledger(), shown.to_numpy().tolist(), strict=True)
    }
    data = json.dumps({"rows": cells, "reasons": reasons}, ensure_ascii=False, separators=(",", ":"))
    return f"export default {data};\n"


def write(app: Sphinx, exception: Exception | None) -> None:
    """Put script, style and data beside the other static files of the built pages."""
    if exception is None and app.builder.format == "html":
        static = Path(app.outdir) / "_static"
        for name in FILES:
            shutil.copy(HERE / name, static / name)
        (static / "printed_numbers.js").write_text(card_data(), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directives with Sphinx, and script and style with every page."""
    app.add_directive("report-equation", ReportEquation)
    app.add_directive("report-table", ReportTable)
    app.add_directive("verdict-legend", VerdictLegend)
    app.connect("build-finished", write)
    app.add_css_file("report_equations.css")
    app.add_js_file("report_equations.js", type="module")
    return {"parallel_read_safe": True, "parallel_write_safe": True}
