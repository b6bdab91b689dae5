"""The live views beside the root loci: what Python sends, what the browser makes of it, what readers do."""

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim import explorers
from rlswaim.explorers import ascent, bent_vehicle, coupled_vehicle, coupling_tables, station_map
from rlswaim.explorers.control_systems import DUAL_ACTUATION
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.scripts import module
from rlswaim.loops import station_maps
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial
from rlswaim.vehicle import trajectory
from standin import go_to_empty_page

MODEL = (Path(__file__).parent / "explorer_model.js").read_text(encoding="utf-8")
BOOSTER, PRINTED = rl.swaim_booster(), rl.printed_equations()
COEFFICIENTS = rl.perturbation_equations(BOOSTER).coefficients
ASCENT = trajectory.swaim_ascent()
MAKERS: dict[str, Callable[..., LiveView]] = {
    "bent-vehicle": lambda **values: explorers.bent_vehicle_explorer(BOOSTER, **values),
    "trajectory": lambda **values: explorers.ascent_explorer(ASCENT, BOOSTER.flight, **values),
    "coupling": lambda **values: explorers.coupled_vehicle_explorer(BOOSTER, **values),
    "station-map": lambda **values: explorers.station_map_explorer(PRINTED, **values),
}
view_of = cache(lambda name: MAKERS[name]())


def random_states(view: LiveView, count: int, seed: int) -> list[dict]:
    rng = np.random.default_rng(seed)
    return [{p.name: p.grid[rng.integers(len(p.grid))] for p in view.parameters} for _ in range(count)]


def mismatch(ours: np.ndarray, theirs: np.ndarray) -> float:
    """Return the largest distance in the best pairing, relative to the larger of 1 and our root."""
    rows, columns = linear_sum_assignment(abs(ours[:, None] - theirs))
    return float((abs(ours[rows] - theirs[columns]) / np.maximum(1, abs(ours[rows]))).max())


@contextmanager
def opened(browser: Browser, view: LiveView, width: int = 760) -> Iterator[Page]:
    """A page with one view on a stand-in for the notebook's model."""
    page = browser.new_page(viewport={"width": width, "height": 900})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    go_to_empty_page(page)
    places = {f"{p.name}_at": getattr(view, f"{p.name}_at") for p in view.parameters}
    page.evaluate(MODEL, [view._esm, view._css, {**view.values(), **places, "payload": view.payload}])
    yield page
    assert errors == []
    page.close()


@pytest.fixture(scope="module", params=MAKERS)
def shown(request: pytest.FixtureRequest, browser: Browser) -> Iterator[tuple[Page, LiveView]]:
    with opened(browser, view_of(request.param)) as page:
        yield page, view_of(request.param)


@pytest.fixture(params=MAKERS)
def fresh(request: pytest.FixtureRequest, browser: Browser) -> Iterator[tuple[Page, LiveView]]:
    """The same, on a page that nobody has touched."""
    with opened(browser, view_of(request.param)) as page:
        page.wait_for_function("document.querySelector('table tbody tr')")
        yield page, view_of(request.param)


def show(page: Page, **values: object) -> dict:
    """Set values of the model and wait for the drawing; they must differ from the present ones."""
    return page.evaluate(
        """async (values) => {
             const done = drawn();
             for (const [name, value] of Object.entries(values)) model.set(name, value);
             return done;
           }""",
        values,
    )


