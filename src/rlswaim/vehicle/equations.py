"""Perturbation equations of motion: short period and two bending modes [Eq. 29].

In the Laplace variable s, with alpha, theta in rad and q_1, q_2 in ft::

    [U s + Z_alpha  (Z_thetadot - U) s   Z_q1dot s + Z_q1   ...] [alpha]   [-Z_delta ]
    [M_alpha        s^2 + M_thetadot s   M_q1dot s + M_q1   ...] [theta] = [-M_delta ] delta + ...
    [F1_alpha       F1_thetadot s        s^2 + F1_q1dot s ...  ] [q_1  ]   [-F1_delta]
    [F2_alpha       F2_thetadot s        ...                   ] [q_2  ]   [-F2_delta]
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.polynomials import determinant, roots
from rlswaim.source import checks
from rlswaim.source.quantity import quantity
from rlswaim.source.tables import constants
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.stations import as_station

ROWS = ("Z", "M", "F1", "F2")
COLUMNS = ("alpha", "thetadot", "q1dot", "q1", "q2dot", "q2", "delta")
COEFFICIENTS = tuple(f"{row}_{column}" for row in ROWS for column in COLUMNS)
STATES = ("alpha", "theta", "thetadot", "q1", "q1dot", "q2", "q2dot")
OUTPUTS = ("alpha", "theta", "q1", "q2")
INPUTS = ("delta", "delta_r", "alpha_g")
JET_STATION = 140.0
"""Station of the reaction jet (ft) in the report's final design [Figure 25]."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PerturbationEquations:
    """The linearized equations of motion of one vehicle in one flight condition [Eqs. 29, 125].

    Raises
    ------
    ValueError
        If a coefficient is missing, unknown or not finite, or U is not positive.
    TypeError
        If a coefficient is not a real number.
    """

    coefficients: Mapping[str, float] = quantity("Z, M, F_1, F_2", "see chapter I", "coefficients", "Eq. 29")
    U: float = quantity("U", "ft/s", "undisturbed speed", "Section II")
    jet: Mapping[str, float] = quantity(
        "1/M, 1/I_y, 1/m_1, 1/m_2",
        "1/slug, 1/(slug ft^2)",
        "response to a force and a moment of the reaction jet",
        "Eq. 125",
    )
    l_CG: float = quantity("l_CG", "ft", "station of the center of gravity", "Section II")
    modes: tuple[BendingMode, ...]
    source: str

    def __post_init__(self) -> None:
        """Check and freeze the data."""
        where = f"PerturbationEquations from {self.source}"
        for what, names in (("coefficients", COEFFICIENTS), ("jet", ROWS)):
            given = dict(getattr(self, what))
            wrong = sorted(set(given) ^ set(names))
            if wrong:
                raise ValueError(
                    f"{what} in {where}: got a missing or unknown name {wrong[0]!r}, "
                    f"wanted {', '.join(names)}"
                )
            frozen = {name: checks.real(name, given[name], where) for name in names}
            object.__setattr__(self, what, MappingProxyType(frozen))
        object.__setattr__(self, "U", checks.positive("U", self.U, where))
        object.__setattr__(self, "l_CG", as_station("l_CG", self.l_CG, where))

    @cached_property
    def matrix(self) -> NDArray:
        """The square matrix of Eq. 29: shape (4, 4, 3), powers of s ascending, columns as OUTPUTS."""
        c = self.coefficients
        matrix = np.zeros((4, 4, 3))
        for i, row in enumerate(ROWS):
            matrix[i, 0, 0] = c[f"{row}_alpha"]
            matrix[i, 1, 1] = c[f"{row}_thetadot"]
            matrix[i, 2, :2] = c[f"{row}_q1"], c[f"{row}_q1dot"]
            matrix[i, 3, :2] = c[f"{row}_q2"], c[f"{row}_q2dot"]
        matrix[0, 0, 1] += self.U
        matrix[0, 1, 1] -= self.U
        matrix[[1, 2, 3], [1, 2, 3], 2] += 1.0
        return matrix

    def forcing(self, signal: str, jet: float = JET_STATION) -> NDArray:
        """Return the right-hand column of one input [Eqs. 29, 125].

        Parameters
        ----------
        signal : str
            ``"delta"`` (rad), ``"delta_r"`` (force of the jet, lb: the report's k delta_r)
            or ``"alpha_g"`` (rad).
        jet : float
            Station of the reaction jet (ft), used for ``"delta_r"`` alone.

        Returns
        -------
        ndarray, shape (4,)
        """
        checks.one_of("input", signal, INPUTS, "forcing")
        if signal == "delta_r":
            station = as_station("jet", jet, "forcing")
            phi = [mode.deflection(station) for mode in self.modes]
            arms = np.array([1.0, station - self.l_CG, -phi[0], -phi[1]])
            return arms * [self.jet[row] for row in ROWS]
        column = "alpha" if signal == "alpha_g" else signal
        return np.array([-self.coefficients[f"{row}_{column}"] for row in ROWS])

    def state_space(self, jet: float = JET_STATION) -> control.StateSpace:
        """Return the vehicle as a state space with seven states.

        Parameters
        ----------
        jet : float
            Station of the reaction jet (ft).

        Returns
        -------
        control.StateSpace
            Inputs delta (rad), delta_r (lb of jet force), alpha_g (rad); the outputs are the
            states alpha, theta, thetadot, q1, q1dot, q2, q2dot (rad, ft, s).
        """
        c = self.coefficients
        columns = ("alpha", None, "thetadot", "q1", "q1dot", "q2", "q2dot")
        rows = np.array([[-c[f"{row}_{name}"] if name else 0.0 for name in columns] for row in ROWS])
        rows[0, 2] += self.U
        inputs = np.column_stack([self.forcing(signal, jet) for signal in INPUTS])
        scale = np.array([[1 / self.U], [1.0], [1.0], [1.0]])
        A, B = np.zeros((7, 7)), np.zeros((7, 3))
        A[[0, 2, 4, 6]], B[[0, 2, 4, 6]] = rows * scale, inputs * scale
        A[[1, 3, 5], [2, 4, 6]] = 1.0
        return control.ss(
            A,
            B,
            np.eye(7),
            np.zeros((7, 3)),
            name="vehicle",
            inputs=list(INPUTS),
            outputs=list(STATES),
            states=[f"x_{s}" for s in STATES],
        )

    def characteristic_polynomial(self, order: int = 4) -> NDArray:
        """Return the leading ``order`` by ``order`` determinant over U, constant term first.

        Order 2 is the rigid body alone [Eq. 39], 3 adds the first mode [Eq. 40], 4 both [Eq. 41].
        """
        return determinant(self.matrix[:order, :order])[: 2 * order] / self.U

    def numerator(self, output: str, signal: str, jet: float = JET_STATION, order: int = 4) -> NDArray:
        """Return the numerator of output/input over U by Cramer's rule, constant term first.

        Parameters
        ----------
        output : str
            One of alpha, theta, q1, q2.
        signal : str
            One of delta, delta_r, alpha_g.
        jet : float
            Station of the reaction jet (ft).
        order : int
            2 for the rigid body alone, 3 with the first mode, 4 with both.

        Returns
        -------
        ndarray, shape (2 order,)
            It belongs to the denominator `characteristic_polynomial` of the same order
            [Eqs. 60, 76, 92-94, 131, 132].
        """
        j = OUTPUTS.index(checks.one_of("output", output, OUTPUTS[:order], "numerator"))
        replaced = self.matrix[:order, :order].copy()
        replaced[:, j] = 0.0
        replaced[:, j, 0] = self.forcing(signal, jet)[:order]
        return determinant(replaced)[: 2 * order] / self.U


