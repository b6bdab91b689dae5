"""What instruments read on a bent vehicle: gyros, accelerometers and a vane, as rows over states and inputs.

A gyro package at station l reads the attitude and the rate of the axis there, an accelerometer the specific
force across it (what a mass feels, so without the weight), a vane the incidence of the air::

    attitude       theta - sum sigma_i q_i            rate   its derivative
    accelerometer  U (alpha' - theta') + (l - l_CG) theta'' - sum phi_i q_i'' + g sin gamma_0 theta
    vane           alpha + alpha_g + (l - l_CG)/U theta' + sum (sigma_i q_i - phi_i/U q_i')

All count as the report's symbols do: accelerations down, in ft/s^2, angles in rad.
"""

from dataclasses import dataclass

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.source import checks
from rlswaim.vehicle.equations import PerturbationEquations

KINDS = ("attitude", "rate", "accelerometer", "vane")
GYRO = ("attitude", "rate")


@dataclass(frozen=True)
class Instrument:
    """An instrument of a kind (one of `KINDS`) at a station (ft).

    Raises
    ------
    ValueError
        If the kind is unknown.
    """

    kind: str
    station: float

    def __post_init__(self) -> None:
        """Check the kind; the modes check the station when it is used."""
        checks.one_of("kind", self.kind, KINDS, "Instrument")

    @property
    def name(self) -> str:
        """Kind and station; signals of python-control have no dot in their names."""
        return f"{self.kind} {self.station:g}".replace(".", ",")


def gyros(*stations: float) -> tuple[Instrument, ...]:
    """Return a package of attitude and rate gyros at each of several ``stations`` (ft)."""
    return tuple(Instrument(kind, station) for station in stations for kind in GYRO)


def reading(eqs: PerturbationEquations, vehicle: control.StateSpace, instrument: Instrument) -> NDArray:
    """Return what an instrument reads per unit of each state and of each input.

    Parameters
    ----------
    eqs : PerturbationEquations
    vehicle : control.StateSpace
        Its state space, with the jet where it is.
    instrument : Instrument

    Returns
    -------
    ndarray, shape (states + inputs,)
    """
    columns = [*vehicle.output_labels, *vehicle.input_labels]
    x, found = instrument.station, np.zeros(len(columns))
    if instrument.kind == "accelerometer":
        rates = dict(zip(vehicle.output_labels, np.hstack([vehicle.A, vehicle.B]), strict=True))
        found += eqs.U * (rates["alpha"] - rates["theta"]) + (x - eqs.l_CG) * rates["thetadot"]
        for i, mode in enumerate(eqs.modes, start=1):
            found -= mode.deflection(x) * rates[f"q{i}dot"]
        found[columns.index("theta")] += eqs.gravity
        return found
    if instrument.kind == "vane":
        row = {"alpha": 1.0, "alpha_g": 1.0, "thetadot": (x - eqs.l_CG) / eqs.U}
        for i, mode in enumerate(eqs.modes, start=1):
            row |= {f"q{i}": mode.slope(x), f"q{i}dot": -mode.deflection(x) / eqs.U}
    else:
        dot = "dot" if instrument.kind == "rate" else ""
        row = {f"theta{dot}": 1.0}
        row |= {f"q{i}{dot}": -mode.slope(x) for i, mode in enumerate(eqs.modes, start=1)}
    found[[columns.index(name) for name in row]] = list(row.values())
    return found
