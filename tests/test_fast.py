"""Compiled or not, the same loci; and the compiled way gives up where it can't be trusted."""

import subprocess
import sys

import control
import numpy as np
import pytest

import rlswaim as rl
from exact import exact_roots, off_the_polyline, paired, relative_errors
from rlswaim.rootlocus import fast, polynomials
from rlswaim.rootlocus.adaptive_gains import default_axes
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


@pytest.fixture
def both(monkeypatch):
    """Do work with the compiled functions and without."""

    def done(work):
        with monkeypatch.context() as patch:
            patch.setattr(fast, "ENABLED", True)
            compiled = work()
            patch.setattr(fast, "ENABLED", False)
            return compiled, work()

    return done


def agree(a, b):
    """Well-conditioned roots of two loci at the same gains are the same to 1e-10, whatever their order."""
    assert np.array_equal(a.gains, b.gains)
    for found, wanted, condition in zip(a.roots, b.roots, a.condition, strict=True):
        well = condition < 1e5
        assert relative_errors(found, wanted)[well].max(initial=0) < 1e-10


def test_the_compiled_functions_are_there():
    assert fast.ENABLED
    assert fast.compiled() is not None


@pytest.mark.parametrize("count", [1, 9, 500])
@pytest.mark.parametrize("sign", [1, -1])
def test_given_gains_have_the_same_roots_and_names(system, both, count, sign):
    gains = sign * np.geomspace(1e-3, 1e3, count) * 1.0001
    a, b = both(lambda: rl.root_locus(system, gains))
    agree(a, b)
    assert sorted(a.labels) == sorted(b.labels)
    starts = paired(a.roots[0], b.roots[0])
    names = dict(zip(b.roots[0].tolist(), b.labels, strict=True))
    assert [names[s] for s in starts.tolist()] == list(a.labels)


@pytest.mark.parametrize("sign", [1, -1])
def test_pictures_are_as_good(system, both, sign):
    """The compiled way takes about as many gains or fewer, with the same marks; each lies on the other."""
    a, b = both(lambda: rl.root_locus(system, sign=sign))
    axes = default_axes(open_loop(system))
    assert a.gains.size <= 2 + 1.1 * b.gains.size
    for one, other in ((a, b), (b, a)):
        assert off_the_polyline(one.roots.ravel(), other.roots, axes) < 0.25
    for mine, theirs in ((a.break_aways, b.break_aways), (a.crossings, b.crossings)):
        assert np.allclose([m[0] for m in mine], [m[0] for m in theirs], rtol=1e-6, atol=0)
    agree(rl.root_locus(system, a.gains), a)


def test_marks_of_a_break_away_end_on_one_branch_each(both):
    """A gain of a double root in the middle of others leaves each column where it was."""
    system = SYSTEMS["section IV, polynomials"]
    mark = next(b.gain for b in rl.root_locus(system).break_aways if b.gain > 1)
    for locus in both(lambda: rl.root_locus(system, mark * np.linspace(0.99, 1.01, 201))):
        assert np.abs(np.diff(locus.roots, axis=0)).max() < 0.1


def test_what_is_not_trusted_is_left_to_eigenvalues(both):
    """Wilkinson's polynomial of order 20 hardly knows its roots: the matrix does, digit for digit."""
    wilkinson = -np.diag(np.arange(1.0, 21)), np.ones((20, 1)), np.full((1, 20), 1e-3)
    a, b = both(lambda: rl.root_locus(wilkinson, np.geomspace(0.1, 10, 20)))
    assert np.array_equal(a.roots, b.roots)
    assert (a.condition > 1e8).mean() > 0.25


@pytest.mark.parametrize("p", [np.poly([-1.0] * 4), np.poly([-1, -1, -2, 5, 1e-6]), np.poly([1e5, 1, -1e-4])])
def test_polynomials_have_the_same_roots(both, p):
    a, b = both(lambda: polynomials.roots(p[::-1]))
    assert mismatch(a, b) < 1e-12


def test_roots_of_a_polynomial_of_order_38(both):
    """Break-away points of a random system of order 20, all of size .05 or so, against 60 digits."""
    loop = open_loop(SYSTEMS["random 20"])
    p = np.convolve(loop.numerator, polynomials.derivative(loop.denominator))
    p -= np.convolve(loop.denominator, polynomials.derivative(loop.numerator))
    wanted = exact_roots(p)
    for found in both(lambda: polynomials.roots(p)):
        assert relative_errors(found, wanted).max() < 1e-12


def test_four_integrators_and_a_pair_beside_its_zeros(both):
    """Gains up to 5e15, four roots that leave the origin (found by fuzzing): each satisfies D + k N."""
    system = control.tf([1, 1, 9.01, 9.01, 0.09, 0.09], [1, 0, 0.01, 0, 0, 0, 0])
    for locus in both(lambda: rl.root_locus(system, sign=-1)):
        p, sizes = locus.loop.polynomials(locus.gains)
        value, _, terms = polynomials.horner(p, locus.roots.T, sizes)
        assert (np.abs(value) <= 1e-12 * terms).all()
        assert locus.gains.size < 100


@pytest.mark.parametrize("sign", [1, -1])
def test_an_integrator_is_at_the_origin_exactly(both, sign):
    """Without gain; found by fuzzing: it was at 6e-33."""
    den = np.polymul(np.polymul([1, 0], [1, 0, 0.1**2]), [1, 0, 1])
    for locus in both(lambda: rl.root_locus(control.tf([1], den), sign=sign)):
        assert (locus.roots[locus.gains == 0] == 0).sum() == 1


def test_without_numba_or_room_for_its_cache_numpy_serves():
    """In fresh processes: numba can't be imported; nothing may be written beside the sources or at home."""
    work = "import rlswaim as rl, control; print(rl.root_locus(control.tf([1], [1, 2, 2, 0])).gains.size)"
    hide = "import sys; sys.modules['numba'] = None; "
    full = (
        "import numba.core.caching as c; "
        "c.CacheImpl._locator_classes = []; "
        "from rlswaim.rootlocus import fast; assert fast.compiled() is None; "
    )
    sizes = [
        subprocess.run(
            [sys.executable, "-c", start + work], capture_output=True, text=True, check=True
        ).stdout
        for start in (hide, full)
    ]
    assert sizes[0] == sizes[1]


def test_importing_the_package_does_not_import_numba():
    code = "import rlswaim, sys; assert 'numba' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
