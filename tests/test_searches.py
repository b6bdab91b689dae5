"""Searches over all gains: the machinery, the stored winners, and the proofs they may not contradict."""

from functools import cache

import control
import mpmath
import numpy as np
import pytest

import rlswaim as rl
from exact import exact_roots, paired
from rlswaim.edition import conclusions, robustness, search, simultaneous_margins
from rlswaim.loops import certificates, closed_loops, rigid_body_design
from rlswaim.loops.closed_loops import LOOPS
from rlswaim.loops.control_systems import RATE_ATTITUDE
from rlswaim.loops.given_shapes import with_shapes
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.rootlocus.polynomials import exact_characteristic_polynomial, roots
from systems import polynomial_at

EQS = rl.printed_equations()
OWN = rl.perturbation_equations(rl.swaim_booster())
WINNERS = search.winners()
IDS = [f"{w.system}-{w.objective}" for w in WINNERS]
SLOW = search.slow_bound()


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
    assert (g["K_A"][0], g["K_R"][0]) == pytest.approx(certificates.gains_for_pole(EQS, WANTED, 10.0, 60.0))


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
    assert search.abscissas(np.array([poles], complex), apart)[0] == wanted


def test_spread_covers_the_bounds():
    for system in LOOPS:
        for row in search.bounds(system).values():
            ends = search._spread(row, np.array([0.0, 1.0]))
            np.testing.assert_allclose(ends, [float(row["low"]), float(row["high"])], rtol=1e-9)


@pytest.mark.parametrize(("system", "objective"), [("section_4", "all"), ("single_sensor", "best")])
def test_an_unknown_name_is_told(system, objective):
    with pytest.raises(ValueError, match=r"search: got '.*', wanted one of"):
        search.search(EQS, system, objective)


# ---- the stored winners


def test_every_system_has_every_objective():
    assert [(w.system, w.objective) for w in WINNERS] == [(s, o) for s in LOOPS for o in search.OBJECTIVES]


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_winner_lies_within_its_bounds(winner):
    for name, row in search.bounds(winner.system).items():
        assert float(row["low"]) <= winner.gains[name] <= float(row["high"])


@pytest.mark.parametrize("at", range(len(WINNERS)), ids=IDS)
def test_winner_holds_two_ways(at):
    """The wired state space, in exact arithmetic, and the determinants, in floats: the same roots."""
    winner, state = WINNERS[at], exact_poles(at)
    other = roots(closed_loops.polynomial(EQS, winner.system, winner.gains))
    assert np.abs(other - paired(other, state)).max() < 1e-4 * np.abs(state).max()
    value = search.abscissas(state[None], winner.objective.endswith("apart"))[0]
    assert value == pytest.approx(winner.abscissa, abs=1e-4)
    if winner.objective.startswith("pair"):
        assert np.abs(state - WANTED).min() < 1e-3


@pytest.mark.parametrize("winner", WINNERS, ids=IDS)
def test_a_short_search_repeats_itself_and_does_not_beat_the_long_one(winner):
    first, again = (search.search(EQS, winner.system, winner.objective, rounds=15) for _ in range(2))
    assert first == again
    assert first.abscissa >= winner.abscissa - 1e-3


def test_a_long_search_gives_its_winner_again():
    winner = next(w for w in WINNERS if (w.system, w.objective) == ("rigid_angle", "pair-all"))
    again = search.search(EQS, winner.system, winner.objective, winner.seed)
    assert again.abscissa == pytest.approx(winner.abscissa, abs=1e-4)
    assert again.evaluations * len(search.SEEDS) == winner.evaluations


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


# ---- what the loops of Section VII bear

BY_HAND = conclusions.found_gains("dual_actuation")
MODEST = next(w.gains for w in WINNERS if (w.system, w.objective) == ("modest_jet", "pair-all"))


def delayed(gains_, actuator, seconds):
    """Return the largest real part with a delay in front of an actuator, as a Pade quotient of order 5."""
    A, at = robustness._matrix(EQS, gains_), robustness.ACTUATORS[actuator]
    num, den = control.pade(seconds, 5)
    lag = control.ss(control.tf(num, den))
    opened, push = A.copy(), np.zeros((9, 1))
    opened[at, :7], push[at] = 0, 1
    loop = control.ss(opened, push, np.r_[A[at, :7], 0, 0][None], 0)
    return control.feedback(loop * lag, 1, sign=1).poles().real.max()


@pytest.mark.parametrize("chosen", [BY_HAND, MODEST], ids=["by hand", "modest jet"])
@pytest.mark.parametrize("actuator", robustness.ACTUATORS)
def test_margins_are_where_the_loop_fails(chosen, actuator):
    found = robustness.margins(EQS, chosen, actuator)
    assert delayed(chosen, actuator, 0.99 * found.delay) < 0 < delayed(chosen, actuator, 1.01 * found.delay)
    A, at = robustness._matrix(EQS, chosen), robustness.ACTUATORS[actuator]
    for factor, stable in (
        (found.lower * 0.99, False),
        (found.lower * 1.01, True),
        (found.upper * 0.99, True),
    ):
        if factor and np.isfinite(factor):
            scaled = A.copy()
            scaled[at, :7] *= factor
            assert (np.linalg.eigvals(scaled).real.max() < 0) == stable


