"""The poles that the browser computes are those of the library's closed loop at the same state.

Where a pole is ill-conditioned, its error is compared with what one rounding of the coefficients'
terms would do to it.
"""

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from scipy.linalg import matrix_balance

from browser_maths import (
    VIEW,
    factors_at,
    forms,
    loops,
    maths_page,
    order_of,
    points,
    presets_of,
    run,
    sections,
    sizes,
    states,
)
from rlswaim.rootlocus.exact_polynomials import exact_characteristic_polynomial

EPS = np.finfo(float).eps


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


def exact_poles(A: np.ndarray, coefficients: np.ndarray) -> np.ndarray:
    """Return a closed loop's poles, polished on its exact coefficients in extended precision."""
    p = np.array(coefficients, dtype=np.longdouble)
    z = np.linalg.eigvals(matrix_balance(A)[0]).astype(np.clongdouble)
    powers = np.arange(p.size)
    for _ in range(3):
        slope = (z[:, None] ** powers[:-1]) @ (p[1:] * powers[1:])
        step = (z[:, None] ** powers) @ p / np.where(slope == 0, 1, slope)
        z = z - np.where(abs(step) < 1e-3 * abs(z), step, 0)
    return z.astype(complex)


@sections
class TestPoles:
    def test_agree_with_python(self, page, section):
        found = run(page, "(s, all) => all.map((x) => module.closedLoop(s, x))", section, states(section))
        for state, loop, js in zip(states(section), loops(section), found, strict=True):
            exact = [float(c) for c in exact_characteristic_polynomial(loop.A)]
            ours = points(js)
            wanted = order_of(ours, exact_poles(loop.A, exact))
            slope = abs(np.polyval(np.polyder(exact[::-1]), wanted))
            rounding = np.polyval(
                sizes(forms(section).polynomial, factors_at(section, state))[::-1], abs(wanted)
            )
            spread = np.minimum(20 * EPS * rounding / np.maximum(slope, 1e-300), 1e-3 * abs(wanted))
            assert (abs(ours - wanted) <= np.maximum(1e-8 * abs(wanted), spread) + 1e-12).all(), state

    def test_without_feedback_of_the_angle_the_attitude_stays_at_the_origin_exactly(self, page, section):
        body = "(s, all) => all.map((x) => module.closedLoop(s, { ...x, K_A: 0 }))"
        for js in run(page, body, section, [*presets_of(section), *states(section)]):
            assert points(js)[js["branches"].index("attitude")] == 0

    def test_names_are_those_of_the_locus_and_lead_back_to_the_open_loop(self, page, section):
        found = run(
            page,
            """(s, all, view) => all.map((x) => {
                 const last = module.rootLocus(s, x, view);
                 const alone = { ...x };
                 for (const gain of s.locus_gains.slice(0, -1)) alone[gain] = 0;
                 return [module.closedLoop(s, x), last.present, last.names,
                         module.rootLocus(s, alone, view).open, module.namedPoles(s, alone)];
               })""",
            section,
            states(section)[:200],
            VIEW,
        )
        for present, drawn, names, back, opened in found:
            assert names == present["branches"]
            assert (points(drawn) == points(present)).all()
            assert back["branches"] == opened["branches"]
            assert abs(points(back) - points(opened)).max() < 1e-6 * (1 + abs(points(opened)).max())
