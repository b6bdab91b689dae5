"""Greensite's vehicle on the workbench: its polynomials, poles and call are those of the library."""

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from criteria_rows import ROWS, agree
from rlswaim import explorers
from rlswaim.explorers import greensite as view
from rlswaim.loops.multiaffine import forms
from rlswaim.practice.greensite import closed_loop, greensite
from standin import opened, paired, show, table

DRAWS = np.random.default_rng(72)


@pytest.mark.parametrize("notch", [True, False])
def test_polynomial_and_numerators_are_those_of_the_closed_loop(notch):
    found = forms(view.family(notch), tuple(view.UNITS))
    for _ in range(20):
        gains = dict(
            zip(view.GAINS, DRAWS.uniform([-3, -3, -0.01, -0.01, 0.1], [3, 3, 0.01, 0.01, 3]), strict=True)
        )
        omega = DRAWS.uniform(0.8, 1.2)
        loop = closed_loop(notch=notch, omega=omega, **gains)
        factors = {**gains, "omega_1": omega, "omega_2": omega**2}
        D = np.polynomial.Polynomial(found.polynomial(**factors))
        ours, theirs = paired(loop.poles(), D.roots())
        assert np.all(abs(ours - theirs) <= 1e-8 * np.maximum(1, abs(ours)))
        for name, form in found.numerators["alpha_w"].items():
            N = np.polynomial.Polynomial(form(**factors))
            for s in (0.3j, 5j, 18j):
                exact = complex(loop(s)[loop.output_labels.index(name), 0])
                assert abs(N(s) / D(s) - exact) <= 1e-8 * abs(exact)


@pytest.mark.parametrize("notch", [True, False])
@pytest.mark.parametrize("place", [80, 100, 113])
def test_open_poles_are_those_of_the_open_loop(notch, place):
    sent = view.open_poles(notch)
    poles = np.array([(p["re"] + 1j * p["im"]) * (p["each"][place] if "at" in p else 1) for p in sent])
    loop = greensite(K_p=0.0, K_d=0.0, notch=notch, omega=place / 100).poles()
    ours, theirs = paired(loop, poles)
    assert np.all(abs(ours - theirs) <= 1e-9 * np.maximum(1, abs(ours)))
    assert [p["branch"] for p in sent].count("mode 1") == 2


@pytest.fixture(scope="module")
def page(browser):
    with opened(browser, explorers.greensite_explorer()) as page:
        page.evaluate("[...el.querySelectorAll('details')].forEach((panel) => (panel.open = true))")
        yield page


def test_the_table_follows_python(page):
    explorer = explorers.greensite_explorer()
    for values in ({"K_d": 0.3, "omega": 95}, {"K_z": 0.0, "k": 2.0}, {"K_p": 1.78, "omega": 110}):
        show(page, **values)
        for name, value in values.items():
            setattr(explorer, name, value)
        ours, theirs = paired(explorer.poles(), table(page))
        assert np.all(abs(ours - theirs) <= 1e-8 * np.maximum(1, abs(ours)))


def test_the_printed_design_has_its_printed_margins(page):
    page.get_by_role("button", name="6 dB and 30°", exact=True).click()
    page.wait_for_function("el.querySelector('.crossings').textContent.includes('−6 dB')")
    words = page.locator(".crossings").inner_text()
    assert "+7.56 dB" in words
    assert "+30° (ω" in words


def test_the_call_of_the_library_gives_the_poles_shown(page):
    page.get_by_role("button", name="Mode 5 % up", exact=True).click()
    page.wait_for_function("el.querySelector('[data-panel=takeaway] code').textContent.includes('105 / 100')")
    names: dict = {}
    exec(page.locator("[data-panel=takeaway] code").inner_text(), names)
    ours, theirs = paired(names["loop"].poles(), table(page))
    assert np.all(abs(ours - theirs) <= 1e-6 * np.maximum(1, abs(ours)))
    assert page.locator(".verdict").inner_text().startswith("Unstable")


def test_there_is_a_map_of_the_frequency_and_no_panel_of_the_shape(page):
    page.locator("canvas[data-plane=map]").scroll_into_view_if_needed()
    words = "el.querySelector('[data-panel=map] small').textContent.startsWith('ω from 80 to 120 %')"
    page.wait_for_function(words)
    assert page.locator("[data-panel=mode]").count() == 0
    responses = page.locator("canvas[data-plane=responses]")
    responses.scroll_into_view_if_needed()
    expect(responses).to_have_attribute("aria-label", re.compile("z: largest"))


def test_refused():
    with pytest.raises(ValueError, match=r"omega in greensite explorer: got 79 %, wanted a whole number"):
        explorers.greensite_explorer(omega=79)
    with pytest.raises(ValueError, match="K_p in greensite explorer: got nan"):
        explorers.greensite_explorer(K_p=float("nan"))
    with pytest.raises(TypeError, match="notch in greensite explorer: got int"):
        explorers.greensite_explorer(notch=1)


def at_random(rng, values):
    """Return values with each gain off by up to a fifth, and the mode's frequency lower by up to a tenth."""
    gains = {name: value * rng.uniform(0.8, 1.25) for name, value in values.items() if name != "omega"}
    return gains | {"omega": int(rng.integers(90, 102))}


def cases():
    """Return the designs by name, and loops near them."""
    rng, designs = np.random.default_rng(73), {p["name"]: p["values"] for p in view.presets()}
    near = {f"near {name}": at_random(rng, values) for name, values in designs.items()}
    return designs | near


@pytest.mark.parametrize("values", [pytest.param(values, id=name) for name, values in cases().items()])
def test_the_card_of_criteria_is_that_of_python(page, values):
    explorer = explorers.greensite_explorer()
    for name, value in values.items():
        setattr(explorer, name, value)
    show(page, **values)
    card = page.locator("details[data-panel=criteria]")
    card.evaluate("card => card.dispatchEvent(new Event('toggle'))")
    agree(card.locator("tbody tr").evaluate_all(ROWS), explorer.criteria())
