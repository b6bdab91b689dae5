"""Section III's partition of the determinant, in numbers and in letters, and the report's Eqs. 39 to 54."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rlswaim as rl
from pages import show
from rlswaim.edition import corrected_loops
from rlswaim.edition.ledger import coefficient_frame
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle import coupling
from rlswaim.vehicle.equations import COEFFICIENTS
from rlswaim.vehicle.modes import BendingMode

BOOSTER = rl.swaim_booster()
PRINTED = rl.printed_equations()
ENTRIES = [e for e in rl.ledger() if e.section in ("II", "III")]


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.id)
def test_verdict_is_tested_both_ways(entry):
    assert (entry.verdict == "agrees") == entry.agrees
    assert bool(entry.why) != entry.agrees


@given(st.lists(st.floats(-50, 50), min_size=28, max_size=28))
def test_parts_add_up_to_the_determinant(values):
    eqs = replace(PRINTED, coefficients=dict(zip(COEFFICIENTS, values, strict=True)))
    parts = coupling.partition(eqs)
    whole = eqs.characteristic_polynomial(order=3)
    np.testing.assert_allclose(parts.uncoupled + parts.coupling, whole, atol=1e-9 * (1 + abs(whole).max()))


def test_products_of_eq_48_add_up_to_eq_51():
    sums = coupling.coupling_products(PRINTED).groupby("power").value.sum()
    parts = coupling.partition(PRINTED)
    np.testing.assert_allclose(sums.to_numpy(), parts.coupling_undivided[1:4], rtol=1e-12)
    np.testing.assert_allclose(sums[[3, 2, 1]], [-9.94, 463, -4730], rtol=3e-3)


def test_on_one_scale_the_cubic_coupling_is_the_small_one():
    ratios = coupling.partition(PRINTED).frame()["|coupling / uncoupled|"]
    assert ratios["s^3"] < 0.02
    assert ratios["s^2"] > 5
    assert ratios["s"] > 70


def test_eq_52_needs_its_division_by_the_speed():
    exact = coupling.partition(rl.perturbation_equations(BOOSTER)).coupling_undivided[1:4]
    np.testing.assert_allclose(coupling.literal_coupling(BOOSTER), exact, rtol=1e-3)
    as_printed = coupling.literal_coupling(BOOSTER, as_printed=True)
    assert as_printed[2] == pytest.approx(exact[2] * BOOSTER.flight.U)
    assert abs(as_printed[1]) > 100 * abs(exact[1])


def test_the_report_s_loop_of_the_coupling_has_the_printed_coefficients():
    """Eq. 51 over Eq. 50, with the powers of s that both print."""
    loop = corrected_loops.coupling_loops(PRINTED)["report"]
    assert loop.num[0][0].tolist() == [-9.94, 463, -4730, 0]
    assert loop.den[0][0].tolist() == [1, 0.2317, 0.4417, 0.0472, 0.0363, 0]


def with_first_mode(phi_payload, phi_fins):
    """Return the booster with a first mode that has these deflections at payload and fins."""
    mode = BOOSTER.modes[0]
    phi = mode.deflections.copy()
    phi[[0, 10]] = phi_payload, phi_fins
    shape = BendingMode(
        mode.stations, phi, mode.slope_stations, mode.slopes, mode.omega, mode.zeta, mode.mass
    )
    return replace(BOOSTER, modes=(shape, BOOSTER.modes[1]))


def test_coupling_vanishes_with_both_surfaces_at_nodes():
    parts = coupling.partition(rl.perturbation_equations(with_first_mode(0.0, 0.0)))
    assert abs(parts.coupling).max() < 1e-12


@given(st.floats(-8, 8), st.floats(-8, 8))
def test_coupling_vanishes_in_no_other_way(payload, fins):
    booster = with_first_mode(payload, fins)
    s3 = coupling.partition(rl.perturbation_equations(booster)).coupling_undivided[3]
    assert s3 <= 0
    if max(abs(payload), abs(fins)) > 1e-3:
        assert s3 < 0


def test_eqs_53_and_54_are_the_two_sums_that_enter():
    sums = coupling.surface_sums(BOOSTER)
    assert sums["phi_arm"] == pytest.approx(BOOSTER.l_CG * sums["phi"] - sums["phi_l"])
    assert set(coupling.surface_sums(BOOSTER, 2)) == set(sums)


def test_divergence_ends_at_that_frequency():
    limit = coupling.divergence_frequency(BOOSTER)
    for omega, diverges in ((limit * 0.999, True), (limit * 1.001, False), (10 * 0.342, True)):
        stiff = replace(BOOSTER, modes=(replace(BOOSTER.modes[0], omega=omega), BOOSTER.modes[1]))
        found = roots(rl.perturbation_equations(stiff).characteristic_polynomial(order=3))
        assert (found.real.max() > 1e-6) == diverges


def test_without_air_nothing_couples():
    locus = coupling.dynamic_pressure_locus(BOOSTER, [0.0, 670.0, 1340.0])
    assert (abs(locus.roots[0]) < 1e-6).sum() == 3
    np.testing.assert_allclose(locus.roots[-1].real.max(), 1.3074, atol=1e-3)


def test_a_pole_doubles_in_its_doubling_time():
    assert np.exp(1.31 * coupling.doubling_time(1.31)) == pytest.approx(2)


def test_gust_turns_the_rigid_body_into_the_wind_and_makes_the_flexible_one_diverge():
    eqs, times = rl.perturbation_equations(BOOSTER), np.linspace(0, 3, 61)
    rigid, one, two = (coupling.gust_response(eqs, times, 0.01, modes=n) for n in (0, 1, 2))
    assert rigid[-1] < 0 < one[-1] < two[-1]


def test_coefficient_frame_has_every_coefficient():
    table = coefficient_frame()
    assert tuple(table.index) == COEFFICIENTS
    assert show(table).data.count("\n") == len(COEFFICIENTS) + 1


def test_cross_dampings_mirror_each_other():
    c = rl.perturbation_equations(BOOSTER).coefficients
    assert coupling.mirrored_damping(BOOSTER, c["F2_q1dot"]) == pytest.approx(c["F1_q2dot"])
    assert coupling.mirrored_damping(BOOSTER, PRINTED.coefficients["F2_q1dot"]) == pytest.approx(
        -0.0530, abs=1e-4
    )
