"""Winds on a design: turbulence against the integral of its spectrum, shear against one more integrator."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rlswaim.practice import weather
from rlswaim.practice.criteria import DEG, with_motion
from rlswaim.practice.designs import BASE, NOSE, flown, moved
from rlswaim.practice.dispersed import consistent_booster
from rlswaim.practice.gusts import dryden, shear_with_gust
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.practice.margins import frequency_response
from rlswaim.practice.optimal import Wishes, lqg
from rlswaim.source.tables import constants

BOOSTER = consistent_booster()
READ = (*gyros(60.0), Instrument("accelerometer", NOSE))
DESIGN = flown("LQG", lqg(BOOSTER, READ, Wishes(BASE, recovery=1.0), NOSE), READ, NOSE)
SYSTEM = with_motion(moved(DESIGN, BOOSTER), BOOSTER.flight.U)
WIND = constants("winds")
U = BOOSTER.flight.U


def test_turbulence_is_the_integral_of_its_spectrum():
    found = weather.in_turbulence(DESIGN, BOOSTER)
    omega = np.unique(np.concatenate([np.geomspace(1e-6, 1e3, 20_001), np.linspace(0, 8, 8001)]))
    filter_ = frequency_response(dryden(WIND["sigma"] / U, WIND["length"], U), omega)[:, 0, 0]
    for name, unit in (("delta", DEG), ("delta_r", 1.0)):
        row = SYSTEM.output_labels.index(name)
        size = np.abs(frequency_response(SYSTEM, omega)[:, row, 0] * filter_) ** 2
        assert found[name] == pytest.approx(np.sqrt(np.trapezoid(size, omega) / np.pi) * unit, rel=1e-3)


def test_shear_is_what_another_integrator_makes_of_it():
    found = weather.in_shear(DESIGN, BOOSTER, horizon=30.0)

    def wind(t):
        return shear_with_gust(np.asarray(t), **{name: WIND[name] for name in weather.SHEAR}) / U

    t = np.arange(0, 30, 0.02)
    exact = solve_ivp(
        lambda s, x: SYSTEM.A @ x + SYSTEM.B[:, 0] * wind(s), (0, 30), np.zeros(SYSTEM.nstates),
        "BDF", t_eval=t, rtol=1e-6, atol=1e-10, max_step=0.25, jac=SYSTEM.A,
    )  # fmt: skip
    outputs = SYSTEM.C @ exact.y + SYSTEM.D * wind(t)
    for name in ("theta", "delta", "drift"):
        peak = np.abs(outputs[SYSTEM.output_labels.index(name)]).max() * weather.SHOWN[name]
        assert found[name] == pytest.approx(peak, rel=2e-3)
