"""The one place where files are read: the tables of ``source/data`` and the scripts of the live views."""

import csv
from collections.abc import Sequence
from functools import cache
from importlib.resources import files
from os import PathLike
from pathlib import Path

Row = dict[str, str]


@cache
def read_table(name: str) -> tuple[Row, ...]:
    """Return the rows of ``data/<name>.csv``, every cell as text.

    Parameters
    ----------
    name : str
        File name without its ending, for instance ``"masses"`` (Table 1).

    Returns
    -------
    tuple of dict
        One mapping of column name to text for each row.

    Raises
    ------
    FileNotFoundError
        If there is no such table.
    """
    path = files("rlswaim.source").joinpath("data", f"{name}.csv")
    return tuple(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))


def read_own_table(path: str | PathLike[str], columns: Sequence[str]) -> tuple[Row, ...]:
    """Return the rows of a reader's own CSV file, every cell as text without spaces around it.

    Parameters
    ----------
    path : path
        Of the file, in UTF-8; its first line names the columns.
    columns : sequence of str
        The columns that it must have.

    Returns
    -------
    tuple of dict

    Raises
    ------
    ValueError
        If a column is missing, or a line has more or fewer cells than there are columns.
    FileNotFoundError
        If there is no such file.
    """
    rows = csv.DictReader(Path(path).read_text(encoding="utf-8").splitlines())
    wanted = ", ".join(columns)
    if missing := [name for name in columns if name not in (rows.fieldnames or ())]:
        raise ValueError(f"columns in {path}: got no {missing[0]!r}, wanted {wanted}")
    found = []
    for row in rows:
        if None in row or None in row.values():
            raise ValueError(
                f"line {rows.line_num} in {path}: got other cells than {wanted}, wanted one of each"
            )
        found.append({name: cell.strip() for name, cell in row.items()})
    return tuple(found)


@cache
def printed_rows(section: str) -> tuple[Row, ...]:
    """Return the rows of ``data/printed.csv``, the ledger's table, of one ``section`` (``"II"`` ...)."""
    return tuple(row for row in read_table("printed") if row["section"] == section)


@cache
def _printed_texts() -> dict[str, str]:
    return {row["id"]: row["printed"] for row in read_table("printed")}


def number(cell: str) -> float:
    """Return the number in a ``cell`` of a table.

    The cell may hold the id of a row of ``data/printed.csv``, the one home of printed numbers, instead;
    thousands may be set apart by commas.
    """
    return float(_printed_texts().get(cell, cell).replace(",", ""))


def printed(section: str, start: str = "") -> dict[str, float]:
    """Return printed numbers of one section.

    Parameters
    ----------
    section : str
        ``"II"`` to ``"VII"``.
    start : str
        How the ids begin that are wanted.

    Returns
    -------
    dict of str to float
        By the rest of the id.
    """
    rows = (row for row in printed_rows(section) if row["id"].startswith(start))
    return {row["id"].removeprefix(start): number(row["printed"]) for row in rows}


def half_unit(number: str) -> float:
    """Return half a unit in the last printed digit of a ``number`` given as text.

    Examples
    --------
    >>> half_unit("1.310"), half_unit(".0387"), half_unit("15.297e8")
    (0.0005, 5e-05, 50000.0)
    """
    mantissa, _, exponent = number.lower().replace(",", "").partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - decimals)


def constants(name: str) -> dict[str, float]:
    """Return column ``value`` of ``data/<name>.csv`` by column ``symbol``, in each row's unit."""
    return {row["symbol"]: number(row["value"]) for row in read_table(name)}


def column(name: str, key: str) -> list[float]:
    """Return a column of ``data/<name>.csv`` as numbers.

    Parameters
    ----------
    name : str
        File name without its ending.
    key : str
        Name of the column.
    """
    return [number(row[key]) for row in read_table(name)]


def script(*path: str) -> str:
    """Return a file of a live view as text: ``explorers/<path>``."""
    return files("rlswaim").joinpath("explorers", *path).read_text(encoding="utf-8")
