"""Dataclass fields with a symbol, a unit, a meaning and a source for the notation page."""

import dataclasses
from functools import cache
from typing import Any, NamedTuple

from rlswaim.source.tables import read_table


class Notation(NamedTuple):
    """One line of the notation page."""

    symbol: str
    unit: str
    meaning: str
    source: str


def quantity(symbol: str, unit: str, meaning: str, source: str, **options: Any) -> Any:
    """Return a dataclass field that carries its notation as metadata.

    Parameters
    ----------
    symbol, unit, meaning, source : str
        As in `Notation`.
    **options
        Those of `dataclasses.field`, for instance a default.
    """
    return dataclasses.field(metadata={"notation": Notation(symbol, unit, meaning, source)}, **options)


@cache
def _units() -> dict[str, str]:
    rows = read_table("symbols")
    return {symbol: row["unit"] for row in rows for symbol in row["symbol"].replace(r"\,", " ").split("; ")}


def unit_of(symbol: str) -> str:
    r"""Return the unit of a symbol of ``data/symbols.csv``.

    Parameters
    ----------
    symbol : str
        In TeX, a space for ``\,``.

    Examples
    --------
    >>> unit_of("K_A")
    'rad/rad'
    """
    return _units()[symbol]


def notation(record: type) -> dict[str, Notation]:
    """Return the notation of a dataclass (record) by field name; fields without one are left out."""
    return {f.name: f.metadata["notation"] for f in dataclasses.fields(record) if "notation" in f.metadata}
