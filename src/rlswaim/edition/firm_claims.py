"""What the proofs of Sections IV to VI rest on: gravity along the path, and last printed digits.

Each proof rules out all gains at some stations: by signs of coefficients (`stability_certificate`), or
even when a slow real root is let go (`slow_root_certificate`).  Here each is judged with gravity and
without, and again with the printed coefficients moved within their last digits, as the proof bears least.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from rlswaim.edition.slow_roots import slow_bound
from rlswaim.loops.certificates import slow_root_certificate, stability_certificate
from rlswaim.source.tables import half_unit
from rlswaim.vehicle.equations import (
    PerturbationEquations,
    printed_coefficients,
    printed_equations,
    with_reading,
)
from rlswaim.vehicle.stations import LENGTH

ANY_PAIR = (300.0, 140.0)
"""Two sensors in general position (ft): their readings span those of every pair."""
FEET = tuple(float(x) for x in range(int(LENGTH) + 1))
PROVED = 1e-9
"""Distances below this are rounding of the linear programs."""
Distance = Callable[[PerturbationEquations, float], float]


def _by_signs(eqs: PerturbationEquations, gyro: float | None, sensors: Sequence[float]) -> float:
    return -stability_certificate(eqs, gyro, sensors).margin


def _but_a_slow_root(eqs: PerturbationEquations, gyro: float | None, sensors: Sequence[float]) -> float:
    return slow_root_certificate(eqs, gyro, sensors, slow_bound())


CLAIMS: dict[str, tuple[Distance, tuple[float, ...]]] = {
    "IV: no gains stabilize": (lambda eqs, x: _by_signs(eqs, x, ()), FEET),
    "IV: no gains leave only a slow root": (lambda eqs, x: _but_a_slow_root(eqs, x, ()), FEET),
    "V: no gains stabilize": (lambda eqs, x: _by_signs(eqs, None, (x,)), FEET),
    "V: no gains leave only a slow root": (lambda eqs, x: _but_a_slow_root(eqs, None, (x,)), FEET),
    "VI: no gains stabilize": (lambda eqs, _: _by_signs(eqs, None, ANY_PAIR), FEET[:1]),
    "VI: no gains leave only a slow root": (lambda eqs, _: _but_a_slow_root(eqs, None, ANY_PAIR), FEET[:1]),
}
"""How far each claim holds at one station (positive where it is proved), and the stations it is about."""


class Judgement(NamedTuple):
    """How far one claim holds.

    Attributes
    ----------
    claim : str
        One of `CLAIMS`.
    gravity : bool
        Whether the equations keep Eq. 1's weight across the path.
    ruled_out, stations : int
        Stations at which it is proved, and all.
    weakest : float
        The station (ft) where it holds least.
    holds_by : float
        Distance there, in units of the coefficients of the characteristic polynomial; where it is
        not positive, nothing is proved.
    last_digits : float
        The least distance at ``weakest`` that was found with the coefficients moved by at most half
        a unit of their last printed digit.
    """

    claim: str
    gravity: bool
    ruled_out: int
    stations: int
    weakest: float
    holds_by: float
    last_digits: float

    @property
    def firm(self) -> bool:
        """Whether the claim is proved at all its stations and no last digit found takes it away."""
        return self.holds_by > PROVED and self.last_digits > PROVED


def moved(eqs: PerturbationEquations, units: dict[str, float]) -> PerturbationEquations:
    """Return the equations with printed coefficients moved.

    Parameters
    ----------
    eqs : PerturbationEquations
        With the printed coefficients.
    units : dict of str to float
        Coefficients by name, and by how many units of their last printed digit each is moved.
    """
    printed = printed_coefficients()
    more = {name: eqs.coefficients[name] + 2 * u * half_unit(printed[name]) for name, u in units.items()}
    return replace(eqs, coefficients={**eqs.coefficients, **more})


def judged(claim: str, gravity: bool, stations: Sequence[float] | None = None) -> Judgement:
    """Return how far one claim holds.

    Parameters
    ----------
    claim : str
        One of `CLAIMS`.
    gravity : bool
        Keep Eq. 1's weight across the path.
    stations : sequence of float, optional
        In ft; without them all whole feet, or for Section VI the pair that stands for all.

    Returns
    -------
    Judgement
    """
    how, everywhere = CLAIMS[claim]
    stations = everywhere if stations is None else stations
    eqs = printed_equations(gravity)
    distances = np.array([how(eqs, x) for x in stations])
    weakest = stations[int(distances.argmin())]
    least = _with_last_digits(lambda moved_eqs: how(moved_eqs, weakest), eqs)
    ruled_out, holds_by = int((distances > PROVED).sum()), float(distances.min())
    return Judgement(claim, gravity, ruled_out, len(stations), weakest, holds_by, min(holds_by, least))


def _with_last_digits(
    distance: Callable[[PerturbationEquations], float], eqs: PerturbationEquations
) -> float:
    """Return the least distance with one coefficient moved half a unit, or all of them as they tell least."""
    ends = {
        name: [distance(moved(eqs, {name: units})) for units in (-0.5, 0.5)]
        for name in printed_coefficients()
    }
    worst = {name: -0.5 if down < up else 0.5 for name, (down, up) in ends.items()}
    return float(min(distance(moved(eqs, worst)), *(value for pair in ends.values() for value in pair)))


def judgements() -> tuple[Judgement, ...]:
    """Return every claim without gravity, then every claim with it; about half a minute."""
    return tuple(judged(claim, gravity) for gravity in (False, True) for claim in CLAIMS)


def at_reading(station: float, phi: Sequence[float], gravity: bool = False) -> tuple[float, float]:
    """Return whether one sensor is ruled out with given deflections at its station [Section V].

    Parameters
    ----------
    station : float
        Of the sensor (ft).
    phi : sequence of float
        Deflection of each mode there, as the report may have read it off Figure 5.
    gravity : bool
        Keep Eq. 1's weight across the path.

    Returns
    -------
    stable, but_slow : float
        Distances by which no gains stabilize, and by which none leave only a slow root; nothing is
        proved where they are not positive.
    """
    eqs = with_reading(printed_equations(gravity), station, phi)
    return _by_signs(eqs, None, (station,)), _but_a_slow_root(eqs, None, (station,))
