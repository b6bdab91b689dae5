"""The live views beside the workbenches, each on a page with a stand-in for the notebook's model."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import numpy as np
from playwright.sync_api import Browser, Page
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim import explorers
from rlswaim.explorers.live_view import LiveView
from rlswaim.vehicle import trajectory
from standin import go_to_empty_page

MODEL = (Path(__file__).parent / "explorer_model.js").read_text(encoding="utf-8")
BOOSTER, PRINTED = rl.swaim_booster(), rl.printed_equations()
ASCENT = trajectory.swaim_ascent()
MAKERS: dict[str, Callable[..., LiveView]] = {
    "bent-vehicle": lambda **values: explorers.bent_vehicle_explorer(BOOSTER, **values),
    "trajectory": lambda **values: explorers.ascent_explorer(ASCENT, BOOSTER.flight, **values),
    "coupling": lambda **values: explorers.coupled_vehicle_explorer(BOOSTER, **values),
    "peak-bound": explorers.peak_bound_explorer,
    "whole-burn": explorers.frozen_poles_explorer,
    "station-map": lambda **values: explorers.station_map_explorer(PRINTED, **values),
}
view_of = cache(lambda name: MAKERS[name]())


def random_states(view: LiveView, count: int, seed: int) -> list[dict]:
    rng = np.random.default_rng(seed)
    return [{p.name: p.grid[rng.integers(len(p.grid))] for p in view.parameters} for _ in range(count)]


def mismatch(ours: np.ndarray, theirs: np.ndarray) -> float:
    """Return the largest distance in the best pairing, relative to the larger of 1 and our root."""
    rows, columns = linear_sum_assignment(abs(ours[:, None] - theirs))
    return float((abs(ours[rows] - theirs[columns]) / np.maximum(1, abs(ours[rows]))).max())


@contextmanager
def opened(browser: Browser, view: LiveView, width: int = 760) -> Iterator[Page]:
    """A page with one view on a stand-in for the notebook's model."""
    page = browser.new_page(viewport={"width": width, "height": 900})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    go_to_empty_page(page)
    places = {f"{p.name}_at": getattr(view, f"{p.name}_at") for p in view.parameters}
    page.evaluate(MODEL, [view._esm, view._css, {**view.values(), **places, "payload": view.payload}])
    yield page
    assert errors == []
    page.close()


def show(page: Page, **values: object) -> dict:
    """Set values of the model and wait for the drawing; they must differ from the present ones."""
    return page.evaluate(
        """async (values) => {
             const done = drawn();
             for (const [name, value] of Object.entries(values)) model.set(name, value);
             return done;
           }""",
        values,
    )
