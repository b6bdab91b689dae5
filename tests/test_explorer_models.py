"""The live views' models: the exact forms that Python sends, and what the browser computes from them.

Python's side is the library's closed loop at the same state, so that a form or a script that
forgot a factor would be found out.  Where a pole is ill-conditioned, its error is compared with
what one rounding of the coefficients' terms would do to it.
"""

import json
import math
import re
from collections.abc import Iterator
from functools import cache

import control
import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from scipy.linalg import expm, matrix_balance
from scipy.optimize import linear_sum_assignment

import rlswaim as rl
from rlswaim.edition import section_4
from rlswaim.explorers.control_systems import SYSTEMS, payload
from rlswaim.explorers.presets import COMPARED, CORRECTED, corrected_designs, designs
from rlswaim.loops.closures import JetLoop, theta_numerator
from rlswaim.loops.multiaffine import multiaffine_forms, with_shapes
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial, exact_characteristic_polynomial
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source.tables import read_table, script

EQUATIONS = {"data": rl.perturbation_equations(rl.swaim_booster()), "printed": rl.printed_equations()}
EQS = EQUATIONS["printed"]
MODULE = "\n".join(
    re.sub(r"^import [^;]*;\n", "", script("js", "maths", f"{name}.js"), flags=re.MULTILINE)
    for name in ("roots", "locus", "responses", "mode_shape")
)
VIEW = {"left": -12.0, "right": 4.0, "bottom": -1.0, "top": 13.0, "scale": 40.0, "tolerance": 0.25}
COUNT = 1000
EPS = np.finfo(float).eps
sections = pytest.mark.parametrize("section", SYSTEMS)


@cache
def forms(section: str, equations: str = "printed"):
    return SYSTEMS[section].forms(EQUATIONS[equations])


@cache
def sent(section: str) -> dict:
    """Return the payload as the browser gets it."""
    system, polynomial = SYSTEMS[section], forms(section).polynomial
    return {
        **json.loads(json.dumps(payload(system, EQS, forms(section)))),
        "terms": [term._asdict() for term in polynomial.terms],
        "parameters": [{"name": p.name, "grid": p.grid} for p in system.parameters(EQS)],
    }


@cache
def states(section: str, count: int = COUNT, seed: int = 1964) -> list[dict]:
    """Return random places of all sliders."""
    rng = np.random.default_rng(seed)
    parameters = SYSTEMS[section].parameters(EQS)
    return [{p.name: p.grid[rng.integers(len(p.grid))] for p in parameters} for _ in range(count)]


@cache
def loops(section: str) -> list[control.StateSpace]:
    """Return the library's closed loops at the random states."""
    return [SYSTEMS[section].closed_loop(EQS, **state) for state in states(section)]


def presets_of(section: str) -> list[dict]:
    return [preset["values"] for preset in sent(section)["presets"]]


def factors_at(section: str, state: dict) -> dict[str, float]:
    """Return the factors of the form at a state, as the browser takes them: straight between two feet."""
    system = SYSTEMS[section]
    values = {name: state[name] for name in system.gains}
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


def random_factors(section: str, seed: int) -> dict[str, float]:
    rng = np.random.default_rng(seed)
    names = forms(section).polynomial.factors
    values = {name: float(rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 2)) for name in names}
    return values | ({"arm": 12.5 * (1 + seed)} if "arm" in values else {})


