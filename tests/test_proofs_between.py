"""Proofs for every station, those between the feet too, beside the programs at single stations."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import conclusions
from rlswaim.edition.slow_roots import slow_bound
from rlswaim.loops import certificates, exact_programs, proofs_between

PLAIN, WITH = rl.printed_equations(), rl.printed_equations(gravity=True)
OWN = rl.perturbation_equations(rl.swaim_booster())
SLOW = slow_bound()
CASES = [(PLAIN, None, 6.72), (PLAIN, SLOW, 6.38), (WITH, None, 6.92), (WITH, SLOW, 6.60)]
IDS = ["all roots", "a slow one apart", "all roots, gravity", "a slow one apart, gravity"]
along = cache(proofs_between.proof_for_gyros)


def at_station(eqs, station, slow):
    if slow is None:
        return -certificates.stability_certificate(eqs, station).margin
    return certificates.slow_root_certificate(eqs, station, slow=slow)


@pytest.mark.parametrize(("eqs", "slow", "least"), CASES, ids=IDS)
def test_no_gyro_station_at_all_stabilizes(eqs, slow, least):
    proof = along(eqs, slow)
    assert not proof.fails
    assert proof.holds_by == pytest.approx(least, abs=0.01)
    starts, ends, _ = zip(*proof.stretches, strict=True)
    assert (starts[0], ends[-1]) == (0, 420)
    assert starts[1:] == ends[:-1]


def test_the_coefficients_of_section_ii_rule_every_gyro_station_out_as_well():
    assert along(OWN, None).holds_by > 6
    assert along(OWN, SLOW).holds_by > 6


@pytest.mark.parametrize(("eqs", "slow", "least"), CASES, ids=IDS)
def test_the_bound_is_below_what_every_station_tells(eqs, slow, least):
    stretches = along(eqs, slow).stretches
    draw = np.random.default_rng(1964)
    for start, end, bound in stretches[::3]:
        for station in (start, end, draw.uniform(start, end)):
            assert bound <= at_station(eqs, station, slow) * (1 + 1e-7)
    start, end, bound = min(stretches, key=lambda stretch: stretch[2])
    assert least - 0.01 < bound <= at_station(eqs, end, slow) * (1 + 1e-7) < bound * 1.01


def test_nothing_is_proved_where_gains_stabilize():
    eqs = rl.perturbation_equations(conclusions.surfaces_cut(rl.swaim_booster())["payload surface halved"])
    proof = proofs_between.proof_for_gyros(eqs, SLOW, (368.0, 370.0))
    assert not proof.stretches
    assert proof.holds_by == 0
    assert (proof.fails[0][0], proof.fails[-1][1]) == (368, 370)
    assert np.isinf(certificates.stability_certificate(eqs, 369.3).margin)


def test_with_half_the_payload_surface_some_stations_are_ruled_out_and_others_not():
    eqs = rl.perturbation_equations(conclusions.surfaces_cut(rl.swaim_booster())["payload surface halved"])
    proof = proofs_between.proof_for_gyros(eqs, SLOW, (358.0, 366.0))
    feet = [certificates.slow_root_certificate(eqs, float(x), slow=SLOW) > 1e-6 for x in range(358, 367)]
    assert proof.stretches
    assert proof.fails
    for start, end, _ in proof.stretches:
        assert all(feet[x - 358] for x in range(358, 367) if start <= x <= end)
    for x, ruled in zip(range(358, 367), feet, strict=True):
        assert ruled or any(start <= x <= end for start, end in proof.fails)


@pytest.mark.parametrize(
    ("eqs", "slow", "wanted"),
    [
        (PLAIN, None, 0.00095),
        (PLAIN, SLOW, 0.0),
        (WITH, None, 0.0967),
        (WITH, SLOW, 0.0963),
    ],
    ids=IDS,
)
def test_any_sensors_at_any_stations(eqs, slow, wanted):
    """A last digit decides without gravity; with it the proof is firm, a slow root set apart or not."""
    proved = proofs_between.proof_for_sensors(eqs, slow)
    assert proved == pytest.approx(wanted, abs=5e-5)
    sensors = [140.0, 300.0]
    found = (
        -certificates.stability_certificate(eqs, None, sensors).margin
        if slow is None
        else certificates.slow_root_certificate(eqs, None, sensors, slow)
    )
    assert proved == pytest.approx(found, abs=1e-9)
    for sensor in (56.0, 141.3, 393.1):
        one = -certificates.stability_certificate(eqs, None, [sensor]).margin
        assert slow is not None or proved <= one + 1e-9


def test_equations_are_solved_without_rounding():
    draw = np.random.default_rng(1964).integers(-9, 10, (5, 6))
    rows = [[Fraction(int(value)) for value in row] for row in draw]
    determinant, x = exact_programs.solved([row[:5] for row in rows], [row[5] for row in rows])
    assert determinant == round(np.linalg.det(draw[:, :5]))
    for row in rows:
        assert sum(a * b for a, b in zip(row[:5], x, strict=True)) == determinant * row[5]
    again = exact_programs.solved([rows[0][:2], rows[0][:2]], [Fraction(1), Fraction(2)])
    assert again == (0, [0, 0])


@pytest.mark.parametrize("end", [Fraction(1), Fraction(3, 2), Fraction(3)])
def test_a_weight_that_turns_negative_on_the_stretch_proves_nothing(end):
    """The unknowns are 1 and 1 - at**2 / 2: the second is not negative up to the root of 2."""
    program = exact_programs.Program(
        [Fraction(1), Fraction(0)],
        lambda at: [[Fraction(1), Fraction(0)], [at * at / 2 - 1, Fraction(1)]],
        [Fraction(1), Fraction(0)],
        2,
    )
    least = exact_programs.proved_least(program, Fraction(0), end)
    assert (least == 1) if end * end <= 2 else (least is None)


def bending(depth):
    """Return the program whose first unknown is 1 - depth t (1 - t) times the second, which is 1."""

    def rows(t):
        return [[Fraction(1), -(1 - depth * t * (1 - t))], [Fraction(0), Fraction(1)]]

    zero, one = Fraction(0), Fraction(1)
    return exact_programs.Program([zero, one], rows, [zero, one], 2)


@pytest.mark.parametrize(("depth", "least"), [(2, 1), (6, None)], ids=["above 0", "below 0 in between"])
def test_an_unknown_that_turns_negative_between_the_ends_proves_nothing(depth, least):
    """At both ends it is 1, and in the middle 1 - depth/4."""
    assert exact_programs.proved_least(bending(Fraction(depth)), Fraction(0), Fraction(1)) == least
