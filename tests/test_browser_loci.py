"""The root loci and pole maps that the browser draws are those of the library."""

from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import rlswaim as rl
from browser_maths import EQS, VIEW, maths_page, order_of, points, presets_of, run, sections, sent, states
from rlswaim.explorers.system_views import VIEWS
from rlswaim.loops.closures import JetLoop, theta_numerator
from rlswaim.rootlocus.polynomials import roots
from running_value import loci_of, polynomial_along


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


def roots_at(p: np.ndarray) -> np.ndarray:
    """Return roots for a picture."""
    return roots(np.where(abs(p) > 1e-15 * abs(p).max(), p, 0.0) if abs(p[-1]) < 1e-15 * abs(p).max() else p)


def roots_of_all(polynomials: np.ndarray) -> np.ndarray:
    """Return the roots for a picture of one polynomial a row, rows filled up with nan."""
    sizes_ = abs(polynomials).max(axis=1, keepdims=True)
    degrees = (np.arange(polynomials.shape[1]) * (abs(polynomials) > 1e-15 * sizes_)).max(axis=1)
    found = np.full((len(polynomials), polynomials.shape[1] - 1), np.nan, dtype=complex)
    for n in set(degrees.tolist()):
        rows = degrees == n
        companion = np.zeros((rows.sum(), n, n))
        companion[:, 1:, :-1] = np.eye(n - 1)
        companion[:, :, -1] = -polynomials[rows, :n] / polynomials[rows, n : n + 1]
        found[rows, :n] = np.linalg.eigvals(companion)
    return found


DRAWN = """(system, ...given) => {
  const { kind, end, branches } = module.rootLocus(system, ...given);
  return { kind, end, t: branches.map((p) => p.t), x: branches.map((p) => p.x), y: branches.map((p) => p.y) };
}"""


