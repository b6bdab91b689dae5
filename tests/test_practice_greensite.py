"""Somebody else's vehicle: the printed results both ways, and the loop against transfer functions by hand."""

import numpy as np
import pytest

from rlswaim.practice import agreement
from rlswaim.practice import greensite as g
from rlswaim.practice.margins import frequency_response
from rlswaim.source.tables import constants, half_unit

ROWS = {row.id: row for row in agreement.greensite_rows()}
C = constants("greensite")
OMEGA = np.geomspace(1e-3, 300, 400)


@pytest.mark.parametrize("row", ROWS.values(), ids=list(ROWS))
def test_printed(row):
    assert row.verdict in ("agrees", "rounding")
    assert (row.verdict == "agrees") == row.agrees, f"printed {row.printed}, computed {row.computed}"
    assert row.agrees or row.why


def test_margins_with_notch_come_out_with_gains_that_round_to_the_printed_ones():
    gains = agreement.unrounded_gains()
    for name, printed in (("K_p", "1.73"), ("K_d", ".69")):
        assert abs(gains[name] - float(printed)) <= half_unit(printed)
    found = agreement.margins_with(**gains)
    for name in ("aero_margin", "gain_margin", "phase_margin"):
        row = ROWS[f"notch-{name}"]
        assert abs(found[name] - float(row.printed)) <= half_unit(row.printed)
        assert "1.7318 and .6867" in row.why
    assert (round(gains["K_p"], 4), round(gains["K_d"], 4)) == (1.7318, 0.6867)


def test_alpha_in_the_gust_comes_out_with_an_amplitude_that_rounds_to_the_printed_one():
    row = ROWS["gust-alpha"]
    amplitude = 6.4 * float(row.printed) / row.computed
    assert f"{amplitude:.3f} m/s" in row.why
    assert abs(amplitude - 6.4) <= half_unit("6.4")


def test_printed_rigid_case_has_neither_actuator_nor_delay():
    found = agreement.margins_with(**agreement.RIGID, bending=False)
    row = ROWS["rigid-phase_margin"]
    assert abs(found["phase_margin"] - float(row.printed)) > half_unit(row.printed)


def by_hand(s, K_p, K_d, K_z, K_zdot, notch, mu_alpha=1.0, mu_c=1.0, omega=1.0, exact_delay=False):
    """Return L(s) from the equations of motion by Cramer's rule, its blocks multiplied."""
    A6, K1 = mu_alpha * C["A6"], mu_c * C["K1"]
    a, b = s**2 - C["a1"] * s, -(C["a1"] * C["V"] + C["a4"])
    c, d = -A6 / C["V"] * s, s**2 - A6
    z, theta = (C["a3"] * d - K1 * b) / (a * d - b * c), (a * K1 - c * C["a3"]) / (a * d - b * c)
    w = C["omega"] * omega
    eta = -C["phi_tvc"] * C["T_c"] / (s**2 + 2 * C["zeta"] * w * s + w**2)
    signal = (K_p + K_d * s) * (theta + C["sigma_ins"] * eta) + (K_z + K_zdot * s) * (z - C["phi_ins"] * eta)
    x = s * C["delay"]
    pade = (
        np.exp(-x) if exact_delay else (120 - 60 * x + 12 * x**2 - x**3) / (120 + 60 * x + 12 * x**2 + x**3)
    )
    W = 70**2 / (s**2 + 98 * s + 70**2) * pade
    if notch:
        W = W * (s**2 + 2 * 0.002 * 18.9 * s + 18.9**2) / (s**2 + 2 * 0.7 * 18.9 * s + 18.9**2)
    return W * signal


@pytest.mark.parametrize(
    "given",
    [
        {"notch": True},
        {"notch": False},
        {"notch": True, "omega": 1.1, "mu_alpha": 1.3, "mu_c": 0.8},
        {"notch": True, "K_z": 0.0, "K_zdot": 0.002},
    ],
    ids=str,
)
def test_loop_is_that_of_the_equations(given):
    given = {"K_p": 1.73, "K_d": 0.69, "K_z": -1e-3, "K_zdot": -1e-3} | given
    wanted = by_hand(1j * OMEGA, **given)
    found = frequency_response(g.greensite(**given), OMEGA)[:, 0, 0]
    assert np.max(np.abs(found / wanted - 1)) < 1e-9


def test_pade_errs_little_where_the_margins_are():
    gains = {"K_p": 1.73, "K_d": 0.69, "K_z": -1e-3, "K_zdot": -1e-3, "notch": True}
    near = 1j * OMEGA[OMEGA < 30]
    assert np.max(np.abs(by_hand(near, **gains) / by_hand(near, **gains, exact_delay=True) - 1)) < 1e-5


def test_closed_loop_is_the_loop_closed():
    given = {"K_p": 1.73, "K_d": 0.69}
    closed = g.closed_loop(**given)
    s = 1j * OMEGA[:, None, None]
    poles = closed.poles()
    assert closed.nstates == 13
    assert (
        np.max(
            np.abs(1 + np.array([by_hand(p, K_z=-1e-3, K_zdot=-1e-3, notch=True, **given) for p in poles]))
        )
        < 1e-6
    )
    found = frequency_response(closed, OMEGA)
    theta, zdot, alpha = (found[:, closed.output_labels.index(n), 0] for n in ("theta", "zdot", "alpha"))
    assert np.allclose(alpha, theta + zdot / C["V"] - 1)
    assert np.allclose(s[:, 0, 0] * theta, found[:, closed.output_labels.index("thetadot"), 0])


def test_gust_peaks_go_with_the_gust():
    one, two = (agreement.gust_peaks(amplitude, **agreement.RIGID, bending=False) for amplitude in (1.0, 2.0))
    assert two == pytest.approx({name: 2 * value for name, value in one.items()})


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        ({"K_p": float("nan")}, ValueError, "K_p in greensite: got nan"),
        ({"K_p": "1"}, TypeError, "K_p in greensite: got '1'"),
        ({"omega": 0.0}, ValueError, "omega in greensite: got 0, wanted a number above 0"),
        ({"mu_c": float("inf")}, ValueError, "mu_c in greensite: got inf"),
        ({"notch": 1}, TypeError, "notch in greensite: got int, wanted bool"),
        ({"bending": None}, TypeError, "bending in greensite: got NoneType, wanted bool"),
    ],
    ids=str,
)
def test_bad_input(given, error, words):
    with pytest.raises(error, match=words):
        g.greensite(**({"K_p": 1.73, "K_d": 0.69} | given))


def test_table_shows_every_row():
    frame = agreement.table(ROWS.values())
    assert list(frame.index) == list(ROWS)
    assert (frame.verdict == "rounding").sum() == sum(not row.agrees for row in ROWS.values())
