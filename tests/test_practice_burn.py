"""The burn against the ascent, orthogonality, balance of loads and a simulation of another kind."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from rlswaim.practice import burn, dispersed, gusts, loads, schedule_search
from rlswaim.practice.designs import NOSE
from rlswaim.practice.dispersed import with_gravity
from rlswaim.practice.hardware import closed_loop, plant
from rlswaim.vehicle.modes import generalized_mass, rotation_product, translation_product
from rlswaim.vehicle.trajectory import swaim_ascent

TIMES = (20.0, 57.5, 95.0)


@pytest.mark.parametrize("t", TIMES)
def test_masses_add_up_to_the_ascents(t):
    assert burn.masses_at(t).sum() == pytest.approx(float(swaim_ascent().mass(t)), rel=1e-3)
    assert burn.masses_at(t).min() > 0


def test_vehicle_at_its_own_time_is_the_consistent_one():
    own, found = dispersed.consistent_booster(), burn.booster_at(57.5)
    for one, other in zip(own.modes, found.modes, strict=True):
        assert other.omega == pytest.approx(one.omega)
        assert np.allclose(one.deflections, other.deflections)
    assert (found.M, found.l_CG, found.I_y) == pytest.approx((own.M, own.l_CG, own.I_y))


@pytest.mark.parametrize("t", TIMES)
def test_modes_are_orthogonal_and_rayleighs_quotient_is_their_frequency(t):
    booster, own = burn.booster_at(t), dispersed.consistent_booster()
    m, phi = booster.masses, [mode.deflection(booster.stations) for mode in booster.modes]
    size = generalized_mass(m, phi[0], phi[0])
    assert abs(generalized_mass(m, *phi)) < 1e-6 * size
    for mode, shape in zip(booster.modes, phi, strict=True):
        assert generalized_mass(m, shape, shape) == pytest.approx(mode.mass)
        assert abs(translation_product(m, shape)) < 1e-6 * np.abs(m * shape).sum()
        assert abs(rotation_product(m, shape, booster.arms)) < 1e-6 * np.abs(m * shape * booster.arms).sum()
        line = np.column_stack(
            [np.ones(11), booster.stations, *(o.deflection(booster.stations) for o in own.modes)]
        )
        share = np.linalg.lstsq(line, shape, rcond=None)[0][2:]
        energy = sum(o.mass * o.omega**2 * c**2 for o, c in zip(own.modes, share, strict=True))
        assert mode.omega == pytest.approx(np.sqrt(energy / mode.mass), rel=1e-6)


@pytest.mark.parametrize("t", TIMES)
def test_loads_balance_all_the_way(t):
    booster = burn.booster_at(t)
    found = loads.section_loads(booster, dispersed.with_gravity(booster), np.arange(0, 421, 20.0), 27.0)
    size = np.abs(found.moment).max(axis=0)
    assert np.all(np.abs(found.end_moment[size > 0]) < 1e-8 * size[size > 0])


def test_frequencies_rise_as_the_propellant_goes():
    found = np.array([[mode.omega for mode in burn.booster_at(t).modes] for t in (10.0, 40.0, 70.0, 100.0)])
    assert np.all(np.diff(found, axis=0) > 0)


def test_frozen_flight_is_the_response_of_one_loop():
    run = burn.flight(burn.fixed, 45.0, 60.0, frozen=57.5)
    loop = burn.loop_at(57.5, burn.fixed)
    single = loop[:, loop.input_labels.index("alpha_g")]
    found = gusts.response(single, run["t"] - 45.0, run["alpha_g"])
    for name, wanted in zip(loop.output_labels, found.values(), strict=True):
        assert np.allclose(run[name], wanted, atol=3e-3 * np.abs(wanted).max())


def test_schedule_holds_from_lift_off_to_burnout():
    times = np.arange(0.5, 110.1, 0.5)
    worst = [np.linalg.eigvals(burn.loop_at(t, burn.scheduled).A).real.max() for t in times]
    assert max(worst) < 0
    assert burn.held(burn.scheduled, times[::40]) == (0.5, 100.5)


def test_schedule_is_the_best_of_the_search():
    """Its designs among their neighbours: no two hold the whole burn, and the stored three come out again."""
    times, made_for = schedule_search.TIMES, np.array([17.5, 22.5, 57.5, 60.0, 107.5, 110.0])
    rows = [burn.frozen_poles(times, lambda _, t=t: burn.made_for(t)).real.max(axis=1) for t in made_for]
    assert schedule_search.best_schedule(np.array(rows), times, made_for) == burn.switched()


def test_search_takes_the_fewest_designs_and_the_widest_overlap():
    times, made_for = np.arange(6.0), np.array([1.0, 2.0, 3.0, 4.0])
    rows = ["--++++", "---+++", "+-----", "++-+--"]
    signs = np.array([[1.0 if c == "+" else -1.0 for c in row] for row in rows])
    assert schedule_search.best_schedule(signs, times, made_for) == {0.0: 2.0, 1.5: 3.0}
    assert schedule_search.held_spans(signs)[3] == [(2, 2), (4, 5)]
    with pytest.raises(ValueError, match="got none that hold"):
        schedule_search.best_schedule(signs[:2], times, made_for[:2])


def test_at_lift_off_a_root_is_zero_that_no_instrument_sees():
    """Without air the velocity across the path acts on nothing, so that no design moves its root."""
    whole = burn.plant_at(0.0)
    at = [whole.output_labels.index(one.name) for one in burn.READS]
    values, vectors = np.linalg.eig(whole.A)
    still = np.abs(values) < 1e-9
    assert min(np.abs(whole.C[at] @ vectors[:, i]).max() for i in np.flatnonzero(still)) < 1e-9
    for design in (burn.fixed, burn.scheduled):
        assert np.abs(burn.loop_at(0.0, design).poles()).min() < 1e-9
    booster = burn.booster_at(0.0)
    loops = [
        closed_loop(
            plant(with_gravity(replace(booster, flight=replace(booster.flight, U=U))), burn.READS, jet=NOSE),
            burn.fixed(0),
        )
        for U in (0.1, 1.0, 10.0)
    ]
    for s in (0.3 + 1j, -0.7 + 3j, 20j):
        characteristic = [np.linalg.det(s * np.eye(loop.nstates) - loop.A) for loop in loops]
        assert np.allclose(characteristic, characteristic[1], rtol=1e-8)


@pytest.mark.parametrize("design", [burn.fixed, burn.scheduled])
def test_whole_flight_is_what_another_integrator_makes_of_it(design):
    """Radau's implicit method, data that change all the time in place of each half second."""
    run = burn.flight(design, 2.0, 110.0, theta=np.radians(1.0))
    path, x = burn.flown_path(), burn.tilted(burn.loop_at(2.0, design), np.radians(1.0))
    edges = [2.0, *(t for t in burn.switched() if t > 2), 110.0]
    for start, end in pairwise(edges):
        nodes = np.linspace(start, end, round(2 * (end - start)) + 1)
        kept = design(start)
        loops = [burn.loop_at(float(t), lambda _, kept=kept: kept) for t in nodes]
        gust = [loop.B[:, loop.input_labels.index("alpha_g")] for loop in loops]
        A, b = CubicSpline(nodes, [loop.A for loop in loops]), CubicSpline(nodes, gust)

        def rate(t, x, A=A, b=b):
            return A(t) @ x + b(t) * burn.wind(np.array(t)) / np.interp(t, path.times, path.U)

        at = run["t"][(run["t"] > start - 1e-9) & (run["t"] < end - 1e-9)]
        found = solve_ivp(
            rate,
            (start, end),
            x,
            "Radau",
            np.append(at, end),
            rtol=1e-7,
            atol=1e-9,
            max_step=0.1,
            jac=lambda t, _, A=A: A(t),
        )
        x = found.y[:, -1]
        for name in ("theta", "alpha"):
            row = loops[0].C[loops[0].output_labels.index(name)]
            size = np.abs(run[name]).max()
            ours = run[name][np.searchsorted(run["t"], at - 1e-9)]
            assert np.allclose(ours, (row @ found.y)[:-1], atol=0.01 * size), (name, start)


def test_schedule_switches_when_it_says():
    (_, first), (early, second), (late, third) = burn.switched().items()
    for t, made_for in (
        (10.0, first),
        (early - 0.1, first),
        (early, second),
        (late - 0.1, second),
        (late, third),
    ):
        assert np.array_equal(burn.scheduled(t).A, burn.made_for(made_for).A)
    assert np.array_equal(burn.redesigned(58.0).A, burn.made_for(57.5).A)
