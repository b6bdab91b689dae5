"""Printed roots beside ours: which of our roots belongs to which row of the table.

An id ends in the kind of number: ``-root`` (a real root), ``-re`` and ``-im``
(a complex one), ``-2zw`` and ``-w2`` (s^2 + 2 zeta omega s + omega^2), or
``-omega`` and ``-zeta``.  What stands before names the root.  Section VII numbers
its real roots, ``-r1``, ``-r2`` and so on; such an id is the root's whole name.
"""

import re
from collections import defaultdict
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from rlswaim.source.tables import printed, printed_rows
from rlswaim.vehicle.equations import PerturbationEquations

KINDS = {
    "root": lambda s: s.real,
    "re": lambda s: s.real,
    "im": lambda s: abs(s.imag),
    "2zw": lambda s: -2 * s.real,
    "w2": lambda s: abs(s) ** 2,
    "omega": abs,
    "zeta": lambda s: -s.real / abs(s),
}


def as_written(eqs: PerturbationEquations, *starts: str) -> dict[str, float]:
    """Return the entries of Eq. 38's matrix and thrust column as the report writes them.

    Parameters
    ----------
    eqs : PerturbationEquations
    *starts : str
        Starts of ids, for instance ``"eq38-"``; the entries are returned for each of them.
    """
    entries = {**eqs.coefficients, "Z_thetadot": eqs.coefficients["Z_thetadot"] - eqs.U, "U": eqs.U}
    return {f"{start}{name}": value for start in starts for name, value in entries.items()}


def choices(section: str) -> dict[str, float]:
    """Return the gains and stations that a ``section`` chooses and that the computations take from it."""
    chosen = {row["id"] for row in printed_rows(section) if row["quantity"].endswith("(a choice)")}
    return {name: number for name, number in printed(section).items() if name in chosen}


def _name_and_kind(id_: str) -> tuple[str, str]:
    """Return the name of the root that a row is of, and the kind of its number; "" is the kind of no root."""
    name, _, end = id_.rpartition("-")
    if re.fullmatch(r"r\d+", end):
        return id_, "root"
    return (name, end) if end in KINDS else (id_, "")


def _root(kinds: dict[str, float]) -> complex:
    """Return the root (1/s) behind its printed numbers; of a pair, the one above the real axis."""
    if "root" in kinds:
        return complex(kinds["root"])
    if "re" in kinds:
        return complex(kinds["re"], kinds["im"])
    if "w2" in kinds:
        return complex(-kinds["2zw"] / 2, np.sqrt(kinds["w2"] - kinds["2zw"] ** 2 / 4))
    return kinds["omega"] * complex(-kinds["zeta"], np.sqrt(1 - kinds["zeta"] ** 2))


def printed_roots(section: str, start: str) -> dict[str, complex]:
    """Return printed roots (1/s) by name.

    Parameters
    ----------
    section : str
    start : str
        How the ids of their rows begin.
    """
    groups: dict[str, dict[str, float]] = defaultdict(dict)
    for id_, value in printed(section).items():
        name, kind = _name_and_kind(id_)
        if id_.startswith(start) and kind:
            groups[name][kind] = value
    return {name: _root(kinds) for name, kinds in groups.items()}


def roots_beside(section: str, start: str, computed: NDArray) -> dict[str, float]:
    """Return our number for each row of printed roots.

    Each printed root is paired with another one of ours, so that the sum of all distances is least.

    Parameters
    ----------
    section : str
    start : str
        How the ids start, for instance ``"eq92-"``.
    computed : ndarray of complex, shape (n,)
        Our roots (1/s), pairs in full or by their upper root.

    Returns
    -------
    dict of str to float
        By id; a printed root without one of ours is not among them.
    """
    ours = np.asarray(computed, dtype=complex)
    ours = ours[ours.imag >= 0]
    theirs = printed_roots(section, start)
    rows, columns = linear_sum_assignment(np.abs(np.array(list(theirs.values()))[:, None] - ours))
    pairs = dict(zip(np.array(list(theirs))[rows], ours[columns], strict=True))
    parts = {id_: _name_and_kind(id_) for id_ in printed(section)}
    return {i: float(KINDS[kind](pairs[name])) for i, (name, kind) in parts.items() if name in pairs}


def listed(values: Iterable[complex], digits: int = 3) -> str:
    """Return roots as text, one of each pair: ``-1.543, -0.012 ± 1.150j``.

    Parameters
    ----------
    values : iterable of complex
        Roots (1/s).
    digits : int
        Digits after the point.

    Returns
    -------
    str
    """
    upper = sorted((complex(v) for v in values if np.imag(v) >= 0), key=lambda v: (v.real, v.imag))
    return ", ".join(f"{v.real:.{digits}f}" + (f" ± {v.imag:.{digits}f}j" if v.imag else "") for v in upper)


def as_printed(section: str, *starts: str) -> str:
    """Return printed roots with the report's own digits, for a picture's legend: ``−1.543, −.012 ± j1.15``.

    Parameters
    ----------
    section : str
    *starts : str
        How the ids of their rows begin.
    """
    groups: dict[str, dict[str, str]] = defaultdict(dict)
    for row in printed_rows(section):
        name, kind = _name_and_kind(row["id"])
        if row["id"].startswith(starts) and kind:
            groups[name][kind] = row["printed"].replace("-", "−")
    return ", ".join(_as_text(kinds) for kinds in groups.values())


def _as_text(kinds: dict[str, str]) -> str:
    """Return one printed root as text; of a quadratic its two numbers."""
    if "root" in kinds:
        return kinds["root"]
    if "re" in kinds:
        return f"{kinds['re']} ± j{kinds['im']}"
    if "omega" in kinds:
        return f"{kinds['omega']} rad/s and {kinds['zeta']}"
    return f"s² + {kinds['2zw']} s + {kinds['w2']}"
