"""Controllers of a fixed structure: Section VII's as it can be built, and blended gyros with notches.

    delta_c   = K_A K_C/(s + K_C) F(s) (command theta_c - theta_F)
    theta_F   = (theta + K_R theta')_gyro
    delta_r_c = -kK_z K_r/(s + K_r) (s + b)/(s^2 + 2 zeta w s + w^2) accelerometer

F is a low-pass of second order in place of the report's ideal one.  The linear sensor is an accelerometer,
and two integrations with a washout w stand in place of the ideal high-pass: at once above w they are the
displacement z, times (s + b) as in Section VII, whose signs the gains keep.

As practitioners build it, two gyros are blended for each effector, and a notch stands behind::

    delta_c   = K_A (1 + K_I/s) N(s) F(s) (theta_c - theta_b)     theta_b = blend (theta + K_R theta')_gyro
    delta_r_c = K_J N_J(s) K_r/(s + K_r) (theta_c - theta_j)                + (1 - blend) (...)_second gyro

theta_j has a blend and a K_R of its own.
"""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import control
import numpy as np

from rlswaim.practice.blocks import first_order, gain, low_pass, notch, second_order
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.source.tables import constants

NOSE = 27.0
"""Station of the jet and of the accelerometer of designs with a nose jet (ft): the first mass of Table 1."""
ENGINE = ("command", "K_A", "K_C", "K_R", "low_pass", "gyro")
JET = ("kK_z", "K_r", "b", "washout", "sensor", "jet")
BLENDED = (
    "K_A",
    "K_R",
    "K_I",
    "low_pass",
    "gyro",
    "second_gyro",
    "blend",
    "notch",
    "notch_zeros",
    "notch_poles",
)
BLENDED_JET = ("K_J", "K_RJ", "K_r", "blend_jet", "notch_jet", "notch_jet_zeros", "notch_jet_poles")


class Structure(NamedTuple):
    """A controller's parameters, what it is made of, and what is kept.

    ``controller`` takes the gains and returns a state space as `hardware.closed_loop` wants it;
    ``instruments`` takes them too.  ``fixed`` are gains that are not sought.
    """

    parameters: tuple[str, ...]
    controller: Callable[[Mapping[str, float]], control.StateSpace]
    instruments: Callable[[Mapping[str, float]], tuple[Instrument, ...]]
    fixed: Mapping[str, float]


def _low_pass(gains: Mapping[str, float]) -> control.StateSpace:
    return low_pass(gains["low_pass"], constants("ladder")["filter_zeta"])


def _notch(gains: Mapping[str, float], name: str) -> control.StateSpace:
    return notch(gains[name], gains[f"{name}_zeros"], gains[f"{name}_poles"])


def section_vii_instruments(gains: Mapping[str, float]) -> tuple[Instrument, ...]:
    """Return the instruments that Section VII's structure with these ``gains`` reads."""
    return (*gyros(gains["gyro"]), Instrument("accelerometer", gains["sensor"]))


def section_vii(gains: Mapping[str, float]) -> control.StateSpace:
    """Return Section VII's controller with filters and instruments that can be built.

    Parameters
    ----------
    gains : mapping of str to float
        command, K_A (1), K_C (1/s), K_R (s), low_pass (rad/s), gyro (ft); kK_z (lb s/ft), K_r, b (1/s),
        washout (rad/s), sensor, jet (ft).

    Returns
    -------
    control.StateSpace
        Inputs theta_c and `section_vii_instruments`; outputs delta_c, delta_r_c.
    """
    engine = control.series(_low_pass(gains), first_order([gains["K_A"] * gains["K_C"]], [1.0, gains["K_C"]]))
    zeta, w = constants("ladder")["filter_zeta"], gains["washout"]
    displacement = second_order([1.0, gains["b"]], [1.0, 2 * zeta * w, w**2])
    jet = control.series(displacement, first_order([-gains["kK_z"] * gains["K_r"]], [1.0, gains["K_r"]]))
    rows = np.array([[gains["command"], -1.0, -gains["K_R"], 0.0], [0.0, 0.0, 0.0, 1.0]])
    return _named(control.append(engine, jet) * gain(rows), section_vii_instruments(gains))


def blended_instruments(gains: Mapping[str, float]) -> tuple[Instrument, ...]:
    """Return the instruments that the blended gyros' structure with these ``gains`` reads."""
    return gyros(*dict.fromkeys([gains["gyro"], gains["second_gyro"]]))


def blended_gyros(gains: Mapping[str, float]) -> control.StateSpace:
    """Return the controller that blends two gyros for each effector, with a notch behind.

    Parameters
    ----------
    gains : mapping of str to float
        K_A (1), K_R (s), K_I (1/s), low_pass (rad/s), gyro, second_gyro (ft), blend (1), notch (rad/s) with
        the damping ratios of its zeros and poles; K_J (lb/rad), K_RJ (s), K_r (1/s), blend_jet (1),
        notch_jet likewise.

    Returns
    -------
    control.StateSpace
        Inputs theta_c and `blended_instruments`; outputs delta_c, delta_r_c.
    """
    integral = first_order([1.0, gains["K_I"]], [1.0, 0.0])
    engine = control.series(gain(gains["K_A"]), integral, _notch(gains, "notch"), _low_pass(gains))
    lag = first_order([gains["K_J"] * gains["K_r"]], [1.0, gains["K_r"]])
    jet = control.series(_notch(gains, "notch_jet"), lag)
    one = gains["gyro"] == gains["second_gyro"]
    rows = []
    for blend, K_R in ((gains["blend"], gains["K_R"]), (gains["blend_jet"], gains["K_RJ"])):
        weights = [1.0] if one else [blend, 1 - blend]
        rows.append([1.0, *(-weight * rate for weight in weights for rate in (1.0, K_R))])
    return _named(control.append(engine, jet) * gain(rows), blended_instruments(gains))


def _named(both: control.StateSpace, instruments: tuple[Instrument, ...]) -> control.StateSpace:
    """Return a controller with the names of its signals."""
    names = ["theta_c", *(one.name for one in instruments)]
    return control.ss(both, name="fixed structure", inputs=names, outputs=["delta_c", "delta_r_c"])


STRUCTURES: Mapping[str, Structure] = {
    "VII, realizable": Structure(ENGINE + JET, section_vii, section_vii_instruments, {}),
    "blended gyros, notches, nose jet": Structure(
        BLENDED + BLENDED_JET, blended_gyros, blended_instruments, {"jet": NOSE}
    ),
}
