"""The live views: the table that Python sends, what the browser makes of it, and what both refuse."""

import gzip
import json
import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from playwright.sync_api import Browser, Page
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim.explorers import Explorer, multiaffine_form, rate_attitude_explorer
from rlswaim.explorers.multiaffine import with_shapes
from rlswaim.explorers.rate_attitude import designs, form, named_poles, parameters
from rlswaim.explorers.widget import module
from rlswaim.polynomials import characteristic_polynomial
from rlswaim.tables import read_table

EQUATIONS = {"data": rl.perturbation_equations(rl.swaim_booster()), "printed": rl.printed_equations()}
MODEL = (Path(__file__).parent / "explorer_model.js").read_text(encoding="utf-8")
VIEW = {"left": -12.0, "right": 4.0, "bottom": -1.0, "top": 13.0, "scale": 40.0, "tolerance": 0.25}
FIGURE_11 = designs("IV")["Figure 11"]
gains = st.floats(-200, 200)
slopes = st.floats(-0.2, 0.2)


def paired(first: np.ndarray, second: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return both root sets in the order of the pairing of least distance."""
    rows, columns = linear_sum_assignment(abs(first[:, None] - second))
    return first[rows], second[columns]


def random_states(count: int, seed: int) -> list[dict]:
    rng = np.random.default_rng(seed)
    return [{p.name: p.grid[rng.integers(len(p.grid))] for p in parameters()} for _ in range(count)]


def closed_loop(eqs, state: dict):
    gyro = state["gyro"] if state["feedback"] == "total" else None
    return rl.rate_attitude(eqs, **{name: state[name] for name in ("K_A", "K_C", "K_R")}, gyro=gyro)


@pytest.fixture(scope="module")
def explorer() -> Explorer:
    return rate_attitude_explorer(EQUATIONS["printed"])


@pytest.fixture(scope="module")
def page(browser: Browser, explorer: Explorer) -> Iterator[Page]:
    """A blank page with the view on a stand-in for the notebook's model."""
    page = browser.new_page(viewport={"width": 900, "height": 900})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    places = {f"{p.name}_at": getattr(explorer, f"{p.name}_at") for p in explorer.parameters}
    state = {**explorer.values(), **places, "magnify": 1, "payload": explorer.payload}
    page.evaluate(MODEL, [module(), explorer._css, state])
    yield page
    assert errors == []
    page.close()


def show(page: Page, **values: object) -> None:
    """Set values of the model and wait for the drawing; they must differ from the present ones."""
    page.evaluate(
        """async (values) => {
             const done = drawn();
             for (const [name, value] of Object.entries(values)) model.set(name, value);
             await done;
           }""",
        values,
    )


def table(page: Page) -> np.ndarray:
    """Return the poles in the table at full precision."""
    rows = page.evaluate(
        "() => [...el.querySelectorAll('.poles tbody tr')].map(r => [+r.dataset.re, +r.dataset.im])"
    )
    return np.array(rows) @ [1, 1j]


class TestMultiAffineForm:
    @pytest.mark.parametrize("eqs", EQUATIONS.values(), ids=EQUATIONS)
    def test_terms_are_those_of_eq_83(self, eqs):
        loop = ("K_A", "K_C")
        assert [term.factors for term in form(eqs).terms] == [
            (),
            ("K_C",),
            loop,
            (*loop, "K_R"),
            (*loop, "sigma_1"),
            (*loop, "sigma_2"),
            (*loop, "K_R", "sigma_1"),
            (*loop, "K_R", "sigma_2"),
        ]

    @given(K_A=gains, K_C=gains, K_R=gains, sigma_1=slopes, sigma_2=slopes)
    def test_form_is_the_characteristic_polynomial(self, K_A, K_C, K_R, sigma_1, sigma_2):
        for name, eqs in EQUATIONS.items():
            here = with_shapes(eqs, slopes={100.0: (sigma_1, sigma_2)})
            loop = rl.rate_attitude(here, K_A=K_A, K_C=K_C, K_R=K_R, gyro=100.0)
            exact = characteristic_polynomial(loop.A)
            values = {"K_A": K_A, "K_C": K_C, "K_R": K_R, "sigma_1": sigma_1, "sigma_2": sigma_2}
            terms = [
                abs(math.prod(values[f] for f in term.factors) * np.array(term.coefficients))
                for term in FORMS[name].terms
            ]
            # Rounding in proportion to the terms' sizes: their sum may cancel.
            assert (abs(FORMS[name](**values) - exact) <= 2e-12 * sum(terms) + 1e-300).all()

    def test_a_square_is_found_out(self):
        def squared(K_A: float):
            return rl.rate_attitude(EQUATIONS["printed"], K_A=K_A, K_C=K_A, K_R=1.0, gyro=None)

        with pytest.raises(ValueError, match="not multi-affine in K_A"):
            multiaffine_form(squared, ("K_A",))

    def test_unknown_and_bad_factors(self):
        values = dict.fromkeys(("K_A", "K_C", "K_R", "sigma_1", "sigma_2"), 1.0)
        with pytest.raises(ValueError, match="unknown factor 'K_B', wanted K_A, K_C"):
            FORMS["printed"](**values, K_B=1.0)
        with pytest.raises(ValueError, match="K_R in MultiAffine: got nan, wanted a finite number"):
            FORMS["printed"](**{**values, "K_R": math.nan})

    def test_given_shapes_stand_at_their_stations_alone(self):
        eqs = EQUATIONS["printed"]
        here = with_shapes(eqs, deflections={140.0: (1.5, 2.5)}, slopes={60.0: (0.1, 0.2)})
        assert [mode.deflection(140.0) for mode in here.modes] == [1.5, 2.5]
        assert [mode.slope(60.0) for mode in here.modes] == [0.1, 0.2]
        assert [mode.slope(140.0) for mode in here.modes] == [mode.slope(140.0) for mode in eqs.modes]


FORMS = {name: form(eqs) for name, eqs in EQUATIONS.items()}


class TestPython:
    def test_starts_at_figure_8(self, explorer):
        assert explorer.values() == designs("IV")["Figure 8"]
        assert repr(explorer) == (
            "rate-attitude explorer: K_A = 1.8, K_C = 10.0, K_R = 0.618, gyro = 60, feedback = total"
        )

    @pytest.mark.parametrize("state", [*designs("IV").values(), *random_states(3, seed=1)])
    def test_closed_loop_is_that_of_the_library(self, state):
        moved = rate_attitude_explorer(EQUATIONS["printed"], **state)
        assert (moved.closed_loop().A == closed_loop(EQUATIONS["printed"], state).A).all()

    def test_a_value_off_the_grid_stays_and_moves_the_slider_beside_it(self):
        moved = rate_attitude_explorer(EQUATIONS["printed"], K_A=-3.1416)
        grid = moved.parameters[0].grid
        assert (moved.K_A, grid[moved.K_A_at]) == (-3.1416, -3.14)
        moved.K_A = 0.0123
        assert abs(grid[moved.K_A_at] / 0.0123 - 1) < 0.04

    def test_sliders_reach_what_the_report_uses(self):
        grids = {p.name: p.grid for p in parameters()}
        assert {-3.14, -1000.0, 0.0, 0.0016, 1.8, 1000.0} <= set(grids["K_A"])
        assert {10.0, 1.75, 0.5} <= set(grids["K_C"])
        assert {-1.0, -0.33, -0.286, 0.0, 0.12, 0.618, 1.0} <= set(grids["K_R"])
        assert grids["gyro"] == tuple(range(421))
        assert all(row["source"] for row in read_table("designs"))

    @pytest.mark.parametrize(
        ("name", "value", "error", "message"),
        [
            ("K_A", math.nan, ValueError, "K_A in rate-attitude explorer: got nan, wanted a finite number"),
            ("K_C", math.inf, ValueError, "K_C in rate-attitude explorer: got inf, wanted a finite number"),
            ("K_R", "1", TypeError, r"K_R in rate-attitude explorer: got '1' \(str\), wanted a real number"),
            ("gyro", 421, ValueError, "got station 421 ft, wanted 0 to 420 ft"),
            ("gyro", 60.5, ValueError, "got station 60.5 ft, wanted a whole number of feet"),
            ("feedback", "elastic", ValueError, "got 'elastic', wanted one of total, rigid body"),
        ],
    )
    def test_bad_values(self, explorer, name, value, error, message):
        before = explorer.values()
        with pytest.raises(error, match=message):
            setattr(explorer, name, value)
        with pytest.raises(error, match=message):
            rate_attitude_explorer(EQUATIONS["printed"], **{name: value})
        assert explorer.values() == before

    def test_unknown_parameter(self):
        with pytest.raises(TypeError, match="unknown 'K_z', wanted K_A, K_C, K_R, gyro, feedback"):
            rate_attitude_explorer(EQUATIONS["printed"], K_z=1.0)

    def test_displays_itself_with_its_sliders(self, explorer):
        bundle = explorer._repr_mimebundle_()
        assert bundle["text/plain"] == repr(explorer)
        assert bundle["application/vnd.jupyter.widget-view+json"]["model_id"] == explorer.panel.model_id

    def test_poles_are_named_by_the_motion_they_grow_out_of(self):
        named = named_poles(EQUATIONS["printed"])
        poles = {name: [pole for pole, own in named if own == name] for _, name in named}
        assert poles["attitude"] == [0]
        assert sorted(round(pole.real, 2) for pole in poles["short period"]) == [-1.54, 1.31]  # Eq. 41
        assert {round(abs(pole), 1) for pole in poles["mode 1"]} == {1.2}
        assert {round(abs(pole), 1) for pole in poles["mode 2"]} == {3.1}

    def test_weight(self, explorer):
        sent = json.dumps(explorer.payload) + module() + explorer._css
        assert len(gzip.compress(sent.encode())) < 60_000

    def test_module_neither_evaluates_text_nor_loads_anything(self):
        for word in ("eval(", "Function(", "import(", "fetch(", "http", "\nimport "):
            assert word not in module()


class TestNumbersInTheBrowser:
    def test_poles_agree_with_python(self, page, explorer):
        states = random_states(200, seed=1964)
        found = page.evaluate(
            """([system, states, view]) => states.map((s) => {
                 const { x, y } = module.rootLocus(system, s, view).present;
                 return [[...x], [...y]];
               })""",
            [explorer.payload, states, VIEW],
        )
        for state, (x, y) in zip(states, found, strict=True):
            poles = closed_loop(EQUATIONS["printed"], state).poles()
            ours, theirs = paired(poles, np.array(x) + 1j * np.array(y))
            assert (abs(ours - theirs) <= 1e-8 * np.maximum(1, abs(ours))).all(), state

    @pytest.mark.parametrize("state", [*designs("IV").values(), *random_states(8, seed=3)])
    def test_locus_is_true_to_half_a_pixel(self, page, explorer, state):
        """Every root at many gains between the nodes lies on its own branch as drawn."""
        points, (D, N) = page.evaluate(
            """([system, state, view]) => {
                 const points = module.rootLocus(system, state, view).branches;
                 const { D, N } = module.openLoop(system, state);
                 return [points.map(({ t, x, y }) => [t, [...x], [...y]]), [[...D], [...N]]];
               }""",
            [explorer.payload, state, VIEW],
        )
        for (a, *first), (b, *second) in pairwise(points):
            start, end = (np.array(x) + 1j * np.array(y) for x, y in (first, second))
            for share in (0.1, 0.3, 0.6, 0.85):
                k = a + share * (b - a) if a * b == 0 else a * (b / a) ** share
                roots = np.roots((np.array(D) + k * np.array(N))[::-1])
                across = (roots.real > VIEW["left"]) & (roots.real < VIEW["right"])
                seen = roots[across & (abs(roots.imag) < VIEW["top"])]
                chord = np.where(end == start, 1e-300, end - start)
                along = np.clip(((seen[:, None] - start) / chord).real, 0, 1)
                miss = abs(seen[:, None] - start - along * (end - start)).min(axis=1, initial=np.inf)
                assert (miss * VIEW["scale"] < 0.5).all(), (k, seen)

    @pytest.mark.parametrize("state", designs("IV").values(), ids=designs("IV"))
    def test_break_aways_and_crossings_are_those_of_the_library(self, page, explorer, state):
        found = page.evaluate(
            """([system, state, view]) => {
                 const { breaks, crossings, end } = module.rootLocus(system, state, view);
                 return [breaks, crossings, end];
               }""",
            [explorer.payload, state, VIEW],
        )
        breaks, crossings, end = found
        values = {
            **{name: state[name] for name in ("K_C", "K_R")},
            **{f"sigma_{i + 1}": m.slope(state["gyro"]) for i, m in enumerate(EQUATIONS["printed"].modes)},
        }
        if state["feedback"] == "rigid body":
            values |= {"sigma_1": 0.0, "sigma_2": 0.0}
        D, N = FORMS["printed"](K_A=0.0, **values), FORMS["printed"](K_A=1.0, **values)
        locus = rl.root_locus(control.tf((N - D)[::-1].tolist(), D[::-1].tolist()), gains=[0.0])
        ours = sorted(b.gain for b in locus.break_aways if 0 < b.gain / end < 1)
        assert sorted(b["gain"] for b in breaks) == pytest.approx(ours, rel=1e-6)
        ours = sorted((c.gain, c.omega) for c in locus.crossings if 0 < c.gain / end < 1)
        theirs = sorted((c["gain"], c["omega"]) for c in crossings)
        assert np.array(theirs) == pytest.approx(np.array(ours), rel=1e-6)

    def test_labels_do_not_depend_on_the_window(self, page, explorer):
        far = page.evaluate(
            """([system, states, view]) => {
                 const ends = (s, v) => {
                   const { x, y } = module.rootLocus(system, s, v).branches.at(-1);
                   return [...x, ...y];
                 };
                 const close = { ...view, left: -0.3, right: 0.1, top: 0.3, scale: 1000 };
                 return states.map((s) => [ends(s, view), ends(s, close)]);
               }""",
            [explorer.payload, [*designs("IV").values(), *random_states(60, seed=7)], VIEW],
        )
        for wide, close in far:
            assert np.array(wide) == pytest.approx(np.array(close), rel=1e-3, abs=1e-3)

    def test_branches_start_at_the_named_poles(self, page, explorer):
        open_poles, first = page.evaluate(
            """([system, state, view]) => {
                 const { open, branches } = module.rootLocus(system, state, view);
                 return [[open.x, open.y, open.branches], [[...branches[0].x], [...branches[0].y]]];
               }""",
            [explorer.payload, explorer.values(), VIEW],
        )
        assert open_poles[:2] == first
        assert open_poles[2][-1] == "actuator"
        assert open_poles[0][-1] == -explorer.K_C

    def test_pole_map_ends_where_the_library_says(self, page, explorer):
        state = explorer.values()
        sides = page.evaluate(
            """([system, state, view]) => {
                 const { present } = module.rootLocus(system, state, view);
                 return module.poleMap(system, state, present, view).map((side) => {
                   const { t, x, y } = side.at(-1);
                   return [t, [...x], [...y]];
                 });
               }""",
            [explorer.payload, state, VIEW],
        )
        assert [t for t, *_ in sides] == [0, 420]
        for t, x, y in sides:
            poles = closed_loop(EQUATIONS["printed"], {**state, "gyro": t}).poles()
            ours, theirs = paired(poles, np.array(x) + 1j * np.array(y))
            # Good for a picture; the present poles, above, are good to the last digits.
            assert (abs(ours - theirs) < 1e-6 * np.maximum(1, abs(ours))).all()


class TestView:
    def test_table_follows_the_values(self, page):
        for state in [*random_states(5, seed=5), designs("IV")["Figure 8"]]:
            show(page, **state)
            ours, theirs = paired(closed_loop(EQUATIONS["printed"], state).poles(), table(page))
            assert (abs(ours - theirs) <= 1e-8 * np.maximum(1, abs(ours))).all()

    def test_table_tells_each_pole_as_text(self, page):
        show(page, **FIGURE_11)
        rows = page.locator("[data-explorer=rate-attitude] table.poles tbody tr")
        assert rows.count() == 8
        for row in rows.all():
            real, imaginary, omega, zeta, word = row.locator("td").all_text_contents()
            pole = complex(float(row.get_attribute("data-re")), float(row.get_attribute("data-im")))
            assert float(real) == pytest.approx(pole.real, rel=1e-7)
            assert float(imaginary) == pytest.approx(pole.imag, rel=1e-7)
            assert float(omega) == pytest.approx(abs(pole), rel=1e-7)
            assert float(zeta) == pytest.approx(-pole.real / abs(pole), rel=1e-7)
            assert word == ("unstable" if pole.real > 0 else "stable")
            assert row.get_attribute("data-branch") == row.locator("th").inner_text().split(" ", 1)[1]

    def test_words_name_the_worst_root_and_its_doubling_time(self, page):
        show(page, **FIGURE_11, magnify=3)
        worst = max(closed_loop(EQUATIONS["printed"], FIGURE_11).poles().real)
        words = page.locator(".verdict").inner_text()
        assert words.startswith(f"Unstable because of a real root at +{worst:.4g} 1/s (from short period)")
        assert f"doubles every {math.log(2) / worst:.3g} s" in words
        assert page.locator("[role=status]").text_content().startswith("Unstable: 2 of 8 roots")
        for kind in ("locus", "map"):
            assert "nstable" in page.locator(f"canvas[data-plane={kind}]").get_attribute("aria-label")

    def test_neutral_without_feedback_apart_from_the_divergence(self, page):
        show(page, K_A=0, feedback="total")
        attitude = page.locator("tr[data-branch=attitude]")
        assert attitude.get_attribute("data-re") == "0"
        assert attitude.locator("td").last.inner_text() == "neutrally stable"

    def test_value_and_slider_keep_each_other(self, page, explorer):
        grid = explorer.parameters[0].grid
        show(page, K_A=-3.1416)
        assert page.evaluate("state.K_A_at") == explorer.parameters[0].nearest(-3.1416) == grid.index(-3.14)
        assert page.evaluate("state.K_A") == -3.1416
        show(page, K_A_at=0)
        assert page.evaluate("state.K_A") == grid[0] == -1000

    @pytest.mark.parametrize("name", designs("IV"))
    def test_presets(self, page, name):
        show(page, K_A=7.7, K_C=3.0)
        page.get_by_role("button", name=name, exact=True).click()
        pressed = "name => document.querySelector('[aria-pressed=true]')?.textContent === name"
        page.wait_for_function(pressed, arg=name)
        design = designs("IV")[name]
        assert page.evaluate("names => names.map(n => state[n])", list(design)) == list(design.values())

    def test_reset(self, page, explorer):
        show(page, K_A=7.7, magnify=100)
        page.get_by_role("button", name="Reset").click()
        page.wait_for_function("state.K_A === state.payload.initial.K_A && state.magnify === 1")

    def test_same_state_same_picture(self, page):
        def pictures() -> list[str]:
            return page.evaluate("[...document.querySelectorAll('canvas')].map(c => c.toDataURL())")

        show(page, **FIGURE_11)
        before = pictures()
        show(page, K_A=0.5, K_R=0.9)
        show(page, magnify=10)
        assert pictures() != before
        show(page, **FIGURE_11, magnify=1)
        assert pictures() == before

    def test_draws_are_joined_in_one_frame(self, page):
        count = page.evaluate(
            """async () => {
                 let count = 0;
                 el.addEventListener('rlswaim:drawn', () => (count += 1));
                 const done = drawn();
                 for (let i = 1; i < 20; i += 1) model.set('K_A', i);
                 const { ms } = await done;
                 await new Promise((next) => setTimeout(next, 100));
                 return ms > 0 ? count : -1;
               }"""
        )
        assert count == 1

    def test_theme_changes_the_picture(self, page):
        pixel = "document.querySelector('canvas').getContext('2d').getImageData(120, 40, 1, 1).data[0]"
        light = page.evaluate(pixel)
        theme = "async (t) => { const d = drawn(); document.documentElement.dataset.theme = t; await d; }"
        page.evaluate(theme, "dark")
        assert page.evaluate(pixel) < 64
        assert light > 192
        page.evaluate(theme, "light")
        assert page.evaluate(pixel) == light

    def test_fits_a_narrow_page(self, page):
        page.evaluate("async () => { const d = drawn(); el.style.width = '328px'; await d; }")
        assert page.evaluate("el.scrollWidth") <= 328
        page.evaluate("async () => { const d = drawn(); el.style.width = ''; await d; }")
