"""The report's equations as printed: all there, no number typed, each number tied to its ledger row."""

import re

import pytest

from rlswaim.edition.equations_as_printed import as_tex, digits, rows, template, with_numbers
from rlswaim.edition.ledger import KINDS, kind_counts, ledger
from rlswaim.edition.tables_as_printed import printed_table
from rlswaim.source.equations import PLACE, parse, templates
from rlswaim.source.tables import half_unit

UNNUMBERED = ("37a", "37b", "39a", "40a", "41a", "46a", "75a", "84a", "87a", "125a", "133a", "135a", "136a")
ENTRIES = {entry.id: entry for entry in ledger()}
PLACES = {key: found.entries for key, found in templates().items()}
MARK = re.compile(
    r"(-?)\\class\{printed (verdict-[a-z-]+) kind-[a-z]+ entry-([^}]+)\}\{(-?)((?:[^{}]|\{[^{}]*\})+)\}"
)
# A factor s of Eqs. 77 to 82 stands for a root: there is no digit to mark.
WITHOUT_A_DIGIT = {f"eq{number}-origin-root" for number in range(77, 83)}


def text(tex: str) -> str:
    """Return a number's TeX as the ledger writes it, without its sign."""
    plain = tex.replace("{,}", ",")
    power = re.fullmatch(r"(?:(.+)\\times)?10\^\{(-?\d+)\}", plain)
    return f"{power[1] or 1}e{power[2]}" if power else plain


# ---- the templates


def test_all_137_equations_are_there_in_order():
    assert [key for key in templates() if key.isdigit()] == [str(n) for n in range(1, 138)]
    assert tuple(key for key in templates() if not key.isdigit()) == UNNUMBERED
    numbers = [int(key.rstrip("ab")) for key in templates()]
    assert numbers == sorted(numbers)


def test_every_place_is_a_row_of_the_ledger():
    assert {e for places in PLACES.values() for e in places} - rows().keys() == set()


def test_every_row_of_an_equation_stands_in_it():
    for entry in rows():
        found = re.match(r"eq(\d+)-", entry)
        if found and entry not in WITHOUT_A_DIGIT:
            own = PLACES[found[1]] + PLACES.get(f"{found[1]}a", ())
            assert entry in own, entry


def equations_named(where: str) -> set[str]:
    """Return the keys of the equations that a row names: "Eqs. 42 to 44, 47" are four."""
    if not where.startswith("Eq"):
        return set()
    named = re.match(r"Eqs?\. ((?:\d+(?: to \d+)?(?:, )?(?:and )?)+)", where)[1]
    keys: set[str] = set()
    for first, last in re.findall(r"(\d+)(?: to (\d+))?", named):
        keys |= {str(n) for n in range(int(first), int(last or first) + 1)}
    return keys


def test_a_row_stands_in_every_equation_that_it_names():
    """But where Eq. 42 repeats Eq. 38 it has rows of its own, which Eqs. 43 to 49 share among them."""
    for entry, row in rows().items():
        for key in equations_named(row["where"]) if entry not in WITHOUT_A_DIGIT else ():
            named = PLACES[key] + PLACES.get(f"{key}a", ())
            assert entry in named or entry.startswith("eq42-") or (entry[:5], key) == ("eq38-", "42"), entry


def without_indices(tex: str) -> str:
    """Return TeX without places, words, subscripts, exponents and the distances between lines."""
    tex = PLACE.sub("", tex)
    tex = re.sub(r"\\text\{[^{}]*\}|\\frac12|\\frac1t", "", tex)
    return re.sub(r"[_^](?:\{[^{}]*\}|\w|\\\w+)", "", tex)


@pytest.mark.parametrize("key", templates())
def test_no_number_is_typed(key):
    """Left are zeros and ones of determinants, and the 2 of 2 zeta omega."""
    tex = without_indices(template(key).tex)
    assert re.findall(r"\d*\.\d+", tex) == []
    assert set(re.findall(r"\d+", tex)) <= {"0", "1", "2"}


@pytest.mark.parametrize("key", templates())
def test_tex_is_balanced(key):
    tex = as_tex(key)
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", tex):
        depth += 1 if brace == "{" else -1
        assert depth >= 0
    assert depth == 0
    assert len(re.findall(r"\\left(?![a-z])", tex)) == len(re.findall(r"\\right(?![a-z])", tex))
    opened: list[str] = []
    for what, name in re.findall(r"\\(begin|end)\{(\w+)\}", tex):
        if what == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert opened == []


def test_notes_are_sentences():
    assert [found.key for found in templates().values() if found.note and not found.note.endswith(".")] == []


# ---- the numbers in them


