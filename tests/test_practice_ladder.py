"""The ladder: its first rung is the report's loop, and each part goes over into the ideal one."""

from dataclasses import fields, replace

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import ladder, rungs
from rlswaim.practice.ladder import Rung
from rlswaim.practice.margins import frequency_response
from rlswaim.source.tables import constants

EQS = rl.printed_equations()
OMEGA = np.geomspace(0.01, 20, 60)
ATTITUDE = {"K_A": 3.0, "K_C": 10.0, "K_R": 0.6}
DUAL = {"K_A": 4.4545, "K_C": 8.4816, "K_R": 0.86417, "kK_z": -389252.5, "K_r": 94.027, "b": 2.62154}
STEPS = rungs.ladder_steps()
PLACES = {"sensor": 56.9915, "jet": 270.588}


def near(one, other, names=("theta", "q1", "delta"), rtol=1e-7):
    """Compare two loops' responses to the gust and to the command, output by output."""
    for name in names:
        found = [
            frequency_response(loop, OMEGA)[
                :,
                loop.output_labels.index(name),
                [loop.input_labels.index(i) for i in ("theta_c", "alpha_g")],
            ]
            for loop in (one, other)
        ]
        size = np.abs(found[1]).max()
        assert np.allclose(found[0], found[1], rtol=rtol, atol=rtol * size), name


@pytest.mark.parametrize("gyro", [None, 60.0])
def test_first_rung_is_section_iv(gyro):
    loop = ladder.rate_attitude_on(EQS, Rung(), **ATTITUDE, gyro=gyro)
    near(loop.closed, rl.rate_attitude(EQS, **ATTITUDE, gyro=gyro))


def test_first_rung_is_section_vii():
    loop = ladder.dual_actuation_on(EQS, Rung(), **DUAL, **PLACES)
    near(loop.closed, rl.dual_actuation(EQS, **DUAL, **PLACES), ("theta", "q2", "delta", "delta_r"))


@pytest.mark.parametrize("step", STEPS.values(), ids=list(STEPS))
def test_open_loop_belongs_to_the_closed_one(step):
    """1 + L is zero at each root of the whole that the gyro sees."""
    loop = ladder.dual_actuation_on(*step, **DUAL, **PLACES)
    closed = loop.closed.poles()
    returned = 1 / (1 + frequency_response(loop.open, OMEGA)[:, 0, 0])
    by_roots = np.array(
        [np.prod((1j * w - loop.open.poles()) / (1j * w - closed)) for w in OMEGA]
    )  # S is the ratio of the two characteristic polynomials
    assert np.allclose(returned, by_roots, rtol=1e-5)


BIG = {"actuator": 1e5, "gyro": 1e5, "low_pass": 1e5, "delay": 1e-6}


@pytest.mark.parametrize("name", BIG)
def test_part_that_is_fast_is_as_good_as_none(name):
    gyro = 60.0
    loop = ladder.rate_attitude_on(EQS, Rung(**{name: BIG[name]}), **ATTITUDE, gyro=gyro)
    near(loop.closed, rl.rate_attitude(EQS, **ATTITUDE, gyro=gyro), rtol=2e-3)


@pytest.mark.parametrize("gravity", [False, True])
def test_first_rungs_are_sections_v_and_vi(gravity):
    eqs = rl.printed_equations(gravity=gravity)
    gains = {"K_A": 3.0, "K_C": 10.0, "K_R": 0.6}
    one = ladder.inner_loops_on(eqs, Rung(), **gains, sensors={140.0: 0.05})
    two = ladder.inner_loops_on(eqs, Rung(), **gains, sensors={300.0: 0.04, 140.0: -0.03})
    V = rl.single_sensor(eqs, **gains, K_z=0.05, sensor=140)
    VI = rl.two_sensor(eqs, **gains, K_za=0.04, K_zb=-0.03, sensor_a=300, sensor_b=140)
    for ours, theirs in ((one, V), (two, VI)):
        assert np.allclose(np.sort_complex(ours.closed.poles()), np.sort_complex(theirs.poles()), atol=1e-6)


def test_high_pass_reads_the_whole_displacement():
    """Against transfer functions: K s (s + b)/(s^2 + 2 zeta w s + w^2) times z + (l - l_CG) theta - phi q."""
    rung, b, K, at = Rung(high_pass=0.3), 2.5, 7.0, 57.0
    blocks = ladder._displacement(EQS, rung, K, b, at, "z")
    vehicle = EQS.state_space()
    zeta = constants("ladder")["filter_zeta"]
    for s in (0.2j, 1.1j, 4j):
        x = dict(zip(vehicle.output_labels, vehicle(s)[:, 0], strict=True))
        whole = EQS.U * (x["alpha"] - x["theta"]) / s + (at - EQS.l_CG) * x["theta"]
        whole -= sum(m.deflection(at) * x[f"q{i}"] for i, m in enumerate(EQS.modes, start=1))
        wanted = K * s**2 * (s + b) / (s**2 + 2 * zeta * 0.3 * s + 0.09) * whole
        read = blocks[0].D @ [x[name] for name in blocks[0].input_labels]
        assert blocks[1](s) * read[0] == pytest.approx(wanted, rel=1e-9)


