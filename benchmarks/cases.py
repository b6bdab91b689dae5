"""The loops that are timed: the report's, and random ones of order 8, 14 and 20."""

import control
import numpy as np

import rlswaim as rl
from rlswaim.edition.printed_closures import final_design
from rlswaim.loops.closures import closure_3_open_loop
from rlswaim.loops.transfer_functions import theta_loop


def random_loop(order, seed=0):
    """Return a stable random loop with real and complex poles between .3 and 30 rad/s."""
    rng = np.random.default_rng([order, seed])

    def polynomial(n):
        p = np.array([1.0])
        for _ in range(n // 2):
            omega, zeta = 10 ** rng.uniform(-0.5, 1.5), rng.uniform(0.02, 1.0)
            p = np.convolve(p, [1, 2 * zeta * omega, omega**2])
        return p if n % 2 == 0 else np.convolve(p, [1, rng.uniform(0.3, 3)])

    return control.tf(polynomial(order - 3), polynomial(order))


def loops():
    """Return the open loops by name."""
    eqs = rl.printed_equations()
    design, kK_z = final_design()
    return {
        "Section IV, order 8": theta_loop(eqs, K_C=10, K_R=0.618, gyro=60),
        "Section VII, order 9": closure_3_open_loop(eqs, design, kK_z, K_C=1, K_R=0.286),
        **{f"random, order {n}": random_loop(n) for n in (8, 14, 20)},
    }
