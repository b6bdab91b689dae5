"""Loops for the view of one's own loop: corners that users visit, and fresh members of each kind."""

import control
import numpy as np
from scipy.signal import ZerosPolesGain

from rlswaim.explorers.gallery import gallery


def diagonal(values) -> control.StateSpace:
    n = len(values)
    return control.ss(np.diag(np.array(values, float)), np.ones((n, 1)), np.ones((1, n)), 0)


def random_states(seed: int, n: int) -> control.StateSpace:
    rng = np.random.default_rng(seed)
    return control.ss(rng.normal(size=(n, n)), rng.normal(size=(n, 1)), rng.normal(size=(1, n)), 0)


NEAR = [1e-8 + 5j, 1e-8 - 5j]
CORNERS = {
    "twelve states": diagonal(range(-12, 0)),
    "twenty states": diagonal(range(-20, 0)),
    "thirty states": diagonal(range(-30, 0)),
    "fifteen states, fresh": diagonal(-np.linspace(0.5, 9.3, 15)),
    "common factor": control.tf([1, 0], [1, 3, 2, 0]),
    "common factors, fresh": ([-1.5, -2 + 1j, -2 - 1j], [-1.5, -2 + 1j, -2 - 1j, -4.0, 0.0], 3.0),
    "twenty poles": ([], [-float(i) for i in range(1, 21)], 1.0),
    "sixteen poles, fresh": ([-0.3], [-1.1 * i for i in range(1, 17)], 2.5),
    "poles on the axis": control.tf([1, 1], np.convolve(np.convolve([1, 0, 0.49], [1, 0, 9.61]), [1, 2])),
    "poles on the axis, factors": ([-1], [0.7j, -0.7j, 3.1j, -3.1j, -2], 1.0),
    "near cancellation": (NEAR, [5j, -5j, -1.0, -2.0, -3.0], 1.0),
    "triple pole": control.tf([1], [1, 3, 3, 1]),
    "triple pole, factors": ([], [-1.0, -1.0, -1.0], 1.0),
    "triple pole, states": control.ss([[-1, 1, 0], [0, -1, 1], [0, 0, -1]], [[0], [0], [1]], [[1, 0, 0]], 0),
    "six at z = 1": control.tf([1], np.poly([1.0] * 6), 0.1),
    "discrete": control.tf([1], [1, -1.5, 0.5], True),
    "discrete, factors": ZerosPolesGain([0.3], [0.9, 0.7 + 0.2j, 0.7 - 0.2j], 0.4, dt=0.1),
    "discrete, states": control.ss([[0.9, 0.1], [-0.2, 0.8]], [[0], [1]], [[1, 0]], 0, 0.05),
    "delay of 20 samples": control.tf([1], [1, -0.9, *[0] * 20], 0.1),
    "biproper": control.tf([1, 6, 5], [1, 3, 2.7]),
    "biproper states": control.ss([[-1, 2], [0, -3]], [[1], [1]], [[1, 0.5]], 0.7),
    **{f"random states {n}": random_states(n, n) for n in (3, 5, 8, 12)},
}
LOOPS = {**CORNERS, **{case.name: case.system for case in gallery()}}
