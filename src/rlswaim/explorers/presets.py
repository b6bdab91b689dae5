"""The report's designs and the corrected ones, as presets of the live views."""

from collections.abc import Mapping, Sequence
from typing import Any

from rlswaim.edition.designs import designs, found_gains
from rlswaim.edition.matching import printed_roots
from rlswaim.edition.search import winners
from rlswaim.explorers.parameter import Value
from rlswaim.loops.factors import as_text
from rlswaim.loops.rigid_body_design import WANTED, rigid_body, rigid_design
from rlswaim.source.tables import read_table
from rlswaim.vehicle.equations import PerturbationEquations

CORRECTED = {
    "Eq. 75, divided by U": "the rigid-body design with the division by U that Eq. 61 leaves out",
    "Search": "found by a search, rounded: all roots but a slow one left of the axis",
    "Table 3, case 1": "gains chosen by hand for case 1: no root right of the axis",
    "Search, modest jet": "found by a search, rounded: all roots left of the axis, a pair at 2 rad/s and .5",
}
"""Designs of the book beside the report's, by name, and how each differs from them."""
SEARCHED = {
    "V": ("single_sensor", "apart", "Search"),
    "VI": ("two_sensor", "apart", "Search"),
    "VII": ("modest_jet", "pair-all", "Search, modest jet"),
}
"""Sections with a winner of a search: its system and objective, and the design's name."""
COMPARED = {
    "IV": ("Eq. 78", "Eq. 75, divided by U"),
    "V": ("Figure 16", "Search"),
    "VI": ("Figure 20", "Search"),
    "VII": ("Figure 25", "Table 3, case 1"),
}
"""Presets of a section to see side by side: the report's design and the corrected one."""


def corrected_designs(section: str, eqs: PerturbationEquations) -> dict[str, dict[str, Value]]:
    """Return the corrected designs of one section: the rigid-body design of Eqs. 61 to 75, or gains found.

    Parameters
    ----------
    section : str
    eqs : PerturbationEquations
        Section IV's rigid body.
    """
    if section == "IV":
        own = designs("IV")["Eq. 78"]
        zeta, K_C = -WANTED.real / abs(WANTED), float(own["K_C"])
        gains = rigid_design(rigid_body(eqs), omega=abs(WANTED), zeta=zeta, K_C=K_C)
        return {"Eq. 75, divided by U": {**own, "K_A": gains.K_A, "K_R": gains.K_R}}
    by_hand: dict[str, dict[str, Value]] = {}
    if section == "VII":
        by_hand["Table 3, case 1"] = {**found_gains("dual_actuation")}
    return by_hand | _searched(section)


def _searched(section: str) -> dict[str, dict[str, Value]]:
    """Return a search's winner by name: gains to four figures, stations to a whole foot."""
    system, objective, name = SEARCHED[section]
    winner = next(w for w in winners() if (w.system, w.objective) == (system, objective))
    return {
        name: {
            key: float(round(value) if key.startswith(("sensor", "jet")) else f"{value:.4g}")
            for key, value in winner.gains.items()
        }
    }


def _printed(section: str, start: str) -> list[dict[str, Any]]:
    """Return printed roots (1/s), of a pair the upper one, as a preset tells them."""
    if not start:
        return []
    roots = printed_roots(section, start).values()
    return [{"re": r.real, "im": r.imag, "text": as_text([r])} for r in roots]


def presets(
    section: str, eqs: PerturbationEquations, loci: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Return the presets of one section, the report's first.

    Parameters
    ----------
    section : str
    eqs : PerturbationEquations
    loci : sequence of mapping
        The loci of the section's view; a preset names one of them by its place.
    """
    places = {locus["name"]: i for i, locus in enumerate(loci)}
    rows = {row["name"]: row for row in read_table("presets") if row["section"] == section}
    own = [
        {
            "name": name,
            "label": rows[name]["label"],
            "values": values,
            "locus": places[rows[name]["locus"]],
            "printed": _printed(section, rows[name]["printed"]),
            "path": rows[name]["path"],
            "note": "as printed",
        }
        for name, values in designs(section).items()
    ]
    return own + [
        {
            "name": name,
            "label": CORRECTED[name],
            "values": values,
            "locus": len(loci) - 1,
            "printed": [],
            "note": "corrected",
        }
        for name, values in corrected_designs(section, eqs).items()
    ]