class TestForms:
    @sections
    @pytest.mark.parametrize("equations", EQUATIONS)
    def test_polynomial_and_numerators_are_those_of_the_closed_loop(self, section, equations):
        found, system = forms(section, equations), SYSTEMS[section]
        for seed in range(4):
            values = random_factors(section, seed)
            loop = system.at_factors(EQUATIONS[equations], **values)
            exact = characteristic_polynomial(loop.A)
            scale = sizes(found.polynomial, values)
            assert (abs(found.polynomial(**values) - exact) <= 1e-13 * scale).all()
            for name, by_output in found.numerators.items():
                initial = np.array([[float(label == f"x_{name[:-3]}")] for label in loop.state_labels])
                B = initial if name.endswith("(0)") else loop.B[:, [loop.input_labels.index(name)]]
                for output, form in by_output.items():
                    C = loop.C[[loop.output_labels.index(output)]]
                    exact = characteristic_polynomial(loop.A, B, C)
                    ours = form(**values)
                    assert not exact[ours.size :].any()
                    assert (abs(ours - exact[: ours.size]) <= 1e-13 * sizes(form, values)).all()

    def test_terms_are_those_of_eq_83(self):
        loop = ("K_A", "K_C")
        assert [term.factors for term in forms("IV").polynomial.terms] == [
            (),
            ("K_C",),
            loop,
            (*loop, "K_R"),
            (*loop, "sigma_1"),
            (*loop, "sigma_2"),
            (*loop, "K_R", "sigma_1"),
            (*loop, "K_R", "sigma_2"),
        ]

    def test_a_square_is_found_out(self):
        def squared(K_A: float):
            return rl.rate_attitude(EQS, K_A=K_A, K_C=K_A, K_R=1.0, gyro=None)

        with pytest.raises(ValueError, match="not multi-affine in K_A"):
            multiaffine_forms(squared, [("K_A",)])

    def test_factors_of_two_groups_in_one_entry_are_found_out(self):
        def closed_loop(K_A: float, K_C: float):
            return rl.rate_attitude(EQS, K_A=K_A, K_C=K_C, K_R=1.0, gyro=None)

        assert multiaffine_forms(closed_loop, [("K_A", "K_C")]).polynomial.terms
        with pytest.raises(ValueError, match="not multi-affine in K_A, K_C"):
            multiaffine_forms(closed_loop, [("K_A",), ("K_C",)])

    def test_unknown_and_bad_factors(self):
        form = forms("IV").polynomial
        values = dict.fromkeys(form.factors, 1.0)
        with pytest.raises(ValueError, match="unknown factor 'K_B', wanted K_A, K_C"):
            form(**values, K_B=1.0)
        with pytest.raises(ValueError, match="K_R in MultiAffine: got nan, wanted a finite number"):
            form(**{**values, "K_R": math.nan})

    def test_given_shapes_stand_at_their_stations_alone(self):
        here = with_shapes(EQS, deflections={140.0: (1.5, 2.5)}, slopes={60.0: (0.1, 0.2)})
        assert [mode.deflection(140.0) for mode in here.modes] == [1.5, 2.5]
        assert [mode.slope(60.0) for mode in here.modes] == [0.1, 0.2]
        assert [mode.slope(140.0) for mode in here.modes] == [mode.slope(140.0) for mode in EQS.modes]


class TestPresets:
    @sections
    def test_values_are_all_parameters_and_on_their_sliders(self, section):
        grids = {p.name: p.grid for p in SYSTEMS[section].parameters(EQS)}
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
            ours = SYSTEMS["IV"].closed_loop(EQS, **preset["values"]).poles()
            for root in preset["printed"]:
                z = complex(root["re"], root["im"])
                assert abs(ours - z).min() <= 0.03 * abs(z) + 1e-3, (preset["name"], z)

    @sections
    def test_printed_roots_off_ours_name_the_path_that_they_lie_on(self, section):
        for preset in sent(section)["presets"]:
            ours = SYSTEMS[section].closed_loop(EQS, **preset["values"]).poles()
            printed = [complex(root["re"], root["im"]) for root in preset["printed"]]
            far = any(abs(ours - z).min() > 0.03 * abs(z) + 1e-3 for z in printed)
            assert far == bool(preset.get("path")), preset["name"]

    def test_the_corrected_rigid_body_design_puts_the_short_period_where_it_is_wanted(self):
        gains = corrected_designs("IV", EQS)["Eq. 75, divided by U"]
        short = section_4.closed_loop_roots(EQS, gains["K_A"], gains["K_R"], None, order=2)
        assert abs(short - complex(-1, math.sqrt(3))).min() < 1e-9

    def test_the_gains_found_leave_no_root_right_of_the_axis(self):
        for values in corrected_designs("VII", EQS).values():
            assert SYSTEMS["VII"].closed_loop(EQS, **values).poles().real.max() < 1e-7


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    """A blank page with the models' scripts as `module`."""
    page = browser.new_page()
    page.evaluate(
        """async ([code, systems]) => {
             const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
             Object.assign(globalThis, { module: await import(address), systems });
           }""",
        [MODULE, {section: sent(section) for section in SYSTEMS}],
    )
    yield page
    page.close()


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


