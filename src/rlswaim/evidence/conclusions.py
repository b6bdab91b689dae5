"""Section VIII: computations for and against the report's conclusions that stand in no other chapter."""

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from typing import NamedTuple

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray
from scipy.optimize import differential_evolution, linprog

from rlswaim import systems
from rlswaim.dual import JetLoop, closed_1, theta_numerator
from rlswaim.gains import gain_terms
from rlswaim.loops import denominator
from rlswaim.perturbation import PerturbationEquations, perturbation_equations
from rlswaim.polynomials import roots
from rlswaim.tables import read_table
from rlswaim.vehicle import Booster

SLOW = 0.02
"""Below this size (1/s) a real root is set apart as slow: its time constant is over 50 s."""
BOUNDS = ((-1, 2), (-20, 20), (-5, 5), (-6, 6), (0, 420))
"""Of the search: log10 K_C, K_A, K_R (s), arcsinh K_z, station of the sensor (ft)."""


class Margin(NamedTuple):
    """Largest real part (1/s) of all poles but a slow real one, and that slow one (nan without)."""

    abscissa: float
    slow: float


def margin(poles: NDArray) -> Margin:
    """Return how stable a closed loop is, a slow real root set apart; poles in 1/s, shape (n,)."""
    at = int(np.argmin(np.abs(poles)))
    if abs(poles[at].imag) > 0 or abs(poles[at]) > SLOW:
        return Margin(float(poles.real.max()), float("nan"))
    return Margin(float(np.delete(poles, at).real.max()), float(poles[at].real))


def found_gains(system: str) -> dict[str, float]:
    """Return the found gains and stations of a ``system``, ``dual_actuation`` or ``single_sensor``."""
    return {r["parameter"]: float(r["value"]) for r in read_table("gains_found") if r["system"] == system}


def closed_loop(eqs: PerturbationEquations, system: str) -> control.StateSpace:
    """Return the closed loop of a ``system`` with the found gains, as state space."""
    return getattr(systems, system)(eqs, **found_gains(system))


def polynomial(eqs: PerturbationEquations, system: str) -> NDArray:
    """Return the characteristic polynomial of the same ``system`` from determinants, constant term first."""
    g = found_gains(system)
    if system == "single_sensor":
        top = eqs.numerator("theta", "delta")
        return npp.polyadd(
            denominator(eqs, g["K_C"], [(g["K_z"], g["sensor"])]),
            g["K_C"] * g["K_A"] * npp.polymul([1.0, g["K_R"]], top),
        )
    loop = JetLoop(g["K_r"], g["b"], g["sensor"], g["jet"])
    bottom = npp.polymul([g["K_C"], 1.0], closed_1(eqs, loop, g["kK_z"]))
    top = npp.polymul([1.0, g["K_R"]], theta_numerator(eqs, loop, g["kK_z"]))
    return npp.polyadd(bottom, g["K_C"] * g["K_A"] * top)


def search_single_sensor(eqs: PerturbationEquations, seed: int = 1964, rounds: int = 200) -> dict[str, float]:
    """Return gains and station of Section V's loop with the least abscissa found within `BOUNDS`.

    Parameters
    ----------
    eqs : PerturbationEquations
    seed : int
        Of the differential evolution.
    rounds : int
        Its generations, of 100 loops each.

    Returns
    -------
    dict
        K_C, K_A, K_R, K_z, sensor, and the abscissa (1/s) of all roots but a slow real one.
    """
    fixed = gain_terms(eqs, None, ())
    base, at_K_C, at_x, at_y = fixed.values()
    stations = np.arange(421.0)
    sensing = np.array([list(gain_terms(eqs, None, [x]).values())[-1] for x in stations])

    def chosen(x: NDArray) -> dict[str, float]:
        gains = {"K_C": 10 ** x[0], "K_A": x[1], "K_R": x[2], "K_z": np.sinh(x[3])}
        return {name: float(v) for name, v in gains.items()} | {"sensor": float(round(x[4]))}

    def abscissa(x: NDArray) -> float:
        g = chosen(x)
        moved = at_K_C + g["K_A"] * (at_x + g["K_R"] * at_y) + g["K_z"] * sensing[int(g["sensor"])]
        return margin(roots(base + g["K_C"] * moved)).abscissa

    best = differential_evolution(
        abscissa, BOUNDS, seed=seed, popsize=20, maxiter=rounds, tol=0, polish=False
    )
    return chosen(best.x) | {"abscissa": float(best.fun)}