class TestEveryView:
    def test_is_named_and_told_in_words(self, shown):
        page, view = shown
        assert page.evaluate("el.dataset.explorer") == view.system
        for canvas in page.locator("canvas").all():
            assert len(canvas.get_attribute("aria-label")) > 20
        assert len(page.locator("[role=status]").text_content()) > 20
        assert page.locator("table tbody tr").count() > 2

    def test_every_slider_runs_to_both_ends(self, shown):
        page, view = shown
        for p in view.parameters:
            for end in (len(p.grid) - 1, 0):
                if page.evaluate(f"state.{p.name}_at") != end:
                    assert show(page, **{f"{p.name}_at": end})["ms"] > 0
                assert page.evaluate(f"state.{p.name}") == p.grid[end]
        text = page.locator("body").inner_text()
        assert "NaN" not in text
        assert "undefined" not in text
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("Object.entries(state.payload.initial).every(([n, v]) => state[n] === v)")

    def test_presets_set_their_values(self, shown):
        page, view = shown
        for preset in view.payload["presets"]:
            page.get_by_role("button", name=preset["name"], exact=True).click()
            pressed = "name => document.querySelector('[aria-pressed=true]')?.textContent === name"
            page.wait_for_function(pressed, arg=preset["name"])
            assert page.evaluate("names => names.map(n => state[n])", list(preset["values"])) == list(
                preset["values"].values()
            )
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("Object.entries(state.payload.initial).every(([n, v]) => state[n] === v)")

    def test_a_change_is_drawn_before_its_event_is_over(self, shown):
        page, view = shown
        name, grid = next((p.name, p.grid) for p in view.parameters if not isinstance(p.grid[0], str))
        if view.system == "station-map":  # until all its rows are there each frame has its drawing
            page.wait_for_function("el.dataset.step === 'complete'")
        counts = page.evaluate(
            """async ([name, values]) => {
                 const frame = () => new Promise(requestAnimationFrame);
                 let count = 0;
                 const note = () => count++;
                 el.addEventListener('rlswaim:drawn', note);
                 const counts = [];
                 await frame(); await frame();
                 count = 0;
                 model.set(name, values[0]);
                 await null;
                 counts.push(count);
                 model.set(name, values[1]);
                 model.set(name, values[2]);
                 await null;
                 counts.push(count);
                 await frame(); await frame();
                 counts.push(count);
                 el.removeEventListener('rlswaim:drawn', note);
                 return counts;
               }""",
            [name, [grid[1], grid[2], grid[3]]],
        )
        if view.system == "station-map":  # its rows begin to come
            counts[2] = min(counts[2], 2)
        assert counts == [1, 1, 2], "at once, then once more with the next frame"
        page.get_by_role("button", name="Reset").click()

    def test_undo_redo_and_the_address(self, fresh):
        page, view = fresh
        own = [p for p in view.parameters if not isinstance(p.grid[0], str)]
        start = {p.name: view.payload["initial"][p.name] for p in own}
        values = "names => names.map(name => state[name])"
        first, last = own[0], own[-1]
        places = {p.name: next(v for v in p.grid if v != start[p.name]) for p in (first, last)}
        for name, value in places.items():
            show(page, **{name: value})
            page.wait_for_timeout(900)  # a step of the history ends where the hand rests
        said = page.evaluate("location.hash")
        assert said == f"#{view.system}:" + ",".join(f"{name}={value:g}" for name, value in places.items())
        page.get_by_role("button", name="undo").click()
        assert page.evaluate(values, list(places)) == [places[first.name], start[last.name]]
        page.get_by_role("button", name="undo").click()
        assert page.evaluate(values, list(places)) == [start[first.name], start[last.name]]
        assert page.get_by_role("button", name="undo").is_disabled()
        page.wait_for_function("() => !location.hash")
        page.get_by_role("button", name="redo").click()
        page.locator("canvas").first.press("Control+Shift+z")
        assert page.evaluate(values, list(places)) == list(places.values())
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("() => !location.hash")
        page.evaluate("hash => { location.hash = hash; }", said)
        page.wait_for_function(
            "([names, wanted]) => names.every((name, i) => state[name] === wanted[i])",
            arg=[list(places), list(places.values())],
        )
        page.evaluate(f"location.hash = '{view.system}:{first.name}=1e9,{last.name}=two'")
        page.wait_for_timeout(50)
        assert page.evaluate(values, list(places)) == list(places.values()), "what makes no sense is left"
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("() => !location.hash")

    def test_fits_a_narrow_page_and_a_dark_one(self, shown):
        page, _ = shown
        page.evaluate("async () => { const d = drawn(); el.style.width = '328px'; await d; }")
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth && el.scrollWidth <= 328")
        page.evaluate("async () => { const d = drawn(); el.style.width = ''; await d; }")
        light = page.evaluate("getComputedStyle(el).color")
        theme = "async (t) => { const d = drawn(); document.documentElement.dataset.theme = t; await d; }"
        page.evaluate(theme, "dark")
        assert page.evaluate("getComputedStyle(el).color") != light
        page.evaluate(theme, "light")

    @pytest.mark.parametrize("name", MAKERS)
    def test_python_refuses_what_makes_no_sense(self, name):
        first = view_of(name).parameters[0].name
        with pytest.raises(ValueError, match=f"{first} in {name} explorer: got nan"):
            MAKERS[name](**{first: math.nan})
        with pytest.raises(
            TypeError, match=rf"{name} explorer: got a missing or unknown 'K_x', wanted {first}"
        ):
            MAKERS[name](K_x=1.0)
        with pytest.raises(TypeError, match=f"{first} in {name} explorer"):
            setattr(view_of(name), first, "far")

    @pytest.mark.parametrize("name", MAKERS)
    def test_a_value_moves_its_slider(self, name):
        view = MAKERS[name]()
        first = view.parameters[0]
        setattr(view, first.name, first.grid[3])
        assert getattr(view, f"{first.name}_at") == 3
        assert f"{first.name} = {first.grid[3]}" in repr(view)


