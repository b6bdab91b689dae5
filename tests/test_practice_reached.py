"""What regulators reach, against python-control's own norm and against the limits."""

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.practice import measurements as m
from rlswaim.practice import reached
from rlswaim.practice.limits import limits

HEAVY = rl.printed_equations(gravity=True)
PLANTS = {
    "gyro at 60": m.attitude(HEAVY, 60.0),
    "gyro at 420": m.attitude(HEAVY, 420.0),
    "V": m.measured(HEAVY, [m.angle(HEAVY, {}), m.displacement(HEAVY, 140.0)], ["delta"]),
}


@pytest.fixture(scope="module", params=PLANTS)
def pair(request):
    plant = PLANTS[request.param]
    return request.param, plant, reached.least_peak_reached(plant, (1e-6, 1e-2, 1.0, 100.0))


def test_peak_is_the_norm_of_the_sensitivity(pair):
    _, plant, found = pair
    S = control.feedback(control.ss([], np.zeros((0, 1)), np.zeros((1, 0)), [[1.0]]), found.loop)
    assert S.poles().real.max() < 0
    assert found.peak == pytest.approx(control.system_norm(S, "inf", tol=1e-8), rel=1e-3)
    omega = np.geomspace(0.01, 100, 50)
    assert np.allclose(reached.sensitivity(found.loop, omega), np.abs(S(1j * omega)))
    assert found.peak >= limits(plant).peak * (1 - 1e-6)


def test_which_are_reached_by_stable_controllers(pair):
    name, plant, found = pair
    controller = reached.regulator(plant, found.effort, found.noise)
    assert found.stable_controller == (controller.poles().real.max() < 0) == (name == "V")
    assert control.feedback(plant, controller).poles().real.max() < 0


def test_refused():
    with pytest.raises(ValueError, match="effort in regulator: got 0, wanted a number above 0"):
        reached.regulator(PLANTS["V"], 0.0, 1.0)
