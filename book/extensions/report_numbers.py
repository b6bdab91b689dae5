"""Number equations, figures and tables as the report does, so that Eq. (39) of the report is Eq. (39) here.

A label ``eq-39``, ``fig-8`` or ``tab-1`` takes its number from the report.  What the report
does not have is labelled otherwise and numbered E.1, E.2, ... through the book.
"""

import re
from collections import Counter
from typing import Any

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

REPORT = re.compile(r"(?:equation-eq|fig|tab)-(\d+[a-z]?)")


def renumber(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Replace Sphinx's running numbers; no page has to be read again for it."""
    ours: Counter[str] = Counter()
    for by_kind in env.toc_fignumbers.values():
        for kind, numbers in by_kind.items():
            for label in numbers:
                report = REPORT.fullmatch(label)
                if not report:
                    ours[kind] += 1
                numbers[label] = (report[1],) if report else ("E", ours[kind])  # type: ignore[assignment]
    return []


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the numbering with Sphinx."""
    app.connect("env-get-updated", renumber, priority=900)  # after Sphinx has numbered
    return {"parallel_read_safe": True, "parallel_write_safe": True}
