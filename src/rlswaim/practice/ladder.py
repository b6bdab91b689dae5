"""A ladder of truer models: the report's loops with hardware that it takes as ideal, rung by rung.

Rungs of the vehicle (orthogonal modes, more modes, other data) are other `PerturbationEquations`; rungs
of the loop are the fields of `Rung`.  `Rung()` is the report's own loop.
"""

from dataclasses import dataclass, fields
from typing import NamedTuple

import control
import numpy as np

from rlswaim.practice.blocks import delay, first_order, gain, second_order
from rlswaim.source import checks
from rlswaim.source.tables import constants
from rlswaim.vehicle.equations import JET_STATION, PerturbationEquations


@dataclass(frozen=True, kw_only=True)
class Rung:
    """What a loop has that the report's ideal one has not; 0 leaves a part ideal.

    Raises
    ------
    ValueError
        If a number is negative or not finite.
    TypeError
        If it is no real number.
    """

    gravity: float = 0.0
    """g sin gamma_0 across the path (ft/s^2) [Eq. 1], on top of what the equations have themselves."""
    level: float = 0.0
    """g cos gamma_0 (ft/s^2): the path curves by -level/U, and the speed u becomes a state."""
    drag: float = 0.0
    """Derivative of the drag by the speed, over the mass (1/s); counts with ``level`` alone."""
    actuator: float = 0.0
    """Frequency of a second-order actuator behind K_C/(s + K_C) (rad/s)."""
    gyro: float = 0.0
    """Frequency of the gyro's own second-order dynamics (rad/s)."""
    delay: float = 0.0
    """Delay of the engine's loop and of the jet's (s), by Pade's approximation."""
    low_pass: float = 0.0
    """Corner of a low-pass on the whole angle at the gyro, instead of the rigid angle alone (rad/s)."""
    high_pass: float = 0.0
    """Corner of a high-pass on the whole displacement, instead of its elastic part alone (rad/s)."""

    def __post_init__(self) -> None:
        """Check the numbers."""
        for field in fields(self):
            checks.not_negative(field.name, getattr(self, field.name), "Rung")


class Loop(NamedTuple):
    """A control system on one rung: the whole, and opened at the engine's command."""

    closed: control.StateSpace
    open: control.StateSpace


def rungs(g: float, gamma_0: float) -> dict[str, Rung]:
    """Return the ladder by name: each part alone, and all of them.

    Parameters
    ----------
    g : float
        Acceleration of gravity (ft/s^2).
    gamma_0 : float
        Flight path angle above the horizon (rad).

    Returns
    -------
    dict of str to Rung
        With the numbers of ``data/ladder.csv``; the drag is the middle of its range.
    """
    c = constants("ladder")
    gravity = {"gravity": g * np.sin(gamma_0)}
    parts = {
        "gravity": gravity,
        "path and speed": gravity | {"level": g * np.cos(gamma_0), "drag": c["drag"] / 2},
        "second-order actuator": {"actuator": c["actuator_omega"]},
        "gyro dynamics": {"gyro": c["gyro_omega"]},
        "delay": {"delay": c["delay"]},
        "realizable filters": {"low_pass": c["low_pass"], "high_pass": c["high_pass"]},
    }
    together = {name: value for part in parts.values() for name, value in part.items()}
    chosen = {"as printed": Rung()} | {name: Rung(**part) for name, part in parts.items()}
    return chosen | {"all of them": Rung(**together)}


def vehicle_on(eqs: PerturbationEquations, rung: Rung, jet: float = JET_STATION) -> control.StateSpace:
    """Return the vehicle on a rung.

    From Newton's law in the vehicle's axes, with the steady pitch rate -level/U of the curved path::

        U alpha' = ... - gravity theta - level/U u        u' = level (alpha - theta) - drag u

    Parameters
    ----------
    eqs : PerturbationEquations
    rung : Rung
        Its gravity, level and drag count here, and whether it has a high-pass.
    jet : float
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace
        Inputs delta, delta_r, alpha_g; the outputs are the states of `PerturbationEquations.state_space`,
        with ``level`` the change of speed u (ft/s), and where a high-pass needs it the displacement z (ft,
        down), z' = U (alpha - theta).  No loop of the report holds z, which leaves a root at 0.
    """
    vehicle = eqs.state_space(jet)
    more = [name for name, there in (("u", rung.level), ("z", rung.high_pass)) if there]
    names = [*vehicle.output_labels, *more]
    n = vehicle.nstates
    alpha, theta = names.index("alpha"), names.index("theta")
    A = np.zeros((len(names), len(names)))
    A[:n, :n] = vehicle.A
    A[alpha, theta] -= rung.gravity / eqs.U
    if rung.level:
        u = names.index("u")
        A[alpha, u] = -rung.level / eqs.U**2
        A[u, [alpha, theta, u]] = rung.level, -rung.level, -rung.drag
    if rung.high_pass:
        A[names.index("z"), [alpha, theta]] = eqs.U, -eqs.U
    B = np.vstack([vehicle.B, np.zeros((len(more), vehicle.ninputs))])
    C, D = np.eye(len(names)), np.zeros_like(B)
    return control.ss(A, B, C, D, name="vehicle", inputs=vehicle.input_labels, outputs=names)


def _filter(omega: float, low: bool, **names: str) -> control.StateSpace:
    """Return a second-order low-pass or high-pass with a corner, or a wire if the corner is 0."""
    if not omega:
        return gain(1.0, **names)
    poles = [1.0, 2 * constants("ladder")["filter_zeta"] * omega, omega**2]
    return second_order([omega**2] if low else [1.0, 0.0, 0.0], poles, **names)


