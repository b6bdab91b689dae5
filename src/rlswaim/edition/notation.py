"""The notation page: one row for each symbol, from the data classes' fields and ``data/symbols.csv``."""

import re

import pandas as pd

from rlswaim.source.quantity import Notation, notation
from rlswaim.source.tables import read_table
from rlswaim.vehicle.booster import Booster, FlightCondition, Surface
from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.modes import BendingMode

RECORDS = (FlightCondition, Surface, Booster, BendingMode, PerturbationEquations)
GREEK = {"alpha", "gamma", "delta", "zeta", "theta", "xi", "rho", "sigma", "phi", "omega", "Delta"}


def _symbol(name: str) -> str:
    """Return one symbol as LaTeX: ``C_N_alpha`` becomes C_{N_{alpha}}, Greek letters by name."""
    head, _, rest = name.partition("_")
    inner = _symbol(rest) if rest else ""
    letter = re.split(r"\d", head)[0]
    digits = head.removeprefix(letter)
    if letter in GREEK:
        head = rf"\{letter}"
    elif letter == "kK":
        head = r"k\,K"
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


def rows() -> tuple[tuple[str, Notation], ...]:
    """Return every symbol with where the library keeps it, in the order of the classes, gains last.

    Returns
    -------
    tuple of (str, Notation)
        ``"Booster.M"`` and so on, or ``""`` for a gain or a signal.
    """
    fields = [
        (f"{record.__name__}.{name}", line) for record in RECORDS for name, line in notation(record).items()
    ]
    others = [
        ("", Notation(r["symbol"], r["unit"], r["meaning"], r["source"])) for r in read_table("symbols")
    ]
    return (*fields, *others)


def frame() -> pd.DataFrame:
    """Return `rows` as a table of texts for the notation page, symbols in TeX between dollar signs."""
    return pd.DataFrame(
        [
            (
                f"${latex(line.symbol)}$",
                line.unit,
                line.meaning,
                line.source,
                " ".join(f"`{part}`" for part in place.split(".")) if place else "",
            )
            for place, line in rows()
        ],
        columns=["symbol", "unit", "meaning", "defined in", "in the library"],
    )
