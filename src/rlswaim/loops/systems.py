"""The control systems of Sections IV to VII as feedback around the vehicle.

Every system is wired by signal name with `control.interconnect`; the blocks
are the report's: amplifier K_A, actuator K_C/(s + K_C), rate and attitude gyro
K_R s + 1, linear sensor K_z (s + 1).  Section V to VII filter ideally: the
gyro gives the rigid-body angle alone and the linear sensor the elastic
displacement alone.
"""

from collections.abc import Sequence

import control
import numpy as np

from rlswaim.loops.blocks import gyro_package, joined, lag, linear_sensor, without_input
from rlswaim.source import checks
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations
from rlswaim.vehicle.stations import as_station


def _gains(system: str, eqs: PerturbationEquations, **gains: object) -> list[float]:
    checks.instance("eqs", eqs, PerturbationEquations, system)
    return [checks.real(name, value, system) for name, value in gains.items()]


def rate_attitude(
    eqs: PerturbationEquations, *, K_A: float, K_C: float, K_R: float, gyro: float | None
) -> control.StateSpace:
    """Return Section IV's closed loop: rate and attitude feedback to the thrust vector.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A : float
        Amplifier gain (rad/rad).
    K_C : float
        Actuator gain, minus the actuator's pole (1/s).
    K_R : float
        Rate gyro gain (s).
    gyro : float or None
        Station of the gyro package (ft); None feeds back the rigid-body angle only [Eq. 96].

    Returns
    -------
    control.StateSpace
        Eight states; inputs theta_c, alpha_g (rad); outputs the vehicle's states and delta (rad).

    Raises
    ------
    ValueError
        If a gain is not finite or the station lies outside 0..420 ft.
    TypeError
        If a gain is not a real number.

    Notes
    -----
    The control law is Eq. 58; the characteristic equation is that of Eqs. 59 and 83.
    """
    K_A, K_C, K_R = _gains("rate_attitude", eqs, K_A=K_A, K_C=K_C, K_R=K_R)
    station = None if gyro is None else as_station("gyro", gyro, "rate_attitude")
    return joined(
        "rate_attitude",
        [
            without_input(eqs.state_space(), "delta_r"),
            gyro_package(eqs, K_R, station),
            control.summing_junction(["theta_c", "-theta_F"], "theta_e"),
            lag("actuator", "theta_e", "delta", K_C, K_A),
        ],
        ["delta"],
    )


def _inner_loop_system(
    name: str,
    eqs: PerturbationEquations,
    K_A: float,
    K_C: float,
    K_R: float,
    sensors: Sequence[control.StateSpace],
) -> control.StateSpace:
    """Return the loop of Sections V and VI: delta = K_C/(s + K_C) [K_A (theta_c - theta_F) - sum of z]."""
    signals = [sensor.output_labels[0] for sensor in sensors]
    return joined(
        name,
        [
            without_input(eqs.state_space(), "delta_r"),
            gyro_package(eqs, K_R, None),
            control.summing_junction(["theta_c", "-theta_F"], "theta_e"),
            control.ss(
                [],
                np.zeros((0, 1)),
                np.zeros((1, 0)),
                [[K_A]],
                name="amplifier",
                inputs="theta_e",
                outputs="u",
            ),
            control.summing_junction(["u", *(f"-{signal}" for signal in signals)], "delta_2"),
            *sensors,
            lag("actuator", "delta_2", "delta", K_C),
        ],
        ["delta"],
    )


def single_sensor(
    eqs: PerturbationEquations, *, K_A: float, K_C: float, K_R: float, K_z: float, sensor: float
) -> control.StateSpace:
    """Return Section V's closed loop: one linear sensor in an inner loop to the thrust vector.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A, K_C, K_R : float
        Amplifier (rad/rad), actuator (1/s) and rate gyro (s) gains.
    K_z : float
        Displacement sensor gain (rad s/ft).
    sensor : float
        Station of the linear sensor (ft).

    Returns
    -------
    control.StateSpace
        Eight states; inputs theta_c, alpha_g; outputs the vehicle's states and delta.

    Raises
    ------
    ValueError
        If a gain is not finite or the station lies outside 0..420 ft.
    TypeError
        If a gain is not a real number.

    Notes
    -----
    Figures 12 to 14, Eqs. 98 to 110.
    """
    K_A, K_C, K_R, K_z = _gains("single_sensor", eqs, K_A=K_A, K_C=K_C, K_R=K_R, K_z=K_z)
    station = as_station("sensor", sensor, "single_sensor")
    return _inner_loop_system("single_sensor", eqs, K_A, K_C, K_R, [linear_sensor(eqs, "z", K_z, station)])


