"""Instruments against derivatives, plants against blocks joined by name, dispersions against coefficients."""

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import dispersed
from rlswaim.practice.blocks import delay, gain, second_order
from rlswaim.practice.hardware import Hardware, closed_loop, plant, real_hardware
from rlswaim.practice.instruments import Instrument, gyros, reading
from rlswaim.source.tables import read_table

EQS = dispersed.with_gravity(dispersed.consistent_booster())
STATION = 100.0
S = 0.9j
VEHICLE = EQS.state_space(50.0)
STATES = dict(zip(VEHICLE.output_labels, VEHICLE(S), strict=True))


def _read(kind):
    row = reading(EQS, VEHICLE, Instrument(kind, STATION))
    n = VEHICLE.nstates
    return row[:n] @ np.array([STATES[name] for name in VEHICLE.output_labels]) + row[n:]


def _sum(rate, values):
    dot = "dot" if rate else ""
    return sum(value * STATES[f"q{i}{dot}"] for i, value in enumerate(values, start=1))


def test_readings_are_derivatives_of_the_axis():
    slopes, phis = (
        [f(STATION) for f in fs] for fs in zip(*((m.slope, m.deflection) for m in EQS.modes), strict=True)
    )
    attitude = STATES["theta"] - _sum(False, slopes)
    assert np.allclose(_read("attitude"), attitude)
    assert np.allclose(_read("rate"), S * attitude)
    arm = STATION - EQS.l_CG
    down = EQS.U * (STATES["alpha"] - STATES["theta"]) + arm * STATES["thetadot"] - _sum(True, phis)
    assert np.allclose(_read("accelerometer"), S * down + EQS.gravity * STATES["theta"])
    incidence = (
        STATES["alpha"] + arm / EQS.U * STATES["thetadot"] + _sum(False, slopes) - _sum(True, phis) / EQS.U
    )
    assert np.allclose(_read("vane"), incidence + np.eye(3)[VEHICLE.input_labels.index("alpha_g")])


GAINS = {"K_A": 1.8, "K_C": 10.0, "K_R": 0.618}
AUTOPILOT = control.ss(
    [[-10.0]], [[18.0, -18.0, -18 * 0.618]], [[1.0]], [[0.0, 0.0, 0.0]],
    inputs=["theta_c", "attitude 60", "rate 60"], outputs=["delta_c"],
)  # fmt: skip


def test_ideal_hardware_is_section_four():
    eqs = rl.printed_equations()
    found = closed_loop(plant(eqs, gyros(60.0), Hardware()), AUTOPILOT)
    wanted = rl.rate_attitude(eqs, **GAINS, gyro=60)
    shared = [found.output_labels.index(name) for name in wanted.output_labels]
    assert np.allclose(found(0.3j)[shared], wanted(0.3j))
    assert np.allclose(np.sort_complex(found.poles()), np.sort_complex(wanted.poles()))


def test_real_hardware_is_blocks_joined_by_name():
    made = real_hardware()
    low = [
        second_order([w**2], [1, 2 * z * w, w**2])
        for w, z in ((made.actuator_omega, made.actuator_zeta), (made.gyro_omega, made.gyro_zeta))
    ]
    engine = control.ss(low[0] * delay(made.delay, 3), inputs="delta_c", outputs="delta", name="engine")
    rows = np.array([reading(EQS, VEHICLE, one)[:7] for one in gyros(60.0)])
    raw = gain(rows, inputs=list(VEHICLE.output_labels), outputs=["a", "r"], name="raw")
    filters = [
        control.ss(low[1], inputs=i, outputs=o, name=o) for i, o in (("a", "attitude 60"), ("r", "rate 60"))
    ]
    vehicle = control.ss(VEHICLE, name="vehicle")
    joined = control.interconnect(
        [vehicle, engine, raw, *filters, control.ss(AUTOPILOT, name="K")],
        inputs=["theta_c", "alpha_g"], outputs=[*VEHICLE.output_labels, "delta"],
        check_unused=False, warn_duplicate=False,
    )  # fmt: skip
    found = closed_loop(plant(EQS, gyros(60.0)), AUTOPILOT)
    assert np.allclose(found(S)[:8], joined(S), rtol=1e-8)


def test_opened_loop_closes_at_the_poles():
    whole = plant(EQS, (*gyros(60.0), Instrument("accelerometer", 27.0)), jet=27.0)
    both = control.ss(
        [[-10.0, 0], [0, -2.0]], [[18.0, -18.0, -9.0, 0.0], [0, 0, 0, -1e3]], np.eye(2), np.zeros((2, 4)),
        inputs=["theta_c", "attitude 60", "rate 60", "accelerometer 27"], outputs=["delta_c", "delta_r_c"],
    )  # fmt: skip
    poles = closed_loop(whole, both).poles()
    for command in ("delta_c", "delta_r_c"):
        L = closed_loop(whole, both, command)
        for pole in poles[np.abs(poles) < 30]:
            assert abs(1 + L(pole)) < 1e-4 * (1 + abs(L(pole * 1.01)))


def test_controllers_with_unknown_signals_are_refused():
    with pytest.raises(ValueError, match="signal of the controller in closed_loop: got 'attitude 60'"):
        closed_loop(plant(EQS, gyros(61.0)), AUTOPILOT)
    with pytest.raises(ValueError, match="kind in Instrument: got 'compass'"):
        Instrument("compass", 1.0)
    with pytest.raises(ValueError, match="delay in Hardware: got -1"):
        Hardware(delay=-1.0)


def test_dispersions_multiply_what_they_name():
    own = dispersed.consistent_booster()
    same = dispersed.with_gravity(dispersed.dispersed(own, {}))
    assert dict(same.coefficients) == pytest.approx(dict(EQS.coefficients))
    heavy = dispersed.with_gravity(dispersed.dispersed(own, {"mass": 2.0}))
    assert heavy.coefficients["M_alpha"] == pytest.approx(EQS.coefficients["M_alpha"] / 2)
    airy = dispersed.with_gravity(dispersed.dispersed(own, {"q_D": 1.1}))
    assert airy.coefficients["Z_alpha"] == pytest.approx(1.1 * EQS.coefficients["Z_alpha"])
    with pytest.raises(ValueError, match="factor in dispersed: got 'drag'"):
        dispersed.dispersed(own, {"drag": 1.0})


def test_draws_are_within_their_spreads_and_do_not_depend_on_their_number():
    draws = [dispersed.drawn(i) for i in range(400)]
    assert dispersed.drawn(7) == draws[7]
    assert dispersed.drawn(7, seed=1) != draws[7]
    for row in read_table("dispersions"):
        values, spread = np.array([d[row["factor"]] for d in draws]), float(row["spread"])
        low, high = (1 / spread, spread) if row["kind"] == "log" else (1 - spread, 1 + spread)
        assert low <= values.min() < low + 0.1 * (high - low)
        assert high - 0.1 * (high - low) < values.max() <= high