def exact_poles(A: np.ndarray, coefficients: np.ndarray) -> np.ndarray:
    """Return a closed loop's poles, polished on its exact coefficients in extended precision."""
    p = np.array(coefficients, dtype=np.longdouble)
    z = np.linalg.eigvals(matrix_balance(A)[0]).astype(np.clongdouble)
    powers = np.arange(p.size)
    for _ in range(3):
        slope = (z[:, None] ** powers[:-1]) @ (p[1:] * powers[1:])
        step = (z[:, None] ** powers) @ p / np.where(slope == 0, 1, slope)
        z = z - np.where(abs(step) < 1e-3 * abs(z), step, 0)
    return z.astype(complex)


@sections
class TestPoles:
    def test_agree_with_python(self, page, section):
        found = run(page, "(s, all) => all.map((x) => module.closedLoop(s, x))", section, states(section))
        for state, loop, js in zip(states(section), loops(section), found, strict=True):
            exact = [float(c) for c in exact_characteristic_polynomial(loop.A)]
            ours = points(js)
            wanted = order_of(ours, exact_poles(loop.A, exact))
            slope = abs(np.polyval(np.polyder(exact[::-1]), wanted))
            rounding = np.polyval(
                sizes(forms(section).polynomial, factors_at(section, state))[::-1], abs(wanted)
            )
            spread = np.minimum(20 * EPS * rounding / np.maximum(slope, 1e-300), 1e-3 * abs(wanted))
            assert (abs(ours - wanted) <= np.maximum(1e-8 * abs(wanted), spread) + 1e-12).all(), state

    def test_without_feedback_of_the_angle_the_attitude_stays_at_the_origin_exactly(self, page, section):
        body = "(s, all) => all.map((x) => module.closedLoop(s, { ...x, K_A: 0 }))"
        for js in run(page, body, section, [*presets_of(section), *states(section)]):
            assert points(js)[js["branches"].index("attitude")] == 0

    def test_names_are_those_of_the_locus_and_lead_back_to_the_open_loop(self, page, section):
        found = run(
            page,
            """(s, all, view) => all.map((x) => {
                 const last = module.rootLocus(s, x, view);
                 const alone = { ...x };
                 for (const gain of s.closing.slice(0, -1)) alone[gain] = 0;
                 return [module.closedLoop(s, x), last.present, last.names,
                         module.rootLocus(s, alone, view).open, module.namedPoles(s, alone)];
               })""",
            section,
            states(section)[:200],
            VIEW,
        )
        for present, drawn, names, back, opened in found:
            assert names == present["branches"]
            assert (points(drawn) == points(present)).all()
            assert back["branches"] == opened["branches"]
            assert abs(points(back) - points(opened)).max() < 1e-6 * (1 + abs(points(opened)).max())


def response_of(loop: control.StateSpace, stimulus: dict, times: np.ndarray) -> dict[str, np.ndarray]:
    """Return the outputs by matrix exponentials of the closed loop with its input's own equations."""
    n, amplitude, name = loop.nstates, stimulus["amplitude"], stimulus["input"]
    signal = np.zeros((n, 3))
    x = np.zeros(n + 3)
    x[n:] = 1, 1, 0  # 1, cos, sin
    w = 2 * math.pi / stimulus["duration"]
    turning = np.array([[0, 0, 0], [0, 0, -w], [0, w, 0]])
    if stimulus["kind"] == "initial":
        x[loop.state_labels.index(f"x_{name[:-3]}")] = amplitude
    else:
        b = amplitude * loop.B[:, loop.input_labels.index(name)]
        signal[:, 0] = b if stimulus["kind"] == "step" else b / 2
        signal[:, 1] = 0 if stimulus["kind"] == "step" else -b / 2
    full = np.block([[loop.A, signal], [np.zeros((3, n)), turning]])
    balanced, T = matrix_balance(full)
    dt = times[1] - times[0]
    forced = T @ expm(balanced * dt) @ np.linalg.inv(T)
    free = forced.copy()
    free[:n, n:] = 0
    rows = [x]
    for t in times[:-1]:
        over = stimulus["kind"] == "gust" and t > stimulus["duration"] - dt / 2
        rows.append((free if over else forced) @ rows[-1])
    found = np.array(rows)[:, :n] @ loop.C.T
    return dict(zip(loop.output_labels, found.T, strict=True))


