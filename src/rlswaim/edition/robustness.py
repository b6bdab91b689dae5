"""How robust a closed loop of Section VII is: against other mode shapes, other loop gains and delay."""

from collections.abc import Mapping
from dataclasses import replace
from itertools import product
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.slow_roots import abscissas, slow_roots
from rlswaim.loops.closed_loops import state_space
from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.source import checks
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations

ACTUATORS = {"thrust": 7, "jet": 8}
"""Row of each actuator in the state matrix of `dual_actuation`; the loop is opened in front of it."""
FACTORS = np.geomspace(1e-3, 1e3, 6001)
"""Factors on the loop gain that are tried, a quarter of a percent apart."""


class Margins(NamedTuple):
    """Limits of one actuator's loop: the factors on its gain, and the delay (s), that make it unstable."""

    lower: float
    upper: float
    delay: float


def _matrix(eqs: PerturbationEquations, gains: Mapping[str, float]) -> NDArray:
    return state_space(eqs, "dual_actuation", gains).A


def stable_matrix(eqs: PerturbationEquations, gains: Mapping[str, float], where: str) -> NDArray:
    """Return the state matrix of a stable loop, shape (9, 9).

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.
    where : str
        What asks for it, for the error.

    Raises
    ------
    ValueError
        If the loop is not stable.
    """
    A = _matrix(eqs, gains)
    if (worst := np.linalg.eigvals(A).real.max()) >= 0:
        raise ValueError(f"gains in {where}: got a loop with a root at {worst:.3g} 1/s, wanted a stable one")
    return A


def misread(eqs: PerturbationEquations, gains: Mapping[str, float], by: float = 0.05) -> NDArray:
    """Return the poles with phi_1 and phi_2 read wrongly at the sensor and at the jet, each up or down.

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.
    by : float
        Relative error of each of the four readings.

    Returns
    -------
    ndarray of complex, shape (16, 9)
        All combinations of signs (1/s).
    """
    loops = DUAL_ACTUATION.around(eqs)
    read = loops.factors(**gains)
    stations = DUAL_ACTUATION.stations.values()
    phi = [name for entering in stations for name, (kind, _) in entering.items() if kind == "deflection"]
    wrong = [
        read | {name: read[name] * (1 + by * sign) for name, sign in zip(phi, signs, strict=True)}
        for signs in product((-1, 1), repeat=len(phi))
    ]
    return np.linalg.eigvals(np.array([loops.family.matrices(factors) for factors in wrong]))


def reshaped(booster: Booster, gains: Mapping[str, float], by: float = 0.05) -> NDArray:
    """Return the poles with whole mode shapes scaled, in all coefficients too; shape (4, 9).

    Parameters
    ----------
    booster : Booster
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.
    by : float
        Relative error of each mode's deflections and slopes.
    """
    matrices = []
    for signs in product((-1, 1), repeat=2):
        pairs = zip(booster.modes, 1 + by * np.array(signs), strict=True)
        first, second = (replace(m, deflections=m.deflections * f, slopes=m.slopes * f) for m, f in pairs)
        matrices.append(_matrix(perturbation_equations(replace(booster, modes=(first, second))), gains))
    return np.linalg.eigvals(np.array(matrices))


def margins(eqs: PerturbationEquations, gains: Mapping[str, float], actuator: str) -> Margins:
    """Return the margins of a stable loop, opened in front of one actuator, the other loop closed.

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.
    actuator : str
        ``"thrust"`` or ``"jet"``.

    Returns
    -------
    Margins

    Raises
    ------
    ValueError
        If the loop is not stable as it is, or the actuator is unknown.
    """
    at = ACTUATORS[checks.one_of("actuator", actuator, tuple(ACTUATORS), "margins")]
    A = stable_matrix(eqs, gains, "margins")
    scaled = np.repeat(A[None], FACTORS.size, axis=0)
    scaled[:, at, :7] *= FACTORS[:, None]
    fails = FACTORS[np.linalg.eigvals(scaled).real.max(axis=1) >= 0]
    lower, upper = fails[fails < 1].max(initial=0.0), fails[fails > 1].min(initial=np.inf)
    return Margins(float(lower), float(upper), _delay(A, at))


def _delay(A: NDArray, at: int) -> float:
    """Return the least delay (s) in front of the actuator in row ``at`` that brings a root to the axis."""
    row, opened, push = -A[at, :7] / -A[at, at], A.copy(), np.zeros((len(A), 1))
    opened[at, :7], push[at] = 0.0, -A[at, at]
    loop = control.ss(opened, push, np.r_[row, np.zeros(len(A) - 7)][None], 0)
    _, phase, _, _, crossings, _ = control.stability_margins(loop, returnall=True)
    return float((np.radians(phase) % (2 * np.pi) / crossings).min(initial=np.inf))


def borne(eqs: PerturbationEquations, booster: Booster, gains: Mapping[str, float]) -> dict[str, str]:
    """Return the robustness of one loop as texts by row: largest real parts (1/s), then margins.

    Parameters
    ----------
    eqs : PerturbationEquations
        With the printed coefficients.
    booster : Booster
        The vehicle whose data give the other coefficients and the scaled mode shapes.
    gains : mapping of str to float
        The arguments of `rlswaim.dual_actuation`.
    """
    cases = {
        "printed coefficients": np.linalg.eigvals(_matrix(eqs, gains))[None],
        "coefficients from Section II": np.linalg.eigvals(_matrix(perturbation_equations(booster), gains))[
            None
        ],
        "worst of 16: φ read 5 % wrong at sensor and jet": misread(eqs, gains),
        "worst of 4: whole shapes 5 % wrong": reshaped(booster, gains),
    }
    rows = {
        f"{name} (1/s)": f"{abscissas(p, True).max():.3f}, slow root {_slow(p)}" for name, p in cases.items()
    }
    for name in ACTUATORS:
        limits = margins(eqs, gains, name)
        less = f"down to {limits.lower:.2f}" if limits.lower else "any less"
        more = f"up to {limits.upper:.2f}" if np.isfinite(limits.upper) else "any more"
        rows[f"factor on the gain of the {name} loop"] = f"{less}, {more}"
        rows[f"delay in the {name} loop (s)"] = f"{limits.delay:.2g}"
    return rows


def _slow(poles: NDArray) -> str:
    """Return the rightmost of the slow roots of some loops as text."""
    slow = slow_roots(poles)
    return "none" if np.isnan(slow).all() else f"{np.nanmax(slow):+.2g}"
