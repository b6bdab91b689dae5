"""The live views in Firefox and WebKit: sliders to both ends, a drag, a link, and no error on the page."""

import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from http.server import ThreadingHTTPServer

import pytest

from conftest import HTML
from livepage import PAGES
from other_browsers import STARTED, Driven, MissingBrowserError
from serve import Handler

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
return [...panel.querySelectorAll('[role=slider]')].map((slider, i) => {
  slider.dataset.tried = i;
  return [slider.ariaValueMin, slider.ariaValueMax].map(Number);
});"""
)
VALUE = "return Number(document.querySelector(arguments[0]).ariaValueNow)"
PLACE = """const slider = document.querySelector(arguments[0]);
slider.scrollIntoView({ block: 'center' });
const [handle, track] = [slider, slider.closest('.noUi-target')].map((e) => e.getBoundingClientRect());
const y = Math.round(handle.top + handle.height / 2);
return [[Math.round(handle.left + handle.width / 2), y], [Math.round(track.left + .3 * track.width), y]];"""
TOLD = FIND + "return root.querySelector('table').innerText"


class Listening(Handler):
    """Puts a script in front of each page that notes what goes wrong there."""

    def do_GET(self) -> None:
        """Answer; a page gets one more line."""
        path = self.path.partition("#")[0]
        if path == "/listen.js":
            self._answer(LISTEN.encode(), "text/javascript")
        elif path.endswith(".html"):
            page = (HTML / path[1:]).read_bytes()
            head, tag, rest = page.partition(b"<head>")
            listen = b'<script src="/listen.js"></script>'
            self._answer(head + tag + listen + rest, "text/html; charset=utf-8")
        else:
            super().do_GET()

    def _answer(self, body: bytes, kind: str) -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)


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


@pytest.mark.parametrize("name", [name for name in PAGES if name not in ("comparison", "station-map")])
def test_sliders_drag_and_link(other: Driven, listening: str, name: str):
    address = f"{listening}/{PAGES[name]}"
    sliders = shown(other, address, name)
    assert sliders, "no sliders"
    for i, (least, most) in enumerate(sliders):
        slider = f"[role=slider][data-tried='{i}']"
        for key, end in (("END", most), ("HOME", least)):
            other.press(slider, key)
            assert other.run(VALUE, slider) == end, f"slider {i} after {key}"
    first, told = "[role=slider][data-tried='0']", other.run(TOLD, name)
    other.drag(*other.run(PLACE, first))
    assert other.run(VALUE, first) != sliders[0][0], "the drag moved nothing"
    until(lambda: other.run(TOLD, name) != told, other, "a new table")
    told = other.run(TOLD, name)
    time.sleep(0.5)  # the address follows when the hand rests
    link = other.run("return location.hash")
    assert other.run(WRONG) == []
    shown(other, address + link, name)
    until(lambda: other.run(TOLD, name) == told, other, f"the same table by {link}")
    assert other.run(WRONG) == []
