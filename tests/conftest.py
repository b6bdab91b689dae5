"""What the tests share: hypothesis profiles, the built book on a local server, a browser without network."""

import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import HealthCheck, settings
from playwright.sync_api import Browser, Page, sync_playwright

from chromium import FLAGS, NoChromiumError, find_chromium
from livepage import LivePage, live
from plain_pages import PlainHandler
from rlswaim.explorers import Explorer
from serve import Handler, server
from standin import opened
from workbench_page import EQUATIONS, VIEWS

ROOT = Path(__file__).parent.parent
HTML = Path(os.environ.get("HTML", ROOT / "_build" / "html"))
"""The built book, or one that was built in another way."""

MATHJAX = "() => !document.querySelector('script[src*=mathjax i]') || window.MathJax?.startup?.promise"
"""MathJax has started, where a page has it: its script comes late, after its settings."""

settings.register_profile(
    "ci", derandomize=True, deadline=None, max_examples=60, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("search", parent=settings.get_profile("ci"), derandomize=False, max_examples=2000)
PROFILE = os.environ.get("HYPOTHESIS_PROFILE", "ci")
settings.load_profile(PROFILE)


def cases(count: int) -> int:
    """Return how many random cases a test tries: so many, or those of `make fuzz`."""
    return settings().max_examples if PROFILE == "search" else count


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run a test with a browser once more if it fails, as a busy machine may be late: what fails twice fails.

    The summary of a run names each test that ran twice.
    """
    for item in items:
        if {"browser", "other"} & set(getattr(item, "fixturenames", ())):
            item.add_marker(pytest.mark.flaky(reruns=1))


class Visit(NamedTuple):
    """A page, and all that went wrong or outside while it was open."""

    page: Page
    outside: list[str]
    errors: list[str]


@contextmanager
def served(handler: type[Handler]) -> Iterator[str]:
    """Serve the built book; the address of its root, without the last slash."""
    if not (HTML / ".built").is_file():
        pytest.fail("the book is not built: run `make book` first", pytrace=False)
    with server(HTML, handler=handler) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}"
        running.shutdown()


@pytest.fixture(scope="session")
def site() -> Iterator[str]:
    """The address of the built book."""
    with served(Handler) as address:
        yield address


@pytest.fixture(scope="session")
def plain_site() -> Iterator[str]:
    """The address of the built book without formulas and icons, for tests that look at neither."""
    with served(PlainHandler) as address:
        yield address


@contextmanager
def launched(window: bool = False) -> Iterator[Browser]:
    """Start a Chromium that resolves no name: the browser that readers have, or the engine alone."""
    try:
        path = find_chromium(window)
    except NoChromiumError as error:
        pytest.fail(str(error), pytrace=False)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=FLAGS)
        yield chromium
        chromium.close()


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """A Chromium, the engine alone where it is there."""
    with launched() as chromium:
        yield chromium


@pytest.fixture(scope="module")
def visit(browser: Browser, site: str, plain_site: str) -> Callable[..., Iterator[Visit]]:
    """Open a page of the book by its path, in a fresh context; the browser resolves no name outside.

    A plain page has its formulas as text and no icons, for tests that look at neither.
    """

    @contextmanager
    def opened(path: str, plain: bool = False) -> Iterator[Visit]:
        context = browser.new_context(viewport={"width": 1280, "height": 900})
        page = context.new_page()
        found = Visit(page, [], [])

        root = plain_site if plain else site
        inside = (f"{root}/", "data:", "blob:")
        page.on("request", lambda r: r.url.startswith(inside) or found.outside.append(r.url))
        page.on("pageerror", lambda error: found.errors.append(f"page error: {error}"))
        page.on("console", lambda line: line.type == "error" and found.errors.append(f"console: {line.text}"))
        page.on("response", lambda r: r.status >= 400 and found.errors.append(f"{r.status} {r.url}"))
        page.goto(f"{root}/{path}", wait_until="load")
        page.wait_for_function(MATHJAX)
        page.evaluate("() => window.MathJax?.startup?.promise")
        yield found
        context.close()

    return opened


@pytest.fixture(scope="module")
def shown(visit, request) -> Iterator[LivePage]:
    """A live view on its page, shared by the tests of one view."""
    with live(visit, request.param) as found:
        yield found


@pytest.fixture
def fresh(shown) -> LivePage:
    """The view back at its start."""
    shown.reset()
    return shown


@pytest.fixture(scope="module")
def explorer() -> Explorer:
    """The workbench of Section IV."""
    return VIEWS["IV"](EQUATIONS)


@pytest.fixture
def page(browser: Browser, explorer: Explorer) -> Iterator[Page]:
    """The workbench of Section IV on a page of its own."""
    with opened(browser, explorer) as page:
        page.wait_for_timeout(50)
        yield page
