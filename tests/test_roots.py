"""Roots of polynomials and of loops that are hard to follow, against 60 digits."""

import control
import numpy as np
import pytest

import rlswaim as rl
from exact import exact_roots, off_the_polyline, relative_errors
from rlswaim.rootlocus import polynomials
from rlswaim.rootlocus.adaptive_gains import default_axes
from rlswaim.rootlocus.branches import continuous_branches
from rlswaim.rootlocus.open_loop import open_loop
from systems import mismatch
from test_locus_accuracy import random_system, report_loop

SYSTEMS = {
    "section IV": report_loop("IV"),
    "section IV, polynomials": control.ss2tf(report_loop("IV")),
    "section VII": report_loop("VII"),
    **{f"random {order}": random_system(order, 1) for order in (3, 8, 14, 20)},
    "two integrators": control.tf([1, 1], [1, 0, 0]),
    "equal orders": control.tf([2, 3, 4], [1, 0.5, 9]),
    "cancellation": control.tf([1, 3, 2], [1, 6, 11, 6]),
}


@pytest.fixture(params=SYSTEMS)
def system(request):
    return SYSTEMS[request.param]


@pytest.mark.parametrize("sign", [1, -1])
def test_given_gains_and_chosen_gains_have_the_same_roots(system, sign):
    """Gains followed from anchors, or one by one, give what the picture's gains give; few gains suffice."""
    locus = rl.root_locus(system, sign=sign)
    again = rl.root_locus(system, locus.gains)
    for found, wanted, condition in zip(again.roots, locus.roots, again.condition, strict=True):
        assert relative_errors(found, wanted)[condition < 1e5].max(initial=0) < 1e-10
    dense = sign * np.geomspace(*np.abs(locus.gains[locus.gains != 0])[[0, -1]], 300)
    exact = rl.root_locus(system, dense)
    assert off_the_polyline(exact.roots.ravel(), locus.roots, default_axes(open_loop(system))) < 0.25
    assert sorted(exact.labels) == sorted(locus.labels)


def test_marks_of_a_break_away_end_on_one_branch_each():
    """A gain of a double root in the middle of others leaves each column where it was."""
    system = SYSTEMS["section IV, polynomials"]
    mark = next(b.gain for b in rl.root_locus(system).break_aways if b.gain > 1)
    locus = rl.root_locus(system, mark * np.linspace(0.99, 1.01, 201))
    assert np.abs(np.diff(locus.roots, axis=0)).max() < 0.1


def test_the_matrix_knows_what_the_polynomial_hardly_does():
    """Wilkinson's polynomial of order 20: the locus of the diagonal matrix is right to the last digits."""
    A, B, C = -np.diag(np.arange(1.0, 21)), np.ones((20, 1)), np.full((1, 20), 1e-3)
    locus = rl.root_locus((A, B, C), np.geomspace(0.1, 10, 20))
    for gain, found in zip(locus.gains, locus.roots, strict=True):
        assert relative_errors(found, np.linalg.eigvalsh(A - gain * B @ C)).max() < 1e-13
    assert (locus.condition > 1e8).mean() > 0.25


@pytest.mark.parametrize("p", [np.poly([-1, -1, -2, 5, 1e-6]), np.poly([1e5, 1, -1e-4])])
def test_polynomials_have_the_roots_of_sixty_digits(p):
    assert mismatch(polynomials.roots(p[::-1]), exact_roots(p[::-1])) < 1e-7


def test_a_repeated_root_is_found_as_one():
    """(s + 1)^4 moves as the fourth root of rounding in its polynomial; the open loop has it exactly."""
    p = np.poly([-1.0] * 4)
    assert mismatch(polynomials.roots(p[::-1]), [-1.0] * 4) < 1e-3
    assert np.array_equal(rl.root_locus(control.tf([1], p), [0.0]).poles, [-1.0] * 4)


def test_roots_of_a_polynomial_of_order_38():
    """Break-away points of a random system of order 20, all of size .05 or so, against 60 digits."""
    loop = open_loop(SYSTEMS["random 20"])
    p = np.convolve(loop.numerator, polynomials.derivative(loop.denominator))
    p -= np.convolve(loop.denominator, polynomials.derivative(loop.numerator))
    wanted = exact_roots(p)
    assert relative_errors(polynomials.roots(p), wanted).max() < 1e-12


def test_four_integrators_and_a_pair_beside_its_zeros():
    """Gains up to 5e15, four roots that leave the origin (found by fuzzing): each satisfies D + k N."""
    system = control.tf([1, 1, 9.01, 9.01, 0.09, 0.09], [1, 0, 0.01, 0, 0, 0, 0])
    locus = rl.root_locus(system, sign=-1)
    p, sizes = locus.loop.polynomials(locus.gains)
    value, _, terms = polynomials.horner(p, locus.roots.T, sizes)
    assert (np.abs(value) <= 1e-12 * terms).all()
    assert locus.gains.size < 100


@pytest.mark.parametrize("sign", [1, -1])
def test_an_integrator_is_at_the_origin_exactly(sign):
    """Without gain; found by fuzzing: it was at 6e-33."""
    den = np.polymul(np.polymul([1, 0], [1, 0, 0.1**2]), [1, 0, 1])
    locus = rl.root_locus(control.tf([1], den), sign=sign)
    assert (locus.roots[locus.gains == 0] == 0).sum() == 1


