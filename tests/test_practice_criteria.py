"""Criteria of closed loops against simulations, and what an unstable loop gets."""

from dataclasses import replace

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import criteria, loads
from rlswaim.practice.margins import margins

BOOSTER, EQS = rl.swaim_booster(), rl.printed_equations()
GAINS = {"K_A": 4.4545, "K_C": 8.4816, "K_R": 0.86417, "kK_z": -389252.5, "K_r": 94.027, "b": 2.62154}
JET = 270.588
LOOP = rl.dual_actuation(EQS, **GAINS, sensor=56.9915, jet=JET)
WITH_MOMENTS = loads.with_moments(LOOP, loads.section_loads(BOOSTER, EQS, [200.0], JET))
OPEN = control.ss(control.zpk([], [-1, -2, -5], 20))
FOUND = {c.name: c for c in criteria.evaluate(WITH_MOMENTS, EQS.U, OPEN, {"bending 1": 30.0})}


def test_every_criterion_is_there():
    peaks = {"settling", *criteria.GUST_PEAKS, "moment 200"}
    by_mode = {"disk", "rigid gain_dB", "rigid phase_deg", "rigid delay_s", "aero gain_dB"}
    bending = {"bending 1 gain_dB", "bending 1 phase_deg", "bending 1 delay_s"}
    assert set(FOUND) == peaks | by_mode | bending


def test_peaks_are_those_of_simulated_gusts():
    want = criteria.wanted()
    for duration in (1.0, 3.0, 8.0):
        frame = criteria.gust_response(LOOP, EQS.U, want.gust_ft_s, duration)
        for name, (output, unit) in criteria.GUST_PEAKS.items():
            assert frame[output].abs().max() * unit <= FOUND[name].value * 1.01
        rate = np.gradient(frame["delta"], frame.index)
        assert np.allclose(rate[2:-2], frame["delta_rate"].iloc[2:-2], atol=0.01 * np.abs(rate).max())


def test_drift_is_the_velocity_across_the_path():
    frame = criteria.gust_response(LOOP, EQS.U, 30.0, 3.0)
    assert np.allclose(frame["drift"], EQS.U * (frame["alpha"] - frame["theta"]))
    assert frame["incidence"].iloc[0] == pytest.approx(0.0)


def test_margins_are_those_of_the_open_loop():
    found = margins(OPEN)
    assert FOUND["disk"].value == found.disk
    assert FOUND["rigid gain_dB"].value == pytest.approx(found.gain[0].dB)
    assert FOUND["aero gain_dB"].value == np.inf


def test_settling():
    first = control.ss([[-1.0]], [[1.0]], [[1.0]], [[0.0]], inputs="theta_c", outputs="theta")
    assert criteria.settling_time(first, 0.1) == pytest.approx(np.log(10), abs=0.011)
    unstable = control.ss([[1.0]], [[1.0]], [[1.0]], [[0.0]], inputs="theta_c", outputs="theta")
    assert criteria.settling_time(unstable, 0.1) == np.inf
    half = control.ss([[-1.0]], [[1.0]], [[0.5]], [[0.0]], inputs="theta_c", outputs="theta")
    assert criteria.settling_time(half, 0.1) == np.inf


def test_a_loop_that_is_not_stable_meets_nothing_in_time():
    closed = rl.rate_attitude(EQS, K_A=1.8, K_C=10, K_R=0.618, gyro=60)
    found = criteria.evaluate(closed, EQS.U)
    assert {c.value for c in found} == {np.inf}
    assert not any(c.met for c in found)


def test_a_loop_that_is_not_stable_has_no_margins():
    closed = rl.rate_attitude(EQS, K_A=1.8, K_C=10, K_R=0.618, gyro=60)
    found = criteria.evaluate(closed, EQS.U, OPEN, {"bending 1": 30.0})
    margins_of_it = [c for c in found if not c.at_most]
    assert [c.name for c in margins_of_it] == [c.name for c in FOUND.values() if not c.at_most]
    assert all(np.isnan(c.value) and c.met is False for c in margins_of_it)


def test_where_nothing_is_wanted_there_is_no_verdict():
    assert FOUND["moment 200"].met is None
    assert {name for name, c in FOUND.items() if c.met is None} == {"moment 200"}
    row = criteria.table(tuple(FOUND.values())).loc["moment 200"]
    assert (row["wanted"], row["met"]) == ("", None)


def test_bounds_can_be_varied_and_are_checked():
    strict = replace(criteria.wanted(), alpha_deg=1e-6)
    found = {c.name: c for c in criteria.evaluate(LOOP, EQS.U, want=strict)}
    assert not found["alpha_deg"].met
    with pytest.raises(ValueError, match="band in Wanted: got 0"):
        replace(criteria.wanted(), band=0.0)


def test_table():
    frame = criteria.table(tuple(FOUND.values()))
    assert list(frame.columns) == ["value", "wanted", "unit", "met"]
    assert list(frame.index) == list(FOUND)
