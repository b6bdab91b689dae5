"""Root loci refuse bad systems, gains and parameters; they clip nothing and return no nan."""

import control
import numpy as np
import pytest

import rlswaim as rl
from bad_input import refused
from systems import closed_loop


@pytest.fixture(scope="module")
def eqs():
    return rl.printed_equations()


PLANT = control.tf([1.0, 1.0], [1.0, 2.0, 5.0, 0.0])


@pytest.mark.parametrize("bad", [None, "G(s)", 3.0, np.eye(2), {"A": 1}], ids=repr)
def test_a_locus_needs_a_system(bad):
    refused(TypeError, lambda: rl.root_locus(bad), "root_locus")


@pytest.mark.parametrize(
    "system",
    [
        control.tf([1.0, 0.0, 0.0], [1.0, 1.0]),
        control.ss(-np.eye(2), np.eye(2), np.eye(2), np.zeros((2, 2))),
        control.ss([[np.nan]], [[1.0]], [[1.0]], [[0.0]]),
    ],
    ids=["improper", "two by two", "nan"],
)
def test_a_locus_needs_a_proper_single_loop(system):
    refused(ValueError, lambda: rl.root_locus(system), "root_locus")


@pytest.mark.parametrize(
    "bad", [[np.nan], [1.0, np.inf], np.ones((2, 2))], ids=["nan", "inf", "two dimensions"]
)
def test_gains_must_be_a_row_of_finite_numbers(bad):
    refused(ValueError, lambda: rl.root_locus(PLANT, bad), "gains", "root_locus")


@pytest.mark.parametrize("bad", ["1", [1j], [None]], ids=["text", "complex", "None"])
def test_gains_must_be_real_numbers(bad):
    refused(TypeError, lambda: rl.root_locus(PLANT, bad), "gains", "root_locus")


@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan])
def test_the_tolerance_must_be_positive(bad):
    refused(ValueError, lambda: rl.root_locus(PLANT, tolerance=bad), "tolerance")


@pytest.mark.parametrize("bad", [[np.nan], [0.0, np.inf]])
def test_values_of_a_parameter_must_be_finite(eqs, bad):
    refused(
        ValueError,
        lambda: rl.parameter_locus(lambda k: closed_loop("rate_attitude", eqs, K_A=k), bad),
        "values",
    )


def test_a_parameter_must_keep_the_order():
    def grows(k):
        return PLANT if k < 1 else PLANT * PLANT

    refused(ValueError, lambda: rl.parameter_locus(grows, [0.0, 2.0]), "parameter_locus", "6 poles", "3")


def test_a_parameter_passes_the_system_s_own_complaint_on(eqs):
    with pytest.raises(ValueError, match="gyro in rate_attitude"):
        rl.parameter_locus(lambda x: closed_loop("rate_attitude", eqs, gyro=x), [400.0, 430.0])