class TestBentVehicle:
    def test_forces_add_up_to_eq_29(self):
        c = rl.perturbation_equations(BOOSTER).coefficients
        sums = {
            (row, motion): sum(rows[row][motion] for rows in bent_vehicle.forces(BOOSTER).values())
            for row in bent_vehicle.ROWS
            for motion in bent_vehicle.MOTIONS
        }
        degree = math.radians(1)
        assert sums["Z", "alpha"] == pytest.approx(-BOOSTER.M * c["Z_alpha"] * degree, rel=1e-12)
        assert sums["M", "q_2"] == pytest.approx(-BOOSTER.I_y * c["M_q2"], rel=1e-9)
        mode = BOOSTER.modes[0]
        assert sums["F1", "q_1"] == pytest.approx(mode.mass * (c["F1_q1"] - mode.omega**2), rel=1e-9)

    def test_thrust_is_that_of_eqs_10_and_11(self):
        thrust, G = bent_vehicle.forces(BOOSTER)["thrust"], BOOSTER.thrust_station
        sigma, phi = BOOSTER.modes[0].slope(G), BOOSTER.modes[0].deflection(G)
        assert thrust["Z"]["q_1"] == pytest.approx(-BOOSTER.T * sigma)
        assert thrust["M"]["q_1"] == pytest.approx(-BOOSTER.T * (BOOSTER.l_G * sigma + phi))
        assert thrust["M"]["delta"] == pytest.approx(BOOSTER.T * BOOSTER.l_G * math.radians(1))
        assert thrust["F1"]["delta"] == pytest.approx(BOOSTER.T * phi * math.radians(1))

    def test_the_air_is_that_of_eq_20(self):
        fins = BOOSTER.surfaces[1]
        one = BOOSTER.flight.q_D * BOOSTER.S * fins.C_Nalpha
        found = bent_vehicle.forces(BOOSTER)["fins"]
        assert found["Z"]["alpha"] == pytest.approx(-one * math.radians(1))
        assert found["Z"]["q_2"] == pytest.approx(-one * BOOSTER.modes[1].slope(fins.station))
        assert found["M"]["alpha"] == pytest.approx(one * (BOOSTER.l_CG - fins.station) * math.radians(1))

    def test_the_browser_adds_up_the_same(self, browser):
        view = view_of("bent-vehicle")
        states = random_states(view, 1000, seed=1)
        phi = [mode.deflection(60.0) for mode in BOOSTER.modes]
        with opened(browser, view) as page:
            found = page.evaluate(
                """([payload, states]) => states.map(s =>
                     [module.loads(payload, s).sum, module.height(payload, s, 60)])""",
                [view.payload, states],
            )
        assert MAKERS["bent-vehicle"](**states[0]).loads() == pytest.approx(
            _loads(states[0]), rel=1e-9, abs=1e-3
        )
        for state, (loads, height) in zip(states, found, strict=True):
            assert loads == pytest.approx(_loads(state), rel=1e-9, abs=1e-3)
            turned = math.radians(state["theta"]) * (BOOSTER.l_CG - 60)
            assert height == pytest.approx(turned + state["q_1"] * phi[0] + state["q_2"] * phi[1], abs=1e-3)


