"""The benches of chapters I to III: closed loops around the chapter's own vehicle, on a page of their own."""

from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Page

import rlswaim as rl
from criteria_rows import ROWS, agree
from rlswaim import explorers
from rlswaim.explorers.criteria_card import STATIONS
from rlswaim.explorers.live_view import LiveView
from rlswaim.loops.cut_loop import cut_loop
from rlswaim.practice import criteria
from rlswaim.practice.burn import equations_at
from rlswaim.practice.loads import section_loads, with_moments
from rlswaim.vehicle import trajectory
from standin import SITE, opened, paired

BOOSTER = rl.swaim_booster()
OWN = rl.perturbation_equations(BOOSTER)
LOOPS = {
    "rate-attitude": rl.rate_attitude,
    "single-sensor": rl.single_sensor,
    "two-sensor": rl.two_sensor,
    "dual-actuation": rl.dual_actuation,
}
MAKERS = {
    "bent-vehicle": lambda: explorers.bent_vehicle_explorer(BOOSTER),
    "trajectory": lambda: explorers.ascent_explorer(trajectory.swaim_ascent(), BOOSTER.flight),
    "coupling": lambda: explorers.coupled_vehicle_explorer(BOOSTER),
}
PROGRAMS = [(0, 110, 58), (0, 110, 2), (0, 110, 100), (6, 100, 30), (18, 150, 80), (12, 180, 0)]
"""Upright, level and time (s): programs and times that Python has flown."""


@pytest.fixture(scope="module")
def views() -> dict[str, LiveView]:
    return {name: make() for name, make in MAKERS.items()}


@pytest.fixture(params=MAKERS)
def bench(browser, views, request) -> Iterator[tuple[Page, LiveView]]:
    yield from _open(browser, views[request.param])


def _open(browser, view: LiveView, address: str = SITE) -> Iterator[tuple[Page, LiveView]]:
    with opened(browser, view, address, viewport={"width": 1000, "height": 900}) as page:
        page.locator("[data-panel=bench]").evaluate("panel => { panel.open = true; }")
        page.locator("[data-panel=bench] canvas[data-plane=locus]").scroll_into_view_if_needed()
        page.wait_for_timeout(300)
        yield page, view


@pytest.fixture
def bent(browser, views) -> Iterator[tuple[Page, LiveView]]:
    yield from _open(browser, views["bent-vehicle"])


@pytest.fixture
def burn(browser, views) -> Iterator[tuple[Page, LiveView]]:
    yield from _open(browser, views["trajectory"])


@pytest.fixture
def coupled(browser, views) -> Iterator[tuple[Page, LiveView]]:
    yield from _open(browser, views["coupling"])


def poles(page: Page) -> np.ndarray:
    rows = page.evaluate(
        """() => [...el.querySelectorAll('[data-panel=bench] .bench .poles tbody tr')]
             .map(row => [+row.dataset.re, +row.dataset.im])"""
    )
    return np.array(rows) @ [1, 1j]


def choose(page: Page, system: str) -> None:
    page.locator("[data-panel=bench] > .controls select").select_option(system)
    page.wait_for_timeout(200)


def values(page: Page) -> dict:
    """Return what the bench's own sliders show."""
    read = page.evaluate(
        """() => [...el.querySelectorAll('.bench .row[data-parameter]')].map((row) =>
             [row.dataset.parameter, row.querySelector('input[type=text], select').value])"""
    )
    return {name: text if name in ("feedback", "gravity") else float(text) for name, text in read}


def put(page: Page, name: str, text: str) -> None:
    box = page.locator(f".bench [data-parameter={name}] input[type=text]")
    box.evaluate("(box, text) => { box.value = text; box.dispatchEvent(new Event('change')); }", text)
    page.wait_for_timeout(80)


def assert_poles(page: Page, system: str, eqs: rl.PerturbationEquations) -> None:
    data = {"q_D", "C_payload", "C_fins", "omega_1", "omega_2", "gravity", "t"}
    given = {name: value for name, value in values(page).items() if name not in data}
    if given.pop("feedback", "total") == "rigid body":
        given["gyro"] = None
    found, wanted = paired(poles(page), LOOPS[system](eqs, **given).poles())
    assert (abs(found - wanted) / np.maximum(abs(wanted), 1.0)).max() < 1e-8


