"""Every built page in a real browser with the network cut: nothing from outside, no error, math typeset."""

import re
import struct
from collections.abc import Iterator
from html.parser import HTMLParser
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import unquote, urldefrag, urljoin, urlsplit

import pandas as pd
import pytest
import yaml
from docutils import nodes

import rlswaim as rl
from conftest import HTML, Visit
from extensions.how_to_cite import HowToCite
from extensions.typeset_tables import typeset
from rlswaim.edition.ledger import as_frame

ROOT = Path(__file__).parent.parent
TOC = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
CONFIG = yaml.safe_load((ROOT / "_config.yml").read_text(encoding="utf-8"))["sphinx"]["config"]
CHAPTERS = [TOC["root"], *(c["file"] for part in TOC["parts"] for c in part["chapters"])]
PAGES = [f"{name}.html" for name in (*CHAPTERS, "search", "genindex")]

FAULTS = """() => ({
  plainMath: [...document.querySelectorAll('.math')].filter(el => !el.querySelector('mjx-container')).length,
  badMath: [...document.querySelectorAll('mjx-merror, [data-mjx-error]')].map(el => el.textContent),
  tabStops: [...document.querySelectorAll('mjx-container')].filter(el => el.tabIndex >= 0).length,
  noAlt: [...document.images].filter(el => !el.alt.trim()).map(el => el.src),
  broken: [...document.images].filter(el => el.complete && !el.naturalWidth).map(el => el.src),
  noAxes: [...document.querySelectorAll('.live-view-failure')].map(el => el.textContent),
})"""

LEAST, TALLEST = 500, 20_000
"""Heights of pages (px)."""
SCROLLED = """async () => {
  const all = document.documentElement;
  for (let y = 0; y < all.scrollHeight; y += 800) {
    scrollTo(0, y);
    await new Promise(next => setTimeout(next, 30));
  }
}"""


