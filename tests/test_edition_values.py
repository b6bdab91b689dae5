"""Values of the edition that the book alone would show, beside the same computed another way."""

from decimal import Decimal

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import (
    conclusions,
    consistent_vehicles,
    designs,
    firm_claims,
    matching,
    reduced_loading,
    robustness,
    search,
    section_6,
)
from rlswaim.loops import certificates, closed_loops
from rlswaim.loops.closed_loops import LOOPS, state_space
from rlswaim.source.tables import printed
from rlswaim.vehicle import trajectory
from rlswaim.vehicle.equations import printed_coefficients
from systems import rounding_of

EQS = rl.printed_equations()
ENTRIES = {entry.id: entry for entry in rl.ledger()}


# ---- the constant term of theta/delta


def at_rest(coefficients):
    """Return Eq. 29's determinant over U at s = 0, the thrust's column in theta's place."""
    columns = (("alpha", 1), ("delta", -1), ("q1", 1), ("q2", 1))
    rows = [
        [sign * coefficients[f"{row}_{name}"] for name, sign in columns] for row in ("Z", "M", "F1", "F2")
    ]
    return np.linalg.det(rows) / EQS.U


def test_the_constant_term_and_its_reach_are_those_of_a_determinant():
    value, reach = conclusions.constant_term(EQS)
    here, total = at_rest(EQS.coefficients), 0.0
    for name, text in printed_coefficients().items():
        half = 0.5 * 10.0 ** int(Decimal(text).as_tuple().exponent)
        total += abs(at_rest({**EQS.coefficients, name: EQS.coefficients[name] + half}) - here)
    assert (value, reach) == (pytest.approx(here, abs=1e-12), pytest.approx(total, rel=1e-9))
    assert (value, reach) == pytest.approx((-0.00144, 0.00604), abs=5e-6)


def test_the_odd_pole_and_its_zero_have_these_values():
    assert conclusions.interlacing(EQS) == pytest.approx((1.1485, 1.3097), abs=5e-5)


# ---- what the last printed digits can do to a claim


def test_a_claim_is_judged_at_every_foot_or_at_the_pair_that_stands_for_all():
    stations = {claim.split(":")[0]: places for claim, (_, places) in firm_claims.CLAIMS.items()}
    assert stations == {"IV": (*range(421),), "V": (*range(421),), "VI": (0,)}


@pytest.mark.parametrize("gravity", [False, True], ids=["without gravity", "with gravity"])
@pytest.mark.parametrize("claim", ["VI: no gains stabilize", "VI: no gains leave only a slow root"])
def test_no_last_digits_tried_bring_a_claim_nearer_than_it_says(claim, gravity):
    found, (how, _) = firm_claims.judged(claim, gravity), firm_claims.CLAIMS[claim]
    eqs, names = rl.printed_equations(gravity), list(printed_coefficients())
    singles = [how(firm_claims.moved(eqs, {name: units}), 0.0) for name in names for units in (-0.5, 0.5)]
    draw = np.random.default_rng(1964)
    signs = draw.choice([-0.5, 0.5], (15, len(names)))
    several = [how(firm_claims.moved(eqs, dict(zip(names, row, strict=True))), 0.0) for row in signs]
    assert found.last_digits <= min(*singles, *several) + 1e-9
    if gravity:  # all together do more than any one alone
        assert found.last_digits < min(singles) - 1e-3


# ---- Eqs. 115 and 118


def printed_roots(start):
    """Return printed roots by their ids, of a pair both."""
    value = {name: entry.value for name, entry in ENTRIES.items() if name.startswith(start)}
    pairs = [complex(v, value[n.replace("-re", "-im")]) for n, v in value.items() if n.endswith("-re")]
    return [*(complex(v) for n, v in value.items() if n.endswith("-root")), *pairs, *np.conj(pairs)]


def test_eq_118_as_printed_is_its_own_poles_and_the_zeros_of_eq_108():
    s = np.array([0.5, 2j, -3 + 1j])
    top = np.prod([s - z for z in [0, -1, *printed_roots("eq108-z")]], axis=0)
    bottom = np.prod([s - p for p in [0, *printed_roots("eq118-p")]], axis=0)
    assert len(printed_roots("eq118-p")) == 7
    np.testing.assert_allclose(section_6.printed_second_loop()(s), 1356 * top / bottom, rtol=1e-9)


# ---- the winners beside their bounds


