"""The roots that matter most, written out here once more, beside the ledger and apart from it.

Each holds the text as printed, the equation it stands in, and how it is computed, so that a
changed table cannot change the test with it.
"""

from functools import cache

import numpy as np
import pytest
from numpy.polynomial import polynomial as npp

import rlswaim as rl
from rlswaim.edition.ledger import half_unit


@pytest.mark.parametrize(
    ("printed", "half"),
    [("1.310", 0.0005), (".0387", 0.00005), ("35,800", 0.5), ("15.297e8", 5e4), ("-10", 0.5)],
)
def test_tolerance_is_half_a_unit_of_the_last_printed_digit(printed, half):
    assert half_unit(printed) == pytest.approx(half)


# ---- the roots, as printed

AGREES, LAST_DIGIT = "agrees", "one unit off in the last digit"

DESIGN = {"K_A": 0.0016, "K_C": 10.0, "K_R": 0.618}
"""The gains of Eqs. 72-75, as the report goes on with them."""


@cache
def poles(case):
    """Return the poles of one of the report's cases, by name."""
    eqs = rl.printed_equations()
    if case in (2, 3, 4):
        return npp.polyroots(eqs.characteristic_polynomial(case))
    if case == "fig11":
        return rl.rate_attitude(eqs, K_A=-3.14, K_C=1.75, K_R=-0.286, gyro=None).poles()
    if case == "fig8":
        return rl.rate_attitude(eqs, K_A=1.8, K_C=10.0, K_R=0.618, gyro=60.0).poles()
    if case == "station 60, one mode":
        return npp.polyroots(one_mode_loop(eqs, 60.0))
    return rl.rate_attitude(eqs, **DESIGN, gyro=float(case)).poles()


def one_mode_loop(eqs, gyro):
    """Return the characteristic polynomial of Eq. 76: rigid body, first mode and actuator."""

    def numerator(column):
        replaced = eqs.matrix[:3, :3].copy()
        replaced[:, column] = 0.0
        replaced[:, column, 0] = eqs.forcing("delta")[:3]
        return np.array([np.linalg.det(replaced @ (s ** np.arange(3))) for s in around])

    around = 3.0 * np.exp(2j * np.pi * np.arange(9) / 9)
    seen = numerator(1) - eqs.modes[0].slope(gyro) * numerator(2)
    open_loop = np.array([np.linalg.det(eqs.matrix[:3, :3] @ (s ** np.arange(3))) for s in around])
    gain = DESIGN["K_A"] * DESIGN["K_C"]
    values = open_loop * (around + DESIGN["K_C"]) + gain * (DESIGN["K_R"] * around + 1) * seen
    return (np.fft.fft(values) / 9 / 3.0 ** np.arange(9)).real[:7] / eqs.U


def near(case, place):
    """Return the pole that lies nearest to a place in the upper half plane."""
    found = poles(case)
    return found[np.abs(found - place).argmin()]


def real_root(case, place):
    root = near(case, place)
    assert root.imag == 0
    return root.real


def damping(case, place):
    return -2 * near(case, place).real


def stiffness(case, place):
    return abs(near(case, place)) ** 2


def omega(case, place):
    return abs(near(case, place))


def zeta(case, place):
    return -near(case, place).real / abs(near(case, place))


