"""Margins against python-control and against loops with known ones."""

import control
import numpy as np
import pytest

from rlswaim.practice import blocks
from rlswaim.practice.greensite import greensite
from rlswaim.practice.margins import by_mode, frequency_response, margins


def test_known_loop():
    """1/(s (s + 1)^2): the phase is -180 deg at 1 rad/s, where the size is one half."""
    loop = control.ss(control.tf([1], [1, 2, 1, 0]))
    found = margins(loop)
    assert [tuple(m) for m in found.gain] == [pytest.approx((20 * np.log10(2), 1.0))]
    (phase,) = found.phase
    assert phase.omega * (1 + phase.omega**2) == pytest.approx(1)
    assert phase.deg == pytest.approx(90 - 2 * np.degrees(np.arctan(phase.omega)))
    assert phase.delay == pytest.approx(np.radians(phase.deg) / phase.omega)


LOOPS = {
    "rigid": greensite(K_p=1.78, K_d=0.44, notch=False, bending=False),
    "notch": greensite(K_p=1.73, K_d=0.69),
    "two lags": control.ss(control.zpk([-1], [0.5, -2, -3], 30)),
}


@pytest.mark.parametrize("loop", LOOPS.values(), ids=list(LOOPS))
def test_as_python_control_has_them(loop):
    found = margins(loop)
    omega = np.geomspace(1e-3, 1e3, 20_001)
    L = np.asarray(loop(1j * omega))
    disk = control.disk_margins(loop, omega)[0]
    assert found.disk == pytest.approx(disk, rel=1e-3)
    assert found.peak_sensitivity == pytest.approx(np.max(1 / np.abs(1 + L)), rel=1e-3)
    real = np.flatnonzero(np.diff(np.signbit(L.imag)) & (L.real[1:] < 0))
    assert np.allclose([m.omega for m in found.gain if 1e-3 < m.omega < 1e3], omega[real], rtol=2e-3)
    ones = np.flatnonzero(np.diff(np.abs(L) > 1))
    assert np.allclose([m.omega for m in found.phase if 1e-3 < m.omega < 1e3], omega[ones], rtol=2e-3)


@pytest.mark.parametrize("name", LOOPS)
def test_loop_at_its_margins_is_at_the_border(name):
    loop = LOOPS[name]
    found = margins(loop)
    assert (len(found.gain), len(found.phase)) == {"rigid": (3, 3), "notch": (4, 3), "two lags": (0, 1)}[name]
    for m in found.gain:
        poles = control.feedback(loop * 10 ** (m.dB / 20), 1).poles()
        assert np.min(np.abs(poles - 1j * m.omega)) < 1e-5 * max(1, m.omega)
    for m in found.phase:
        L = frequency_response(loop, np.array([m.omega]))[0, 0, 0]
        assert abs(1 + L * np.exp(-1j * m.omega * m.delay)) < 1e-9


def test_gain_and_phase_of_the_disk():
    found = margins(LOOPS["notch"])
    low, high = (min((m.dB for m in found.gain if (m.dB > 0) == up), key=abs) for up in (False, True))
    assert 0 < found.disk_gain_dB <= min(-low, high)
    assert 0 < found.disk_phase_deg <= min(abs(m.deg) for m in found.phase)


def test_by_mode_names_each_crossing_once():
    found = margins(LOOPS["notch"])
    table = by_mode(found, {"bending 1": 18.9})
    assert set(table) == {"rigid", "aero", "bending 1"}
    assert table["aero"]["gain_dB"] == pytest.approx(-5.98722, abs=1e-4)
    assert table["rigid"]["gain_dB"] == pytest.approx(7.52631, abs=1e-4)
    assert table["bending 1"]["gain_dB"] == np.inf
    without = margins(greensite(K_p=1.73, K_d=0.69, notch=False))
    assert by_mode(without, {"bending 1": 18.9})["bending 1"]["phase_deg"] < 90


def test_refused():
    with pytest.raises(ValueError, match="loop in margins: got 2 inputs, 2 outputs, wanted 1, 1"):
        margins(blocks.gain(np.eye(2)))
    with pytest.raises(TypeError, match="loop in margins: got TransferFunction"):
        margins(control.tf([1], [1, 1]))


S = 1j * np.geomspace(1e-2, 1e3, 100)


@pytest.mark.parametrize(
    ("block", "zeros", "poles"),
    [
        (blocks.first_order([2, 3], [5, 7]), [2, 3], [5, 7]),
        (blocks.first_order([3], [5, 7]), [3], [5, 7]),
        (blocks.second_order([1, 2, 3], [2, 0.5, 7]), [1, 2, 3], [2, 0.5, 7]),
        (blocks.second_order([5], [2, 0.5, 7]), [5], [2, 0.5, 7]),
        *[(blocks.delay(0.02, n), *control.pade(0.02, n)) for n in (1, 2, 3, 4, 5)],
    ],
)
def test_blocks(block, zeros, poles):
    wanted = np.polyval(zeros, S) / np.polyval(poles, S)
    assert np.allclose(frequency_response(block, S.imag)[:, 0, 0], wanted, rtol=1e-10)