class Links(HTMLParser):
    """Collects a page's links, the ids they can point to, and what it loads."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.ids: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {key: value or "" for key, value in attrs}
        self.ids |= {given[key] for key in ("id", "name") if given.get(key)}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        elif "src" in given:
            self.loaded.append(given["src"])
        elif tag == "link" and given.get("rel") in {"stylesheet", "preload", "modulepreload", "icon"}:
            self.loaded.append(given["href"])


def parsed(page: str) -> Links:
    links = Links()
    links.feed((HTML / page).read_text(encoding="utf-8"))
    return links


@pytest.fixture(scope="module")
def links() -> dict[str, Links]:
    return {path.relative_to(HTML).as_posix(): parsed(str(path)) for path in sorted(HTML.rglob("*.html"))}


@pytest.fixture(scope="module", params=PAGES)
def opened(visit, request) -> Iterator[tuple[str, Visit]]:
    """A page as it opens, and its path."""
    with visit(request.param) as found:
        found.page.wait_for_timeout(500)  # what comes late
        yield request.param, found


def test_page_is_whole_without_a_network(opened):
    path, (page, outside, errors) = opened
    assert outside == []
    assert errors == []
    assert {what: found for what, found in page.evaluate(FAULTS).items() if found} == {}
    assert page.title().strip(" #—-")
    if path.removesuffix(".html") in CHAPTERS:
        assert page.locator("article h1").count() == 1


def test_page_is_not_too_tall_to_find_one_s_way_in(opened):
    """Its height at 1280 px, all folds closed, once all that comes when it is in sight has come."""
    path, (page, outside, errors) = opened
    assert page.evaluate("innerWidth") == 1280
    page.evaluate(SCROLLED)
    page.wait_for_timeout(300)
    assert page.locator("details.hide[open], details.sd-dropdown[open]").count() == 0
    height = page.evaluate("document.documentElement.scrollHeight")
    assert LEAST < height <= TALLEST, path
    assert (outside, errors) == ([], [])


def test_every_page_of_the_contents_is_built(links):
    assert set(PAGES) <= set(links)


def test_no_page_loads_from_another_server(links):
    loaded = [(page, address) for page, found in links.items() for address in found.loaded]
    assert [pair for pair in loaded if urlsplit(pair[1]).netloc] == []


def test_no_page_names_a_content_network(links):
    named = re.compile(r"(?:src|href)=[\"'][^\"']*(?:cdn|unpkg|googleapis|gstatic)", re.IGNORECASE)
    assert [page for page in links if named.search((HTML / page).read_text(encoding="utf-8"))] == []


def test_internal_links_lead_somewhere(links):
    lost = []
    for page, found in links.items():
        for link in found.links:
            address, anchor = urldefrag(urljoin(page, link))
            target = unquote(address) or page
            if urlsplit(link).scheme or urlsplit(link).netloc or (link.startswith("#") and not anchor):
                continue
            if re.match(r"[\w-]+:", anchor):  # a state of a live view: test_exercises opens it
                continue
            if not (HTML / target).is_file() or (
                anchor and target in links and unquote(anchor) not in links[target].ids
            ):
                lost.append(f"{page}: {link}")
    assert lost == []


# ---- what a page says of itself, and how to cite the edition


class Head(HTMLParser):
    """Collects what a page's head says of it, and its text."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.said: dict[str, list[str]] = {}
        self.feed((HTML / page).read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {key: value or "" for key, value in attrs}
        if tag == "meta" and (name := given.get("name") or given.get("property")):
            self.said.setdefault(name, []).append(given.get("content", ""))


@pytest.mark.parametrize("page", CHAPTERS)
def test_each_page_says_what_it_is_about_and_shows_a_picture(page):
    said = Head(f"{page}.html").said
    (told,), (title,), (picture,) = said["description"], said["og:title"], said["og:image"]
    assert told == CONFIG["page_descriptions"][page]
    assert 60 <= len(told) <= 160
    assert said["og:description"] == [told]
    assert title in (HTML / f"{page}.html").read_text(encoding="utf-8").partition("</title>")[0]
    assert not urlsplit(picture).netloc
    found = (HTML / urljoin(f"{page}.html", picture)).read_bytes()
    assert found.startswith(b"\x89PNG")
    assert struct.unpack(">II", found[16:24]) == (1200, 630)
    assert [said[f"og:image:{side}"] for side in ("width", "height")] == [["1200"], ["630"]]


def test_descriptions_are_of_the_pages_that_there_are_and_differ():
    assert set(CONFIG["page_descriptions"]) == set(CHAPTERS)
    assert len(set(CONFIG["page_descriptions"].values())) == len(CHAPTERS)


def test_how_to_cite_is_what_the_citation_file_says(visit):
    cff = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    report = cff["references"][0]
    assert cff["version"] == version("rlswaim")
    with visit("book/09-references.html") as (page, _, _):
        section = page.locator("section:has(> h2:has-text('How to cite'))").inner_text()
    assert "<" not in section
    first, second = section.partition("@techreport")[::2]
    for words in (cff["title"], cff["version"], cff["authors"][0]["name"], "@software{rlswaim,"):
        assert words in first
    for words in (report["title"], str(report["year"]), "Robert L. Swaim", report["institution"]["location"]):
        assert words in second


def test_how_to_cite_sets_each_work_as_a_line_without_markup_and_an_entry():
    cff = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    env = SimpleNamespace(note_dependency=lambda _: None)
    found = HowToCite.run(SimpleNamespace(env=env))
    assert [type(node) for node in found] == [nodes.paragraph, nodes.literal_block] * 2
    for line, work in zip(found[::2], (cff, cff["references"][0]), strict=True):
        assert [node.astext() for node in line.findall(nodes.emphasis)] == [work["title"]]
        assert work["title"] in line.astext()
    assert not any("<" in node.astext() for node in found)


# ---- the ledger's page: the table is the ledger, its search finds, and on paper all rows stand


def test_the_ledger_s_page_prints_every_row(visit):
    wanted = as_frame(rl.ledger()).reset_index()
    with visit("book/12-agreement.html", plain=True) as (page, _, errors):
        page.locator(".dt-search input").wait_for()
        rows = page.locator("#printed-numbers tbody tr")
        assert rows.count() < len(wanted)
        page.evaluate("() => window.dispatchEvent(new Event('beforeprint'))")
        assert page.locator(".dt-search").count() == 0
        texts = rows.evaluate_all("rows => rows.map(row => [...row.cells].map(cell => cell.textContent))")
        shown = pd.DataFrame(texts).iloc[:, : wanted.shape[1]].replace("’", "'", regex=True)
        wanted = wanted.map(lambda text: "".join(node.astext() for node in typeset(str(text))))
        assert (shown.to_numpy() == wanted.to_numpy()).all(axis=0).tolist() == [True] * wanted.shape[1]
        page.evaluate("() => window.dispatchEvent(new Event('afterprint'))")
        assert page.locator(".dt-search").count() == 1
        assert errors == []


def test_numbers_and_words_of_the_ledger_are_found_by_the_book_s_search(visit):
    with visit("search.html?q=eq136-zero-c2-re", plain=True) as (page, _, errors):
        page.locator("#search-results li a").first.wait_for()
        found = page.locator("#search-results li a").evaluate_all("links => links.map(link => link.href)")
        assert any("12-agreement" in address for address in found)
        assert errors == []


def test_printed_numbers_can_be_searched(visit):
    with visit("book/12-agreement.html", plain=True) as (page, outside, errors):
        box, info = page.locator(".dt-search input"), page.locator(".dt-info")
        box.wait_for()
        assert f"of {len(rl.ledger())} entries" in info.text_content()
        box.fill("plot reading")
        wanted = [e for e in rl.ledger() if "plot reading" in f"{e.quantity} {e.verdict} {e.why}"]
        page.wait_for_function("() => document.querySelector('.dt-info').textContent.includes('filtered')")
        assert f"of {len(wanted)} entries" in info.text_content()
        first = page.locator("#printed-numbers tbody tr").first.locator("td").all_text_contents()
        assert first[0] == wanted[0].id
        assert first[3] == wanted[0].printed
        assert (outside, errors) == ([], [])