def test_path_and_speed_are_newtons_law():
    """The equations of a mass point in its own axes, in full, differ by the forces of the air alone."""
    g, gamma, U = 32.2, 0.9, EQS.U
    rung = Rung(level=g * np.cos(gamma), drag=0.004)
    eqs = replace(EQS, gravity=g * np.sin(gamma))
    vehicle = ladder.vehicle_on(eqs, rung)
    added = vehicle.A.copy()
    added[:7, :7] -= EQS.state_space().A
    steady_rate = -g * np.cos(gamma) / U

    def newton(u, w, theta):
        axial = g * np.sin(gamma) - 0.004 * (u - U)  # thrust less drag holds the steady speed
        return np.array(
            [
                axial - steady_rate * w - g * np.sin(gamma + theta),
                (steady_rate * u + g * np.cos(gamma + theta)) / U,
            ]
        )

    names = vehicle.output_labels
    for column, step in (("u", (1, 0, 0)), ("alpha", (0, U, 0)), ("theta", (0, 0, 1))):
        h = 1e-5 * np.array(step)
        slope = (newton(*(np.array([U, 0, 0]) + h)) - newton(*(np.array([U, 0, 0]) - h))) / 2e-5
        found = added[[names.index("u"), names.index("alpha")], names.index(column)]
        assert np.allclose(found, slope, atol=1e-8)


def test_pade_is_the_delay_where_the_loop_works():
    rung = Rung(delay=0.02)
    late = ladder.rate_attitude_on(EQS, rung, **ATTITUDE, gyro=60.0).open
    ideal = ladder.rate_attitude_on(EQS, Rung(), **ATTITUDE, gyro=60.0).open
    ratio = frequency_response(late, OMEGA)[:, 0, 0] / frequency_response(ideal, OMEGA)[:, 0, 0]
    assert np.allclose(ratio, np.exp(-0.02j * OMEGA), atol=1e-6)


@pytest.mark.parametrize("w", [0.05, 0.3, 2.0])
def test_complementary_filter_blends_two_gyros(w):
    """Against the transfer functions themselves, at complex frequencies."""
    K_R, at = 0.6, constants("ladder")["rate_station"]
    loop = ladder.rate_attitude_on(EQS, Rung(blend=w), K_A=3.0, K_C=10.0, K_R=K_R, gyro=60.0)
    for s in (0.1j, 0.9j, 3 + 2j):
        x = dict(zip(EQS.states, EQS.state_space()(s)[:, 0], strict=True))
        low, high = (
            x["theta"] - sum(m.slope(x_0) * x[f"q{i}"] for i, m in enumerate(EQS.modes, start=1))
            for x_0 in (60, at)
        )
        wanted = 30 / (s + 10) * (w / (s + w) * low + (1 / (s + w) + K_R) * s * high)
        assert loop.open(s) == pytest.approx(wanted, rel=1e-9)


def test_complementary_filter_of_one_angle_is_that_angle(monkeypatch):
    place = constants("ladder") | {"rate_station": 60.0}
    monkeypatch.setattr("rlswaim.practice.complementary.constants", lambda name: place)
    blended = ladder.rate_attitude_on(EQS, Rung(blend=0.3), **ATTITUDE, gyro=60.0)
    near(blended.closed, rl.rate_attitude(EQS, **ATTITUDE, gyro=60.0))


def test_steps_hold_every_part():
    assert STEPS["as printed"].rung == Rung()
    for field in fields(Rung):
        changed = [name for name, step in STEPS.items() if getattr(step.rung, field.name)]
        assert changed, field.name
        assert ("all of the loop, gravity" in changed) == (field.name not in ("level", "drag", "blend"))
    weights = {name for name, step in STEPS.items() if step.eqs.gravity}
    assert weights == {name for name in STEPS if name.startswith(("gravity", "path", "all"))}


def test_third_mode_is_orthogonal_and_oscillates_once_more():
    booster = rl.swaim_booster()
    mode = rungs.third_mode(booster)
    x, m = booster.stations, booster.masses
    phi = mode.deflection(x)
    others = [np.ones_like(x), x, *(one.deflection(x) for one in booster.modes)]
    for other in others:
        cosine = (m * phi) @ other / np.sqrt((m * phi) @ phi * ((m * other) @ other))
        assert abs(cosine) < 1e-9
    assert mode.mass == pytest.approx((m * phi) @ phi)
    assert mode.deflection(booster.thrust_station) == pytest.approx(1.0)
    assert len(mode.shape.roots(extrapolate=False)) == 4
    assert np.cosh(rungs.BETA_3) * np.cos(rungs.BETA_3) == pytest.approx(1.0, abs=0.01)
    assert mode.omega == pytest.approx(1.96 * booster.modes[1].omega)
    uniform = (rungs.BETA_3 / 7.8532046) ** 2
    assert uniform == pytest.approx(constants("ladder")["mode_3_ratio"], abs=0.005)


def test_refused():
    with pytest.raises(ValueError, match="delay in Rung: got -1, wanted 0 or more"):
        replace(Rung(), delay=-1.0)
    with pytest.raises(TypeError, match="gyro in Rung"):
        Rung(gyro="60")
