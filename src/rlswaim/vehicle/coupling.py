"""Section III: how the first bending mode couples into the rigid-body motion.

The 3 by 3 determinant of Eq. 42 is the product of the rigid body's determinant
and the mode's own entry, which would be all without coupling, plus the coupling
part.  Polynomials run from the constant term up.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import control
import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

from rlswaim.rootlocus.locus import RootLocus, parameter_locus
from rlswaim.rootlocus.polynomials import determinant, roots
from rlswaim.source.tables import read_table
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations


@dataclass(frozen=True, eq=False)
class Partition:
    """The two parts of the determinant, both over U, so that they can be compared; arrays of shape (6,)."""

    uncoupled: NDArray
    coupling: NDArray
    U: float

    @property
    def coupling_undivided(self) -> NDArray:
        """The coupling part without the division by U: the scale of the report's Eq. 51."""
        return self.coupling * self.U

    def frame(self) -> pd.DataFrame:
        """Return both parts and their ratio for each power of s that both have."""
        powers = [3, 2, 1]
        return pd.DataFrame(
            {
                "uncoupled, over U": self.uncoupled[powers],
                "coupling, over U": self.coupling[powers],
                "|coupling / uncoupled|": abs(self.coupling[powers] / self.uncoupled[powers]),
                "coupling, not over U": self.coupling_undivided[powers],
            },
            index=["s^3", "s^2", "s"],
        )


def partition(eqs: PerturbationEquations) -> Partition:
    """Return the uncoupled and the coupling part of Eq. 42 [Eqs. 43, 49 to 51]; ValueError without a mode."""
    if not eqs.modes:
        raise ValueError(f"modes in partition: got none in {eqs.source}, wanted a first bending mode")
    matrix = eqs.matrix[:3, :3]
    uncoupled = np.convolve(determinant(matrix[:2, :2]), matrix[2, 2])[:6] / eqs.U
    # The third row's expansion, so that no difference of the two large parts is taken.
    third = np.convolve(matrix[2, 0], determinant(matrix[:2, [1, 2]]))
    second = np.convolve(matrix[2, 1], determinant(matrix[:2, [0, 2]]))
    return Partition(uncoupled, (third - second)[:6] / eqs.U, eqs.U)


def coupling_products(eqs: PerturbationEquations) -> pd.DataFrame:
    """Return the products of Eq. 48 one by one, not over U: power of s, factors and signed value."""
    known = {
        **eqs.coefficients,
        "U": eqs.U,
        "1": 1.0,
        "Z_thetadot - U": eqs.coefficients["Z_thetadot"] - eqs.U,
    }
    rows = [
        {
            "power": int(row["power"]),
            "product": "{} ({first}) ({second}) ({third})".format("-" if row["sign"] == "-1" else "+", **row),
            "value": float(row["sign"]) * known[row["first"]] * known[row["second"]] * known[row["third"]],
        }
        for row in read_table("coupling_products")
    ]
    return pd.DataFrame(rows)


def surface_sums(booster: Booster, mode: int = 1) -> Mapping[str, float]:
    """Return the sums over the lifting surfaces that Eq. 52 is made of.

    Parameters
    ----------
    booster : Booster
    mode : int
        Number of a bending mode, from 1 up.

    Returns
    -------
    mapping
        ``phi`` (1/rad) [Eq. 53], ``phi_l`` (ft/rad) [Eq. 54], ``phi_arm`` (ft/rad), ``sigma`` (1/(ft rad)),
        ``sigma_arm`` (1/rad) and ``arm`` (ft/rad), where arm is l_CG - l.

    Raises
    ------
    ValueError
        If there is no such mode.
    """
    if mode not in range(1, len(booster.modes) + 1):
        raise ValueError(f"mode in surface_sums: got {mode}, wanted 1 to {len(booster.modes)}")
    C = np.array([surface.C_Nalpha for surface in booster.surfaces])
    x = np.array([surface.station for surface in booster.surfaces])
    phi, sigma = booster.modes[mode - 1].deflection(x), booster.modes[mode - 1].slope(x)
    arm = booster.l_CG - x
    terms = {"phi": phi, "phi_l": phi * x, "phi_arm": phi * arm, "sigma": sigma, "sigma_arm": sigma * arm}
    return MappingProxyType({name: float(C @ term) for name, term in {**terms, "arm": arm}.items()})


