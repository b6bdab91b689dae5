"""A complementary filter: one gyro's angle below a corner, another station's rate gyro above it."""

import control

from rlswaim.practice.blocks import first_order, gain
from rlswaim.practice.measurements import angle
from rlswaim.source.tables import constants
from rlswaim.vehicle.equations import PerturbationEquations


def complementary(
    eqs: PerturbationEquations, corner: float, K_R: float, station: float
) -> list[control.StateSpace]:
    """Return the blocks from the vehicle's states to theta_i.

    theta_i = w/(s + w) angle + (1/(s + w) + K_R) rate, w the corner: of one and the same angle both parts
    make (1 + K_R s) times it.  The rate gyro stands where ``data/ladder.csv`` says.

    Parameters
    ----------
    eqs : PerturbationEquations
    corner : float
        In rad/s.
    K_R : float
        Gain of the rate (s).
    station : float
        Of the gyro whose angle is read (ft).

    Returns
    -------
    list of control.StateSpace
    """
    w = corner
    low = angle(eqs, {station: 1.0})
    high = {
        f"{name}dot": value for name, value in angle(eqs, {constants("ladder")["rate_station"]: 1.0}).items()
    }
    both = control.append(first_order([w], [1.0, w]), first_order([K_R, 1 + K_R * w], [1.0, w]))
    return [
        gain([list(low.values())], name="gyro", inputs=list(low), outputs="angle"),
        gain([list(high.values())], name="rate gyro", inputs=list(high), outputs="rate"),
        control.ss(
            gain([[1.0, 1.0]]) * both, name="complementary", inputs=["angle", "rate"], outputs="theta_i"
        ),
    ]
