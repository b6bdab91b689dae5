"""The live views' models: what Python sends, random states, and a page with the scripts of `js/maths`."""

import json
import math
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page, Route
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from conftest import cases
from rlswaim.explorers.control_systems import payload
from rlswaim.explorers.system_views import VIEWS
from rlswaim.source.tables import script

EQUATIONS = {"data": rl.perturbation_equations(rl.swaim_booster()), "printed": rl.printed_equations()}
EQS = EQUATIONS["printed"]
MATHS = (
    "closed_loop",
    "compensated",
    "compensator",
    "cut_loop",
    "frequency_response",
    "gain_at",
    "locus",
    "loop_modes",
    "margins",
    "mode_shape",
    "open_loop",
    "responses",
)
SCRIPTS = "http://127.0.0.1/maths/"
VIEW = {"left": -12.0, "right": 4.0, "bottom": -1.0, "top": 13.0, "scale": 40.0, "tolerance": 0.25}
COUNT = cases(300)
"""So many random states of each view, 2,000 with `make fuzz`."""
sections = pytest.mark.parametrize("section", VIEWS)


@cache
def forms(section: str, equations: str = "printed"):
    return VIEWS[section].system.forms(EQUATIONS[equations])


@cache
def sent(section: str) -> dict:
    """Return the payload as the browser gets it."""
    view, polynomial = VIEWS[section], forms(section).polynomial
    return {
        **json.loads(json.dumps(payload(view, EQS, polynomial))),
        "terms": [term._asdict() for term in polynomial.terms],
        "parameters": [{"name": p.name, "grid": p.grid} for p in view.parameters(EQS)],
    }


@cache
def states(section: str, count: int = COUNT, seed: int = 1964) -> list[dict]:
    """Return random places of all sliders."""
    rng = np.random.default_rng(seed)
    parameters = VIEWS[section].parameters(EQS)
    return [{p.name: p.grid[rng.integers(len(p.grid))] for p in parameters} for _ in range(count)]


@cache
def loops(section: str) -> list[control.StateSpace]:
    """Return the library's closed loops at the random states."""
    return [VIEWS[section].closed_loop(EQS, **state) for state in states(section)]


def presets_of(section: str) -> list[dict]:
    return [preset["values"] for preset in sent(section)["presets"]]


def factors_at(section: str, state: dict) -> dict[str, float]:
    """Return the factors of the form at a state, as the browser takes them: straight between two feet."""
    values = {name: state[name] for name in VIEWS[section].gains}
    for factor, shape in sent(section)["shapes"].items():
        values[factor] = np.interp(state[shape["at"]], np.arange(421), shape["values"])
    if state.get("feedback") == "rigid body":
        values |= {"sigma_1": 0.0, "sigma_2": 0.0}
    return values


def sizes(form, values: dict[str, float]) -> np.ndarray:
    """Return the sum of the sizes of a form's terms: rounding is in proportion to it where terms cancel."""
    total = np.zeros(max((len(t.coefficients) for t in form.terms), default=1))
    for term in form.terms:
        weight = math.prod(values[f] for f in term.factors)
        total[: len(term.coefficients)] += abs(weight * np.array(term.coefficients))
    return total


def _send_script(route: Route) -> None:
    """Answer a request for a script of `js/maths` with its text, and one for the folder with a blank page."""
    name = route.request.url.removeprefix(SCRIPTS)
    if name:
        route.fulfill(content_type="text/javascript", body=script("js", "maths", name))
    else:
        route.fulfill(content_type="text/html", body="<!doctype html>")


def run(page: Page, body: str, section: str, *arguments: object):
    """Evaluate a function of a section's system and more in the page; typed arrays come back as lists."""
    wrapped = f"""([section, ...given]) => JSON.stringify(({body})(systems[section], ...given),
        (key, value) => (ArrayBuffer.isView(value) ? [...value] : value))"""
    return json.loads(page.evaluate(wrapped, [section, *arguments]))


def points(found: dict) -> np.ndarray:
    return np.array(found["x"]) + 1j * np.array(found["y"])


def order_of(found: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return the wanted roots in the order of the found ones, by the pairing of least distance."""
    return wanted[linear_sum_assignment(abs(found[:, None] - wanted))[1]]


@contextmanager
def maths_page(browser: Browser) -> Iterator[Page]:
    """Open a blank page with what the models' scripts export as `module`."""
    page = browser.new_page()
    page.route(f"{SCRIPTS}**", _send_script)
    page.goto(SCRIPTS)
    page.evaluate(
        """async ([names, systems]) => {
             const modules = await Promise.all(names.map((name) => import(`./${name}.js`)));
             Object.assign(globalThis, { module: Object.assign({}, ...modules), systems });
           }""",
        [MATHS, {section: sent(section) for section in VIEWS}],
    )
    yield page
    page.close()
