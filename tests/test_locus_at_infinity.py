"""Loops with direct feedthrough: one root passes through infinity at a gain of -1/D."""

import control
import numpy as np
import pytest

import rlswaim as rl

S = control.tf("s")


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("D", [0.5, -0.5])
def test_gains_lie_close_on_either_side_of_the_gain_at_which_a_root_is_lost(D, sign):
    """1 + k G has one root less at k = -1/D: gains chosen on that side hold it between two neighbors."""
    loop = D * (S + 1) * (S + 3) / ((S + 2) * (S + 5))
    locus = rl.root_locus(loop, sign=sign)
    lost = -1 / D
    near = locus.gains[np.abs(locus.gains / lost - 1) < 2e-7]
    largest = np.abs(locus.roots).max()
    if lost * sign > 0:
        assert np.sort(near / lost) == pytest.approx([1 - 1e-7, 1 + 1e-7], abs=1e-12)
        assert largest > 1e6
    else:
        assert near.size == 0
        assert largest < 6
