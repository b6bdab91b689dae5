"""How far rounding moves the points of an open loop, and how roots of neighboring gains are paired."""

import control
import numpy as np
import pytest

from rlswaim.rootlocus.branches import assigned, squared_distances
from rlswaim.rootlocus.open_loop import open_loop


@pytest.mark.parametrize("points", [(1.0, -2.0), (-0.5, -3.0, -40.0), (-1 + 2j, -1 - 2j, -6.0)])
def test_simple_points_are_known_to_half_a_unit_of_every_coefficient(points):
    """2^-53 sum |p_i s^i| / |p'(s)|, here with p'(s) as the product of the distances to the others."""
    p = np.poly(points)
    loop = open_loop(control.tf(p, np.polymul(p, [1.0, 7.0])))
    for found in (loop.zero_points, loop.pole_points):
        assert len(found.values) >= len(points)
        for s, error in zip(found.values, found.errors, strict=True):
            others = [q for q in found.values if q != s]
            terms = np.polyval(np.abs(np.poly(found.values)), np.abs(s))
            assert error == pytest.approx(2.0**-53 * terms / np.abs(np.prod(s - np.array(others))), rel=1e-6)


@pytest.mark.parametrize("turns", [None, np.zeros((1, 2, 2)), np.ones((1, 2, 2))], ids=["none", "0", "1"])
def test_where_all_eigenvectors_turn_alike_the_distance_decides(turns):
    """Both roots are nearest to 0.9; the least total distance gives it to 0, and 1.2 to 1."""
    before, after = np.array([[0.0, 1.0]], complex), np.array([[1.2, 0.9]], complex)
    assert assigned(squared_distances(before, after), turns).tolist() == [[1, 0]]
