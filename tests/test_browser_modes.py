"""The mode shapes that the browser computes are eigenvectors of the library's closed loop."""

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

from browser_maths import COUNT, EQS, loops, maths_page, presets_of, run, sections, states
from rlswaim.explorers.system_views import VIEWS


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with maths_page(browser) as page:
        yield page


@sections
class TestModes:
    def test_are_eigenvectors_of_the_closed_loop(self, page, section):
        found = run(
            page,
            """(s, all) => all.map((x, i) => {
                 const poles = module.closedLoop(s, x);
                 const pole = { re: poles.x[i % poles.x.length], im: poles.y[i % poles.x.length] };
                 const mode = module.modeShape(s, x, pole);
                 if (mode) mode.shape = [mode.shape.re[60], mode.shape.im[60]];
                 return [pole, mode];
               })""",
            section,
            states(section),
        )
        seen = 0
        for state, loop, (pole, mode) in zip(states(section), loops(section), found, strict=True):
            if mode is None:
                continue
            seen += 1
            p = complex(pole["re"], pole["im"])
            value = {name: complex(*mode[name]) for name in VIEWS[section].system.outputs}
            v = np.array([value["alpha"], value["theta"], p * value["theta"], value["q1"], p * value["q1"],
                          value["q2"], p * value["q2"]])  # fmt: skip
            for name in VIEWS[section].system.outputs[4:]:
                row = loop.C[loop.output_labels.index(name)]
                weight = row[loop.state_labels.index(f"x_{name}")]
                v = np.append(v, value[name] / weight if weight else 0)
            # An actuator whose gain is zero moves unseen: its own equation can't be checked.
            known = [label in ("x_alpha", "x_theta") or abs(loop.C[:, i]).any() for i, label in
                     enumerate(loop.state_labels)]  # fmt: skip
            miss = abs(loop.A @ v - p * v)[known]
            scale = (abs(loop.A) @ abs(v) + abs(p * v))[known]
            assert (miss <= 1e-7 * scale + 1e-12 * scale.max()).all(), (state, p)
            assert sum(mode["shares"].values()) == pytest.approx(1)
        assert seen > 0.9 * COUNT

    def test_shape_is_the_motion_along_the_vehicle(self, page, section):
        count = 0
        for state in presets_of(section):
            modes = run(
                page,
                """(s, x) => {
                     const { x: re, y: im } = module.closedLoop(s, x);
                     return re.map((r, i) => [[r, im[i]], module.modeShape(s, x, { re: r, im: im[i] })]);
                   }""",
                section,
                state,
            )
            feet = np.arange(421.0)
            for (re_, im), mode in modes:
                if mode is None or abs(complex(re_, im)) < 1e-9:
                    continue
                count += 1
                value = {name: complex(*mode[name]) for name in ("alpha", "theta", "q1", "q2")}
                shape = EQS.U * (value["alpha"] - value["theta"]) / complex(re_, im)
                shape = shape + value["theta"] * (feet - EQS.l_CG)
                for mode_, q in zip(EQS.modes, ("q1", "q2"), strict=True):
                    shape = shape - mode_.deflection(feet) * value[q]
                drawn = np.array(mode["shape"]["re"]) + 1j * np.array(mode["shape"]["im"])
                assert abs(drawn - shape).max() < 1e-9
                assert abs(drawn).max() == pytest.approx(1)
                assert abs(drawn[abs(drawn).argmax()] - 1) < 1e-9
        assert count >= 5 * len(presets_of(section))
