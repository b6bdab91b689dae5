"""The live views on the built pages: where each stands, what it shows, and the library's answer beside it."""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from playwright.sync_api import Locator, Page

import rlswaim as rl
from exact import exact_roots, paired
from rlswaim import explorers
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial
from rlswaim.vehicle import trajectory

SCREENSHOTS = Path(__file__).parent.parent / "screenshots"
PAGES = {
    "bent-vehicle": "book/01-equations-of-motion.html",
    "trajectory": "book/02-trajectory-and-modes.html",
    "coupling": "book/03-forward-loop.html",
    "rate-attitude": "book/04-rate-and-attitude-feedback.html",
    "single-sensor": "book/05-single-sensor.html",
    "two-sensor": "book/06-two-sensors.html",
    "dual-actuation": "book/07-dual-actuation.html",
    "station-map": "book/07-dual-actuation.html",
    "comparison": "book/08-conclusions.html",
    "peak-bound": "book/15-limits-of-performance.html",
    "greensite": "book/18-another-vehicle.html",
    "whole-burn": "book/19-whole-burn.html",
}
MORE = {
    "book/16-designs-and-loads.html": ("dual-actuation",),
    "book/17-ladder-of-models.html": ("dual-actuation",),
    "book/18-another-vehicle.html": ("rate-attitude",),
}
"""Views of other systems, which have pages of their own, that stand on a page too."""
ON_PAGES = {
    path: tuple(name for name, at in PAGES.items() if at == path) + MORE.get(path, ())
    for path in sorted({*PAGES.values(), *MORE})
}
"""All views with sliders or pictures of their own by page, but for that of one's own loop."""
WORKBENCHES = ("rate-attitude", "single-sensor", "two-sensor", "dual-actuation")
BOOSTER, EQUATIONS = rl.swaim_booster(), rl.printed_equations()
ASCENT = trajectory.swaim_ascent()
MAKERS: dict[str, Callable[[], Any]] = {
    "bent-vehicle": lambda: explorers.bent_vehicle_explorer(BOOSTER),
    "trajectory": lambda: explorers.ascent_explorer(ASCENT, BOOSTER.flight),
    "coupling": lambda: explorers.coupled_vehicle_explorer(BOOSTER),
    "rate-attitude": lambda: explorers.rate_attitude_explorer(EQUATIONS),
    "single-sensor": lambda: explorers.single_sensor_explorer(EQUATIONS),
    "two-sensor": lambda: explorers.two_sensor_explorer(EQUATIONS),
    "dual-actuation": lambda: explorers.dual_actuation_explorer(EQUATIONS),
    "station-map": lambda: explorers.station_map_explorer(EQUATIONS),
    "comparison": lambda: explorers.comparison_explorer(EQUATIONS),
    "peak-bound": explorers.peak_bound_explorer,
    "greensite": explorers.greensite_explorer,
    "whole-burn": explorers.frozen_poles_explorer,
}
library = cache(lambda name: MAKERS[name]())
"""The view in Python: its parameters, and what the library computes at their values."""

ROWS = """table => [...table.tBodies[0].rows].map(row =>
  [[...row.cells].map(cell => cell.textContent.trim()), { ...row.dataset }])"""
NEXT = """() => { window.drawn = new Promise(done =>
  document.addEventListener('rlswaim:drawn', event => done(event.detail.ms), { once: true })); }"""
WAIT = "() => Promise.race([window.drawn, new Promise(late => setTimeout(late, 5000))])"
SHOWN = """panel => [[...panel.querySelectorAll('.widget-hbox input')].map(box => box.value),
  [...panel.querySelectorAll('.widget-toggle-buttons .mod-active')].map(on => on.textContent.trim())]"""
MOVE = """async (panel, [row, values, table]) => {
  const box = panel.querySelectorAll('.widget-hbox')[row].querySelector('input');
  const found = [];
  for (const value of values) {
    const drawn = new Promise(done => panel.addEventListener('rlswaim:drawn', done, { once: true }));
    box.value = value;
    for (const kind of ['input', 'change']) box.dispatchEvent(new Event(kind, { bubbles: true }));
    const late = new Promise((_, stop) => setTimeout(() => stop(`${value}: not drawn`), 5000));
    await Promise.race([drawn, late]);
    found.push([...panel.querySelector(table).tBodies[0].rows].map(row =>
      [[...row.cells].map(cell => cell.textContent.trim()), { ...row.dataset }]));
  }
  return found;
}"""

Row = tuple[list[str], dict[str, str]]


def number(text: str) -> float:
    """Return a number as the views write it: −1,234.5 or 6.7·10⁻⁴."""
    digits = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")
    return float(re.sub(r"·10(?=[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])", "e", text).replace(",", "").translate(digits))


