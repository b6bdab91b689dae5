"""What holds for the tracked files: their size, nothing of one machine in them, built files are current."""

import re
import subprocess
import sys
import tomllib
from itertools import chain
from pathlib import Path

import nbformat
import pytest
from matplotlib import pyplot as plt
from pybtex.database import parse_file
from pybtex.style.labels.alpha import LabelStyle

from rlswaim.edition.ledger import counts, errata, ledger
from rlswaim.source.tables import read_table

ROOT = Path(__file__).parent.parent
LARGEST = 1_500_000
VIEWS = {
    "bent-vehicle",
    "trajectory",
    "coupling",
    "rate-attitude",
    "single-sensor",
    "two-sensor",
    "dual-actuation",
    "peak-bound",
    "greensite",
    "whole-burn",
    "own-loop",
    "moving-loop",
}
FRAME = 1000 / 60  # ms
CHAPTERS = {
    f"{path.stem}.html"
    for path in (ROOT / "book").glob("*.ipynb")
    if "jupyter.widget-view" in path.read_text(encoding="utf-8")
}
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


def test_labels_of_works_are_short():
    """A work by a body has the letters of its name, not its words run together."""
    works = parse_file(ROOT / "book" / "references.bib").entries
    labels = {key: LabelStyle().format_label(work) for key, work in works.items()}
    assert labels["icao1993"] == "ICAO93"
    assert {key: label for key, label in labels.items() if len(label) > 8} == {}


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


@pytest.mark.parametrize("name", ["README.md", "book/13-how-to.md"])
def test_the_examples_run_in_their_order(name):
    examples = re.findall(r"```python\n(.+?)```", (ROOT / name).read_text(encoding="utf-8"), re.DOTALL)
    assert examples
    try:
        exec(compile("\n".join(examples), name, "exec"), {})
    finally:
        plt.close("all")


def test_agreement_counts_the_ledger_s_verdicts():
    """The table that the page of the book shows, as it is stored in its notebook."""
    page = nbformat.read(ROOT / "book" / "12-agreement.ipynb", as_version=4)
    outputs = [output for cell in page.cells for output in cell.get("outputs", [])]
    tables = [output.get("data", {}).get("text/markdown", "") for output in outputs]
    pair = [text for text in tables if text.startswith("| verdict |")]
    for table, wanted in zip(pair, (counts(), counts(None)), strict=True):
        lines = [re.findall(r"[^|]+", line) for line in table.splitlines()[2:]]
        shown = {cells[0]: cells[1:] for cells in lines if cells}
        assert shown == {f" {verdict} ": [f" {n} " for n in row] for verdict, row in wanted.T.iterrows()}


def test_the_readme_counts_all_printed_numbers():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (count,) = re.findall(r"prints (\d+) numbers", readme)
    assert int(count) == len(ledger())


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


def test_the_speed_page_shows_measured_figures_of_every_chapter_and_view():
    """`make bench` writes it; README leaves these figures to it."""
    page = (ROOT / "book" / "11-speed.md").read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for head, wanted in (("| view | key to picture", VIEWS), ("| page | first picture", CHAPTERS)):
        table = page[page.index(head) :].partition("\n\n")[0].splitlines()
        rows = {cells[0]: cells[1:] for line in table[2:] if (cells := line.strip("| ").split(" | "))}
        assert set(rows) == wanted
        assert all(float(number) >= 0 for cells in rows.values() for number in cells)
        assert head not in readme
        if "view" in head:  # the README says that a view draws within a frame
            assert max(float(cells[1]) for cells in rows.values()) < FRAME
    assert "(book/11-speed.md)" in readme


def test_the_workflows_follow_the_host_s_schema():
    files = sorted(map(str, (ROOT / ".github" / "workflows").glob("*.yml")))
    assert len(files) == 3
    check = ["-m", "check_jsonschema", "--builtin-schema", "vendor.github-workflows", *files]
    done = subprocess.run([sys.executable, *check], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_the_workflows_call_targets_that_there_are():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / ".github" / "workflows").glob("*.yml")]
    called = set(re.findall(r"run: make ([a-z-]+)", "\n".join(texts)))
    assert called
    assert called <= set(re.findall(r"^([a-z-]+):", makefile, re.MULTILINE))
