"""Controllers of a fixed structure: Section VII's, with filters and instruments that can be built.

    delta_c   = K_A K_C/(s + K_C) F(s) N(s) (1 + K_I/s) (command theta_c - theta_F)
    theta_F   = blend (theta + K_R theta')_gyro + (1 - blend) (theta + K_R theta')_second gyro
    delta_r_c = -kK_z K_r/(s + K_r) (s + b)/(s^2 + 2 zeta w s + w^2) accelerometer

F is a low-pass of second order in place of the report's ideal one.  N is a notch.  The linear sensor is an
accelerometer, and two integrations with a washout w stand in place of the ideal high-pass: at once above w
they are the displacement z, times (s + b) as in Section VII, whose signs the gains keep.
"""

from collections.abc import Mapping

import control
import numpy as np

from rlswaim.practice.blocks import first_order, gain, second_order
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.source.tables import constants

ENGINE = ("command", "K_A", "K_C", "K_R", "low_pass", "gyro")
JET = ("kK_z", "K_r", "b", "washout", "sensor", "jet")
BLEND = ("K_I", "blend", "second_gyro", "notch", "notch_zeros", "notch_poles")
"""Parameters by part; the last part may be left out: no integral, one gyro, no notch."""


def instruments_of(gains: Mapping[str, float]) -> tuple[Instrument, ...]:
    """Return the instruments that a controller with these ``gains`` reads."""
    return (*gyros(*_gyro_stations(gains)), Instrument("accelerometer", gains["sensor"]))


def _gyro_stations(gains: Mapping[str, float]) -> list[float]:
    """Return the stations of the gyros, each once."""
    return list(dict.fromkeys([gains["gyro"], gains.get("second_gyro", gains["gyro"])]))


def _engine_filter(gains: Mapping[str, float]) -> control.StateSpace:
    zeta, w = constants("ladder")["filter_zeta"], gains["low_pass"]
    chain = [second_order([w**2], [1.0, 2 * zeta * w, w**2])]
    if "notch" in gains:
        at = gains["notch"]
        zeros, poles = ([1.0, 2 * gains[f"notch_{kind}"] * at, at**2] for kind in ("zeros", "poles"))
        chain.append(second_order(zeros, poles))
    if "K_I" in gains:
        chain.append(first_order([1.0, gains["K_I"]], [1.0, 0.0]))
    chain.append(first_order([gains["K_A"] * gains["K_C"]], [1.0, gains["K_C"]]))
    return control.series(*chain)


def _jet_filter(gains: Mapping[str, float]) -> control.StateSpace:
    zeta, w = constants("ladder")["filter_zeta"], gains["washout"]
    displacement = second_order([1.0, gains["b"]], [1.0, 2 * zeta * w, w**2])
    return control.series(displacement, first_order([-gains["kK_z"] * gains["K_r"]], [1.0, gains["K_r"]]))


def controller(gains: Mapping[str, float]) -> control.StateSpace:
    """Return the controller with given gains.

    Parameters
    ----------
    gains : mapping of str to float
        command, K_A (1), K_C (1/s), K_R (s), low_pass (rad/s), gyro (ft); kK_z (lb s/ft), K_r, b (1/s),
        washout (rad/s), sensor, jet (ft); perhaps K_I (1/s), blend (1), second_gyro (ft), notch (rad/s),
        notch_zeros and notch_poles (damping ratios).

    Returns
    -------
    control.StateSpace
        Inputs theta_c and `instruments_of`; outputs delta_c, delta_r_c.
    """
    blend = gains.get("blend", 1.0)
    weights = [blend, 1 - blend] if len(_gyro_stations(gains)) > 1 else [1.0]
    reads = [-weight * rate for weight in weights for rate in (1.0, gains["K_R"])]
    rows = np.array([[gains["command"], *reads, 0.0], [*np.zeros(1 + len(reads)), 1.0]])
    both = control.append(_engine_filter(gains), _jet_filter(gains)) * gain(rows)
    names = ["theta_c", *(one.name for one in instruments_of(gains))]
    return control.ss(both, name="fixed structure", inputs=names, outputs=["delta_c", "delta_r_c"])
