"""The table of conclusions by rungs: its numbers by other ways, its searches closed again."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition.printed_closures import final_design
from rlswaim.edition.slow_roots import abscissas, slow_bound
from rlswaim.loops.certificates import slow_root_certificate
from rlswaim.loops.closed_loops import polynomial
from rlswaim.loops.closures import closure_1_polynomial
from rlswaim.practice import conclusions_on_rungs as judged
from rlswaim.practice import ladder_dispersed as dis
from rlswaim.practice import ladder_search as search
from rlswaim.practice.dispersed import dispersed, drawn
from rlswaim.practice.ladder import vehicle_on
from rlswaim.practice.limits import limits
from rlswaim.practice.measurements import attitude
from rlswaim.practice.rungs import ladder_steps
from rlswaim.rootlocus.polynomials import roots

STEPS, STORED = ladder_steps(), search.stored()


@pytest.mark.parametrize("pair", STORED, ids=str)
def test_each_winner_closes_its_loop_as_stored(pair):
    rung, section = pair
    best = STORED[pair]
    structure = search.SEARCHED[section]
    poles = structure.closed_loop(STEPS[rung], **best.gains).poles()
    assert abscissas(poles[None], True)[0] == pytest.approx(best.abscissa, rel=1e-4, abs=1e-5)
    problem = search.OnARung(STEPS[rung], structure)
    A = problem.matrices(**best.gains)
    assert abscissas(np.linalg.eigvals(A)[None], True)[0] == pytest.approx(best.abscissa, rel=1e-3, abs=1e-4)
    assert np.all(problem.place(best.gains) >= -1e-9)
    assert np.all(problem.place(best.gains) <= 1 + 1e-9)


def test_page_names_the_reports_conclusions_of_the_table():
    ours = [one for one in judged.CONCLUSIONS.values() if not one.of_report]
    assert [one.words for one in ours] == ["no stable controller", "or other gains"]
    numbers = sorted({one.of_report for one in judged.CONCLUSIONS.values()} - {""})
    config = (Path(__file__).parent.parent / "_config.yml").read_text(encoding="utf-8")
    said = f"Conclusions {', '.join(numbers[:-1])} and {numbers[-1]} of the report and two of this edition"
    assert f"17-ladder-of-models: {said}" in config


def test_every_rung_and_section_is_stored():
    assert set(STORED) == {(rung, section) for rung in STEPS for section in search.SEARCHED}
    assert min(best.evaluations for best in STORED.values()) > 10_000


def test_no_search_beats_a_proof():
    """Where a certificate rules all gains out, the search has found none; and the report's loops agree."""
    ways = {"IV": (60.0, ()), "V": (None, (140.0,)), "VI": (None, (300.0, 140.0))}
    for rung in ("as printed", "gravity"):
        for section, (gyro, sensors) in ways.items():
            proved = slow_root_certificate(STEPS[rung].eqs, gyro, sensors, slow_bound()) > 1e-6
            assert not proved or STORED[rung, section].abscissa > 0


def test_a_short_search_is_not_better_than_the_stored_one():
    found = search.sought("gravity", "IV", rounds=20)
    assert STORED["gravity", "IV"].abscissa - 1e-9 <= found.abscissa < 2


@pytest.mark.parametrize("rung", STEPS)
def test_modest_loop_as_found(rung):
    step = STEPS[rung]
    given = judged.as_found(step)
    if len(step.eqs.modes) == 2 and not any(vars(step.rung).values()):
        p = polynomial(step.eqs, "modest_jet", search.modest_gains())
        assert given == pytest.approx(abscissas(roots(p)[None], True)[0], rel=1e-5)
    verdict = judged.cells()[rung]["modest"].verdict
    assert (verdict == "stands") == (given < 0)
    assert STORED[rung, "VII"].abscissa <= given + 1e-6


