"""The grid behind a root locus: that of the s-plane, or a discrete loop's in z."""

import control
import numpy as np
import pytest
from matplotlib.figure import Figure

import rlswaim as rl
from rlswaim.figures.loci import draw_root_locus
from rlswaim.figures.pole_grids import draw_z_grid

WINDOW = (-1.3, 1.3, -1.2, 1.2)


def curves(ax):
    """Return the lines of some length on the axes as complex points, without what lies at z = 0."""
    lines = [line.get_xdata() + 1j * np.asarray(line.get_ydata()) for line in ax.lines]
    return [line[np.abs(line) > 1e-9] for line in lines if len(line) > 20]


def test_the_curves_in_z_are_those_of_equal_damping_and_frequency():
    """The logarithm takes each back to a ray or a circle around the origin."""
    ax = Figure().subplots()
    ax.set(xlim=WINDOW[:2], ylim=WINDOW[2:])
    draw_z_grid(ax, zetas=(0.3, 0.6), parts=(0.2, 0.5))
    dampings, frequencies = set(), set()
    for curve in curves(ax):
        s = np.log(curve[(curve != 1) & (np.abs(curve.imag) > 1e-12)])
        damping, frequency = -s.real / np.abs(s), np.abs(s) / np.pi
        if np.ptp(damping) < 1e-9:
            dampings.add(round(damping.mean(), 9) + 0.0)
        else:
            assert np.ptp(frequency) < 1e-9
            frequencies.add(round(frequency.mean(), 9))
    assert dampings == {0.0, 0.3, 0.6}  # 0 is the unit circle
    assert frequencies == {0.2, 0.5}
    assert (*ax.get_xlim(), *ax.get_ylim()) == WINDOW


@pytest.mark.parametrize("dt", [0, True, 0.1])
def test_the_grid_is_that_of_the_loop_s_time(dt):
    locus = rl.root_locus(control.tf([0.1], [1, -1.2, 0.5], dt))
    ax = draw_root_locus(Figure().subplots(), locus, WINDOW)
    circles = [curve for curve in curves(ax) if np.allclose(np.abs(curve), 1)]
    assert len(circles) == (1 if dt else 0)
    assert ("z" in ax.get_xlabel().split()) == bool(dt)
    assert any("zeta" in text.get_text() for text in ax.texts)
