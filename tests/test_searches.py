"""Searches over all gains: the machinery, the stored winners, and the proofs they may not contradict."""

from functools import cache

import mpmath
import numpy as np
import pytest

import rlswaim as rl
from exact import exact_roots, paired
from rlswaim.edition import (
    adaptation,
    conclusions,
    long_searches,
    search,
)
from rlswaim.edition.slow_roots import abscissas, slow_bound
from rlswaim.loops import certificates, closed_loops, gain_terms, rigid_body_design
from rlswaim.loops.closed_loops import LOOPS
from rlswaim.loops.control_systems import RATE_ATTITUDE
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.rootlocus.exact_polynomials import exact_characteristic_polynomial
from rlswaim.rootlocus.polynomials import roots
from systems import polynomial_at, rounding_of

EQS = rl.printed_equations()
OWN = rl.perturbation_equations(rl.swaim_booster())
WINNERS = search.winners()
IDS = [f"{w.system}-{w.objective}" for w in WINNERS]
SLOW = slow_bound()


def sampled(system, n=6):
    """Return gains of a system spread over its bounds."""
    u = np.random.default_rng(1964).random((len(search.bounds(system)), n))
    return {
        name: search._spread(row, x) for (name, row), x in zip(search.bounds(system).items(), u, strict=True)
    }


def one(sampled_gains, i):
    return {name: float(values[i]) for name, values in sampled_gains.items()}


@cache
def exact_poles(at):
    """Return the poles of a winner's wired state space: exact arithmetic, 60 digits, then rounded."""
    A = closed_loops.state_space(EQS, WINNERS[at].system, WINNERS[at].gains).A
    with mpmath.workdps(60):
        p = [mpmath.mpf(c.numerator) / c.denominator for c in exact_characteristic_polynomial(A)]
    found = exact_roots(p)
    return np.where(np.abs(found.imag) < 1e-12, found.real, found)


def test_four_roots_of_the_best_attitude_loop_lie_equally_far_right_and_two_nearly_meet():
    poles = exact_poles(IDS.index("rate_attitude-all"))
    first = poles[poles.real > poles.real.max() - 1e-6]
    assert first.real == pytest.approx([0.58756] * 4, abs=5e-6)
    real, paired_up = sorted(np.abs(first.imag))[:2], sorted(np.abs(first.imag))[2:]
    assert max(real) < 1e-4
    assert paired_up == pytest.approx([0.43225] * 2, abs=5e-5)


# ---- the machinery


@pytest.mark.parametrize("system", LOOPS)
@pytest.mark.parametrize("eqs", [EQS, OWN], ids=["printed", "data"])
def test_matrices_are_those_of_the_wired_loops(system, eqs):
    g = sampled(system)
    for i, A in enumerate(LOOPS[system].around(eqs).matrices(**g)):
        wired = closed_loops.state_space(eqs, system, one(g, i)).A
        assert (np.abs(A - wired) <= 1e-12 * np.abs(wired).max(axis=1, keepdims=True)).all()


@pytest.mark.parametrize("system", LOOPS)
def test_matrices_have_the_exact_polynomials_of_the_wired_loops(system):
    g = sampled(system)
    for i, A in enumerate(LOOPS[system].around(EQS).matrices(**g)):
        p = [
            float(c)
            for c in exact_characteristic_polynomial(closed_loops.state_space(EQS, system, one(g, i)).A)
        ]
        q = [float(c) for c in exact_characteristic_polynomial(A)]
        np.testing.assert_allclose(q, p, rtol=1e-9, atol=1e-11 * np.abs(p).max())


@pytest.mark.parametrize("system", LOOPS)
def test_a_wanted_pair_is_held(system):
    g = LOOPS[system].around(EQS).with_pair(sampled(system))
    for i in range(6):
        assert polynomial_at(closed_loops.polynomial(EQS, system, one(g, i)), WANTED) < 1e-11


def test_a_wanted_pair_takes_the_gains_that_the_coefficients_give():
    g = RATE_ATTITUDE.around(EQS).with_pair({"K_C": np.array([10.0]), "gyro": np.array([60.0])})
    assert (g["K_A"][0], g["K_R"][0]) == pytest.approx(gain_terms.gains_for_pole(EQS, WANTED, 10.0, 60.0))


@pytest.mark.parametrize(
    ("poles", "apart", "wanted"),
    [
        ([-1, SLOW / 2, -3], True, -1),
        ([-1, SLOW / 2, -3], False, SLOW / 2),
        ([-1, 2 * SLOW, -3], True, 2 * SLOW),
        ([-1, 1e-3 + 1e-3j, 1e-3 - 1e-3j], True, 1e-3),
        ([0, SLOW / 2, -1], True, SLOW / 2),
    ],
    ids=["slow", "counted", "too fast", "a pair", "only one"],
)
def test_one_slow_real_root_is_set_apart(poles, apart, wanted):
    assert abscissas(np.array([poles], complex), apart)[0] == wanted


