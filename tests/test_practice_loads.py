"""Bending moments: zero at both free ends, the same from fore and from aft, and in balance with the modes."""

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import loads
from rlswaim.vehicle.other_data import own_data, with_data, with_other_data

BOOSTER = rl.swaim_booster().recomputed().orthogonalized()
EQS = rl.perturbation_equations(BOOSTER)
GAINS = {"K_A": 4.45, "K_C": 8.48, "K_R": 0.864, "kK_z": -389252.0, "K_r": 94.0, "b": 2.62}
CUTS = np.arange(0.0, 420.1, 10.0)
FOUND = loads.section_loads(BOOSTER, EQS, CUTS, 140.0)
SIZE = np.abs(FOUND.moment).max(axis=0)


def test_free_ends_carry_nothing():
    assert not FOUND.moment[0].any()
    assert not FOUND.shear[0].any()
    used = SIZE > 0
    assert used.sum() == len(FOUND.columns) - 1  # theta alone bends nothing
    assert np.all(np.abs(FOUND.end_moment[used]) < 1e-9 * SIZE[used])
    assert np.all(np.abs(FOUND.end_shear) < 1e-9 * np.abs(FOUND.shear).max(axis=0) + 1e-6)


def test_jets_force_at_any_station_is_balanced():
    for jet in (30.0, 200.0, 400.0):
        found = loads.section_loads(BOOSTER, EQS, CUTS, jet)
        at = found.columns.index("delta_r")
        assert abs(found.end_moment[at]) < 1e-9 * np.abs(found.moment[:, at]).max()


def test_printed_vehicle_does_not_balance():
    found = loads.section_loads(rl.swaim_booster(), rl.printed_equations(), CUTS)
    size = np.abs(found.moment).max(axis=0)
    assert np.max(np.abs(found.end_moment[size > 0]) / size[size > 0]) > 0.01


def test_moment_grows_by_the_shear():
    """Between masses the moment is straight, but for the axial force on the bent axis."""
    cuts = np.array([300.0, 310.0, 320.0])
    found = loads.section_loads(BOOSTER, EQS, cuts)
    at = found.columns.index("delta")
    assert np.allclose(np.diff(found.moment[:, at]) / 10, found.shear[0, at])


@pytest.mark.parametrize("mode", [0, 1])
def test_forces_do_on_each_mode_what_its_spring_and_damper_resist(mode):
    """Sum of -phi times all forces = m (omega^2 q + 2 zeta omega q'), from the steps of the shear."""
    places = np.unique([*BOOSTER.stations, *(s.station for s in BOOSTER.surfaces), 140.0])
    cuts = np.concatenate([places - 1e-6, places + 1e-6])
    found = loads.section_loads(BOOSTER, EQS, cuts, 140.0)
    steps = found.shear[places.size :] - found.shear[: places.size]
    shape = BOOSTER.modes[mode]
    thrust = found.end_shear - steps.sum(axis=0)
    work = -shape.deflection(places) @ steps - shape.deflection(BOOSTER.thrust_station) * thrust
    wanted = np.zeros(len(found.columns))
    wanted[found.columns.index(f"q{mode + 1}")] = shape.mass * shape.omega**2
    wanted[found.columns.index(f"q{mode + 1}dot")] = shape.mass * 2 * shape.zeta * shape.omega
    assert np.allclose(work, wanted, rtol=1e-8, atol=1e-3 * shape.mass * 1e-6)


def test_a_rigid_bar_pushed_at_its_end():
    """No air and no motion yet: the engine's push bends as inertia resists, m (T delta)(a + b x)."""
    at = FOUND.columns.index("delta")
    x, m, G = BOOSTER.stations, BOOSTER.masses, BOOSTER.thrust_station
    arm = G - BOOSTER.l_CG
    rigid = 1 / BOOSTER.M + arm / BOOSTER.I_y * (x - BOOSTER.l_CG)
    bent = sum(
        mode.deflection(x) * mode.deflection(G) / mode.mass for mode in BOOSTER.modes
    )  # the modes give way at once
    ahead = np.maximum(CUTS[:, None] - x, 0)
    wanted = -BOOSTER.T * ahead @ (m * (rigid + bent))
    assert np.allclose(FOUND.moment[:, at], wanted, rtol=1e-9, atol=1e-9 * SIZE[at])


def test_closed_loop_with_moments():
    closed = rl.rate_attitude(EQS, K_A=3.0, K_C=10.0, K_R=0.6, gyro=None)
    found = loads.section_loads(BOOSTER, EQS, [100.0, 250.0])
    system = loads.with_moments(closed, found)
    assert system.output_labels[-2:] == ["moment 100", "moment 250"]
    s = 0.7j
    outputs = dict(zip(system.output_labels, system(s)[:, system.input_labels.index("alpha_g")], strict=True))
    by_hand = sum(
        found.moment[1, i] * (1.0 if name == "alpha_g" else outputs.get(name, 0.0))
        for i, name in enumerate(found.columns)
    )
    assert outputs["moment 250"] == pytest.approx(by_hand)


def test_refused():
    with pytest.raises(
        TypeError, match="booster in section_loads: got PerturbationEquations, wanted Booster"
    ):
        loads.section_loads(EQS, EQS, CUTS)
    with pytest.raises(ValueError, match=r"stations\[0\] in section_loads: got nan"):
        loads.section_loads(BOOSTER, EQS, [np.nan])


@pytest.mark.parametrize("data", [{}, {"q_D": 300.0, "C_payload": 0.5, "C_fins": 2.0, "omega_1": 5.0}])
def test_moment_is_the_sum_of_its_terms_for_other_data_too(data):
    booster = rl.swaim_booster()
    eqs = with_other_data(rl.printed_equations(), gravity=bool(data), **data)
    changed = with_data(booster, **data)
    loop = rl.dual_actuation(eqs, **GAINS, sensor=57.0, jet=150.0)
    wanted = loads.with_moments(loop, loads.section_loads(changed, eqs, [200.0], 150.0))
    given = {**own_data(changed), "gravity": eqs.gravity, "lever": 50.0}
    for s in (0.3j, 2j, 1 + 20j):
        at = dict(zip(loop.output_labels, loop(s)[:, loop.input_labels.index("alpha_g")], strict=True))
        at["alpha_g"] = 1.0
        terms = loads.moment_terms(booster, eqs, 200.0)
        found = sum(
            t.weight * np.prod([given[f] for f in t.factors]) * s**t.order * at[t.quantity] for t in terms
        )
        moment = wanted(s)[wanted.output_labels.index("moment 200"), loop.input_labels.index("alpha_g")]
        assert found == pytest.approx(moment, rel=1e-9)