MODE_1, MODE_2, ALONE = 1.15j, 3.05j, 1.35j
PRINTED = [
    # id, text as printed, quantity, case, near which root, what is true
    ("eq39-2_zeta_omega_sp", ".1032", damping, 2, 0.3j, AGREES),
    ("eq39-omega_sp^2", ".1164", stiffness, 2, 0.3j, LAST_DIGIT),
    ("eq39-omega_sp", ".342", omega, 2, 0.3j, LAST_DIGIT),
    ("eq39-zeta_sp", ".151", zeta, 2, 0.3j, AGREES),
    ("eq40-unstable", "1.08", real_root, 3, 1.1, AGREES),
    ("eq40-stable", "-1.28", real_root, 3, -1.3, AGREES),
    ("eq40-2_zeta_omega_1e", ".0387", damping, 3, ALONE, AGREES),
    ("eq40-omega_1e^2", "1.813", stiffness, 3, ALONE, AGREES),
    ("eq40-omega_1e", "1.347", omega, 3, ALONE, AGREES),
    ("eq40-zeta_1e", ".014", zeta, 3, ALONE, AGREES),
    ("eq41-unstable", "1.31", real_root, 4, 1.3, AGREES),
    ("eq41-stable", "-1.54", real_root, 4, -1.5, AGREES),
    ("eq41-2_zeta_omega_1e", ".0236", damping, 4, MODE_1, AGREES),
    ("eq41-omega_1e^2", "1.323", stiffness, 4, MODE_1, LAST_DIGIT),
    ("eq41-2_zeta_omega_2e", ".0615", damping, 4, MODE_2, LAST_DIGIT),
    ("eq41-omega_2e^2", "9.3", stiffness, 4, MODE_2, AGREES),
    ("eq41-omega_1e", "1.15", omega, 4, MODE_1, AGREES),
    ("eq41-zeta_1e", ".01", zeta, 4, MODE_1, AGREES),
    ("eq41-omega_2e", "3.05", omega, 4, MODE_2, AGREES),
    ("eq41-zeta_2e", ".01", zeta, 4, MODE_2, AGREES),
    ("eq77-unstable", "1.08", real_root, "station 60, one mode", 1.1, AGREES),
    ("eq77-stable", "-1.28", real_root, "station 60, one mode", -1.3, AGREES),
    ("eq77-2_zeta_omega_1e", ".0406", damping, "station 60, one mode", ALONE, AGREES),
    ("eq77-omega_1e^2", "1.817", stiffness, "station 60, one mode", ALONE, AGREES),
    ("eq77-actuator", "-10", real_root, "station 60, one mode", -10, AGREES),
    ("eq77-origin", "0", real_root, "station 60, one mode", 0, AGREES),
    ("eq80-unstable", "1.31", real_root, 400, 1.3, AGREES),
    ("eq80-stable", "-1.54", real_root, 400, -1.5, AGREES),
    ("eq80-2_zeta_omega_1e", ".024", damping, 400, MODE_1, AGREES),
    ("eq80-omega_1e^2", "1.32", stiffness, 400, MODE_1, AGREES),
    ("eq80-2_zeta_omega_2e", ".061", damping, 400, MODE_2, AGREES),
    ("eq80-omega_2e^2", "9.3", stiffness, 400, MODE_2, AGREES),
    ("eq80-actuator", "-10", real_root, 400, -10, AGREES),
    ("eq80-origin", "0", real_root, 400, 0, AGREES),
    ("fig8-omega_1e", "2", omega, "fig8", -1 + 1.7j, AGREES),
    ("fig8-zeta_1e", "0.5", zeta, "fig8", -1 + 1.7j, AGREES),
    ("fig11-omega_sp", "2.04", omega, "fig11", -1.2 + 1.6j, AGREES),
    ("fig11-zeta_sp", ".591", zeta, "fig11", -1.2 + 1.6j, LAST_DIGIT),
    ("fig11-first_mode_slow", "-.00027", real_root, "fig11", 0, AGREES),
    ("fig11-first_mode_fast", "-1.291", real_root, "fig11", -1.3, AGREES),
    ("fig11-unstable", "1.375", real_root, "fig11", 1.4, AGREES),
    ("fig11-unstable_slow", ".42", real_root, "fig11", 0.4, AGREES),
    ("fig11-omega_2e", "3.05", omega, "fig11", 3j, AGREES),
    ("fig11-zeta_2e", ".026", zeta, "fig11", 3j, AGREES),
]


@pytest.mark.parametrize(
    ("printed", "quantity", "case", "place", "truth"),
    [row[1:] for row in PRINTED],
    ids=[row[0] for row in PRINTED],
)
def test_printed(printed, quantity, case, place, truth):
    """A root agrees to the last printed digit, or is one unit off in it and no more: then the row says so."""
    difference = abs(quantity(case, place) - float(printed))
    agrees = difference <= half_unit(printed) * (1 + 1e-9)
    assert agrees == (truth == AGREES)
    assert difference <= 3 * half_unit(printed)


# ---- transfer functions, as printed: gain, real roots, complex pair

TRANSFER = [
    # id, output, text of the leading coefficient, roots (real, imaginary) as printed
    ("eq92", "theta", "1.04", [("1.148", ""), ("-.00011", ""), ("-1.343", ""), ("-.027", "2.865")]),
    ("eq93", "q1", "-19.72", [("0", ""), ("1.562", ""), ("-1.912", ""), (".00235", "2.183")]),
    ("eq94", "q2", "-19.25", [("0", ""), ("1.062", ""), ("-1.229", ""), ("-.0156", ".365")]),
    (
        "eq92-denominator",
        "",
        "1",
        [("0", ""), ("1.31", ""), ("-1.543", ""), ("-.012", "1.15"), ("-.031", "3.051")],
    ),
]
ROWS = [(name, output, gain, root) for name, output, gain, found in TRANSFER for root in found]


@cache
def factored(output):
    """Return the leading coefficient and the roots of a numerator over delta, or of the denominator."""
    eqs = rl.printed_equations()
    p = eqs.numerator(output, "delta") if output else eqs.characteristic_polynomial()
    p = np.trim_zeros(np.where(np.abs(p) > 1e-12 * np.abs(p).max(), p, 0.0), "b")
    return p[-1], npp.polyroots(p)


@pytest.mark.parametrize(
    ("name", "output", "gain"), [row[:3] for row in TRANSFER], ids=[row[0] for row in TRANSFER]
)
def test_printed_leading_coefficient(name, output, gain):
    assert abs(factored(output)[0] - float(gain)) <= half_unit(gain)


@pytest.mark.parametrize(
    ("output", "real", "imaginary"),
    [(output, *root) for _, output, _, root in ROWS],
    ids=[f"{name}-({root[0]},{root[1] or 0})" for name, _, _, root in ROWS],
)
def test_printed_root(output, real, imaginary):
    wanted = complex(float(real), float(imaginary or 0))
    roots = factored(output)[1]
    root = roots[np.abs(roots - wanted).argmin()]
    assert abs(root.real - float(real)) <= half_unit(real)
    assert abs(root.imag - wanted.imag) <= half_unit(imaginary or "0.0")


@pytest.mark.parametrize(("name", "output", "gain", "found"), TRANSFER, ids=[row[0] for row in TRANSFER])
def test_printed_roots_are_all_there_are(name, output, gain, found):
    assert factored(output)[1].size == sum(2 if imaginary else 1 for _, imaginary in found)
