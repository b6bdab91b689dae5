"""A ladder of truer models: the report's loops with hardware that it takes as ideal, rung by rung.

Rungs of the vehicle (orthogonal modes, more modes, other data) are other `PerturbationEquations`; rungs
of the loop are the fields of `Rung`.  `Rung()` is the report's own loop.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import NamedTuple

import control
import numpy as np

from rlswaim.practice.blocks import delay, first_order, gain, low_pass, notch, second_order
from rlswaim.practice.complementary import complementary
from rlswaim.practice.measurements import angle
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
    notch: float = 0.0
    """Damping ratio of a notch's poles at each mode's frequency, behind a gyro of the whole angle (1)."""
    high_pass: float = 0.0
    """Corner of a high-pass on the whole displacement, instead of its elastic part alone (rad/s)."""
    blend: float = 0.0
    """Corner of a complementary filter: below it the gyro's angle, above it the integral of a rate gyro's
    reading at a station of its own (rad/s)."""

    def __post_init__(self) -> None:
        """Check the numbers."""
        for field in fields(self):
            checks.not_negative(field.name, getattr(self, field.name), "Rung")


class Loop(NamedTuple):
    """A control system on one rung: the whole, and opened at the engine's command."""

    closed: control.StateSpace
    open: control.StateSpace


def vehicle_on(eqs: PerturbationEquations, rung: Rung, jet: float = JET_STATION) -> control.StateSpace:
    """Return the vehicle on a rung.

    From Newton's law in the vehicle's axes, with the steady pitch rate -level/U of the curved path::

        U alpha' = ... - level/U u        u' = level (alpha - theta) - drag u

    Gravity across the path is a term of the equations themselves (``gravity=True``).

    Parameters
    ----------
    eqs : PerturbationEquations
    rung : Rung
        Its level and drag count here.
    jet : float
        Station of the jet (ft).

    Returns
    -------
    control.StateSpace
        Inputs delta, delta_r, alpha_g; the outputs are the states of `PerturbationEquations.state_space`,
        with ``level`` the change of speed u (ft/s).
    """
    vehicle = eqs.state_space(jet)
    if not rung.level:
        return vehicle
    names = [*vehicle.output_labels, "u"]
    alpha, theta, u = (names.index(name) for name in ("alpha", "theta", "u"))
    A = np.pad(vehicle.A, ((0, 1), (0, 1)))
    A[alpha, u] = -rung.level / eqs.U**2
    A[u, [alpha, theta, u]] = rung.level, -rung.level, -rung.drag
    B = np.pad(vehicle.B, ((0, 1), (0, 0)))
    C, D = np.eye(len(names)), np.zeros_like(B)
    return control.ss(A, B, C, D, name="vehicle", inputs=vehicle.input_labels, outputs=names)


def _notches(eqs: PerturbationEquations, rung: Rung) -> list[control.StateSpace]:
    """Return a notch at each mode's own frequency; none if the rung has none."""
    zeta = constants("ladder")["notch_zeta_zeros"]
    return [notch(mode.omega, zeta, rung.notch) for mode in (eqs.modes if rung.notch else ())]


def reads_the_whole(rung: Rung) -> bool:
    """Return whether a gyro reads the whole angle on a ``rung``, as it has no ideal filter there."""
    return bool(rung.low_pass or rung.notch or rung.blend)


def _gyro(eqs: PerturbationEquations, rung: Rung, K_R: float, station: float | None) -> list:
    """Return the blocks from the vehicle's states to theta_F."""
    where = constants("ladder")["gyro_station"] if station is None and reads_the_whole(rung) else station
    row = angle(eqs, {} if where is None else {where: 1.0})
    row |= {f"{name}dot": K_R * value for name, value in row.items()}
    read = [gain([list(row.values())], name="gyro", inputs=list(row), outputs="theta_i")]
    if rung.blend and where is not None:
        read = complementary(eqs, rung.blend, K_R, where)
    c = constants("ladder")
    own, cut = low_pass(rung.gyro, c["gyro_zeta"]), low_pass(rung.low_pass, c["filter_zeta"])
    chain = control.series(own, cut, *_notches(eqs, rung))
    return [
        *read,
        control.ss(chain, name="gyro's filters", inputs="theta_i", outputs="theta_F"),
    ]