def two_sensor(
    eqs: PerturbationEquations,
    *,
    K_A: float,
    K_C: float,
    K_R: float,
    K_za: float,
    K_zb: float,
    sensor_a: float,
    sensor_b: float,
) -> control.StateSpace:
    """Return Section VI's closed loop: two linear sensors in inner loops to the thrust vector.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A, K_C, K_R : float
        Amplifier (rad/rad), actuator (1/s) and rate gyro (s) gains.
    K_za, K_zb : float
        Displacement sensor gains (rad s/ft).
    sensor_a, sensor_b : float
        Stations of the linear sensors (ft).

    Returns
    -------
    control.StateSpace
        Eight states; inputs theta_c, alpha_g; outputs the vehicle's states and delta.

    Raises
    ------
    ValueError
        If a gain is not finite or a station lies outside 0..420 ft.
    TypeError
        If a gain is not a real number.

    Notes
    -----
    Figures 17 and 18, Eqs. 112 to 114.
    """
    K_A, K_C, K_R, K_za, K_zb = _gains("two_sensor", eqs, K_A=K_A, K_C=K_C, K_R=K_R, K_za=K_za, K_zb=K_zb)
    at = [
        as_station(name, value, "two_sensor")
        for name, value in (("sensor_a", sensor_a), ("sensor_b", sensor_b))
    ]
    return _inner_loop_system(
        "two_sensor",
        eqs,
        K_A,
        K_C,
        K_R,
        [linear_sensor(eqs, "z_a", K_za, at[0]), linear_sensor(eqs, "z_b", K_zb, at[1])],
    )


def dual_actuation(
    eqs: PerturbationEquations,
    *,
    K_A: float,
    K_C: float,
    K_R: float,
    kK_z: float,
    K_r: float,
    b: float,
    sensor: float,
    jet: float = JET_STATION,
) -> control.StateSpace:
    """Return Section VII's closed loop: thrust vector for the rigid body, reaction jet for the modes.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A, K_C, K_R : float
        Amplifier (rad/rad), actuator (1/s) and rate gyro (s) gains of the outer loop.
    kK_z : float
        Jet constant times displacement sensor gain (lb s/ft), in the report's sign.
    K_r : float
        Gain of the jet's valve, minus its pole (1/s).
    b : float
        Attitude-to-rate ratio of the linear sensor, (s + b) (1/s).
    sensor, jet : float
        Stations of the linear sensor and of the reaction jet (ft).

    Returns
    -------
    control.StateSpace
        Nine states; inputs theta_c, alpha_g; outputs the vehicle's states, delta (rad) and
        delta_r, given as the jet's force k delta_r (lb).

    Raises
    ------
    ValueError
        If a gain is not finite or a station lies outside 0..420 ft.
    TypeError
        If a gain is not a real number.

    Notes
    -----
    Figures 21 to 23, Eqs. 120 to 130: delta_r = -G_12 q_1 - G_14 q_2.
    """
    K_A, K_C, K_R, kK_z, K_r, b = _gains(
        "dual_actuation", eqs, K_A=K_A, K_C=K_C, K_R=K_R, kK_z=kK_z, K_r=K_r, b=b
    )
    at = [as_station(name, value, "dual_actuation") for name, value in (("sensor", sensor), ("jet", jet))]
    return joined(
        "dual_actuation",
        [
            eqs.state_space(at[1]),
            gyro_package(eqs, K_R, None),
            control.summing_junction(["theta_c", "-theta_F"], "theta_e"),
            lag("actuator", "theta_e", "delta", K_C, K_A),
            linear_sensor(eqs, "z", -kK_z, at[0], b),
            lag("valve", "z", "delta_r", K_r),
        ],
        ["delta", "delta_r"],
    )
