"""The live views in Firefox and WebKit: sliders to both ends, a drag, a link, and no error on the page."""

import re
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from http.server import ThreadingHTTPServer

import pytest

from conftest import HTML, ROOT
from livepage import PAGES
from other_browsers import STARTED, Driven, MissingBrowserError
from plain_pages import PlainHandler

ELSEWHERE = [
    ("dual-actuation", "book/16-designs-and-loads.html"),
    ("dual-actuation", "book/17-ladder-of-models.html"),
    ("rate-attitude", "book/18-another-vehicle.html"),
    ("own-loop", "book/20-own-loop.html"),
]
"""Views that stand on other pages than their own, and that of one's own loop."""
WITH_SLIDERS = [pair for pair in PAGES.items() if pair[0] != "station-map"] + ELSEWHERE
FIRST_PAGE = "book/preface.html"
LISTEN = """globalThis.wrong = [];
addEventListener('error', ({ message, filename }) => wrong.push(`${message} ${filename}`), true);
addEventListener('unhandledrejection', ({ reason }) => wrong.push(String(reason)));
addEventListener('securitypolicyviolation', ({ blockedURI }) => wrong.push(`policy: ${blockedURI}`));
addEventListener('rlswaim:drawn', () => { globalThis.drawings = (globalThis.drawings ?? 0) + 1; });
"""
WRONG = "return globalThis.wrong"
FIND = "const root = document.querySelector(`[data-explorer='${arguments[0]}']`);"
READY = FIND + "return Boolean(root?.querySelector('canvas')?.width && globalThis.drawings)"
MARK = (
    FIND
    + """
const panel = root.closest('.live-view');
root.scrollIntoView({ block: 'center' });
root.dataset.tried = '';
const beside = [...panel.querySelectorAll('[role=slider]')];
const own = [...root.querySelectorAll('[data-parameter] [type=range]')];
const sliders = beside.length ? beside : own.filter((slider) => !slider.closest('details:not([open])'));
return sliders.map((slider, i) => {
  slider.dataset.tried = i;
  return [slider.min ?? slider.ariaValueMin, slider.max ?? slider.ariaValueMax].map(Number);
});"""
)
VALUE = """const slider = document.querySelector(arguments[0]);
return Number(slider.value ?? slider.ariaValueNow);"""
PLACE = """const slider = document.querySelector(arguments[0]);
slider.scrollIntoView({ block: 'center' });
const widget = slider.closest('.noUi-target');
const [handle, track] = [slider, widget ?? slider].map((e) => e.getBoundingClientRect());
const y = Math.round(handle.top + handle.height / 2);
const start = widget ? handle.left + handle.width / 2 : handle.left + handle.height / 2;  // at its least
return [[Math.round(start), y], [Math.round(track.left + .3 * track.width), y]];"""
MOVING = """return [...root.querySelectorAll('[type=range]')].map((slider) => {
  slider.dataset.tried = 0;
  return [slider.min, slider.max].map(Number);
});"""
OUTPUT = "return document.querySelector('[data-explorer=moving-loop] output').textContent"
MAKES = re.compile(r"\bexplorers\.\w+\(|\brl\.explore\(")
TOLD = FIND + "return root.querySelector('table').innerText"
MAP = "canvas[data-plane=stations]"
SPOT = f"""const canvas = document.querySelector('{MAP}');
canvas.scrollIntoView({{ block: 'center' }});
const {{ left, top, width, height }} = canvas.getBoundingClientRect();
return [Math.round(left + .6 * width), Math.round(top + .3 * height)];"""
COMPLETE = FIND + "return root.dataset.step === 'complete'"
VERDICT = FIND + "return root.querySelector('.verdict').innerText"


class Listening(PlainHandler):
    """Puts a script in front of each page that notes what goes wrong there."""

    def do_GET(self) -> None:
        """Answer; a page gets one more line."""
        path = self.path.partition("#")[0]
        if path == "/listen.js":
            self.answer(LISTEN.encode(), "text/javascript")
        elif path.endswith(".html"):
            page = (HTML / path[1:]).read_bytes()
            head, tag, rest = page.partition(b"<head>")
            listen = b'<script src="/listen.js"></script>'
            self.answer(head + tag + listen + rest, "text/html; charset=utf-8")
        else:
            super().do_GET()


@pytest.fixture(scope="module")
def listening() -> Iterator[str]:
    """Serve the built book, with a listener on each page; the address of its root."""
    if not (HTML / ".built").is_file():
        pytest.fail("the book is not built: run `make book` first", pytrace=False)
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Listening, directory=str(HTML))) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}"
        running.shutdown()


