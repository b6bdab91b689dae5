"""The report's path and the corrected one, at the values that the chapters show; and consistent data."""

from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim.edition import (
    consistent_vehicles,
    corrected_loops,
    printed_closures,
    section_5,
    section_6,
)
from rlswaim.edition.matching import printed_roots
from rlswaim.edition.section_4 import CLOSED_LOOPS, WANTED, closed_loop_roots
from rlswaim.figures.loci import draw_far_locus
from rlswaim.loops import closures, transfer_functions
from rlswaim.loops.rigid_body_design import rigid_body, rigid_design
from rlswaim.rootlocus.locus import root_locus
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle import trajectory

EQS, BOOSTER = rl.printed_equations(), rl.swaim_booster()
K_A, K_C, K_R = 0.0016, 10.0, 0.618
RIGHT = rigid_design(rigid_body(EQS), omega=2.0, zeta=0.5, K_C=K_C)
JET, KK_Z = printed_closures.final_design()


def at(loop, gain):
    return root_locus(loop, [gain]).roots[0]


def contains(found, wanted, within):
    """Pair wanted roots with found ones; the largest distance over size is at most ``within``."""
    wanted = np.asarray(list(wanted), complex)
    distance = np.abs(wanted[:, None] - np.asarray(found)) / np.maximum(np.abs(wanted)[:, None], 1e-2)
    return distance[linear_sum_assignment(distance)].max() <= within


def upper(found):
    return sorted((r for r in found if r.imag > 1e-9), key=abs)


# ---- Section III: the coupling on two scales


def test_coupling_on_one_scale_ends_at_eq_40_and_on_two_scales_does_not():
    pair = corrected_loops.coupling_loops(EQS)
    eq_40 = [1.08, -1.28, complex(-0.0387 / 2, np.sqrt(1.813 - 0.0387**2 / 4))]
    assert contains(at(pair["corrected"], 1), eq_40, 0.004)
    mixed = at(pair["report"], 1)
    assert not contains(mixed, eq_40, 0.5)
    assert max(mixed.real) == pytest.approx(6.68, abs=0.01)
    assert upper(mixed)[0] == pytest.approx(1.62 + 8.19j, abs=0.01)


def test_without_coupling_both_scales_start_alike():
    first, second = (np.sort_complex(at(loop, 0)) for loop in corrected_loops.coupling_loops(EQS).values())
    np.testing.assert_allclose(first, second, atol=1e-3)


# ---- Section IV: gains of the rigid body


def test_each_rigid_loop_has_the_wanted_short_period_at_its_own_gain_alone():
    pair = corrected_loops.rigid_loops(EQS)
    assert np.abs(at(pair["report"], K_A) - WANTED).min() < 0.01
    assert np.abs(at(pair["corrected"], RIGHT.K_A) - WANTED).min() < 0.01
    assert np.abs(at(pair["corrected"], K_A) - WANTED).min() > 1.5
    fast = upper(at(pair["report"], RIGHT.K_A))[0]
    assert (abs(fast), -fast.real / abs(fast)) == pytest.approx((189.3, 0.0223), rel=3e-3)


@pytest.mark.parametrize("number", CLOSED_LOOPS)
def test_printed_roots_are_those_of_the_gain_with_the_slip(number):
    gyro, order = CLOSED_LOOPS[number]
    wanted = [
        r for name, r in printed_roots("IV", f"eq{number}-").items() if number != "79" or "mode1" not in name
    ]
    assert contains(closed_loop_roots(EQS, K_A, K_R, gyro, order), wanted, 0.005)
    assert not contains(closed_loop_roots(EQS, RIGHT.K_A, RIGHT.K_R, gyro, order), wanted, 0.05)


@pytest.mark.parametrize(
    ("gyro", "unstable", "first", "second"),
    [(60, 1.39, 0.63, -0.34), (400, 1.07, 0.45, -0.30), (304, 1.21, 0.32, 0.08)],
)
def test_closed_loops_at_the_right_gain(gyro, unstable, first, second):
    found = closed_loop_roots(EQS, RIGHT.K_A, RIGHT.K_R, gyro)
    pairs = [-r.real / abs(r) for r in upper(found)[:2]]
    assert max(found[found.imag == 0].real) == pytest.approx(unstable, abs=0.005)
    assert pairs == pytest.approx([first, second], abs=0.005)


# ---- Sections V and VI: the zeros of the inner loops


@pytest.mark.parametrize(
    ("station", "as_printed", "gain", "first", "second"),
    [
        (140, section_5.printed_inner_loop(), 0.054, 1.23, 7.97),
        (300, section_6.printed_first_loop(), -0.144, 1.56, 7.64),
    ],
)
def test_inner_loops_close_otherwise_along_each_set_of_zeros(station, as_printed, gain, first, second):
    report, corrected = at(as_printed, gain), at(transfer_functions.inner_loop(EQS, K_C, station), gain)
    assert upper(report)[0].real > 1
    modes = upper(corrected)
    assert all(r.real < 0 for r in modes)
    assert [abs(r) for r in modes] == pytest.approx([first, second], abs=0.01)


def test_the_first_mode_is_stiffened_at_station_140_but_not_much():
    """At every gain its frequency rises, to that of the zero that it ends at."""
    loop = transfer_functions.inner_loop(EQS, K_C, 140)
    size = [abs(upper(at(loop, gain))[0]) for gain in np.geomspace(1e-4, 1e6, 101)]
    assert np.all(np.diff(size) > -1e-9)
    assert size[0] == pytest.approx(1.1504, abs=1e-3)
    assert max(size) == pytest.approx(1.2751, abs=5e-5)


