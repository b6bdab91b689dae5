"""Eq. 29 as one matrix formula, for any number of bending modes: names, coefficients, terms.

A downward force at a station enters each equation by its lever there, and each motion moves the air
there by its incidence.  Both are shapes of the vehicle::

    equation   Z   M          F_i         motion      alpha   thetadot         q_i dot    q_i
    lever      1   l - l_CG   -phi_i      incidence   1       (l - l_CG)/U     -phi_i/U   sigma_i

The air's part of a coefficient is the sum over the surfaces of lever times q_D S C_N times incidence,
over the inertia of its equation (M, I_y, m_i).  Thrust and structure add their own parts.
"""

from collections.abc import Iterator, Sequence
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.modes import BendingMode


class Shaped(NamedTuple):
    """A sign and the name of a shape: ``one``, ``arm`` (l - l_CG, ft), ``phi_i`` or ``sigma_i`` (1/ft).

    What a rate brings (``rate``) counts over U, as an angle.
    """

    sign: float
    shape: str
    rate: bool = False


class Product(NamedTuple):
    """A number times some factors, which are known by name."""

    weight: float
    factors: tuple[str, ...]


def output_names(modes: int) -> tuple[str, ...]:
    """Return the unknowns, alpha, theta, q1 and so on, for a number of ``modes``."""
    return ("alpha", "theta", *(f"q{i + 1}" for i in range(modes)))


def state_names(modes: int) -> tuple[str, ...]:
    """Return the states: alpha, and each other unknown with its rate, for a number of ``modes``."""
    moving = (name + rate for name in output_names(modes)[1:] for rate in ("", "dot"))
    return ("alpha", *moving)


def levers(modes: int) -> dict[str, Shaped]:
    """Return how a downward force enters each equation, by its row, for a number of ``modes``."""
    own = {f"F{i + 1}": Shaped(-1.0, f"phi_{i + 1}") for i in range(modes)}
    return {"Z": Shaped(1.0, "one"), "M": Shaped(1.0, "arm"), **own}


def incidences(modes: int) -> dict[str, Shaped]:
    """Return how each motion moves the air, by its column, for a number of ``modes`` [Eq. 21]."""
    found = {"alpha": Shaped(1.0, "one"), "thetadot": Shaped(1.0, "arm", rate=True)}
    for i in range(1, modes + 1):
        found |= {f"q{i}dot": Shaped(-1.0, f"phi_{i}", rate=True), f"q{i}": Shaped(1.0, f"sigma_{i}")}
    return found


def row_names(modes: int) -> tuple[str, ...]:
    """Return the names of the equations, Z, M, F1 and so on, for a number of ``modes``."""
    return tuple(levers(modes))


def coefficient_names(modes: int) -> tuple[str, ...]:
    """Return the names of the coefficients of Eq. 29 for a number of ``modes``, row by row."""
    return tuple(f"{row}_{column}" for row in levers(modes) for column in (*incidences(modes), "delta"))


def shape_at(name: str, modes: Sequence[BendingMode], l_CG: float, stations: float | NDArray) -> Any:
    """Return a shape of the vehicle at a station, or at several.

    Parameters
    ----------
    name : str
        As in `Shaped`.
    modes : sequence of BendingMode
    l_CG : float
        Station of the center of gravity (ft).
    stations : float or ndarray, shape (S,)
        In ft.

    Returns
    -------
    float or ndarray, shape (S,)
    """
    if name in ("one", "arm"):
        return stations - l_CG if name == "arm" else 0.0 * stations + 1.0
    kind, number = name.split("_")
    mode = modes[int(number) - 1]
    return mode.deflection(stations) if kind == "phi" else mode.slope(stations)


def lever_matrix(modes: Sequence[BendingMode], l_CG: float, stations: float | NDArray) -> NDArray:
    """Return the lever of a force in each equation.

    Parameters
    ----------
    modes : sequence of BendingMode
    l_CG : float
        Station of the center of gravity (ft).
    stations : float or ndarray, shape (S,)
        Where the force acts (ft).

    Returns
    -------
    ndarray, shape (rows,) or (rows, S)
    """
    shaped = levers(len(modes)).values()
    return np.array([sign * shape_at(shape, modes, l_CG, stations) for sign, shape, _ in shaped])


def inertias(booster: Booster) -> NDArray:
    """Return the inertia of each equation, M, I_y and the generalized masses: shape (rows,)."""
    return np.array([booster.M, booster.I_y, *(mode.mass for mode in booster.modes)])


def air(booster: Booster) -> NDArray:
    """Return the air's part of a booster's coefficients: inertia^-1 lever diag(q_D S C_N) incidence^T.

    Returns
    -------
    ndarray, shape (rows, motions)
    """
    modes, l_CG, U = booster.modes, booster.l_CG, booster.flight.U
    stations = np.array([surface.station for surface in booster.surfaces])
    C_N = np.array([surface.C_Nalpha for surface in booster.surfaces])
    incidence = np.array(
        [
            sign * shape_at(shape, modes, l_CG, stations) / (U if rate else 1.0)
            for sign, shape, rate in incidences(len(modes)).values()
        ]
    )
    lever = lever_matrix(modes, l_CG, stations)
    force = booster.flight.q_D * booster.S / inertias(booster)
    return force[:, None] * np.einsum("rs,cs->rc", C_N * lever, incidence)


