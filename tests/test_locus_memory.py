"""Memory does not grow with gains times order squared, nor where places all but cancel each other."""

import tracemalloc

import control
import numpy as np
import pytest
from scipy.signal import ZerosPolesGain

import rlswaim as rl

PEAK = 100e6
"""Bytes: what a locus may take at most beside its own roots."""


def peak_of(work):
    """Return what ``work`` returns, and the most memory (bytes) that it took."""
    tracemalloc.start()
    try:
        found = work()
        return found, tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "poles",
    [
        [-1, 1 + 5e-15],
        [-1, 1 + 1e-12],
        [-1, 1 + 1e-9],
        [-1, 1 + 5e-15, -2, 2 + 1e-14, 0, 0],
        [-1 + 3j, -1 - 3j, 1 + 1e-13 + 3j, 1 + 1e-13 - 3j],
    ],
)
def test_poles_that_all_but_mirror_each_other(poles):
    """The phase on the axis is a multiple of pi but for some rounding: no cutting tells where."""
    found, peak = peak_of(lambda: rl.root_locus(ZerosPolesGain([], poles, 1.0)).crossings)
    assert all(c.omega == 0 for c in found)
    assert peak < PEAK


def test_a_zero_that_all_but_cancels_a_pole():
    loop = ZerosPolesGain([-1 - 1e-11, 3.0], [-1.0, -2.0, -3.0], 1.0)
    found, peak = peak_of(lambda: rl.root_locus(loop).crossings)
    wanted = (-5.0, np.sqrt(21)), (2.0, 0.0)  # those of (s - 3)/((s + 2)(s + 3))
    assert [(c.gain, c.omega) for c in found] == [pytest.approx(w, rel=1e-9) for w in wanted]
    assert peak < PEAK


@pytest.mark.parametrize("gains", [None, np.linspace(0.0, 10.0, 1001)], ids=["picture", "given"])
def test_a_long_delay_with_many_gains(gains):
    a = np.exp(-0.001)
    loop = control.tf([3.5 * (1 - a)], [1, -a] + [0] * 100, 0.01)
    found, peak = peak_of(lambda: rl.root_locus(loop, gains))
    assert peak < PEAK + 20 * found.roots.nbytes