def literal_coupling(booster: Booster, as_printed: bool = False) -> NDArray:
    """Return Eq. 52: the coupling part's coefficients of s, s^2, s^3 (in this order), not over U.

    Parameters
    ----------
    booster : Booster
    as_printed : bool
        Leave out, as the report does, the 1/U that the s^3 term and one of the s^2 terms need.

    Returns
    -------
    ndarray, shape (3,)
        Only the terms that the report keeps.
    """
    f, U, k = surface_sums(booster), booster.flight.U, booster.flight.q_D * booster.S
    M, I_y, m = booster.M, booster.I_y, booster.modes[0].mass
    G, sigma_G = booster.thrust_station, booster.modes[0].slope(booster.thrust_station)
    bend = f["sigma_arm"] - booster.T / k * (booster.l_G * sigma_G + booster.modes[0].deflection(G))
    lift = f["sigma"] + booster.T / k * sigma_G
    speed = U + k / (M * U) * f["arm"]
    over = 1.0 if as_printed else U
    s3 = -(k**2) / m * (f["phi_arm"] ** 2 / I_y + f["phi"] ** 2 / M) / over
    s2 = (
        k**2
        / m
        * (f["phi_arm"] * bend / I_y + f["phi"] * lift / M + f["phi"] * f["phi_arm"] * speed / I_y / over)
    )
    s1 = -(k**2) / (m * I_y) * f["phi"] * bend * speed
    return np.array([s1, s2, s3])


def divergence_frequency(booster: Booster) -> float:
    """Return the frequency omega_1 (rad/s) above which rigid body and first mode no longer diverge.

    There the coefficient of s in Eq. 42, linear in omega_1 squared, changes its sign.
    """
    parts = partition(perturbation_equations(booster))
    rigid = perturbation_equations(booster).characteristic_polynomial(order=2)[1]
    excess = (parts.uncoupled[1] + parts.coupling[1]) / rigid
    return float(np.sqrt(booster.modes[0].omega ** 2 - excess))


def dynamic_pressure_locus(booster: Booster, values: ArrayLike) -> RootLocus:
    """Return the vehicle's poles over the dynamic pressure; without air nothing couples.

    Parameters
    ----------
    booster : Booster
    values : array_like
        Dynamic pressures (lb/ft^2).
    """

    def vehicle(q_D: float) -> control.StateSpace:
        varied = replace(booster, flight=replace(booster.flight, q_D=q_D))
        return perturbation_equations(varied).state_space()

    return parameter_locus(vehicle, values)


def elastic_poles(eqs: PerturbationEquations) -> list[complex]:
    """Return the pole above the real axis (1/s) of each bending mode, the first mode's first."""
    poles = roots(eqs.characteristic_polynomial())
    return sorted(poles[poles.imag > 1e-6], key=abs)


def doubling_time(pole: float) -> float:
    """Return the time (s) in which a motion with a positive real pole (1/s) doubles."""
    return float(np.log(2) / pole)


def mirrored_damping(booster: Booster, F2_q1dot: float) -> float:
    """Return the F1_q2dot (1/s) that belongs to an F2_q1dot.

    Both are one aerodynamic sum, over the generalized mass of their own equation.

    Parameters
    ----------
    booster : Booster
    F2_q1dot : float
        In 1/s.

    Returns
    -------
    float
    """
    return F2_q1dot * booster.modes[1].mass / booster.modes[0].mass


def gust_response(eqs: PerturbationEquations, times: ArrayLike, alpha_g: float, modes: int = 2) -> NDArray:
    """Return theta after a gust that sets in at once and stays.

    Parameters
    ----------
    eqs : PerturbationEquations
    times : array_like, shape (N,)
        Times (s).
    alpha_g : float
        Angle of attack that the gust adds (rad).
    modes : int
        How many of the bending modes take part.

    Returns
    -------
    ndarray, shape (N,)
        In rad.
    """
    vehicle, n = eqs.state_space(), 3 + 2 * modes
    gust = vehicle.input_labels.index("alpha_g")
    kept = control.ss(vehicle.A[:n, :n], vehicle.B[:n, [gust]], np.eye(n)[[1]], np.zeros((1, 1)))
    return control.forced_response(kept, times, np.full(np.size(times), alpha_g)).outputs
