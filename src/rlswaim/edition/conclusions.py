"""Section VIII: computations for and against the report's conclusions that stand in no other chapter."""

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_continuous_lyapunov

from rlswaim.edition.designs import found_gains
from rlswaim.edition.search import search
from rlswaim.edition.slow_roots import abscissas, slow_bound, slow_roots
from rlswaim.loops import closed_loops
from rlswaim.loops.certificates import slow_root_certificate
from rlswaim.loops.rigid_body_design import WANTED, rigid_body, rigid_design
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source import checks
from rlswaim.source.tables import constants, half_unit
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations, printed_coefficients


class Margin(NamedTuple):
    """Largest real part (1/s) of all poles but a slow real one, and the slow one (nan if there is none)."""

    abscissa: float
    slow: float


def margin(poles: NDArray) -> Margin:
    """Return the largest real part of all ``poles`` (1/s, shape (n,)) but a slow real one, and that one."""
    one = np.asarray(poles)[None]
    return Margin(float(abscissas(one, apart=True)[0]), float(slow_roots(one)[0]))


def closed_loop(eqs: PerturbationEquations, system: str) -> control.StateSpace:
    """Return the closed loop of a system with the gains that were found by hand.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        ``"dual_actuation"``.
    """
    return closed_loops.state_space(eqs, system, found_gains(system))


def polynomial(eqs: PerturbationEquations, system: str) -> NDArray:
    """Return the characteristic polynomial of the same loop from determinants.

    Parameters
    ----------
    eqs : PerturbationEquations
    system : str
        ``"dual_actuation"``.

    Returns
    -------
    ndarray, shape (n + 1,)
        Constant term first.
    """
    return closed_loops.polynomial(eqs, system, found_gains(system))


def interlacing(eqs: PerturbationEquations) -> tuple[float, float]:
    """Return the positive real zero of theta/delta and the positive real pole (1/s).

    If exactly one pole lies between the zero and infinity, no stable controller of the rigid-body
    angle stabilizes the vehicle (parity interlacing of Youla, Bongiorno and Lu; not in the report).
    """
    zeros, poles = roots(eqs.numerator("theta", "delta")), roots(eqs.characteristic_polynomial())
    return float(zeros.real.max()), float(poles.real.max())


def constant_term(eqs: PerturbationEquations) -> tuple[float, float]:
    """Return N of theta/delta at s = 0, and how far the last printed digits of Eq. 38 can move it."""
    here = eqs.numerator("theta", "delta")[0]
    total = 0.0
    for name, text in printed_coefficients().items():
        moved = dict(eqs.coefficients) | {name: eqs.coefficients[name] + half_unit(text)}
        total += abs(replace(eqs, coefficients=moved).numerator("theta", "delta")[0] - here)
    return float(here), float(total)


def unstable_root(booster: Booster) -> float:
    """Return the largest real part of the poles of the uncontrolled vehicle (1/s) [Eq. 41]."""
    return float(roots(perturbation_equations(booster).characteristic_polynomial()).real.max())


def stiffened(booster: Booster, factor: float) -> Booster:
    """Return the vehicle with other free-free frequencies.

    Parameters
    ----------
    booster : Booster
    factor : float
        Factor on the frequency of every mode.
    """
    return replace(booster, modes=tuple(replace(m, omega=m.omega * factor) for m in booster.modes))


def resurfaced(booster: Booster, payload: float, fins: float) -> Booster:
    """Return the vehicle with more or less lift.

    Parameters
    ----------
    booster : Booster
    payload, fins : float
        Factors on the lift of the two surfaces.
    """
    pairs = zip(booster.surfaces, (payload, fins), strict=True)
    return replace(booster, surfaces=tuple(replace(s, C_Nalpha=s.C_Nalpha * f) for s, f in pairs))


def relocated(booster: Booster, payload: float, fins: float) -> Booster:
    """Return the vehicle with its lifting surfaces at other stations.

    Parameters
    ----------
    booster : Booster
    payload, fins : float
        Stations of the two surfaces (ft).
    """
    pairs = zip(booster.surfaces, (payload, fins), strict=True)
    return replace(booster, surfaces=tuple(replace(s, station=x) for s, x in pairs))


def surfaces_moved(booster: Booster) -> Mapping[str, Booster]:
    """Return the vehicle with its lifting surfaces at the first mode's nodes [conclusion 2]."""
    front, rear = booster.modes[0].shape.roots(extrapolate=False)
    payload, fins = (surface.station for surface in booster.surfaces)
    return {
        "payload surface at the first mode's front node": relocated(booster, front, fins),
        "fins at its rear node": relocated(booster, payload, rear),
        "both surfaces at its nodes": relocated(booster, front, rear),
    }


def surfaces_cut(booster: Booster) -> Mapping[str, Booster]:
    """Return the vehicle with its lifting surfaces cut down one way at a time [recommendation 1]."""
    return {
        "payload surface halved": resurfaced(booster, 0.5, 1.0),
        "no payload surface": resurfaced(booster, 0.0, 1.0),
        "fins halved": resurfaced(booster, 1.0, 0.5),
        "no fins": resurfaced(booster, 1.0, 0.0),
        "no surface at all": resurfaced(booster, 0.0, 0.0),
    }


def cures(booster: Booster) -> Mapping[str, float]:
    """Return the unstable root (1/s) of the vehicle varied one way at a time [conclusion 2]."""
    cases = {
        "as it is": booster,
        "no air (q_D = 0)": replace(booster, flight=replace(booster.flight, q_D=0.0)),
        "no thrust": replace(booster, T=0.0),
        **surfaces_moved(booster),
        **surfaces_cut(booster),
        "fins doubled": resurfaced(booster, 1.0, 2.0),
        "both frequencies doubled": stiffened(booster, 2.0),
        "both frequencies five times": stiffened(booster, 5.0),
    }
    return {name: unstable_root(case) for name, case in cases.items()}


