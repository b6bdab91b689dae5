"""One's own loop in the browser against `rl.root_locus`: what the view reads from the text alone, and what
Python sends of it."""

import json

import control
import numpy as np
import pytest

import rlswaim as rl
from own_loops import LOOPS
from rlswaim.explorers.own_loop import explore, known_roots, loop_text
from rlswaim.rootlocus.open_loop import open_loop
from standin import go_to_empty_page, paired

FOUND = """async ([payload, text, k]) => {
  const { systemOf } = await import('/js/views/own_loop_system.js');
  const { loopOf } = await import('/js/maths/open_loop.js');
  const { closedLoop } = await import('/js/maths/closed_loop.js');
  const system = systemOf(payload, text);
  const loop = loopOf(system, { loop: text, k }, { running: 'k', off: [], of: 'poles' });
  const closed = closedLoop(system, { loop: text, k });
  return {
    poles: system.loop.poles, zeros: system.loop.zeros, closed,
    breaks: loop.breaks.map(({ gain, x, y }) => [gain, x, y]),
    crossings: loop.crossings().map(({ gain, omega, direction }) => [gain, omega, direction]),
  };
}"""
K = 0.37


@pytest.fixture(scope="module")
def page(browser):
    page = browser.new_page()
    go_to_empty_page(page)
    yield page
    page.close()


def payload(system, text, known):
    sent = {**explore(control.tf([1], [1, 1])).payload, "known": {}}
    if known:
        exact = not isinstance(system, control.TransferFunction)
        sent["known"] = {text: known_roots(open_loop(system), exact)}
    return json.loads(json.dumps(sent))


def complex_of(points):
    return np.array(points["x"]) + 1j * np.array(points["y"])


def assert_near(found, wanted, relative, least=1e-12):
    found, wanted = np.asarray(found, complex), np.asarray(wanted, complex)
    assert found.size == wanted.size, (found, wanted)
    ours, theirs = paired(found, wanted)
    off = abs(ours - theirs) / np.maximum(abs(theirs), least)
    assert off.max(initial=0) <= relative, (ours, theirs)


@pytest.mark.parametrize("known", [False, True], ids=["read", "sent"])
@pytest.mark.parametrize("name", LOOPS)
def test_the_view_finds_what_the_library_finds(page, name, known):
    system = LOOPS[name]
    text, locus = loop_text(system), rl.root_locus(system, [K])
    found = page.evaluate(FOUND, [payload(system, text, known), text, K])
    assert_near(complex_of(found["poles"]), locus.poles, 1e-9)
    assert_near(complex_of(found["zeros"]), locus.zeros, 1e-9)
    roots, condition = locus.roots[0], locus.condition[0]
    well = condition[np.isfinite(condition)].max(initial=1)
    assert_near(complex_of(found["closed"]), roots, 1e-9 if well < 1e6 else 1e-6, 1e-9)
    breaks = [b for b in found["breaks"] if b[0]]
    wanted = [b for b in locus.break_aways if b.gain]
    assert_near([b[0] for b in breaks], [b.gain for b in wanted], 1e-6)
    assert_near([complex(*b[1:]) for b in breaks], [b.point for b in wanted], 1e-6, 1e-9)
    assert_near([c[0] for c in found["crossings"]], [c.gain for c in locus.crossings], 1e-6)
    assert_near([c[1] for c in found["crossings"]], [c.omega for c in locus.crossings], 1e-6, 1e-9)
