"""Each workbench opens with a design that does something: its gains move the poles of the vehicle."""

import pytest

from workbench_page import EQUATIONS, VIEWS


@pytest.mark.parametrize("section", VIEWS)
def test_the_first_design_moves_poles(section):
    view = VIEWS[section](EQUATIONS)
    opened = sorted(view.poles(), key=lambda p: (p.real, p.imag))
    view.K_A = 0
    idle = sorted(view.poles(), key=lambda p: (p.real, p.imag))
    assert max(abs(a - b) for a, b in zip(opened, idle, strict=True)) > 0.01
