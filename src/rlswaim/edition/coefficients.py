"""The coefficients of Eq. 29 as a table: formula, value from the data, printed value."""

import pandas as pd

from rlswaim.edition.ledger import ledger
from rlswaim.source.tables import read_table
from rlswaim.vehicle.booster import Booster


def coefficient_table() -> pd.DataFrame:
    """Return one row for each coefficient, indexed by its name.

    Returns
    -------
    DataFrame
        Columns: symbol (TeX), printed, computed, difference (%), unit, formula (TeX), verdict.
        The printed number is the one that stands in Eq. 38 (Z_thetadot - U for Z_thetadot).
    """
    entries = {entry.id: entry for entry in ledger()}
    rows = {}
    for row in read_table("coefficients"):
        entry = entries[f"eq38-{row['symbol']}"]
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


def mirrored_damping(booster: Booster, F2_q1dot: float) -> float:
    """Return the F1_q2dot that belongs to an F2_q1dot (1/s).

    Both are one aerodynamic sum, over the generalized mass of their own equation.
    """
    return F2_q1dot * booster.modes[1].mass / booster.modes[0].mass
