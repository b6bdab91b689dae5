"""The notation page: one row for each symbol, in groups.

The rows are the data classes' fields, the coefficients of Eq. 29, and ``data/symbols.csv``, whose symbols
are TeX; several of one row stand apart by "; ".
"""

import re
from typing import NamedTuple

import pandas as pd

from rlswaim.source.quantity import Notation, notation
from rlswaim.source.tables import Row, read_table
from rlswaim.vehicle.booster import Booster, FlightCondition, Surface
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.modes import BendingMode

RECORDS = {
    FlightCondition: "path",
    Surface: "vehicle",
    Booster: "vehicle",
    BendingMode: "modes",
    PerturbationEquations: "coefficients",
}
"""The data classes, and the group in which the fields of each one stand."""
EQUATIONS = {"Z": "force", "M": "moment", "F1": "first mode", "F2": "second mode"}
GREEK = {"alpha", "gamma", "delta", "zeta", "theta", "xi", "rho", "sigma", "phi", "omega", "Delta"}
OTHERS = {"kK": r"k\,K", "calM": r"\mathcal{M}", "l": r"\ell"}


def _symbol(name: str) -> str:
    """Return one symbol as LaTeX: ``C_N_alpha`` becomes C_{N_{alpha}}, Greek letters by name."""
    head, _, rest = name.partition("_")
    inner = _symbol(rest) if rest else ""
    letter = re.split(r"\d", head)[0]
    digits = head.removeprefix(letter)
    if letter in GREEK:
        head = rf"\{letter}"
    elif letter in OTHERS:
        head = OTHERS[letter]
    elif letter and digits:
        head = f"{letter}_{{{digits}}}"
    return f"{head}_{{{inner}}}" if inner else head


def latex(text: str) -> str:
    """Return a field's symbols as LaTeX.

    Parameters
    ----------
    text : str
        Names such as ``omega_1e``, also several, for instance ``"1/M, 1/I_y"``.

    Returns
    -------
    str
    """
    return re.sub(
        r"[A-Za-z]\w*", lambda found: _symbol(found[0]), re.sub(r"(?<=\w) (?=\w)", ", ", text)
    ).replace(", ", r",\ ")


def with_formulas(text: str) -> str:
    r"""Return a ``text`` for a page, the names in it that are symbols set as formulas.

    Examples
    --------
    >>> with_formulas("deflection phi_1 q_1 at the nose")
    'deflection $\\phi_{1}$ $q_{1}$ at the nose'
    """
    greek = "|".join(GREEK)
    return re.sub(rf"\b(?:[A-Za-z]\w*_\w+|{greek})\b", lambda found: f"${_symbol(found[0])}$", text)


class Line(NamedTuple):
    """A row of the page: its group, its symbols as TeX, the rest of it, and its place in the library."""

    group: str
    symbols: tuple[str, ...]
    notation: Notation
    place: str = ""


def _coefficient(row: Row) -> Line:
    """Return the row of a coefficient of Eq. 29."""
    equation, _, column = row["symbol"].partition("_")
    rate, of = column.endswith("dot"), column.removesuffix("dot").replace("q", "q_")
    meaning = f"what {'the rate of ' if rate else ''}{of} does in the equation of the {EQUATIONS[equation]}"
    told = Notation(row["symbol"], row["unit"], meaning, "Eq. 29")
    place = f"PerturbationEquations.coefficients.{row['symbol']}"
    return Line("coefficients", (row["latex"],), told, place)


def rows() -> tuple[Line, ...]:
    """Return the rows of all groups: fields of the data classes, coefficients, signals and gains."""
    fields = [
        Line(group, tuple(latex(told.symbol).split(r",\ ")), told, f"{record.__name__}.{name}")
        for record, group in RECORDS.items()
        for name, told in notation(record).items()
    ]
    coefficients = [_coefficient(row) for row in read_table("coefficients")]
    others = [
        Line(r["group"], tuple(r["symbol"].split("; ")), Notation(*list(r.values())[1:]))
        for r in read_table("symbols")
    ]
    return (*fields, *coefficients, *others)


def frame(group: str) -> pd.DataFrame:
    """Return the rows of one group as a table of texts for the notation page.

    Parameters
    ----------
    group : str
        ``"path"``, ``"vehicle"``, ``"motion"``, ``"modes"``, ``"forces"``, ``"coefficients"``, ``"loops"`` or
        ``"roots"``.

    Returns
    -------
    DataFrame
        Symbols in TeX between dollar signs.

    Raises
    ------
    ValueError
        If there is no such group.
    """
    found = [line for line in rows() if line.group == group]
    if not found:
        wanted = ", ".join(dict.fromkeys(line.group for line in rows()))
        raise ValueError(f"group in frame: got {group!r}, wanted one of {wanted}")
    return pd.DataFrame(
        [
            (
                ", ".join(f"${symbol}$" for symbol in line.symbols),
                line.notation.unit,
                with_formulas(line.notation.meaning),
                line.notation.source,
                " ".join(f"`{part}`" for part in line.place.split(".")[-2:] if part),
            )
            for line in found
        ],
        columns=["symbol", "unit", "meaning", "defined in", "in the library"],
    )
