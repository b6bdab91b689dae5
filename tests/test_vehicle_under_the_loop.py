"""The vehicle's sliders under the loops of Sections IV to VII: poles, Python, address, cloud."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from playwright.sync_api import Page

import rlswaim as rl
from rlswaim.explorers.vehicle_sliders import DATA, DISPERSED, DRAWS, data_parameters, dispersed_data
from rlswaim.loops.control_systems import DUAL_ACTUATION, RATE_ATTITUDE, SINGLE_SENSOR, TWO_SENSOR
from rlswaim.loops.vehicle_family import GRAVITY, jet_factors, vehicle_family
from rlswaim.practice.dispersed import dispersed, drawn
from rlswaim.vehicle.other_data import own_data, with_data
from standin import SITE, opened, paired, show, table
from systems import mismatch
from workbench_page import EQUATIONS, VIEWS

CHANGES = [
    {"q_D": 0.0},
    {"q_D": 400.0, "gravity": "kept"},
    {"omega_1": 3.2, "omega_2": 2.1},
    {"C_payload": 0.4, "C_fins": 2.0, "omega_2": 9.0},
    {"q_D": 1500.0, "C_payload": 2.5, "omega_1": 1.3, "gravity": "kept"},
]
SYSTEMS = (RATE_ATTITUDE, SINGLE_SENSOR, TWO_SENSOR, DUAL_ACTUATION)


def rebuilt(changes: dict) -> rl.PerturbationEquations:
    """Return equations from the data of a changed vehicle, put together here."""
    booster = rl.swaim_booster()
    modes = tuple(
        replace(m, omega=changes.get(f"omega_{i}", m.omega)) for i, m in enumerate(booster.modes, start=1)
    )
    surfaces = tuple(replace(s, C_Nalpha=changes.get(f"C_{s.name}", s.C_Nalpha)) for s in booster.surfaces)
    flight = replace(booster.flight, q_D=changes.get("q_D", booster.flight.q_D))
    changed = replace(booster, modes=modes, surfaces=surfaces, flight=flight)
    return rl.perturbation_equations(changed, gravity=changes.get("gravity") == "kept")


def given(changes: dict) -> dict:
    """Return changes as the library takes them."""
    return {**changes, "gravity": changes.get("gravity") == "kept"}


@pytest.mark.parametrize("changes", CHANGES)
def test_equations_from_the_data_are_those_of_the_rebuilt_vehicle(changes):
    own = rl.perturbation_equations(rl.swaim_booster())
    found, wanted = rl.with_other_data(own, **given(changes)), rebuilt(changes)
    assert found.gravity == wanted.gravity
    for name, value in wanted.coefficients.items():
        assert found.coefficients[name] == pytest.approx(value, rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("changes", CHANGES)
def test_printed_equations_move_by_what_the_data_give(changes):
    own, wanted = rl.perturbation_equations(rl.swaim_booster()), rebuilt(changes)
    found = rl.with_other_data(EQUATIONS, **given(changes))
    for name, value in wanted.coefficients.items():
        moved = value - own.coefficients[name]
        assert found.coefficients[name] - EQUATIONS.coefficients[name] == pytest.approx(moved, abs=1e-12)


def test_nothing_changed_keeps_every_printed_number():
    assert rl.with_other_data(EQUATIONS).coefficients == EQUATIONS.coefficients
    assert rl.with_other_data(EQUATIONS).gravity == 0.0
    heavy = rl.printed_equations(gravity=True)
    assert rl.with_other_data(heavy).gravity == heavy.gravity
    assert rl.with_other_data(heavy, gravity=False).gravity == 0.0


@pytest.mark.parametrize(
    ("data", "error", "message"),
    [
        ({"q": 1.0}, TypeError, "with_data: got an unknown 'q', wanted omega_1, omega_2, q_D, C_payload"),
        ({"q_D": -1.0}, ValueError, "q_D in FlightCondition: got -1"),
        ({"omega_1": 0.0}, ValueError, "omega in BendingMode bending mode 1: got 0"),
        ({"C_fins": float("nan")}, ValueError, "C_Nalpha in Surface fins: got nan"),
    ],
)
def test_bad_data(data, error, message):
    with pytest.raises(error, match=message.replace("(", r"\(")):
        rl.with_other_data(EQUATIONS, **data)


def test_equations_are_wanted():
    with pytest.raises(TypeError, match="with_other_data"):
        rl.with_other_data(rl.swaim_booster())


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.function.__name__)
def test_the_family_in_coefficients_is_the_loop_around_a_rebuilt_vehicle(system):
    eqs = rl.with_other_data(EQUATIONS, q_D=300.0, omega_1=2.0, C_fins=1.0, gravity=True)
    stations = dict(zip(system.stations, (140.0, 25.0), strict=False))
    gains = {"K_A": 1.3, "K_C": 7.0, "K_R": 0.4, "K_z": 0.2, "K_za": 0.2, "K_zb": -0.3}
    gains |= {"kK_z": 1e5, "K_r": 9.0, "b": 3.0}
    chosen = {name: gains[name] for name in system.gains}
    factors = system.around(eqs).factors(**chosen, **stations)
    family = vehicle_family(system, eqs.U)
    values = {**factors, **eqs.coefficients, GRAVITY: eqs.gravity, **jet_factors(eqs)}
    found = np.linalg.eigvals(family.matrices(values))
    wanted = system.function(eqs, **chosen, **stations).poles()
    assert mismatch(found, wanted) < 1e-10


@pytest.fixture(params=VIEWS)
def bench(browser, request) -> Iterator[tuple[Page, object]]:
    made = VIEWS[request.param](EQUATIONS)
    with opened(browser, made, viewport={"width": 1000, "height": 900}) as page:
        page.locator("[data-panel=vehicle]").evaluate("panel => { panel.open = true; }")
        yield page, made


def put(page: Page, name: str, text: str) -> None:
    """Type a value into the box of a slider of the vehicle."""
    box = page.locator(f"[data-panel=vehicle] [data-parameter={name}] input[type=text]")
    box.fill(text)
    box.press("Enter")
    page.wait_for_timeout(60)


def test_poles_under_a_changed_vehicle_are_the_librarys(bench):
    page, view = bench
    preset = view.payload["presets"][-1]["values"]
    show(page, **preset)
    for changes in CHANGES:
        start = {**view.payload["initial"], **preset, **changes}
        page.evaluate("values => { for (const [n, v] of Object.entries(values)) model.set(n, v); }", start)
        page.wait_for_timeout(60)
        for name, value in start.items():
            setattr(view, name, value)
        found, wanted = paired(table(page), view.poles())
        assert (abs(found - wanted) / np.maximum(abs(wanted), 1.0)).max() < 1e-8, changes


def test_copied_python_gives_the_poles_of_the_changed_vehicle(bench):
    page, _ = bench
    page.locator("[data-panel=takeaway]").evaluate("panel => { panel.open = true; }")
    page.locator("[data-parameter=gravity] select").select_option("kept")
    put(page, "q_D", "700")
    put(page, "omega_1", "2,5")
    page.wait_for_timeout(400)
    code = page.locator("[data-panel=takeaway] pre").inner_text()
    assert "rl.with_other_data(rl.printed_equations(), q_D=700, omega_1=2.5, gravity=True)" in code
    made: dict = {}
    exec(code, made)
    found, wanted = paired(table(page), made["loop"].poles())
    assert (abs(found - wanted) / np.maximum(abs(wanted), 1.0)).max() < 1e-8


def test_responses_and_mode_of_a_changed_vehicle(bench):
    """The numerators come from the matrices then: they must be those of the report's vehicle near it."""
    page, _ = bench
    show(page, K_A=1.7)
    page.locator("canvas[data-plane=responses]").scroll_into_view_if_needed()
    page.wait_for_timeout(400)
    before = page.evaluate("() => el.querySelector('canvas[data-plane=responses]').ariaLabel")
    own = page.evaluate("() => model.get('q_D')")
    show(page, q_D=own * (1 + 1e-12))
    page.wait_for_timeout(400)
    assert page.evaluate("() => el.querySelector('canvas[data-plane=responses]').ariaLabel") == before
    show(page, q_D=0.5 * own)
    page.wait_for_timeout(400)
    assert page.evaluate("() => el.querySelector('canvas[data-plane=responses]').ariaLabel") != before


