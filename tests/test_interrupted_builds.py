"""A build that fails or is killed leaves nothing that the next takes for good; none needs a home folder."""

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SECONDS = 30
FRAME = ["_config.yml", "_toc.yml", "CITATION.cff", "requirements.txt", "pyproject.toml"]
HOMES = ["IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR"]
RUNS_NOTEBOOKS = """#!/bin/sh
mkdir -p _build/.jupyter_cache && touch _build/.jupyter_cache/result
"""
BUILDS_PAGES = """#!/bin/sh
mkdir -p _build/html && touch _build/html/page.html
env > settings
test "$ENDS" != badly || exit 1
test "$ENDS" != never || sleep 60
"""


@pytest.fixture
def project(tmp_path):
    """A project with this one's Makefile, whose notebooks and pages are made by two small scripts."""
    shutil.copy(ROOT / "Makefile", tmp_path)
    for folder in ("book", "src/rlswaim", "programs", ".venv"):
        (tmp_path / folder).mkdir(parents=True)
    for name in [*FRAME, "book/one.ipynb", ".venv/.installed"]:
        (tmp_path / name).touch()
    for name, script in (("python", RUNS_NOTEBOOKS), ("jupyter-book", BUILDS_PAGES)):
        program = tmp_path / "programs" / name
        program.write_text(script, encoding="utf-8")
        program.chmod(0o755)
    return tmp_path


def build(project: Path, ends: str) -> subprocess.Popen[str]:
    """Start the build of the pages with a home folder that can't be written."""
    settings = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    settings |= {"ENDS": ends, "HOME": os.devnull}
    command = ["make", "BIN=programs", "_build/html/.built"]
    pipe = subprocess.PIPE
    return subprocess.Popen(
        command, cwd=project, env=settings, stdout=pipe, stderr=pipe, text=True, start_new_session=True
    )


def assert_builds(project: Path) -> None:
    """The next build runs to its end, and the one after it has nothing to do."""
    again = build(project, "well")
    said = again.communicate(timeout=SECONDS)
    assert again.returncode == 0, said
    assert (project / "_build/html/page.html").is_file()
    (project / "_build/html/page.html").unlink()
    build(project, "well").communicate(timeout=SECONDS)
    assert not (project / "_build/html/page.html").exists()  # nothing was built anew


def test_a_failed_build_keeps_no_page_and_no_result(project):
    failed = build(project, "badly")
    failed.communicate(timeout=SECONDS)
    assert failed.returncode != 0
    assert not (project / "_build/html").exists()
    assert not (project / "_build/.jupyter_cache").exists()
    assert_builds(project)


def test_a_killed_build_is_not_taken_for_a_whole_one(project):
    killed = build(project, "never")
    until = time.monotonic() + SECONDS
    while not (project / "settings").exists() and time.monotonic() < until:
        time.sleep(0.05)
    os.killpg(killed.pid, signal.SIGKILL)
    killed.communicate()
    assert (project / "_build/html/page.html").is_file()
    assert not (project / "_build/html/.built").exists()
    assert_builds(project)


def test_no_program_of_the_build_writes_into_the_home_folder(project):
    build(project, "well").communicate(timeout=SECONDS)
    lines = (project / "settings").read_text(encoding="utf-8").splitlines()
    settings = dict(line.partition("=")[::2] for line in lines)
    assert {name: Path(settings[name]).is_relative_to(project) for name in HOMES} == dict.fromkeys(
        HOMES, True
    )
