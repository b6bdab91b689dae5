"""The presets of the workbenches: the report's designs and the corrected ones."""

import math

import pytest

from browser_maths import EQS, sections, sent
from rlswaim.edition import section_4
from rlswaim.explorers.presets import COMPARED, CORRECTED, corrected_designs, designs
from rlswaim.explorers.system_views import VIEWS
from rlswaim.loops.transfer_functions import theta_loop
from rlswaim.source.tables import read_table


class TestPresets:
    @pytest.mark.parametrize(
        ("section", "presets", "loci", "maps", "printed"),
        [("IV", 8, 1, 1, 25), ("V", 3, 2, 1, 1), ("VI", 3, 3, 2, 4), ("VII", 5, 3, 2, 15)],
    )
    def test_every_section_has_its_presets_loci_maps_and_printed_roots(
        self, section, presets, loci, maps, printed
    ):
        """Many tests go through these lists, and would hold of empty ones."""
        found = sent(section)
        assert [len(found[part]) for part in ("presets", "loci", "maps")] == [presets, loci, maps]
        assert sum(len(preset["printed"]) for preset in found["presets"]) == printed
        assert len(designs(section)) + len(corrected_designs(section, EQS)) == presets

    @sections
    def test_values_are_all_parameters_and_on_their_sliders(self, section):
        grids = {p.name: p.grid for p in VIEWS[section].parameters(EQS)}
        for name, values in designs(section).items():
            assert set(values) == set(grids), name
            assert all(value in grids[parameter] for parameter, value in values.items()), name
        assert all(row["source"] for row in read_table("designs"))

    @sections
    def test_each_names_its_locus_and_says_whose_it_is(self, section):
        presets = sent(section)["presets"]
        assert [p["name"] for p in presets][: len(designs(section))] == list(designs(section))
        for preset in presets:
            assert preset["label"]
            assert preset["note"] == ("corrected" if preset["name"] in CORRECTED else "as printed")
            assert 0 <= preset["locus"] < len(sent(section)["loci"])
        assert set(COMPARED.get(section, ())) <= {p["name"] for p in presets}

    def test_printed_roots_of_section_iv_are_those_of_the_closed_loop(self):
        for preset in sent("IV")["presets"]:
            ours = VIEWS["IV"].closed_loop(EQS, **preset["values"]).poles()
            for root in preset["printed"]:
                z = complex(root["re"], root["im"])
                assert abs(ours - z).min() <= 0.03 * abs(z) + 1e-3, (preset["name"], z)

    @sections
    def test_printed_roots_off_ours_name_the_path_that_they_lie_on(self, section):
        for preset in sent(section)["presets"]:
            ours = VIEWS[section].closed_loop(EQS, **preset["values"]).poles()
            printed = [complex(root["re"], root["im"]) for root in preset["printed"]]
            far = any(abs(ours - z).min() > 0.03 * abs(z) + 1e-3 for z in printed)
            assert far == bool(preset.get("path")), preset["name"]

    def test_figures_9_and_10_are_closed_where_the_oscillation_of_the_text_exists(self):
        for number, sign, side in ((9, -1, 1), (10, 1, -1)):
            preset = designs("IV")[f"Figure {number}"]
            loop = theta_loop(EQS, preset["K_C"], preset["K_R"], preset["gyro"])
            first, last = section_4.real_meetings(loop, sign, side)
            assert abs(first) < abs(preset["K_A"]) < abs(last)
            assert section_4.oscillates(EQS, number, preset["K_A"], side)
            for beyond in (0.9 * first, 1.1 * last):
                assert not section_4.oscillates(EQS, number, beyond, side)

    def test_the_corrected_rigid_body_design_puts_the_short_period_where_it_is_wanted(self):
        gains = corrected_designs("IV", EQS)["Eq. 75, divided by U"]
        short = section_4.closed_loop_roots(EQS, gains["K_A"], gains["K_R"], None, order=2)
        assert abs(short - complex(-1, math.sqrt(3))).min() < 1e-9

    def test_the_gains_found_leave_no_root_right_of_the_axis(self):
        found = corrected_designs("VII", EQS)
        assert len(found) == 2
        for values in found.values():
            assert VIEWS["VII"].closed_loop(EQS, **values).poles().real.max() < 1e-7
