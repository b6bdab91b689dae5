"""Section IV: rate and attitude feedback [Eqs. 59-96, Figures 8 to 11]."""

import control
import numpy as np

from rlswaim.edition.matching import as_written, choices, printed_roots, roots_beside
from rlswaim.loops.factors import factored, from_factors
from rlswaim.loops.gain_terms import gain_terms, gains_for_pole
from rlswaim.loops.named_branches import NamedLocus, named_locus, open_loop_parts
from rlswaim.loops.rigid_body_design import WANTED, RigidBody, rigid_body, rigid_design
from rlswaim.loops.transfer_functions import denominator, theta_loop
from rlswaim.rootlocus.locus import root_locus
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source.tables import printed
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import ROWS, PerturbationEquations, perturbation_equations, printed_equations

CLOSED_LOOPS = {"77": (60, 3), "78": (60, 4), "79": (400, 3), "80": (400, 4), "81": (304, 3), "82": (304, 4)}
"""Gyro station (ft) and order of the closed loops of Eqs. 77 to 82."""


def closed_loop_roots(
    eqs: PerturbationEquations,
    K_A: float,
    K_R: float,
    gyro: float | None,
    order: int = 4,
    K_C: float | None = None,
) -> np.ndarray:
    """Return closed-loop roots (1/s) [Eqs. 76-82].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A, K_R : float
        Amplifier (rad/rad) and rate gyro (s) gains.
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle only.
    order : int
        2 for the rigid body alone, 3 with the first mode, 4 with both.
    K_C : float, optional
        Actuator gain (1/s); without one, that of Figure 8.
    """
    K_C = printed("IV")["fig8-K_C"] if K_C is None else K_C
    return root_locus(theta_loop(eqs, K_C, K_R, gyro, order=order), [K_A]).roots[0]


def printed_rigid_loop() -> control.TransferFunction:
    """Return Eq. 96 as printed, for K_A = 1 and Figure 11's K_C and K_R."""
    p = printed("IV")
    K_C, K_R = p["fig11-K_C"], p["fig11-K_R"]
    zeros = [-1 / K_R, *printed_roots("IV", "eq92-z").values()]
    return from_factors(
        p["eq92-gain"] * K_C * K_R, zeros, [0.0, -K_C, *printed_roots("IV", "eq92-p").values()]
    )


def _data() -> dict[str, float]:
    booster = swaim_booster()
    eqs = perturbation_equations(booster)
    found = as_written(printed_equations(), "eq59-", "eq60-", "eq76-") | choices("IV")
    found |= {f"eq59-gust_{row}": -eqs.coefficients[f"{row}_alpha"] for row in ROWS}
    for station in (60, 400, 304):
        found[f"sigma-{station}-mode1"] = booster.modes[0].slope(station)
    return found | {f"sigma-{station}-mode2": booster.modes[1].slope(station) for station in (400, 304)}


