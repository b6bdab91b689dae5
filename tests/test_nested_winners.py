"""The stored winners of nested problems: a constraint never improves the best, nor does one way alone."""

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import long_searches, search
from rlswaim.loops.closed_loops import LOOPS

EQS = rl.printed_equations()
WINNERS = search.winners()
IDS = [f"{w.system}-{w.objective}" for w in WINNERS]
NESTED = [(key, inner) for key in rl.searches() for inner in long_searches.constrained(*key)]


@pytest.mark.parametrize(("key", "inner"), NESTED, ids=["-".join(a + b) for a, b in NESTED])
def test_a_constraint_never_improves_the_best(key, inner):
    best, harder = rl.searches()[key].abscissa, rl.searches()[inner].abscissa
    assert best <= harder + 5e-5 * max(1, abs(harder))


@pytest.mark.parametrize(("key", "inner"), NESTED, ids=["-".join(a + b) for a, b in NESTED])
def test_the_winner_of_a_harder_problem_is_a_loop_of_the_easier(key, inner):
    gains = long_searches.embedded(rl.searches()[inner].gains, key[0])
    for name, row in search.bounds(key[0]).items():
        assert float(row["low"]) <= gains[name] <= float(row["high"])
    value = long_searches.exact_abscissa(EQS, key, gains)
    assert value <= rl.searches()[inner].abscissa + 1e-4


def test_every_system_of_the_searches_is_nested_before_its_easier_ones():
    assert set(long_searches.ORDER) == set(LOOPS)
    for key, inner in NESTED:
        assert long_searches.ORDER.index(inner[0]) <= long_searches.ORDER.index(key[0])


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_no_way_found_better_than_the_winner(winner):
    """Each way starts at places of its own; what it found by itself stands in the table."""
    gone = [way for way in (winner.evolution, winner.adaptation, winner.descents) if not np.isnan(way)]
    assert len(gone) >= 2
    for alone in gone:
        assert winner.abscissa <= alone + 5e-5 * max(1, abs(alone))


def test_a_long_search_gives_its_winner_again():
    winner = rl.searches()["rigid_angle", "pair-all"]
    again = long_searches.long_search(EQS, ("rigid_angle", "pair-all"), {})
    assert again.abscissa == pytest.approx(winner.abscissa, abs=1e-4)
    assert again.evolution == pytest.approx(winner.evolution, abs=1e-4)
    assert again.adaptation == pytest.approx(winner.adaptation, abs=1e-4)
    assert (again.seed, again.evaluations) == (winner.seed, winner.evaluations)


@pytest.mark.parametrize("system", LOOPS)
def test_the_tables_tell_what_each_way_found_alone(system):
    columns = search.beside_bounds(EQS, system)
    for winner in (w for w in WINNERS if w.system == system):
        told = columns[search.OBJECTIVES[winner.objective]]
        assert float(told["evolution alone found (1/s)"]) == pytest.approx(winner.evolution, abs=5e-5)
        assert float(told["adaptation alone found (1/s)"]) == pytest.approx(winner.adaptation, abs=5e-5)


def test_where_chapter_vii_says_that_both_ways_agree():
    """Of the problems with a jet: all of Figure 25's, and a pair held with everything free."""
    agree = {
        (w.system, w.objective)
        for w in WINNERS
        if LOOPS[w.system] is LOOPS["dual_actuation"] and max(w.evolution, w.adaptation) <= w.abscissa + 1e-3
    }
    free = {("dual_actuation", "pair-all"), ("dual_actuation", "pair-apart")}
    assert agree == free | {("figure_25", objective) for objective in search.OBJECTIVES}


def test_where_chapter_vii_says_that_four_runs_agree():
    """With a jet: all of Figure 25's, all with a pair held, and the modest jet's with all roots counted."""
    jets = {(w.system, w.objective): w for w in WINNERS if LOOPS[w.system] is LOOPS["dual_actuation"]}
    agree = {key for key, w in jets.items() if w.worst <= w.abscissa + 1e-3}
    free = {("modest_jet", "apart"), ("dual_actuation", "all"), ("dual_actuation", "apart")}
    assert agree == set(jets) - free
    assert all(w.descents <= w.worst for key, w in jets.items() if key in agree)
