"""Bending modes: deflection, slope, generalized mass and orthogonality.

The report prints the deflection phi of each mode at eleven mass stations and at
the thrust point G, and the slope sigma = -d phi/d l at six stations.  Between
them we take the shape of a uniform beam that is held at every printed
deflection and turned to every printed slope, and that bends as little as it
can: of all shapes through the data it has the least integral of (d^2 phi/d l^2)^2.
It is a cubic between stations, has a continuous slope everywhere, and is
straight ahead of station 27.  How far it errs between the data can be seen by
withholding a printed slope: `BendingMode.withheld_slopes`; chapter II of the
book gives the figures.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Self, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicHermiteSpline

from rlswaim.source import checks
from rlswaim.source.quantity import quantity
from rlswaim.vehicle.stations import LENGTH, as_station, as_stations, increasing_stations


def _beam_stiffness(x: NDArray) -> NDArray:
    """Return the stiffness matrix (2n, 2n) of a uniform beam with nodes x (ft), EI = 1."""
    stiffness = np.zeros((2 * x.size, 2 * x.size))
    for i, h in enumerate(np.diff(x)):
        element = (
            np.array(
                [
                    [12, 6 * h, -12, 6 * h],
                    [6 * h, 4 * h * h, -6 * h, 2 * h * h],
                    [-12, -6 * h, 12, -6 * h],
                    [6 * h, 2 * h * h, -6 * h, 4 * h * h],
                ]
            )
            / h**3
        )
        stiffness[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += element
    return stiffness


def least_bending_shape(
    deflections: Mapping[float, float], slopes: Mapping[float, float]
) -> CubicHermiteSpline:
    """Return the least-bending curve through given deflections and derivatives.

    Parameters
    ----------
    deflections : mapping of station (ft) to deflection
    slopes : mapping of station (ft) to derivative d phi/d l (1/ft)

    Returns
    -------
    CubicHermiteSpline
        The curve on 0..420 ft.
    """
    x = np.unique([0.0, LENGTH, *deflections, *slopes])
    known = np.concatenate(
        [2 * np.searchsorted(x, list(deflections)), 2 * np.searchsorted(x, list(slopes)) + 1]
    ).astype(int)
    free = np.setdiff1d(np.arange(2 * x.size), known)
    nodes = np.zeros(2 * x.size)
    nodes[known] = [*deflections.values(), *slopes.values()]
    stiffness = _beam_stiffness(x)
    load = -stiffness[np.ix_(free, known)] @ nodes[known]
    nodes[free] = np.linalg.solve(stiffness[np.ix_(free, free)], load)
    return CubicHermiteSpline(x, nodes[::2], nodes[1::2])


@dataclass(frozen=True, eq=False)
class BendingMode:
    """One free-free bending mode as the report prints it [Table 2, Figure 5].

    Raises
    ------
    ValueError
        If stations do not increase or lie outside 0..420 ft, arrays differ in
        length, a number is not finite, the frequency or the generalized mass
        is not positive, or the damping ratio is negative.
    """

    stations: NDArray = quantity("l", "ft", "stations of the printed deflections", "Table 2")
    deflections: NDArray = quantity("phi", "1", "normalized deflections there, positive up", "Table 2")
    slope_stations: NDArray = quantity("l", "ft", "stations of the printed slopes", "Table 2, Section IV")
    slopes: NDArray = quantity("sigma", "1/ft", "negative slopes -d phi/d l there", "Table 2, Section IV")
    omega: float = quantity("omega", "rad/s", "undamped natural frequency", "Section II")
    zeta: float = quantity("zeta", "1", "structural damping ratio", "Section III")
    mass: float = quantity("calM", "slug", "generalized mass", "Table 2")
    name: str = field(default="mode", metadata={})

    def __post_init__(self) -> None:
        """Check and freeze the data."""
        where = f"BendingMode {self.name}"
        x = increasing_stations("stations", self.stations, where)
        at = increasing_stations("slope_stations", self.slope_stations, where)
        for what, value in {
            "stations": x,
            "deflections": checks.frozen_array("deflections", self.deflections, where, x.shape),
            "slope_stations": at,
            "slopes": checks.frozen_array("slopes", self.slopes, where, at.shape),
            "omega": checks.positive("omega", self.omega, where),
            "zeta": checks.not_negative("zeta", self.zeta, where),
            "mass": checks.positive("mass", self.mass, where),
        }.items():
            object.__setattr__(self, what, value)

    @cached_property
    def shape(self) -> CubicHermiteSpline:
        """The least-bending curve through the printed deflections and slopes."""
        return least_bending_shape(
            dict(zip(self.stations.tolist(), self.deflections.tolist(), strict=True)),
            dict(zip(self.slope_stations.tolist(), (-self.slopes).tolist(), strict=True)),
        )

    @overload
    def deflection(self, station: float) -> float: ...
    @overload
    def deflection(self, station: NDArray | Sequence[float]) -> NDArray: ...
    def deflection(self, station: float | NDArray | Sequence[float]) -> NDArray | float:
        """Return phi at a station or an array of stations (ft); ValueError outside 0..420 ft."""
        return self._along(station, 0)

    @overload
    def slope(self, station: float) -> float: ...
    @overload
    def slope(self, station: NDArray | Sequence[float]) -> NDArray: ...
    def slope(self, station: float | NDArray | Sequence[float]) -> NDArray | float:
        """Return sigma = -d phi/d l (1/ft) at a station or more; ValueError outside 0..420 ft [Eq. 19]."""
        return -self._along(station, 1)

    def through(self, station: float, value: float) -> Self:
        """Return the mode bent to pass through one more deflection.

        Parameters
        ----------
        station : float
            In ft, away from the stations of the mode's own deflections.
        value : float
            Deflection there.

        Returns
        -------
        BendingMode
        """
        at = int(np.searchsorted(self.stations, station))
        stations = np.insert(self.stations, at, station)
        return replace(self, stations=stations, deflections=np.insert(self.deflections, at, value))

    def withheld_slopes(self, all_at_once: bool = False) -> NDArray:
        """Return sigma (1/ft) at each printed slope station, from a curve that does not use the slope there.

        The curve leaves out one printed slope at a time or, with ``all_at_once``, all of them.
        """
        phi = dict(zip(self.stations.tolist(), self.deflections.tolist(), strict=True))
        known = dict(zip(self.slope_stations.tolist(), (-self.slopes).tolist(), strict=True))
        rest = [{} if all_at_once else {x: v for x, v in known.items() if x != at} for at in known]
        shapes = (least_bending_shape(phi, slopes) for slopes in rest)
        return np.array([-float(shape(at, 1)) for at, shape in zip(known, shapes, strict=True)])

    def _along(self, station: ArrayLike, derivative: int) -> NDArray | float:
        if np.ndim(station) == 0:
            return float(self.shape(as_station("station", station, self.name), derivative))
        return self.shape(as_stations("station", station, self.name), derivative)


def generalized_mass(masses: NDArray, first: NDArray, second: NDArray) -> float:
    """Return the sum of mass times two shapes (slug): the generalized mass of one, 0 if two are orthogonal.

    Parameters
    ----------
    masses, first, second : ndarray, shape (n,)
        Masses (slug), and the deflection of both shapes there.
    """
    return float(np.sum(masses * first * second))


def translation_product(masses: NDArray, phi: NDArray) -> float:
    """Return the sum of mass times deflection (slug): 0 if orthogonal to translation [Section II].

    Parameters
    ----------
    masses, phi : ndarray, shape (n,)
        Masses (slug), and the mode's deflection there.
    """
    return float(np.sum(masses * phi))


def rotation_product(masses: NDArray, phi: NDArray, arms: NDArray) -> float:
    """Return the sum of mass times deflection times arm (slug ft): 0 if orthogonal to rotation.

    Parameters
    ----------
    masses, phi, arms : ndarray, shape (n,)
        Masses (slug), the mode's deflection there, and the arms l_CG - l (ft).
    """
    return float(np.sum(masses * phi * arms))


def mass_cosine(masses: NDArray, first: NDArray, second: NDArray) -> float:
    """Return the cosine of the angle between two shapes, weighted by mass: 0 if orthogonal, 1 if alike.

    Parameters
    ----------
    masses, first, second : ndarray, shape (n,)
        As in `generalized_mass`.
    """
    product, one, other = (
        generalized_mass(masses, a, b) for a, b in ((first, second), (first, first), (second, second))
    )
    return float(product / np.sqrt(one * other))


def purified(
    mode: BendingMode, stations: NDArray, masses: NDArray, others: Sequence[BendingMode] = ()
) -> BendingMode:
    """Return a mode less its parts along rigid translation, rigid rotation and other modes.

    Parameters
    ----------
    mode : BendingMode
    stations, masses : ndarray, shape (n,)
        Of the concentrated masses (ft, slug), the weights of the projection.
    others : sequence of BendingMode
        Modes with the stations of ``mode``.

    Returns
    -------
    BendingMode
        Bent as before but for the others: a straight line is taken off its deflections.
    """

    def basis(x: NDArray, slope: bool = False) -> NDArray:
        line = [0 * x, 0 * x + 1] if slope else [0 * x + 1, -x]
        return np.column_stack([*line, *(o.slope(x) if slope else o.deflection(x) for o in others)])

    weight = np.sqrt(masses)
    share = np.linalg.lstsq(weight[:, None] * basis(stations), weight * mode.deflection(stations))[0]
    return replace(
        mode,
        deflections=mode.deflections - basis(mode.stations) @ share,
        slopes=mode.slopes - basis(mode.slope_stations, slope=True) @ share,
    )
