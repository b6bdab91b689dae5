"""The one place where files are read: the tables of ``rlswaim/data``."""

import csv
from functools import cache
from importlib.resources import files

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
    path = files("rlswaim").joinpath("data", f"{name}.csv")
    with path.open(encoding="utf-8", newline="") as stream:
        return tuple(csv.DictReader(stream))


def constants(name: str) -> dict[str, float]:
    """Return column ``value`` of ``data/<name>.csv`` by column ``symbol``, in each row's unit."""
    return {row["symbol"]: float(row["value"]) for row in read_table(name)}


def column(name: str, key: str) -> list[float]:
    """Return one numeric column of ``data/<name>.csv``."""
    return [float(row[key]) for row in read_table(name)]
