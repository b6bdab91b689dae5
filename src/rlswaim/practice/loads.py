"""Bending moment and shear along the vehicle, by summation of inertia and air forces.

All forces on the part ahead of a cut at station x are summed, positive down like z:

    inertia of each mass    -m (U (alpha' - theta') + (l - l_CG) theta'' - sum phi_i q_i'')
    air on each surface     -q_D S C_N (alpha + alpha_g + (l - l_CG)/U theta'
                                        + sum (sigma_i q_i - phi_i/U q_i'))
    jet                     k delta_r at its station
    axial inertia           -m T/M forward, which bends where the axis is bent

The shear is their sum, and the moment the sum of (x - l) times each, the axial ones by the deflection
-sum phi_i q_i between the mass and the cut.  At the nose both are zero by their making.  At the aft end,
with the thrust, they are zero only if the equations of motion balance the same forces: an independent
check, which the vehicle with recomputed totals and orthogonal modes passes, and the printed one does not.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.source import checks
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations

INPUTS = ("delta", "delta_r", "alpha_g")


@dataclass(frozen=True, eq=False)
class SectionLoads:
    """Shear (lb) and bending moment (lb ft) at stations, linear in the vehicle's states and inputs.

    Both have the shape (stations, columns): what each unit of a state or an input brings.
    """

    stations: NDArray
    columns: tuple[str, ...]
    shear: NDArray
    moment: NDArray
    end_shear: NDArray
    """Shear at the aft end with the thrust: zero in each column if the forces balance (lb)."""
    end_moment: NDArray
    """Moment at the thrust point: zero in each column if the forces balance (lb ft)."""


def _accelerations(booster: Booster, rates: Mapping[str, NDArray], U: float, l_CG: float) -> NDArray:
    """Return what each mass feels as acceleration (ft/s^2, down) by what the states' rates are rows of."""
    found = U * (rates["alpha"] - rates["theta"]) + np.outer(booster.stations - l_CG, rates["thetadot"])
    for i, mode in enumerate(booster.modes, start=1):
        found = found - np.outer(mode.deflection(booster.stations), rates[f"q{i}dot"])
    return found


def _air(booster: Booster, columns: Sequence[str], U: float, l_CG: float) -> NDArray:
    """Return the air's downward force (lb) on each surface by state and input: (surfaces, columns)."""
    rows = []
    for surface in booster.surfaces:
        x = surface.station
        incidence = {"alpha": 1.0, "alpha_g": 1.0, "thetadot": (x - l_CG) / U}
        for i, mode in enumerate(booster.modes, start=1):
            incidence |= {f"q{i}": mode.slope(x), f"q{i}dot": -mode.deflection(x) / U}
        force = -booster.flight.q_D * booster.S * surface.C_Nalpha
        rows.append([force * incidence.get(name, 0.0) for name in columns])
    return np.array(rows)


def _by_mode(booster: Booster, columns: Sequence[str], values: Sequence[float]) -> NDArray:
    """Return a row with one value in the column of each q_i."""
    found = np.zeros(len(columns))
    for i, value in enumerate(values, start=1):
        found[columns.index(f"q{i}")] = value
    return found


def _axial(booster: Booster, columns: Sequence[str], cuts: NDArray) -> NDArray:
    """Return the moment (lb ft) at each cut of the axial inertia ahead of it: (cuts, columns)."""
    found = np.zeros((cuts.size, len(columns)))
    pulls = booster.masses * booster.T / booster.masses.sum()
    ahead = np.where(booster.stations < cuts[:, None], pulls, 0.0)
    for i, mode in enumerate(booster.modes, start=1):
        bent = mode.deflection(cuts)[:, None] - mode.deflection(booster.stations)
        found[:, columns.index(f"q{i}")] = (ahead * bent).sum(axis=1)
    return found


def section_loads(
    booster: Booster, eqs: PerturbationEquations, stations: ArrayLike, jet: float = JET_STATION
) -> SectionLoads:
    """Return shear and bending moment at stations.

    Parameters
    ----------
    booster : Booster
        Its masses, modes, surfaces and thrust.
    eqs : PerturbationEquations
        Of the same vehicle.
    stations : array_like, shape (n,)
        Of the cuts (ft).
    jet : float
        Station of the jet (ft).

    Returns
    -------
    SectionLoads

    Raises
    ------
    TypeError
        If ``booster`` or ``eqs`` is of another kind.
    ValueError
        If a station is not finite.
    """
    checks.instance("booster", booster, Booster, "section_loads")
    checks.instance("eqs", eqs, PerturbationEquations, "section_loads")
    cuts = checks.frozen_array("stations", stations, "section_loads")
    vehicle = eqs.state_space(jet)
    columns = (*vehicle.output_labels, *INPUTS)
    rates = dict(zip(vehicle.output_labels, np.hstack([vehicle.A, vehicle.B]), strict=True))
    felt = _accelerations(booster, rates, eqs.U, eqs.l_CG)
    felt[:, columns.index("theta")] += getattr(eqs, "gravity", 0.0)  # the weight bends nothing
    inertia = -booster.masses[:, None] * felt
    pushed = np.zeros((1, len(columns)))
    pushed[0, columns.index("delta_r")] = 1.0
    forces = np.vstack([inertia, _air(booster, columns, eqs.U, eqs.l_CG), pushed])
    places = np.array([*booster.stations, *(s.station for s in booster.surfaces), jet])
    G = booster.thrust_station
    ends = np.array([*cuts, G])
    ahead = np.maximum(ends[:, None] - places, 0.0)
    shear, moment = (places < ends[:, None]) @ forces, ahead @ forces + _axial(booster, columns, ends)
    thrust = _by_mode(booster, columns, [-booster.T * mode.slope(G) for mode in booster.modes])
    thrust[columns.index("delta")] = booster.T
    return SectionLoads(cuts, columns, shear[:-1], moment[:-1], shear[-1] + thrust, moment[-1])


