r"""The report's equations as the report prints them, each printed number marked with its verdict.

A template of `rlswaim.source.equations` becomes TeX for MathJax.  Each number comes from the
ledger's table and is wrapped in ``\class{printed verdict-... kind-... entry-...}{...}``; the book's script
turns ``entry-<id>`` into the attribute ``data-entry="<id>"``, and its style draws the verdict.
"""

import re
from functools import cache

from rlswaim.source.equations import PLACE, Template, templates
from rlswaim.source.tables import Row, read_table

PLAIN = {"agrees", "rounding", "plot reading"}
"""Verdicts that are drawn as a line below the number alone, without a box or a sign beside it."""
CLOSE = re.compile(r"[A-Za-z()\]]|\\(?:phi|Delta|,)")
"""What stands close behind a number: a letter, a bracket, or a thin space."""


@cache
def rows() -> dict[str, Row]:
    """Return the rows of printed numbers by id."""
    return {row["id"]: row for row in read_table("printed")}


def template(key: str | int) -> Template:
    """Return the template of an equation.

    Parameters
    ----------
    key : str or int
        The report's number, or for what it prints without one the number before it and a letter:
        ``"46a"`` is the inequality below Eq. 46, ``"133a"`` the transfer function of closure 2.

    Raises
    ------
    ValueError
        If the report has no such equation.
    """
    try:
        return templates()[str(key)]
    except KeyError:
        raise ValueError(f"equation: got {key!r}, wanted 1 to 137 or one of {_letters()}") from None


def _letters() -> str:
    return ", ".join(key for key, found in templates().items() if not found.numbered)


def digits(number: str) -> str:
    r"""Return a printed number, without its sign, as TeX.

    Examples
    --------
    >>> digits("-.0647"), digits("19,400"), digits("6.61e-6"), digits("-1e7")
    ('.0647', '19{,}400', '6.61\\times10^{-6}', '10^{7}')
    """
    mantissa, _, exponent = number.lstrip("-").replace(",", "{,}").partition("e")
    if not exponent:
        return mantissa
    power = rf"10^{{{int(exponent)}}}"
    return power if mantissa == "1" else rf"{mantissa}\times{power}"


def slug(verdict: str) -> str:
    """Return a ``verdict`` as a class of the page: ``"plot reading"`` is ``verdict-plot-reading``."""
    return f"verdict-{verdict.replace(' ', '-')}"


def classes(entry: str) -> list[str]:
    """Return the classes on the page of the number of row ``entry``: its verdict, its kind and the id."""
    row = rows()[entry]
    return ["printed", slug(row["verdict"]), f"kind-{row['kind']}", f"entry-{entry}"]


def _marked(entry: str, tex: str) -> str:
    return rf"\class{{{' '.join(classes(entry))}}}{{{tex}}}"


def _room(row: Row, rest: str) -> str:
    """Return the space between a number and the ``rest`` of the formula: a box and a sign need some."""
    return r"\;" if row["verdict"] not in PLAIN and CLOSE.match(rest) else ""


def _set(match: re.Match[str]) -> str:
    """Return the TeX of one place: a sign that adds stands before the mark, any other one in it."""
    place, row = match[1], rows()[match[2]]
    room = _room(row, match.string[match.end() :])
    negative = row["printed"].startswith("-") != (place in ("turned", "minus"))
    if place in ("plus", "minus"):
        return ("-" if negative else "+") + _marked(row["id"], digits(row["printed"])) + room
    return _marked(row["id"], ("-" if negative else "") + digits(row["printed"])) + room


def with_numbers(tex: str) -> str:
    """Return a template's ``tex`` with the printed numbers in their places, each one marked.

    Raises
    ------
    KeyError
        If it names a row that the ledger does not have.
    """
    return PLACE.sub(_set, tex)


def as_tex(key: str | int) -> str:
    """Return an equation of the report as TeX for MathJax, its printed numbers marked.

    Parameters
    ----------
    key : str or int
        As for `template`.

    Raises
    ------
    ValueError
        If the report has no such equation.
    """
    return with_numbers(template(key).tex)