def stimuli(section: str) -> list[tuple[dict, np.ndarray]]:
    """Return an input for each random state, over a time in which no motion grows beyond e^12."""
    names = list(sent(section)["numerators"])
    found = []
    for i, loop in enumerate(loops(section)):
        fastest = max(loop.poles().real.max(), 1e-9)
        end = min(10.0, 12 / fastest)
        name = names[i % len(names)]
        kind = "initial" if name.endswith("(0)") else ("step" if name == "theta_c" else "gust")
        found.append(
            ({"input": name, "kind": kind, "amplitude": 0.1, "duration": 0.4 * end}, np.linspace(0, end, 21))
        )
    return found


@sections
class TestResponses:
    def test_agree_with_python(self, page, section):
        given = stimuli(section)
        found = run(
            page,
            "(s, all, given) => all.map((x, i) => module.responses(s, x, given[i][0], given[i][1]))",
            section,
            states(section),
            [[stimulus, times.tolist()] for stimulus, times in given],
        )
        for state, loop, (stimulus, times), js in zip(
            states(section), loops(section), given, found, strict=True
        ):
            wanted = response_of(loop, stimulus, times)
            assert set(js) == set(SYSTEMS[section].outputs)
            for name, values in js.items():
                largest = abs(wanted[name]).max()
                assert abs(np.array(values) - wanted[name]).max() <= 1e-6 * largest, (state, stimulus, name)

    def test_start_at_the_initial_condition(self, page, section):
        stimulus = {"input": "q1(0)", "kind": "initial", "amplitude": 2.0, "duration": 1.0}
        for state in presets_of(section):
            js = run(page, "(s, x, u) => module.responses(s, x, u, [0, 1])", section, state, stimulus)
            assert js["q1"][0] == pytest.approx(2.0, rel=1e-7)
            assert js["theta"][0] == pytest.approx(0.0, abs=1e-7)


@sections
def test_responses_pass_through_coinciding_poles(page, section):
    """Two poles that all but fall together, the actuator's and another, do not spoil each other's part."""
    state = {**presets_of(section)[0], **dict.fromkeys(sent(section)["closing"], 0.0), "K_C": 10.0}
    if section == "VII":
        state |= {"K_r": 10.0}
    else:
        pole = min(root["re"] for root in sent(section)["poles"])
        state |= {"K_C": -pole}
    stimulus = {"input": "theta_c", "kind": "step", "amplitude": 1.0, "duration": 1.0}
    gain = sent(section)["closing"][-1]
    body = "(s, x, u, t) => module.responses(s, x, u, t)"
    times = np.linspace(0, 4, 21)
    js = run(page, body, section, {**state, gain: 1e-9}, stimulus, times.tolist())
    wanted = response_of(SYSTEMS[section].closed_loop(EQS, **{**state, gain: 1e-9}), stimulus, times)
    for name, values in js.items():
        assert abs(np.array(values) - wanted[name]).max() <= 1e-6 * abs(wanted[name]).max(), name


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
            value = {name: complex(*mode[name]) for name in SYSTEMS[section].outputs}
            v = np.array([value["alpha"], value["theta"], p * value["theta"], value["q1"], p * value["q1"],
                          value["q2"], p * value["q2"]])  # fmt: skip
            for name in SYSTEMS[section].outputs[4:]:
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
                value = {name: complex(*mode[name]) for name in ("alpha", "theta", "q1", "q2")}
                shape = EQS.U * (value["alpha"] - value["theta"]) / complex(re_, im)
                shape = shape + value["theta"] * (feet - EQS.l_CG)
                for mode_, q in zip(EQS.modes, ("q1", "q2"), strict=True):
                    shape = shape - mode_.deflection(feet) * value[q]
                drawn = np.array(mode["shape"]["re"]) + 1j * np.array(mode["shape"]["im"])
                assert abs(drawn - shape).max() < 1e-9
                assert abs(drawn).max() == pytest.approx(1)
                assert abs(drawn[abs(drawn).argmax()] - 1) < 1e-9