def relative_mismatch(found: Sequence[complex], loop: Any) -> float:
    """Return the largest relative distance of the poles found from a loop's; those below 1e-9 count as that.

    The library's eigenvalues are rounded like any; where they differ, its matrix decides, to fifty digits.
    """
    ours, wanted = np.asarray(found), loop.poles()
    assert ours.size == wanted.size, f"got {ours.size} poles, wanted {wanted.size}"
    close = _largest(ours, wanted)
    return close if close < 1e-6 else _largest(ours, exact_roots(characteristic_polynomial(loop.A)))


def _largest(ours: np.ndarray, wanted: np.ndarray) -> float:
    wanted = paired(ours, wanted)
    return float((abs(ours - wanted) / np.maximum(abs(wanted), 1e-9)).max())


class LivePage(NamedTuple):
    """A live view on its page, with its sliders."""

    name: str
    page: Page
    root: Locator
    panel: Locator

    @property
    def view(self) -> Any:
        """The view in Python."""
        return library(self.name)

    def redrawn(self, act: Callable[[], object]) -> float:
        """Do something and return how long the redraw that follows took (ms)."""
        self.page.evaluate(NEXT)
        act()
        ms = self.page.evaluate(WAIT)
        assert isinstance(ms, (int, float)), "nothing was drawn"
        return ms

    def control(self, name: str) -> Locator:
        """Return the row of a parameter: its slider and box, or its buttons."""
        choices = [p.name for p in self.beside() if isinstance(p.grid[0], str)]
        if name in choices:
            return self.panel.locator(".widget-toggle-buttons").nth(choices.index(name))
        return self.panel.locator(".widget-hbox").nth(self.numbers().index(name))

    def numbers(self) -> list[str]:
        """Return the parameters with sliders."""
        return [p.name for p in self.beside() if not isinstance(p.grid[0], str)]

    def beside(self) -> list[Any]:
        """Return the parameters whose controls are widgets beside the view."""
        return [p for p in self.view.parameters if not p.folded]

    def values(self) -> dict[str, Any]:
        """Return the parameters as the page shows them: those in the boxes, and the buttons pressed."""
        boxes, pressed = map(iter, self.panel.evaluate(SHOWN))
        return {
            p.name: next(pressed) if isinstance(p.grid[0], str) else type(p.grid[0])(next(boxes))
            for p in self.beside()
        }

    def library_at(self, values: dict[str, Any] | None = None) -> Any:
        """Return the view in Python at these values, or at those that the page shows."""
        for name, value in (values or self.values()).items():
            setattr(self.view, name, value)
        return self.view

    def press(self, name: str) -> None:
        """Press a button of the view and wait until it is drawn."""
        self.redrawn(self.root.get_by_role("button", name=name, exact=True).click)

    def reset(self) -> None:
        """Go back to the start."""
        self.root.get_by_role("button", name="Reset", exact=True).first.click()
        self.page.evaluate(
            "() => new Promise(next => requestAnimationFrame(() => requestAnimationFrame(next)))"
        )

    def moved(self, name: str, values: Sequence[float], table: str) -> list[list[Row]]:
        """Put values in a box, one after the other; return the rows of a table after each."""
        return self.panel.evaluate(MOVE, [self.numbers().index(name), list(values), table])

    def rows(self, table: str) -> list[Row]:
        """Return the rows of a table: texts and data."""
        return self.root.locator(table).first.evaluate(ROWS)


@contextmanager
def live(visit: Callable, name: str, anchor: str = "", at: str = "") -> Iterator[LivePage]:
    """Open a live view on its page or on ``at``; anything asked from outside and any error is a failure."""
    with visit(f"{at or PAGES[name]}{anchor}", plain=True) as (page, outside, errors):
        root = page.locator(f"[data-explorer='{name}']").first
        root.wait_for()
        root.scroll_into_view_if_needed()
        panel = page.locator(".live-view", has=page.locator(f"[data-explorer='{name}']")).first
        yield LivePage(name, page, root, panel)
        assert (outside, errors) == ([], []), (outside, errors)


def poles_of(rows: Sequence[Row]) -> list[complex]:
    """Return the poles of a table from their text, its other columns checked against them."""
    found = []
    for (_, *texts, stability), _ in rows:
        real, imaginary, omega, zeta = (float("nan") if text == "–" else float(text) for text in texts)
        pole = complex(real, imaginary)
        found.append(pole)
        assert abs(omega - abs(pole)) <= 1e-6 * abs(pole), texts
        assert pole == 0 or abs(zeta + pole.real / abs(pole)) <= 1e-6, texts
        wanted = "unstable" if pole.real > 0 else "stable" if pole.real < 0 else "neutrally stable"
        assert stability == wanted, texts
    return found
