"""The notation page's rows: complete, readable, with units."""

import dataclasses

import pytest

from rlswaim.edition import notation

NOT_A_SYMBOL = {"name", "source", "surfaces", "modes", "flight"}


@pytest.mark.parametrize("record", notation.RECORDS, ids=lambda record: record.__name__)
def test_every_quantity_of_the_data_classes_is_listed(record):
    listed = {place for place, _ in notation.rows()}
    fields = {f.name for f in dataclasses.fields(record)} - NOT_A_SYMBOL
    assert {f"{record.__name__}.{name}" for name in fields} <= listed


def test_no_row_is_empty_and_no_signal_stands_twice():
    rows = notation.rows()
    assert all(line.symbol and line.unit and line.meaning and line.source for _, line in rows)
    signals = [line.symbol for place, line in rows if not place]
    assert len(signals) == len(set(signals))


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("q_D", "q_{D}"),
        ("C_N_alpha", r"C_{N_{\alpha}}"),
        ("omega_1e", r"\omega_{1e}"),
        ("kK_z", r"k\,K_{z}"),
        ("1/M, 1/I_y", r"1/M,\ 1/I_{y}"),
        ("N_q1 N_theta", r"N_{q_{1}},\ N_{\theta}"),
    ],
)
def test_latex(text, wanted):
    assert notation.latex(text) == wanted


def test_page_sets_symbols_between_dollar_signs():
    frame = notation.frame()
    assert len(frame) == len(notation.rows())
    assert frame.symbol.str.fullmatch(r"\$[^$]+\$").all()
