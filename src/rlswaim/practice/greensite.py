"""Somebody else's vehicle: Greensite's launch vehicle at t = 72 s, as a course project recomputed it, in SI.

With z the drift (m), theta the pitch angle, eta the bending mode, alpha_w the incidence of the wind::

    z''     = a1 z' + (a1 V + a4) theta + a3 delta - a1 V alpha_w
    theta'' = A6/V z' + A6 theta + K1 delta - A6 alpha_w
    eta''   = -omega^2 eta - 2 zeta omega eta' - phi_tvc T_c delta
    delta   = W (-K_p theta_m - K_d theta_m' - K_z z_m - K_zdot z_m')
    theta_m = theta + sigma_ins eta        z_m = z - phi_ins eta

W is the actuator, the delay of 20 ms by Pade's approximation of order 3, and the notch.

How the symbols go over into those of the report (here z counts up with theta, there down, so the
incidence is theta + z'/V - alpha_w here and alpha + alpha_g there):

    A6 = -M_alpha        a1 V = -Z_alpha (z up)       a3 = the engine's force over M  = |Z_delta|
    K1 = -M_delta        V = U                        phi_tvc T_c = |F1_delta|
    a4 = -(axial acceleration): theta turns the thrust less drag across the path

a4 has no counterpart in Eq. 29, whose axes turn with the vehicle: z'' here is V (theta' - alpha') there.
M_thetadot and the air's forces on and by the mode (M_q1, M_q1dot, F1_alpha ...) are zero here: the mode
is driven by the engine alone and drives nothing but the instruments.
"""

from dataclasses import asdict, replace
from typing import Any

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.practice import criteria
from rlswaim.practice.blocks import delay, gain, notch, second_order
from rlswaim.source import checks
from rlswaim.source.tables import constants

RIGID = ("z", "zdot", "theta", "thetadot")
MODE = ("eta", "etadot")
GAINS = ("K_p", "K_d", "K_z", "K_zdot", "k")
FOOT = 0.3048
"""Metres."""


def vehicle(
    mu_alpha: float = 1.0, mu_c: float = 1.0, omega: float = 1.0, bending: bool = True
) -> control.StateSpace:
    """Return Greensite's vehicle without its loop.

    Parameters
    ----------
    mu_alpha, mu_c : float
        Factors of A6 and of K1 (1).
    omega : float
        Factor of the mode's frequency (1).
    bending : bool
        Whether the bending mode is there.

    Returns
    -------
    control.StateSpace
        Inputs delta, alpha_w (rad); the outputs are the states z, zdot, theta, thetadot, and with the
        mode eta, etadot (m, rad, s).

    Raises
    ------
    ValueError
        If a factor of the air or of the engine is not finite, or that of the mode is not positive.
    TypeError
        If a factor is not a real number, or ``bending`` no bool.
    """
    where = "greensite"
    checks.instance("bending", bending, bool, where)
    c = constants("greensite")
    A6 = checks.real("mu_alpha", mu_alpha, where) * c["A6"]
    K1 = checks.real("mu_c", mu_c, where) * c["K1"]
    frequency = checks.positive("omega", omega, where) * c["omega"]
    a1V = c["a1"] * c["V"]
    states = (*RIGID, *(MODE if bending else ()))
    A, B = np.zeros((6, 6)), np.zeros((6, 2))
    A[[0, 2, 4], [1, 3, 5]] = 1.0
    A[1, 1:3], B[1] = (c["a1"], a1V + c["a4"]), (c["a3"], -a1V)
    A[3, 1:3], B[3] = (A6 / c["V"], A6), (K1, -A6)
    A[5, 4:], B[5] = (-(frequency**2), -2 * c["zeta"] * frequency), (-c["phi_tvc"] * c["T_c"], 0.0)
    n = len(states)
    return control.ss(
        A[:n, :n],
        B[:n],
        np.eye(n),
        np.zeros((n, 2)),
        name="vehicle",
        inputs=["delta", "alpha_w"],
        outputs=list(states),
        states=[f"x_{s}" for s in states],
    )


def _feedback(states: list[str], K_p: float, K_d: float, K_z: float, K_zdot: float, k: float) -> NDArray:
    """Return the row that makes the signal of the autopilot from the vehicle's states."""
    c = constants("greensite")
    row = {"z": K_z, "zdot": K_zdot, "theta": K_p, "thetadot": K_d}
    row["eta"] = c["sigma_ins"] * K_p - c["phi_ins"] * K_z
    row["etadot"] = c["sigma_ins"] * K_d - c["phi_ins"] * K_zdot
    return k * np.array([[row[state] for state in states]])


def _engine(actuator: bool, notched: bool) -> list[control.StateSpace]:
    """Return the blocks of W from signal "command" to signal "delta"; the notch keeps the nominal omega."""
    c = constants("greensite")
    blocks = []
    if actuator:
        bandwidth = c["omega_tvc"]
        blocks.append(second_order([bandwidth**2], [1.0, c["damping_tvc"], bandwidth**2]))
        blocks.append(delay(c["delay"], int(c["pade_order"])))
    if notched:
        blocks.append(notch(c["omega"], c["zeta_notch_zeros"], c["zeta_notch_poles"]))
    return blocks or [gain(1.0)]


