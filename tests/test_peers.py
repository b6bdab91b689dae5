"""Systems from the root-locus tests and bug reports of python-control and ControlSystems.jl.

Each is written anew from its numbers; the right answers are 50-digit roots.
"""

import control
import numpy as np
import pytest

import rlswaim as rl
from exact import closed_loop, exact_roots, relative_errors
from rlswaim.rootlocus.open_loop import open_loop

PENDULUM = control.ss(
    [[0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1], [0, 0, 5, 0]], [[0], [1], [0], [-2]], [[1, 0, 0, 0]], 0
)


def poles_and_zeros(zeros, poles, gain=1.0):
    return control.tf(gain * np.poly(zeros).real, np.poly(poles).real)


SYSTEMS = {
    "python-control#306": control.tf([1], [1, 2, 2, 0]),
    "python-control#350": control.tf([1], np.convolve([1, 2, 5], [1, 6, 13])),
    "python-control#715": PENDULUM,
    "python-control#1063": control.tf([1], [1, 2, 1]),
    "python-control-test-TF": control.tf([1, 2], [1, 2, 3]),
    "python-control-test-SS": control.ss([[1.0, 4.0], [3.0, 2.0]], [[1.0], [-4.0]], [[1.0, 0.0]], 0),
    "python-control-test-equal-order": control.tf([-1, 2], [1, 2]),
    "python-control-test-two-zeros": control.tf([1, 0, -1], [1, 1, 1]),
    "python-control-test-zoom": control.tf([1000], [1, 25, 100, 0]),
    "python-control-test-default-wn": poles_and_zeros([-1e-2, 1 - 1e7j, 1 + 1e7j], [0, -1e7j, 1e7j]),
    "python-control-test-12.19a": control.tf([1, 1], [1, 0, 0]),
    "python-control-test-12.19b": control.tf([1, 1], np.convolve([1, 2, 0], [1, 2, 4])),
    "python-control-test-12.19c": control.tf([1, 1], [1, 0, 1, 0]),
    "python-control-test-12.19d": control.tf([1, 2, 2], [1, 0, 1, 0]),
    "ControlSystems.jl#156": control.ss([[4.38, 209], [-0.036, -2]], [[2.09], [0]], [[1, 0]], 0),
    "ControlSystems.jl#231": control.tf([1, 9], [1, 4, 11, 0]),
    "ControlSystems.jl#740": poles_and_zeros(
        [-1 - 1.732050807568877j, -1 + 1.732050807568877j],
        [0.0, -4.0, -6.0, -0.7 - 0.7141428428542851j, -0.7 + 0.7141428428542851j],
    ),
    "ControlSystems.jl#759": control.tf([6, 204], [1, 10, 34, 0]),
    "ControlSystems.jl-test": control.tf([0.2, 2], [1, 1, 1]),
}


@pytest.mark.parametrize("system", SYSTEMS.values(), ids=SYSTEMS)
def test_roots_are_right(system):
    """At given gains of both signs, and at every gain of its own picture."""
    loop, own = open_loop(system), rl.root_locus(system)
    given = rl.root_locus(
        system, np.setdiff1d([-7.0, -0.3, 0.0, 0.3, 0.9, 7.0, 300.0], [-1 / (loop.D or np.inf)])
    )
    for locus, step in ((given, 1), (own, max(1, own.gains.size // 8))):
        for gain, roots, condition in zip(
            locus.gains[::step], locus.roots[::step], locus.condition[::step], strict=True
        ):
            wanted = exact_roots(closed_loop(loop.numerator, loop.denominator, gain))
            well = condition < 1e5
            assert relative_errors(roots, wanted)[well].max(initial=0) < 1e-10, f"gain {gain:g}"


@pytest.mark.parametrize(
    ("name", "gain", "omega"),
    [
        ("python-control#306", 4.0, np.sqrt(2)),
        ("python-control-test-zoom", 2.5, 10.0),
    ],
)
def test_crossings_of_the_axis_by_hand(name, gain, omega):
    """Routh's array gives these by hand; #306 reported .7 in place of 4."""
    crossing = next(c for c in rl.root_locus(SYSTEMS[name]).crossings if c.gain > 0 and c.omega > 0)
    assert (crossing.gain, crossing.omega) == pytest.approx((gain, omega), rel=1e-12)
    assert crossing.direction == 1


def test_a_double_pole_at_the_origin_leaves_at_right_angles():
    """#715: no branch lies on the real axis just left of the double pole (there a gain would be negative)."""
    locus = rl.root_locus(PENDULUM)
    near = locus.roots[(np.abs(locus.roots) < 0.1) & (locus.roots != 0)]
    assert near.size > 10
    assert (near[near.imag == 0].real >= 0).all()


def test_the_branch_that_759_missed():
    """One branch of (6 s + 204)/(s^3 + 10 s^2 + 34 s) ends at the zero -34."""
    locus = rl.root_locus(SYSTEMS["ControlSystems.jl#759"])
    assert np.abs(locus.roots[-1] + 34).min() < 0.05


def test_231_has_no_break_in_on_the_positive_locus():
    """(s + 9)/(s (s^2 + 4 s + 11)) has no real double point between zero and pole."""
    marks = rl.root_locus(SYSTEMS["ControlSystems.jl#231"]).break_aways
    assert len(marks) == 1
    for mark in marks:
        between = -9 < mark.point.real < 0 and mark.point.imag == 0
        assert not (between and mark.gain > 0)


def test_improper_systems_are_refused():
    """ControlSystems.jl#611: (s + 1)(s + 5)/(s + 2) was a dimension mismatch there."""
    with pytest.raises(
        ValueError, match="got a numerator of order 2 over one of order 1, wanted a proper system"
    ):
        rl.root_locus(control.tf([1, 6, 5], [1, 2]))


def test_one_gain_is_enough():
    """python-control#1063: a map with one point."""
    locus = rl.root_locus(SYSTEMS["python-control#1063"], 3.0)
    assert locus.roots.shape == (1, 2)
    assert relative_errors(locus.roots[0], np.array([-1 + 1j * 3**0.5, -1 - 1j * 3**0.5])).max() < 1e-14


def test_the_scale_of_the_loop_does_not_move_the_locus():
    """python-control#612: L G for any positive L has the locus of G, at gains divided by L."""
    system = SYSTEMS["ControlSystems.jl#740"]
    for scale in (1e-6, 1e6):
        scaled = rl.root_locus(system * scale, np.array([0.5, 5.0]) / scale)
        for found, wanted in zip(scaled.roots, rl.root_locus(system, [0.5, 5.0]).roots, strict=True):
            assert relative_errors(found, wanted).max() < 1e-11
