"""The notation page's rows: readable, with units, and one for every symbol that the report prints."""

import dataclasses

import pytest

from rlswaim.edition import notation
from rlswaim.source.equations import templates
from rlswaim.source.tables import read_table
from symbols_in_tex import symbols_in

NOT_A_SYMBOL = {"name", "source", "surfaces", "modes", "flight"}


@pytest.mark.parametrize("record", notation.RECORDS, ids=lambda record: record.__name__)
def test_every_quantity_of_the_data_classes_is_listed(record):
    listed = {line.place for line in notation.rows()}
    fields = {f.name for f in dataclasses.fields(record)} - NOT_A_SYMBOL
    assert {f"{record.__name__}.{name}" for name in fields} <= listed


def test_no_row_is_empty_and_no_signal_stands_twice():
    rows = notation.rows()
    assert all(line.symbols and all(line.notation) for line in rows)
    signals = [symbol for line in rows if not line.place for symbol in line.symbols]
    assert len(signals) == len(set(signals))


def test_a_row_has_one_unit_or_one_for_each_of_its_symbols():
    wrong = [
        line
        for line in notation.rows()
        if not line.place and len(line.notation.unit.split("; ")) not in (1, len(line.symbols))
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("tex", "wanted"),
    [
        (r"\frac{K_AK_{z_a}}{\phi_1(z_a)}", {"K_A", "K_{z_a}", r"\phi_1(z_a)", "z_a"}),
        (r"\int_0^L C_{N_\alpha}\phi_1^2\,d\ell", {"L", r"C_{N_\alpha}", r"\phi_1", r"\ell"}),
        (r"\ddot q_1 + \bar\theta_i(s)", {"q_1", r"\bar\theta_i", "s"}),
        (r"Z_{\dot q_1}\printed{eq38-Z_q1}", {r"Z_{\dot q_1}"}),
        (
            r"m^{(i)}\tan^{-1}\frac{\partial\xi(G,t)}{\partial\ell}",
            {"m", "i", r"\xi(G,t)", "G", "t", r"\ell"},
        ),
    ],
)
def test_the_symbols_of_a_formula_are_found(tex, wanted):
    assert symbols_in(tex) == wanted


def test_every_symbol_of_every_printed_equation_has_a_row():
    listed = set().union(*(symbols_in(symbol) for line in notation.rows() for symbol in line.symbols))
    used = {key: symbols_in(template.tex) for key, template in templates().items()}
    assert all(used.values())
    lost = {key: symbols - listed for key, symbols in used.items() if symbols - listed}
    assert lost == {}


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("q_D", "q_{D}"),
        ("C_N_alpha", r"C_{N_{\alpha}}"),
        ("omega_1e", r"\omega_{1e}"),
        ("kK_z", r"k\,K_{z}"),
        ("l_CG", r"\ell_{CG}"),
        ("1/M, 1/I_y", r"1/M,\ 1/I_{y}"),
        ("N_q1 N_theta", r"N_{q_{1}},\ N_{\theta}"),
    ],
)
def test_latex(text, wanted):
    assert notation.latex(text) == wanted


def test_the_page_shows_every_row_in_one_group():
    groups = dict.fromkeys(line.group for line in notation.rows())
    frames = [notation.frame(group) for group in groups]
    assert sum(map(len, frames)) == len(notation.rows())
    assert all(frame.symbol.str.fullmatch(r"\$[^$]+\$(?:, \$[^$]+\$)*").all() for frame in frames)
    with pytest.raises(ValueError, match="group in frame: got 'gains', wanted one of path"):
        notation.frame("gains")


def test_coefficients_have_the_units_of_their_table():
    found = {line.symbols[0]: line.notation.unit for line in notation.rows() if "coefficients." in line.place}
    assert found == {row["latex"]: row["unit"] for row in read_table("coefficients")}


@pytest.mark.parametrize(
    ("name", "meaning"),
    [
        ("Z_alpha", "what alpha does in the equation of the force"),
        ("M_thetadot", "what the rate of theta does in the equation of the moment"),
        ("F1_q1", "what q_1 does in the equation of the first mode"),
        ("F2_q2dot", "what the rate of q_2 does in the equation of the second mode"),
        ("M_delta", "what delta does in the equation of the moment"),
    ],
)
def test_a_coefficient_says_which_motion_does_what_in_which_equation(name, meaning):
    (line,) = (x for x in notation.rows() if x.place == f"PerturbationEquations.coefficients.{name}")
    assert line.notation.meaning == meaning
    assert (line.group, line.notation.symbol, line.notation.source) == ("coefficients", name, "Eq. 29")
