"""Stations along the vehicle: its length, and checks that stations lie on it."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.source import checks

LENGTH = 420.0
"""Length of the vehicle (ft): stations run from 0 at the nose to this."""


def as_station(what: str, value: object, where: str = "") -> float:
    """Return ``value`` as a station in feet; ValueError outside 0..420 ft."""
    number = checks.real(what, value, where)
    if not 0 <= number <= LENGTH:
        place = f" in {where}" if where else ""
        raise ValueError(f"{what}{place}: got station {number:g} ft, wanted 0 to {LENGTH:g} ft")
    return number


def as_stations(what: str, values: ArrayLike, where: str = "") -> NDArray:
    """Return ``values`` as stations in feet; ValueError if one lies outside 0..420 ft."""
    array = checks.frozen_array(what, values, where)
    outside = np.flatnonzero((array < 0) | (array > LENGTH))
    if outside.size:
        at = int(outside[0])
        place = f" in {where}" if where else ""
        raise ValueError(f"{what}[{at}]{place}: got station {array.flat[at]:g} ft, wanted 0 to {LENGTH:g} ft")
    return array


def increasing_stations(what: str, values: ArrayLike, where: str = "") -> NDArray:
    """Return ``values`` as strictly increasing stations in feet; ValueError otherwise."""
    array = as_stations(what, values, where)
    stuck = np.flatnonzero(np.diff(array) <= 0)
    if stuck.size:
        at = int(stuck[0]) + 1
        place = f" in {where}" if where else ""
        raise ValueError(
            f"{what}{place}: got {what}[{at}] = {array[at]:g} ft after {array[at - 1]:g} ft, "
            "wanted increasing stations"
        )
    return array