def test_printed_roots_are_shown_beside_the_reports_vehicle_alone(bench):
    page, view = bench
    name = next(preset["name"] for preset in view.payload["presets"] if preset["printed"])
    page.get_by_role("button", name=name, exact=True).click()
    page.wait_for_timeout(60)
    words = page.locator(".crossings")
    assert "Printed roots (+)" in words.inner_text()
    put(page, "C_fins", "1")
    assert "Printed roots" not in words.inner_text()
    page.get_by_role("button", name="The report's vehicle").click()
    page.wait_for_timeout(60)
    assert "Printed roots (+)" in words.inner_text()


def test_address_and_undo_keep_the_vehicle(bench, browser):
    page, view = bench
    page.wait_for_timeout(500)
    before = table(page)
    put(page, "q_D", "300")
    page.wait_for_timeout(600)
    moved = table(page)
    assert abs(moved - before).max() > 1e-3
    address = page.evaluate("location.hash")
    assert "q_D=300" in address
    assert "omega_1" not in address
    with opened(browser, view, f"{SITE}{address}") as other:
        other.wait_for_timeout(300)
        assert (table(other) == moved).all()
    page.get_by_role("button", name="undo").click()
    page.wait_for_timeout(100)
    assert (table(page) == before).all()


@pytest.mark.parametrize(
    ("part", "said"),
    [
        ("q_D=1e308", "q_D from the address is beyond its range 0 to 2,000: 2,000 is shown."),
        ("omega_1=-1e308", "omega_1 from the address is beyond its range 0.3 to 30: 0.3 is shown."),
        ("C_fins=NaN", "C_fins from the address is not a number and is left out."),
        ("gravity=maybe", "gravity from the address is not one of its choices and is left out."),
        ("view.cloud=7", "view.cloud from the address is not one that can be shown and is left out."),
    ],
)
def test_hostile_values_of_the_vehicle(browser, part, said):
    with opened(browser, VIEWS["VII"](EQUATIONS), f"{SITE}#dual-actuation:{part}") as page:
        page.wait_for_timeout(200)
        assert said in page.locator("output").first.inner_text()
        assert np.isfinite(table(page)).all()


