"""The rows of a card of criteria, and whether they are those of `practice.criteria`."""

import math
import re

from livepage import number
from rlswaim.practice import criteria

ROWS = """rows => rows.map(row => [row.dataset.criterion, ...[...row.cells].map(cell => cell.textContent)])"""
UNITS = {"deg": "°", "deg/s": "°/s", "1": ""}
VERDICTS = {True: "met", False: "not met", None: "nothing asked"}


def half_a_digit(value):
    """Return half a unit of the third digit."""
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) - 2)


def agree(shown, found):
    """Assert that all rows are those of Python: order, values, bounds, verdicts."""
    assert [row[0] for row in shown] == [c.name for c in found]
    for (name, _, value, asked, verdict), c in zip(shown, found, strict=True):
        is_near = c.met is not None and f"{c.value:.2e}" == f"{c.wanted:.2e}"
        assert verdict == "just " * is_near + VERDICTS[c.met], name
        if not math.isfinite(c.value):
            words = "none" if math.isnan(c.value) else "without end" if c.at_most else "∞"
            assert value == (f"not within {criteria.HORIZON:g} s" if name == "settling" else words), name
        else:
            digits = re.sub(r"\s*(°|[a-zA-Z]).*", "", value)
            assert value.removeprefix(digits).strip() == UNITS.get(c.unit, c.unit), name
            off = abs(number(digits) - c.value)
            assert off <= half_a_digit(c.value) * (1 + 1e-6), (name, value, c.value)
        if c.met is None:
            assert asked == ""
        else:
            assert asked[0] == ("≤" if c.at_most else "≥")
            assert number(re.sub(r"\s*(°|[a-zA-Z]).*", "", asked[2:])) == float(f"{c.wanted:.3g}")
