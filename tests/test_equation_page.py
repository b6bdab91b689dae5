"""Every equation of the report on one page: set by the directive, typeset by MathJax, with its cards."""

import re
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from rlswaim.edition.ledger import VERDICTS, ledger
from rlswaim.edition.tables_as_printed import printed_table
from rlswaim.source.equations import templates
from serve import server

EXTENSIONS = Path(__file__).parent.parent / "book" / "extensions"
ENTRIES = {entry.id: entry for entry in ledger()}
PLACES = {key: found.entries for key, found in templates().items()}

CONF = """
import sys
sys.path.insert(0, {extensions!r})
extensions = ["myst_parser", "sphinx.ext.mathjax", "sphinx-mathjax-offline"]
extensions += ["report_numbers", "report_equations"]
myst_enable_extensions = ["colon_fence"]
numfig = True
html_theme = "basic"
"""
PAGE = """# Equations

See {{eq}}`eq-38` and {{eq}}`eq-133`.

:::{{verdict-legend}}
:::

```{{report-equation}}
{one_a_line}
```

:::{{report-equation}} {the_rest}
:::

See {{numref}}`tab-2`.

:::{{report-table}} 1
:::

:::{{report-table}} 2
:::

:::{{report-table}} 3
:::
"""


def sphinx(folder: Path, page: str) -> subprocess.CompletedProcess[str]:
    """Build a page with warnings as errors."""
    source = folder / "source"
    source.mkdir()
    (source / "conf.py").write_text(CONF.format(extensions=str(EXTENSIONS)), encoding="utf-8")
    (source / "index.md").write_text(page, encoding="utf-8")
    command = [
        sys.executable,
        "-m",
        "sphinx",
        "-q",
        "-W",
        "-n",
        "-b",
        "html",
        str(source),
        str(folder / "html"),
    ]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def all_equations(tmp_path_factory):
    """The address of a page with every equation."""
    folder = tmp_path_factory.mktemp("equations")
    keys = list(templates())
    done = sphinx(folder, PAGE.format(one_a_line="\n".join(keys[:80]), the_rest=", ".join(keys[80:])))
    assert done.returncode == 0, done.stderr
    with server(folder / "html") as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}/index.html"
        running.shutdown()


@pytest.fixture(scope="module")
def page(browser, all_equations):
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    opened, errors = context.new_page(), []
    opened.on("pageerror", lambda error: errors.append(str(error)))
    opened.goto(all_equations, wait_until="load")
    opened.wait_for_function("() => document.documentElement.dataset.printedNumbers")
    yield opened
    context.close()
    assert errors == []


def test_mathjax_sets_all_equations_and_ties_each_number(page):
    assert page.locator("mjx-merror, [data-mjx-error]").count() == 0
    assert page.locator("div.report-equation mjx-container").count() == len(templates())
    tied = page.evaluate(
        """() => Object.fromEntries([...document.querySelectorAll('div.report-equation')].map((el, i) =>
             [i, [...el.querySelectorAll('.printed')].map((n) => [n.dataset.entry, n.textContent])]))"""
    )
    wanted = {str(i): list(found.entries) for i, found in enumerate(templates().values())}
    assert {i: [entry for entry, _ in numbers] for i, numbers in tied.items()} == wanted


def test_equations_have_the_report_s_numbers(page):
    numbers = page.locator("div.report-equation .eqno").all_text_contents()
    assert [re.match(r"\((\d+)\)", n)[1] for n in numbers] == [str(n) for n in range(1, 138)]
    assert page.locator("a.internal[href='#equation-eq-38']").text_content() == "(38)"


def test_tables_have_their_numbers_and_marks(page):
    tables = page.locator("table.report-table")
    captions = [" ".join(words.split()) for words in tables.locator("caption").all_text_contents()]
    assert [words[:8] for words in captions] == ["Table 1 ", "Table 2 ", "Table 3 "]
    for i in range(3):
        entries_shown = (
            tables.nth(i).locator(".printed").evaluate_all("all => all.map((n) => n.dataset.entry)")
        )
        assert tuple(entries_shown) == printed_table(i + 1).entries
    assert page.locator("a.internal[href='#tab-2']").text_content() == "Table 2"


def card(page):
    return page.locator(".printed-card")


def equation(number: int) -> str:
    return f"[id='equation-eq-{number}']"


