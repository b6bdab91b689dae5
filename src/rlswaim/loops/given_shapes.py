"""Bending modes that take given values at single stations, so that these can be factors of a family."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rlswaim.vehicle.equations import PerturbationEquations
from rlswaim.vehicle.modes import BendingMode


@dataclass(frozen=True)
class ModeWith:
    """A bending mode with other numbers in place of its own at single stations (ft)."""

    mode: BendingMode
    deflections: Mapping[float, float]
    slopes: Mapping[float, float]

    def deflection(self, station: float) -> float:
        """Return phi at a station: the given number, else the mode's own."""
        return self.deflections[station] if station in self.deflections else self.mode.deflection(station)

    def slope(self, station: float) -> float:
        """Return sigma = -d phi/d l (1/ft) at a station: the given number, else the mode's own."""
        return self.slopes[station] if station in self.slopes else self.mode.slope(station)


def with_shapes(
    eqs: PerturbationEquations,
    deflections: Mapping[float, Sequence[float]] | None = None,
    slopes: Mapping[float, Sequence[float]] | None = None,
) -> PerturbationEquations:
    """Return the equations with modes that take given values at single stations.

    Parameters
    ----------
    eqs : PerturbationEquations
    deflections, slopes : mapping of station (ft) to the values of both modes, optional
        phi_1, phi_2 and sigma_1, sigma_2 (1/ft): so they can be factors in their own right.
    """
    given = (deflections or {}, slopes or {})
    modes: Any = tuple(
        ModeWith(mode, *({at: pair[i] for at, pair in shapes.items()} for shapes in given))
        for i, mode in enumerate(eqs.modes)
    )
    return replace(eqs, modes=modes)
