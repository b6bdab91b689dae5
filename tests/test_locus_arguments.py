"""What a root locus refuses, with what, where, got and wanted."""

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.rootlocus.adaptive_gains import MOST
from systems import mismatch

S = control.tf("s")


@pytest.mark.parametrize("sign", [0, 2, -3, 0.5, True, "1", None, [1], np.array([1])])
def test_the_sign_is_one_or_minus_one(sign):
    with pytest.raises(ValueError, match=r"sign in root_locus: got .*, wanted 1 or -1"):
        rl.root_locus(1 / (S + 1), sign=sign)


@pytest.mark.parametrize("axes", [(1, 0, 0, 1), (0, 1, 1, 0), (0, 0, 0, 1), (0, 1, 0), (0, np.nan, 0, 1)])
def test_axes_are_left_right_bottom_top(axes):
    with pytest.raises(ValueError, match=r"axes.* in root_locus: got .*, wanted"):
        rl.root_locus(1 / (S + 1), axes=axes)


@pytest.mark.parametrize("gain", [1e308, -1e308, 1e200])
def test_gains_that_floats_can_t_follow_are_refused(gain):
    with pytest.raises(ValueError, match=r"gains\[\d\] in root_locus: got .*, wanted at most"):
        rl.root_locus(1 / (S + 1), [0.0, gain])


@pytest.mark.parametrize(
    ("gains", "error"),
    [
        ([], ValueError),
        ([[]], ValueError),
        ([[1.0, 2.0], [3.0, 4.0]], ValueError),
        ([[1.0], [1.0, 2.0]], ValueError),
        ([1.0, np.nan], ValueError),
        ([np.inf], ValueError),
        ([1j], TypeError),
        ([True], TypeError),
        (["1"], TypeError),
        ([None], TypeError),
    ],
)
def test_gains_are_one_row_of_finite_numbers(gains, error):
    with pytest.raises(error, match=r"gains.* in root_locus: got .*, wanted"):
        rl.root_locus(1 / (S + 1), gains)


@pytest.mark.parametrize("tolerance", [1e-300, 1e-6])
def test_no_picture_takes_more_gains_than_it_may(tolerance):
    found = rl.root_locus((S + 3) / ((S + 1) * (S + 2)), tolerance=tolerance)
    assert found.gains.size <= MOST
    assert (np.diff(found.gains) > 0).all()


@pytest.mark.parametrize(
    ("system", "error", "words"),
    [
        (control.tf([1e300], [1e-300, 1.0]), ValueError, "denominator in root_locus: got"),
        (control.tf([1.0], [1e-320, 1.0, 1.0]), ValueError, "denominator in root_locus: got"),
        (control.tf([1e-320], [1.0, 1.0]), ValueError, "gain in root_locus: got .*, wanted a size"),
        (([], [-1.0], 1e120), ValueError, r"gain in root_locus: got 1e\+120 .*, wanted a size"),
        (([[1.0], [1.0, 2.0]], [[1.0]], [[1.0]]), ValueError, "A in root_locus: got rows of unequal"),
        (([np.nan], [-1.0, -2.0], 1.0), ValueError, "zeros in root_locus: got .*, wanted"),
        (control.tf([np.nan], [1.0, 1.0]), ValueError, r"numerator\[0\] in root_locus: got nan, wanted"),
        (
            control.ss(np.eye(2), np.eye(2), np.eye(2), 0),
            ValueError,
            "root_locus: got 2 inputs and 2 outputs",
        ),
        (control.tf([0], [1, 1]), ValueError, "numerator in root_locus: got 0, wanted"),
        (([], [-1.0], 0.0), ValueError, "gain in root_locus: got 0, wanted"),
        (([1j], [-1, -2], 1.0), ValueError, r"zeros\[0\] in root_locus: got 1j without its conjugate"),
        (([], [-1, "2"], 1.0), TypeError, "poles in root_locus: got"),
        (([], [-1.0], 1j), TypeError, "gain in root_locus: got"),
        (([1.0, 2.0], [-1.0], 1.0), ValueError, "wanted a proper system; .* give 1/G"),
        ((S + 1) * (S + 5) / (S + 2), ValueError, "wanted a proper system; .* give 1/G"),
        (([[1j]], [[1.0]], [[1.0]]), TypeError, "A in root_locus: got an array of complex128"),
    ],
)
def test_loops_that_are_none_are_refused(system, error, words):
    with pytest.raises(error, match=words):
        rl.root_locus(system)


def test_an_improper_loop_is_followed_by_its_inverse():
    """What the refusal says: 1 + k G = 0 has the roots of 1 + (1/k)(1/G) = 0."""
    G, k = (S + 1) * (S + 5) / (S + 2), 3.0
    found = rl.root_locus(1 / G, [1 / k]).roots[0]
    assert mismatch(found, np.roots(np.polyadd([1, 2], k * np.array([1, 6, 5])))) < 1e-14