@pytest.fixture(scope="module", params=STARTED)
def other(request) -> Iterator[Driven]:
    """A browser beside Chromium."""
    try:
        with STARTED[request.param]() as browser:
            yield browser
    except MissingBrowserError as error:
        pytest.skip(str(error))


def until(check: Callable[[], object], browser: Driven, what: str) -> None:
    """Wait until something holds."""
    for _ in range(600):
        if check():
            return
        time.sleep(0.05)
    pytest.fail(f"{what}: not within 30 s; errors: {browser.run(WRONG)}")


def shown(browser: Driven, address: str, name: str) -> list[list[float]]:
    """Open a view; return the ends of its sliders."""
    browser.go(address)
    until(lambda: browser.run(READY, name), browser, f"{name} drawn")
    return browser.run(MARK, name)


def assert_link_shows(browser: Driven, address: str, name: str) -> None:
    """What the view tells now, it tells again by the address that it has written."""
    told = browser.run(TOLD, name)
    time.sleep(0.5)  # the address follows when the hand rests
    link = browser.run("return location.hash")
    assert link
    assert browser.run(WRONG) == []
    shown(browser, address + link, name)
    until(lambda: browser.run(TOLD, name) == told, browser, f"the same table by {link}")
    assert browser.run(WRONG) == []


def to_both_ends(browser: Driven, sliders: list[list[float]]) -> None:
    """Bring each slider to its largest value, and back to its least."""
    for i, (least, most) in enumerate(sliders):
        slider = f"[data-tried='{i}']"
        for key, end in (("END", most), ("HOME", least)):
            browser.press(slider, key)
            until(lambda s=slider, e=end: browser.run(VALUE, s) == e, browser, f"slider {i} after {key}")


def test_no_page_with_a_view_is_left_out():
    pages = {path.stem for path in (ROOT / "book").glob("*.ipynb") if MAKES.search(path.read_text("utf-8"))}
    tried = {*dict(WITH_SLIDERS).values(), *PAGES.values(), *(path for _, path in ELSEWHERE), FIRST_PAGE}
    assert {f"book/{page}.html" for page in pages} == tried


@pytest.mark.parametrize(("name", "path"), WITH_SLIDERS)
def test_sliders_drag_and_link(other: Driven, listening: str, name: str, path: str):
    address = f"{listening}/{path}"
    sliders = shown(other, address, name)
    assert sliders, "no sliders"
    to_both_ends(other, sliders)
    first, told = "[data-tried='0']", other.run(TOLD, name)
    other.drag(*other.run(PLACE, first))
    assert other.run(VALUE, first) != sliders[0][0], "the drag moved nothing"
    until(lambda: other.run(TOLD, name) != told, other, "a new table")
    assert_link_shows(other, address, name)


def test_the_loop_on_the_first_page(other: Driven, listening: str):
    name = "moving-loop"
    shown(other, f"{listening}/{FIRST_PAGE}", name)
    (ends,) = other.run(FIND + MOVING, name)
    to_both_ends(other, [ends])
    before = other.run(OUTPUT)
    other.drag(*other.run(PLACE, "[data-tried='0']"))
    until(lambda: other.run(OUTPUT) != before, other, "another gain")
    assert other.run(WRONG) == []
    other.run("document.querySelector('[data-explorer=moving-loop] a').click()")
    until(lambda: other.run(READY, "rate-attitude"), other, "the workbench of its link")
    assert other.run(WRONG) == []


def test_the_map_of_pairs(other: Driven, listening: str):
    """A click and a key each pick a pair, which the workbench beside the map takes and its link keeps."""
    name, address = "station-map", f"{listening}/{PAGES['station-map']}"
    shown(other, address, name)
    spot = other.run(SPOT)
    until(lambda: other.run(COMPLETE, name), other, "the whole map")
    poles, verdict = other.run(TOLD, "dual-actuation"), other.run(VERDICT, name)
    other.drag(spot, spot)
    until(lambda: other.run(TOLD, "dual-actuation") != poles, other, "the poles of the pair that was clicked")
    until(lambda: other.run(VERDICT, name) != verdict, other, "its verdict on the map")
    poles = other.run(TOLD, "dual-actuation")
    for key in ("ARROW_RIGHT", "ENTER"):
        other.press(MAP, key)
    until(lambda: other.run(TOLD, "dual-actuation") != poles, other, "the poles of the pair beside it")
    assert_link_shows(other, address, "dual-actuation")
