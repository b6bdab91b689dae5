"""What holds for the tracked files: their size, nothing of one machine in them, built files are current."""

import re
import subprocess
import tomllib
from itertools import chain
from pathlib import Path

import pytest

from rlswaim.edition.ledger import counts, errata
from rlswaim.source.tables import read_table

ROOT = Path(__file__).parent.parent
LARGEST = 1_500_000
# Written so that this file does not hold the words itself.
OF_ONE_MACHINE = re.compile(
    rb"/(?:work|root|home/\w+|tmp/[a-z])/|/opt/(?:py" + rb"pi|wheels)|file:/" + rb"//"
)
REGISTRY = re.compile(rb"https?://[\w.-]*(?:py" + rb"pi|pythonhosted|npm" + rb"js|registry)", re.IGNORECASE)


def git(*command):
    return subprocess.run(["git", *command], cwd=ROOT, capture_output=True, check=True).stdout


def tracked():
    """Return the files under version control, and new ones that are not ignored."""
    names = git("ls-files", "-z", "--cached", "--others", "--exclude-standard").decode().split("\0")
    return [ROOT / name for name in sorted(set(filter(None, names))) if (ROOT / name).is_file()]


TRACKED = tracked()


def test_no_tracked_file_is_large():
    assert {str(path): path.stat().st_size for path in TRACKED if path.stat().st_size > LARGEST} == {}


@pytest.mark.parametrize(
    "pattern", [OF_ONE_MACHINE, REGISTRY], ids=["paths of one machine", "registry hosts"]
)
def test_no_tracked_file_names(pattern):
    found = {}
    for path in TRACKED:
        if path.suffix == ".png" or path.name == "rlswaim-widgets.LICENSES.txt":
            continue
        hits = {hit.decode() for hit in pattern.findall(path.read_bytes())}
        if hits:
            found[str(path.relative_to(ROOT))] = sorted(hits)
    assert found == {}


def test_the_lock_pins_every_direct_dependency():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = [*project["dependencies"], *chain(*project["optional-dependencies"].values())]
    lock = (ROOT / "requirements.txt").read_text(encoding="utf-8")
    pinned = set(re.findall(r"^([A-Za-z0-9._-]+)==", lock, re.MULTILINE))
    names = {re.split(r"[<>=!~\[; ]", requirement, maxsplit=1)[0].lower() for requirement in wanted}
    assert names <= pinned


def test_the_lock_names_no_source():
    lines = (ROOT / "requirements.txt").read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if re.match(r"\s*(-|--|https?:)", line) or " @ " in line] == []


def test_every_target_is_explained():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = re.search(r"^\.PHONY: (.+)$", makefile, re.MULTILINE)[1].split()
    assert set(re.findall(r"^([a-z-]+):.*## \S", makefile, re.MULTILINE)) == set(targets)


def test_the_readme_s_example_runs():
    (example,) = re.findall(
        r"```python\n(.+?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL
    )
    exec(compile(example, "README.md", "exec"), {})


def test_the_readme_counts_the_ledger_s_verdicts():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = readme.partition("| verdict |")[2].partition("\n\n")[0].splitlines()
    shown = {cells[0]: cells[1:] for line in lines[2:] if (cells := re.findall(r"[^|]+", line))}
    wanted = {f" {verdict} ": [f" {n} " for n in row] for verdict, row in counts().T.iterrows()}
    assert shown == wanted


def test_the_errata_are_the_ledger_s():
    """They are written by the command that CONTRIBUTING.md names."""
    fields = ("where", "quantity", "printed", "unit", "verdict", "why")
    rows = read_table("errata")
    assert [row["id"] for row in rows] == list(errata().index)
    for row, wanted in zip(rows, errata().to_dict("records"), strict=True):
        assert {name: row[name] for name in fields} == {name: wanted[name] for name in fields}
        assert float(row["computed"]) == pytest.approx(float(wanted["computed"]), rel=1e-3, abs=1e-7)


def test_the_readme_s_pictures_and_files_are_there():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    named = [
        *re.findall(r"!\[[^]]*\]\(([^)]+)\)", readme),
        *re.findall(r"^\| `([\w/.]+)` \|", readme, re.MULTILINE),
    ]
    assert len(named) >= 5
    assert [name for name in named if not (ROOT / name).exists()] == []


def test_the_readme_shows_the_measured_figures():
    """Its tables of live views are those of the page that `make bench` writes."""
    page = (ROOT / "book" / "11-speed.md").read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for head in ("| view | key to picture", "| page | first picture"):
        start = page.index(head)
        assert page[start : page.index("\n\n", start)] in readme
