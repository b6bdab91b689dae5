"""Table 3: what closure 1 does to both bending modes for each pair of a sensor and a jet."""

from collections.abc import Sequence
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.printed_closures import final_design
from rlswaim.loops.closures import JetLoop, closure_1_open_loop
from rlswaim.rootlocus.break_aways import break_aways
from rlswaim.rootlocus.crossings import crossings
from rlswaim.rootlocus.locus import root_locus
from rlswaim.rootlocus.open_loop import open_loop
from rlswaim.source import checks
from rlswaim.source.tables import column
from rlswaim.vehicle.coupling import elastic_poles
from rlswaim.vehicle.equations import PerturbationEquations


class Trial(NamedTuple):
    """What closure 1 does to both bending modes for one pair of Table 3, for the better sign of k K_z.

    A mode is followed as a pair of complex roots from its place without the jet.  Where the two roots meet
    on the real axis it ends: real roots have no frequency, and a pair that real roots form at a larger gain
    is none of the two modes.  So it never counts which of two real roots is which.

    ``factors`` are the coupled frequencies at the largest gain over those without the jet, nan for a mode
    that has ended.  ``outcome``: "rises throughout" if at no gain up to there either frequency is below its
    own and neither mode ends; "higher at the end" if both are there at the largest gain, and higher; else
    "no".  ``unstable`` counts the roots right of the axis at the largest gain; ``steadies`` tells whether
    some gain leaves none there.
    """

    case: int
    sensor: float
    jet: float
    sign: int
    factors: tuple[float, float]
    outcome: str
    unstable: int
    steadies: bool


REAL = 1e-9
"""A root whose imaginary part is below this share of its size is real."""
OUTCOMES = ("no", "higher at the end", "rises throughout")


def pairs() -> tuple[tuple[int, float, float], ...]:
    """Return the cases of Table 3: number, station of the sensor, station of the jet (ft)."""
    columns = (column("table3", name) for name in ("case", "sensor_ft", "jet_ft"))
    return tuple((int(case), sensor, jet) for case, sensor, jet in zip(*columns, strict=True))


def trials(eqs: PerturbationEquations) -> tuple[Trial, ...]:
    """Return what becomes of each pair of Table 3 up to the gain of Figure 24; ``eqs`` are the equations."""
    design, largest = final_design()
    return tuple(
        trial(eqs, case, design._replace(sensor=sensor, jet=jet), largest) for case, sensor, jet in pairs()
    )


def _in_units(opened: control.TransferFunction, size: float) -> control.TransferFunction:
    """Return an open loop in s over a size: its roots of that size lie on the unit circle."""
    top, bottom = (p[0][0] * size ** np.arange(p[0][0].size - 1.0, -1, -1) for p in (opened.num, opened.den))
    return control.tf(top / bottom[0], bottom / bottom[0], True)


def deciding_gains(opened: control.TransferFunction, sizes: Sequence[float], largest: float) -> NDArray:
    """Return the gains at which something can change in what is said of a trial.

    At such a gain two roots meet on the real axis, a root crosses the imaginary axis, or a root is as
    far from the origin as an elastic pole without the jet.  Between two of them nothing changes.

    Parameters
    ----------
    opened : TransferFunction
        Closure 1's open loop for k K_z = 1.
    sizes : sequence of float
        Distances of the elastic poles from the origin (rad/s).
    largest : float
        Gains of larger size are left out; its sign plays no part.

    Returns
    -------
    ndarray, shape (K,)
        Increasing, of both signs (lb s/ft).
    """
    loop = open_loop(opened)
    met = [meeting for meeting in break_aways(loop) if abs(meeting.point.imag) <= REAL * abs(meeting.point)]
    passed = [*crossings(loop)]
    for size in sizes:
        passed += crossings(open_loop(_in_units(opened, size)))
    found = [meeting.gain for meeting in met] + [crossing.gain for crossing in passed]
    return np.unique([gain for gain in found if abs(gain) <= abs(largest)])


def trial(eqs: PerturbationEquations, case: int, loop: JetLoop, largest: float) -> Trial:
    """Return what closure 1 does for one pair of stations, for the better sign of k K_z.

    Parameters
    ----------
    eqs : PerturbationEquations
    case : int
        Number of the pair in Table 3.
    loop : JetLoop
        The jet's loop with the stations of the pair.
    largest : float
        Largest size of k K_z (lb s/ft); its sign plays no part.

    Returns
    -------
    Trial

    Raises
    ------
    ValueError
        If the largest gain is not finite.
    """
    size = abs(checks.real("largest", largest, "trial"))
    opened, elastic = closure_1_open_loop(eqs, loop), elastic_poles(eqs)
    decide = deciding_gains(opened, [abs(pole) for pole in elastic], size)
    edges = np.unique([-size, *decide, 0.0, size])
    followed = np.unique([-size, *(edges[:-1] + edges[1:]) / 2, 0.0, size])
    roots, start = root_locus(opened, followed).roots, int(np.flatnonzero(followed == 0)[0])
    found = [
        _trial(case, loop, sign, elastic, way) for sign, way in ((1, roots[start:]), (-1, roots[start::-1]))
    ]
    return max(found, key=lambda s: (OUTCOMES.index(s.outcome), min(np.nan_to_num(s.factors))))


def _trial(case: int, loop: JetLoop, sign: int, elastic: Sequence[complex], roots: NDArray) -> Trial:
    """Return the trial for one sign of the gain, from a root set at 0 and one between any two deciding gains.

    Parameters
    ----------
    case : int
    loop : JetLoop
    sign : int
    elastic : sequence of complex
        The elastic poles without the jet (1/s).
    roots : ndarray of complex, shape (K, n)
        Continuous branches, from the gain 0 to the largest one.
    """
    way = roots[:, [int(np.argmin(np.abs(roots[0] - pole))) for pole in elastic]]
    there = np.logical_and.accumulate(np.abs(way.imag) > REAL * np.abs(way), axis=0)
    factors = np.where(there, np.abs(way) / np.abs(way[0]), np.nan)
    good = np.all(factors[1:] >= 1, axis=1)
    right = (roots[1:].real > 1e-7).sum(axis=1)  # the root that rests at the origin is none
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
