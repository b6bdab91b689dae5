"""The blocks of the report's control systems, and how they are joined by signal name."""

from collections.abc import Sequence

import control
import numpy as np

from rlswaim.vehicle.equations import STATES, PerturbationEquations


def ideal_sensor(name: str, weights: dict[str, float]) -> control.StateSpace:
    """Return an ideal sensor: a weighted sum of the vehicle's states.

    Parameters
    ----------
    name : str
        Of its output.
    weights : dict of str to float
        Of the states that count, by their names.
    """
    D = np.array([[weights.get(state, 0.0) for state in STATES]])
    return control.ss(
        [],
        np.zeros((0, len(STATES))),
        np.zeros((1, 0)),
        D,
        name=f"sensor of {name}",
        inputs=list(STATES),
        outputs=name,
    )


def lag(name: str, signal: str, output: str, pole: float, gain: float = 1.0) -> control.StateSpace:
    """Return ``gain * pole / (s + pole)``.

    Parameters
    ----------
    name, signal, output : str
        Of the block, its input and its output.
    pole : float
        Minus the pole (1/s).
    gain : float
    """
    return control.ss(
        [[-pole]],
        [[1.0]],
        [[gain * pole]],
        [[0.0]],
        name=name,
        inputs=signal,
        outputs=output,
        states=f"x_{output}",
    )


def gyro_package(eqs: PerturbationEquations, K_R: float, gyro: float | None) -> control.StateSpace:
    """Return the rate and attitude gyro: theta_F from the total or the rigid-body angle [Eq. 57].

    Parameters
    ----------
    eqs : PerturbationEquations
    K_R : float
        Rate gyro gain (s).
    gyro : float or None
        Station (ft); None reads the rigid-body angle alone.
    """
    sigma = [0.0, 0.0] if gyro is None else [mode.slope(gyro) for mode in eqs.modes]
    return ideal_sensor(
        "theta_F",
        {
            "theta": 1.0,
            "thetadot": K_R,
            "q1": -sigma[0],
            "q1dot": -K_R * sigma[0],
            "q2": -sigma[1],
            "q2dot": -K_R * sigma[1],
        },
    )


def linear_sensor(
    eqs: PerturbationEquations, name: str, K_z: float, sensor: float, b: float = 1.0
) -> control.StateSpace:
    """Return the elastic part of the linear sensor: -K_z (s + b)(phi_1 q_1 + phi_2 q_2) [Eq. 99].

    Parameters
    ----------
    eqs : PerturbationEquations
    name : str
        Of its output.
    K_z : float
        Displacement sensor gain (rad s/ft).
    sensor : float
        Station (ft).
    b : float
        Attitude-to-rate ratio (1/s).
    """
    phi = [K_z * mode.deflection(sensor) for mode in eqs.modes]
    return ideal_sensor(name, {"q1": -b * phi[0], "q1dot": -phi[0], "q2": -b * phi[1], "q2dot": -phi[1]})


def joined(name: str, blocks: Sequence[control.StateSpace], actuators: Sequence[str]) -> control.StateSpace:
    """Return blocks joined by signal name, from theta_c and alpha_g to the states and actuators.

    Parameters
    ----------
    name : str
        Of the closed loop.
    blocks : sequence of control.StateSpace
    actuators : sequence of str
        Outputs of the actuators.
    """
    outputs = [*STATES, *actuators]
    return control.interconnect(
        list(blocks),
        name=name,
        inputs=["theta_c", "alpha_g"],
        outputs=outputs,
        states=[f"x_{signal}" for signal in outputs],
        warn_duplicate=False,
    )


def without_input(vehicle: control.StateSpace, signal: str) -> control.StateSpace:
    """Return the vehicle without one of its inputs.

    Parameters
    ----------
    vehicle : control.StateSpace
    signal : str
        The input that is left out.
    """
    kept = [label for label in vehicle.input_labels if label != signal]
    return control.ss(
        vehicle.A,
        vehicle.B[:, [vehicle.input_labels.index(k) for k in kept]],
        vehicle.C,
        np.zeros((len(STATES), len(kept))),
        name="vehicle",
        inputs=kept,
        outputs=list(STATES),
        states=vehicle.state_labels,
    )