def test_bounds_without_hardware_are_those_of_chapter_xv():
    for rung, gravity in (("as printed", False), ("gravity", True)):
        plain = limits(attitude(rl.printed_equations(gravity=gravity), None))
        found = judged.cells()[rung]["parity"]
        assert found.number == pytest.approx(plain.peak)
        assert found.verdict == "stands"
    # A delay's zeros right of the axis make the bound greater, other stable parts leave it.
    assert judged.cells()["20 ms delay"]["parity"].number > judged.cells()["as printed"]["parity"].number


@pytest.mark.parametrize("rung", STEPS)
def test_stiff_vehicle_is_the_limit_of_stiffer_ones(rung):
    """Frequencies a thousand times as high, well damped, leave the rigid body's roots."""
    eqs, hardware = STEPS[rung]
    stiffer = dict(eqs.coefficients)
    for i, mode in enumerate(eqs.modes, start=1):
        stiffer[f"F{i}_q{i}"] += 1e6 * mode.omega**2
        stiffer[f"F{i}_q{i}dot"] += 1e3 * mode.omega
    poles = vehicle_on(replace(eqs, coefficients=stiffer), hardware).poles()
    assert abscissas(poles[None], True)[0] == pytest.approx(judged.rigid_root(STEPS[rung]), rel=1e-3)
    verdict = judged.cells()[rung]["rigid"].verdict
    assert verdict == ("depends" if eqs.gravity else "stands")


def test_jet_alone_is_closure_1():
    """On the report's own rung the root with the jet is that of Figure 24's closed loop."""
    loop, kK_z = final_design()
    for rung in ("as printed", "gravity"):
        p = closure_1_polynomial(STEPS[rung].eqs, loop, kK_z)
        assert judged.root_with_the_jet(STEPS[rung]) == pytest.approx(roots(p).real.max(), rel=1e-7)
    assert all(row["jet"].number > 0 for row in judged.cells().values())


@pytest.mark.parametrize("rung", STEPS)
def test_jet_alone_leaves_the_divergence_itself(rung):
    """Beside any root of the jet's own loop a real root is left, about as fast as that without it."""
    poles = judged.with_the_jet(STEPS[rung]).poles()
    left = poles.real[(poles.imag == 0) & (poles.real > 0.5 * judged.unstable_root(STEPS[rung]))]
    assert left.min() == pytest.approx(judged.unstable_root(STEPS[rung]), rel=0.25)


def test_table_has_a_link_in_each_cell():
    frame = judged.table({"dispersions": dis.cells()})
    assert frame.shape == (len(STEPS) + 1, len(judged.CONCLUSIONS))
    pages = {one.words: one.page for one in judged.CONCLUSIONS.values()}
    for words, column in frame.items():
        assert all(text.endswith(f"]({pages[words]})") for text in column)


def test_dispersions_are_stored_as_they_come_out():
    shares = dis.stored_shares()
    assert shares["draws"] == dis.DRAWS
    worst = dis.outcome(int(shares["worst_draw"]))
    assert worst.modest == pytest.approx(shares["worst"], rel=1e-5)
    few = [dis.outcome(index) for index in range(1, 13)]
    assert all(one.modest <= worst.modest for one in few)
    assert shares["diverges"] == shares["parity"] == shares["jet"] == 100
    assert all(0 < one.rigid < min(one.unstable, shares["rigid"] + 1e-9) for one in few)
    assert all(one.with_the_jet > 0 for one in few)
    assert all(one.unstable > 0 and not one.stable_controller for one in few)
    for i, name in enumerate(dis.CLAIMS):
        assert shares[name] < 100 or all(one.ruled_out[i] for one in few)
    assert dis.cells()["modest"] == judged.Cell("depends", shares["modest"], " %")


def test_dispersed_modest_loop_is_that_of_the_polynomial():
    eqs = rl.perturbation_equations(dispersed(rl.swaim_booster(), drawn(7)), gravity=True)
    p = polynomial(eqs, "modest_jet", search.modest_gains())
    assert dis.outcome(7).modest == pytest.approx(abscissas(roots(p)[None], True)[0], rel=1e-5)
