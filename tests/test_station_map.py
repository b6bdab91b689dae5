"""The live view of all pairs of stations: its map is that of the library."""

import math

import numpy as np
import pytest

import rlswaim as rl
from rlswaim import explorers
from rlswaim.explorers import station_map
from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial
from small_views import MAKERS, MODEL, PRINTED, opened, random_states, show, view_of


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
        gains = [{n: d[n] for n in self.GAINS} for d in station_map.map_designs().values()]
        gains += [{n: s[n] for n in self.GAINS} for s in random_states(view, 2, seed=5)]
        with opened(browser, view) as page:
            found = page.evaluate(
                """async ([payload, gains]) => {
                     const map = await import('/js/maths/abscissa.js');
                     return gains.map(g => [...map.rows(map.planOf(payload, g), [28, 7])]
                       .filter(r => r.values).map(({ step, jet, values }) => [step, jet, [...values]]));
                   }""",
                [view.payload, gains],
            )
        for at, rows in zip(gains, found, strict=True):
            loops = DUAL_ACTUATION.around(PRINTED)
            cells = [(jet, n * step, v) for step, jet, values in rows for n, v in enumerate(values)]
            picked = [cells[k] for k in rng.integers(len(cells), size=400)]
            jets, sensors, values = (np.array(c) for c in zip(*picked, strict=True))
            ours = loops.abscissas(**at, sensor=sensors, jet=jets)
            size = abs(np.linalg.eigvals(loops.matrices(**at, sensor=sensors, jet=jets))).max(axis=1)
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
            design = station_map.map_designs()["The pair that works"] | {"sensor": 91, "jet": 302}
            ours = rl.dual_actuation(PRINTED, **design).poles().real.max()
            shows = "ours => Math.abs(+document.querySelector('.verdict').dataset.value - ours) < 1e-8"
            page.wait_for_function(shows, arg=ours)

    def test_the_pair_is_dragged_over_whole_feet(self, browser):
        view = view_of("station-map")
        with opened(browser, view) as page:
            canvas = page.locator("canvas[data-plane=stations]")
            canvas.scroll_into_view_if_needed()
            box = canvas.bounding_box()
            foot = (box["width"] - 62) / 421

            def place(sensor: float, jet: float) -> tuple[float, float]:
                x = box["x"] + 50 + foot * (sensor + 0.5)
                return x, box["y"] + box["height"] - 36 - (box["height"] - 46) * (jet + 0.5) / 421

            start = page.evaluate("[state.sensor, state.jet]")
            page.mouse.move(*place(*start))
            page.mouse.down()
            for share in (0.3, 0.7, 1.0):
                page.mouse.move(
                    *place(*(a + share * (b - a) for a, b in zip(start, (200.2, 250.3), strict=True)))
                )
            page.mouse.up()
            page.wait_for_function("state.sensor === 200 && state.jet === 250")
            page.wait_for_timeout(500)
            page.get_by_role("button", name="undo").click()
            assert page.evaluate("[state.sensor, state.jet]") == start, "a drag is one step"

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
            rows.first.wait_for()  # a worker computes them
            assert rows.count() == 24
            design = station_map.map_designs()["The pair that works"] | {"sensor": 140, "jet": 56}
            ours = rl.dual_actuation(PRINTED, **design).poles().real.max()
            assert float(rows.nth(1).get_attribute("data-value")) == pytest.approx(ours, abs=1e-9)

    def test_stands_beside_another_view_of_the_same_gains(self):
        first = MAKERS["station-map"]()
        second = explorers.station_map_explorer(PRINTED, beside=first)
        assert len(second.panel.children) == 1
        sliders, shown = first.panel.children
        assert (len(sliders.children), shown) == (len(first.parameters), first)
