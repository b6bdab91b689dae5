"""A dataclass field that knows its symbol, unit, meaning and source."""

import dataclasses
from typing import Any, NamedTuple


class Notation(NamedTuple):
    """One line of the notation page."""

    symbol: str
    unit: str
    meaning: str
    source: str


def quantity(symbol: str, unit: str, meaning: str, source: str, **options: Any) -> Any:
    """Return a dataclass field that knows what it stands for.

    Parameters
    ----------
    symbol, unit, meaning, source : str
        As in `Notation`.
    **options
        Those of `dataclasses.field`, for instance a default.
    """
    return dataclasses.field(metadata={"notation": Notation(symbol, unit, meaning, source)}, **options)


def notation(record: type) -> dict[str, Notation]:
    """Return the notation of a dataclass (record) by field name; fields without one are left out."""
    return {f.name: f.metadata["notation"] for f in dataclasses.fields(record) if "notation" in f.metadata}