@pytest.mark.parametrize("key", [key for key, places in PLACES.items() if places])
def test_a_number_is_the_ledger_s_digit_by_digit(key):
    marks = MARK.findall(as_tex(key))
    assert tuple(mark[2] for mark in marks) == PLACES[key]
    for _, verdict, entry, _, tex in marks:
        assert text(tex) == rows()[entry]["printed"].lstrip("-")
        assert verdict == f"verdict-{rows()[entry]['verdict'].replace(' ', '-')}"


def test_signs():
    mark = r"\class{printed verdict-rounding kind-result entry-eq38-Z_q1}{%s}"
    places = "".join(rf"\{place}{{eq38-Z_q1}}" for place in ("printed", "turned", "plus", "minus"))
    written = [with_numbers(place) for place in re.findall(r"\\\w+\{[^}]+\}", places)]
    assert rows()["eq38-Z_q1"]["printed"] == "-4.682"
    assert written == [mark % "-4.682", mark % "4.682", "-" + mark % "4.682", "+" + mark % "4.682"]


def test_signs_of_roots_are_those_of_the_report():
    """Each root's sign, where the machine reading has it: in Eqs. 41, 92 and 118."""
    tex = {key: re.sub(r"\\[,;]", "", as_tex(key)) for key in ("41", "92", "118")}
    plain = {key: MARK.sub(lambda m: m[1] + m[4] + text(m[5]), found) for key, found in tex.items()}
    assert "(s-1.31)(s+1.54)(s^2+.0236s+1.323)" in plain["41"].replace("\n", "")
    assert "(s-1.148)(s+.00011)(s+1.343)(s+.027\\pm j2.865)" in plain["92"].replace("\n", "")
    assert "(s+.9)(s-2.8\\pm j2.25)(s+2.55\\pm j6.8)(s+5\\pm j4.3)s" in plain["118"].replace("\n", "")


def test_powers_of_ten_and_thousands():
    assert [digits(n) for n in ("-.538e-6", "1e7", "19,400", "0")] == [
        r".538\times10^{-6}",
        "10^{7}",
        "19{,}400",
        "0",
    ]


def test_an_unknown_equation_is_refused():
    with pytest.raises(ValueError, match="equation: got '138', wanted 1 to 137 or one of 37a"):
        template("138")


def test_a_note_may_run_over_lines():
    found = parse("% eq 7\nx = y\n% note: One line\n%  and another.\n% eq 8\nz\n")
    assert [(t.key, t.tex, t.note) for t in found.values()] == [
        ("7", "x = y", "One line and another."),
        ("8", "z", ""),
    ]


# ---- the tables


def test_every_row_of_a_table_stands_in_it_once():
    for number in ("1", "2", "3"):
        shown = printed_table(number).entries
        below = PLACES["37b"] if number == "2" else ()
        own = {entry for entry in rows() if entry.startswith(f"tab{number}-")} - {"tab1-l_CG"}
        assert len(shown) == len(set(shown))
        assert {*shown, *below} == own


def test_tables_have_the_report_s_shape():
    assert [len(printed_table(n).lines) for n in (1, 2, 3)] == [12, 12, 12]
    for number in (1, 2, 3):
        found = printed_table(number)
        assert {len(line) for line in found.lines} == {len(found.heads)}
    with pytest.raises(ValueError, match="table"):
        printed_table(4)


# ---- what kind each row is


def test_every_row_has_a_kind():
    assert {entry.kind for entry in ENTRIES.values()} == set(KINDS)
    assert [e.id for e in ENTRIES.values() if bool(e.of) != (e.kind == "reprint")] == []


def test_what_is_given_agrees_by_itself():
    given = [entry for entry in ENTRIES.values() if entry.kind == "given"]
    assert len(given) > 100
    assert [e.id for e in given if not e.agrees] == []
    assert [e.id for e in ENTRIES.values() if e.quantity.endswith("(a choice)") and e.kind == "result"] == []


def test_a_reprint_repeats_the_digits_of_a_result_or_of_what_is_given():
    """But for its sign, a digit rounded off in Eqs. 131 and 132, and the point of Eq. 38's gust."""
    reprints = [entry for entry in ENTRIES.values() if entry.kind == "reprint"]
    assert len(reprints) > 150
    for again in reprints:
        first = ENTRIES[again.of]
        assert first.kind != "reprint", again
        if again.id != "eq38-gust_M":
            slack = half_unit(again.printed) if "jet_M" in again.id else 0.0
            assert abs(abs(again.value) - abs(first.value)) <= slack * (1 + 1e-9), again


def test_kinds_are_counted_apart():
    found = kind_counts()
    assert found.loc["all", "all"] == found.loc[[*KINDS], "all"].sum() == len(ENTRIES)
    assert (found[["agrees", "rounding", "more"]].sum(axis=1) == found["all"]).all()
    assert found.loc["given", "agrees"] == found.loc["given", "all"]
    results = [entry for entry in ENTRIES.values() if entry.kind == "result"]
    assert found.loc["result", "agrees"] == sum(entry.agrees for entry in results)
