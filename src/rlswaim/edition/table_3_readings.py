"""How the verdicts on Table 3's pairs depend on deflections read off a drawn curve.

`main` prints them as ``data/table_3_readings.csv``; ``make searches`` stores that.

The four deflections at sensor and jet are each scaled within a box; where both stand at one station there
is one reading of each mode.  What happens at small gain is settled exactly: its rates are affine in each
deflection, so that their signs in the whole box are those at its corners.  What happens further up is
followed at the corners and at samples within.
"""

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.edition.printed_closures import final_design
from rlswaim.edition.table_3 import OUTCOMES, Trial, trial, trials
from rlswaim.loops.closures import JetLoop, literal_bracket
from rlswaim.source import checks
from rlswaim.source.tables import number, read_table
from rlswaim.vehicle.coupling import elastic_poles
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations, with_reading

CORNERS = np.array(list(product((-1.0, 1.0), repeat=4)))
"""Signs of the errors of phi_1, phi_2 at the sensor and phi_1, phi_2 at the jet; shape (16, 4)."""
STORED, SAMPLES = (0.0, 0.05), 8
"""Least half widths of the boxes whose readings are stored, and readings within each box."""


class Readings(NamedTuple):
    """What closure 1 does for one pair of Table 3 over the box of possible readings.

    ``nominal`` is its `Trial` as read here.  ``rises``, ``ends`` and ``steadies`` count the readings, of
    ``total`` with the nominal one, that rise throughout, that are at least higher at the end, and that leave
    no root right of the axis at some gain.  ``barred`` is true if no reading in the box rises throughout,
    exactly: for either sign of the gain the frequency of one mode falls as soon as the gain leaves zero.
    """

    nominal: Trial
    rises: int
    ends: int
    steadies: int
    total: int
    barred: bool

    @property
    def judgement(self) -> str:
        """Whether the pair stiffens both modes: "robustly yes", "robustly no" or "depends on the reading"."""
        if self.barred or not self.rises:
            return "robustly no"
        return "robustly yes" if self.rises == self.total else "depends on the reading"


def deflections(eqs: PerturbationEquations, loop: JetLoop) -> NDArray:
    """Return the deflections at sensor and jet as read here.

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop

    Returns
    -------
    ndarray, shape (4,)
        phi_1, phi_2 at the sensor, phi_1, phi_2 at the jet.
    """
    return np.array([mode.deflection(x) for x in (loop.sensor, loop.jet) for mode in eqs.modes])


def starting_rates(eqs: PerturbationEquations, loop: JetLoop, phi: NDArray) -> NDArray:
    """Return d|s|/d(kK_z) of both elastic roots at kK_z = 0.

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    phi : ndarray, shape (K, 4)
        Readings, each as `deflections` gives them.

    Returns
    -------
    ndarray, shape (K, 2)
        In ft/(lb s^2); a mode whose rate has the sign of the gain is stiffened at first.
    """
    phi = checks.frozen_array("phi", phi, "starting_rates", shape=(len(phi), 4))
    fixed = np.tile([1.0, loop.jet - eqs.l_CG], (len(phi), 1))
    weights = np.hstack([fixed, phi[:, 2:]])
    braces = np.einsum("nij,ki,kj->nk", literal_bracket(eqs), phi[:, :2], weights)
    slope = npp.polyder(npp.polymul(loop.valve, eqs.characteristic_polynomial()))
    found = []
    for s in elastic_poles(eqs):
        numerator = loop.K_r * (loop.b + s) * s * npp.polyval(s, braces) / (1000 * eqs.U)
        found.append((np.conj(s) * numerator / npp.polyval(s, slope)).real / abs(s))
    return np.array(found).T


def read_so(eqs: PerturbationEquations, loop: JetLoop, phi: NDArray) -> PerturbationEquations:
    """Return the equations with other deflections at sensor and jet.

    Where both stand at one station, the sensor's two hold for both.

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    phi : ndarray, shape (4,)
        As `deflections` gives them.

    Returns
    -------
    PerturbationEquations
    """
    for station, (first, second) in {loop.jet: phi[2:], loop.sensor: phi[:2]}.items():
        eqs = with_reading(eqs, station, (first, second))
    return eqs


def readings(
    eqs: PerturbationEquations,
    pairs: Sequence[Trial],
    within: float = 0.05,
    least: float = 0.0,
    samples: int = 16,
    seed: int = 1964,
) -> tuple[Readings, ...]:
    """Return what closure 1 does for each pair of Table 3 if the deflections are read otherwise.

    Parameters
    ----------
    eqs : PerturbationEquations
    pairs : sequence of Trial
        From `rlswaim.edition.table_3.trials`.
    within : float
        Half the width of the box, relative to each deflection.
    least : float
        The least half width, for deflections near a node.
    samples : int
        Readings within the box besides its 16 corners.
    seed : int

    Returns
    -------
    tuple of Readings
    """
    within = checks.not_negative("within", within, "readings")
    least = checks.not_negative("least", least, "readings")
    inside = np.random.default_rng(seed).uniform(-1, 1, (samples, 4))
    offsets = np.vstack([CORNERS, inside])
    design, largest = final_design()
    found = []
    for pair in pairs:
        loop = design._replace(sensor=pair.sensor, jet=pair.jet)
        phi = deflections(eqs, loop)
        box = phi + np.maximum(within * np.abs(phi), least) * offsets
        others = [trial(read_so(eqs, loop, reading), pair.case, loop, largest) for reading in box]
        rates = starting_rates(eqs, loop, box[: len(CORNERS)])
        level = np.array([OUTCOMES.index(p.outcome) for p in (pair, *others)])
        found.append(
            Readings(
                pair,
                rises=int((level == 2).sum()),
                ends=int((level >= 1).sum()),
                steadies=sum(p.steadies for p in (pair, *others)),
                total=level.size,
                barred=bool((rates < 0).all(axis=0).any() and (rates > 0).all(axis=0).any()),
            )
        )
    return tuple(found)


def stored(pairs: Sequence[Trial], least: float) -> tuple[Readings, ...]:
    """Return the `readings` of Table 3's pairs that are stored in ``data/table_3_readings.csv``.

    Parameters
    ----------
    pairs : sequence of Trial
        From `rlswaim.edition.table_3.trials` of the printed equations.
    least : float
        The least half width, one of `STORED`.

    Returns
    -------
    tuple of Readings

    Raises
    ------
    ValueError
        If no box of this least half width is stored.
    """
    if least not in STORED:
        raise ValueError(f"stored: least must be one of {STORED}, got {least}")
    rows = {row["case"]: row for row in read_table("table_3_readings") if number(row["least"]) == least}
    found = []
    for pair in pairs:
        row = rows[str(pair.case)]
        rises, ends, steadies, total = (int(row[name]) for name in ("rises", "ends", "steadies", "total"))
        found.append(Readings(pair, rises, ends, steadies, total, row["barred"] == "yes"))
    return tuple(found)


def main() -> None:
    """Print the table ``data/table_3_readings.csv``."""
    eqs = printed_equations()
    print("least,case,rises,ends,steadies,total,barred")
    for least in STORED:
        for found in readings(eqs, trials(eqs), least=least, samples=SAMPLES):
            counts = (found.rises, found.ends, found.steadies, found.total)
            print(least, found.nominal.case, *counts, "yes" if found.barred else "no", sep=",")
