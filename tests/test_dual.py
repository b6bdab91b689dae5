"""Sections VII and VIII: closures against the state space, Eq. 133 by terms, Table 3, slips, found gains."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import polynomial as npp
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim.edition import causes, conclusions, matching, printed_closures, table_3
from rlswaim.loops import closures
from rlswaim.loops.transfer_functions import elastic_numerator
from rlswaim.practice.ladder import Rung, vehicle_on
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.equations import with_reading

EQS = rl.printed_equations()
LOOP, KK_Z = printed_closures.final_design()
ROWS = [entry for entry in rl.ledger() if entry.section == "VII"]
STATIONS = st.floats(0, 420)


def worst(found, wanted):
    """Largest distance over size, sets paired by least total distance."""
    found, wanted = np.asarray(found, complex), np.asarray(wanted, complex)
    assert found.size == wanted.size
    distance = np.abs(found[:, None] - wanted) / np.maximum(np.abs(wanted), 1e-2)
    return distance[linear_sum_assignment(distance)].max()


@given(STATIONS, st.sampled_from(["q1", "q2", "alpha"]))
def test_two_input_products_divide_by_delta(jet, other):
    coupled = npp.polymul(
        EQS.characteristic_polynomial(), closures.coupling_numerator(EQS, "theta", other, jet)
    )
    left = npp.polymul(EQS.numerator("theta", "delta"), EQS.numerator(other, "delta_r", jet))
    right = npp.polymul(EQS.numerator("theta", "delta_r", jet), EQS.numerator(other, "delta"))
    size = max(np.abs(left).max(), np.abs(right).max())
    assert np.allclose((left - right)[: coupled.size], coupled, atol=1e-12 * size)


@given(STATIONS, STATIONS, st.floats(-1e6, 1e6), st.floats(-5, 5))
def test_closures_end_at_the_state_space(sensor, jet, kK_z, K_A):
    loop = closures.JetLoop(10.0, 3.0, sensor, jet)
    polynomial = npp.polyadd(
        npp.polymul([1.5, 1.0], closures.closure_1_polynomial(EQS, loop, kK_z)),
        1.5 * K_A * npp.polymul([1.0, 0.3], closures.theta_numerator(EQS, loop, kK_z)),
    )
    system = rl.dual_actuation(EQS, K_A=K_A, K_C=1.5, K_R=0.3, kK_z=kK_z, K_r=10, b=3, sensor=sensor, jet=jet)
    poles = system.poles()
    at = npp.polyval(poles, polynomial)
    size = npp.polyval(np.abs(poles), np.abs(polynomial))
    assert np.all(np.abs(at) <= 1e-9 * np.maximum(size, 1))


@given(STATIONS, STATIONS)
def test_braces_of_eq_133_give_both_numerators(sensor, jet):
    phi_z, phi_r = ([m.deflection(x) for m in EQS.modes] for x in (sensor, jet))
    braces = np.einsum("nij,i,j", closures.literal_bracket(EQS), phi_z, [1, jet - EQS.l_CG, *phi_r])
    numerator = elastic_numerator(EQS, sensor, "delta_r", jet)
    assert np.allclose(braces, 1000 * EQS.U * numerator[1:6], rtol=1e-9, atol=1e-9)


def test_eq_135_is_the_numerator_of_alpha():
    printed = matching.printed_roots("VII", "eq135-").values()
    wanted = [0.0, *printed, *(z.conjugate() for z in printed if z.imag)]
    assert worst(roots(closures.jet_numerator(EQS, LOOP, as_printed=True)[:7]), wanted) < 0.005
    assert roots(closures.jet_numerator(EQS, LOOP)).size == len(wanted) - 1


def test_eq_133_lost_one_product():
    computed = closures.literal_bracket(EQS)[:4, 0, 2]
    entries = {entry.id: entry for entry in ROWS}
    printed = np.array([entries[f"eq133-s{power}-1-F1"].value for power in range(4)])
    assert np.abs((computed - causes.dropped_product(EQS)) / printed - 1).max() < 0.005
    assert np.abs(computed / printed - 1).max() > 0.3


def test_jet_moment_has_two_digits_exchanged():
    assert float(f"{1 / 15.279e8:.3e}") == 6.545e-10


def test_fitted_reading_brings_the_printed_roots():
    printed = matching.printed_roots("VII", "text-closure1-").values()
    wanted = [0.0, *printed, *(z.conjugate() for z in printed if z.imag)]
    fitted = printed_closures.fitted_deflections(EQS, LOOP, KK_Z)
    vehicle = with_reading(EQS, LOOP.sensor, fitted)
    assert [m.deflection(LOOP.sensor) for m in vehicle.modes] == pytest.approx(fitted)
    assert worst(roots(closures.closure_1_polynomial(vehicle, LOOP, KK_Z)), wanted) < 0.03
    assert worst(roots(closures.closure_1_polynomial(EQS, LOOP, KK_Z)), wanted) > 0.3


def test_closure_2_contains_delta_and_the_printed_one_does_not():
    delta = roots(EQS.characteristic_polynomial())
    opened = closures.closure_2_open_loop(EQS, LOOP, KK_Z)
    closed = npp.polyadd(opened.num[0][0][::-1], opened.den[0][0][::-1])
    size = npp.polyval(np.abs(delta), np.abs(closed))
    assert np.all(np.abs(npp.polyval(delta, closed)) <= 1e-10 * np.maximum(size, 1))
    printed = np.array(list(matching.printed_roots("VII", "text-closure2-").values()))
    assert np.abs(printed[:, None] - delta[delta != 0]).min(axis=0).min() > 0.02


def test_table_3():
    pairs = table_3.trials(EQS)
    assert [p.case for p in pairs] == list(range(1, 25))
    assert {p.case for p in pairs if p.outcome == "rises throughout"} == {1, 2, 4, 7, 11, 13, 14, 19}
    assert {p.case for p in pairs if p.steadies} == {1, 4}
    assert pairs[21].outcome == "higher at the end"


@pytest.mark.parametrize("case", [21, 22, 23, 24])
def test_last_pairs_stand_where_the_direct_effect_vanishes(case):
    pair = table_3.trials(EQS)[case - 1]
    near = closures.direct_response(EQS, pair.sensor + np.array([-2.5, 2.5]), np.full(2, pair.jet))
    assert near[0] * near[1] < 0


@pytest.mark.parametrize("entry", ROWS, ids=[entry.id for entry in ROWS])
def test_row(entry):
    assert (entry.verdict == "agrees") == entry.agrees
    assert entry.why or entry.verdict == "agrees"
    assert np.isfinite(entry.computed)


@pytest.mark.parametrize("eqs", [EQS, rl.perturbation_equations(rl.swaim_booster())], ids=["printed", "data"])
def test_found_gains_hold_two_ways(eqs):
    poles = conclusions.closed_loop(eqs, "dual_actuation").poles()
    assert worst(poles, roots(conclusions.polynomial(eqs, "dual_actuation"))) < 1e-6
    state = conclusions.margin(poles)
    assert state.abscissa < -0.15
    assert -2e-3 < state.slow < 0


def test_an_odd_pole_right_of_the_zero():
    zero, pole = conclusions.interlacing(EQS)
    assert 0 < zero < pole


def test_digits_do_not_fix_the_constant_term():
    value, reach = conclusions.constant_term(EQS)
    assert abs(value) < reach


def test_cures():
    found = conclusions.cures(rl.swaim_booster())
    assert found["as it is"] == pytest.approx(1.31, abs=0.005)
    assert found["no air (q_D = 0)"] == found["no payload surface"] == pytest.approx(0, abs=1e-6)
    assert found["payload surface at the first mode's front node"] == pytest.approx(0, abs=1e-6)
    assert found["fins at its rear node"] == pytest.approx(1.292, abs=5e-4)
    assert found["both surfaces at its nodes"] == pytest.approx(0, abs=1e-6)


def test_moved_surfaces_stand_where_the_first_mode_does_not_bend():
    booster = rl.swaim_booster()
    both = conclusions.surfaces_moved(booster)["both surfaces at its nodes"]
    assert [round(s.station) for s in both.surfaces] == [188, 394]
    assert booster.modes[0].deflection([s.station for s in both.surfaces]) == pytest.approx([0, 0], abs=1e-9)
    assert [s.C_Nalpha for s in both.surfaces] == [s.C_Nalpha for s in booster.surfaces]


def test_the_path_leaves_the_unstable_root_and_makes_a_slow_pair_of_the_origin():
    """Recommendation 4 with the weight along and across the path: each root makes Eq. 29's determinant zero.

    A row and a column for the speed u are joined to it: U alpha' has -g cos(gamma_0) u/U and
    u' is g cos(gamma_0) (alpha - theta).
    """
    flight = rl.swaim_booster().flight
    across, along = 32.2 * np.sin(flight.gamma_0), 32.2 * np.cos(flight.gamma_0)
    found = vehicle_on(rl.printed_equations(gravity=True), Rung(level=along)).poles()
    powers = np.zeros((5, 5, 3))
    powers[:4, :4] = EQS.matrix
    powers[0, 1, 0] += across
    powers[0, 4, 0] = along / EQS.U
    powers[4, [0, 1, 4], [0, 0, 1]] = -along, along, 1.0
    assert len(found) == 8
    for s in found:
        at = powers @ [1, s, s**2]
        assert abs(np.linalg.det(at)) < 1e-9 * np.prod(np.linalg.norm(at, axis=1))
    assert found.real.max() == pytest.approx(1.3072, abs=5e-5)
    slow = min(found[found.imag > 0], key=abs)
    assert slow == pytest.approx(0.00591 + 0.01122j, abs=5e-6)


def test_unknown_output_is_told():
    with pytest.raises(ValueError, match="coupling_numerator: got 'q3', wanted one of"):
        closures.coupling_numerator(EQS, "theta", "q3", 140.0)


def test_roots_as_text():
    assert matching.listed([2, -1 + 2j, -1 - 2j]) == "-1.000 ± 2.000j, 2.000"
