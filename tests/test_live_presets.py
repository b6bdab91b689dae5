"""Each preset of a live view on the built book: its values, its roots, and the printed ones beside them."""

import numpy as np
import pytest

from live_tables import SLID, TABLES, assert_rows, every
from livepage import EQUATIONS, WORKBENCHES, poles_of
from rlswaim.explorers import designs
from rlswaim.explorers.presets import corrected_designs
from rlswaim.loops.rigid_body_design import rigid_body, rigid_design

SECTIONS = dict(zip(WORKBENCHES, ("IV", "V", "VI", "VII"), strict=True))
REPRODUCED = {"Figure 8", "Figure 11", "Eq. 78", "Eq. 80", "Eq. 82"}
"""Designs whose printed roots are those of their gains; the others' are errata of the report."""


@every(*SLID)
def test_each_preset_sets_its_values(fresh):
    assert len(fresh.view.payload["presets"]) >= 3
    for preset in fresh.view.payload["presets"]:
        button = fresh.root.get_by_role("button", name=preset["name"], exact=True)
        button.click()
        fresh.page.wait_for_function(
            "button => button.getAttribute('aria-pressed') === 'true'", arg=button.element_handle()
        )
        view = fresh.library_at()
        assert view.values() == {**view.values(), **preset["values"]}
        assert_rows(fresh.name, fresh.rows(TABLES[fresh.name]), view)


@every(*WORKBENCHES)
def test_each_preset_tells_the_printed_roots_beside_its_own(fresh):
    section = SECTIONS[fresh.name]
    corrected = corrected_designs(section, EQUATIONS)
    assert [p["name"] for p in fresh.view.payload["presets"]] == [*designs(section), *corrected]
    for preset in fresh.view.payload["presets"]:
        fresh.press(preset["name"])
        words = fresh.root.locator(".crossings").inner_text()
        button = fresh.root.get_by_role("button", name=preset["name"], exact=True)
        assert button.get_attribute("title").endswith(
            "corrected" if preset["name"] in corrected else "as printed"
        )
        if not preset["printed"]:
            assert "Printed roots" not in words
            continue
        printed = np.array([complex(r["re"], r["im"]) for r in preset["printed"]])
        poles = np.array(poles_of(fresh.rows("table.poles")))
        off = abs(printed[:, None] - poles).min(axis=1) > 0.05 * np.maximum(abs(printed), 0.1)
        if preset["name"] in REPRODUCED:
            assert not off.any(), preset["name"]
            assert (
                f"Printed roots (+): {len(printed)}, all within a plot’s reading of the roots here." in words
            )
        else:
            assert f"Printed roots (+): {len(printed)}, of which " in words
            assert " more than a plot’s reading off: " in words
            if preset["locus"] == len(fresh.view.payload["loci"]) - 1:  # the whole loop, as in the table
                assert f"of which {off.sum()} more" in words


@every("rate-attitude")
def test_the_corrected_design_is_that_of_the_corrected_equation(fresh):
    fresh.press("Eq. 75, divided by U")
    wanted = rigid_design(rigid_body(EQUATIONS), omega=2, zeta=0.5, K_C=10)
    assert fresh.values()["K_A"] == pytest.approx(wanted.K_A, rel=1e-9)
    assert fresh.values()["K_R"] == pytest.approx(wanted.K_R, rel=1e-9)