def loci_of(section: str) -> list[dict]:
    """Return the report's loops, the actuator's gain, and each station."""
    system = sent(section)
    more = [{"running": name, "off": [], "of": "poles"} for name in ("K_C", "K_R", *system["maps"])]
    return [*system["loci"], *more]


def polynomial_along(section: str, state: dict, what: dict):
    """Return the polynomial whose roots a locus follows, as a function of the running value or of many."""
    form = forms(section).polynomial
    size = max(len(term.coefficients) for term in form.terms)

    def value(t: float | np.ndarray, factors: dict[str, float]) -> np.ndarray:
        total = np.zeros((*np.shape(t), size))
        for term in form.terms:
            weight = math.prod(factors[f] for f in term.factors)
            total[..., : len(term.coefficients)] += np.multiply.outer(weight, term.coefficients)
        return total

    held = {**state, **dict.fromkeys(what["off"], 0.0)}

    def at(t: float | np.ndarray) -> np.ndarray:
        values = factors_at(section, {**held, what["running"]: t})
        if what["of"] == "zeros":
            return value(t, {**values, what["gain"]: 1.0}) - value(t, {**values, what["gain"]: 0.0})
        return value(t, values)

    return at


def roots_at(p: np.ndarray) -> np.ndarray:
    """Return roots for a picture."""
    return roots(np.where(abs(p) > 1e-15 * abs(p).max(), p, 0.0) if abs(p[-1]) < 1e-15 * abs(p).max() else p)


def roots_of_all(polynomials: np.ndarray) -> np.ndarray:
    """Return the roots for a picture of one polynomial a row, rows filled up with nan."""
    sizes_ = abs(polynomials).max(axis=1, keepdims=True)
    degrees = (np.arange(polynomials.shape[1]) * (abs(polynomials) > 1e-15 * sizes_)).max(axis=1)
    found = np.full((len(polynomials), polynomials.shape[1] - 1), np.nan, dtype=complex)
    for n in set(degrees.tolist()):
        rows = degrees == n
        companion = np.zeros((rows.sum(), n, n))
        companion[:, 1:, :-1] = np.eye(n - 1)
        companion[:, :, -1] = -polynomials[rows, :n] / polynomials[rows, n : n + 1]
        found[rows, :n] = np.linalg.eigvals(companion)
    return found


DRAWN = """(system, ...given) => {
  const { kind, end, branches } = module.rootLocus(system, ...given);
  return { kind, end, t: branches.map((p) => p.t), x: branches.map((p) => p.x), y: branches.map((p) => p.y) };
}"""