def _gyro(eqs: PerturbationEquations, rung: Rung, K_R: float, station: float | None) -> list:
    """Return the blocks from the vehicle's states to theta_F."""
    where = constants("ladder")["gyro_station"] if station is None and rung.low_pass else station
    row = {"theta": 1.0, "thetadot": K_R}
    if where is not None:
        for i, mode in enumerate(eqs.modes, start=1):
            row |= {f"q{i}": -mode.slope(where), f"q{i}dot": -K_R * mode.slope(where)}
    zeta = constants("ladder")["gyro_zeta"]
    own = gain(1.0)
    if rung.gyro:
        own = second_order([rung.gyro**2], [1.0, 2 * zeta * rung.gyro, rung.gyro**2])
    chain = control.series(own, _filter(rung.low_pass, True))
    return [
        gain([list(row.values())], name="gyro", inputs=list(row), outputs="theta_i"),
        control.ss(chain, name="gyro's filters", inputs="theta_i", outputs="theta_F"),
    ]


def _engine(rung: Rung, K_A: float, K_C: float) -> control.StateSpace:
    """Return the block from the engine's command to delta."""
    c = constants("ladder")
    chain = [first_order([K_A * K_C], [1.0, K_C])]
    if rung.actuator:
        square = [1.0, 2 * c["actuator_zeta"] * rung.actuator, rung.actuator**2]
        chain.append(second_order([rung.actuator**2], square))
    if rung.delay:
        chain.append(delay(rung.delay, int(c["pade_order"])))
    return control.ss(control.series(gain(1.0), *chain), name="engine", inputs="command", outputs="delta")


def _jet_loop(
    eqs: PerturbationEquations, rung: Rung, kK_z: float, K_r: float, b: float, sensor: float
) -> list:
    """Return the blocks from the vehicle's states to the jet's force delta_r [Eq. 120].

    The elastic displacement counts -phi_i q_i, and the whole one z + (l - l_CG) theta beside it; with
    the ideal filter of the report the elastic part alone is read.
    """
    row: dict[str, float] = {}
    if rung.high_pass:
        arm = sensor - eqs.l_CG
        row = {"z": b, "alpha": eqs.U, "theta": b * arm - eqs.U, "thetadot": arm}
    for i, mode in enumerate(eqs.modes, start=1):
        row |= {f"q{i}": -b * mode.deflection(sensor), f"q{i}dot": -mode.deflection(sensor)}
    valve = first_order([K_r], [1.0, K_r])
    late = delay(rung.delay, int(constants("ladder")["pade_order"])) if rung.delay else gain(1.0)
    chain = control.series(_filter(rung.high_pass, False), valve, late)
    return [
        gain([[-kK_z * value for value in row.values()]], name="sensor", inputs=list(row), outputs="z_e"),
        control.ss(chain, name="jet", inputs="z_e", outputs="delta_r"),
    ]


def _joined(name: str, vehicle: control.StateSpace, engine: control.StateSpace, rest: list) -> Loop:
    """Return a system joined by the names of its signals, closed and opened at the engine's command."""
    jet = ["delta_r"] if any("delta_r" in block.output_labels for block in rest) else []
    error = control.summing_junction(["theta_c", "-theta_F"], "command")
    outputs = [*vehicle.output_labels, "delta", *jet]
    settings = {"name": name, "warn_duplicate": False, "check_unused": False}
    return Loop(
        control.interconnect(
            [vehicle, engine, *rest, error], inputs=["theta_c", "alpha_g"], outputs=outputs, **settings
        ),
        control.interconnect([vehicle, engine, *rest], inputs=["command"], outputs=["theta_F"], **settings),
    )


def rate_attitude_on(
    eqs: PerturbationEquations, rung: Rung, *, K_A: float, K_C: float, K_R: float, gyro: float | None
) -> Loop:
    """Return Section IV's control system on a rung.

    Parameters
    ----------
    eqs : PerturbationEquations
    rung : Rung
    K_A, K_C, K_R : float
        As in `rlswaim.rate_attitude`.
    gyro : float or None
        Station of the gyro (ft); None is the rigid angle alone, which a rung with a low-pass does not
        have: there the gyro stands where ``data/ladder.csv`` says.

    Returns
    -------
    Loop
    """
    return _joined(
        "rate_attitude", vehicle_on(eqs, rung), _engine(rung, K_A, K_C), _gyro(eqs, rung, K_R, gyro)
    )


def dual_actuation_on(
    eqs: PerturbationEquations,
    rung: Rung,
    *,
    K_A: float,
    K_C: float,
    K_R: float,
    kK_z: float,
    K_r: float,
    b: float,
    sensor: float,
    jet: float = JET_STATION,
) -> Loop:
    """Return Section VII's control system on a rung.

    Parameters
    ----------
    eqs : PerturbationEquations
    rung : Rung
    K_A, K_C, K_R, kK_z, K_r, b : float
        As in `rlswaim.dual_actuation`.
    sensor, jet : float
        Stations of the linear sensor and of the jet (ft).

    Returns
    -------
    Loop
        The jet's loop is closed in both.
    """
    rest = [*_gyro(eqs, rung, K_R, None), *_jet_loop(eqs, rung, kK_z, K_r, b, sensor)]
    return _joined("dual_actuation", vehicle_on(eqs, rung, jet), _engine(rung, K_A, K_C), rest)
