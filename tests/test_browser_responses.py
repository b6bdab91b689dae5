"""The responses that the browser computes are those of the library's closed loop."""

import math
from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from scipy.linalg import expm, matrix_balance

from browser_maths import EQS, loops, maths_page, presets_of, run, sections, sent, states
from rlswaim.explorers.system_views import VIEWS


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


def response_of(loop: control.StateSpace, stimulus: dict, times: np.ndarray) -> dict[str, np.ndarray]:
    """Return the outputs by matrix exponentials of the closed loop with its input's own equations."""
    n, amplitude, name = loop.nstates, stimulus["amplitude"], stimulus["input"]
    signal = np.zeros((n, 3))
    x = np.zeros(n + 3)
    x[n:] = 1, 1, 0  # 1, cos, sin
    w = 2 * math.pi / stimulus["duration"]
    turning = np.array([[0, 0, 0], [0, 0, -w], [0, w, 0]])
    if stimulus["kind"] == "initial":
        x[loop.state_labels.index(f"x_{name[:-3]}")] = amplitude
    else:
        b = amplitude * loop.B[:, loop.input_labels.index(name)]
        signal[:, 0] = b if stimulus["kind"] == "step" else b / 2
        signal[:, 1] = 0 if stimulus["kind"] == "step" else -b / 2
    full = np.block([[loop.A, signal], [np.zeros((3, n)), turning]])
    balanced, T = matrix_balance(full)
    dt = times[1] - times[0]
    forced = T @ expm(balanced * dt) @ np.linalg.inv(T)
    free = forced.copy()
    free[:n, n:] = 0
    rows = [x]
    for t in times[:-1]:
        over = stimulus["kind"] == "gust" and t > stimulus["duration"] - dt / 2
        rows.append((free if over else forced) @ rows[-1])
    found = np.array(rows)[:, :n] @ loop.C.T
    return dict(zip(loop.output_labels, found.T, strict=True))


def stimuli(section: str) -> list[tuple[dict, np.ndarray]]:
    """Return an input for each random state, over a time in which no motion grows beyond e^12."""
    plant = sent(section)["plant"]
    names = [*plant["inputs"], *(f"{name}(0)" for name in plant["initial"])]
    found = []
    for i, loop in enumerate(loops(section)):
        fastest = max(loop.poles().real.max(), 1e-9)
        end = min(10.0, 12 / fastest)
        name = names[i % len(names)]
        kind = "initial" if name.endswith("(0)") else ("step" if name == "theta_c" else "gust")
        found.append(
            ({"input": name, "kind": kind, "amplitude": 0.1, "duration": 0.4 * end}, np.linspace(0, end, 21))
        )
    return found


@sections
class TestResponses:
    def test_agree_with_python(self, page, section):
        given = stimuli(section)
        found = run(
            page,
            "(s, all, given) => all.map((x, i) => module.responses(s, x, given[i][0], given[i][1]))",
            section,
            states(section),
            [[stimulus, times.tolist()] for stimulus, times in given],
        )
        for state, loop, (stimulus, times), js in zip(
            states(section), loops(section), given, found, strict=True
        ):
            wanted = response_of(loop, stimulus, times)
            assert set(js) == set(VIEWS[section].system.outputs)
            rounding = 1e-11 * stimulus["amplitude"]  # of modes that cancel where a motion has hardly begun
            for name, values in js.items():
                largest = abs(wanted[name]).max()
                off = abs(np.array(values) - wanted[name]).max()
                assert off <= max(1e-6 * largest, rounding), (state, stimulus, name)

    def test_start_at_the_initial_condition(self, page, section):
        stimulus = {"input": "q1(0)", "kind": "initial", "amplitude": 2.0, "duration": 1.0}
        for state in presets_of(section):
            js = run(page, "(s, x, u) => module.responses(s, x, u, [0, 1])", section, state, stimulus)
            assert js["q1"][0] == pytest.approx(2.0, rel=1e-7)
            assert js["theta"][0] == pytest.approx(0.0, abs=1e-7)


@sections
def test_responses_pass_through_coinciding_poles(page, section):
    """Two poles that all but fall together, the actuator's and another, do not spoil each other's part."""
    state = {**presets_of(section)[0], **dict.fromkeys(sent(section)["locus_gains"], 0.0), "K_C": 10.0}
    if section == "VII":
        state |= {"K_r": 10.0}
    else:
        pole = min(root["re"] for root in sent(section)["poles"])
        state |= {"K_C": -pole}
    stimulus = {"input": "theta_c", "kind": "step", "amplitude": 1.0, "duration": 1.0}
    gain = sent(section)["locus_gains"][-1]
    body = "(s, x, u, t) => module.responses(s, x, u, t)"
    times = np.linspace(0, 4, 21)
    js = run(page, body, section, {**state, gain: 1e-9}, stimulus, times.tolist())
    wanted = response_of(VIEWS[section].closed_loop(EQS, **{**state, gain: 1e-9}), stimulus, times)
    for name, values in js.items():
        assert abs(np.array(values) - wanted[name]).max() <= 1e-6 * abs(wanted[name]).max(), name