def perturbation_equations(booster: Booster) -> PerturbationEquations:
    """Return Eq. 29 with every coefficient computed from the vehicle's data.

    Parameters
    ----------
    booster : Booster

    Returns
    -------
    PerturbationEquations
        Coefficients by their formulas at the end of Section I.
    """
    checks.instance("booster", booster, Booster, "perturbation_equations")
    U = booster.flight.U
    aero = booster.flight.q_D * booster.S
    inertia = dict(zip(ROWS, (booster.M, booster.I_y, *(mode.mass for mode in booster.modes)), strict=True))
    phi = [lambda x, m=mode: m.deflection(x) for mode in booster.modes]
    sigma = [lambda x, m=mode: m.slope(x) for mode in booster.modes]
    # How a downward force at station x enters each equation, and how each motion moves the air there.
    lever: dict[str, Callable] = {
        "Z": lambda x: 1.0,
        "M": lambda x: x - booster.l_CG,
        "F1": lambda x: -phi[0](x),
        "F2": lambda x: -phi[1](x),
    }
    incidence: dict[str, Callable] = {
        "alpha": lambda x: 1.0,
        "thetadot": lambda x: (x - booster.l_CG) / U,
        "q1dot": lambda x: -phi[0](x) / U,
        "q1": sigma[0],
        "q2dot": lambda x: -phi[1](x) / U,
        "q2": sigma[1],
    }

    def aerodynamic(row: str, column: str) -> float:
        return (
            aero
            / inertia[row]
            * sum(s.C_Nalpha * lever[row](s.station) * incidence[column](s.station) for s in booster.surfaces)
        )

    c = {f"{row}_{column}": aerodynamic(row, column) for row in ROWS for column in incidence}
    G = booster.thrust_station
    thrust = {row: booster.T / inertia[row] for row in ROWS}
    for i, mode in enumerate(booster.modes, start=1):
        for row in ROWS:
            c[f"{row}_q{i}"] += thrust[row] * lever[row](G) * mode.slope(G)
        c[f"M_q{i}"] += thrust["M"] * mode.deflection(G)
        c[f"F{i}_q{i}dot"] += 2 * mode.zeta * mode.omega
        c[f"F{i}_q{i}"] += mode.omega**2
    c |= {f"{row}_delta": -thrust[row] * lever[row](G) for row in ROWS}
    return PerturbationEquations(
        coefficients=c,
        U=U,
        jet={row: 1 / inertia[row] for row in ROWS},
        l_CG=booster.l_CG,
        modes=booster.modes,
        source=booster.name,
    )


