"""The ladder's last rung: what holds for vehicles that differ from the report's in all their data at once."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.firm_claims import PROVED
from rlswaim.edition.slow_roots import slow_bound
from rlswaim.loops.certificates import slow_root_certificate
from rlswaim.practice.conclusions_on_rungs import (
    Cell,
    angle_limits,
    as_found,
    rigid_root,
    root_with_the_jet,
    unstable_root,
)
from rlswaim.practice.dispersed import dispersed, drawn
from rlswaim.practice.ladder import Rung
from rlswaim.practice.rungs import Step
from rlswaim.source.tables import read_table
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import perturbation_equations

DRAWS = 500
"""So many dispersed vehicles are judged."""
CLAIMS = {"IV": (60.0, ()), "V": (None, (140.0,)), "VI": (None, (300.0, 140.0))}
"""Gyro and sensors (ft) of the claims that no gains of Sections IV to VI stabilize."""


class Outcome(NamedTuple):
    """What becomes of one dispersed vehicle, gravity kept."""

    unstable: float
    """Its unstable root without control (1/s)."""
    with_the_jet: float
    """Its largest real part (1/s) with the jet's loop of Figure 24 closed alone."""
    rigid: float
    """Its largest real part (1/s) if nothing of it bends, a slow real root apart."""
    stable_controller: bool
    """Whether a stable controller may hold it by the rigid body's angle."""
    ruled_out: tuple[bool, ...]
    """Whether all gains are proved to leave more than a slow root right of the axis, by `CLAIMS`."""
    modest: float
    """Largest real part (1/s) under the modest loop of Section VII, a slow real root apart."""


def outcome(index: int) -> Outcome:
    """Return the outcome of one draw, by its number from 0."""
    eqs = perturbation_equations(dispersed(swaim_booster(), drawn(index)), gravity=True)
    step = Step(eqs, Rung())
    proved = (slow_root_certificate(eqs, *claim, slow_bound()) > PROVED for claim in CLAIMS.values())
    return Outcome(
        unstable_root(step),
        root_with_the_jet(step),
        rigid_root(step),
        bool(angle_limits(step).stable_controller),
        tuple(proved),
        as_found(step),
    )


def stored_shares() -> dict[str, float]:
    """Return shares (%), worst roots (1/s) and the worst draw's place, stored in ladder_dispersed.csv."""
    return {row["quantity"]: float(row["value"]) for row in read_table("ladder_dispersed")}


def cells() -> dict[str, Cell]:
    """Return the shares (%) as the last row of the table of conclusions: stands, falls or depends.

    Where nothing bends, the number is the largest real part of all vehicles (1/s): the weight leaves each
    a divergence, a slower one.
    """
    shares = stored_shares()

    def cell(share: float) -> Cell:
        return Cell({100.0: "stands", 0.0: "falls"}.get(share, "depends"), share, " %")

    row = {name: cell(shares[name]) for name in ("diverges", "jet", "parity", *CLAIMS, "modest")}
    rigid = Cell("stands" if shares["rigid"] <= 0 else "depends", shares["rigid"])
    return row | {"rigid": rigid, "VII": cell(shares["modest"])}


def main() -> None:
    """Print the shares as the table ``ladder_dispersed``."""
    found = [outcome(index) for index in range(DRAWS)]
    modest = np.array([one.modest for one in found])
    meanings: dict[str, tuple[list[bool] | NDArray, str]] = {
        "diverges": ([one.unstable > 0 for one in found], "vehicles that diverge without control"),
        "jet": ([one.with_the_jet > 0 for one in found], "vehicles that the jet alone leaves diverging"),
        "parity": (
            [not one.stable_controller for one in found],
            "vehicles that no stable controller holds by the rigid angle",
        ),
        "modest": (modest < 0, "vehicles that the modest loop holds"),
    }
    for i, name in enumerate(CLAIMS):
        proved = [one.ruled_out[i] for one in found]
        meanings[name] = (proved, f"vehicles that no gains of Section {name} hold: proved")
    print("quantity,value,unit,meaning")
    print(f"draws,{len(found)},1,number of dispersed vehicles")
    for name, (held, meaning) in meanings.items():
        print(f"{name},{100 * np.mean(held):g},%,{meaning}")
    rigid = max(one.rigid for one in found)
    print(f"rigid,{rigid:.9g},1/s,largest real part of the vehicles if nothing of them bends")
    print(f"worst,{modest.max():.9g},1/s,largest real part under the modest loop")
    print(f"worst_draw,{modest.argmax()},1,its place among the draws")


if __name__ == "__main__":
    main()