def thrust(booster: Booster) -> NDArray:
    """Return the thrust's part of the coefficients, shape (rows, motions and delta) [Eqs. 14 to 17].

    It turns with the vehicle's end, by -sigma_i(G) q_i, and with delta; and it acts beside the center of
    gravity by phi_i(G) q_i.
    """
    count, G = len(booster.modes), booster.thrust_station
    force = booster.T / inertias(booster)
    across = force * lever_matrix(booster.modes, booster.l_CG, G)
    found = np.zeros((2 + count, 3 + 2 * count))
    for i, mode in enumerate(booster.modes):
        found[:, 3 + 2 * i] = across * mode.slope(G)
        found[1, 3 + 2 * i] += force[1] * mode.deflection(G)
    found[:, -1] = -across
    return found


def structure(modes: Sequence[BendingMode]) -> dict[str, Product]:
    """Return the structure's part of the coefficients of the ``modes``: 2 zeta_i omega_i and omega_i^2."""
    found = {}
    for i, mode in enumerate(modes, start=1):
        found[f"F{i}_q{i}dot"] = Product(2 * mode.zeta, (f"omega_{i}",))
        found[f"F{i}_q{i}"] = Product(1.0, (f"omega_{i}", f"omega_{i}"))
    return found


def coefficients(booster: Booster) -> dict[str, float]:
    """Return every coefficient of Eq. 29 by name, from a vehicle's data."""
    found = thrust(booster)
    found[:, :-1] += air(booster)
    c = dict(zip(coefficient_names(len(booster.modes)), found.ravel().tolist(), strict=True))
    omega = {f"omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    for name, (weight, factors) in structure(booster.modes).items():
        c[name] += weight * prod(omega[factor] for factor in factors)
    return c


class EquationTerm(NamedTuple):
    """One term of the matrix of Eq. 29: a weight times a coefficient, or alone, times a power of s."""

    row: int
    column: int
    power: int
    weight: float
    coefficient: str = ""


def equation_terms(modes: int, U: float, gravity: float = 0.0) -> Iterator[EquationTerm]:
    """Yield the terms that the matrix of Eq. 29 is the sum of.

    Parameters
    ----------
    modes : int
        Number of bending modes.
    U : float
        Speed (ft/s).
    gravity : float
        Weight across the path, g sin gamma_0 (ft/s^2): Eq. 1's own term, which Eq. 29 leaves out.

    Yields
    ------
    EquationTerm
    """
    for i, row in enumerate(row_names(modes)):
        yield EquationTerm(i, 0, 0, 1.0, f"{row}_alpha")
        yield EquationTerm(i, 1, 1, 1.0, f"{row}_thetadot")
        for j, q in enumerate(output_names(modes)[2:], start=2):
            yield EquationTerm(i, j, 0, 1.0, f"{row}_{q}")
            yield EquationTerm(i, j, 1, 1.0, f"{row}_{q}dot")
        yield EquationTerm(i, i, 2 if i else 1, 1.0 if i else U)
    yield EquationTerm(0, 1, 1, -U)
    yield EquationTerm(0, 1, 0, gravity)


def products(booster: Booster) -> dict[str, tuple[Product, ...]]:
    """Return each coefficient of a motion as a sum of products, for vehicles that differ in some data.

    Parameters
    ----------
    booster : Booster
        Masses, thrust, shapes, damping ratios and speed stay its own.

    Returns
    -------
    dict of str to tuple of Product
        Factors: q_D, C_<surface>, omega_i, and ``<shape>_<surface>`` with the shapes of `Shaped`.
    """
    count, U = len(booster.modes), booster.flight.U
    own = dict(zip(coefficient_names(count), thrust(booster).ravel().tolist(), strict=True))
    found = {
        f"{row}_{motion}": [Product(own[f"{row}_{motion}"], ())]
        for row in levers(count)
        for motion in incidences(count)
    }
    for name, spring in structure(booster.modes).items():
        found[name].append(spring)
    for (row, lever), inertia in zip(levers(count).items(), inertias(booster).tolist(), strict=True):
        for motion, incidence in incidences(count).items():
            weight = booster.S / inertia * lever.sign * incidence.sign / (U if incidence.rate else 1.0)
            shaped = [shape for shape in (lever.shape, incidence.shape) if shape != "one"]
            found[f"{row}_{motion}"] += [
                Product(weight, ("q_D", f"C_{s.name}", *(f"{shape}_{s.name}" for shape in shaped)))
                for s in booster.surfaces
            ]
    return {name: tuple(sums) for name, sums in found.items()}