@sections
class TestLoci:
    def test_are_true_to_half_a_pixel(self, page, section):
        """Every root at values between the points drawn lies on its own branch as drawn."""
        for state in [*presets_of(section), *states(section, 4, seed=3)]:
            for what in loci_of(section):
                locus = run(page, DRAWN, section, state, VIEW, what)
                p = polynomial_along(section, state, what)
                assert locus["t"][0] == 0
                assert locus["t"][-1] == locus["end"]
                places, drawn = np.array(locus["t"]), points(locus)
                (a, b), share = (places[:-1], places[1:]), 0.37
                linear = (a * b == 0) | (locus["kind"] == "station")
                ratio = np.where(linear, 1, b / np.where(a == 0, 1, a))
                exact = roots_of_all(p(np.where(linear, a + share * (b - a), a * ratio**share)))
                across = (exact.real > VIEW["left"]) & (exact.real < VIEW["right"])
                seen = across & (abs(exact.imag) < VIEW["top"])
                start, end = drawn[:-1, None, :], drawn[1:, None, :]
                chord = np.where(end == start, 1e-300, end - start)
                along = np.clip(((exact[:, :, None] - start) / chord).real, 0, 1)
                miss = abs(exact[:, :, None] - start - along * (end - start)).min(axis=2)
                assert (miss[seen] * VIEW["scale"] < 0.5).all(), (state, what)

    def test_break_aways_and_crossings_are_those_of_the_library(self, page, section):
        for state in presets_of(section):
            for what in [w for w in sent(section)["loci"] if w["of"] == "poles"]:
                locus = run(page, "module.rootLocus", section, state, VIEW, what)
                p, end = polynomial_along(section, state, what), locus["end"]
                D, N = p(0.0), p(1.0) - p(0.0)
                tf = control.tf(N[::-1].tolist(), D[::-1].tolist())
                theirs = rl.root_locus(tf, gains=[0.0])
                ours = sorted(b.gain for b in theirs.break_aways if 0 < b.gain / end < 1)
                assert len(locus["breaks"]) == len(ours)
                for broken in locus["breaks"]:
                    at = complex(broken["x"], broken["y"])
                    two = np.sort(abs(roots(p(broken["gain"])) - at))[:2]
                    assert two.max() <= 1e-5 * abs(at)  # a double root, found to half the digits
                ours = sorted((c.gain, c.omega) for c in theirs.crossings if 0 < c.gain / end < 1)
                found = sorted((c["gain"], c["omega"]) for c in locus["crossings"])
                assert np.array(found) == pytest.approx(np.array(ours), rel=1e-6)

    def test_stations_where_a_branch_crosses_the_axis(self, page, section):
        count = 0
        for state in [*presets_of(section), *states(section, 12, seed=5)]:
            for station in sent(section)["maps"]:
                what = {"running": station, "off": [], "of": "poles"}
                locus = run(page, "module.rootLocus", section, state, VIEW, what)
                p = polynomial_along(section, state, what)
                for crossing in locus["crossings"]:
                    count += 1
                    exact = roots(p(crossing["gain"]))
                    at = abs(exact - 1j * crossing["omega"]).argmin()
                    assert abs(exact[at] - 1j * crossing["omega"]) < 1e-6 * (1 + abs(exact[at]))
                before, after = (roots(p(t)) for t in (0.0, 420.0))
                gained = sum(c["direction"] * (2 if c["omega"] > 1e-6 else 1) for c in locus["crossings"])
                assert (after.real > 1e-13).sum() - (before.real > 1e-13).sum() == gained
        assert count > 3

    def test_labels_do_not_depend_on_the_window(self, page, section):
        """But where two branches all but meet: at most one locus in fifty."""
        close, wrong, count = {**VIEW, "left": -0.3, "right": 0.1, "top": 0.3, "scale": 1000}, 0, 0
        for what in loci_of(section):
            found = run(
                page,
                """(s, all, views, w) =>
                     all.map((x) => views.map((v) => module.rootLocus(s, x, v, w).branches.at(-1)))""",
                section,
                [*presets_of(section), *states(section, 20, seed=7)],
                [VIEW, close],
                what,
            )
            count += len(found)
            wrong += sum(not np.allclose(points(a), points(b), rtol=1e-3, atol=1e-3) for a, b in found)
        assert wrong <= 0.02 * count

    def test_the_value_at_a_point_of_a_branch_is_found_again(self, page, section):
        for state in presets_of(section):
            for what in loci_of(section):
                asked = run(
                    page,
                    """(s, x, view, w) => {
                         const locus = module.rootLocus(s, x, view, w);
                         return [3, 5].map((i) => {
                           const p = locus.branches[Math.floor((locus.branches.length * i) / 9)];
                           const branch = Math.min(i, p.x.length - 1);
                           const t = module.gainAt(s, x, w, branch, p.x[branch], p.y[branch], locus);
                           return { t, branch, re: p.x[branch], im: p.y[branch] };
                         });
                       }""",
                    section,
                    state,
                    VIEW,
                    what,
                )
                p = polynomial_along(section, state, what)
                for point in asked:
                    z = complex(point["re"], point["im"])
                    assert abs(roots_at(p(point["t"])) - z).min() <= 1e-5 * max(abs(z), 1e-2), (state, what)

    def test_pole_maps_end_where_the_library_says(self, page, section):
        for state in presets_of(section):
            for station in sent(section)["maps"]:
                sides = run(
                    page,
                    """(s, x, view, at) =>
                         module.poleMap(s, x, module.closedLoop(s, x), view, at).map((b) => b.at(-1))""",
                    section,
                    state,
                    VIEW,
                    station,
                )
                for end in sides:
                    exact = SYSTEMS[section].closed_loop(EQS, **{**state, station: end["t"]}).poles()
                    ours = points(end)
                    # Good for a picture; the present poles, above, are good to the last digits.
                    assert (abs(ours - order_of(ours, exact)) < 1e-5 * np.maximum(1, abs(ours))).all()