@pytest.mark.parametrize("system", LOOPS)
def test_winners_stand_beside_their_bounds(system):
    winners = [w for w in search.winners() if w.system == system]
    between, *columns = search.beside_bounds(EQS, system).values()
    assert len(columns) == len(winners) > 0
    rows = search.bounds(system)
    for text, row in zip(between.values(), rows.values(), strict=True):
        assert text == (
            f"fixed: {row['low']}" if row["low"] == row["high"] else f"{row['low']} to {row['high']}"
        )
    for column, winner in zip(columns, winners, strict=True):
        texts = list(column.values())
        gains = [float(text) for text in texts[: len(rows)]]
        assert gains == pytest.approx([winner.gains[name] for name in rows], rel=1e-4)
        poles = state_space(EQS, system, winner.gains).poles()
        slow = min(poles, key=abs)
        if slow.imag or abs(slow) > 1 / 110:
            assert texts[-2:] == ["none", ""]
        else:
            assert float(texts[-2]) == pytest.approx(slow.real, rel=0.06, abs=1e-12)
            assert not slow or float(texts[-1]) == pytest.approx(abs(1 / slow), abs=0.51)
        apart = winner.objective.endswith("apart") and texts[-2] != "none"
        largest = max(p.real for p in poles if not (apart and p == slow))
        polynomial = closed_loops.polynomial(EQS, system, winner.gains)
        shaky = rounding_of(polynomial, poles).max() > 1e-6  # floats give roots that meet to few digits alone
        assert float(texts[len(rows)]) == pytest.approx(winner.abscissa, abs=1.01e-4)
        assert largest == pytest.approx(winner.abscissa, abs=0.05 if shaky else 1.01e-4)
        descents = [way for way in (winner.descents, winner.worst) if not np.isnan(way)]
        ways = [winner.evolution, winner.adaptation, *descents]
        second, *told = (float(text) for text in texts[len(rows) + 1 : -2])
        # Three decimals are told.
        assert second == pytest.approx(winner.abscissa, abs=0.05 if shaky else 6e-4)
        assert told == pytest.approx(ways, abs=1.01e-4)
        assert winner.abscissa <= min(winner.evolution, winner.adaptation) + 1e-9


def test_units_stand_in_the_names_of_the_rows():
    names = list(next(iter(search.beside_bounds(EQS, "dual_actuation").values())))
    assert names == [
        *("$K_{A}$", "$K_{C}$ (1/s)", "$K_{R}$ (s)", "$kK_{z}$ (lb s/ft)", "$K_{r}$ (1/s)", "$b$ (1/s)"),
        *("sensor (ft)", "jet (ft)"),
    ]


# ---- printed roots and numbers


ROOTS = [
    *(("IV", start) for start in ("eq77-", "eq78-", "eq79-", "eq80-", "eq81-", "eq82-", "eq92-")),
    *(("IV", start) for start in ("fig8-mode1", "fig11-sp")),
    *(("V", "eq108-z"), ("V", "fig16-sp"), ("VI", "eq115-z"), ("VI", "eq118-p")),
]


@pytest.mark.parametrize(("section", "start"), ROOTS, ids=[start for _, start in ROOTS])
def test_a_printed_root_gives_its_own_numbers_again(section, start):
    """Whichever two numbers the report prints of a root, the root that is made of them has these two."""
    rows, found = printed(section), matching.printed_roots(section, start)
    assert found
    for name, root in found.items():
        kinds = [kind for kind in matching.KINDS if f"{name}-{kind}" in rows]
        assert len(kinds) == (1 if kinds == ["root"] else 2)
        for kind in kinds:
            assert matching.KINDS[kind](root) == pytest.approx(rows[f"{name}-{kind}"], rel=1e-12)
        assert root.imag >= 0


@pytest.mark.parametrize(
    ("section", "start", "text"),
    [
        ("IV", "eq92-p", "1.31, −1.543, −.012 ± j1.15, −.031 ± j3.051"),
        ("IV", "eq77-", "1.08, −1.28, s² + .0406 s + 1.817, −10, 0"),
        ("IV", "fig8-mode1", "2 rad/s and 0.5"),
        ("V", "eq108-z", "3.2 ± j2.625, −3.315 ± j3.81"),
        ("VII", "eq135-", "1.348, 28.121, −1.513, −.3 ± j3.648"),
    ],
    ids=["Eq. 92", "Eq. 77", "Figure 8", "Eq. 108", "Eq. 135"],
)
def test_printed_roots_are_told_with_the_report_s_digits(section, start, text):
    assert matching.as_printed(section, start) == text