def printed_equations() -> PerturbationEquations:
    """Return the equations with the numbers that the report prints [Eq. 38, or Eq. 59 where 38 is lost].

    Returns
    -------
    PerturbationEquations
        The rounded coefficients, the jet's as in Eq. 125; the mode shapes are those of `swaim_booster`.
    """
    data = constants("equations_as_printed")
    booster = swaim_booster()
    return PerturbationEquations(
        coefficients={name: data[name] for name in COEFFICIENTS},
        U=booster.flight.U,
        jet={row: data[f"jet_{row}"] for row in ROWS},
        l_CG=booster.l_CG,
        modes=booster.modes,
        source="the report's Eq. 38",
    )


def with_reading(
    eqs: PerturbationEquations, station: float, phi: tuple[float, float]
) -> PerturbationEquations:
    """Return the equations with both modes bent to pass through ``phi`` at one more station (ft)."""
    modes = []
    for mode, value in zip(eqs.modes, phi, strict=True):
        at = int(np.searchsorted(mode.stations, station))
        points = np.insert(mode.stations, at, station), np.insert(mode.deflections, at, value)
        modes.append(replace(mode, stations=points[0], deflections=points[1]))
    return replace(eqs, modes=(modes[0], modes[1]))


def elastic_poles(eqs: PerturbationEquations) -> list[complex]:
    """Return the pole above the real axis (1/s) of each bending mode, the first mode's first."""
    poles = roots(eqs.characteristic_polynomial())
    return sorted(poles[poles.imag > 1e-6], key=abs)
