"""Every design around thousands of vehicles whose data are wrong at random.

``python -m rlswaim.practice.monte_carlo`` prints ``data/monte_carlo.csv``.  The draws are those of
`dispersed.drawn` about the consistent vehicle, the same for each design; their number may follow
the command.
"""

import sys
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from joblib import Parallel, delayed
from scipy.stats import beta

from rlswaim.practice.criteria import DEG, wanted
from rlswaim.practice.designs import designs, moved
from rlswaim.practice.dispersed import consistent_booster, dispersed, drawn
from rlswaim.practice.optimal import MIDDLE
from rlswaim.practice.synthesis import responses, slowest
from rlswaim.source.tables import number, read_table

DRAWS, FIRST = 2000, 20
"""Of the table; the median of the first ones is stored too, so that a test can repeat them."""
QUANTITIES = {
    "delta": ("rad", DEG),
    "delta_r": ("lb", 1.0),
    f"moment {MIDDLE:g}": ("lb ft", 1.0),
    "abscissa": ("1/s", 1.0),
}
"""What is stored of each draw: its unit, and what one counts in the unit of the criteria."""
SHARES = (0.05, 0.5, 0.95, 0.99)


class Spread(NamedTuple):
    """How one design does in all draws.

    ``stable`` counts the stable ones; ``quantiles`` holds, by quantity, those of `SHARES` among these;
    ``first`` the median of the first draws.
    """

    draws: int
    stable: int
    quantiles: dict[str, tuple[float, ...]]
    first: dict[str, float]

    def share(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return bounds of the share of stable vehicles, by Clopper and Pearson, at a ``confidence``."""
        tail, k, n = (1 - confidence) / 2, self.stable, self.draws
        low = beta.ppf(tail, k, n - k + 1) if k else 0.0
        high = beta.ppf(1 - tail, k + 1, n - k) if k < n else 1.0
        return float(low), float(high)


def one_draw(index: int) -> dict[str, dict[str, float]]:
    """Return what each design does around one vehicle: peaks in gusts, and its abscissa.

    Parameters
    ----------
    index : int
        Of the draw.

    Returns
    -------
    dict of str to dict
        By design.  Peaks (rad, lb, lb ft) are nan where a root is faster than `synthesis.slowest`;
        abscissa (1/s).
    """
    booster, found = dispersed(consistent_booster(), drawn(index)), {}
    for name, design in designs().items():
        closed = moved(design, booster)
        row = dict.fromkeys(QUANTITIES, float("nan")) | {"abscissa": float(closed.poles().real.max())}
        if row["abscissa"] <= slowest():
            values = responses(closed, booster.flight.U, wanted().gust_ft_s)
            peaks = {key: value[:, :-1] for key, value in values.items() if key in QUANTITIES}
            row |= {key: float(np.abs(value).max()) for key, value in peaks.items()}
        found[name] = row
    return found


def spread(rows: Sequence[Mapping[str, float]]) -> Spread:
    """Return how one design does in many draws, from its ``rows`` of `one_draw`."""
    columns = {key: np.array([row[key] for row in rows]) for key in QUANTITIES}
    stable = columns["abscissa"] <= slowest()
    quantiles, first = {}, {}
    for key, values in columns.items():
        kept = values[stable & np.isfinite(values)]
        if kept.size:
            quantiles[key] = tuple(np.quantile(kept, SHARES).tolist())
        early = values[:FIRST][np.isfinite(values[:FIRST])]
        if early.size:
            first[key] = float(np.median(early))
    return Spread(len(rows), int(stable.sum()), quantiles, first)


def spreads() -> dict[str, Spread]:
    """Return the stored table ``data/monte_carlo.csv`` by design."""
    rows: dict[str, dict[str, float]] = {}
    for row in read_table("monte_carlo"):
        rows.setdefault(row["design"], {})[row["quantity"]] = number(row["value"])
    found = {}
    for name, values in rows.items():
        shares = [f"{share:g}" for share in SHARES]
        quantiles = {
            key: tuple(values[f"{key} at {share}"] for share in shares)
            for key in QUANTITIES
            if f"{key} at {shares[0]}" in values
        }
        first = {key: values[f"{key} first"] for key in QUANTITIES if f"{key} first" in values}
        found[name] = Spread(int(values["draws"]), int(values["stable"]), quantiles, first)
    return found


def main(draws: int = DRAWS) -> None:
    """Print the table ``data/monte_carlo.csv`` of so many ``draws``, as ``joblib.parallel_config`` says."""
    found = Parallel()(delayed(one_draw)(index) for index in range(draws))
    print("design,quantity,value,unit")
    for name in designs():
        one = spread([draw[name] for draw in found])
        rows = [("draws", f"{one.draws}", "1"), ("stable", f"{one.stable}", "1")]
        for key, values in one.quantiles.items():
            unit = QUANTITIES[key][0]
            rows += [(f"{key} at {s:g}", f"{v:.6g}", unit) for s, v in zip(SHARES, values, strict=True)]
        rows += [(f"{key} first", f"{value:.6g}", QUANTITIES[key][0]) for key, value in one.first.items()]
        for row in rows:
            print(f'"{name}"', *row, sep=",")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
