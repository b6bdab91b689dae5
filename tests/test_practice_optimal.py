"""Optimal designs: separation, recovery, the bound of H-infinity, fixed structures."""

import control
import numpy as np
import pytest
from scipy.linalg import solve_continuous_are

from rlswaim.practice import designs, dispersed, monte_carlo, optimal, structures
from rlswaim.practice.h_infinity import h_infinity
from rlswaim.practice.hardware import Hardware, closed_loop
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.practice.margins import frequency_response
from rlswaim.practice.optimal import Wishes, design_plant, kalman, lqg, regulated, regulator

BOOSTER = dispersed.consistent_booster()
READ = (*gyros(60.0), Instrument("accelerometer", 27.0))
WISHES = Wishes(designs.BASE, recovery=1.0)


def test_poles_are_those_of_regulator_and_filter():
    whole = design_plant(BOOSTER, READ, 27.0)
    K, L = regulator(whole, WISHES, "attitude 60"), kalman(whole, READ, WISHES)
    rows = [whole.output_labels.index(one.name) for one in READ]
    n = whole.nstates
    A = np.block([[whole.A, np.zeros((n, 1))], [whole.C[rows[:1]], np.zeros((1, 1))]])
    B = np.vstack([whole.B[:, 1:], whole.D[rows[:1]][:, 1:]])
    wanted_poles = np.concatenate(
        [np.linalg.eigvals(A - B @ K), np.linalg.eigvals(whole.A - L @ whole.C[rows])]
    )
    found = closed_loop(whole, lqg(BOOSTER, READ, WISHES, 27.0)).poles()
    assert found.size == wanted_poles.size
    for pole in found:
        assert np.min(np.abs(wanted_poles - pole)) < 1e-3 * max(1.0, abs(pole))


def test_regulator_solves_riccatis_equation():
    whole = design_plant(BOOSTER, READ, 27.0)
    n = whole.nstates
    row = whole.output_labels.index("attitude 60")
    A = np.block([[whole.A, np.zeros((n, 1))], [whole.C[[row]], np.zeros((1, 1))]])
    B = np.vstack([whole.B[:, 1:], whole.D[[row], 1:]])
    Q = 1e-9 * np.eye(n + 1)
    Q[-1, -1] += WISHES.sizes["integral"] ** -2
    for name, size in WISHES.sizes.items():
        if name != "integral":
            weight = np.append(whole.C[whole.output_labels.index(name)], 0) / size
            Q += np.outer(weight, weight)
    R = np.diag(WISHES.commands(2) ** -2.0)
    P = solve_continuous_are(A, B, Q, R)
    exact = np.linalg.solve(R, B.T @ P)
    off = np.abs(regulator(whole, WISHES, "attitude 60") - exact)
    assert np.all(off < 1e-5 * np.abs(exact).max(axis=1, keepdims=True))


def test_regulated_loop_keeps_kalmans_inequality():
    """|1 + L| >= 1 at each command where the costs of the commands are apart; and its closed poles agree."""
    omega = np.geomspace(1e-3, 1e3, 300)
    closed = regulated(BOOSTER, READ, WISHES, 27.0)
    assert closed.poles().real.max() < 0
    for i in range(2):
        L = regulated(BOOSTER, READ, WISHES, 27.0, i)
        assert np.abs(1 + frequency_response(L, omega)[:, 0, 0]).min() > 1 - 1e-6
        again = np.linalg.eigvals(L.A - L.B @ L.C)
        assert all(np.min(np.abs(again - pole)) < 1e-5 * max(1.0, abs(pole)) for pole in closed.poles())


def test_recovery_brings_the_regulators_loop_back_with_two_gyros(monkeypatch):
    """Without the delay, whose zero right of the axis forbids it, LQG's loop at the engine goes to LQR's."""
    fast = Hardware(actuator_omega=40.0, gyro_omega=1e5, delay=1e-5)
    monkeypatch.setattr(optimal, "real_hardware", lambda: fast)
    two, omega = gyros(60.0, 304.0), np.array([0.3, 1.0, 3.0])
    whole = design_plant(BOOSTER, two, None)
    at = whole.output_labels.index("attitude 60")
    K, n = regulator(whole, designs.THRUST, "attitude 60"), whole.nstates
    A = np.block([[whole.A, np.zeros((n, 1))], [whole.C[[at]], np.zeros((1, 1))]])
    ideal = control.ss(A, np.vstack([whole.B[:, 1:], [[0.0]]]), K, 0)
    goal = frequency_response(ideal, omega)[:, 0, 0]
    off = []
    for recovery in (10.0, 100.0, 1000.0, 1e5):
        made = lqg(BOOSTER, two, Wishes(designs.BASE, recovery=recovery))
        loop = frequency_response(closed_loop(whole, made, "delta_c"), omega)[:, 0, 0]
        off.append(np.max(np.abs(loop - goal) / np.abs(goal)))
    assert off == sorted(off, reverse=True)
    assert off[-1] < 0.05


def test_h_infinity_keeps_its_bound():
    wishes = designs.BOUNDED
    made, bound = h_infinity(BOOSTER, READ, wishes, 27.0)
    whole = design_plant(BOOSTER, READ, 27.0)
    closed = closed_loop(whole, made)
    assert closed.poles().real.max() < 0
    at = [closed.output_labels.index(name) for name in wishes.sizes]
    omega = np.geomspace(1e-3, 1e2, 400)
    size = frequency_response(closed, omega)[:, at, 1] * wishes.gust / np.array([*wishes.sizes.values()])
    assert np.linalg.norm(size, axis=1).max() < bound


GAINS = {
    "command": 1.3, "K_A": 2.0, "K_C": 12.0, "K_R": 0.7, "low_pass": 25.0, "gyro": 200.0,
    "kK_z": 4e4, "K_r": 9.0, "b": 2.0, "washout": 0.1, "sensor": 30.0, "jet": 27.0,
}  # fmt: skip


def test_structure_of_section_vii_is_its_formula():
    s, g = 0.8j, GAINS
    engine = (
        g["K_A"]
        * g["K_C"]
        / (s + g["K_C"])
        * g["low_pass"] ** 2
        / (s**2 + 1.4 * g["low_pass"] * s + g["low_pass"] ** 2)
    )
    reads = [-1.0, -g["K_R"]]
    found = structures.section_vii(g)(s)
    assert np.allclose(found[0], engine * np.array([g["command"], *reads, 0.0]))
    jet = (
        -g["kK_z"]
        * g["K_r"]
        / (s + g["K_r"])
        * (s + g["b"])
        / (s**2 + 1.4 * g["washout"] * s + g["washout"] ** 2)
    )
    assert np.allclose(found[1], [*np.zeros(1 + len(reads)), jet])
    assert [one.kind for one in structures.section_vii_instruments(g)][-1] == "accelerometer"


def test_share_of_all_is_bounded_by_the_rule_of_three():
    low, high = monte_carlo.Spread(2000, 2000, {}, {}).share()
    assert high == 1.0
    assert low == pytest.approx(1 - 3.69 / 2000, abs=1e-5)
    assert monte_carlo.Spread(10, 0, {}, {}).share()[0] == 0.0