def test_instruments_stand_where_the_report_puts_them():
    """Gyros of Section IV, sensors of Sections V to VII, the jet of Figure 24."""
    assert designs.instrument_stations() == {
        "gyros": (60, 304, 400),
        "linear sensors": (20, 39, 140, 300, 420),
        "jet": (140,),
    }


def test_a_coefficient_moves_by_units_of_its_last_printed_digit():
    """M_q1 is printed as -.087, Z_delta with the most figures as -81.0."""
    moved = firm_claims.moved(EQS, {"M_q1": 0.5, "Z_delta": -2.0}).coefficients
    assert moved["M_q1"] == pytest.approx(-0.0865, abs=1e-12)
    assert moved["Z_delta"] == pytest.approx(-81.2, abs=1e-12)
    kept = set(moved) - {"M_q1", "Z_delta"}
    assert {name: moved[name] for name in kept} == {name: EQS.coefficients[name] for name in kept}


def test_every_claim_is_judged_without_gravity_and_with_it(monkeypatch):
    monkeypatch.setattr(firm_claims, "judged", lambda claim, gravity: (claim, gravity))
    claims = list(firm_claims.CLAIMS)
    assert list(firm_claims.judgements()) == [(c, False) for c in claims] + [(c, True) for c in claims]


def test_a_survey_proves_for_a_gyro_at_station_60():
    """For a gyro a foot away the margin is another."""
    booster = rl.swaim_booster()
    (found,) = consistent_vehicles.survey({"it": booster}).margin
    near = [
        certificates.stability_certificate(rl.perturbation_equations(booster), x).margin
        for x in (59.0, 60.0, 61.0)
    ]
    assert found == near[1]
    assert min(abs(near[0] - found), abs(near[2] - found)) > 1e-4


def test_the_vehicle_along_the_burn_has_the_speed_and_air_of_the_flight():
    ascent, at = trajectory.swaim_ascent(), 63.37
    program = trajectory.level_at_burnout(ascent)
    flight = reduced_loading.along_the_burn(rl.swaim_booster(), ascent, program)(at).flight
    exact = trajectory.fly(ascent, program, [0.0, at])
    assert (flight.U, flight.h) == pytest.approx((exact.U[1], exact.h[1]), rel=2e-6)
    assert (flight.q_D, flight.t) == pytest.approx((exact.q_D[1], at), rel=5e-6)
    assert flight.gamma_0 == pytest.approx(np.pi / 2 * (1 - at / 110))


def test_the_last_of_the_flight_conditions_is_at_the_largest_pressure_of_the_flight():
    ascent = trajectory.swaim_ascent()
    program = trajectory.level_at_burnout(ascent)
    found = consistent_vehicles.flight_conditions(rl.swaim_booster(), ascent, program)
    flight = found["integrated, at its largest q_D"]
    around = trajectory.fly(ascent, program, [0.0, flight.t - 0.5, flight.t, flight.t + 0.5])
    assert flight.q_D == pytest.approx(around.q_D[2], rel=1e-5)
    assert flight.q_D > max(around.q_D[1], around.q_D[3])


# ---- what a loop bears, as the book's table says it


def test_the_table_tells_what_a_loop_bears():
    """Largest real parts and slow roots by eigenvalues, margins to the digits that they are found to."""
    gains, booster = conclusions.found_gains("dual_actuation"), rl.swaim_booster()
    told = list(robustness.borne(EQS, booster, gains).values())
    own = rl.perturbation_equations(booster)
    cases = [rl.dual_actuation(eqs, **gains).poles()[None] for eqs in (EQS, own)]
    cases += [robustness.misread(EQS, gains), robustness.reshaped(booster, gains)]
    for text, sets in zip(told, cases, strict=False):
        worst, slow = [], []
        for poles in sets:
            near = poles[np.abs(poles).argmin()]
            apart = near.imag == 0 and abs(near) <= 1 / 110
            slow += [near.real] if apart else []
            worst.append(max(p.real for p in poles if not (apart and p == near)))
        slow_text = f"{max(slow):+.2g}" if slow else "none"
        assert text == f"{max(worst):.3f}, slow root {slow_text}"
    for actuator, (factors, delay) in {"thrust": told[4:6], "jet": told[6:]}.items():
        found = robustness.margins(EQS, gains, actuator)
        assert delay == f"{found.delay:.2g}"
        low, high = factors.split(", ")
        assert low == (f"down to {found.lower:.2f}" if found.lower > 0 else "any less")
        assert high == (f"up to {found.upper:.2f}" if found.upper < np.inf else "any more")
    assert len(told) == 8
