"""Table 3: what closure 1 does to both bending modes for each pair of a sensor and a jet."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.printed_closures import final_design
from rlswaim.loops.closures import JetLoop, closure_1_open_loop
from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.source import checks
from rlswaim.source.tables import column
from rlswaim.vehicle.coupling import elastic_poles
from rlswaim.vehicle.equations import PerturbationEquations


class Trial(NamedTuple):
    """What closure 1 does to both bending modes for one pair of Table 3, for the better sign of k K_z.

    ``factors`` are the coupled frequencies at the largest gain over those without the jet.  ``outcome``:
    "rises throughout" if at no gain up to there either frequency is below its own and both roots stay
    complex; "higher at the end" if that holds at the largest gain only; else "no".  ``unstable`` counts
    the roots right of the axis at the largest gain; ``steadies`` tells whether some gain leaves none there.
    """

    case: int
    sensor: float
    jet: float
    sign: int
    factors: tuple[float, float]
    outcome: str
    unstable: int
    steadies: bool


OUTCOMES = ("no", "higher at the end", "rises throughout")


def pairs() -> tuple[tuple[int, float, float], ...]:
    """Return the cases of Table 3: number, station of the sensor, station of the jet (ft)."""
    columns = (column("table3", name) for name in ("case", "sensor_ft", "jet_ft"))
    return tuple((int(case), sensor, jet) for case, sensor, jet in zip(*columns, strict=True))


def trials(eqs: PerturbationEquations, points: int = 600) -> tuple[Trial, ...]:
    """Return what becomes of each pair of Table 3.

    Parameters
    ----------
    eqs : PerturbationEquations
    points : int
        Gains that each locus is followed at, up to that of Figure 24.

    Returns
    -------
    tuple of Trial
    """
    design, largest = final_design()
    gains = gains_to(largest, points)
    return tuple(
        trial(eqs, case, design._replace(sensor=sensor, jet=jet), gains) for case, sensor, jet in pairs()
    )


def gains_to(largest: float, points: int) -> NDArray:
    """Return the sizes of gains at which a locus is followed: 0, and then evenly spaced logarithms.

    Parameters
    ----------
    largest : float
        The last gain; its sign plays no part.
    points : int
        How many gains follow the 0; the first of them is 1e-7 of the last.

    Returns
    -------
    ndarray, shape (points + 1,)

    Raises
    ------
    ValueError
        If the largest gain is not finite.
    """
    size = abs(checks.real("largest", largest, "gains_to"))
    return np.concatenate([[0.0], np.geomspace(1e-7, 1.0, points) * size])


def trial(eqs: PerturbationEquations, case: int, loop: JetLoop, gains: NDArray) -> Trial:
    """Return what closure 1 does for one pair of stations, for the better sign of k K_z.

    Parameters
    ----------
    eqs : PerturbationEquations
    case : int
        Number of the pair in Table 3.
    loop : JetLoop
        The jet's loop with the stations of the pair.
    gains : ndarray, shape (K,)
        Sizes of k K_z (lb s/ft), increasing from 0.

    Returns
    -------
    Trial
    """
    opened = closure_1_open_loop(eqs, loop)
    found = [_trial(eqs, case, loop, sign, root_locus(opened, sign * gains)) for sign in (1, -1)]
    return max(found, key=lambda s: (OUTCOMES.index(s.outcome), min(s.factors)))


def _trial(eqs: PerturbationEquations, case: int, loop: JetLoop, sign: int, locus: RootLocus) -> Trial:
    elastic = elastic_poles(eqs)
    way = locus.roots[:, [int(np.argmin(np.abs(locus.roots[0] - pole))) for pole in elastic]]
    factors = np.abs(way) / np.abs(way[0])
    good = ((factors >= 1 - 1e-6) & (way.imag > 1e-6)).all(axis=1)
    right = (locus.roots.real > 1e-7).sum(axis=1)
    return Trial(
        case,
        loop.sensor,
        loop.jet,
        sign,
        (float(factors[-1, 0]), float(factors[-1, 1])),
        OUTCOMES[int(good[-1]) + int(good.all())],
        int(right[-1]),
        bool((right == 0).any()),
    )
