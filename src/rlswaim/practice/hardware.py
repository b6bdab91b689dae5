"""A vehicle with the hardware that a controller meets: engine, jet, delay, gyros, accelerometers, a vane.

A controller is a state space of its own.  Its inputs are theta_c and the names of the instruments, its
outputs are the commands delta_c (rad) and, with a jet, delta_r_c (lb).
"""

from dataclasses import dataclass, fields
from functools import cache, lru_cache

import control
import numpy as np

from rlswaim.practice.blocks import delay, gain, low_pass
from rlswaim.practice.instruments import GYRO, Instrument, reading
from rlswaim.source import checks
from rlswaim.source.tables import constants
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations

COMMANDS = {"delta_c": "delta", "delta_r_c": "delta_r"}
"""Each command, and what follows it."""


@dataclass(frozen=True)
class Hardware:
    """Engine and gyros of second order, and the delay between a reading and the command; 0 is ideal.

    Raises
    ------
    ValueError
        If a number is negative or not finite.
    """

    actuator_omega: float = 0.0
    """Of the engine (rad/s)."""
    actuator_zeta: float = 0.7
    gyro_omega: float = 0.0
    """Of each gyro (rad/s)."""
    gyro_zeta: float = 0.7
    delay: float = 0.0
    """In both commands (s), by Pade's approximation."""
    pade_order: float = 3

    def __post_init__(self) -> None:
        """Check the numbers."""
        for field in fields(self):
            checks.not_negative(field.name, getattr(self, field.name), "Hardware")


@cache
def real_hardware() -> Hardware:
    """Return the hardware of ``data/ladder.csv``."""
    given = constants("ladder")
    return Hardware(**{field.name: given[field.name] for field in fields(Hardware)})


@cache
def _effector(hardware: Hardware, omega: float) -> control.StateSpace:
    """Return the way from a command to what follows it, with an actuator of a frequency (rad/s; 0: none)."""
    late = delay(hardware.delay, int(hardware.pade_order)) if hardware.delay else gain(1.0)
    return control.series(late, low_pass(omega, hardware.actuator_zeta))


@lru_cache(maxsize=16)
def plant(
    eqs: PerturbationEquations,
    instruments: tuple[Instrument, ...],
    hardware: Hardware | None = None,
    jet: float | None = None,
) -> control.StateSpace:
    """Return what a controller sees: the vehicle with its effectors and instruments.

    Parameters
    ----------
    eqs : PerturbationEquations
    instruments : tuple of Instrument
    hardware : Hardware, optional
        That of `real_hardware` without it.
    jet : float, optional
        Station of the jet (ft); no jet without it.

    Returns
    -------
    control.StateSpace
        Inputs alpha_g, delta_c and with a jet delta_r_c.  Outputs the vehicle's states, delta, with a jet
        delta_r, and each instrument by its name.
    """
    made = hardware or real_hardware()
    vehicle = eqs.state_space(JET_STATION if jet is None else jet)
    used = ["delta", *(["delta_r"] if jet is not None else [])]
    kept = [vehicle.input_labels.index(name) for name in ("alpha_g", *used)]
    n, m = vehicle.nstates, len(used)
    rows = np.array([reading(eqs, vehicle, one) for one in instruments]).reshape(-1, n + vehicle.ninputs)
    C = np.vstack([np.eye(n), np.zeros((m, n)), rows[:, :n]])
    passed = np.hstack([np.zeros((m, 1)), np.eye(m)])
    D = np.vstack([np.zeros((n, 1 + m)), passed, rows[:, n:][:, kept]])
    inner = control.ss(vehicle.A, vehicle.B[:, kept], C, D)
    effectors = [_effector(made, made.actuator_omega), _effector(made, 0.0)][:m]
    before = control.append(gain(1.0), *effectors)
    gyro = low_pass(made.gyro_omega, made.gyro_zeta)
    after = [gyro if one.kind in GYRO else gain(1.0) for one in instruments]
    whole = control.append(gain(np.eye(n + m)), *after) * inner * before
    return control.ss(
        whole,
        name="plant",
        inputs=["alpha_g", *[c for c, follows in COMMANDS.items() if follows in used]],
        outputs=[*vehicle.output_labels, *used, *(one.name for one in instruments)],
    )


def _lifted(
    whole: control.StateSpace, controller: control.StateSpace, opened: str | None
) -> control.StateSpace:
    """Return the plant with the inputs and outputs of a controller last, as its linear fraction wants them.

    With ``opened`` that command comes from outside, and what the controller commands is an output.
    """
    given = list(whole.input_labels)
    signals, commands = list(controller.input_labels), list(controller.output_labels)
    outside = ["theta_c", "alpha_g", *([opened] if opened else [])]
    inputs = [*outside, *(f"K {c}" for c in commands)]
    outputs = [*whole.output_labels, *([f"K {opened}"] if opened else []), *(f"K {s}" for s in signals)]
    enters = np.zeros((len(given), len(inputs)))
    for i, name in enumerate(given):
        direct = name in ("alpha_g", opened)
        enters[i, inputs.index(name if direct else f"K {name}")] = 1.0
    C, D = np.zeros((len(outputs), whole.nstates)), np.zeros((len(outputs), len(inputs)))
    DB = whole.D @ enters
    for i, name in enumerate(outputs):
        source = name.removeprefix("K ")
        if source == "theta_c":
            D[i, 0] = 1.0
        elif source == opened:
            D[i, inputs.index(f"K {opened}")] = 1.0
        else:
            at = list(whole.output_labels).index(source)
            C[i], D[i] = whole.C[at], DB[at]
    return control.ss(whole.A, whole.B @ enters, C, D, inputs=inputs, outputs=outputs)


def closed_loop(
    whole: control.StateSpace, controller: control.StateSpace, opened: str | None = None
) -> control.StateSpace:
    """Return a plant under a controller.

    Parameters
    ----------
    whole : control.StateSpace
        From `plant`.
    controller : control.StateSpace
        Inputs theta_c and instruments, outputs commands, by their names.
    opened : str, optional
        A command at which the loop is opened instead.

    Returns
    -------
    control.StateSpace
        From theta_c and alpha_g to the plant's outputs; opened, the loop L for 1 + L = 0.

    Raises
    ------
    ValueError
        If the controller reads or commands what the plant has not.
    """
    for name in (*controller.input_labels, *controller.output_labels):
        known = ["theta_c", *whole.input_labels, *whole.output_labels]
        checks.one_of("signal of the controller", name, known, "closed_loop")
    signals, commands = controller.ninputs, controller.noutputs
    lifted = _lifted(whole, controller, opened)
    joined = lifted.lft(controller, commands, signals)
    if opened:
        return control.ss(joined.A, joined.B[:, [2]], -joined.C[[-1]], -joined.D[[-1]][:, [2]])
    return control.ss(joined, inputs=["theta_c", "alpha_g"], outputs=list(whole.output_labels))
