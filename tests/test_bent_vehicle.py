"""The live view of the bent vehicle: its forces are those of the equations of motion."""

import math

import pytest

import rlswaim as rl
from rlswaim.explorers import bent_vehicle
from small_views import BOOSTER, MAKERS, opened, random_states, view_of

COEFFICIENTS = rl.perturbation_equations(BOOSTER).coefficients


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
                     [module.default.loads(payload, s).sum, module.default.height(payload, s, 60)])""",
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
