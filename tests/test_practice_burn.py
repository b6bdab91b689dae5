"""The burn against the ascent, orthogonality, balance of loads and a simulation of another kind."""

import numpy as np
import pytest

from rlswaim.practice import burn, dispersed, gusts, loads
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


def test_schedule_is_lost_before_its_first_switch_and_at_burnout():
    times = np.array([12.5, 27.5, 28.0, 28.5, 29.0, 60.0, 90.5, 91.0, 108.0, 108.5, 110.0])
    lost = [float(t) for t in times if np.linalg.eigvals(burn.loop_at(t, burn.scheduled).A).real.max() >= 0]
    assert lost == [28.0, 28.5, 108.5, 110.0]
    assert burn.held(burn.scheduled, times) == (12.5, 108.0)


def test_schedule_switches_when_it_says():
    for t, made_for in ((10.0, 20.0), (28.9, 20.0), (29.0, 57.5), (91.0, 100.0)):
        assert np.array_equal(burn.scheduled(t).A, burn._made_at(made_for).A)
    assert np.array_equal(burn.redesigned(58.0).A, burn._made_at(57.5).A)
