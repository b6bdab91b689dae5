"""What the loops of Section VII bear: wrong readings, other gains, delay, in one actuator or in both."""

import control
import numpy as np
import pytest

import rlswaim as rl
from exact import paired
from rlswaim.edition import conclusions, robustness, search, simultaneous_margins
from rlswaim.loops.given_shapes import with_shapes

EQS = rl.printed_equations()
WINNERS = search.winners()
BY_HAND = conclusions.found_gains("dual_actuation")
MODEST = next(w.gains for w in WINNERS if (w.system, w.objective) == ("modest_jet", "pair-all"))


def delayed(gains_, actuator, seconds):
    """Return the largest real part with a delay in front of an actuator, as a Pade quotient of order 5."""
    A, at = robustness._matrix(EQS, gains_), robustness.ACTUATORS[actuator]
    num, den = control.pade(seconds, 5)
    lag = control.ss(control.tf(num, den))
    opened, push = A.copy(), np.zeros((9, 1))
    opened[at, :7], push[at] = 0, 1
    loop = control.ss(opened, push, np.r_[A[at, :7], 0, 0][None], 0)
    return control.feedback(loop * lag, 1, sign=1).poles().real.max()


@pytest.mark.parametrize("chosen", [BY_HAND, MODEST], ids=["by hand", "modest jet"])
@pytest.mark.parametrize("actuator", robustness.ACTUATORS)
def test_margins_are_where_the_loop_fails(chosen, actuator):
    found = robustness.margins(EQS, chosen, actuator)
    assert delayed(chosen, actuator, 0.99 * found.delay) < 0 < delayed(chosen, actuator, 1.01 * found.delay)
    A, at = robustness._matrix(EQS, chosen), robustness.ACTUATORS[actuator]
    for factor, stable in (
        (found.lower * 0.99, False),
        (found.lower * 1.01, True),
        (found.upper * 0.99, True),
    ):
        if factor and np.isfinite(factor):
            scaled = A.copy()
            scaled[at, :7] *= factor
            assert (np.linalg.eigvals(scaled).real.max() < 0) == stable


def test_margins_want_a_stable_loop():
    with pytest.raises(ValueError, match=r"gains in margins: got a loop with a root at 1\.26 1/s"):
        robustness.margins(EQS, BY_HAND | {"kK_z": 0.0, "K_A": 1.0}, "jet")


def test_shapes_that_are_right_leave_the_poles():
    poles = np.linalg.eigvals(robustness._matrix(EQS, BY_HAND))
    for other in (
        *robustness.misread(EQS, BY_HAND, 0.0),
        *robustness.reshaped(rl.swaim_booster(), BY_HAND, 0.0),
    ):
        assert np.abs(np.sort_complex(other) - np.sort_complex(poles)).max() < 0.1
    same = robustness.misread(EQS, BY_HAND, 0.0)[0]
    assert np.abs(same - paired(same, poles)).max() < 1e-9


@pytest.mark.parametrize("chosen", [BY_HAND, MODEST], ids=["by hand", "modest jet"])
def test_misread_deflections_are_off_by_what_is_said(chosen):
    """Beside loops that are wired anew, with the deflections of both modes at sensor and jet set by hand."""
    signs = [(i, j, k, m) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1) for m in (-1, 1)]
    at = [(mode, chosen[place]) for place in ("sensor", "jet") for mode in EQS.modes]
    if chosen["sensor"] == chosen["jet"]:  # a place of its own for each reading
        chosen = chosen | {"jet": chosen["jet"] + 1e-9}
    for poles, wrong in zip(robustness.misread(EQS, chosen), signs, strict=True):
        phi = [mode.deflection(x) * (1 + 0.05 * sign) for (mode, x), sign in zip(at, wrong, strict=True)]
        eqs = with_shapes(EQS, {chosen["sensor"]: phi[:2], chosen["jet"]: phi[2:]})
        wired = rl.dual_actuation(eqs, **chosen).poles()
        assert np.abs(poles - paired(poles, wired)).max() < 1e-4


BOTH = {name: simultaneous_margins.together(EQS, g) for name, g in (("by hand", BY_HAND), ("modest", MODEST))}


@pytest.mark.parametrize("name", BOTH)
def test_both_loops_fail_at_their_disk_margin_and_not_within(name):
    found, A = BOTH[name], robustness._matrix(EQS, {"by hand": BY_HAND, "modest": MODEST}[name])
    at_limit = np.linalg.eigvals(simultaneous_margins.scaled(A, found.worst))
    assert np.abs(at_limit - 1j * found.omega).min() < 1e-6 * found.omega
    delta = 2 * (found.worst - 1) / (found.worst + 1)
    assert np.abs(delta) == pytest.approx([found.disk] * 2)
    draw = np.random.default_rng(1964)
    inside = found.disk * 0.995 * np.exp(2j * np.pi * draw.random((4000, 2)))
    poles = np.linalg.eigvals(simultaneous_margins.scaled(A, (1 + inside / 2) / (1 - inside / 2)))
    assert poles.real.max() < 0


@pytest.mark.parametrize("name", BOTH)
def test_gain_and_phase_margins_are_those_of_the_disk(name):
    found, chosen = BOTH[name], {"by hand": BY_HAND, "modest": MODEST}[name]
    A = robustness._matrix(EQS, chosen)
    turns = np.exp(1j * np.radians(0.999 * found.phase) * np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]]))
    ends = np.array([[x, y] for x in (found.lower, found.upper) for y in (found.lower, found.upper)])
    for factors in (turns, ends):
        assert np.linalg.eigvals(simultaneous_margins.scaled(A, factors)).real.max() < 0
    for actuator in robustness.ACTUATORS:
        single = robustness.margins(EQS, chosen, actuator)
        assert single.lower < found.lower
        assert found.upper < single.upper
    assert found.one_down < found.lower
    size = np.abs(2 * (found.upper - 1) / (found.upper + 1))
    assert size == pytest.approx(found.disk)
    assert found.lower * found.upper == pytest.approx(1)
    turned = np.exp(1j * np.radians(found.phase))
    assert np.abs(2 * (turned - 1) / (turned + 1)) == pytest.approx(found.disk)


def test_simultaneous_margins_want_a_stable_loop():
    with pytest.raises(ValueError, match=r"gains in together: got a loop with a root at 1\.26 1/s"):
        simultaneous_margins.together(EQS, BY_HAND | {"kK_z": 0.0, "K_A": 1.0})
