"""Checks of what callers pass in: every error says what, where, got and wanted."""

import math
from collections.abc import Iterable
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray


def real(what: str, value: object, where: str = "") -> float:
    """Return ``value`` as a finite float.

    Raises
    ------
    TypeError
        If it is not a real number (bool counts as none).
    ValueError
        If it is nan or infinite.
    """
    place = f" in {where}" if where else ""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Real):
        raise TypeError(f"{what}{place}: got {value!r} ({type(value).__name__}), wanted a real number")
    if not math.isfinite(value):
        raise ValueError(f"{what}{place}: got {value}, wanted a finite number")
    return float(value)


def positive(what: str, value: object, where: str = "") -> float:
    """Return ``value`` as a finite float greater than zero; ValueError or TypeError otherwise."""
    number = real(what, value, where)
    if number <= 0:
        raise ValueError(f"{what}{' in ' + where if where else ''}: got {number:g}, wanted a number above 0")
    return number


def not_negative(what: str, value: object, where: str = "") -> float:
    """Return ``value`` as a finite float of at least zero; ValueError or TypeError otherwise."""
    number = real(what, value, where)
    if number < 0:
        raise ValueError(f"{what}{' in ' + where if where else ''}: got {number:g}, wanted 0 or more")
    return number


def off_axis(what: str, value: complex, where: str) -> complex:
    """Return ``value`` as a finite complex number off the real axis; ValueError otherwise."""
    if not np.isfinite(value) or not np.imag(value):
        raise ValueError(f"{what} in {where}: got {value}, wanted a finite number off the real axis")
    return complex(value)


def frozen_array(
    what: str, values: ArrayLike, where: str = "", shape: tuple[int, ...] | None = None
) -> NDArray:
    """Return a read-only float copy of ``values``.

    Raises
    ------
    TypeError
        If the values are complex or no numbers.
    ValueError
        If one is not finite, or the shape is not the wanted one.
    """
    place = f" in {where}" if where else ""
    raw = np.asarray(values)
    if raw.dtype.kind not in "iuf":
        raise TypeError(f"{what}{place}: got an array of {raw.dtype}, wanted real numbers")
    array = np.array(raw, dtype=float)
    if shape is not None and array.shape != shape:
        raise ValueError(f"{what}{place}: got shape {array.shape}, wanted {shape}")
    if not np.isfinite(array).all():
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        raise ValueError(f"{what}[{at}]{place}: got {array.flat[at]}, wanted finite numbers")
    array.setflags(write=False)
    return array


def instance(what: str, value: Any, kind: type, where: str = "") -> Any:
    """Return ``value`` if it is a ``kind``; TypeError otherwise."""
    if not isinstance(value, kind):
        place = f" in {where}" if where else ""
        raise TypeError(f"{what}{place}: got {type(value).__name__}, wanted {kind.__name__}")
    return value


def one_of(what: str, value: object, names: Iterable[str], where: str = "") -> str:
    """Return ``value`` if it is one of ``names``; ValueError that lists them otherwise."""
    known = list(names)
    if not isinstance(value, str) or value not in known:
        place = f" in {where}" if where else ""
        raise ValueError(f"{what}{place}: got {value!r}, wanted one of {', '.join(known)}")
    return value
