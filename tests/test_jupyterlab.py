"""The notebooks in JupyterLab: their prose has its numbers, and a view follows its sliders there."""

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from urllib.request import urlopen

import pytest

from conftest import launched
from lab_copies import HERE, copy_all

NOTEBOOK = "05-single-sensor.ipynb"
QUIET = ["--LabApp.news_url=", "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate"]
LEFT = re.compile(r"\{[\w:-]+\}`|^(:::|```)\{.*|^\([\w-]+\)=$", re.MULTILINE)
RUNNING = re.compile(r"http://127\.0\.0\.1:\d+/")


@pytest.fixture(scope="module")
def copies(tmp_path_factory) -> Path:
    """All notebooks as JupyterLab can show them."""
    folder = tmp_path_factory.mktemp("lab")
    copy_all(folder)
    return folder


@pytest.fixture(scope="module")
def lab(copies: Path) -> Iterator[str]:
    """JupyterLab on the copies; its address."""
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--port=0", *QUIET]
    command += ["--IdentityProvider.token=", f"--ServerApp.root_dir={copies}"]
    own = {f"JUPYTER_{name}_DIR": str(copies / name) for name in ("CONFIG", "DATA", "RUNTIME")}
    said = copies / "lab.log"
    with said.open("w") as log, subprocess.Popen(command, stderr=log, env={**os.environ, **own}) as server:
        try:
            yield _address(said, server)
        finally:
            server.terminate()


def _address(said: Path, server: subprocess.Popen) -> str:
    for _ in range(600):
        if found := RUNNING.search(said.read_text(encoding="utf-8")):
            with urlopen(f"{found[0]}api", timeout=30) as answer:
                assert json.load(answer)["version"]
            return found[0]
        if server.poll() is not None:
            break
        time.sleep(0.1)
    return pytest.fail(f"JupyterLab did not start: {said.read_text(encoding='utf-8')[-2000:]}")


@pytest.mark.parametrize("name", sorted(path.name for path in HERE.glob("*.ipynb")))
def test_nothing_is_left_that_only_the_book_reads(copies, name):
    cells = json.loads((copies / name).read_text(encoding="utf-8"))["cells"]
    prose = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    assert prose
    assert [match[0] for text in prose for match in LEFT.finditer(text)] == []


def test_the_code_is_the_book_s(copies):
    for path in HERE.glob("*.ipynb"):
        book, copy = (
            [
                cell["source"]
                for cell in json.loads(at.read_text(encoding="utf-8"))["cells"]
                if cell["cell_type"] == "code"
            ]
            for at in (path, copies / path.name)
        )
        assert ["".join(source) for source in book] == ["".join(source) for source in copy]


@pytest.fixture
def browser():
    """The browser that readers have: JupyterLab draws a notebook as its window shows it."""
    with launched(window=True) as chromium:
        yield chromium


def test_a_view_follows_its_sliders(browser, lab):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.set_default_timeout(120_000)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{lab}lab/tree/{NOTEBOOK}?reset")
    page.locator(".jp-Notebook .jp-MarkdownOutput mjx-container").first.wait_for()
    page.locator(".jp-MarkdownOutput", has_text="= 1.59").first.wait_for()
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    root = page.locator("[data-explorer=single-sensor]").first
    root.wait_for()
    root.scroll_into_view_if_needed()
    assert not page.get_by_text("needs scripts").is_visible()
    table = root.locator("table.poles")
    before = table.inner_text()
    panel = page.locator(".widget-vbox", has=root).first
    slider = panel.locator("[role=slider]").first
    slider.press("End")
    page.wait_for_function(
        "before => document.querySelector('[data-explorer=single-sensor] table.poles').innerText !== before",
        arg=before,
    )
    assert slider.get_attribute("aria-label")
    assert slider.get_attribute("aria-valuetext")
    assert errors == []
    page.close()
