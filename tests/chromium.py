"""Find a Chromium, or install one: `python tests/chromium.py` prints its path.

Debian's chromium-headless-shell is the same engine without a window, and opens a page with half the work:
it comes first.
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from playwright.sync_api import sync_playwright

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
SHELL = "chromium-headless-shell"
"""Debian's package and program of the engine without a window."""
MAC = "/Applications/{0}.app/Contents/MacOS/{0}"
FLAGS = [
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
]
"""How it is started: it resolves no name."""
HASTE = ["-o", "Acquire::http::Timeout=30", "-o", "Acquire::Retries=1"]
"""Without a network apt gives up soon."""
WANTED = "No Chromium: install the package chromium, or set CHROMIUM to a browser's path, and run make again."


class NoChromiumError(Exception):
    """There is no Chromium, and none could be installed."""


def named() -> str | None:
    """Return the browser that CHROMIUM names; an error if there is none at that path."""
    path = os.environ.get("CHROMIUM")
    if path and not shutil.which(path):
        raise NoChromiumError(f"CHROMIUM: got {path}, wanted the path of a browser that can be run")
    return path and shutil.which(path)


def without_window() -> str | None:
    """Return the engine without a window, if it is there."""
    return shutil.which(SHELL)


def installed() -> str | None:
    """Return a Chromium on PATH or in a Mac's applications."""
    places = (*NAMES, MAC.format("Chromium"), MAC.format("Google Chrome"))
    return next(filter(None, map(shutil.which, places)), None)


def playwrights_own() -> str | None:
    """Return Playwright's own Chromium if it is there."""
    with sync_playwright() as playwright:
        path = playwright.chromium.executable_path
    return path if Path(path).is_file() else None


def _succeeds(*command: str) -> bool:
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=sys.stderr, check=False).returncode == 0


def from_debian(names: Sequence[str] = NAMES, package: str = "chromium") -> str | None:
    """Install a browser of Debian's where this user may, and return the path of its program.

    Parameters
    ----------
    names : sequence of str
        Names that the program may have.
    package : str
    """
    if not shutil.which("apt-get"):
        return None
    rights = [] if os.geteuid() == 0 else ["sudo", "-n"]
    if rights and not (shutil.which("sudo") and _succeeds(*rights, "true")):
        return None
    apt = [*rights, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq", *HASTE]
    _succeeds(*apt, "update")
    _succeeds(*apt, "install", "-y", "--no-install-recommends", package)
    return next(filter(None, map(shutil.which, names)), None)


def from_playwright() -> str | None:
    """Let Playwright download its own Chromium, and return its path."""
    _succeeds(sys.executable, "-m", "playwright", "install", "chromium")
    return playwrights_own()


def _ways(window: bool) -> Iterator[str | None]:
    others = (installed, playwrights_own, from_debian, from_playwright)
    for way in (named, *others) if window else (named, without_window, *others):
        yield way()


def find_chromium(window: bool = False) -> str:
    """Return the path of a Chromium, installing one if need be.

    Parameters
    ----------
    window : bool
        Whether it is to be the browser that readers have; else the engine alone does where it is there.

    Raises
    ------
    NoChromiumError
        If there is none and none could be installed; the message says what to do.
    """
    path = next(filter(None, _ways(window)), None)
    if not path:
        raise NoChromiumError(WANTED)
    return path


if __name__ == "__main__":
    try:
        if not (named() or without_window()):
            from_debian([SHELL], SHELL)
        print(f"Chromium: {find_chromium()}")
    except NoChromiumError as error:
        sys.exit(str(error))