def test_spread_covers_the_bounds():
    for system, loop in LOOPS.items():
        without = {"gyro"} if system == "rigid_angle" else set()
        assert set(search.bounds(system)) == {*loop.gains, *loop.stations} - without
        for row in search.bounds(system).values():
            ends = search._spread(row, np.array([0.0, 1.0]))
            np.testing.assert_allclose(ends, [float(row["low"]), float(row["high"])], rtol=1e-9)


@pytest.mark.parametrize(("system", "objective"), [("section_4", "all"), ("single_sensor", "best")])
def test_an_unknown_name_is_told(system, objective):
    with pytest.raises(ValueError, match=r"search: got '.*', wanted one of"):
        search.search(EQS, system, objective)


@pytest.mark.parametrize("system", LOOPS)
def test_a_place_in_the_cube_is_found_again(system):
    for row in search.bounds(system).values():
        if row["low"] != row["high"]:
            u = np.array([0.0, 0.1, 0.5, 0.9, 1.0])
            values = search._spread(row, u)
            assert [search._place(row, x) for x in values] == pytest.approx(u, abs=1e-9)


def test_adaptation_follows_a_valley_without_a_gradient():
    """The least of the largest of four slopes lies at a kink, far narrower one way than the other."""
    wanted = np.array([0.3, 0.8, 0.41, 0.52])
    slopes = np.array([1.0, 30.0, 300.0, 3.0])

    def cost(u):
        off = u - wanted[:, None]
        return np.abs(slopes[:, None] * (off + off.sum(axis=0))).max(axis=0)

    place, least = adaptation.adapted(cost, np.full(4, 0.5), 0.2, np.random.default_rng(1964), 600)
    assert least < 1e-6
    np.testing.assert_allclose(place, wanted, atol=1e-6)


def test_adaptation_stays_in_the_cube_and_never_gets_worse():
    place, least = adaptation.adapted(
        lambda u: -u.sum(axis=0), np.full(3, 0.2), 0.1, np.random.default_rng(1), 300
    )
    assert least == pytest.approx(-3, abs=1e-4)
    assert (place <= 1).all()
    start = np.array([0.2, 0.4])
    kept, same = adaptation.adapted(
        lambda u: np.abs(u - start[:, None]).sum(axis=0), start, 0.1, np.random.default_rng(1), 50
    )
    assert (kept == start).all()
    assert same == 0


@pytest.mark.parametrize("objective", ["all", "pair-apart"])
def test_a_long_search_keeps_what_a_harder_problem_found(objective, monkeypatch):
    """Almost without generations of its own it is no worse than the winners it starts from."""
    few_of = ("ROUNDS", "ADAPTED", "LAST", "SHORT_ROUNDS", "STARTS", "SETTLED", "HOPS", "AROUND", "FEW")
    for name, few in (*((name, 1) for name in few_of), ("DESCENTS", 2), ("SHORT", 2)):
        monkeypatch.setattr(long_searches, name, few)
    key = ("dual_actuation", objective)
    found = long_searches.long_search(EQS, key, rl.searches())
    harder = [rl.searches()[inner].abscissa for inner in long_searches.constrained(*key)]
    assert found.abscissa <= min(harder) + 1e-4
    assert found.abscissa <= min(found.evolution, found.adaptation, found.descents) + 1e-4
    assert found.descents <= found.worst
    assert found.evaluations > 0


# ---- the stored winners


def test_every_system_has_every_objective():
    assert [(w.system, w.objective) for w in WINNERS] == [(s, o) for s in LOOPS for o in search.OBJECTIVES]


def test_winners_are_offered_by_system_and_objective():
    offered = rl.searches()
    assert list(offered.values()) == list(WINNERS)
    best = offered["modest_jet", "pair-all"]
    assert set(best.gains) == set(search.bounds("modest_jet"))
    assert rl.dual_actuation(EQS, **best.gains).poles().real.max() == pytest.approx(best.abscissa, abs=1e-3)


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_winner_lies_within_its_bounds(winner):
    for name, row in search.bounds(winner.system).items():
        assert float(row["low"]) <= winner.gains[name] <= float(row["high"])


