"""The workbench's card of criteria beside `practice.criteria`, row by row, to the digits that it shows."""

import math
import re

import numpy as np
import pytest

from criteria_rows import ROWS, agree
from rlswaim.explorers.criteria_card import BENDING, STATIONS
from rlswaim.practice import criteria
from standin import opened, show
from workbench_page import EQUATIONS, VIEWS

CARD = "details[data-panel=criteria]"
DRAWS = 3


def designs(section):
    """Return the designs of a section by name."""
    return {preset["name"]: preset["values"] for preset in VIEWS[section](EQUATIONS).payload["presets"]}


def scaled(section, rng, values):
    """Return values with each gain off by up to a fifth."""
    gains = [name for name in values if name[0] in "Kkb"]
    return values | {name: values[name] * rng.uniform(0.8, 1.25) for name in gains}


def is_stable(explorer, values):
    for name, value in values.items():
        setattr(explorer, name, value)
    return explorer.poles().real.max() <= criteria.STABLE


def stable_draws(section):
    """Return a few random stable loops of a section, drawn with a seed."""
    rng, explorer, found = np.random.default_rng(1964), VIEWS[section](EQUATIONS), []
    known = list(designs(section).values())
    for _ in range(2000):
        values = scaled(section, rng, known[rng.integers(len(known))])
        if section != "VII":
            values |= {"q_D": float(rng.uniform(1, 200)), "C_payload": float(rng.uniform(0, 0.5))}
            values |= {"gravity": str(rng.choice(["left out", "kept"]))}
        if is_stable(explorer, values):
            found.append(values)
        if len(found) == DRAWS:
            return found
    raise AssertionError(f"{section}: got {len(found)} stable loops, wanted {DRAWS}")


@pytest.fixture(scope="module", params=list(VIEWS))
def card(request, browser):
    """A workbench with its card open, and what the card shows at given values."""
    explorer = VIEWS[request.param](EQUATIONS)
    with opened(browser, explorer) as page:
        page.evaluate(f"document.querySelector('{CARD}').open = true")

        def at(values):
            for name, value in values.items():
                setattr(explorer, name, value)
            show(page, **explorer.values())
            page.locator(CARD).evaluate("card => card.dispatchEvent(new Event('toggle'))")
            return page.locator(f"{CARD} tbody tr").evaluate_all(ROWS)

        yield request.param, explorer, page, at


def test_designs_are_judged_as_python_does(card):
    section, explorer, _, at = card
    for name, values in designs(section).items():
        start = explorer.payload["initial"]
        shown = at(start | values)
        agree(shown, explorer.criteria())
        assert name != "Search, modest jet" or all(row[2] != "none" for row in shown)


def test_random_stable_loops_are_judged_as_python_does(card):
    section, explorer, _, at = card
    for values in stable_draws(section):
        shown = at(explorer.payload["initial"] | values)
        found = explorer.criteria()
        assert all(not math.isnan(c.value) for c in found)
        agree(shown, found)


def test_loop_that_is_not_stable_has_no_margins(card):
    _, explorer, page, at = card
    rows = {row[0]: row for row in at(explorer.payload["initial"] | {"K_A": -900.0})}
    assert "not stable" in page.locator(f"{CARD} p.criteria").inner_text()
    assert rows["disk"][2:] == ["none", "≥\N{NO-BREAK SPACE}0.5", "not met"]
    assert rows[f"moment {STATIONS[0]:g}"][2:] == ["without end", "", "nothing asked"]
    assert rows["settling"][2] == "not within 60 s"


def test_names_are_typeset_and_modes_have_pythons_names(card):
    _, explorer, page, at = card
    at(explorer.payload["initial"])
    labels = page.locator(f"{CARD} tbody th").all_inner_texts()
    assert labels[:2] == ["θ settles", "α with the gust, largest"]
    assert not any(re.search(r"[A-Za-z]_|\b(alpha|theta|delta)\b", label) for label in labels)
    assert {label.split(":")[0] for label in labels if ":" in label} == {"rigid", "aero", *BENDING}
