"""A table of texts as Markdown for a page."""

import pandas as pd


def as_markdown(frame: pd.DataFrame) -> str:
    """Return ``frame``, a table of texts, as Markdown, so that a page sets its formulas."""
    lines = [frame.columns, ["---"] * frame.shape[1], *frame.to_numpy()]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)