@pytest.mark.parametrize("at", range(len(WINNERS)), ids=IDS)
def test_winner_holds_two_ways(at):
    """The wired state space, in exact arithmetic, and the determinants, in floats: the same roots."""
    winner, state = WINNERS[at], exact_poles(at)
    polynomial = closed_loops.polynomial(EQS, winner.system, winner.gains)
    assert max(polynomial_at(polynomial, pole) for pole in state) < 1e-9
    if rounding_of(polynomial, state).max() < 1e-6:  # floats give roots that meet to few digits alone
        other = roots(polynomial)
        assert np.abs(other - paired(other, state)).max() < 1e-4 * np.abs(state).max()
    value = abscissas(state[None], winner.objective.endswith("apart"))[0]
    assert value == pytest.approx(winner.abscissa, rel=5e-5, abs=1e-4)  # five digits are stored
    if winner.objective.startswith("pair"):
        assert np.abs(state - WANTED).min() < 1e-3


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_a_short_search_repeats_itself_and_does_not_beat_the_long_one(winner):
    first, again = (search.search(EQS, winner.system, winner.objective, rounds=15) for _ in range(2))
    assert first == again
    assert first.abscissa >= winner.abscissa - 1e-3


# ---- proofs and searches


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_winner_contradicts_no_proof(winner):
    if "jet" in winner.gains:
        assert winner.abscissa < 0
        return
    sensors = [winner.gains[n] for n in ("sensor", "sensor_a", "sensor_b") if n in winner.gains]
    gyro, slow = winner.gains.get("gyro"), SLOW if winner.objective.endswith("apart") else 0.0
    apart = certificates.slow_root_certificate(EQS, gyro, sensors, slow)
    proved = apart > 1e-9 or (not slow and certificates.stability_certificate(EQS, gyro, sensors).margin <= 0)
    assert proved == (winner.abscissa > 0)


@pytest.mark.parametrize("eqs", [EQS, OWN], ids=["printed", "data"])
@pytest.mark.parametrize("gyro", [None, 0.0, 60.0, 304.0, 400.0, 420.0])
def test_rate_and_attitude_feedback_leaves_more_than_a_slow_root(eqs, gyro):
    assert certificates.slow_root_certificate(eqs, gyro, slow=SLOW) > 1


@pytest.mark.parametrize(("sensor", "proved"), [(140, True), (207, True), (25, False), (229, False)])
def test_one_sensor_is_ruled_out_where_the_proof_says_so(sensor, proved):
    assert (certificates.slow_root_certificate(EQS, None, [float(sensor)], SLOW) > 1e-9) == proved


def test_without_payload_surface_nothing_is_ruled_out():
    eqs = rl.perturbation_equations(conclusions.surfaces_cut(rl.swaim_booster())["payload surface halved"])
    assert certificates.stability_certificate(eqs, 370.0).margin == np.inf
    assert certificates.slow_root_certificate(eqs, 370.0) == pytest.approx(0, abs=1e-9)


def test_a_slow_root_that_may_be_fast_rules_nothing_out():
    """Without a bound on it the unstable root itself is the one set apart."""
    assert certificates.slow_root_certificate(EQS, 60.0, slow=2.0) == pytest.approx(0, abs=1e-9)


# ---- Section VIII

BY_HAND = conclusions.found_gains("dual_actuation")


def test_the_jet_halves_the_bending_where_there_is_little_interaction():
    free, held = (conclusions.damped(rl.swaim_booster(), kK_z) for kK_z in (0.0, 3e4))
    assert free.jet == 0
    assert held.zeta > 2.5 * free.zeta
    assert held.q1 < 0.55 * free.q1


def test_gust_response_is_the_area_under_the_frequency_response():
    found = conclusions.damped(rl.swaim_booster(), 3e4)
    stiff = conclusions.stiffened(rl.swaim_booster(), 5.0)
    eqs = rl.perturbation_equations(stiff)
    design = rigid_body_design.rigid_design(rigid_body_design.rigid_body(eqs), omega=2.0, zeta=0.5, K_C=10)
    loop = rl.dual_actuation(eqs, **BY_HAND | {"kK_z": 3e4, "K_A": design.K_A, "K_R": design.K_R})
    w = np.linspace(0, 100, 25_001)
    response = loop[loop.find_output("q1"), loop.find_input("alpha_g")](1j * w)
    assert np.sqrt(np.trapezoid(np.abs(response) ** 2, w) / np.pi) == pytest.approx(found.q1, rel=1e-3)


def test_the_equation_along_x_leaves_the_divergence():
    """Without a steady angle of attack the equation along x follows the others and moves no root."""
    for gamma_0 in (0.0, 0.75):
        found = conclusions.with_longitudinal(EQS, 0.0, gamma_0)
        assert found == pytest.approx(max(roots(EQS.characteristic_polynomial()).real))


def test_half_the_payload_surface_lets_rate_and_attitude_feedback_work():
    cut = conclusions.surfaces_cut(rl.swaim_booster())
    halved, finless = (conclusions.steered(cut[name], 150) for name in ("payload surface halved", "no fins"))
    assert halved.abscissa < 0 < halved.ruled_out < halved.stations
    assert finless.ruled_out == finless.stations
    assert np.isnan(finless.abscissa)