def _loads(state: dict) -> dict[str, float]:
    """Return the four loads from the whole vehicle's coefficients."""
    c = COEFFICIENTS
    inertia = (-BOOSTER.M, -BOOSTER.I_y, *(mode.mass for mode in BOOSTER.modes))
    found = {}
    for row, weight in zip(bent_vehicle.ROWS, inertia, strict=True):
        found[row] = weight * (
            c[f"{row}_q1"] * state["q_1"]
            + c[f"{row}_q2"] * state["q_2"]
            + c[f"{row}_alpha"] * math.radians(state["alpha"])
            + c[f"{row}_delta"] * math.radians(state["delta"])
        )
    for i, mode in enumerate(BOOSTER.modes, start=1):
        found[f"F{i}"] -= mode.mass * mode.omega**2 * state[f"q_{i}"]
    return found


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
                     const { curves, peak } = module.flight(payload, s);
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


class TestCoupledVehicle:
    def test_coefficients_are_those_of_the_library(self):
        table = coupling_tables.coefficient_table(BOOSTER)
        factors = {
            "q_D": 900.0,
            "C_payload": 0.03,
            "C_fins": 0.4,
            "omega_1": 1.7,
            "omega_2": 5.0,
            "coupling": 1.0,
        }
        places = {"payload": 90.0, "fins": 333.0}
        for name, at in places.items():
            factors[f"arm_{name}"] = at - BOOSTER.l_CG
            for i, mode in enumerate(BOOSTER.modes, start=1):
                factors |= {f"phi_{i}_{name}": mode.deflection(at), f"sigma_{i}_{name}": mode.slope(at)}
        varied = replace(
            BOOSTER,
            flight=replace(BOOSTER.flight, q_D=900.0),
            modes=tuple(replace(m, omega=w) for m, w in zip(BOOSTER.modes, (1.7, 5.0), strict=True)),
            surfaces=tuple(
                replace(s, station=places[s.name], C_Nalpha=factors[f"C_{s.name}"]) for s in BOOSTER.surfaces
            ),
        )
        wanted = rl.perturbation_equations(varied).coefficients
        for name, products in table.items():
            found = sum(p.weight * math.prod(factors[f] for f in p.factors) for p in products)
            assert found == pytest.approx(wanted[name], rel=1e-11, abs=1e-14), name

    def test_determinant_is_the_characteristic_polynomial(self):
        eqs = PRINTED
        for order in (2, 3, 4):
            p = np.zeros(9)
            for weight, power, names in coupling_tables.determinant_table(range(order), eqs.U):
                p[power] += weight * math.prod(eqs.coefficients[n] for n in names)
            assert p[: 2 * order] == pytest.approx(eqs.characteristic_polynomial(order), rel=1e-12, abs=1e-15)

    def test_poles_agree_with_python_on_1000_states(self, browser):
        view = view_of("coupling")
        states = random_states(view, 1000, seed=1964)
        with opened(browser, view) as page:
            found = page.evaluate(
                """([payload, states]) => states.map(s => {
                     const { x, y } = module.poles(payload, s);
                     return [[...x], [...y]];
                   })""",
                [view.payload, states],
            )
        for state, (x, y) in zip(states, found, strict=True):
            given = {k: float(v) for k, v in state.items() if k != "running"}
            ours = coupled_vehicle.vehicle(BOOSTER, **given).poles()
            assert mismatch(ours, np.array([0, *(np.array(x) + 1j * np.array(y))])) <= 1e-8, state

    def test_paths_start_uncoupled_and_end_at_the_poles(self, browser):
        view = view_of("coupling")
        window = {"left": -3, "right": 3, "top": 6, "scale": 100, "tolerance": 0.3}
        states = [
            s | {"running": r} for r in ("coupling", "q_D", "l_fins") for s in random_states(view, 20, 3)
        ]
        with opened(browser, view) as page:
            found = page.evaluate(
                """([payload, states, window]) => states.map(s => {
                     const { start, present, names, runs } = module.paths(payload, s, window);
                     const pairs = ({ x, y }) => [...x].map((v, i) => [v, y[i]]);
                     const ends = runs.map(r => [r.at(-1).t, pairs(r.at(-1))]);
                     return [pairs(start), pairs(present), names, ends];
                   })""",
                [view.payload, states, window],
            )
        for state, (start, present, names, runs) in zip(states, found, strict=True):
            given = {k: float(v) for k, v in state.items() if k != "running"}
            vehicle = coupled_vehicle.vehicle(BOOSTER, **given)
            points = np.array(present) @ [1, 1j]
            assert mismatch(vehicle.poles(), np.array([0, *points])) <= 1e-8
            assert names == ["short period"] * 2 + ["mode 1"] * 2 + ["mode 2"] * 2
            alone = np.array([0, *(np.array(start) @ [1, 1j])])
            assert mismatch(_uncoupled(vehicle), alone) <= 1e-8
            for end, last in runs:
                moved = given if state["running"] == "coupling" else {**given, state["running"]: end}
                poles = coupled_vehicle.vehicle(BOOSTER, **moved).poles()
                # Good for a picture; near a multiple root (no air) no path can be good to more digits.
                assert mismatch(poles, np.array([0, *(np.array(last) @ [1, 1j])])) < 1e-4, state

    def test_cures_are_the_three_of_the_conclusion(self):
        named = {case["name"]: case["values"] for case in coupled_vehicle.cures(BOOSTER)}
        own = named.pop("As it is")
        roots = {
            name: coupled_vehicle.vehicle(BOOSTER, **{k: float(v) for k, v in values.items()})
            .poles()
            .real.max()
            for name, values in named.items()
        }
        assert own["l_fins"] == 407
        assert len(roots) == 4
        worst = rl.perturbation_equations(BOOSTER).state_space().poles().real.max()
        assert all(root < worst for root in roots.values())

    def test_the_table_and_the_words_follow(self, browser):
        view = view_of("coupling")
        with opened(browser, view) as page:
            show(page, omega_1=2.5, q_D=700)
            rows = page.locator("[data-explorer=coupling] table.poles tbody tr")
            poles = []
            for row in rows.all():
                real, imaginary, omega, zeta, word = row.locator("td").all_text_contents()
                pole = complex(float(real), float(imaginary))
                poles.append(pole)
                assert float(omega) == pytest.approx(abs(pole), rel=1e-7)
                assert zeta == "–" or float(zeta) == pytest.approx(-pole.real / abs(pole), rel=1e-6)
                assert word == (
                    "unstable" if pole.real > 0 else "stable" if pole.real < 0 else "neutrally stable"
                )
            varied = coupled_vehicle.vehicle(
                BOOSTER, **{**coupled_vehicle.own_values(BOOSTER), "omega_1": 2.5, "q_D": 700.0}
            )
            assert mismatch(varied.poles(), np.array(poles)) < 1e-7
            double = math.log(2) / max(varied.poles().real)
            assert f"doubles its motion every {double:.3g} s" in page.locator(".verdict").inner_text()