def _design(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    """Follow Eqs. 61 to 76 from the printed c_0 and c_1, with the gain terms divided by U as well."""
    body = rigid_body(eqs)
    K_C = p["fig8-K_C"]
    body = RigidBody(c_0=p["eq61-c_0"], c_1=p["eq61-c_1"], g_0=body.g_0, g_1=body.g_1)
    gains = rigid_design(body, omega=2.0, zeta=0.5, K_C=K_C)
    ours = rigid_body(eqs)
    return {f"eq61-{name}": getattr(ours, name) for name in ("c_0", "c_1", "g_0", "g_1")} | {
        "sec4-omega_sp": abs(WANTED),
        "sec4-zeta_sp": -WANTED.real / abs(WANTED),
        "eq69-2zw": -2 * WANTED.real,
        "eq70-w2": abs(WANTED) ** 2,
        "eq68-constant": 2.0 - body.c_1,
        "eq69-constant": 4.0 - body.c_0,
        "eq72-sum": K_C - 2.0 + body.c_1,
        "eq73-constant": 4.0 - body.c_1 * K_C - body.c_0,
        "eq73-gain": body.g_1 * K_C,
        "eq74-constant": body.c_0 * K_C,
        "eq74-gain": body.g_0 * K_C,
        "eq75-K_A": gains.K_A,
        "eq75-K_R": gains.K_R,
        "eq75-a": gains.a,
        "eq75-b": gains.b,
        "eq76-s": 1 / (gains.K_A * K_C),
        "eq76-1": 1 / gains.K_A,
        "eq76-K_R": p["eq75-K_R"],
        "eq76-slope": -eqs.modes[0].slope(60),
        "eq76-sigma": -p["eq75-K_R"] * p["sigma-60-mode1"],
    }


def _closed_loops(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    found: dict[str, float] = {}
    for number, (gyro, order) in CLOSED_LOOPS.items():
        ours = closed_loop_roots(eqs, p["eq75-K_A"], p["eq75-K_R"], gyro, order)
        found |= roots_beside("IV", f"eq{number}-", ours)
    found |= roots_beside("IV", "fig8-", closed_loop_roots(eqs, p["eq84-K_A"], p["eq75-K_R"], 60))
    return found | roots_beside("IV", "fig11-", root_locus(printed_rigid_loop(), [p["fig11-K_A"]]).roots[0])


def _polynomial(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    short = {"1": "free", "K_C": "KC", "K_A K_C": "KAKC", "K_A K_C K_R": "KAKCKR"}
    found = {
        f"eq83-s{power}-{short[name]}": float(value)
        for name, polynomial in gain_terms(eqs, 60).items()
        for power, value in enumerate(polynomial)
    }
    found["eq84-K_A"], found["eq84-K_R"] = gains_for_pole(eqs, WANTED, p["fig8-K_C"], 60)
    return found


def _transfer_functions(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    found: dict[str, float] = {}
    for number, output in (("92", "theta"), ("93", "q1"), ("94", "q2")):
        numerator = eqs.numerator(output, "delta")
        found[f"eq{number}-gain"] = float(numerator[5])
        found |= roots_beside("IV", f"eq{number}-z", roots(numerator))
    found |= roots_beside("IV", "eq92-p", roots(denominator(eqs, p["fig8-K_C"])))
    gain, zeros, _ = factored(theta_loop(eqs, 1.0, 1.0, 60))
    found |= {"eq95-gain": gain} | roots_beside("IV", "eq95-z", zeros[np.abs(zeros + 1) > 1e-9])
    return found | {"fig8-limit": max(abs(zeros))}


def real_meetings(loop: control.TransferFunction, sign: int, side: int) -> list[float]:
    """Return the gains at which two roots meet on the real axis, smallest first.

    Parameters
    ----------
    loop : control.TransferFunction
        Open loop.
    sign : int
        1 for positive gains, -1 for negative ones.
    side : int
        1 for meetings right of the origin, -1 for those left of it.
    """
    found = [at.gain for at in root_locus(loop).break_aways if at.point.imag == 0 < at.point.real * side]
    return sorted((gain for gain in found if gain * sign > 0), key=abs)


def oscillates(eqs: PerturbationEquations, number: int, gain: float, side: int) -> bool:
    """Return whether branches of the short period or the actuator are a pair in Figure 9 or 10.

    Parameters
    ----------
    eqs : PerturbationEquations
    number : int
        Of the figure, whose K_C and K_R are taken.
    gain : float
        K_A (rad/rad).
    side : int
        1 for a pair right of the imaginary axis, -1 for one left of it.
    """
    ends = _figure(eqs, number, gain).ends
    return any(root.imag > 0 < root.real * side for name in ("rigid", "actuator") for root in ends[name])


def _figure(eqs: PerturbationEquations, number: int, gain: float) -> NamedLocus:
    """Return the locus of Figures 8 to 11 with its branches by their open-loop poles."""
    p = printed("IV", f"fig{number}-")
    gyro = None if number == 11 else 60
    loop = theta_loop(eqs, p["K_C"], p["K_R"], gyro)
    return named_locus(loop, gain, open_loop_parts(eqs, p["K_C"]))


def _said_of_figures(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    """Return what the text says of Figures 8 to 11: 1 for yes, 0 for no, or how many."""
    short = _figure(eqs, 8, 1.0)
    way = short.locus.roots[:, short.parts["rigid"]]
    ends = np.sort(way.real, axis=1)
    apart = (way.imag == 0).all() and (ends[:, 0] < -0.1).all() and (ends[:, -1] > 0.1).all()
    pairs = {}
    for number, name, sign, side in ((9, "oscillation", -1, 1), (10, "pseudo", 1, -1)):
        loop = theta_loop(eqs, p[f"fig{number}-K_C"], p[f"fig{number}-K_R"], 60)
        meet = real_meetings(loop, sign, side)
        inside = sign * np.sqrt(meet[0] * meet[1])
        pairs[f"fig{number}-{name}"] = float(oscillates(eqs, number, inside, side))
    ten, eleven = _figure(eqs, 10, 1e3).ends, _figure(eqs, 11, p["fig11-K_A"]).ends
    starts, modes = open_loop_parts(eqs, p["fig11-K_C"]), ("mode 1", "mode 2")
    unstable = {f"fig10-mode{i}-unstable": float(ten[m].real.max() > 0) for i, m in enumerate(modes, start=1)}
    stiffened = sum(bool(abs(eleven[m][0]) > abs(starts[m][0])) for m in modes)
    return pairs | unstable | {"fig8-short": float(apart), "fig11-stiffened": float(stiffened)}


def computed() -> dict[str, float]:
    """Return our number for each row of section IV of ``data/printed.csv``, by its id.

    The closed loops of Eqs. 77 to 82 are those of the printed gains; the design itself (Eqs. 61
    to 76) is followed with the division by U that the report leaves out.
    """
    eqs, p = printed_equations(), printed("IV")
    found = _data() | _closed_loops(eqs, p) | _polynomial(eqs, p) | _transfer_functions(eqs, p)
    return found | _design(eqs, p) | _said_of_figures(eqs, p)
