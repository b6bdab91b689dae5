"""The search of the book finds numbers in any form, and shows no source code."""

import json
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import rlswaim as rl
from extensions.number_search import SearchWordsAndNumbers
from rlswaim.edition.ledger import as_frame
from test_pages import HTML

SPLIT = SearchWordsAndNumbers({}).split
EXCERPTS = "#search-results p.context"
FORMS = [
    ("6.545e-10", r"6.545 \times 10^{-10}"),
    ("6.545e-10", "6.545 × 10^-10"),
    ("6.545e-10", "6.545E−10"),
    ("6.545e-10", r"6.545\,\cdot\,10^{-10}"),
    ("1940", "1,940"),
    ("1940", "1{,}940"),
    ("1940", r"1\,940"),
    ("1940", "1.94e3"),
    ("0.618", ".618"),
    ("0.618", "-0.6180"),
    ("89000000", ".890 × 10^8"),
    ("1e-7", "10^{-7}"),
]


def pages_found(visit, query: str) -> set[str]:
    """The pages that a search lists, without what stands after a #."""
    with visit(f"search.html?q={query.replace('+', '%2B')}", plain=True) as (page, outside, errors):
        page.wait_for_function("() => /finished|did not match/.test(document.body.innerText)")
        hrefs = page.locator("#search-results li a").evaluate_all("all => all.map(a => a.pathname)")
        assert (outside, errors) == ([], [])
    return {Path(href).stem for href in hrefs}


def indexed_words() -> set[str]:
    """The words of the index; a word of an earlier build stands there without a page."""
    index = json.loads(re.search(r"\{.*\}", (HTML / "searchindex.js").read_text(encoding="utf-8"))[0])
    return {word for word, pages in index["terms"].items() if pages != []}


@pytest.mark.parametrize(("plain", "form"), FORMS)
def test_a_number_has_one_word_in_all_its_forms(plain, form):
    assert SPLIT(form) == [f"={plain}"] == SPLIT(plain)


def test_words_and_names_stay_words():
    assert SPLIT("the 2 gains K_A, x1 of Eq.125") == ["the", "=2", "gains", "K_A", "x1", "of", "Eq", "=125"]


@given(st.floats(min_value=1e-30, max_value=1e30))
def test_a_number_as_python_writes_it_keeps_its_value(value):
    (word,) = SPLIT(repr(value))
    assert float(word[1:]) == value


def test_the_browser_makes_the_same_words(visit):
    values = [10.0**k * m for k in range(-12, 24) for m in (1, 1.25, 6.02214076)]
    texts = [form for _, form in FORMS] + [f"{v!r}" for v in values] + ["φ_1 K_A 0.618s^2 v1.2.3 naïve 3rd"]
    with visit("search.html", plain=True) as (page, _, _):
        assert page.evaluate("texts => texts.map(text => splitQuery(text))", texts) == [*map(SPLIT, texts)]


@pytest.mark.parametrize(
    ("query", "wanted"),
    [
        ("1940", {"04-rate-and-attitude-feedback", "12-agreement"}),
        ("0.618", {"04-rate-and-attitude-feedback", "10-loci-and-maps", "12-agreement"}),
        ("6.545e-10", {"07-dual-actuation", "12-agreement"}),
        (r"6.545 \times 10^{-10}", {"07-dual-actuation"}),
        ("429000000", {"02-trajectory-and-modes"}),  # Table 1, printed as 4.290 and a power of ten
        ("19,400", {"04-rate-and-attitude-feedback"}),  # Eq. 73
    ],
)
def test_a_printed_number_is_found(visit, query, wanted):
    assert wanted <= pages_found(visit, query)


def test_a_number_that_is_nowhere_finds_nothing_but_its_first_digits_do(visit):
    assert pages_found(visit, "987654.3217") == set()
    assert "07-dual-actuation" in pages_found(visit, "6.54")


def test_each_printed_number_of_the_ledger_is_in_the_index():
    terms = indexed_words()
    printed = as_frame(rl.ledger())["printed"]
    numbers = {abs(float(value)) for value in printed if re.fullmatch(r"-?[0-9.]+(e-?[0-9]+)?", str(value))}
    assert len(numbers) > 200
    assert [value for value in numbers if SPLIT(repr(value))[0] not in terms] == []


@pytest.mark.parametrize("query", ["import", "vehicle", "1940"])
def test_excerpts_show_no_source_code(visit, query):
    with visit(f"search.html?q={query}", plain=True) as (page, _, _):
        page.wait_for_function("() => /finished|did not match/.test(document.body.innerText)")
        page.wait_for_load_state("networkidle")
        excerpts = page.locator(EXCERPTS).all_inner_texts()
    code = [text for text in excerpts if re.search(r"\bimport \w+|from rlswaim|rl\.\w+\(|glue_all", text)]
    assert code == []
    assert query == "import" or excerpts


def test_an_excerpt_shows_the_number_that_was_searched(visit):
    with visit("search.html?q=6.545e-10", plain=True) as (page, _, _):
        page.wait_for_function("() => /finished|did not match/.test(document.body.innerText)")
        page.wait_for_load_state("networkidle")
        excerpts = page.locator(EXCERPTS).all_inner_texts()
    assert excerpts
    assert all("=6.545e-10" in SPLIT(text) for text in excerpts)


def test_source_code_is_not_indexed():
    terms = indexed_words()
    assert {"booster", "=1940"} <= terms
    assert not {"glue_al", "glue_all", "matplotlib_inline", "verdict-agrees"} & terms
