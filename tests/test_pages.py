"""Every built page in a real browser with the network cut: nothing from outside, no error, math typeset."""

import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag, urljoin, urlsplit

import pytest
import yaml

import rlswaim as rl

ROOT = Path(__file__).parent.parent
HTML = ROOT / "_build" / "html"
TOC = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
CHAPTERS = [TOC["root"], *(c["file"] for part in TOC["parts"] for c in part["chapters"])]
PAGES = [f"{name}.html" for name in (*CHAPTERS, "search", "genindex")]

FAULTS = """() => ({
  plainMath: [...document.querySelectorAll('.math')].filter(el => !el.querySelector('mjx-container')).length,
  badMath: [...document.querySelectorAll('mjx-merror, [data-mjx-error]')].map(el => el.textContent),
  noAlt: [...document.images].filter(el => !el.alt.trim()).map(el => el.src),
  broken: [...document.images].filter(el => el.complete && !el.naturalWidth).map(el => el.src),
  noAxes: [...document.querySelectorAll('.live-view-failure')].map(el => el.textContent),
})"""


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


@pytest.mark.parametrize("path", PAGES)
def test_page_is_whole_without_a_network(visit, path):
    with visit(path) as (page, outside, errors):
        page.wait_for_load_state("networkidle")
        assert outside == []
        assert errors == []
        assert {what: found for what, found in page.evaluate(FAULTS).items() if found} == {}
        assert page.title().strip(" #—-")
        if path.removesuffix(".html") in CHAPTERS:
            assert page.locator("article h1").count() == 1


def test_pages_are_served_under_a_policy_against_code_from_text(visit):
    trial = "setTimeout(() => { try { window.sum = eval('1 + 1'); } catch (e) { window.sum = e.name; } })"
    with visit("book/preface.html") as (page, _, _):
        page.add_script_tag(content=trial)
        page.wait_for_function("() => window.sum")
        assert page.evaluate("() => window.sum") == "EvalError"


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


# ---- the ledger's page: the table is the ledger, and its search finds


def test_printed_numbers_can_be_searched(visit):
    with visit("book/12-agreement.html") as (page, outside, errors):
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