def test_a_step_that_would_lead_anywhere(page):
    """Two poles and a zero in one place: on the way a correction had a pole, and the page stood still."""
    state = {
        **{"K_A": 0.00841, "K_C": 79.4, "K_R": 0.96, "kK_z": -10700000, "K_r": 79.4, "b": 79.4},
        **{"sensor": 115, "jet": 212},
    }
    locus = run(page, "module.rootLocus", "VII", state, VIEW, sent("VII")["loci"][0])
    assert np.isfinite([[p["x"], p["y"]] for p in locus["branches"]]).all()


class TestMargins:
    @sections
    @pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")  # control's, at a pole and zero at 0
    def test_agree_with_control(self, page, section):
        for state in presets_of(section):
            for what in [w for w in sent(section)["loci"] if w["of"] == "poles"]:
                found = run(page, "module.margins", section, state, what)
                k = state[what["running"]]
                if k == 0:
                    assert found is None
                    continue
                p = polynomial_along(section, state, what)
                D, N = p(0.0), k * (p(1.0) - p(0.0))
                loop = control.tf(np.trim_zeros(N[::-1], "f").tolist(), D[::-1].tolist())
                gain, phase, _, w_gain, w_phase, _ = control.stability_margins(loop, returnall=True)
                ours = sorted((m["omega"], m["factor"]) for m in found["gain"] if m["omega"] > 1e-3)
                theirs = sorted((w, g) for w, g in zip(w_gain, gain, strict=True) if w > 1e-3)
                assert np.array(ours) == pytest.approx(np.array(theirs), rel=1e-5)
                ours = sorted((m["omega"], m["degrees"]) for m in found["phase"] if m["omega"] > 1e-3)
                theirs = sorted(
                    (w, (g + 180) % 360 - 180) for w, g in zip(w_phase, phase, strict=True) if w > 1e-3
                )
                assert np.array(ours) == pytest.approx(np.array(theirs), rel=1e-5)
                for margin in found["gain"]:
                    assert margin["dB"] == pytest.approx(20 * math.log10(margin["factor"]))
                for margin in found["phase"]:
                    lag = math.degrees(margin["delay"] * margin["omega"])
                    assert 0 <= lag < 360
                    assert (lag - margin["degrees"]) % 360 == pytest.approx(
                        0, abs=1e-9
                    ) or lag == pytest.approx(margin["degrees"] % 360)

    def test_none_for_stations_and_zeros(self, page):
        state = presets_of("VII")[0]
        for what in (sent("VII")["loci"][1], {"running": "sensor", "off": [], "of": "poles"}):
            assert run(page, "module.margins", "VII", state, what) is None


def test_closure_2_gives_the_zeros_that_closure_3_runs_to(page):
    for state in [*presets_of("VII"), *states("VII", 30, seed=9)]:
        locus = run(page, "module.rootLocus", "VII", state, VIEW, sent("VII")["loci"][1])
        loop = JetLoop(*(state[name] for name in ("K_r", "b", "sensor", "jet")))
        numerator = theta_numerator(EQS, loop, state["kK_z"])
        numerator = np.where(abs(numerator) > 1e-13 * abs(numerator).max(), numerator, 0)
        rate = [] if state["K_R"] == 0 else [-1 / state["K_R"]]
        wanted, ours = np.append(roots(numerator), rate), points(locus["present"])
        assert ours.size == wanted.size
        assert (abs(ours - order_of(ours, wanted)) <= 1e-6 * np.maximum(1e-3, abs(ours))).all(), state