def _uncoupled(vehicle: control.StateSpace) -> np.ndarray:
    """Return the poles of the three diagonal blocks and of the attitude."""
    kept = [0, 2, 3, 4, 5, 6]
    A = vehicle.A[np.ix_(kept, kept)]
    block = np.array([0, 0, 1, 1, 2, 2])
    return np.append(np.linalg.eigvals(np.where(block[:, None] == block, A, 0)), 0)


class TestStationMap:
    GAINS = ("K_A", "K_C", "K_R", "kK_z", "K_r", "b")

    def test_form_is_the_characteristic_polynomial(self):
        form, rng = DUAL_ACTUATION.polynomial(PRINTED), np.random.default_rng(7)
        for _ in range(20):
            gains = dict(zip(self.GAINS, rng.uniform(-3, 10, 6), strict=True)) | {"kK_z": rng.normal() * 1e5}
            sensor, jet = rng.uniform(0, 420, 2)
            values = gains | {"arm": jet - PRINTED.l_CG}
            for i, mode in enumerate(PRINTED.modes, start=1):
                values |= {f"phi_{i}": mode.deflection(sensor), f"phi_{i}r": mode.deflection(jet)}
            exact = characteristic_polynomial(rl.dual_actuation(PRINTED, **gains, sensor=sensor, jet=jet).A)
            size = sum(
                abs(math.prod(values[f] for f in term.factors) * np.array(term.coefficients))
                for term in form.terms
            )
            assert (abs(form(**values) - exact) <= 1e-11 * size + 1e-300).all()

    def test_map_is_that_of_the_library(self, browser):
        """At random pairs, for the designs and for random gains, at every fineness of the map."""
        view, rng = view_of("station-map"), np.random.default_rng(11)
        gains = [{n: d[n] for n in self.GAINS} for d in station_map.designs().values()]
        gains += [{n: s[n] for n in self.GAINS} for s in random_states(view, 2, seed=5)]
        with opened(browser, view) as page:
            found = page.evaluate(
                """async ([code, payload, gains]) => {
                     const script = new Blob([code], { type: 'text/javascript' });
                     const map = await import(URL.createObjectURL(script));
                     return gains.map(g => [...map.rows(map.planOf(payload, g), [28, 7])]
                       .filter(r => r.values).map(({ step, jet, values }) => [step, jet, [...values]]));
                   }""",
                [module("abscissa"), view.payload, gains],
            )
        for at, rows in zip(gains, found, strict=True):
            family = station_maps.DualActuationFamily.of(PRINTED, **at)
            cells = [(jet, n * step, v) for step, jet, values in rows for n, v in enumerate(values)]
            picked = [cells[k] for k in rng.integers(len(cells), size=400)]
            jets, sensors, values = (np.array(c) for c in zip(*picked, strict=True))
            ours = family(sensors, jets)
            size = abs(np.linalg.eigvals(family.matrices(sensors, jets))).max(axis=1)
            assert (abs(values - ours) <= 1e-8 * np.maximum(1, size)).all(), at

    def test_map_comes_coarse_first_and_is_whole_in_the_end(self, browser):
        with opened(browser, view_of("station-map")) as page:
            page.wait_for_function("el.dataset.step === 'complete'", timeout=20000)
            assert "All 177,241 pairs" in page.locator(".crossings").inner_text()
            page.evaluate(
                """() => {
                     globalThis.seen = [];
                     el.addEventListener('rlswaim:drawn', () => seen.push(el.dataset.step));
                   }"""
            )
            show(page, K_R=0.5)
            page.wait_for_function("el.dataset.step === 'complete'", timeout=20000)
            steps = page.evaluate(
                "[...new Set(seen)].filter(s => s !== '0').map(s => s === 'complete' ? 0 : +s)"
            )
            assert steps == sorted(steps, reverse=True)
            assert len(steps) > 1

    def test_click_and_keys_pick_the_pair(self, browser):
        view = view_of("station-map")
        with opened(browser, view) as page:
            canvas = page.locator("canvas[data-plane=stations]")
            box = canvas.bounding_box()
            left, right, top, bottom = 50, 12, 10, 36
            x = left + (100.5 / 421) * (box["width"] - left - right)
            y = box["height"] - bottom - (300.5 / 421) * (box["height"] - top - bottom)
            canvas.click(position={"x": x, "y": y})
            page.wait_for_function("state.sensor === 100 && state.jet === 300")
            assert page.evaluate("[state.sensor_at, state.jet_at]") == [100, 300]
            canvas.focus()
            for key in ("ArrowRight", "ArrowUp", "ArrowUp", "Shift+ArrowLeft", "Enter"):
                canvas.press(key)
            page.wait_for_function("state.sensor === 91 && state.jet === 302")
            design = station_map.designs()["The pair that works"] | {"sensor": 91, "jet": 302}
            ours = rl.dual_actuation(PRINTED, **design).poles().real.max()
            shows = "ours => Math.abs(+document.querySelector('.verdict').dataset.value - ours) < 1e-8"
            page.wait_for_function(shows, arg=ours)

    def test_without_a_worker_the_page_computes_in_turns(self, browser):
        view = MAKERS["station-map"]()
        page = browser.new_page()
        page.set_content("<!doctype html><title>view</title>")
        page.evaluate(
            "() => { globalThis.Worker = class { constructor() { throw new Error('refused'); } }; }"
        )
        places = {f"{p.name}_at": getattr(view, f"{p.name}_at") for p in view.parameters}
        page.evaluate(MODEL, [view._esm, view._css, {**view.values(), **places, "payload": view.payload}])
        page.wait_for_function("+el.dataset.step > 0 || el.dataset.step === 'complete'", timeout=20000)
        page.close()

    def test_table_3_is_told(self, browser):
        with opened(browser, view_of("station-map")) as page:
            rows = page.locator("table.values tbody tr")
            assert rows.count() == 24
            design = station_map.designs()["The pair that works"] | {"sensor": 140, "jet": 56}
            ours = rl.dual_actuation(PRINTED, **design).poles().real.max()
            assert float(rows.nth(1).get_attribute("data-value")) == pytest.approx(ours, abs=1e-9)

    def test_stands_beside_another_view_of_the_same_gains(self):
        first = MAKERS["station-map"]()
        second = explorers.station_map_explorer(PRINTED, beside=first)
        assert len(second.panel.children) == 1
        assert len(first.panel.children) == len(first.parameters) + 1
