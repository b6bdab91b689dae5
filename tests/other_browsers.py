"""Firefox and WebKit, found or installed, each driven by its own protocol behind one small interface."""

import json
import os
import shutil
import subprocess
import sys
import threading
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Protocol

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.webkitgtk.service import Service
from websocket import WebSocket, create_connection

from chromium import from_debian

WIDTH, HEIGHT = 1280, 900
FIREFOX = ("firefox-esr", "firefox", "/Applications/Firefox.app/Contents/MacOS/firefox")
MINIBROWSERS = "/usr/lib/*/webkit2gtk-4.*/MiniBrowser"
OFFLINE = {
    "network.proxy.type": 1,
    "network.proxy.socks": "127.0.0.1",
    "network.proxy.socks_port": 9,
    "network.proxy.socks_remote_dns": True,
    "network.proxy.no_proxies_on": "127.0.0.1",
}
"""Firefox asks nobody but this machine: all else goes to a port where nothing listens."""


CALL = "(given) => JSON.stringify((function () { %s })(...JSON.parse(given)))"


class MissingBrowserError(Exception):
    """A browser is not there and could not be installed."""


class Driven(Protocol):
    """What the tests ask of a browser."""

    def go(self, address: str) -> None:
        """Load an address from nothing."""

    def run(self, script: str, *given: object) -> Any:
        """Return what the body of a function returns for the arguments."""

    def press(self, selector: str, key: str) -> None:
        """Press a key, by its name, on an element."""

    def drag(self, start: Sequence[int], end: Sequence[int]) -> None:
        """Drag by the mouse from one point of the window to another (CSS px)."""


def _found(names: Sequence[str], package: str) -> str:
    """Return the first program that is there; Debian's package is installed if none is."""
    path = next(filter(None, map(shutil.which, names)), None) or from_debian(names, package)
    if not path:
        raise MissingBrowserError(f"No {package}: install it to test the live views there too.")
    return path


class Firefox:
    """Firefox, driven by WebDriver BiDi, which it speaks without a driver beside it."""

    def __init__(self, socket: WebSocket):
        self.socket, self.count = socket, 0
        self.ask("session.new", capabilities={})
        self.context = self.ask("browsingContext.getTree")["contexts"][0]["context"]

    def ask(self, method: str, **given: object) -> Any:
        """Send a command and return its answer."""
        self.count += 1
        self.socket.send(json.dumps({"id": self.count, "method": method, "params": given}))
        while (answer := json.loads(self.socket.recv())).get("id") != self.count:
            pass
        if "error" in answer:
            raise RuntimeError(f"{method} in Firefox: {answer['message']}")
        return answer["result"]

    def go(self, address: str) -> None:
        """Load an address from nothing."""
        for url in ("about:blank", address):
            self.ask("browsingContext.navigate", context=self.context, url=url, wait="complete")

    def run(self, script: str, *given: object) -> Any:
        """Return what the body of a function returns for the arguments."""
        found = self.ask(
            "script.callFunction",
            functionDeclaration=CALL % script,
            arguments=[{"type": "string", "value": json.dumps(given)}],
            target={"context": self.context},
            awaitPromise=False,
        )
        if found["type"] == "exception":
            raise RuntimeError(f"script in Firefox: {found['exceptionDetails']['text']}")
        return json.loads(found["result"].get("value", "null"))

    def _act(self, kind: str, *actions: dict) -> None:
        source = {"type": kind, "id": kind, "actions": actions}
        self.ask("input.performActions", context=self.context, actions=[source])

    def press(self, selector: str, key: str) -> None:
        """Press a key, by its name, on an element."""
        self.run("document.querySelector(arguments[0]).focus()", selector)
        self._act("key", *({"type": kind, "value": getattr(Keys, key)} for kind in ("keyDown", "keyUp")))

    def drag(self, start: Sequence[int], end: Sequence[int]) -> None:
        """Drag by the mouse from one point of the window to another (CSS px)."""
        there, away = ({"type": "pointerMove", "x": x, "y": y} for x, y in (start, end))
        down, up = ({"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp"))
        self._act("pointer", there, down, {**away, "duration": 200}, up)


class WebKit:
    """WebKitGTK's MiniBrowser, driven by its WebDriver."""

    def __init__(self, driver: webdriver.WebKitGTK):
        self.driver = driver

    def go(self, address: str) -> None:
        """Load an address from nothing."""
        self.driver.get("about:blank")
        self.driver.get(address)

    def run(self, script: str, *given: object) -> Any:
        """Return what the body of a function returns for the arguments."""
        return self.driver.execute_script(script, *given)

    def press(self, selector: str, key: str) -> None:
        """Press a key, by its name, on an element."""
        self.driver.find_element(By.CSS_SELECTOR, selector).send_keys(getattr(Keys, key))

    def drag(self, start: Sequence[int], end: Sequence[int]) -> None:
        """Drag by the mouse from one point of the window to another (CSS px)."""
        chain = ActionChains(self.driver, duration=200)
        pointer = chain.w3c_actions.pointer_action
        pointer.move_to_location(*start).pointer_down().move_to_location(*end).pointer_up()
        chain.perform()


@contextmanager
def firefox() -> Iterator[Firefox]:
    """Start Firefox without a window, and end it."""
    path = _found(FIREFOX, "firefox-esr")
    with TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        prefs = "".join(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in OFFLINE.items())
        (Path(profile) / "user.js").write_text(prefs, encoding="utf-8")
        size = ["--width", str(WIDTH), "--height", str(HEIGHT)]
        command = [path, "--headless", *size, "--profile", profile, "--remote-debugging-port", "0"]
        with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
            try:
                said = next(line for line in process.stderr if "BiDi listening on" in line)
                threading.Thread(target=process.stderr.read, daemon=True).start()  # so that it never fills
                socket = create_connection(f"{said.split()[-1]}/session", timeout=60, suppress_origin=True)
                yield Firefox(socket)
                socket.close()
            finally:
                process.kill()


@contextmanager
def _screen() -> Iterator[str]:
    """Start a screen in memory and return its name; MiniBrowser wants one."""
    command = [_found(["Xvfb"], "xvfb"), "-displayfd", "1", "-screen", "0", f"{WIDTH}x{HEIGHT}x24"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as screen:
        try:
            yield f":{screen.stdout.readline().strip()}"
        finally:
            screen.terminate()


@contextmanager
def webkit() -> Iterator[WebKit]:
    """Start MiniBrowser, and end it."""
    if sys.platform != "linux":
        raise MissingBrowserError("WebKit's MiniBrowser runs on Linux only: Safari is not tested here.")
    driver = _found(["WebKitWebDriver"], "webkit2gtk-driver")
    browser = max(map(str, Path("/").glob(MINIBROWSERS[1:])))
    options = webdriver.WebKitGTKOptions()
    options.binary_location = browser
    options.add_argument("--automation")
    options.set_capability("browserName", "MiniBrowser")
    with _screen() as display:
        own = {**os.environ, "DISPLAY": display, "WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS": "1"}
        with warnings.catch_warnings(action="ignore", category=DeprecationWarning):  # of selenium's own
            found = webdriver.WebKitGTK(options=options, service=Service(driver, env=own))
        try:
            found.set_window_size(WIDTH, HEIGHT)
            yield WebKit(found)
        finally:
            found.quit()


STARTED = {"firefox": firefox, "webkit": webkit}
