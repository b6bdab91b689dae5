"""Checks of what callers pass in: every error says what, where, got and wanted."""

import math
from collections.abc import Iterable
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray


def named(what: str, where: str) -> str:
    """Return how an error names a value.

    Parameters
    ----------
    what, where : str
        Name of the value, and of the place that it was given to; the place may be empty.
    """
    return f"{what} in {where}" if where else what


def real(what: str, value: object, where: str = "") -> float:
    """Return a value as a finite float.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : object

    Raises
    ------
    TypeError
        If it is not a real number (bool counts as none).
    ValueError
        If it is nan or infinite.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Real):
        kind = type(value).__name__
        raise TypeError(f"{named(what, where)}: got {value!r} ({kind}), wanted a real number")
    if not math.isfinite(value):
        raise ValueError(f"{named(what, where)}: got {value}, wanted a finite number")
    return float(value)


def positive(what: str, value: object, where: str = "") -> float:
    """Return a value as a finite float greater than zero.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : object

    Raises
    ------
    TypeError, ValueError
        As in `real`, and if the value is not above zero.
    """
    number = real(what, value, where)
    if number <= 0:
        raise ValueError(f"{named(what, where)}: got {number:g}, wanted a number above 0")
    return number


def not_negative(what: str, value: object, where: str = "") -> float:
    """Return a value as a finite float of at least zero.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : object

    Raises
    ------
    TypeError, ValueError
        As in `real`, and if the value is below zero.
    """
    number = real(what, value, where)
    if number < 0:
        raise ValueError(f"{named(what, where)}: got {number:g}, wanted 0 or more")
    return number


def off_axis(what: str, value: complex, where: str) -> complex:
    """Return a value as a finite complex number off the real axis.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : complex

    Raises
    ------
    ValueError
        If it is not finite or is real.
    """
    if not np.isfinite(value) or not np.imag(value):
        raise ValueError(f"{named(what, where)}: got {value}, wanted a finite number off the real axis")
    return complex(value)


def frozen_array(
    what: str, values: ArrayLike, where: str = "", shape: tuple[int, ...] | None = None
) -> NDArray:
    """Return a read-only float copy of some values.

    Parameters
    ----------
    what, where : str
        As in `named`.
    values : array_like
    shape : tuple of int, optional
        The shape that they must have.

    Raises
    ------
    TypeError
        If the values are complex or no numbers.
    ValueError
        If one is not finite, or the shape is not the wanted one.
    """
    try:
        raw = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{named(what, where)}: got rows of unequal lengths, wanted an array") from error
    if raw.dtype.kind not in "iuf":
        raise TypeError(f"{named(what, where)}: got an array of {raw.dtype}, wanted real numbers")
    array = np.array(raw, dtype=float)
    if shape is not None and array.shape != shape:
        raise ValueError(f"{named(what, where)}: got shape {array.shape}, wanted {shape}")
    if not np.isfinite(array).all():
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        raise ValueError(f"{named(f'{what}[{at}]', where)}: got {array.flat[at]}, wanted finite numbers")
    array.setflags(write=False)
    return array


def instance(what: str, value: Any, kind: type, where: str = "") -> Any:
    """Return a value if it is of a kind.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : object
    kind : type

    Raises
    ------
    TypeError
        If it is of another kind.
    """
    if not isinstance(value, kind):
        raise TypeError(f"{named(what, where)}: got {type(value).__name__}, wanted {kind.__name__}")
    return value


def one_of(what: str, value: object, names: Iterable[str], where: str = "") -> str:
    """Return a value if it is one of some names.

    Parameters
    ----------
    what, where : str
        As in `named`.
    value : object
    names : iterable of str

    Raises
    ------
    ValueError
        If it is none of them; the error lists them.
    """
    known = list(names)
    if not isinstance(value, str) or value not in known:
        raise ValueError(f"{named(what, where)}: got {value!r}, wanted one of {', '.join(known)}")
    return value
