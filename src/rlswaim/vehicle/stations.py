"""Stations along the vehicle: its length, and checks that stations lie on it."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.source import checks
from rlswaim.source.checks import named
from rlswaim.source.tables import constants

LENGTH = constants("vehicle")["L"]
"""Length of the vehicle (ft): stations run from 0 at the nose to this."""


def as_station(what: str, value: object, where: str = "") -> float:
    """Return a value as a station.

    Parameters
    ----------
    what, where : str
        As in `rlswaim.source.checks.named`.
    value : object
        In ft.

    Raises
    ------
    TypeError, ValueError
        If it is no finite number, or lies outside 0..420 ft.
    """
    number = checks.real(what, value, where)
    if not 0 <= number <= LENGTH:
        raise ValueError(f"{named(what, where)}: got station {number:g} ft, wanted 0 to {LENGTH:g} ft")
    return number


def as_stations(what: str, values: ArrayLike, where: str = "") -> NDArray:
    """Return some values as stations.

    Parameters
    ----------
    what, where : str
        As in `rlswaim.source.checks.named`.
    values : array_like
        In ft.

    Raises
    ------
    TypeError, ValueError
        If one is no finite number, or lies outside 0..420 ft.
    """
    array = checks.frozen_array(what, values, where)
    outside = np.flatnonzero((array < 0) | (array > LENGTH))
    if outside.size:
        at = int(outside[0])
        place = named(f"{what}[{at}]", where)
        raise ValueError(f"{place}: got station {array.flat[at]:g} ft, wanted 0 to {LENGTH:g} ft")
    return array


def increasing_stations(what: str, values: ArrayLike, where: str = "") -> NDArray:
    """Return some values as stations that increase.

    Parameters
    ----------
    what, where : str
        As in `rlswaim.source.checks.named`.
    values : array_like
        In ft.

    Raises
    ------
    TypeError, ValueError
        As in `as_stations`, and if one is not above the one before.
    """
    array = as_stations(what, values, where)
    stuck = np.flatnonzero(np.diff(array) <= 0)
    if stuck.size:
        at = int(stuck[0]) + 1
        raise ValueError(
            f"{named(what, where)}: got {what}[{at}] = {array[at]:g} ft after {array[at - 1]:g} ft, "
            "wanted increasing stations"
        )
    return array
