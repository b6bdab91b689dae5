"""The ledger: every printed number beside ours, each verdict tested both ways; its coverage.

A row fails if its verdict says that it disagrees but its numbers agree, and the other way round.
"""

import re

import numpy as np
import pytest
from matplotlib import pyplot as plt

import rlswaim as rl
from rlswaim.edition.ledger import VERDICTS, open_causes
from rlswaim.figures.agreement import draw_differences
from rlswaim.source.tables import number, read_table

LEDGER = rl.ledger()
ENTRIES = {entry.id: entry for entry in LEDGER}


@pytest.mark.parametrize("entry", LEDGER, ids=list(ENTRIES))
def test_printed(entry):
    assert entry.verdict in VERDICTS
    assert np.isfinite(entry.computed)
    assert (entry.verdict == "agrees") == entry.agrees, (
        f"printed {entry.printed}, computed {entry.computed:.6g}, said to be: {entry.verdict}"
    )
    assert entry.agrees or entry.why


@pytest.mark.parametrize("entry", [e for e in LEDGER if e.verdict == "rounding"], ids=lambda e: e.id)
def test_rounding_is_small(entry):
    """Half a percent, or what the row itself explains: figures lost in a small difference or the like."""
    lost = ("small difference", "beside a root of 1e7", "border", "with two figures")
    assert abs(entry.percent) < 0.5 + 1e-9 or any(words in entry.why for words in lost)


EQUATIONS = [
    *range(38, 43),
    *(45, 46, 48, 50, 51, 59, 60, 61),
    *range(64, 84),
    *range(92, 97),
    *(108, 109, 111, 115, 116, 117, 118, 125),
    *(131, 132, 133, 135, 136, 137),
]
"""Eq. 134 holds letters alone; Eq. 136 is its numbers."""
TABLES = {  # rows of each column
    **{"tab1-m": 11, "tab1-arm": 11, "tab1-I_y": 12, "tab1-M": 1},
    **{"tab2-phi_1": 12, "tab2-phi_2": 12, "tab2-mass_1": 12, "tab2-mass_2": 12},
    **{"tab2-sigma_1": 2, "tab2-sigma_2": 2, "tab3-sensor": 24, "tab3-jet": 24},
}
SIZES = {  # numbers in the larger expressions: U, entries, columns of the thrust and the gust; gains, roots
    **{"eq38": 1 + 28 + 4, "eq42": 13, "eq48": 11, "eq60": 7, "eq76": 13 + 3 + 5, "eq83": 24},
    **{"eq41": 10, "eq77": 6, "eq78": 8, "eq79": 6, "eq80": 8, "eq81": 6, "eq82": 8},
    **{"eq92": 12, "eq93": 5, "eq94": 5, "eq95": 6, "eq108": 5, "eq115": 5, "eq118": 8},
    **{
        "eq131": 21,
        "eq132": 21,
        "eq133": 1 + 2 + 4 * 8,
        "eq135": 6,
        "eq136": 1 + 10 + 12,
        "eq137": 1 + 12 + 13,
    },
}


def equations(where):
    """Return the numbers of the equations that a row says it stands in: ``"Eqs. 61, 64 to 66"``."""
    found = set()
    for listed in re.findall(r"Eqs?\. ((?:\d+(?:, | to |-| and )?)+)", where):
        for first, last in re.findall(r"(\d+)(?:(?: to |-)(\d+))?", listed):
            found |= set(range(int(first), int(last or first) + 1))
    return found


COVERED = set().union(*(equations(entry.where) for entry in LEDGER))


@pytest.mark.parametrize("number", EQUATIONS, ids=lambda n: f"Eq. {n}")
def test_equation_has_rows(number):
    assert number in COVERED


@pytest.mark.parametrize(("start", "size"), [*TABLES.items(), *SIZES.items()])
def test_no_row_is_missing(start, size):
    cells = [id_ for id_ in ENTRIES if re.fullmatch(rf"{re.escape(start)}(-.+)?", id_)]
    assert len(cells) == size


@pytest.mark.parametrize("number", [8, 9, 10, 11, 15, 16, 19, 20, 24, 25])
def test_caption_has_rows(number):
    assert any(id_.startswith(f"fig{number}-K") for id_ in ENTRIES)


def test_ids_are_unique_and_sections_in_order():
    rows = read_table("printed")
    assert len(rows) == len(ENTRIES) == len(LEDGER)
    sections = [row["section"] for row in rows]
    assert [s for i, s in enumerate(sections) if s not in sections[:i]] == [
        "II",
        "III",
        "IV",
        "V",
        "VI",
        "VII",
    ]


# ---- what refers to the ledger

REFERRING = {  # tables whose numbers may be rows of the ledger, and in which column
    **dict.fromkeys(("designs", "gains_found", "modes", "vehicle"), "value"),
    **{"masses": "mass_slug", "surfaces": "C_Nalpha_per_rad", "table3": "sensor_ft"},
}


@pytest.mark.parametrize("name", REFERRING)
def test_a_table_s_number_is_a_row_of_the_ledger_or_a_number(name):
    """Else a mistyped id would pass for words."""
    cells = [row[REFERRING[name]] for row in read_table(name)]
    words = [cell for cell in cells if cell not in ENTRIES and not re.fullmatch(r"-?\d*\.?\d+(e\d+)?", cell)]
    assert set(words) == ({"total", "rigid body"} if name == "designs" else set())
    known = [cell for cell in cells if cell in ENTRIES]
    assert known
    assert [number(cell) for cell in known] == [ENTRIES[cell].value for cell in known]


def test_picture_shows_every_difference_once():
    fig, ax = plt.subplots()
    drawn = draw_differences(ax, LEDGER).get_lines()
    marks = [line for line in drawn if line.get_label() in VERDICTS]
    assert sum(len(line.get_xdata()) for line in marks) == sum(e.value != 0 for e in LEDGER)
    assert (
        len({line.get_marker() for line in marks}) == len({line.get_color() for line in marks}) == len(marks)
    )
    assert max(max(line.get_ydata()) for line in marks) == max(abs(e.percent) for e in LEDGER if e.value)
    plt.close(fig)


@pytest.mark.parametrize(("found", "count"), [("no", 9), ("reading", 2)])
def test_open_causes_are_those_of_the_table_that_end_at_no_number(found, count):
    wanted = [row for row in read_table("causes") if row["found"] == found and not row["to"]]
    frame = open_causes(found)
    assert list(frame.index) == [row["cause"] for row in wanted]
    assert len(frame) == count
    assert list(frame["rows"]) == [row["rows"].replace(" ", ", ") for row in wanted]
    assert list(frame["what"]) == [row["what"] for row in wanted]
    assert frame.index.name == "cause"


def test_a_cause_that_is_read_off_a_figure_and_ends_at_a_number_is_not_open():
    told = [row["cause"] for row in read_table("causes") if row["found"] == "reading" and row["to"]]
    assert told
    assert not {*told} & {*open_causes("reading").index}
    assert open_causes("yes").index.tolist() == [
        row["cause"] for row in read_table("causes") if row["found"] == "yes" and not row["to"]
    ]