def sign_margin(eqs: PerturbationEquations, gyro: float | None) -> float:
    """Return the largest t for which some gains make all coefficients but the constant at least t (scaled).

    With K_C at least 0; at most 0 means that no gains stabilize Section IV's loop, a slow root set apart.
    """
    terms = np.array(list(gain_terms(eqs, gyro).values()))[:, 1:]
    rows = (terms / np.abs(terms).max(axis=0)).T
    limits = [(0, 1), (0, 1), (-1, 1), (-1, 1), (None, 1)]
    sought = linprog(
        [0, 0, 0, 0, -1], np.column_stack([-rows, np.ones(len(rows))]), np.zeros(len(rows)), bounds=limits
    )
    return float(sought.x[-1])


def interlacing(eqs: PerturbationEquations) -> tuple[float, float]:
    """Return the positive real zero of theta/delta and the positive real pole (1/s).

    A pole between the zero and infinity, one in number, rules out every stable controller of
    the rigid-body angle (the parity interlacing of Youla, Bongiorno and Lu; not in the report).
    """
    zeros, poles = roots(eqs.numerator("theta", "delta")), roots(eqs.characteristic_polynomial())
    return float(zeros.real.max()), float(poles.real.max())


def constant_term(eqs: PerturbationEquations) -> tuple[float, float]:
    """Return N of theta/delta at s = 0, and how far the last printed digits of Eq. 38 can move it."""
    here = eqs.numerator("theta", "delta")[0]
    total = 0.0
    for row in read_table("equations_as_printed"):
        name, half = row["symbol"], 0.5 * 10.0 ** int(Decimal(row["value"]).as_tuple().exponent)
        if name in eqs.coefficients:
            moved = dict(eqs.coefficients) | {name: eqs.coefficients[name] + half}
            total += abs(replace(eqs, coefficients=moved).numerator("theta", "delta")[0] - here)
    return float(here), float(total)


def unstable_root(booster: Booster) -> float:
    """Return the largest real part of the poles of the uncontrolled vehicle (1/s) [Eq. 41]."""
    return float(roots(perturbation_equations(booster).characteristic_polynomial()).real.max())


def cures(booster: Booster) -> Mapping[str, float]:
    """Return the unstable root (1/s) of the vehicle varied one way at a time [conclusion 2]."""
    payload, fins = booster.surfaces

    def scaled(of_payload: float, of_fins: float) -> Booster:
        pair = ((payload, of_payload), (fins, of_fins))
        return replace(booster, surfaces=tuple(replace(s, C_Nalpha=s.C_Nalpha * f) for s, f in pair))

    def stiffer(factor: float) -> Booster:
        return replace(booster, modes=tuple(replace(m, omega=m.omega * factor) for m in booster.modes))

    cases = {
        "as it is": booster,
        "no air (q_D = 0)": replace(booster, flight=replace(booster.flight, q_D=0.0)),
        "no thrust": replace(booster, T=0.0),
        "payload surface halved": scaled(0.5, 1.0),
        "no payload surface": scaled(0.0, 1.0),
        "fins halved": scaled(1.0, 0.5),
        "fins doubled": scaled(1.0, 2.0),
        "no fins": scaled(1.0, 0.0),
        "both frequencies doubled": stiffer(2.0),
        "both frequencies five times": stiffer(5.0),
    }
    return {name: unstable_root(case) for name, case in cases.items()}


def full_state_feedback(eqs: PerturbationEquations) -> NDArray:
    """Return the closed-loop poles (1/s) of optimal full-state feedback to the thrust, unit weights."""
    vehicle = eqs.state_space()
    return np.asarray(control.lqr(vehicle.A, vehicle.B[:, [0]], np.eye(vehicle.nstates), np.eye(1))[2])