def _parts(**given: Any) -> tuple[control.StateSpace, control.StateSpace, control.StateSpace]:
    """Return vehicle, W and the autopilot's row, joined by the names delta, command and signal."""
    plant = vehicle(*(given[name] for name in ("mu_alpha", "mu_c", "omega", "bending")))
    gains = [checks.real(name, given[name], "greensite") for name in GAINS]
    for name in ("notch", "actuator"):
        checks.instance(name, given[name], bool, "greensite")
    engine = control.series(*_engine(given["actuator"], given["notch"]))
    states = list(plant.output_labels)
    row = _feedback(states, *gains)
    return (
        plant,
        control.ss(engine, name="W", inputs="command", outputs="delta"),
        gain(row, name="autopilot", inputs=states, outputs="signal"),
    )


def greensite(
    *,
    K_p: float,
    K_d: float,
    K_z: float = -1e-3,
    K_zdot: float = -1e-3,
    notch: bool = True,
    mu_alpha: float = 1.0,
    mu_c: float = 1.0,
    omega: float = 1.0,
    bending: bool = True,
    actuator: bool = True,
    k: float = 1.0,
) -> control.StateSpace:
    """Return the open loop L(s) of Greensite's launch vehicle at t = 72 s, for negative feedback, in SI.

    Parameters
    ----------
    K_p : float
        Gain of the pitch angle (rad/rad).
    K_d : float
        Gain of the pitch rate (s).
    K_z : float
        Gain of the drift (rad/m).
    K_zdot : float
        Gain of the drift rate (rad s/m).
    notch : bool
        Whether the notch filter at 18.9 rad/s is in the loop.
    mu_alpha : float
        Factor of A6, the moment of the air (1).
    mu_c : float
        Factor of K1, the moment of the engine (1).
    omega : float
        Factor of the mode's frequency (1); the notch stays where it is.
    bending : bool
        Whether the bending mode is there; without it the vehicle is rigid.
    actuator : bool
        Whether actuator and delay are there; the printed rigid case has neither.
    k : float
        Factor of all four gains (1).

    Returns
    -------
    control.StateSpace
        From the command of the engine to the signal that is subtracted from it; the loop closes with
        1 + L(s) = 0.

    Raises
    ------
    ValueError
        If a number is not finite, or the factor of the mode's frequency is not positive.
    TypeError
        If a number is not real, or a switch is no bool.

    Notes
    -----
    The printed rigid case is ``bending=False, actuator=False, notch=False``.  `closed_loop` takes the same
    arguments and has the wind as its input; `agreement.gust_peaks` puts it through a gust of any size.
    """
    plant, engine, autopilot = _parts(**locals())
    loop = control.series(engine, plant[:, 0], autopilot)
    return control.ss(loop, name="greensite", inputs="command", outputs="signal")


def closed_loop(**given: Any) -> control.StateSpace:
    """Return the closed loop of `greensite`, with the same arguments.

    Parameters
    ----------
    **given
        As in `greensite`.

    Returns
    -------
    control.StateSpace
        Input alpha_w (rad); outputs the vehicle's states, delta (rad) and alpha, the incidence
        theta + z'/V - alpha_w (rad).
    """
    plant, engine, autopilot = _parts(**((greensite.__kwdefaults__ or {}) | given))
    states = list(plant.output_labels)
    V = constants("greensite")["V"]
    row = np.array([[{"theta": 1.0, "zdot": 1 / V}.get(state, 0.0) for state in states] + [-1.0]])
    blocks = [
        plant,
        engine,
        autopilot,
        control.summing_junction(["-signal"], "command"),
        gain(row, name="incidence", inputs=[*states, "alpha_w"], outputs="alpha"),
    ]
    return control.interconnect(
        blocks, name="greensite", inputs=["alpha_w"], outputs=[*states, "delta", "alpha"]
    )


def wanted_in_metres(want: criteria.Wanted) -> dict[str, float]:
    """Return what is ``want``ed by name, with drift_m_s and gust_m_s in place of drift_ft_s and gust_ft_s."""
    speeds = {name.replace("_ft_", "_m_"): FOOT * getattr(want, name) for name in ("drift_ft_s", "gust_ft_s")}
    return {name: size for name, size in asdict(want).items() if "_ft_" not in name} | speeds


def judged(**given: Any) -> tuple[criteria.Criterion, ...]:
    """Return the criteria of chapter XVI for the closed loop of `greensite`, with the same arguments.

    Parameters
    ----------
    **given
        As in `greensite`.

    Returns
    -------
    tuple of Criterion
        The drift in m/s; nothing settles, as nothing commands the pitch angle, and no bending moment is
        known, as the source tells no masses along the vehicle.
    """
    c, closed = constants("greensite"), closed_loop(**given)
    rows = {name: closed.C[i] for i, name in enumerate(closed.output_labels)}
    # Here the gust is an incidence from the other side, and alpha leaves it out.
    alone = control.ss(
        closed.A,
        -closed.B,
        np.vstack([rows["theta"] + rows["zdot"] / c["V"], rows["theta"], rows["delta"]]),
        np.zeros((3, 1)),
        inputs="alpha_g",
        outputs=["alpha", "theta", "delta"],
    )
    modes = {"bending 1": given.get("omega", 1.0) * c["omega"]}
    found = criteria.evaluate(alone, c["V"] / FOOT, greensite(**given), modes)
    return tuple(map(_in_metres, found))


def _in_metres(found: criteria.Criterion) -> criteria.Criterion:
    """Return a criterion with metres for feet."""
    if found.unit != "ft/s":
        return found
    name = found.name.replace("_ft_", "_m_")
    return replace(found, name=name, value=FOOT * found.value, wanted=FOOT * found.wanted, unit="m/s")
