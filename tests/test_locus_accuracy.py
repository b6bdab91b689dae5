"""Root loci against 50-digit roots, and their pictures against the exact curve."""

import control
import numpy as np
import pytest
from scipy.linalg import block_diag

import rlswaim as rl
from exact import closed_loop, exact_roots, off_the_polyline, relative_errors
from rlswaim.rootlocus.adaptive_gains import default_axes
from rlswaim.rootlocus.branches import continuous_branches
from rlswaim.rootlocus.open_loop import open_loop


def report_loop(which):
    """Return the report's open loops: Section IV's attitude loop and Section VII's jet loop."""
    eqs = rl.printed_equations()
    if which == "IV":
        A, B, C = split(lambda k: rl.rate_attitude(eqs, K_A=k, K_C=10, K_R=0.618, gyro=60))
    else:
        A, B, C = split(
            lambda k: rl.dual_actuation(
                eqs, K_A=0, K_C=1, K_R=0.286, kK_z=-1e8 * k, K_r=10, b=3, sensor=39, jet=140
            )
        )
    return control.ss(A, B, C, 0)


def split(system):
    """Return A, B, C with A(k) = A - k B C from a closed loop that is affine in k."""
    A, rank_one = system(0.0).A, system(0.0).A - system(1.0).A
    row = rank_one[np.abs(rank_one).sum(axis=1).argmax()]
    return A, rank_one @ row[:, None] / (row @ row), row[None, :]


def random_system(order, seed):
    rng = np.random.default_rng([order, seed])
    A = rng.standard_normal((order, order)) * 10 ** rng.uniform(-2, 2)
    return control.ss(A, rng.standard_normal((order, 1)), rng.standard_normal((1, order)), 0)


@pytest.mark.parametrize(
    ("order", "seed"), [(n, s) for n in (2, 3, 5, 8) for s in range(4)] + [(11, 0), (14, 0), (14, 1)]
)
def test_random_systems_to_1e_10(order, seed):
    check_to_1e_10(random_system(order, seed))


@pytest.mark.parametrize("which", ["IV", "VII"])
def test_the_reports_systems_to_1e_10(which):
    check_to_1e_10(report_loop(which))


def check_to_1e_10(system):
    """Every well-conditioned root of the loop is right to 1e-10, relative to its own size."""
    loop = open_loop(system)
    scale = np.abs(loop.denominator).max() / np.abs(loop.numerator).max()
    gains = np.concatenate([[0.0], scale * np.logspace(-4, 4, 4), -scale * np.logspace(-4, 4, 3)])
    found = rl.root_locus(system, gains)
    checked = 0
    for gain, roots, condition in zip(gains, found.roots, found.condition, strict=True):
        wanted = exact_roots(closed_loop(loop.numerator, loop.denominator, gain))
        well = condition < 1e5
        assert relative_errors(roots, wanted)[well].max(initial=0) < 1e-10, f"gain {gain:g}"
        checked += well.sum()
    assert checked > 0.5 * found.roots.size


@pytest.mark.parametrize("which", ["IV", "VII"])
def test_the_condition_bounds_the_error(which):
    """The error of each root is at most some 1e-14 times its condition: the estimate can be trusted."""
    system = report_loop(which)
    loop, gains = open_loop(system), np.logspace(-3, 3, 9)
    found = rl.root_locus(system, gains)
    for gain, roots, condition in zip(gains, found.roots, found.condition, strict=True):
        wanted = exact_roots(closed_loop(loop.numerator, loop.denominator, gain))
        moving = roots != 0
        assert moving.sum() >= roots.size - 1
        assert (relative_errors(roots, wanted)[moving] <= 2e-14 * condition[moving]).all()


@pytest.mark.parametrize("count", [500, 2000])
def test_many_gains_equal_few(count):
    """The fast way through many gains ends at the same roots as one gain at a time."""
    system = report_loop("IV")
    gains = np.logspace(-3, 3, count)
    many = rl.root_locus(system, gains)
    for i in range(0, count, count // 20):
        one = rl.root_locus(system, [gains[i]])
        assert relative_errors(many.roots[i], one.roots[0]).max() < 1e-10 * one.condition.max()


def test_the_systems_of_section_vii_keep_both_ends():
    """Roots of 1e-4 and of 100 live in one system; both ends are right."""
    eqs = rl.printed_equations()
    system = control.ss(
        *split(
            lambda k: rl.dual_actuation(
                eqs, K_A=k, K_C=1, K_R=0.286, kK_z=-17.8e8, K_r=10, b=3, sensor=39, jet=140
            )
        ),
        0,
    )
    loop, found = open_loop(system), rl.root_locus(system, [0.002])
    assert np.abs(found.roots).max() > 90
    assert np.abs(found.roots).min() < 1e-3
    wanted = exact_roots(closed_loop(loop.numerator, loop.denominator, 0.002))
    assert relative_errors(found.roots[0], wanted).max() < 1e-10


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    "system",
    [
        pytest.param(report_loop("IV"), id="section-IV"),
        pytest.param(report_loop("VII"), id="section-VII"),
        *(pytest.param(random_system(order, 1), id=f"random-{order}") for order in (3, 8, 14)),
        pytest.param(control.tf([1], [1, 4, 6, 4, 1]), id="four-poles-in-one"),
        pytest.param(control.tf([1, 1], [1, 0, 0]), id="two-integrators"),
    ],
)
def test_the_picture_is_true_to_a_quarter_pixel(system, sign):
    loop, locus = open_loop(system), rl.root_locus(system, sign=sign)
    axes = default_axes(loop)
    gains = locus.gains[locus.gains != 0]
    dense = sign * np.geomspace(np.abs(gains).min(), np.abs(gains).max(), 1000)
    assert off_the_polyline(rl.root_locus(system, dense).roots.ravel(), locus.roots, axes) < 0.25