def test_the_cloud_has_the_poles_of_the_dispersed_vehicles(bench):
    page, view = bench
    button = page.get_by_role("button", name="Dispersed vehicles")
    button.click()
    said = page.locator("[data-panel=vehicle] .told")
    page.wait_for_function("() => el.querySelector('[data-panel=vehicle] .told').textContent")
    assert button.get_attribute("aria-pressed") == "true"
    everyone = [view._closed_loop(**{**view.values(), **data}) for data in _dispersed(view, DRAWS)]
    calm = sum(bool((loop.poles().real <= 1e-12).all()) for loop in everyone)
    assert said.inner_text() == f"{calm} of {DRAWS} have no root right of the axis"
    button.click()
    page.wait_for_function("() => !el.querySelector('[data-panel=vehicle] .told').textContent")


def _dispersed(view, count: int) -> list[dict]:
    factors = dispersed_data()
    return [{name: getattr(view, name) * factors[name][k] for name in DISPERSED} for k in range(count)]


def test_dispersed_data_are_the_stored_draws():
    factors = dispersed_data()
    booster = rl.swaim_booster()
    for k in (0, 7, DRAWS - 1):
        wanted = dispersed(booster, {name: drawn(k)[name] for name in DISPERSED.values()})
        own = own_data(booster)
        found = with_data(booster, **{name: own[name] * factors[name][k] for name in DISPERSED})
        assert found.flight.q_D == pytest.approx(wanted.flight.q_D, rel=2e-5)
        assert [m.omega for m in found.modes] == pytest.approx([m.omega for m in wanted.modes], rel=2e-5)
        slopes = [[s.C_Nalpha for s in vehicle.surfaces] for vehicle in (found, wanted)]
        assert slopes[0] == pytest.approx(slopes[1], rel=2e-5)


def test_sliders_of_the_vehicle_are_folded_and_hold_the_reports_own():
    for parameter in data_parameters():
        assert parameter.folded
    view = VIEWS["V"](EQUATIONS)
    assert set(DATA) <= set(view.values())
    for name in DATA:
        parameter = next(p for p in view.parameters if p.name == name)
        assert getattr(view, name) in parameter.grid
