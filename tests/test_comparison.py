"""The comparison of Chapter VIII in Python: its designs, both sides' closed loops, its errors, its weight."""

import base64
import gzip
import json

import pytest
import traitlets

import rlswaim as rl
from rlswaim.explorers import COMPARED, Comparison, comparison_explorer, designs
from rlswaim.explorers.presets import corrected_designs
from systems import mismatch

EQUATIONS = rl.printed_equations()
LOOPS = {"V": rl.single_sensor, "VI": rl.two_sensor, "VII": rl.dual_actuation}
SIDES = ("left", "right")


@pytest.fixture(scope="module")
def made() -> Comparison:
    return comparison_explorer(EQUATIONS)


@pytest.fixture
def view(made) -> Comparison:
    """The comparison at its start."""
    made.left, made.right = (made._place("IV", name) for name in COMPARED["IV"])
    return made


def library_loop(section: str, values: dict):
    """Return the closed loop of a design straight from the library."""
    if section in LOOPS:
        return LOOPS[section](EQUATIONS, **values)
    given = dict(values)
    total = given.pop("feedback") == "total"
    return rl.rate_attitude(EQUATIONS, **{**given, "gyro": given["gyro"] if total else None})


def named(section: str) -> dict[str, dict]:
    """Return the designs of a section as the comparison names them."""
    printed = {f"{section}: {name} (as printed)": d for name, d in designs(section).items()}
    corrected = corrected_designs(section, EQUATIONS).items()
    return printed | {f"{section}: {name} (corrected)": d for name, d in corrected}


def test_designs_are_all_those_of_sections_4_to_7_in_order(view):
    assert view.designs == [name for section in ("IV", "V", "VI", "VII") for name in named(section)]


def test_starts_with_the_rigid_body_design_as_printed_and_corrected(view):
    printed, corrected = COMPARED["IV"]
    assert view.designs[view.left] == f"IV: {printed} (as printed)"
    assert view.designs[view.right] == f"IV: {corrected} (corrected)"
    assert repr(view) == f"comparison: IV: {printed} (as printed) beside IV: {corrected} (corrected)"


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("section", ["IV", "V", "VI", "VII"])
def test_closed_loop_of_a_side_is_that_of_the_library(view, section, side):
    assert len(named(section)) == {"IV": 8, "V": 3, "VI": 3, "VII": 5}[section]
    for name, values in named(section).items():
        setattr(view, side, view.designs.index(name))
        assert view.values(side) == values
        assert mismatch(view.closed_loop(side).poles(), library_loop(section, values).poles()) == 0, name


def test_a_side_leaves_the_other(view):
    before = view.values("right")
    view.left = view.designs.index("VII: Figure 25 (as printed)")
    assert view.values("right") == before


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("at", [-1, 1000])
def test_a_place_that_is_no_design(view, side, at):
    message = f"{side} in comparison: got {at}, wanted 0 to {len(view.designs) - 1}"
    with pytest.raises(traitlets.TraitError, match=message):
        setattr(view, side, at)


@pytest.mark.parametrize("method", ["values", "closed_loop"])
def test_a_side_that_is_none(view, method):
    with pytest.raises(ValueError, match="got 'middle', wanted one of left, right"):
        getattr(view, method)("middle")


def test_equations_that_are_none():
    with pytest.raises(TypeError, match="eqs in comparison: got int"):
        comparison_explorer(3)


def test_each_side_has_a_list_of_the_designs(view):
    assert len(view.panel.children) >= len(SIDES) == 2
    for side, chooser in zip(SIDES, view.panel.children, strict=False):
        assert chooser.options == tuple(view.designs)
        assert chooser.index == getattr(view, side)
        assert chooser.description == side.capitalize()


def test_a_still_and_a_line_stand_in_where_no_script_runs(view):
    bundle = view._repr_mimebundle_()
    assert base64.b64decode(bundle["image/png"]).startswith(b"\x89PNG")
    assert bundle["text/plain"] == repr(view)


def test_weight(view):
    """The data of both sides; the scripts are those of all views."""
    assert len(gzip.compress(json.dumps(view.payload).encode())) < 90_000
