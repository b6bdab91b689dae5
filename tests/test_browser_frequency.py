"""The frequency response that the browser computes is that of python-control, at the peaks as well."""

from collections.abc import Iterator

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page

from browser_maths import maths_page, presets_of, run, sections, sent
from running_value import polynomial_along

CURVES = """(s, states, what) => states.map((state) => {
  const cut = module.cutLoop(s, state, what);
  return cut.gain ? module.frequencyResponse(cut) : null;
})"""


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


def loop_of(section: str, state: dict, what: dict) -> control.StateSpace:
    """Return the loop cut at what runs, as the difference of two closed loops says it."""
    p, k = polynomial_along(section, state, what), state[what["running"]]
    D, N = p(0.0), k * (p(1.0) - p(0.0))
    return control.tf(np.trim_zeros(N[::-1], "f").tolist(), D[::-1].tolist())


def closings(section: str) -> list[dict]:
    return [what for what in sent(section)["loci"] if what["of"] == "poles"]


@sections
class TestAgainstControl:
    def test_size_and_phase(self, page, section):
        seen = 0
        for what in closings(section):
            found = run(page, CURVES, section, presets_of(section), what)
            for state, curve in zip(presets_of(section), found, strict=True):
                if curve is None:
                    assert state[what["running"]] == 0
                    continue
                omega = np.array(curve["omega"])
                assert (np.diff(omega) > 0).all()
                inside = (
                    omega > 1e-2
                )  # nearer to 0 the poles at the origin are rounding in control's polynomial
                response = control.frequency_response(loop_of(section, state, what), omega[inside])
                values = np.squeeze(response.complex)
                ours = (np.array(curve["re"]) + 1j * np.array(curve["im"]))[inside]
                assert ours == pytest.approx(values, rel=1e-6)
                assert np.array(curve["dB"])[inside] == pytest.approx(20 * np.log10(abs(values)), abs=1e-5)
                turns = (np.array(curve["degrees"])[inside] - np.degrees(np.angle(values))) / 360
                assert turns == pytest.approx(turns.round(), abs=1e-5)
                seen += 1
        assert seen >= 5

    def test_the_phase_goes_on_without_jumps(self, page, section):
        for what in closings(section):
            for curve in run(page, CURVES, section, presets_of(section), what):
                if curve:
                    assert abs(np.diff(curve["degrees"])).max() < 60

    def test_peaks_are_met(self, page, section):
        """Beside the modes no frequency has a larger value than the largest of the points."""
        for what in closings(section):
            found = run(page, CURVES, section, presets_of(section), what)
            for state, curve in zip(presets_of(section), found, strict=True):
                if curve is None:
                    continue
                omega, dB = np.array(curve["omega"]), np.array(curve["dB"])
                for mode in (1.1504, 3.0512):
                    near = np.linspace(0.97 * mode, 1.03 * mode, 40001)
                    size = abs(
                        np.squeeze(control.frequency_response(loop_of(section, state, what), near).complex)
                    )
                    at = size.argmax()
                    if at in (0, len(near) - 1):
                        continue
                    own = dB[(omega > near[0]) & (omega < near[-1])].max()
                    assert own == pytest.approx(20 * np.log10(size[at]), abs=1e-4)


def test_which_loop_is_cut(page):
    body = "(s, what) => module.loopToCut(s, what).running"
    zeros = sent("VII")["loci"][1]
    assert run(page, body, "VII", zeros) == "K_A"
    assert run(page, body, "VII", {"running": "sensor", "off": [], "of": "poles"}) == "K_A"
    assert run(page, body, "VII", sent("VII")["loci"][0]) == "kK_z"
    assert run(page, body, "VII", {"running": "K_C", "off": [], "of": "poles"}) == "K_C"


def test_modes_are_named_by_the_poles_that_make_them(page):
    body = """(s, state, what, at) => {
      const modes = module.modesOf(module.cutLoop(s, state, what).poles);
      const nameAt = (omega) => module.modeAt(modes, omega)?.name ?? 'none';
      return [modes.map(({ name }) => name), ...at.map(nameAt)];
    }"""
    found = run(page, body, "IV", presets_of("IV")[0], sent("IV")["loci"][0], [0.2, 1.2, 3.5, 9.0])
    assert found == [["mode 1", "mode 2"], "none", "mode 1", "mode 2", "none"]
