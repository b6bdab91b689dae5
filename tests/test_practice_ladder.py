"""The ladder: its first rung is the report's loop, and each part goes over into the ideal one."""

from dataclasses import fields, replace

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import ladder
from rlswaim.practice.ladder import Rung
from rlswaim.practice.margins import frequency_response

EQS = rl.printed_equations()
OMEGA = np.geomspace(0.01, 20, 60)
ATTITUDE = {"K_A": 3.0, "K_C": 10.0, "K_R": 0.6}
DUAL = {"K_A": 4.4545, "K_C": 8.4816, "K_R": 0.86417, "kK_z": -389252.5, "K_r": 94.027, "b": 2.62154}
RUNGS = ladder.rungs(32.2, 0.9)
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


@pytest.mark.parametrize("rung", RUNGS.values(), ids=list(RUNGS))
def test_open_loop_belongs_to_the_closed_one(rung):
    """1 + L is zero at each root of the whole that the gyro sees."""
    loop = ladder.dual_actuation_on(EQS, rung, **DUAL, **PLACES)
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


def test_gravity_is_eq_1s_term():
    """U (alpha' - theta') has -g sin(gamma_0) theta beside the forces: the determinant by hand."""
    g = 20.0
    poles = ladder.vehicle_on(EQS, Rung(gravity=g)).poles()
    matrix = EQS.matrix.copy()
    matrix[0, 1, 0] += g
    for pole in poles[np.abs(poles) > 1e-6]:
        at = matrix @ (pole ** np.arange(3))
        assert np.abs(np.linalg.svd(at / np.abs(at).max(axis=1, keepdims=True))[1][-1]) < 1e-8


def test_path_and_speed_are_newtons_law():
    """The equations of a mass point in its own axes, in full, differ by the forces of the air alone."""
    g, gamma, U = 32.2, 0.9, EQS.U
    rung = Rung(gravity=g * np.sin(gamma), level=g * np.cos(gamma), drag=0.004)
    vehicle = ladder.vehicle_on(EQS, rung)
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


def test_high_pass_lets_the_rigid_motion_through():
    """A sensor of the whole displacement reads z + (l - l_CG) theta - phi q."""
    vehicle = ladder.vehicle_on(EQS, Rung(high_pass=0.3))
    s = 0.5j
    outputs = dict(zip(vehicle.output_labels, vehicle(s)[:, 0], strict=True))
    assert s * outputs["z"] == pytest.approx(EQS.U * (outputs["alpha"] - outputs["theta"]))
    ideal, true = (
        ladder.dual_actuation_on(EQS, Rung(high_pass=corner), **DUAL, **PLACES).closed.poles().real.max()
        for corner in (0.0, 0.3)
    )
    assert ideal < 1e-7
    assert true > 1.0  # this design stands on the ideal filter


def test_rungs_hold_every_part_once():
    assert RUNGS["as printed"] == Rung()
    for field in fields(Rung):
        changed = [name for name, rung in RUNGS.items() if getattr(rung, field.name)]
        assert len(changed) == (3 if field.name == "gravity" else 2)
        assert changed[-1] == "all of them"


def test_refused():
    with pytest.raises(ValueError, match="delay in Rung: got -1, wanted 0 or more"):
        replace(Rung(), delay=-1.0)
    with pytest.raises(TypeError, match="gyro in Rung"):
        Rung(gyro="60")