def test_the_picture_follows_the_visible_axes():
    """The tolerance holds for a close look at the origin, where the whole picture shows one point."""
    system = report_loop("IV")
    near = (-0.01, 0.01, -0.01, 0.01)
    locus = rl.root_locus(system, sign=-1, axes=near)
    dense = -np.geomspace(1e-3, 10, 1000)
    exact = rl.root_locus(system, dense).roots.ravel()
    assert off_the_polyline(exact, locus.roots, near) < 0.25


@pytest.mark.parametrize("sign", [1, -1])
def test_marks_are_members_of_the_gains(sign):
    locus = rl.root_locus(report_loop("IV"), sign=sign)
    marks = [mark for mark in (*locus.break_aways, *locus.crossings) if sign * mark.gain > 0]
    assert len(marks) == {1: 4, -1: 9}[sign]
    for mark in marks:
        assert mark.gain in locus.gains


def test_crossings_lie_on_the_axis():
    system = report_loop("IV")
    locus = rl.root_locus(system)
    assert len(locus.crossings) >= 3
    for crossing in locus.crossings:
        before, at, after = (
            rl.root_locus(system, [crossing.gain * (1 + d * np.sign(crossing.gain))]).roots[0]
            for d in (-1e-4, 0, 1e-4)
        )
        place = 1j * crossing.omega
        nearest = [roots[np.abs(roots - place).argmin()] for roots in (before, at, after)]
        assert abs(nearest[1] - place) < 1e-9
        assert np.sign(nearest[2].real - nearest[0].real) == crossing.direction


def test_break_aways_are_double_roots():
    system = report_loop("IV")
    marks = rl.root_locus(system).break_aways
    assert len(marks) == 9
    for mark in marks:
        roots = rl.root_locus(system, [mark.gain]).roots[0]
        near = np.sort(np.abs(roots - mark.point))[:2]
        assert near.max() < 1e-5 * max(1, abs(mark.point))


def test_pairs_are_exact_conjugates():
    found = rl.root_locus(report_loop("VII")).roots
    assert len(found) > 20
    assert found.shape[1] == 9
    for roots in found:
        for root in roots:
            assert root.conj() in roots


def test_a_root_at_the_origin_stays():
    """Section VII's inner loop leaves theta alone: its root at the origin does not move."""
    locus = rl.root_locus(report_loop("VII"))
    assert (locus.roots == 0).any(axis=1).all()


def test_branches_have_the_names_of_the_modes_they_leave():
    locus = rl.root_locus(report_loop("IV"))
    assert sorted(set(locus.labels)) == [
        "mode at 1.15 rad/s",
        "mode at 3.05 rad/s",
        "pole at -1.54 1/s",
        "pole at -10 1/s",
        "pole at 1.31 1/s",
        "pole at the origin",
    ]
    backward = rl.root_locus(report_loop("IV"), locus.gains[::-1])
    assert sorted(backward.labels) == sorted(locus.labels)


def crossing_modes(p):
    """Two modes that do not know of each other; one overtakes the other as p runs from 0 to 1."""
    pairs = (-0.1 - 0.2 * p, 1.9 + 0.35 * p), (-0.3 + 0.2 * p, 2.0)
    blocks = [np.array([[real, omega], [-omega, real]]) for real, omega in pairs]
    return control.ss(block_diag(*blocks), np.ones((4, 1)), np.ones((1, 4)), 0)


def test_eigenvectors_tell_apart_modes_that_nearly_cross():
    """One coarse step, in which distance alone would exchange the modes."""
    locus = rl.parameter_locus(crossing_modes, [0.0, 1.0])
    ends = dict(zip(locus.roots[0].round(9), locus.roots[1].round(9), strict=True))
    assert ends[-0.1 + 1.9j] == -0.3 + 2.25j
    nearest = continuous_branches(locus.roots)
    assert dict(zip(nearest[0].round(9), nearest[1].round(9), strict=True))[-0.1 + 1.9j] == -0.1 + 2j


def test_a_general_parameter_has_conditions_too():
    locus = rl.parameter_locus(crossing_modes, [0.0, 0.5, 1.0])
    assert locus.condition.shape == locus.roots.shape
    assert (locus.condition >= 0.9).all()
