"""Perturbation equations of motion: short period and any number of bending modes [Eq. 29].

In the Laplace variable s, with alpha, theta in rad and q_1, q_2, ... in ft::

    [U s + Z_alpha  (Z_thetadot - U) s   Z_q1dot s + Z_q1   ...] [alpha]   [-Z_delta ]
    [M_alpha        s^2 + M_thetadot s   M_q1dot s + M_q1   ...] [theta] = [-M_delta ] delta + ...
    [F1_alpha       F1_thetadot s        s^2 + F1_q1dot s ...  ] [q_1  ]   [-F1_delta]
    [...            ...                  ...                   ] [...  ]   [...      ]

Eq. 29 leaves out a term of Eq. 1: the weight across the path, g sin(gamma_0) theta in the first row.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.rootlocus.polynomials import determinant
from rlswaim.source import checks
from rlswaim.source.quantity import quantity
from rlswaim.source.tables import half_unit, printed, printed_rows
from rlswaim.vehicle import eq_29
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.stations import as_station

INPUTS = ("delta", "delta_r", "alpha_g")
JET_STATION = printed("VII", "fig25-")["jet"]
"""Station of the reaction jet (ft) in the report's final design [Figure 25]."""


ROWS, OUTPUTS, STATES = eq_29.row_names(2), eq_29.output_names(2), eq_29.state_names(2)
COEFFICIENTS = eq_29.coefficient_names(2)
"""The names for the report's two modes; those of other vehicles come from the functions."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PerturbationEquations:
    """The linearized equations of motion of one vehicle in one flight condition [Eqs. 1, 29, 125].

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
        "1/M, 1/I_y, 1/calM_1, 1/calM_2",
        "1/slug, 1/(slug ft^2)",
        "response to a force and a moment of the reaction jet",
        "Eq. 125",
    )
    l_CG: float = quantity("l_CG", "ft", "station of the center of gravity", "Section II")
    modes: tuple[BendingMode, ...]
    source: str
    gravity: float = quantity(
        "Z_theta",
        "ft/s^2/rad",
        "weight across the path, g sin gamma_0; 0 where it is left out, as in Eq. 29",
        "Eq. 1",
        default=0.0,
    )

    def __post_init__(self) -> None:
        """Check and freeze the data."""
        where = f"PerturbationEquations from {self.source}"
        for what, names in (("coefficients", eq_29.coefficient_names(len(self.modes))), ("jet", self.rows)):
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
        object.__setattr__(self, "gravity", checks.real("gravity", self.gravity, where))

    @cached_property
    def rows(self) -> tuple[str, ...]:
        """Names of the equations: Z, M, F1 and so on."""
        return eq_29.row_names(len(self.modes))

    @cached_property
    def outputs(self) -> tuple[str, ...]:
        """Names of the unknowns, the columns of `matrix`: alpha, theta, q1 and so on."""
        return eq_29.output_names(len(self.modes))

    @cached_property
    def states(self) -> tuple[str, ...]:
        """Names of the states: alpha, theta, thetadot, q1, q1dot and so on."""
        return eq_29.state_names(len(self.modes))

    @cached_property
    def matrix(self) -> NDArray:
        """The square matrix of Eq. 29: shape (n, n, 3), powers of s ascending, columns as `outputs`."""
        size = len(self.rows)
        matrix = np.zeros((size, size, 3))
        for i, j, power, weight, name in eq_29.equation_terms(len(self.modes), self.U, self.gravity):
            matrix[i, j, power] += weight * self.coefficients[name] if name else weight
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
        ndarray, shape (n,)
        """
        checks.one_of("input", signal, INPUTS, "forcing")
        if signal == "delta_r":
            station = as_station("jet", jet, "forcing")
            return eq_29.lever_matrix(self.modes, self.l_CG, station) * [self.jet[row] for row in self.rows]
        column = "alpha" if signal == "alpha_g" else signal
        return np.array([-self.coefficients[f"{row}_{column}"] for row in self.rows])

    def state_space(self, jet: float = JET_STATION) -> control.StateSpace:
        """Return the vehicle as a state space: seven states with two modes.

        Parameters
        ----------
        jet : float
            Station of the reaction jet (ft).

        Returns
        -------
        control.StateSpace
            Inputs delta (rad), delta_r (lb of jet force), alpha_g (rad); the outputs are the
            states alpha, theta, thetadot, q1, q1dot and so on (rad, ft, s).
        """
        count, size = len(self.states), len(self.rows)
        scale = np.array([self.U, *np.ones(size - 1)])[:, None]
        inputs = np.column_stack([self.forcing(signal, jet) for signal in INPUTS])
        moved = np.column_stack([self.matrix[:, 0, 0], self.matrix[:, 1:, :2].reshape(size, -1)])
        A, B = np.zeros((count, count)), np.zeros((count, len(INPUTS)))
        A[::2] -= moved / scale
        B[::2] = inputs / scale
        A[1::2, 2::2] = np.eye(size - 1)
        return control.ss(
            A,
            B,
            np.eye(count),
            np.zeros_like(B),
            name="vehicle",
            inputs=list(INPUTS),
            outputs=list(self.states),
            states=[f"x_{s}" for s in self.states],
        )

    def characteristic_polynomial(self, order: int | None = None) -> NDArray:
        """Return the determinant of the first ``order`` rows and columns over U, constant term first.

        Order 2 is the rigid body alone [Eq. 39], 3 adds the first mode [Eq. 40], 4 the second [Eq. 41];
        without one, all modes are in.
        """
        n = len(self.rows) if order is None else order
        return determinant(self.matrix[:n, :n])[: 2 * n] / self.U

    def numerator(
        self, output: str, signal: str, jet: float = JET_STATION, order: int | None = None
    ) -> NDArray:
        """Return the numerator of output/input over U by Cramer's rule, constant term first.

        Parameters
        ----------
        output : str
            One of alpha, theta, q1, q2 and so on.
        signal : str
            One of delta, delta_r, alpha_g.
        jet : float
            Station of the reaction jet (ft).
        order : int, optional
            2 for the rigid body alone, 3 with the first mode, and so on; all modes without it.

        Returns
        -------
        ndarray, shape (2 order,)
            It belongs to the denominator `characteristic_polynomial` of the same order
            [Eqs. 60, 76, 92-94, 131, 132].
        """
        n = len(self.rows) if order is None else order
        j = self.outputs.index(checks.one_of("output", output, self.outputs[:n], "numerator"))
        replaced = self.matrix[:n, :n].copy()
        replaced[:, j] = 0.0
        replaced[:, j, 0] = self.forcing(signal, jet)[:n]
        return determinant(replaced)[: 2 * n] / self.U


def perturbation_equations(booster: Booster, gravity: bool = False) -> PerturbationEquations:
    """Return Eq. 29 with every coefficient computed from the vehicle's data.

    Parameters
    ----------
    booster : Booster
    gravity : bool
        Keep Eq. 1's weight across the path, M g theta sin gamma_0, which Eq. 29 leaves out.

    Returns
    -------
    PerturbationEquations
        Coefficients by their formulas at the end of Section I.

    Raises
    ------
    ValueError
        If gravity is wanted and the flight's gamma_0 is not known.
    """
    checks.instance("booster", booster, Booster, "perturbation_equations")
    return PerturbationEquations(
        coefficients=eq_29.coefficients(booster),
        U=booster.flight.U,
        jet=dict(
            zip(eq_29.row_names(len(booster.modes)), (1 / eq_29.inertias(booster)).tolist(), strict=True)
        ),
        l_CG=booster.l_CG,
        modes=booster.modes,
        source=booster.name,
        gravity=booster.flight.weight_across if gravity else 0.0,
    )


def printed_coefficients() -> dict[str, str]:
    """Return the coefficients of Eq. 29 as the report prints them, each with the most figures that it has."""
    ids = {f"eq{number}-{name}": name for number in (38, 59) for name in COEFFICIENTS}
    rows = [row for section in ("III", "IV") for row in printed_rows(section) if row["id"] in ids]
    rows.sort(key=lambda row: half_unit(row["printed"]), reverse=True)
    found = {ids[row["id"]]: row["printed"] for row in rows}
    return {name: found[name] for name in COEFFICIENTS}


def printed_equations(gravity: bool = False) -> PerturbationEquations:
    """Return the equations with the numbers that the report prints [Eq. 38, or Eq. 59 where 38 is lost].

    Parameters
    ----------
    gravity : bool
        Keep Eq. 1's weight across the path, M g theta sin gamma_0, which Eq. 29 leaves out.

    Returns
    -------
    PerturbationEquations
        The rounded coefficients, the jet's as in Eq. 125; the mode shapes are those of `swaim_booster`.
    """
    booster = swaim_booster()
    numbers = {name: float(text) for name, text in printed_coefficients().items()}
    numbers["Z_thetadot"] += booster.flight.U  # Eq. 38 prints Z_thetadot - U
    return PerturbationEquations(
        coefficients=numbers,
        U=booster.flight.U,
        jet={row: abs(value) for row, value in printed("VII", "eq125-").items()},
        l_CG=booster.l_CG,
        modes=booster.modes,
        source="the report's Eq. 38",
        gravity=booster.flight.weight_across if gravity else 0.0,
    )


def with_reading(eqs: PerturbationEquations, station: float, phi: Sequence[float]) -> PerturbationEquations:
    """Return the equations with all modes bent to pass through given deflections at one more station.

    Parameters
    ----------
    eqs : PerturbationEquations
    station : float
        In ft.
    phi : sequence of float
        Deflection of each mode there.

    Returns
    -------
    PerturbationEquations
    """
    pairs = zip(eqs.modes, phi, strict=True)
    return replace(eqs, modes=tuple(mode.through(station, value) for mode, value in pairs))
