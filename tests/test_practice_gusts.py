"""Winds against integrals and against direct simulation."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rlswaim.practice import gusts
from rlswaim.practice.greensite import closed_loop
from rlswaim.practice.margins import frequency_response

LOOP = closed_loop(K_p=1.73, K_d=0.69)


def test_one_minus_cosine():
    t = np.linspace(-1, 5, 6001)
    wind = gusts.one_minus_cosine(t, 2.0, 3.0)
    assert wind.max() == pytest.approx(2.0)
    assert t[wind.argmax()] == pytest.approx(1.5)
    assert np.trapezoid(wind, t) == pytest.approx(3.0)
    assert not wind[(t <= 0) | (t >= 3)].any()


def test_shear_with_gust():
    t = np.linspace(0, 60, 60001)
    wind = gusts.shear_with_gust(t, 50.0, 20.0, 9.0, 0.5, 2.0)
    assert wind.max() == pytest.approx(0.85 * 59)
    assert np.interp(19.4, t, wind) < 0.85 * 50
    assert abs(np.diff(wind)).max() < 0.03
    assert wind[-1] == pytest.approx(0.0, abs=1e-9)


def test_dryden_has_the_rms_and_the_spectrum_that_it_says():
    sigma, length, speed = 5.0, 1750.0, 1860.0
    filter_ = gusts.dryden(sigma, length, speed)
    assert gusts.rms(filter_)["wind"] == pytest.approx(sigma)
    omega = np.array([0.1, 1.0, 10.0])
    x = (length * omega / speed) ** 2
    spectrum = sigma**2 * length / speed * (1 + 3 * x) / (1 + x) ** 2
    assert np.allclose(np.abs(filter_(1j * omega)) ** 2, spectrum)


def test_rms_is_the_integral_of_the_spectrum():
    turbulence = gusts.dryden(2.0, 500.0, 937.709)
    found = gusts.rms(LOOP[:5, 0], turbulence)
    omega = np.concatenate([[0.0], np.geomspace(1e-5, 1e4, 40_001)])
    omega = np.unique(np.concatenate([omega, np.linspace(15, 23, 8001)]))
    wind = frequency_response(turbulence, omega)[:, 0, 0]
    size = np.abs(frequency_response(LOOP[2, 0], omega)[:, 0, 0] * wind) ** 2
    assert found["theta"] == pytest.approx(np.sqrt(np.trapezoid(size, omega) / np.pi), rel=1e-4)


def test_rms_refuses_what_has_none():
    with pytest.raises(ValueError, match="wanted a stable system"):
        gusts.rms(control.ss([[0.1]], [[1.0]], [[1.0]], [[0.0]]))
    with pytest.raises(ValueError, match="wanted D = 0"):
        gusts.rms(LOOP)


def test_response_is_that_of_an_integrator():
    t = np.arange(0, 8, 0.002)
    found = gusts.response(LOOP, t, gusts.one_minus_cosine(t, 0.01, 3.0))

    def rate(time, x):
        return LOOP.A @ x + LOOP.B[:, 0] * gusts.one_minus_cosine(np.array(time), 0.01, 3.0)

    exact = solve_ivp(rate, (0, 8), np.zeros(LOOP.nstates), "DOP853", t_eval=t[::500], rtol=1e-10, atol=1e-14)
    states = LOOP.C @ exact.y
    for name in ("theta", "z", "delta", "eta"):
        assert np.allclose(found[name][::500], states[LOOP.output_labels.index(name)], rtol=1e-4, atol=1e-8)


def test_worst_gust_is_worse_than_others_and_is_what_a_simulation_says():
    found = gusts.worst_gust(LOOP, "delta", 0.01)
    t = np.arange(0, 60, 0.002)

    def peak(duration):
        return np.abs(gusts.response(LOOP, t, gusts.one_minus_cosine(t, 0.01, duration))["delta"]).max()

    assert found.peak == pytest.approx(peak(found.duration), rel=1e-3)
    for duration in (0.5, 1, 2, 4, 8, 16):
        assert peak(duration) <= found.peak * (1 + 1e-4)


def test_worst_gust_refuses_an_unknown_output():
    with pytest.raises(ValueError, match="output in worst_gust: got 'beta'"):
        gusts.worst_gust(LOOP, "beta", 1.0)
