"""The live view of the ascent: its flights are those that Python integrates."""

import math

import numpy as np
import pytest

from rlswaim.explorers import ascent
from rlswaim.vehicle import trajectory
from small_views import ASCENT, BOOSTER, opened, random_states, view_of


class TestAscent:
    def test_the_start_is_the_program_of_the_book(self):
        programs = trajectory.turn(0.0, ASCENT.t_burn), trajectory.level_at_burnout(ASCENT)
        assert [programs[0](t) for t in (0, 30, 110)] == pytest.approx([programs[1](t) for t in (0, 30, 110)])
        assert trajectory.turn(10.0, 60.0)(5.0) == math.pi / 2
        assert trajectory.turn(10.0, 60.0)(70.0) == 0

    def test_a_flight_is_not_level_before_it_turns(self):
        with pytest.raises(ValueError, match="level - upright in turn: got -5"):
            trajectory.turn(20.0, 15.0)

    def test_the_browser_shows_the_flights_and_what_lies_between(self, browser):
        view = view_of("trajectory")
        states = [{"upright": 6, "level": 134}, *random_states(view, 12, seed=4)]
        with opened(browser, view) as page:
            found = page.evaluate(
                """([payload, states]) => states.map(s => {
                     const { curves, peak } = module.default.flight(payload, s);
                     return [curves, peak];
                   })""",
                [view.payload, states],
            )
        for state, (curves, peak) in zip(states, found, strict=True):
            flown = trajectory.fly(ASCENT, trajectory.turn(*map(float, state.values())), ascent.TIMES)
            known = state["upright"] in ascent.UPRIGHT and state["level"] in ascent.LEVEL
            for name, digits in ascent.CURVES.items():
                within = 0.5 * 10.0**-digits * 1.01 + (0 if known else 1.3 * view.payload["accuracy"][name])
                assert abs(np.array(curves[name]) - getattr(flown, name)).max() <= within, (state, name)
            fine = trajectory.fly(
                ASCENT, trajectory.turn(*map(float, state.values())), np.arange(0, 100.05, 0.1)
            )
            assert peak["size"] == pytest.approx(fine.peak[1], rel=0.02)
            assert peak["time"] == pytest.approx(fine.peak[0], abs=0.15 if known else 2.0)

    def test_accuracy_is_that_of_the_cells(self):
        off = view_of("trajectory").payload["accuracy"]
        assert 0 < off["U"] < 5
        assert 0 < off["h"] < 200
        assert 0 < off["q_D"] < 40

    def test_nearest_program_misses_least(self):
        tables = ascent.flights(ASCENT, tuple(ascent.UPRIGHT), tuple(ascent.LEVEL))
        best = ascent.nearest_program(tables, BOOSTER.flight)

        def miss(upright: float, level: float) -> float:
            flown = trajectory.fly(ASCENT, trajectory.turn(upright, level), [0.0, BOOSTER.flight.t])
            return max(abs(getattr(flown, n)[-1] / getattr(BOOSTER.flight, n) - 1) for n in ascent.CURVES)

        rivals = [(float(u), float(v)) for u in ascent.UPRIGHT for v in ascent.LEVEL[::2]]
        assert miss(*best) <= min(miss(*rival) for rival in rivals) + 1e-3
