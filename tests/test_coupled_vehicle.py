"""The live view of the vehicle without control: its poles and paths are those of the library."""

import math
from dataclasses import replace

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.explorers import coupled_vehicle, coupling_tables
from small_views import BOOSTER, PRINTED, mismatch, opened, random_states, show, view_of


class TestCoupledVehicle:
    def test_coefficients_are_those_of_the_library(self):
        table = coupling_tables.coupled_products(BOOSTER)
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
                     const { x, y } = module.default.poles(payload, s);
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
                     const { start, present, names, runs } = module.default.paths(payload, s, window);
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
        named = {case["name"]: case["values"] for case in coupled_vehicle.cure_presets(BOOSTER)}
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
            assert rows.count() == 7
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
            assert f"its motion doubles every {double:.3g} s" in page.locator(".verdict").inner_text()


def _uncoupled(vehicle: control.StateSpace) -> np.ndarray:
    """Return the poles of the three diagonal blocks and of the attitude."""
    kept = [0, 2, 3, 4, 5, 6]
    A = vehicle.A[np.ix_(kept, kept)]
    block = np.array([0, 0, 1, 1, 2, 2])
    return np.append(np.linalg.eigvals(np.where(block[:, None] == block, A, 0)), 0)