def _engine(rung: Rung, K_A: float, K_C: float) -> control.StateSpace:
    """Return the block from the engine's command to delta."""
    c = constants("ladder")
    chain = [first_order([K_A * K_C], [1.0, K_C]), low_pass(rung.actuator, c["actuator_zeta"])]
    if rung.delay:
        chain.append(delay(rung.delay, int(c["pade_order"])))
    return control.ss(control.series(gain(1.0), *chain), name="engine", inputs="command", outputs="delta")


def _displacement(
    eqs: PerturbationEquations, rung: Rung, K_z: float, b: float, sensor: float, output: str
) -> list:
    """Return the blocks from the vehicle's states to K_z (s + b) times the displacement (ft, down).

    The report's ideal filter leaves the elastic part alone, -phi_i q_i [Eq. 99].  Without it the sensor
    reads the whole rate z' + (l - l_CG) theta' - phi_i q_i', z' = U (alpha - theta), and the high-pass
    s^2/(s^2 + ...) turns the displacement into s (s + b)/(s^2 + ...) times this rate.
    """
    row: dict[str, float] = {}
    chain = gain(1.0)
    if rung.high_pass:
        row = {"alpha": eqs.U, "theta": -eqs.U, "thetadot": sensor - eqs.l_CG}
        omega = rung.high_pass
        chain = second_order([1.0, b, 0.0], [1.0, 2 * constants("ladder")["filter_zeta"] * omega, omega**2])
    for i, mode in enumerate(eqs.modes, start=1):
        row[f"q{i}dot"] = -mode.deflection(sensor)
        if not rung.high_pass:
            row[f"q{i}"] = -b * mode.deflection(sensor)
    read, names = [[K_z * value for value in row.values()]], list(row)
    return [
        gain(read, name=f"sensor {output}", inputs=names, outputs=f"{output}_e"),
        control.ss(chain, name=f"filter {output}", inputs=f"{output}_e", outputs=output),
    ]


def _jet_loop(
    eqs: PerturbationEquations, rung: Rung, kK_z: float, K_r: float, b: float, sensor: float
) -> list:
    """Return the blocks from the vehicle's states to the jet's force delta_r [Eq. 120]."""
    late = delay(rung.delay, int(constants("ladder")["pade_order"])) if rung.delay else gain(1.0)
    chain = control.series(first_order([K_r], [1.0, K_r]), late)
    return [
        *_displacement(eqs, rung, -kK_z, b, sensor, "z"),
        control.ss(chain, name="jet", inputs="z", outputs="delta_r"),
    ]


def _joined(
    name: str, vehicle: control.StateSpace, engine: control.StateSpace, rest: list, fed: str = "theta_F"
) -> Loop:
    """Return a system joined by the names of its signals, closed and opened at the engine's command."""
    jet = ["delta_r"] if any("delta_r" in block.output_labels for block in rest) else []
    error = control.summing_junction(["theta_c", f"-{fed}"], "command")
    outputs = [*vehicle.output_labels, "delta", *jet]
    settings = {"name": name, "warn_duplicate": False, "check_unused": False}
    return Loop(
        control.interconnect(
            [vehicle, engine, *rest, error], inputs=["theta_c", "alpha_g"], outputs=outputs, **settings
        ),
        control.interconnect([vehicle, engine, *rest], inputs=["command"], outputs=[fed], **settings),
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


def inner_loops_on(
    eqs: PerturbationEquations,
    rung: Rung,
    *,
    K_A: float,
    K_C: float,
    K_R: float,
    sensors: Mapping[float, float],
) -> Loop:
    """Return the control system of Section V or VI on a rung: linear sensors in inner loops to the engine.

    Parameters
    ----------
    eqs : PerturbationEquations
    rung : Rung
    K_A, K_C, K_R : float
        As in `rlswaim.single_sensor`.
    sensors : mapping of float to float
        Gain of each linear sensor (rad s/ft) by its station (ft).

    Returns
    -------
    Loop
        All its loops are opened at the one engine; theta_c is a command to the engine, K_A times the
        report's.
    """
    names = [f"z{i}" for i in range(len(sensors))]
    blocks = [
        block
        for name, (at, K_z) in zip(names, sensors.items(), strict=True)
        for block in _displacement(eqs, rung, K_z, 1.0, at, name)
    ]
    total = gain([[K_A, *np.ones(len(names))]], name="sum", inputs=["theta_F", *names], outputs="fed")
    rest = [*_gyro(eqs, rung, K_R, None), *blocks, total]
    return _joined("inner_loops", vehicle_on(eqs, rung), _engine(rung, 1.0, K_C), rest, "fed")


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
