"""Which pole is which: the open loop's poles named by their motion, and a locus's branches by their poles."""

from collections.abc import Mapping
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import linear_sum_assignment

from rlswaim.rootlocus.branches import continuous_branches
from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source import checks
from rlswaim.vehicle.equations import STATES, PerturbationEquations


def named_poles(eqs: PerturbationEquations) -> list[tuple[complex, str]]:
    """Return the vehicle's poles (1/s), each with the name of the uncoupled motion that it grows out of.

    The coupling between rigid body, mode 1 and mode 2 (the off-diagonal blocks
    of Eq. 29) is raised from nothing to its size.  The attitude is left out on
    the way: it is the integral of its rate, always a pole at the origin.
    """
    kept = [i for i, state in enumerate(STATES) if state != "theta"]
    A = eqs.state_space().A[np.ix_(kept, kept)]
    block = np.array([0, 0, 1, 1, 2, 2])
    own = block[:, None] == block
    on_the_way = [np.linalg.eigvals(np.where(own, A, share * A)) for share in np.linspace(0, 1, 401)]
    names = np.empty(6, dtype=object)
    for i, name in enumerate(("short period", "mode 1", "mode 2")):
        rows = block == i
        for pole in np.linalg.eigvals(A[np.ix_(rows, rows)]):
            names[np.abs(on_the_way[0] - pole).argmin()] = name
    poles = continuous_branches(np.array(on_the_way, dtype=complex))[-1]
    return [(0j, "attitude"), *zip(poles.tolist(), names.tolist(), strict=True)]


def open_loop_parts(eqs: PerturbationEquations, K_C: float) -> dict[str, NDArray]:
    """Return the open loop's poles (1/s) by origin: rigid body, mode 1, mode 2, actuator.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_C : float
        Actuator gain (1/s).
    """
    poles, K_C = roots(eqs.characteristic_polynomial()), checks.real("K_C", K_C, "open_loop_parts")
    size = np.sort(np.abs(poles[poles.imag > 0]))
    pair = [poles[(poles.imag != 0) & np.isclose(np.abs(poles), s)] for s in size]
    real = poles[poles.imag == 0]
    return {"rigid": real, "mode 1": pair[0], "mode 2": pair[1], "actuator": np.array([-K_C])}


def branch_parts(locus: RootLocus, starts: Mapping[str, ArrayLike]) -> dict[str, list[int]]:
    """Return which branches of a locus start at given poles.

    Parameters
    ----------
    locus : RootLocus
        Its first gain is 0.
    starts : mapping of str to array_like of complex
        Poles (1/s) by name, as many as the locus has branches.

    Returns
    -------
    dict of str to list of int
        Columns of ``locus.roots`` by name, for `figures.loci.draw_root_locus`.
    """
    names = [name for name, poles in starts.items() for _ in np.atleast_1d(poles)]
    points = np.concatenate([np.atleast_1d(poles) for poles in starts.values()])
    columns = linear_sum_assignment(np.abs(points[:, None] - locus.roots[0]))[1]
    return {name: [int(c) for c, n in zip(columns, names, strict=True) if n == name] for name in starts}


class NamedLocus(NamedTuple):
    """A locus, which of its branches is which, and where they arrive at one gain (1/s)."""

    locus: RootLocus
    parts: dict[str, list[int]]
    ends: dict[str, NDArray]

    @property
    def poles(self) -> NDArray:
        """All closed-loop poles (1/s)."""
        return np.concatenate(list(self.ends.values()))


def named_locus(loop: control.TransferFunction, gain: float, starts: Mapping[str, ArrayLike]) -> NamedLocus:
    """Return a loop's locus and what its named poles become at one gain.

    Parameters
    ----------
    loop : TransferFunction
    gain : float
        If it is negative, the locus runs over negative gains (its ``gains`` are their sizes).
    starts : mapping of str to array_like of complex
        The open-loop poles (1/s) by name: `open_loop_parts`, or the ends of a loop closed before.

    Returns
    -------
    NamedLocus
    """
    signed = loop if gain >= 0 else -loop
    locus, path = root_locus(signed), root_locus(signed, np.linspace(0, abs(gain), 401))
    ends = {name: path.roots[-1, columns] for name, columns in branch_parts(path, starts).items()}
    return NamedLocus(locus, branch_parts(locus, starts), ends)
