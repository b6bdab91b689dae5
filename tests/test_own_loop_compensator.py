"""A compensator in series with one's own loop, in s and z: its poles are those of python-control's series."""

import urllib.parse

import control
import numpy as np
import pytest

import rlswaim as rl
from own_loops import LOOPS
from rlswaim.explorers.own_loop import loop_text
from standin import SITE, go_to_empty_page, opened, paired, show, table
from test_compensator_panel import PANEL, RING, add, open_panel, type_in
from test_own_loop_maths import assert_near, complex_of, payload
from test_own_loop_view import type_in as type_loop
from workbench_page import one, to_pixels

IN_S = control.tf([1], [1, 2, 2, 0])
IN_Z = control.tf([1], [1, -1.5, 0.5], 0.1)
K = 0.37
FOUND = """async ([payload, text, compensator, k]) => {
  const { systemOf, inSeries } = await import('/js/views/own_loop_system.js');
  const { loopOf } = await import('/js/maths/open_loop.js');
  const { closedLoop } = await import('/js/maths/closed_loop.js');
  const { stepResponse } = await import('/js/maths/own_response.js');
  const system = inSeries(systemOf(payload, text), compensator);
  const state = { loop: text, k };
  const loop = loopOf(system, state, { running: 'k', off: [], of: 'poles' });
  return {
    poles: system.loop.poles, zeros: system.loop.zeros, closed: closedLoop(system, state),
    crossings: loop.crossings().map(({ gain, omega }) => [gain, omega]),
    step: Array.from(stepResponse(system, state, Array.from({ length: 21 }, (_, k) => k / 10))),
  };
}"""


def with_values(kind: str, *values: float) -> dict:
    return {"kind": kind, "values": list(values)}


def at_one(C: control.TransferFunction) -> control.TransferFunction:
    """Return a section with the value 1 at z = 1."""
    return C / C(1).real


def in_s() -> dict[str, tuple[dict, control.TransferFunction]]:
    """Return sections with their textbook formulas, written anew for python-control."""
    s = control.tf("s")
    return {
        "pole": (with_values("pole", -5.0), 5 / (s + 5)),
        "integrator and zero": (with_values("lead", -0.4, -7.0), 17.5 * (s + 0.4) / (s + 7)),
        "poles": (with_values("poles", 4.0, 0.3), 16 / (s**2 + 2.4 * s + 16)),
        "notch": (
            with_values("notch", 3.0, 0.05, 0.5),
            (s**2 + 0.3 * s + 9) / (s**2 + 3 * s + 9),
        ),
        "delay": (with_values("delay", 0.08, 3), control.tf(*control.pade(0.08, 3))),
    }


def in_z(dt: float | bool) -> dict[str, tuple[dict, control.TransferFunction]]:
    z = control.tf([1, 0], [1], dt)

    def pair(size: float, angle: float) -> control.TransferFunction:
        return z**2 - 2 * size * np.cos(angle) * z + size**2

    return {
        "pole": (with_values("zpole", 0.6), at_one(1 / (z - 0.6))),
        "integrator": (with_values("zpole", 1.0), 1 / (z - 1)),
        "lead": (with_values("zlead", 0.8, 0.2), at_one((z - 0.8) / (z - 0.2))),
        "poles": (with_values("zpoles", 0.7, 1.1), at_one(1 / pair(0.7, 1.1))),
        "notch": (with_values("znotch", 0.9, 0.97, 0.6), at_one(pair(0.97, 0.9) / pair(0.6, 0.9))),
        "delay": (with_values("zdelay", 3), 1 / z**3),
    }


@pytest.fixture(scope="module")
def blank(browser):
    page = browser.new_page()
    go_to_empty_page(page)
    yield page
    page.close()


CASES = ["twelve states", "poles on the axis", "biproper states", "random states 5", "discrete"]
CASES += ["discrete, factors", "discrete, states", "triple pole, factors"]


