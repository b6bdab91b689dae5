"""The mode shapes: through every printed point, least bending, and how far from those of a free beam."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import rlswaim as rl
from rlswaim.source.tables import column
from rlswaim.vehicle import modes

BOOSTER = rl.swaim_booster()
BOTH = pytest.mark.parametrize("mode", BOOSTER.modes, ids=lambda mode: mode.name)


@BOTH
def test_shape_passes_through_every_printed_point(mode):
    np.testing.assert_allclose(mode.deflection(mode.stations), mode.deflections, atol=1e-12)
    np.testing.assert_allclose(mode.slope(mode.slope_stations), mode.slopes, atol=1e-12)


@BOTH
@given(at=st.floats(1, 419))
def test_slope_is_minus_the_derivative(mode, at):
    derivative = (mode.deflection(at + 1e-4) - mode.deflection(at - 1e-4)) / 2e-4
    assert mode.slope(at) == pytest.approx(-derivative, abs=1e-5)


def bending(shape):
    """Return the integral of the squared second derivative."""
    return sum(quad(lambda x: shape(x, 2) ** 2, *ends)[0] for ends in pairwise(shape.x))


@BOTH
@given(at=st.sampled_from([14.0, 84.0, 200.0, 350.0]), push=st.floats(-0.5, 0.5))
def test_any_other_shape_through_the_data_bends_more(mode, at, push):
    phi = dict(zip(mode.stations.tolist(), mode.deflections.tolist(), strict=True))
    slopes = dict(zip(mode.slope_stations.tolist(), (-mode.slopes).tolist(), strict=True))
    other = modes.least_bending_shape(phi | {at: mode.deflection(at) + push}, slopes)
    assert bending(other) >= bending(mode.shape) * (1 - 1e-9)


@BOTH
def test_it_is_straight_ahead_of_the_first_mass(mode):
    assert mode.slope(0) == pytest.approx(mode.slope(27))


def test_error_of_the_shape_where_nothing_is_told():
    worst = [abs(mode.withheld_slopes() - mode.slopes).max() for mode in BOOSTER.modes]
    all_out = [abs(mode.withheld_slopes(all_at_once=True) - mode.slopes).max() for mode in BOOSTER.modes]
    np.testing.assert_allclose([worst, all_out], [[0.0070, 0.0128], [0.0061, 0.0198]], atol=1e-4)


@pytest.mark.parametrize("number", [1, 2])
def test_recovered_deflections_are_met(number):
    at, recovered = column("mode_checks", "station_ft"), column("mode_checks", f"phi_{number}")
    np.testing.assert_allclose(BOOSTER.modes[number - 1].deflection(at), recovered, atol=0.03)


def test_shapes_are_orthogonal_to_translation_but_not_to_rotation():
    m, shapes = BOOSTER.masses, [mode.deflection(BOOSTER.stations) for mode in BOOSTER.modes]
    assert [modes.mass_cosine(m, phi, np.ones(11)) for phi in shapes] == pytest.approx([0, 0], abs=0.011)
    assert modes.mass_cosine(m, *shapes) == pytest.approx(0, abs=0.017)
    assert [modes.mass_cosine(m, phi, BOOSTER.arms) for phi in shapes] == pytest.approx(
        [0.62, 0.24], abs=0.01
    )


def test_a_shape_is_like_itself():
    phi = BOOSTER.modes[0].deflection(BOOSTER.stations)
    assert modes.mass_cosine(BOOSTER.masses, phi, -2 * phi) == pytest.approx(-1)


def test_recomputed_totals():
    exact = BOOSTER.recomputed()
    assert (exact.M, exact.l_CG) == pytest.approx((151301, 289.773), abs=1e-3)
    assert [mode.mass for mode in exact.modes] == pytest.approx([622035.6, 637007.2], abs=0.1)
    assert exact.thrust_station == BOOSTER.thrust_station


@pytest.mark.parametrize("last_first", [False, True])
def test_orthogonalized_modes_are_those_of_a_free_beam(last_first):
    free = BOOSTER.orthogonalized(last_first)
    m, shapes = free.masses, [mode.deflection(free.stations) for mode in free.modes]
    rigid = [np.ones(11), free.arms]
    cosines = [modes.mass_cosine(m, phi, other) for phi in shapes for other in rigid]
    assert [*cosines, modes.mass_cosine(m, *shapes)] == pytest.approx([0] * 5, abs=1e-12)
    for mode, old, phi in zip(free.modes, BOOSTER.modes, shapes, strict=True):
        assert mode.deflection(free.thrust_station) == pytest.approx(1)
        assert mode.mass == pytest.approx(m @ phi**2)
        assert (mode.omega, mode.zeta) == (old.omega, old.zeta)


def test_only_a_line_and_a_scale_are_taken_off_the_first_mode():
    x = np.linspace(0, 420, 43)
    bent = [np.diff(b.modes[0].deflection(x), 2) for b in (BOOSTER, BOOSTER.orthogonalized())]
    np.testing.assert_allclose(bent[1] * (bent[0] @ bent[1]) / (bent[1] @ bent[1]), bent[0], atol=1e-12)
    slopes = BOOSTER.orthogonalized().modes[0].slope(x)
    assert np.abs(slopes + np.gradient(BOOSTER.orthogonalized().modes[0].deflection(x), x))[1:-1].max() < 1e-3


def test_orthogonalizing_twice_changes_nothing():
    once = BOOSTER.orthogonalized()
    twice = once.orthogonalized()
    for a, b in zip(once.modes, twice.modes, strict=True):
        np.testing.assert_allclose(a.deflections, b.deflections, atol=1e-12)
        assert a.mass == pytest.approx(b.mass)
