"""The loop that one gain closes, cut open: closed again it is the same, and it is the library's own."""

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.explorers.system_views import VIEWS
from rlswaim.loops.cut_loop import cut_loop
from rlswaim.loops.transfer_functions import theta_loop
from standin import paired

EQS = rl.printed_equations()
GAINS = {
    "IV": {"K_A": 1.8, "K_C": 10.0, "K_R": 0.618, "gyro": 60},
    "V": {"K_A": 0.4, "K_C": 10.0, "K_R": 0.625, "K_z": 0.054, "sensor": 140},
    "VI": {
        **{"K_A": 0.4, "K_C": 10.0, "K_R": 0.625, "K_za": -0.144, "K_zb": 0.1},
        **{"sensor_a": 300, "sensor_b": 140},
    },
    "VII": {
        **{"K_A": 0.4, "K_C": 1.0, "K_R": 0.286, "kK_z": -1.78e9, "K_r": 10.0, "b": 3.0},
        **{"sensor": 39, "jet": 140},
    },
}
CASES = [
    (section, name) for section, gains in GAINS.items() for name in gains if name in "K_A K_z K_za K_zb kK_z"
]


@pytest.mark.parametrize(("section", "name"), CASES)
def test_closed_again_it_has_the_same_poles(section, name):
    def closed(k: float) -> control.StateSpace:
        return VIEWS[section].closed_loop(EQS, **{**GAINS[section], name: k})

    loop = cut_loop(closed, GAINS[section][name])
    ours, theirs = paired(control.feedback(loop).poles(), closed(GAINS[section][name]).poles())
    assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-11)


def test_it_is_the_open_loop_of_section_iv():
    loop = cut_loop(lambda k: rl.rate_attitude(EQS, K_A=k, K_C=10, K_R=0.618, gyro=60), 1.8)
    own = theta_loop(EQS, K_C=10, K_R=0.618, gyro=60)
    for omega in np.geomspace(0.05, 50, 25):
        assert complex(loop(1j * omega)) == pytest.approx(1.8 * complex(own(1j * omega)), rel=1e-8)


def test_a_gain_at_two_places_is_refused():
    with pytest.raises(
        ValueError, match=r"^gain in cut_loop: got one that multiplies 2 signals, wanted one$"
    ):
        cut_loop(lambda k: control.ss(np.diag([-k, -2 * k]), [[1], [1]], [[1, 1]], 0), 3.0)


def test_no_gain_feeds_nothing_back():
    loop = cut_loop(lambda k: rl.rate_attitude(EQS, K_A=k, K_C=10, K_R=0.618, gyro=60), 0.0)
    assert complex(loop(1j)) == 0