class MomentTerm(NamedTuple):
    """A part of the moment: a weight times data of the vehicle times a derivative of one quantity by time."""

    quantity: str
    order: int
    weight: float
    factors: tuple[str, ...]


def moment_terms(booster: Booster, eqs: PerturbationEquations, station: float) -> list[MomentTerm]:
    """Return the bending moment at a station (lb ft) in the motions, for vehicles with other data.

    Parameters
    ----------
    booster : Booster
        Its masses, shapes, thrust and stations of surfaces, which stay.
    eqs : PerturbationEquations
        Their speed and centre of gravity.
    station : float
        Of the cut (ft).

    Returns
    -------
    list of MomentTerm
        Factors are q_D, C_<surface>, gravity (the weight across the path, ft/s^2) and lever (how far the
        jet is ahead of the cut, ft).
    """
    modes = range(1, len(booster.modes) + 1)
    swings = [*((f"q{i}", 0) for i in modes), *((f"q{i}", 1) for i in modes)]
    states = {"alpha": ("alpha", 0), "theta": ("theta", 0), "thetadot": ("theta", 1)}
    states |= {name + order * "dot": (name, order) for name, order in swings}
    moving = ["alpha", "theta", "thetadot", *(f"q{i}dot" for i in modes)]
    units = dict(zip(moving, np.eye(len(moving)), strict=True))
    pushed = -booster.masses * np.maximum(station - booster.stations, 0.0)
    inertia = pushed @ _accelerations(booster, units, eqs.U, eqs.l_CG)
    found = [
        MomentTerm(states[name][0], states[name][1] + 1, weight, ())
        for name, weight in zip(moving, inertia.tolist(), strict=True)
    ]
    found += [
        MomentTerm("theta", 0, float(pushed.sum()), ("gravity",)),
        MomentTerm("delta_r", 0, 1.0, ("lever",)),
    ]
    columns = (*states, "alpha_g")
    bent = _axial(booster, columns, np.array([station]))[0]
    found += [MomentTerm(f"q{i}", 0, float(bent[columns.index(f"q{i}")]), ()) for i in modes]
    for surface, force in zip(booster.surfaces, _air(booster, columns, eqs.U, eqs.l_CG), strict=True):
        size = max(station - surface.station, 0.0) / (booster.flight.q_D * surface.C_Nalpha)
        data = ("q_D", f"C_{surface.name}")
        for name, weight in zip(columns, (size * force).tolist(), strict=True):
            found.append(MomentTerm(*states.get(name, (name, 0)), weight, data))
    return [term for term in found if term.weight]


def with_moments(
    closed_loop: control.StateSpace, loads: SectionLoads, gust: str = "alpha_g"
) -> control.StateSpace:
    """Return a closed loop with the bending moment at each station as further outputs.

    Parameters
    ----------
    closed_loop : control.StateSpace
        Its outputs hold the vehicle's states, delta, and if there is a jet delta_r.
    loads : SectionLoads
    gust : str
        The input that is the gust's incidence.

    Returns
    -------
    control.StateSpace
        The new outputs are named "moment <station>" (lb ft).
    """
    names = list(closed_loop.output_labels)
    rows, through = closed_loop.C, closed_loop.D
    weights = np.zeros((loads.stations.size, len(names)))
    direct = np.zeros((loads.stations.size, closed_loop.ninputs))
    for at, column in enumerate(loads.columns):
        if column in names:
            weights[:, names.index(column)] = loads.moment[:, at]
        elif column == "alpha_g" and gust in closed_loop.input_labels:
            direct[:, closed_loop.input_labels.index(gust)] = loads.moment[:, at]
    return control.ss(
        closed_loop.A,
        closed_loop.B,
        np.vstack([rows, weights @ rows]),
        np.vstack([through, weights @ through + direct]),
        name=closed_loop.name,
        inputs=closed_loop.input_labels,
        outputs=[*names, *(f"moment {x:g}" for x in loads.stations)],
        states=closed_loop.state_labels,
    )