class Steered(NamedTuple):
    """A vehicle with rate and attitude feedback to the thrust alone; a slow real root does not count.

    ``unstable`` is its unstable root without control (1/s).  ``stations`` is the number of gyro stations,
    ``ruled_out`` the number of those at which no gains stabilize.  ``abscissa`` is the least that a search
    finds (1/s); it is nan if all stations are ruled out.
    """

    unstable: float
    stations: int
    ruled_out: int
    abscissa: float


def steered(booster: Booster, rounds: int = 400) -> Steered:
    """Return whether rate and attitude feedback can stabilize a vehicle [recommendation 1].

    Parameters
    ----------
    booster : Booster
    rounds : int
        Generations of the search.

    Returns
    -------
    Steered
    """
    eqs, stations = perturbation_equations(booster), range(0, 421, 5)
    ruled = sum(slow_root_certificate(eqs, float(x), slow=slow_bound()) > 1e-6 for x in stations)
    open_to_search = ruled < len(stations)
    best = search(eqs, "rate_attitude", "apart", rounds=rounds).abscissa if open_to_search else float("nan")
    return Steered(unstable_root(booster), len(stations), ruled, best)


class Damped(NamedTuple):
    """The response of the stiffened vehicle to gusts, its attitude loop closed and the jet damping its modes.

    ``kK_z`` is the gain of the jet's loop (lb s/ft) and ``zeta`` the damping ratio of the first mode.
    The rest are root mean squares for white noise of unit intensity in alpha_g (rad): of q_1 and
    q_2 (ft), delta (rad) and the jet (lb).
    """

    kK_z: float
    zeta: float
    q1: float
    q2: float
    delta: float
    jet: float


def damped(booster: Booster, kK_z: float, factor: float = 5.0) -> Damped:
    """Return how damping the modes changes the response to gusts of a stiffened vehicle [conclusion 6].

    Parameters
    ----------
    booster : Booster
    kK_z : float
        Gain of the jet's loop (lb s/ft); its other constants are those of `found_gains`.
    factor : float
        Factor on both frequencies.  The attitude loop is designed for the rigid body, as in Section IV.

    Returns
    -------
    Damped
    """
    stiff = stiffened(booster, factor)
    eqs = perturbation_equations(stiff)
    design = rigid_design(rigid_body(eqs), omega=abs(WANTED), zeta=0.5, K_C=10)
    chosen = found_gains("dual_actuation") | {"kK_z": kK_z, "K_A": design.K_A, "K_R": design.K_R}
    loop = closed_loops.state_space(eqs, "dual_actuation", chosen)
    gust = loop.B[:, [loop.input_labels.index("alpha_g")]]
    covariance = loop.C @ solve_continuous_lyapunov(loop.A, -gust @ gust.T) @ loop.C.T
    rms = dict(zip(loop.output_labels, np.sqrt(np.diag(covariance)), strict=True))
    pole = min(loop.poles(), key=lambda p: abs(p - 1j * stiff.modes[0].omega))
    zeta, names = float(-pole.real / abs(pole)), ("q1", "q2", "delta", "delta_r")
    return Damped(kK_z, zeta, *(float(rms[name]) for name in names))


def with_longitudinal(eqs: PerturbationEquations, alpha_0: float, gamma_0: float) -> float:
    """Return the unstable root (1/s) of the vehicle with the equation of motion along x [recommendation 4].

    Parameters
    ----------
    eqs : PerturbationEquations
    alpha_0, gamma_0 : float
        Steady angle of attack and angle of the path (rad); alpha_0 is 0 on the report's ballistic path.

    Notes
    -----
    Ours, not the report's.  Newton's law along the vehicle's axis x, which lies alpha_0 + gamma_0 + theta
    above the horizontal, for the speeds U + u along it and w = U (alpha_0 + alpha) across it::

        u' = (thrust - drag)/M - theta' w - g sin(alpha_0 + gamma_0 + theta)

    The thrust lies along x, and the drag's change is left out; the small changes that remain are
    u' = -U alpha_0 theta' - g cos(alpha_0 + gamma_0) theta.  And u changes each aerodynamic force of
    the steady alpha_0 by 2 u/U of itself, which is the column of alpha times 2 alpha_0 u/U.  The axes do
    not turn before the disturbance, as in Eq. 29; `rlswaim.practice.ladder.vehicle_on` lets the path curve.
    """
    A = np.pad(eqs.state_space().A, ((0, 1), (0, 1)))
    alpha_0 = checks.real("alpha_0", alpha_0, "with_longitudinal")
    gamma_0 = checks.real("gamma_0", gamma_0, "with_longitudinal")
    A[:7, 7] = 2 * alpha_0 / eqs.U * A[:7, 0]
    A[7, 1], A[7, 2] = -constants("vehicle")["g"] * np.cos(alpha_0 + gamma_0), -eqs.U * alpha_0
    return float(np.linalg.eigvals(A).real.max())


def full_state_feedback(eqs: PerturbationEquations) -> NDArray:
    """Return the closed-loop poles (1/s) of optimal full-state feedback to the thrust, unit weights."""
    vehicle = eqs.state_space()
    return np.asarray(control.lqr(vehicle.A, vehicle.B[:, [0]], np.eye(vehicle.nstates), np.eye(1))[2])
