"""The workbench's card of criteria beside python-control, and its words while a loop is not stable."""

import control
import numpy as np
import pytest

import rlswaim as rl
from livepage import number
from standin import opened, show
from workbench_page import EQUATIONS, VIEWS

GAINS = ("K_A", "K_C", "K_R", "kK_z", "K_r", "b", "sensor", "jet")
UNITS = {"alpha": 180 / np.pi, "theta": 180 / np.pi, "delta": 180 / np.pi, "q1": 1, "q2": 1, "delta_r": 1}
CARD = "details[data-panel=criteria]"


@pytest.fixture(scope="module")
def bench(browser):
    with opened(browser, VIEWS["VII"](EQUATIONS)) as page:
        page.get_by_role("button", name="Search, modest jet", exact=True).click()
        page.locator(f"{CARD} summary").click()
        page.wait_for_function(f"document.querySelectorAll('{CARD} tbody tr').length > 6")
        yield page


@pytest.fixture(scope="module")
def card(bench):
    """What the card shows of a stable loop, by row, and the loop by python-control."""
    cells = "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))"
    rows = bench.locator(f"{CARD} tbody tr").evaluate_all(cells)
    gains = {name: bench.evaluate(f"state.{name}") for name in GAINS}
    return rows, rl.dual_actuation(EQUATIONS, **gains)


def first(text):
    return number(text.split()[0].rstrip("°").replace(",", ""))


def test_largest_and_settling_are_those_of_python_control(card):
    rows, loop = card
    told = {what: (value, at) for what, value, at in rows}
    t = np.linspace(0, 30, 6001)
    step = control.forced_response(
        loop[:, loop.input_labels.index("theta_c")], t, np.radians(1) * np.ones_like(t)
    )
    for name, unit in UNITS.items():
        y = np.asarray(step.y).reshape(len(loop.output_labels), -1)[loop.output_labels.index(name)] * unit
        at = np.abs(y).argmax()
        value, when = told[f"{name}, largest"]
        assert first(value) == pytest.approx(y[at], rel=0.01)
        assert first(when) == pytest.approx(t[at], abs=0.1)
        inside = np.abs(y - y[-1]) <= 0.1 * np.abs(y).max()
        settled = t[np.flatnonzero(~inside)[-1] + 1] if not inside.all() else 0.0
        value = told[f"{name} settles"][0]
        assert value.startswith("not within") == (settled > 27)
        assert settled > 27 or first(value) == pytest.approx(settled, abs=0.15)


def test_margins_stand_at_the_nearest_root(card):
    rows, loop = card
    poles = loop.poles()
    margins = [row for row in rows if "margin" in row[0]]
    kinds = dict.fromkeys(what.split(": ")[1] for what, _, _ in margins)
    assert list(kinds) == ["phase margin", "delay margin", "gain margin"]
    for kind in ("phase", "gain"):
        sizes = [abs(first(value)) for what, value, _ in margins if kind in what]
        assert sizes == sorted(sizes)
    named = {}
    for what, _, at in margins:
        near = poles[np.abs(np.log(np.abs(poles) / first(at))).argmin()]
        named.setdefault(what.split(":")[0], set()).add(round(abs(near), 3))
    assert all(len(sizes) <= 2 for sizes in named.values())
    for (_, degrees, at), (_, seconds, _) in zip(
        [m for m in margins if "phase" in m[0]], [m for m in margins if "delay" in m[0]], strict=True
    ):
        assert np.radians(first(degrees) % 360) / first(at) == pytest.approx(first(seconds), rel=0.02)


def test_loop_that_is_not_stable_has_none(bench):
    show(bench, K_A=0.3)
    bench.wait_for_function(f"document.querySelector('{CARD}').innerText.includes('not stable')")
    assert bench.locator(f"{CARD} tbody tr").count() == 0
