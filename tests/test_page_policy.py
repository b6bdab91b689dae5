"""Each built page carries a policy under which nothing loads from elsewhere and no text runs as code."""

import base64
import hashlib
from html.parser import HTMLParser

import pytest

from test_pages import HTML, PAGES

INLINE = """() => { const script = document.createElement('script'); script.textContent = 'window.ran = 1';
  document.head.append(script);
  const image = document.createElement('button'); image.setAttribute('onclick', 'window.ran = 2');
  document.body.append(image); image.click(); return window.ran ?? null; }"""
EVALUATED = """try { window.sum = eval('1 + 1'); } catch (error) { window.sum = error.name; }"""


class Policed(HTMLParser):
    """Collects a page's policies, inline scripts and inline handlers."""

    def __init__(self) -> None:
        super().__init__()
        self.policies: list[str] = []
        self.handlers: list[str] = []
        self.scripts: list[str] = []
        self.in_script = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.handlers += [name for name in given if name.startswith("on")]
        if given.get("http-equiv") == "Content-Security-Policy":
            self.policies.append(given["content"])
        self.in_script = tag == "script" and "src" not in given and "json" not in given.get("type", "")

    def handle_data(self, data: str) -> None:
        if self.in_script:
            self.scripts.append(data)
            self.in_script = False


@pytest.mark.parametrize("path", PAGES)
def test_a_policy_names_each_inline_script(path):
    page = Policed()
    page.feed((HTML / path).read_text(encoding="utf-8"))
    (policy,) = page.policies
    allowed = next(part for part in policy.split("; ") if part.startswith("script-src"))
    hashes = {
        f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
        for text in page.scripts
    }
    assert page.scripts
    assert set(allowed.split()[1:]) == {"'self'", "blob:"} | hashes
    assert page.handlers == []


def test_text_does_not_run_as_code(visit):
    with visit("book/preface.html") as (page, _, _):
        assert page.evaluate(INLINE) is None
        page.route(
            "**/evaluated.js", lambda route: route.fulfill(body=EVALUATED, content_type="text/javascript")
        )
        page.add_script_tag(url="evaluated.js")
        assert page.evaluate("() => window.sum") == "EvalError"


def test_the_buttons_for_print_and_full_screen_work(visit):
    with visit("book/preface.html") as (page, _, errors):
        page.evaluate("() => { window.print = () => { window.printed = true; }; }")
        page.evaluate("() => document.querySelector('[data-page-button=print]').click()")
        assert page.evaluate("() => window.printed")
        page.locator("[data-page-button=full-screen]").click()
        page.wait_for_function("() => document.fullscreenElement")
        assert errors == []
