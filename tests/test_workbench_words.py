"""What a workbench says of margins and of printed roots, while a loop is stable and while it is not."""

import re

import numpy as np
import pytest

from livepage import number
from standin import opened, show, table
from workbench_page import EQUATIONS, VIEWS

PHASE = re.compile(r"([+−]?[\d.]+)° \(ω = ([^ ]+) rad/s\)")


@pytest.fixture
def words(browser, request):
    """What a workbench says of the locus at some values."""
    with opened(browser, VIEWS[request.param](EQUATIONS)) as page:

        def told(**values: object) -> str:
            show(page, **values)
            return page.locator(".crossings").inner_text()

        told.page = page
        yield told


@pytest.mark.parametrize("words", ["VII"], indirect=True)
def test_margins_while_the_loop_is_stable_and_only_then(words):
    page = words.page
    page.get_by_role("button", name="Search, modest jet", exact=True).click()
    seen = set()
    for K_A in np.geomspace(0.3, 300, 24).round(4):
        said = words(K_A=K_A)
        stable = bool((table(page).real < 0).all())
        seen.add(stable)
        if not stable:
            assert "Phase margins: none, as this loop is not stable. Gain margins: none." in said
            assert "Delay margin" not in said
            continue
        gains = [abs(number(dB)) for dB in re.findall(r"([+−][\d.]+) dB", said)]
        assert gains == sorted(gains)
        phases = [(number(degrees), number(omega)) for degrees, omega in PHASE.findall(said)]
        assert [abs(p) for p, _ in phases] == sorted(abs(p) for p, _ in phases)
        assert said.index("Phase margins: ") < said.index("Gain margins: ")
        delays = [np.radians(degrees % 360) / omega for degrees, omega in phases]
        told = re.search(r"Delay margin: (\S+) s\.", said)
        assert bool(delays) == bool(told)
        if delays:
            assert number(told[1]) == pytest.approx(min(delays), rel=0.02)
    assert seen == {True, False}


@pytest.mark.parametrize("words", ["IV"], indirect=True)
def test_printed_roots_only_beside_their_own_design(words):
    page = words.page
    page.wait_for_function("el.querySelector('.crossings').innerText.includes('Printed roots (+)')")
    before = page.evaluate("state.K_A")
    assert "Printed roots" not in words(K_A=before * 1.1)
    assert "Printed roots (+)" in words(K_A=before)