@pytest.mark.parametrize("name", CASES)
def test_the_loop_is_control_series(blank, name):
    """Poles, zeros, crossings and the step response of k C G, with each section and with all."""
    system = LOOPS[name]
    dt = getattr(system, "dt", 0)
    sections = in_z(dt) if dt else in_s()
    text = loop_text(system)
    G = control.zpk(*system, 0) if isinstance(system, tuple) else system
    G = control.zpk(G.zeros, G.poles, G.gain, dt) if hasattr(G, "gain") else G
    for chosen in [*([key] for key in sections), list(sections)]:
        compensator = {"place": "k", "gain": 1.3, "sections": [sections[key][0] for key in chosen]}
        C = control.tf([1.3], [1], dt or 0)
        for key in chosen:
            C = C * sections[key][1]
        loop = control.series(control.ss(C), control.ss(G))
        found = blank.evaluate(FOUND, [payload(system, text, True), text, compensator, K])
        assert_near(complex_of(found["poles"]), [*C.poles(), *rl.root_locus(system, [K]).poles], 1e-6, 1e-2)
        closed = control.feedback(K * loop)
        assert_near(complex_of(found["closed"]), closed.poles(), 1e-6, 0.1)
        times = np.arange(21) / 10
        if dt:
            times = np.arange(int(2 / (1 if dt is True else dt)) + 1) * (1 if dt is True else dt)
        _, wanted = control.step_response(closed, times)
        ours = np.array(found["step"])[:: max(1, round((times[1] - times[0]) * 10))]
        if not dt or times[1] >= 0.1:
            assert ours == pytest.approx(wanted[: ours.size], rel=1e-6, abs=1e-7)
        for gain, omega in found["crossings"]:
            at = np.exp(1j * omega) if dt else 1j * omega
            assert abs(1 + gain * loop(at)) < 1e-6


@pytest.fixture(params=[IN_S, IN_Z], ids=["s", "z"])
def bench(browser, request):
    with opened(browser, rl.explore(request.param, 0.2)) as page:
        open_panel(page)
        yield page


def assert_like_python(page):
    page.wait_for_timeout(250)
    names: dict = {}
    exec(page.locator("[data-panel=takeaway] code").text_content(), names)
    ours, theirs = paired(table(page), names["locus"].roots[0])
    assert (abs(ours - theirs) <= 1e-7 * np.maximum(1, abs(theirs))).all()


KINDS = {
    "s": {"pole": 1, "poles": 2, "notch": 2, "lead": 1, "delay": 2},
    "z": {"zpole": 1, "zpoles": 2, "znotch": 2, "zlead": 1, "zdelay": 1},
}


class TestPanel:
    def test_the_copied_python_has_the_poles_shown(self, bench):
        before = len(table(bench))
        kinds = KINDS["z" if bench.evaluate("el.textContent.includes('discrete, dt')") else "s"]
        added = 0
        for kind, order in kinds.items():
            add(bench, kind)
            added += order
            assert len(table(bench)) == before + added
            assert_like_python(bench)
        assert "compensator" in bench.locator("table.poles").inner_text()

    def test_of_each_form_of_the_loop(self, bench):
        for text in (
            "zeros = [-2]\npoles = [0, -1+5j, -1-5j]\ngain = 4",
            "A = [[-1, 2], [0, -3]]\nB = [[0], [1]]\nC = [[1, 0.5]]\nD = [[0]]",
            "1/((z-1)(z-0.5))",
            "zeros = [0.3]\npoles = [0.9]\ngain = 1\ndt = 0.2",
        ):
            type_loop(bench, text)
            add(bench, "zlead" if "z-" in text or "dt" in text else "lead")
            assert_like_python(bench)

    def test_a_zero_alone_is_left_out_and_told(self, bench):
        before = table(bench)
        zero = "zzero" if bench.locator(f"{PANEL} option[value=zzero]").count() else "zero"
        add(bench, zero)
        assert (table(bench) == before).all()
        assert "more zeros than poles" in bench.locator(f"{PANEL} .told").inner_text()
        assert "C = " not in bench.locator("[data-panel=takeaway] code").text_content()

    def test_a_loop_of_the_other_time_goes_without_it(self, bench):
        is_z = bench.locator(f"{PANEL} option[value=zpole]").count() == 1
        add(bench, "zpole" if is_z else "pole")
        type_loop(bench, "1/(s (s+1))" if is_z else "1/((z-1)(z-0.5))")
        assert "No compensator is in the loop" in bench.locator(f"{PANEL} .told").inner_text()
        assert bench.locator(f"{PANEL} option[value=zpole]").count() == (0 if is_z else 1)
        assert len(table(bench)) == 2

    def test_a_link_brings_it_along(self, browser, bench):
        is_z = bench.locator(f"{PANEL} option[value=zpole]").count() == 1
        type_loop(bench, "0.2/((z-1)(z-0.5))" if is_z else "2/(s (s+1) (s+2))")  # read by both pages alike
        add(bench, *(["znotch", "zdelay"] if is_z else ["notch", "delay"]))
        show(bench, k=0.25)
        bench.wait_for_function("/loop=.*k=0.25.*view.compensator=k~1~/.test(location.hash)")
        with opened(browser, rl.explore(control.tf([1], [1, 1])), bench.evaluate("location.href")) as other:
            other.wait_for_function("k => model.get('k') === k", arg=0.25)
            other.wait_for_timeout(200)
            assert (table(other) == table(bench)).all()
            assert other.locator(PANEL).evaluate("node => node.open")

    def test_undo_and_the_grips(self, bench):
        is_z = bench.locator(f"{PANEL} option[value=zpole]").count() == 1
        add(bench, "zpole" if is_z else "pole")
        bench.wait_for_timeout(600)
        bench.get_by_role("button", name="Lock axes").click()
        target = 0.3 if is_z else -1.7
        ring = bench.locator(RING).first
        ring.scroll_into_view_if_needed()
        box = ring.bounding_box()
        x, y = to_pixels(bench, target + 0j)
        bench.mouse.move(box["x"] + 13, box["y"] + 13)
        bench.mouse.down()
        bench.mouse.move((x + box["x"]) / 2, y, steps=3)
        one(bench, lambda: bench.mouse.move(x, y))
        bench.mouse.up()
        bench.wait_for_timeout(600)
        moved = float(bench.locator(f"{PANEL} li input").first.input_value())
        assert moved == pytest.approx(target, abs=0.05 * max(1, abs(target)))
        assert_like_python(bench)
        with_it = len(table(bench))
        bench.get_by_role("button", name="undo").click()
        bench.get_by_role("button", name="undo").click()
        bench.wait_for_function("n => el.querySelectorAll('.poles tbody tr').length === n", arg=with_it - 1)