@sections
class TestLoci:
    def test_are_true_to_half_a_pixel(self, page, section):
        """Every root at values between the points drawn lies on its own branch as drawn."""
        count = 0
        for state in [*presets_of(section), *states(section, 4, seed=3)]:
            for what in loci_of(section):
                locus = run(page, DRAWN, section, state, VIEW, what)
                p = polynomial_along(section, state, what)
                assert locus["t"][0] == 0
                assert locus["t"][-1] == locus["end"]
                places, drawn = np.array(locus["t"]), points(locus)
                (a, b), share = (places[:-1], places[1:]), 0.37
                linear = (a * b == 0) | (locus["kind"] == "station")
                ratio = np.where(linear, 1, b / np.where(a == 0, 1, a))
                exact = roots_of_all(p(np.where(linear, a + share * (b - a), a * ratio**share)))
                across = (exact.real > VIEW["left"]) & (exact.real < VIEW["right"])
                seen = across & (abs(exact.imag) < VIEW["top"])
                start, end = drawn[:-1, None, :], drawn[1:, None, :]
                chord = np.where(end == start, 1e-300, end - start)
                along = np.clip(((exact[:, :, None] - start) / chord).real, 0, 1)
                miss = abs(exact[:, :, None] - start - along * (end - start)).min(axis=2)
                assert (miss[seen] * VIEW["scale"] < 0.5).all(), (state, what)
                count += seen.sum()
        assert count > 1000

    def test_break_aways_and_crossings_are_those_of_the_library(self, page, section):
        breaks = crossings = 0
        for state in presets_of(section):
            for what in [w for w in sent(section)["loci"] if w["of"] == "poles"]:
                locus = run(page, "module.rootLocus", section, state, VIEW, what)
                breaks, crossings = breaks + len(locus["breaks"]), crossings + len(locus["crossings"])
                p, end = polynomial_along(section, state, what), locus["end"]
                D = p(0.0)
                N = (p(end) - D) / end  # a small gain would leave little of N beside D
                tf = control.tf(N[::-1].tolist(), D[::-1].tolist())
                theirs = rl.root_locus(tf, gains=[0.0])
                ours = sorted(b.gain for b in theirs.break_aways if 0 < b.gain / end < 1)
                assert len(locus["breaks"]) == len(ours)
                for broken in locus["breaks"]:
                    at = complex(broken["x"], broken["y"])
                    two = np.sort(abs(roots(p(broken["gain"])) - at))[:2]
                    assert two.max() <= 1e-5 * abs(at)  # a double root, found to half the digits
                ours = sorted((c.gain, c.omega) for c in theirs.crossings if 0 < c.gain / end < 1)
                found = sorted((c["gain"], c["omega"]) for c in locus["crossings"])
                assert np.array(found) == pytest.approx(np.array(ours), rel=1e-6)
        assert (breaks, crossings) == {"IV": (18, 9), "V": (3, 5), "VI": (8, 12), "VII": (15, 8)}[section]

    def test_stations_where_a_branch_crosses_the_axis(self, page, section):
        count = 0
        for state in [*presets_of(section), *states(section, 12, seed=5)]:
            for station in sent(section)["maps"]:
                what = {"running": station, "off": [], "of": "poles"}
                locus = run(page, "module.rootLocus", section, state, VIEW, what)
                p = polynomial_along(section, state, what)
                for crossing in locus["crossings"]:
                    count += 1
                    exact = roots(p(crossing["gain"]))
                    at = abs(exact - 1j * crossing["omega"]).argmin()
                    assert abs(exact[at] - 1j * crossing["omega"]) < 1e-6 * (1 + abs(exact[at]))
                before, after = (roots(p(t)) for t in (0.0, 420.0))
                gained = sum(c["direction"] * (2 if c["omega"] > 1e-6 else 1) for c in locus["crossings"])
                assert (after.real > 1e-13).sum() - (before.real > 1e-13).sum() == gained
        assert count > 3

    def test_labels_do_not_depend_on_the_window(self, page, section):
        """But where two branches all but meet: at most one locus in fifty."""
        close, wrong, count = {**VIEW, "left": -0.3, "right": 0.1, "top": 0.3, "scale": 1000}, 0, 0
        for what in loci_of(section):
            found = run(
                page,
                """(s, all, views, w) =>
                     all.map((x) => views.map((v) => module.rootLocus(s, x, v, w).branches.at(-1)))""",
                section,
                [*presets_of(section), *states(section, 20, seed=7)],
                [VIEW, close],
                what,
            )
            count += len(found)
            wrong += sum(not np.allclose(points(a), points(b), rtol=1e-3, atol=1e-3) for a, b in found)
        assert wrong <= 0.02 * count

    def test_the_value_at_a_point_of_a_branch_is_found_again(self, page, section):
        for state in presets_of(section):
            for what in loci_of(section):
                asked = run(
                    page,
                    """(s, x, view, w) => {
                         const locus = module.rootLocus(s, x, view, w);
                         return [3, 5].map((i) => {
                           const p = locus.branches[Math.floor((locus.branches.length * i) / 9)];
                           const branch = Math.min(i, p.x.length - 1);
                           const t = module.gainAt(s, x, w, branch, p.x[branch], p.y[branch], locus);
                           return { t, branch, re: p.x[branch], im: p.y[branch] };
                         });
                       }""",
                    section,
                    state,
                    VIEW,
                    what,
                )
                p = polynomial_along(section, state, what)
                assert len(asked) == 2
                for point in asked:
                    z = complex(point["re"], point["im"])
                    assert abs(roots_at(p(point["t"])) - z).min() <= 1e-5 * max(abs(z), 1e-2), (state, what)

    def test_pole_maps_end_where_the_library_says(self, page, section):
        for state in presets_of(section):
            for station in sent(section)["maps"]:
                sides = run(
                    page,
                    """(s, x, view, at) =>
                         module.poleMap(s, x, module.closedLoop(s, x), view, at).map((b) => b.at(-1))""",
                    section,
                    state,
                    VIEW,
                    station,
                )
                assert len(sides) == (0 if state.get("feedback") == "rigid body" else 2)
                for end in sides:
                    exact = VIEWS[section].closed_loop(EQS, **{**state, station: end["t"]}).poles()
                    ours = points(end)
                    # Good for a picture; the present poles, above, are good to the last digits.
                    assert (abs(ours - order_of(ours, exact)) < 1e-5 * np.maximum(1, abs(ours))).all()


def test_a_step_that_would_lead_anywhere(page):
    """Two poles and a zero in one place: on the way a correction had a pole, and the page stood still."""
    state = {
        **{"K_A": 0.00841, "K_C": 79.4, "K_R": 0.96, "kK_z": -10700000, "K_r": 79.4, "b": 79.4},
        **{"sensor": 115, "jet": 212},
    }
    locus = run(page, "module.rootLocus", "VII", state, VIEW, sent("VII")["loci"][0])
    assert np.isfinite([[p["x"], p["y"]] for p in locus["branches"]]).all()


def test_closure_2_gives_the_zeros_that_closure_3_runs_to(page):
    for state in [*presets_of("VII"), *states("VII", 30, seed=9)]:
        locus = run(page, "module.rootLocus", "VII", state, VIEW, sent("VII")["loci"][1])
        loop = JetLoop(*(state[name] for name in ("K_r", "b", "sensor", "jet")))
        numerator = theta_numerator(EQS, loop, state["kK_z"])
        numerator = np.where(abs(numerator) > 1e-13 * abs(numerator).max(), numerator, 0)
        rate = [] if state["K_R"] == 0 else [-1 / state["K_R"]]
        wanted, ours = np.append(roots(numerator), rate), points(locus["present"])
        assert ours.size == wanted.size
        assert (abs(ours - order_of(ours, wanted)) <= 1e-6 * np.maximum(1e-3, abs(ours))).all(), state
