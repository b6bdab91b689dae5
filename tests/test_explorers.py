"""The live views: what Python holds, what the page shows of it, and what both refuse."""

import base64
import gzip
import json
import math
from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import rlswaim as rl
from rlswaim.explorers import Comparison, Explorer, designs, rate_attitude_explorer
from rlswaim.explorers.vehicle_sliders import data_values
from rlswaim.source.tables import read_table
from standin import opened, paired, show, table

EQUATIONS = rl.printed_equations()
FIGURE_11 = designs("IV")["Figure 11"]


def closed_loop(state: dict):
    gyro = state["gyro"] if state["feedback"] == "total" else None
    return rl.rate_attitude(EQUATIONS, **{name: state[name] for name in ("K_A", "K_C", "K_R")}, gyro=gyro)


@pytest.fixture(scope="module")
def explorer() -> Explorer:
    return rate_attitude_explorer(EQUATIONS)


def random_states(count: int, seed: int) -> list[dict]:
    rng = np.random.default_rng(seed)
    places = [(p.name, p.grid) for p in rate_attitude_explorer(EQUATIONS).parameters if not p.folded]
    return [{name: grid[rng.integers(len(grid))] for name, grid in places} for _ in range(count)]


@pytest.fixture(scope="module")
def page(browser: Browser, explorer: Explorer) -> Iterator[Page]:
    """A blank page with the view on a stand-in for the notebook's model."""
    with opened(browser, explorer) as page:
        yield page


class TestPython:
    def test_starts_at_figure_8(self, explorer):
        assert explorer.values() == {**designs("IV")["Figure 8"], **data_values(EQUATIONS)}
        assert repr(explorer) == (
            "rate-attitude explorer: K_A = 1.8, K_C = 10.0, K_R = 0.618, gyro = 60, feedback = total"
        )

    @pytest.mark.parametrize("state", [*designs("IV").values(), *random_states(3, seed=1)])
    def test_closed_loop_is_that_of_the_library(self, state):
        moved = rate_attitude_explorer(EQUATIONS, **state)
        assert (moved.closed_loop().A == closed_loop(state).A).all()

    def test_a_value_off_the_grid_stays_and_moves_the_slider_beside_it(self):
        moved = rate_attitude_explorer(EQUATIONS, K_A=-3.1416)
        grid = moved.parameters[0].grid
        assert (moved.K_A, grid[moved.K_A_at]) == (-3.1416, -3.14)
        moved.K_A = 1.23
        assert abs(grid[moved.K_A_at] / 1.23 - 1) < 0.04
        moved.K_A = 0.0123
        assert grid[moved.K_A_at] == min(grid, key=lambda place: abs(place - 0.0123))

    def test_sliders_reach_what_the_report_uses(self, explorer):
        grids = {p.name: p.grid for p in explorer.parameters}
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
            rate_attitude_explorer(EQUATIONS, **{name: value})
        assert explorer.values() == before

    def test_unknown_parameter(self):
        with pytest.raises(TypeError, match="unknown 'K_z', wanted K_A, K_C, K_R, gyro, feedback"):
            rate_attitude_explorer(EQUATIONS, K_z=1.0)

    def test_displays_itself_with_its_sliders(self, explorer):
        bundle = explorer._repr_mimebundle_()
        assert bundle["text/plain"] == repr(explorer)
        assert bundle["application/vnd.jupyter.widget-view+json"]["model_id"] == explorer.panel.model_id

    def test_a_still_stands_in_where_no_script_runs(self, explorer):
        assert base64.b64decode(explorer._repr_mimebundle_()["image/png"]).startswith(b"\x89PNG")

    def test_weight(self, explorer):
        """What a view's own data weigh, and what all views of the book share and load once."""
        assert len(gzip.compress(json.dumps(explorer.payload).encode())) < 25_000
        assert len(gzip.compress((explorer._esm + explorer._css).encode())) < 110_000

    @pytest.mark.parametrize("view", [Explorer, Comparison])
    def test_module_neither_evaluates_text_nor_loads_anything(self, view):
        text = view._esm.replace('"http://www.w3.org/2000/svg"', "")  # a name, not an address
        for word in ("eval(", "Function(", "import(", "fetch(", "http", "\nimport "):
            assert word not in text


class TestView:
    def test_table_follows_the_values(self, page):
        for state in [*random_states(5, seed=5), designs("IV")["Figure 8"]]:
            show(page, **state)
            ours, theirs = paired(closed_loop(state).poles(), table(page))
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
        worst = max(closed_loop(FIGURE_11).poles().real)
        words = page.locator(".verdict").inner_text()
        assert words.startswith(f"Unstable because of a real root at +{worst:.4g} 1/s (from short period)")
        assert f"doubles every {math.log(2) / worst:.3g} s" in words
        page.wait_for_function(
            "document.querySelector('[role=status]').textContent.startsWith('Unstable: 2 of 8 roots')"
        )
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
        page.wait_for_timeout(200)  # a map that takes its time
        before = pictures()
        show(page, K_A=0.5, K_R=0.9)
        show(page, magnify=10)
        assert pictures() != before
        show(page, **FIGURE_11, magnify=1)
        page.wait_for_timeout(200)
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
