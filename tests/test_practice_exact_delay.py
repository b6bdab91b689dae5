"""The exact delay: roots against the exact frequency response, and against loops whose roots are known."""

import control
import numpy as np
import pytest
from scipy.special import lambertw

from rlswaim.practice import conclusions_on_rungs as judged
from rlswaim.practice import exact_delay as exact
from rlswaim.practice.ladder import Rung, dual_actuation_on
from rlswaim.practice.ladder_search import SEARCHED, modest_gains, stored
from rlswaim.practice.margins import margins
from rlswaim.practice.rungs import Step, ladder_steps

STEP = ladder_steps()[exact.RUNG]
T = STEP.rung.delay
SECTIONS = [(s, stored()[exact.RUNG, s].gains) for s in SEARCHED]


def test_parts_add_up_and_the_late_one_goes_from_effectors_to_the_vehicle():
    loop = SEARCHED["VII"].closed_loop(Step(STEP.eqs, Rung()), **SECTIONS[3][1])
    A, B = exact.parted(loop)
    assert np.allclose(A + B, loop.A)
    assert np.linalg.matrix_rank(B) == 2
    vehicle = STEP.eqs.state_space(modest_gains()["jet"])
    gained = B[:7][:, [list(loop.state_labels).index(f"{name}_x[0]") for name in exact.EFFECTORS]]
    for column, force in zip(gained.T, vehicle.B[:, :2].T, strict=True):
        assert abs(column @ force) == pytest.approx(np.linalg.norm(column) * np.linalg.norm(force))


@pytest.mark.parametrize(("section", "gains"), SECTIONS, ids=list(SEARCHED))
def test_each_root_solves_the_loop_s_own_equation(section, gains):
    """None is missed, and the largest real part is near that with Pade's approximation."""
    value, missed = exact.rightmost(STEP, section, gains)
    assert missed == 0
    A, B = exact.parted(SEARCHED[section].closed_loop(Step(STEP.eqs, Rung()), **gains))
    near = exact.delayed_roots(A, B, T)
    for s in near[near.real > -5]:
        smallest = np.linalg.svd(s * np.eye(len(A)) - A - np.exp(-s * T) * B, compute_uv=False)[-1]
        assert smallest < 1e-9 * (1 + abs(s))
    # Where IV is best, three roots nearly meet: floats fix a third of their digits.
    assert value == pytest.approx(stored()[exact.RUNG, section].abscissa, abs=1e-4)


def test_roots_are_near_those_with_pade():
    """A Pade approximation of order n is off by some (s T)^(2 n + 1)."""
    assert 0 < exact.farthest_from_pade() < 1e-5


@pytest.mark.parametrize("seconds", [0.02, 0.1, 0.25, 0.5])
def test_border_is_that_of_the_delay_margin(seconds):
    """The engine alone being late, the loop is stable exactly below the margin of its frequency response."""
    gains = modest_gains()
    loop = dual_actuation_on(STEP.eqs, Rung(), **gains)
    _, late = exact.parted(loop.closed)
    c = loop.closed
    names = [name.replace("jet", "prompt") for name in c.state_labels]
    only_engine = control.ss(c.A, c.B, c.C, c.D, states=names)
    border = min(m.delay for m in margins(loop.open).phase)
    assert np.count_nonzero(exact.parted(only_engine)[1]) < np.count_nonzero(late)
    A, B = exact.parted(only_engine)
    right = exact.roots_right_of(A, B, seconds, 1e-3)
    assert (right == 0) == (seconds < border)
    assert right == (exact.delayed_roots(A, B, seconds).real > 1e-3).sum()


@pytest.mark.parametrize(("a", "b"), [(0.5, -2.0), (-1.0, 3.0), (0.2, -40.0)])
def test_roots_of_one_state(a, b):
    """By Lambert's function: s = a + W(b T exp(-a T))/T, all branches."""
    A, B = np.array([[a]]), np.array([[b]])
    wanted = np.array([a + lambertw(b * T * np.exp(-a * T), k) / T for k in (0, -1, 1)])
    found = exact.delayed_roots(A, B, T)
    for root in wanted[np.abs(wanted) * T < 10]:
        assert np.abs(found - root).min() < 1e-9 * (1 + abs(root))
    line = max(wanted.real) - 0.1
    assert exact.roots_right_of(A, B, T, line) == (wanted.real > line).sum()


def test_cells():
    row, pade = exact.cells(), judged.cells()[exact.RUNG]
    assert list(row) == list(judged.CONCLUSIONS)
    for name, cell in row.items():
        assert cell.verdict == pade[name].verdict
        # The root with the jet alone is larger than any other here, and Pade's delay less exact there.
        assert cell.number == pytest.approx(pade[name].number, abs=1e-3 if name == "jet" else 1e-4)


def test_bad_delay():
    with pytest.raises(ValueError, match="T in delayed_roots: got -1"):
        exact.delayed_roots(np.eye(2), np.eye(2), -1.0)