def test_a_card_opens_under_the_pointer_and_can_be_entered(page):
    row = ENTRIES["eq61-g_1"]
    number = page.locator(f"{equation(61)} .printed[data-entry='eq61-g_1']").first
    number.hover()
    card(page).wait_for(state="visible")
    shown = card(page).inner_text()
    assert [
        words for words in (row.printed, f"{row.computed:.5g}", row.verdict, row.why) if words not in shown
    ] == []
    card(page).hover()
    page.wait_for_timeout(400)
    assert card(page).is_visible()
    assert card(page).locator("a").get_attribute("href").endswith("/book/12-agreement.html#eq61-g_1")
    page.keyboard.press("Escape")
    assert card(page).is_hidden()


def test_a_touch_opens_a_card_and_another_one_closes_it(page):
    page.locator(f"{equation(79)} .printed[data-entry='eq79-mode1-w2']").dispatch_event("click")
    card(page).wait_for(state="visible")
    assert "misread or misprint" in card(page).inner_text()
    page.locator("h1").dispatch_event("click")
    assert card(page).is_hidden()


def test_a_card_tells_what_is_given_and_what_is_reprinted(page):
    for at, entry, words in (
        (99, "eq99-b", "Data or a choice of the report"),
        (42, "eq42-M_q1", "row eq38-M_q1 judges it"),
    ):
        page.locator(f"{equation(at)} .printed[data-entry='{entry}']").first.dispatch_event("click")
        card(page).get_by_text(words).wait_for()
    page.keyboard.press("Escape")


def test_one_tab_stop_leads_to_all_numbers_of_an_equation(page):
    stop = page.locator(f".printed-numbers-button:has(+ {equation(41)})")
    assert stop.text_content().startswith("6 printed numbers: 4 agrees, 2 rounding.")
    stop.focus()
    seen = []
    for key in ("Home", *["ArrowRight"] * 6):
        page.keyboard.press(key)
        page.wait_for_timeout(50)
        seen.append(card(page).get_attribute("data-entry"))
    assert tuple(seen) == (*PLACES["41"], PLACES["41"][-1])
    assert page.locator(f"{equation(41)} .printed[tabindex], {equation(41)} [tabindex='0']").count() == 0


def test_screen_readers_meet_each_number_once(page):
    assert page.locator("mjx-assistive-mml .printed").count() == 0


def test_verdicts_differ_by_shape_and_not_by_color_alone(page):
    shapes = page.evaluate(
        """() => [...document.querySelectorAll('.printed-sample')].map((el) => {
             const line = getComputedStyle(el, '::after');
             return [line.borderBottomStyle, line.borderBottomWidth, line.borderTopStyle === 'none' ? 0
               : line.borderTopWidth, getComputedStyle(el, '::before').content].join(' ');
           })"""
    )
    assert len(shapes) == len(set(shapes)) == len(VERDICTS)


def test_a_wrong_number_stops_the_build(tmp_path):
    done = sphinx(tmp_path, "# Page\n\n:::{report-equation} 138\n:::\n")
    assert done.returncode != 0
    assert "equation: got '138', wanted 1 to 137" in done.stderr


def test_nothing_comes_from_another_server():
    for name in ("report_equations.js", "report_equations.css"):
        assert re.findall(r"https?://", (EXTENSIONS / name).read_text(encoding="utf-8")) == []


def test_a_box_touches_nothing_that_follows_its_number(page):
    """The box lies over the line and moves nothing; the formula leaves room for it."""
    gaps = page.evaluate(
        """() => [...document.querySelectorAll('div.report-equation .printed')].flatMap((el) => {
             const box = getComputedStyle(el, '::after');
             if (box.borderRightStyle === 'none' || !parseFloat(box.borderRightWidth)) return [];
             const here = el.getBoundingClientRect();
             const glyphs = [...el.closest('mjx-container').querySelectorAll('mjx-c')];
             const after = glyphs[glyphs.findLastIndex((glyph) => el.contains(glyph)) + 1];
             const next = after && after.getBoundingClientRect();
             const beside = next && next.left > here.left && next.top < here.bottom && next.bottom > here.top;
             return beside ? [[el.dataset.entry, next.left - (here.right - parseFloat(box.right))]] : [];
           })"""
    )
    assert len(gaps) > 50
    assert {entry: gap for entry, gap in gaps if gap < 0} == {}
