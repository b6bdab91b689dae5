"""What the report's loops measure and drive, as plants, and the limits of an instrument by its station."""

from collections.abc import Callable, Mapping

import control
import numpy as np
from numpy.typing import ArrayLike

from rlswaim.practice.limits import Limits, limits
from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations


def attitude(eqs: PerturbationEquations, gyro: float | None) -> control.StateSpace:
    """Return the plant of Section IV, from delta to the angle that a gyro reads.

    Parameters
    ----------
    eqs : PerturbationEquations
    gyro : float or None
        Its station (ft); None is the rigid body's angle alone.

    Returns
    -------
    control.StateSpace
    """
    return blended(eqs, {} if gyro is None else {gyro: 1.0})


def angle(eqs: PerturbationEquations, gyros: Mapping[float, float]) -> dict[str, float]:
    """Return the row of a weighted sum of what several gyros read [Eq. 57].

    Parameters
    ----------
    eqs : PerturbationEquations
    gyros : mapping of float to float
        The weight of each gyro by its station (ft), of sum 1; without any, the rigid body's angle alone.

    Returns
    -------
    dict of str to float
    """
    row = {"theta": 1.0}
    for i, mode in enumerate(eqs.modes, start=1):
        row[f"q{i}"] = -sum(weight * mode.slope(at) for at, weight in gyros.items())
    return row


def blended(eqs: PerturbationEquations, gyros: Mapping[float, float]) -> control.StateSpace:
    """Return the plant from delta to a weighted sum of what several gyros read.

    Parameters
    ----------
    eqs : PerturbationEquations
    gyros : mapping of float to float
        As in `angle`.

    Returns
    -------
    control.StateSpace
    """
    return measured(eqs, [angle(eqs, gyros)], ["delta"])


def displacement(eqs: PerturbationEquations, sensor: float) -> dict[str, float]:
    """Return the row of a linear sensor's elastic part, -phi_i(sensor) for each q_i [Eq. 99].

    Parameters
    ----------
    eqs : PerturbationEquations
    sensor : float
        Its station (ft).

    Returns
    -------
    dict of str to float
    """
    return {f"q{i}": -mode.deflection(sensor) for i, mode in enumerate(eqs.modes, start=1)}


def measured(
    eqs: PerturbationEquations, rows: list[dict[str, float]], inputs: list[str], jet: float | None = None
) -> control.StateSpace:
    """Return the vehicle with chosen effectors and with sensors that weigh its states.

    Parameters
    ----------
    eqs : PerturbationEquations
    rows : list of dict
        The weights of each sensor by state.
    inputs : list of str
        Of delta and delta_r.
    jet : float, optional
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace
    """
    vehicle = eqs.state_space() if jet is None else eqs.state_space(jet)
    C = np.array([[row.get(name, 0.0) for name in vehicle.output_labels] for row in rows])
    B = vehicle.B[:, [vehicle.input_labels.index(name) for name in inputs]]
    return control.ss(vehicle.A, B, C, np.zeros((len(rows), len(inputs))), inputs=inputs)


READINGS: dict[str, Callable[[PerturbationEquations, float], dict[str, float]]] = {
    "gyro": lambda eqs, station: angle(eqs, {station: 1.0}),
    "linear sensor": displacement,
}
"""What one instrument at a station (ft) reads, as a row of weights by state."""


def limits_along(eqs: PerturbationEquations, instrument: str, stations: ArrayLike) -> list[Limits]:
    """Return the limits with one instrument alone at each of several stations: a map of the bound.

    Parameters
    ----------
    eqs : PerturbationEquations
    instrument : str
        One of `READINGS`.
    stations : array_like, shape (n,)
        In ft.

    Returns
    -------
    list of Limits

    Raises
    ------
    ValueError
        If there is no such instrument.
    """
    checks.one_of("instrument", instrument, tuple(READINGS), "limits_along")
    rows = (READINGS[instrument](eqs, float(station)) for station in np.asarray(stations))
    return [limits(measured(eqs, [row], ["delta"])) for row in rows]
