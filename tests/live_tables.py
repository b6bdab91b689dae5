"""The text form of the live views on the built pages, checked against the library at the same values."""

import pytest

from livepage import ASCENT, BOOSTER, PAGES, WORKBENCHES, number, poles_of, relative_mismatch
from rlswaim.explorers import ascent
from rlswaim.vehicle import trajectory

SLID = ("bent-vehicle", "trajectory", "coupling", *WORKBENCHES)
TABLES = {**dict.fromkeys(PAGES, "table.poles"), "bent-vehicle": "table.values", "trajectory": "table.values"}
"""The table that tells the view in text."""


def every(*names: str):
    """Run a test on these views, each on one page for all tests."""
    return pytest.mark.parametrize("shown", names, indirect=True)


def assert_loads(rows, view) -> None:
    texts, data = rows[-1]
    for text, (row, wanted) in zip(texts[2:], view.loads().items(), strict=True):
        assert float(data[row]) == pytest.approx(wanted, rel=1e-6, abs=1e-6)
        assert number(text) == pytest.approx(wanted, rel=1e-3, abs=1e-6)


def assert_flight(rows, view) -> None:
    upright, level = (float(v) for v in view.values().values())
    known = upright in ascent.UPRIGHT and level in ascent.LEVEL
    flown = trajectory.fly(ASCENT, trajectory.turn(upright, level), ascent.TIMES)
    for texts, data in rows[:3]:
        name = data["quantity"]
        wanted = flown.at(BOOSTER.flight.t)[name]
        off = 0 if known else 1.3 * view.payload["accuracy"][name]
        assert abs(float(data["value"]) - wanted) <= 0.5 * 10.0 ** -ascent.CURVES[name] * 1.01 + off
        assert number(texts[1]) == pytest.approx(float(data["value"]), rel=1e-3)
        assert number(texts[2]) == pytest.approx(getattr(BOOSTER.flight, name), rel=1e-3)
    _, size = view.trajectory().peak
    assert float(rows[3][1]["value"]) == pytest.approx(size, rel=0.02)


def assert_rows(name: str, rows, view) -> None:
    """Check the text form of a view against the library at the same values."""
    if name == "bent-vehicle":
        assert_loads(rows, view)
    elif name == "trajectory":
        assert_flight(rows, view)
    else:
        loop = view.vehicle() if name == "coupling" else view.closed_loop()
        assert relative_mismatch(poles_of(rows), loop) < 1e-6, view