def test_loop_and_compensator_have_at_most_order_30(browser):
    with opened(browser, rl.explore(([], [-1.0 - 0.1 * i for i in range(29)], 1.0))) as page:
        open_panel(page)
        add(page, "pole")
        assert len(table(page)) == 30
        page.locator(PANEL).get_by_role("button", name="Add").click()
        assert "No more sections" in page.locator(f"{PANEL} .told").inner_text()
        assert len(table(page)) == 30


def test_in_z_a_grip_steps_by_keys_and_goes_with_its_frequency(browser):
    with opened(browser, rl.explore(IN_Z, 0.2)) as page:
        open_panel(page)
        add(page, "zpoles")
        type_in(page, 0, 0, "0.8")
        type_in(page, 0, 1, "0.5")
        ring = page.locator(RING).first
        assert "z = " in ring.get_attribute("aria-label")
        ring.focus()
        one(page, lambda: ring.press("ArrowRight"))
        size, angle = (float(page.locator(f"{PANEL} li input").nth(k).input_value()) for k in (0, 1))
        assert size * np.exp(1j * angle) == pytest.approx(0.8 * np.exp(0.5j) + 0.01, abs=1e-4)
        page.evaluate("el.querySelector('[data-panel=frequency]').open = true")
        page.locator("canvas[data-plane=frequency]").scroll_into_view_if_needed()
        page.wait_for_timeout(300)
        ring = page.locator("[data-panel=frequency] .grips button:not([hidden])").first
        box = ring.bounding_box()
        page.mouse.move(box["x"] + 13, box["y"] + 13)
        page.mouse.down()
        page.mouse.move(box["x"] + 30, box["y"] + 13)
        one(page, lambda: page.mouse.move(box["x"] + 43, box["y"] + 13))
        page.mouse.up()
        after = [float(page.locator(f"{PANEL} li input").nth(k).input_value()) for k in (0, 1)]
        assert after[1] > 1.05 * angle
        assert np.log(after[0]) / after[1] == pytest.approx(np.log(size) / angle, rel=1e-3)


@pytest.mark.parametrize(
    "text",
    [
        "k~1e308",
        "k~1~zpole_0.5",
        "K_A~1~pole_-1",
        "__proto__~1",
        "k~1~delay_0_0",
        "%3Cb%3E",
        "k~1~pole_1e308",
    ],
)
def test_nonsense_is_left_out(browser, text):
    address = f"{SITE}#own-loop:loop={urllib.parse.quote('1/(s (s+1))')},view.compensator={text}"
    with opened(browser, rl.explore(IN_S), address) as page:
        page.wait_for_function("el.querySelector('output').innerText")
        said = page.locator("output").first.inner_text()
        assert "view.compensator from the address is not one that can be shown" in said
        assert len(table(page)) == 2


def test_a_notebooks_view_has_the_panel(browser):
    with opened(browser, rl.explore(IN_S)) as page:
        assert page.locator(PANEL).count() == 1
        show(page, k=0.5)
        assert page.locator("[data-panel=criteria]").count() == 0