def test_what_crosses_and_what_pairs_in_figure_15():
    """Along the printed zeros the unstable real root ends left; the pair comes from -1.543 and -10."""
    report = section_5.printed_inner_loop()
    real = at(report, 0.054)
    assert sorted(real[real.imag == 0].real) == pytest.approx([-0.9925, 0.0], abs=5e-5)
    (meeting,) = [b for b in rl.root_locus(report).break_aways if b.gain > 0]
    assert meeting.point.real == pytest.approx(-6.288, abs=5e-4)
    before = at(report, 0.99 * meeting.gain)
    assert sorted(before[before.imag == 0].real)[:2] == pytest.approx([-6.7, -5.9], abs=0.2)


def test_poles_of_eq_118_follow_from_the_printed_zeros_alone():
    wanted = printed_roots("VI", "eq118-p").values()
    assert contains(at(section_6.printed_first_loop(), -0.144), wanted, 0.11)
    assert not contains(at(transfer_functions.inner_loop(EQS, K_C, 300), -0.144), wanted, 0.3)


def test_outer_loop_of_section_v_both_ways():
    report = section_5.printed_outer_loop()
    corrected = transfer_functions.outer_loop(EQS, K_C, 0.625, [(0.054, 140.0)])
    gain, _ = section_5.nearest_gain(report, WANTED, least=1.0, most=1e3)
    assert gain == pytest.approx(154.28, abs=0.005)
    assert np.abs(at(report, gain) - WANTED).min() == pytest.approx(0.01, abs=0.002)
    assert np.abs(at(report, 39) - WANTED).min() == pytest.approx(1.52, abs=0.01)
    assert upper(at(report, 39))[0] == pytest.approx(1.68 + 2.11j, abs=0.01)
    assert upper(at(corrected, 39)) == pytest.approx([-0.003 + 2.583j, -4.226 + 17.314j], abs=0.001)
    assert at(corrected, 39).real.max() == pytest.approx(1.169, abs=0.001)


# ---- Section VII: three closures


def test_closure_2_both_ways():
    pair = corrected_loops.closure_2_loops(EQS)
    report, corrected = (at(loop, 1) for loop in pair.values())
    assert min(report.real) == pytest.approx(-1.115e7, rel=1e-3)
    printed = printed_roots("VII", "text-closure2-").values()
    assert contains(report, [r for r in printed if abs(r) > 0.1], 0.12)
    assert min(corrected.real) == pytest.approx(-397, abs=0.5)
    assert max(corrected.real) == pytest.approx(390, abs=0.5)
    assert contains(corrected, roots(EQS.characteristic_polynomial())[1:], 1e-4)
    assert not contains(report, roots(EQS.characteristic_polynomial())[1:], 0.02)


def test_closure_3_has_sixteen_poles_in_the_report_and_nine_here():
    report = printed_closures.printed_closure_3(1, 0.286)
    corrected = closures.closure_3_open_loop(EQS, JET, KK_Z, 1, 0.286)
    assert (report.poles().size, corrected.poles().size) == (16, 9)
    assert [int((loop.poles().real > 1e-9).sum()) for loop in (report, corrected)] == [4, 1]
    counts = [int((at(report, gain).real > 1e-9).sum()) for gain in (1e-4, 7.3e-4, 7.5e-4, 1.0, 100.0)]
    assert counts == [4, 4, 6, 6, 6]


# ---- consistent data


def conditions():
    ascent = trajectory.swaim_ascent()
    return consistent_vehicles.flight_conditions(BOOSTER, ascent, trajectory.level_at_burnout(ascent))


def test_consistent_flight_conditions_are_in_the_air():
    assert len(conditions()) == 8
    for name, flight in conditions().items():
        in_air = trajectory.dynamic_pressure(flight.h, flight.U)[0]
        assert (in_air == pytest.approx(flight.q_D)) == (name != "printed")


def test_unstable_root_at_each_flight_condition():
    found = consistent_vehicles.survey({n: replace(BOOSTER, flight=f) for n, f in conditions().items()})
    expected = [1.307, 1.232, 1.311, 0.972, 2.030, 1.045, 1.285, 1.285]
    assert list(found["both modes"]) == pytest.approx(expected, abs=1e-3)
    assert (found.margin < 0).all()
    assert found.doubling["printed"] == pytest.approx(0.530, abs=1e-3)


def test_what_orthogonal_modes_leave_of_section_iii():
    boosters = {"printed": BOOSTER, "1": BOOSTER.orthogonalized(), "2": BOOSTER.orthogonalized(True)}
    found = consistent_vehicles.survey(boosters)
    assert list(found["one mode"]) == pytest.approx([1.083, 0.703, 0.595], abs=1e-3)
    assert list(found["both modes"]) == pytest.approx([1.307, 0.979, 0.826], abs=1e-3)
    assert list(found["s"]) == pytest.approx([-69.6, -6.39, -4.73], abs=0.05)
    assert (np.abs(found["s^2"]) < 0.2).tolist() == [False, True, True]
    assert (found.margin < -5).all()


# ---- figures


def test_far_locus_shows_every_root():
    with mpl.rc_context():
        fig, ax = plt.subplots()
        loop = corrected_loops.closure_2_loops(EQS)["report"]
        locus = root_locus(loop, np.concatenate([[0.0], np.geomspace(1e-12, 1, 60)]))
        printed = list(printed_roots("VII", "text-closure2-").values())
        draw_far_locus(ax, locus, locus.roots[-1], printed)
        closed = next(line for line in ax.lines if line.get_label() == "closed loop, computed")
        assert min(closed.get_xdata()) == pytest.approx(-1.115e7, rel=1e-3)
        assert ax.get_xlim()[0] < min(closed.get_xdata())
        plt.close(fig)