def test_margins_want_a_stable_loop():
    with pytest.raises(ValueError, match=r"gains in margins: got a loop with a root at 1\.26 1/s"):
        robustness.margins(EQS, BY_HAND | {"kK_z": 0.0, "K_A": 1.0}, "jet")


def test_shapes_that_are_right_leave_the_poles():
    poles = np.linalg.eigvals(robustness._matrix(EQS, BY_HAND))
    for other in (
        *robustness.misread(EQS, BY_HAND, 0.0),
        *robustness.reshaped(rl.swaim_booster(), BY_HAND, 0.0),
    ):
        assert np.abs(np.sort_complex(other) - np.sort_complex(poles)).max() < 0.1
    same = robustness.misread(EQS, BY_HAND, 0.0)[0]
    assert np.abs(same - paired(same, poles)).max() < 1e-9


@pytest.mark.parametrize("chosen", [BY_HAND, MODEST], ids=["by hand", "modest jet"])
def test_misread_deflections_are_off_by_what_is_said(chosen):
    """Beside loops that are wired anew, with the deflections of both modes at sensor and jet set by hand."""
    signs = [(i, j, k, m) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1) for m in (-1, 1)]
    at = [(mode, chosen[place]) for place in ("sensor", "jet") for mode in EQS.modes]
    if chosen["sensor"] == chosen["jet"]:  # a place of its own for each reading
        chosen = chosen | {"jet": chosen["jet"] + 1e-9}
    for poles, wrong in zip(robustness.misread(EQS, chosen), signs, strict=True):
        phi = [mode.deflection(x) * (1 + 0.05 * sign) for (mode, x), sign in zip(at, wrong, strict=True)]
        eqs = with_shapes(EQS, {chosen["sensor"]: phi[:2], chosen["jet"]: phi[2:]})
        wired = rl.dual_actuation(eqs, **chosen).poles()
        assert np.abs(poles - paired(poles, wired)).max() < 1e-4


BOTH = {name: simultaneous_margins.together(EQS, g) for name, g in (("by hand", BY_HAND), ("modest", MODEST))}


@pytest.mark.parametrize("name", BOTH)
def test_both_loops_fail_at_their_disk_margin_and_not_within(name):
    found, A = BOTH[name], robustness._matrix(EQS, {"by hand": BY_HAND, "modest": MODEST}[name])
    at_limit = np.linalg.eigvals(simultaneous_margins.scaled(A, found.worst))
    assert np.abs(at_limit - 1j * found.omega).min() < 1e-6 * found.omega
    delta = 2 * (found.worst - 1) / (found.worst + 1)
    assert np.abs(delta) == pytest.approx([found.disk] * 2)
    draw = np.random.default_rng(1964)
    inside = found.disk * 0.995 * np.exp(2j * np.pi * draw.random((4000, 2)))
    poles = np.linalg.eigvals(simultaneous_margins.scaled(A, (1 + inside / 2) / (1 - inside / 2)))
    assert poles.real.max() < 0


@pytest.mark.parametrize("name", BOTH)
def test_gain_and_phase_margins_are_those_of_the_disk(name):
    found, chosen = BOTH[name], {"by hand": BY_HAND, "modest": MODEST}[name]
    A = robustness._matrix(EQS, chosen)
    turns = np.exp(1j * np.radians(0.999 * found.phase) * np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]]))
    ends = np.array([[x, y] for x in (found.lower, found.upper) for y in (found.lower, found.upper)])
    for factors in (turns, ends):
        assert np.linalg.eigvals(simultaneous_margins.scaled(A, factors)).real.max() < 0
    for actuator in robustness.ACTUATORS:
        single = robustness.margins(EQS, chosen, actuator)
        assert single.lower < found.lower
        assert found.upper < single.upper
    assert found.one_down < found.lower


def test_simultaneous_margins_want_a_stable_loop():
    with pytest.raises(ValueError, match=r"gains in together: got a loop with a root at 1\.26 1/s"):
        simultaneous_margins.together(EQS, BY_HAND | {"kK_z": 0.0, "K_A": 1.0})


# ---- Section VIII


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
    assert conclusions.with_longitudinal(EQS, 0.0) == pytest.approx(
        max(roots(EQS.characteristic_polynomial()).real)
    )
    moved = conclusions.with_longitudinal(EQS, np.radians(5)) - conclusions.with_longitudinal(EQS, 0.0)
    assert 1e-3 < abs(moved) < 0.01


def test_half_the_payload_surface_lets_rate_and_attitude_feedback_work():
    cut = conclusions.surfaces_cut(rl.swaim_booster())
    halved, finless = (conclusions.steered(cut[name], 150) for name in ("payload surface halved", "no fins"))
    assert halved.abscissa < 0 < halved.ruled_out < halved.stations
    assert finless.ruled_out == finless.stations
    assert np.isnan(finless.abscissa)