def test_the_roots_of_a_break_away_meet_at_its_point():
    """Amid a pole and two zeros that are near the point, too."""
    for name in ("section VII", "section IV", "random 8"):
        locus = rl.root_locus(SYSTEMS[name])
        for gain, point in locus.break_aways:
            if gain > 0:
                apart = np.abs(locus.roots[locus.gains == gain][0] - point)
                assert np.sort(apart)[1] < 1e-7 * abs(point)


def test_the_lists_are_the_same_whichever_gains_are_asked_for(system):
    """With given gains crossings are found when first asked for."""
    picture, given = rl.root_locus(system), rl.root_locus(system, [1.0, 2.0])
    assert given.crossings == picture.crossings
    assert given.crossings is given.crossings
    assert given.break_aways == picture.break_aways


@pytest.mark.parametrize("sign", [1, -1])
def test_real_roots_keep_their_order_between_break_aways(sign):
    """Interlaced poles and zeros: each branch stays between its neighbors, however far apart the gains."""
    zeros, poles = [-2.0, -4.0, -6.0, -8.0], [-1.0, -3.0, -5.0, -7.0, -9.0]
    locus = rl.root_locus((zeros, poles, 1.0), sign * np.array([0.0, 1e-3, 1.0, 1e3, 1e6]))
    assert (locus.roots.imag == 0).all()
    order = locus.roots[0].real.argsort()
    assert (np.diff(locus.roots.real[:, order], axis=1) > 0).all()
    assert (sign * np.diff(locus.roots.real, axis=0) < 0).all()


@pytest.mark.parametrize("count", [None, 1, 3], ids=["one polynomial", "a column", "three columns"])
def test_values_and_slopes_of_polynomials_are_numpy_s(count):
    """Each column of the coefficients belongs to the same column of the places."""
    rng = np.random.default_rng(1964)
    shape = () if count is None else (count,)
    p, s = rng.standard_normal((6, *shape)), rng.standard_normal((4, *shape)) + 1j
    found = polynomials.horner(p, s)
    for i in range(count or 1):
        column, places = (p, s) if count is None else (p[:, i], s[:, i])
        one = np.polynomial.Polynomial(column)
        wanted = one(places), one.deriv()(places), np.polynomial.Polynomial(np.abs(column))(np.abs(places))
        for ours, theirs in zip(found, wanted, strict=True):
            assert (ours if count is None else ours[:, i]) == pytest.approx(theirs, rel=1e-12)


@pytest.mark.parametrize("factor", [1.0, 7.0, -0.03])
def test_a_common_factor_of_both_polynomials_changes_no_locus(factor):
    """Its roots are those of 3 s^3 + 6 s^2 + 9 s + 12 + k (2 s + 4), its meetings and crossings the same."""
    found = rl.root_locus(control.tf([2 * factor, 4 * factor], factor * np.array([3, 6, 9, 12])), [0.0, 1.5])
    for gain, roots, condition in zip((0.0, 1.5), found.roots, found.condition, strict=True):
        one = np.poly1d([3, 6, 9 + 2 * gain, 12 + 4 * gain])
        assert mismatch(roots, one.roots) < 1e-12
        assert condition == pytest.approx(one(np.abs(roots)) / np.abs(roots * one.deriv()(roots)))
    (crossing,) = found.crossings  # 6 (9 + 2 k) = 3 (12 + 4 k) has no answer
    assert (crossing.gain, crossing.omega, crossing.direction) == (pytest.approx(-3), 0, -1)


@pytest.mark.parametrize("less", [0.0, -1e-7, 1e-7, 1e-5])
def test_asymptotes_along_the_axis_are_crossed_where_they_lean_over_it_alone(less):
    """Far out the branches of (s + 2)/(s^3 + (2 - less) s^2 + 3 s + 4) are as near to the axis as one likes.

    D(jw) N(-jw) has the imaginary part 2 w - less w^3.
    """
    found = rl.root_locus(control.tf([1, 2], [1, 2 - less, 3, 4]), [0.0]).crossings
    far = np.sqrt(2 / less) if less > 0 else None
    assert [c.omega for c in found] == pytest.approx([0.0] if far is None else [0.0, far], rel=1e-6)
    assert found[0].gain == pytest.approx(-2)
    if far:
        # The roots are rounded, and far out that counts far^2 times.
        assert found[1].gain == pytest.approx(((2 - less) * far**2 - 4) / 2, rel=1e-5)
        assert found[1].direction == 1


def test_branches_go_on_from_each_set_to_the_next():
    """Two roots go once around each other, and the sets come in any order; a third stays where it is."""
    turn, rng = np.linspace(0, 2 * np.pi, 60), np.random.default_rng(1964)
    ways = np.stack([np.exp(1j * turn), -np.exp(1j * turn), np.full(60, 5 + 0j)], axis=1)
    mixed = np.array([ways[0], *(rng.permutation(row) for row in ways[1:])])
    assert continuous_branches(mixed) == pytest.approx(ways)


def test_a_close_look_beside_the_real_axis_is_as_true():
    """Where a branch leaves the pole of the second mode; the lower half plane is out of sight."""
    system, near = SYSTEMS["section IV"], (-0.06, 0.0, 3.03, 3.07)
    exact = rl.root_locus(system, np.geomspace(1e-6, 1, 2000)).roots.ravel()
    exact = exact[(exact.imag > near[2]) & (exact.imag < near[3])]
    drawn = rl.root_locus(system, axes=near).roots
    assert (np.abs(exact - (-0.0308 + 3.0506j)) < 0.02).sum() > 100
    assert off_the_polyline(exact, drawn, near) < 0.25