@pytest.mark.parametrize("system", LOOPS)
def test_chapter_1_closes_each_loop_around_the_vehicle_from_its_data(bent, system):
    page, _ = bent
    choose(page, system)
    assert_poles(page, system, OWN)
    put(page, "K_A", "-2.5")
    put(page, "K_C", "6")
    assert_poles(page, system, OWN)
    page.locator(".bench [data-panel=vehicle]").evaluate("panel => { panel.open = true; }")
    put(page, "q_D", "600")
    put(page, "omega_2", "4.4")
    page.locator(".bench [data-parameter=gravity] select").select_option("kept")
    page.wait_for_timeout(80)
    assert_poles(page, system, rl.with_other_data(OWN, q_D=600.0, omega_2=4.4, gravity=True))


@pytest.mark.parametrize("system", LOOPS)
def test_chapter_2_moves_the_vehicle_through_the_burn(burn, system):
    page, view = burn
    choose(page, system)
    tables = view.payload
    for upright, level, t in PROGRAMS:
        page.evaluate(
            "given => { for (const n in given) model.set(n, given[n]); }",
            {"upright": upright, "level": level},
        )
        put(page, "t", str(t))
        row = tables["nodes"]["upright"].index(upright), tables["nodes"]["level"].index(level)
        U, q_D = (tables["curves"][name][row[0]][row[1]][t // 2] for name in ("U", "q_D"))
        assert_poles(page, system, equations_at(t, U=U, q_D=q_D))


@pytest.mark.parametrize("system", LOOPS)
def test_chapter_3_closes_the_loop_around_the_vehicle_of_its_sliders(coupled, system):
    page, _ = coupled
    choose(page, system)
    for changes in ({}, {"q_D": 300.0, "l_payload": 93, "omega_1": 5.0}, {"C_fins": 0.1, "l_fins": 380}):
        page.evaluate("given => { for (const n in given) model.set(n, given[n]); }", changes)
        page.wait_for_timeout(120)
        now = {name: page.evaluate("name => model.get(name)", name) for name in view_data()}
        assert_poles(page, system, rl.with_other_data(OWN, **now))


def own_equations(page: Page, view: LiveView) -> rl.PerturbationEquations:
    """Return the equations of the vehicle that a view opens with."""
    if view.system != "trajectory":
        return OWN
    told, start = view.payload, view.payload["bench"]["plant"]["own"]
    row = [told["nodes"][name].index(start[name]) for name in ("upright", "level")]
    at = told["times"].index(start["t"])
    U, q_D = (told["curves"][name][row[0]][row[1]][at] for name in ("U", "q_D"))
    return equations_at(start["t"], U=U, q_D=q_D)


def test_criteria_are_those_of_the_bench_s_own_vehicle(bench):
    page, view = bench
    choose(page, "dual-actuation")
    page.locator("[data-panel=criteria]").evaluate("card => { card.open = true; }")
    page.wait_for_function("el.querySelectorAll('[data-panel=criteria] tbody tr').length > 15")
    rows = page.locator("[data-panel=criteria] tbody tr").evaluate_all(ROWS)
    eqs, given = own_equations(page, view), values(page)
    gains = {name: given[name] for name in ("K_A", "K_C", "K_R", "kK_z", "K_r", "b", "sensor", "jet")}

    def loop(K_A: float) -> control.StateSpace:
        return rl.dual_actuation(eqs, **gains | {"K_A": K_A})

    closed = loop(gains["K_A"])
    if view.system == "bent-vehicle":
        closed = with_moments(closed, section_loads(BOOSTER, eqs, STATIONS, gains["jet"]))
    modes = {f"bending {i}": mode.omega for i, mode in enumerate(eqs.modes, start=1)}
    found = criteria.evaluate(closed, eqs.U, cut_loop(loop, gains["K_A"]), modes)
    assert sum(np.isfinite(c.value) for c in found) > 8
    agree(rows, found)


def view_data() -> list[str]:
    return ["omega_1", "omega_2", "q_D", "C_payload", "C_fins", "l_payload", "l_fins"]


def test_copied_python_gives_the_poles(bench):
    page, _ = bench
    panel = page.locator(".bench [data-panel=takeaway]")
    if page.locator(".bench [data-parameter=q_D]").count():
        put(page, "q_D", "900")
    if page.locator(".bench [data-parameter=t]").count():
        put(page, "t", "30")
    panel.evaluate("panel => { panel.open = true; }")
    page.wait_for_timeout(500)
    made: dict = {}
    exec(panel.locator("pre").inner_text(), made)
    found, wanted = paired(poles(page), made["loop"].poles())
    assert (abs(found - wanted) / np.maximum(abs(wanted), 1.0)).max() < 1e-8


def test_poles_leave_a_trail_over_the_burn(burn):
    page, _ = burn
    canvas = page.locator(".bench canvas[data-plane=map]")
    canvas.scroll_into_view_if_needed()
    page.wait_for_function(
        "() => !el.querySelector('.bench canvas[data-plane=map]').classList.contains('stale')"
    )
    page.wait_for_timeout(400)
    assert "as the t runs from 0 to 100 s. At 58 s" in canvas.get_attribute("aria-label")
    before = canvas.evaluate("canvas => canvas.toDataURL()")
    page.evaluate("() => model.set('level', 150)")
    page.wait_for_timeout(800)
    assert canvas.evaluate("canvas => canvas.toDataURL()") != before


def test_the_bent_vehicle_moves_in_the_mode_that_is_picked(bent):
    page, _ = bent
    canvas = page.locator("canvas[data-plane=vehicle]")
    canvas.scroll_into_view_if_needed()
    at_rest = canvas.evaluate("canvas => canvas.toDataURL()")
    page.locator(".bench [data-panel=mode]").evaluate("panel => { panel.open = true; }")
    page.wait_for_function("() => el.innerText.includes('moving in the closed-loop mode from mode 1')")
    first = canvas.evaluate("canvas => canvas.toDataURL()")
    page.wait_for_timeout(400)
    assert len({at_rest, first, canvas.evaluate("canvas => canvas.toDataURL()")}) == 3
    page.locator(".bench [data-panel=mode]").evaluate("panel => { panel.open = false; }")
    page.wait_for_timeout(300)
    assert canvas.evaluate("canvas => canvas.toDataURL()") == at_rest


def test_undo_on_the_bench_leaves_the_view_above(coupled):
    page, _ = coupled
    page.wait_for_timeout(600)
    page.evaluate("() => model.set('q_D', 500)")
    page.wait_for_timeout(700)
    before = poles(page)
    put(page, "K_C", "9")
    page.wait_for_timeout(700)
    page.locator(".bench canvas[data-plane=locus]").focus()
    page.keyboard.press("Control+z")
    page.wait_for_timeout(200)
    assert page.evaluate("model.get('q_D')") == 500
    assert abs(poles(page) - before).max() < 1e-9


def test_address_opens_the_bench(bench, browser):
    page, view = bench
    choose(page, "rate-attitude")
    put(page, "K_A", "-7")
    page.wait_for_timeout(500)
    address = page.evaluate("location.hash")
    assert f"{view.system}-rate-attitude:K_A=-7" in address
    with opened(browser, view, f"{SITE}{address}", viewport={"width": 1000, "height": 900}) as other:
        other.locator(".bench .poles tbody tr").first.wait_for()
        other.wait_for_timeout(400)
        assert values(other)["K_A"] == -7
        assert abs(np.sort(poles(other)) - np.sort(poles(page))).max() < 1e-9


HOSTILE = ["K_A=1e308,K_C=-1e308", "t=1e308", "q_D=NaN,omega_1=0", "sensor=3.5,view.window=1e308_1e308_1e308"]


@pytest.mark.parametrize("part", HOSTILE)
@pytest.mark.parametrize("name", MAKERS)
def test_hostile_addresses_of_a_bench(browser, views, name, part):
    address = f"{SITE}#{name}-single-sensor:{part}"
    with opened(browser, views[name], address, viewport={"width": 1000, "height": 900}) as page:
        page.locator(".bench .poles tbody tr").first.wait_for()
        page.wait_for_timeout(300)
        assert np.isfinite(poles(page)).all()
        assert page.locator(".bench output").first.inner_text().startswith("A shared state was opened.")


def test_sliders_are_long_enough_on_a_phone(browser, views):
    for view in views.values():
        with opened(browser, view, viewport={"width": 360, "height": 740}) as page:
            page.locator("[data-panel=bench]").evaluate("panel => { panel.open = true; }")
            page.wait_for_timeout(300)
            sliders = page.locator(".bench > * > .rows input[type=range]")
            widths = sliders.evaluate_all("all => all.map(({ clientWidth }) => clientWidth)")
            assert len(widths) >= 5
            assert min(widths) >= 220
            assert page.evaluate("() => document.documentElement.scrollWidth") <= 360
