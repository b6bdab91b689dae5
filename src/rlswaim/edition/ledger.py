"""The ledger: every number that the report prints, beside the one computed here.

A row of ``data/printed.csv`` holds the number as printed, as text: half a unit
in its last digit is its tolerance.  The verdicts are a short fixed list, and
each is tested both ways: a test fails if a row's numbers disagree and its
verdict is "agrees", and also if they agree and its verdict is another.
Data and choices of the report agree by themselves, and a number that is
printed again says nothing new, so rows are told apart by their kind.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache

import pandas as pd

from rlswaim.edition import causes, section_2, section_3, section_4, section_5, section_6, section_7
from rlswaim.source.tables import half_unit, printed_rows, read_table

VERDICTS = (
    "agrees",
    "rounding",
    "plot reading",
    "misread or misprint",
    "arithmetic slip",
    "carried over from a slip",
    "not reproducible",
)

KINDS = ("result", "given", "reprint")
"""What the report computed; its data and choices; and a number again, but for its sign."""

SECTIONS: dict[str, Callable[[], dict[str, float]]] = {
    "II": section_2.computed,
    "III": section_3.computed,
    "IV": section_4.computed,
    "V": section_5.computed,
    "VI": section_6.computed,
    "VII": section_7.computed,
}
"""For each section of the report, the function that computes our numbers."""


@dataclass(frozen=True)
class Entry:
    """One printed number and what became of it.

    ``kind`` is one of `KINDS`; of a reprint, ``of`` is the id of the row that has the number first.
    """

    id: str
    section: str
    where: str
    quantity: str
    printed: str
    unit: str
    kind: str
    of: str
    verdict: str
    why: str
    computed: float

    @property
    def value(self) -> float:
        """The printed number."""
        return float(self.printed.replace(",", ""))

    @property
    def agrees(self) -> bool:
        """Whether the computed number rounds to the printed one (half a unit in its last digit)."""
        return abs(self.computed - self.value) <= half_unit(self.printed) * (1 + 1e-9)

    @property
    def percent(self) -> float:
        """Difference of the computed from the printed number, in percent of the printed one."""
        return 100 * (self.computed / self.value - 1) if self.value else float("nan")


@cache
def ledger() -> tuple[Entry, ...]:
    """Return all entries, in the order of the report.

    Returns
    -------
    tuple of Entry
        ``.id .where .printed .computed .verdict .why .kind``, and the quantity and its unit.

    Raises
    ------
    KeyError
        If a row of the table has no computation behind it.
    """
    return tuple(entry for section in SECTIONS for entry in _section(section))


def _section(section: str) -> list[Entry]:
    computed = SECTIONS[section]()
    return [Entry(**row, computed=float(computed[row["id"]])) for row in printed_rows(section)]


def as_frame(entries: Iterable[Entry]) -> pd.DataFrame:
    """Return ``entries`` as a table for a page, every cell as text.

    Columns: where, quantity, printed, computed, unit, difference (%), verdict, why; indexed by id.
    """
    chosen = list(entries)
    columns = {
        "where": [e.where for e in chosen],
        "quantity": [e.quantity for e in chosen],
        "printed": [e.printed for e in chosen],
        "computed": [f"{e.computed:.5g}" for e in chosen],
        "unit": [e.unit for e in chosen],
        "difference (%)": [f"{e.percent:.2f}" if e.value else "" for e in chosen],
        "verdict": [e.verdict for e in chosen],
        "why": [e.why for e in chosen],
    }
    return pd.DataFrame(columns, index=pd.Index([e.id for e in chosen], name="id"), dtype=object)


def frame(section: str, start: str = "") -> pd.DataFrame:
    """Return the entries of one section as a table for a page.

    Parameters
    ----------
    section : str
        ``"I"`` to ``"VII"``.
    start : str
        Only ids that start so, for instance ``"eq41"``.

    Returns
    -------
    DataFrame
        As `as_frame`.
    """
    return as_frame(e for e in ledger() if e.section == section and e.id.startswith(start))


def coefficient_frame() -> pd.DataFrame:
    """Return one row for each coefficient of Eq. 29, indexed by its name.

    Returns
    -------
    DataFrame
        Columns: symbol (TeX), printed, computed, difference (%), unit, formula (TeX), verdict.
        The printed number is the one that stands in Eq. 38 (Z_thetadot - U for Z_thetadot).
    """
    found = {entry.id: entry for entry in ledger()}
    rows = {}
    for row in read_table("coefficients"):
        entry = found[f"eq38-{row['symbol']}"]
        tail = "-U" if row["symbol"] == "Z_thetadot" else ""
        rows[row["symbol"]] = {
            "symbol": f"${row['latex']}{tail}$",
            "printed": entry.printed,
            "computed": f"{entry.computed:.5g}",
            "difference (%)": f"{entry.percent:+.2f}",
            "unit": row["unit"],
            "formula": f"${row['formula']}{tail}$",
            "verdict": entry.verdict,
        }
    return pd.DataFrame.from_dict(rows, orient="index")


def errata() -> pd.DataFrame:
    """Return every entry that does not agree, rounding included, as `as_frame` without the difference."""
    return as_frame(e for e in ledger() if not e.agrees).drop(columns="difference (%)")


def counts(kind: str | None = "result") -> pd.DataFrame:
    """Return how many entries each section (rows, and "all") has of each verdict (columns, and "all").

    Parameters
    ----------
    kind : str or None
        One of `KINDS`; None counts all rows, data and reprints too.
    """
    chosen = [(e.section, e.verdict) for e in ledger() if kind in {None, e.kind}]
    rows = pd.DataFrame(chosen, columns=["section", "verdict"])
    found = pd.crosstab(rows.section, rows.verdict, margins=True, margins_name="all")
    found = found.reindex(index=[*SECTIONS, "all"], columns=[*VERDICTS, "all"], fill_value=0)
    return found.rename_axis(columns=None)


def kind_counts() -> pd.DataFrame:
    """Return how many rows of each kind (and "all") there are, agree, differ by rounding, or by more."""
    rows = pd.DataFrame([(e.kind, e.verdict) for e in ledger()], columns=["kind", "verdict"])
    judged = rows.verdict.where(rows.verdict.isin(VERDICTS[:2]), "more")
    found = pd.crosstab(rows.kind, judged, margins=True, margins_name="all")
    return found.reindex(index=[*KINDS, "all"], columns=["all", *VERDICTS[:2], "more"]).rename_axis(
        columns=None
    )


def repeated_slips() -> pd.DataFrame:
    """Return each slip or reading that was repeated, and the printed number that it leads to, by id.

    Columns: where, printed, computed, with the slip, to (how near it comes), what was done.
    """
    entry, result = {e.id: e for e in ledger()}, causes.results()
    rows = [(entry[row], cause) for cause in causes.causes() for row in cause.rows if row in result]
    columns = {
        "where": [e.where for e, _ in rows],
        "printed": [e.printed for e, _ in rows],
        "computed": [f"{e.computed:.5g}" for e, _ in rows],
        "with the slip": [f"{result[e.id]:.5g}" for e, _ in rows],
        "to": [cause.to for _, cause in rows],
        "what was done": [cause.what for _, cause in rows],
    }
    return pd.DataFrame(columns, index=pd.Index([e.id for e, _ in rows], name="id"))


def open_causes(found: str) -> pd.DataFrame:
    """Return the causes of one kind that lead to no number: ``found`` is "no" or "reading".

    Columns: rows (ids), and what was tried or read.
    """
    chosen = [c for c in causes.causes() if c.found == found and not c.to]
    columns = {"rows": [", ".join(c.rows) for c in chosen], "what": [c.what for c in chosen]}
    return pd.DataFrame(columns, index=pd.Index([c.name for c in chosen], name="cause"))
