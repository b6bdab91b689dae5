"""Closed loops with a compensator: the browser's polynomials are python-control's feedback of the parts."""

from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from scipy.linalg import expm

from browser_maths import EQS, maths_page, order_of, points, presets_of, run, sections, sent
from rlswaim.explorers.system_views import VIEWS
from rlswaim.loops.cut_loop import cut_loop

SECTIONS = {
    "notch": {"kind": "notch", "values": [3.05, 0.05, 0.5]},
    "lag": {"kind": "lead", "values": [-4.0, -0.8]},
    "lead": {"kind": "lead", "values": [-0.7, -6.0]},
    "delay": {"kind": "delay", "values": [0.08, 3]},
    "pole": {"kind": "pole", "values": [-5.0]},
    "integrator": {"kind": "pole", "values": [0.0]},
    "poles": {"kind": "poles", "values": [4.0, 0.3]},
}
CASES = [
    ["notch"],
    ["lag"],
    ["lead"],
    ["delay"],
    ["pole"],
    ["poles"],
    ["integrator"],
    ["notch", "lag", "delay"],
]
POLES = """(s, states, compensator) => {
  const system = module.compensated(s, compensator);
  return states.map((state) => module.closedLoop(system, state));
}"""


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


def ratio(section: dict) -> control.TransferFunction:
    """Return a section by textbook formulas, written anew for python-control."""
    s, v = control.tf("s"), section["values"]
    if section["kind"] == "notch":
        return (s**2 + 2 * v[1] * v[0] * s + v[0] ** 2) / (s**2 + 2 * v[2] * v[0] * s + v[0] ** 2)
    if section["kind"] == "lead":
        return (v[1] / v[0]) * (s - v[0]) / (s - v[1])
    if section["kind"] == "delay":
        return control.tf(*control.pade(*v))
    if section["kind"] == "poles":
        return v[0] ** 2 / (s**2 + 2 * v[1] * v[0] * s + v[0] ** 2)
    return 1 / s if v[0] == 0 else -v[0] / (s - v[0])


def with_control(section: str, state: dict, place: str, gain: float, kinds: list[str]) -> control.StateSpace:
    """Return the closed loop by control.feedback."""
    loop = cut_loop(lambda k: VIEWS[section].closed_loop(EQS, **{**state, place: k}), state[place])
    for kind in kinds:
        loop = control.ss(ratio(SECTIONS[kind])) * loop
    return control.feedback(gain * loop)


@sections
@pytest.mark.parametrize("kinds", CASES, ids="+".join)
def test_poles_are_those_of_control_feedback(page, section, kinds):
    for place in {what["running"] for what in sent(section)["loci"]}:
        states = [{**state, place: state[place] or 0.3} for state in presets_of(section)[:4]]
        compensator = {"place": place, "gain": 1.3, "sections": [SECTIONS[kind] for kind in kinds]}
        for state, found in zip(states, run(page, POLES, section, states, compensator), strict=True):
            ours = points(found)
            theirs = order_of(ours, with_control(section, state, place, 1.3, kinds).poles())
            assert ours == pytest.approx(theirs, rel=1e-8, abs=1e-8)
            assert found["branches"].count("compensator") == ours.size - len(sent(section)["poles"]) - len(
                sent(section)["actuators"]
            )


@sections
def test_responses_go_through_it(page, section):
    """After a displacement of alpha, with the compensator at rest: the loop's own states tell all outputs."""
    state = {**presets_of(section)[0], "K_A": 0.4}
    compensator = {"place": "K_A", "gain": 0.7, "sections": [SECTIONS["notch"], SECTIONS["lag"]]}
    body = """(s, state, compensator, times) => module.responses(module.compensated(s, compensator), state,
      { input: 'alpha(0)', kind: 'initial', amplitude: 1 }, times)"""
    times = np.linspace(0, 3, 61)
    found = run(page, body, section, state, compensator, times.tolist())
    closed = VIEWS[section].closed_loop(EQS, **state)
    loop = cut_loop(lambda k: VIEWS[section].closed_loop(EQS, **{**state, "K_A": k}), 0.4)
    C = 0.7 * control.ss(ratio(SECTIONS["notch"])) * control.ss(ratio(SECTIONS["lag"]))
    A = np.block([[loop.A - loop.B @ C.D @ loop.C, loop.B @ C.C], [-C.B @ loop.C, C.A]])
    start = np.zeros(A.shape[0])
    start[closed.state_labels.index("x_alpha")] = 1
    for output in ("alpha", "theta", "q1", "q2"):
        at = closed.state_labels.index(f"x_{output}")
        wanted = [(expm(A * t) @ start)[at] for t in times]
        assert np.array(found[output]) == pytest.approx(np.array(wanted), rel=1e-7, abs=1e-9)


def test_the_delay_is_control_pade(page):
    body = "(_, T, n) => module.ratioOf({ gain: 1, sections: [{ kind: 'delay', values: [T, n] }] })"
    for order in (1, 2, 3, 4):
        found = run(page, body, "IV", 0.3, order)
        N, D = control.pade(0.3, order)
        for ours, theirs in ((found["N"], N), (found["D"], D)):
            assert np.array(ours[::-1]) / found["D"][-1] == pytest.approx(np.array(theirs) / D[0], rel=1e-12)


def test_one_that_cannot_be_built_is_left_out(page):
    body = """(s) => {
      const sections = [{ kind: 'zero', values: [-1] }];
      return module.compensated(s, { place: 'K_A', gain: 2, sections }) === s;
    }"""
    assert run(page, body, "IV")


def test_a_zero_on_a_mode_takes_it_out_of_the_loop(page):
    """A notch that has the mode's own poles as its zeros leaves the mode where it is, at every gain."""
    mode = next(p for p in sent("IV")["poles"] if p["branch"] == "mode 2" and p["im"] > 0)
    omega = abs(complex(mode["re"], mode["im"]))
    notch = {"kind": "notch", "values": [omega, -mode["re"] / omega, 0.5]}
    compensator = {"place": "K_A", "gain": 1.0, "sections": [notch]}
    states = [{**presets_of("IV")[0], "K_A": K_A} for K_A in (0.1, 1.0, 10.0)]
    for found in run(page, POLES, "IV", states, compensator):
        off = abs(points(found) - complex(mode["re"], mode["im"])).min()
        assert off < 1e-8
