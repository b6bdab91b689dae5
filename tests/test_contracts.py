"""What holds for the code as text: which way imports point, types, style, bounds, documented arguments."""

import ast
import dataclasses
import importlib
import inspect
import pkgutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from numpydoc.docscrape import NumpyDocString
from numpydoc.validate import validate

import rlswaim

ROOT = Path(__file__).parent.parent
FOLDERS = ("src", "tests", "benchmarks", "book")
FILES = sorted(
    path for name in FOLDERS for path in (ROOT / name).rglob("*.py") if "widgets" not in path.parts
)
LONGEST_FUNCTION, LONGEST_FILE = 40, 300
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
(ROOMS,) = [contract["layers"] for contract in CONTRACTS["contracts"] if contract["type"] == "layers"]
"""The rooms, each of which imports only those behind it."""


def modules():
    """Return all modules of the package by name."""
    found = pkgutil.walk_packages(rlswaim.__path__, "rlswaim.")
    return {"rlswaim": rlswaim, **{m.name: importlib.import_module(m.name) for m in found}}


def public_functions():
    """Return every public function and method that the package defines, by its full name."""
    found = {}
    for name, module in modules().items():
        for thing in vars(module).values():
            own = getattr(thing, "__module__", None) == name and hasattr(thing, "__name__")
            if not own or thing.__name__.startswith("_"):
                continue
            if inspect.isfunction(thing):
                found[f"{name}.{thing.__name__}"] = thing
            elif inspect.isclass(thing):
                for method in vars(thing).values():
                    if inspect.isfunction(method) and not method.__name__.startswith("_"):
                        found[f"{name}.{thing.__name__}.{method.__name__}"] = method
    return found


PUBLIC = public_functions()


def run(*command):
    """Run a tool of this environment in the project's root; fail with what it says."""
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True, check=False, timeout=300
    )
    if done.returncode:
        pytest.fail(f"{' '.join(command)}\n{done.stdout}{done.stderr}", pytrace=False)


def test_ruff_finds_nothing():
    run("ruff", "check", *FOLDERS)


def test_code_is_formatted():
    run("ruff", "format", "--check", *FOLDERS)


def test_types():
    run("mypy")


def test_imports_point_one_way():
    """The contracts are in pyproject.toml."""
    run("importlinter.cli", "lint")


@pytest.mark.parametrize("name", rlswaim.__all__)
def test_contract_names_are_documented_in_full(name):
    """Summary, parameters, returns: numpydoc's checks on what `import rlswaim as rl` offers."""
    wanted = {"GL08", "SS01", "SS03", "SS05", "PR01", "PR02", "PR03", "PR04", "PR10", "RT01", "YD01"}
    if inspect.isclass(getattr(rlswaim, name)):
        wanted -= {"PR01", "PR02", "PR03", "PR04"}  # a dataclass documents its fields in their notation
    found = [f"{code}: {text}" for code, text in validate(f"rlswaim.{name}")["errors"] if code in wanted]
    assert found == []


def documented(name):
    """Return the arguments that a function's Parameters block names."""
    block = NumpyDocString(inspect.getdoc(PUBLIC[name]) or "")["Parameters"]
    return {argument.strip(" *") for parameter in block for argument in parameter.name.split(",")}


@pytest.mark.parametrize("name", PUBLIC)
def test_every_argument_is_documented(name):
    """Two arguments or more stand in a Parameters block; one may be named in a sentence."""
    text = inspect.getdoc(PUBLIC[name]) or ""
    assert text
    arguments = [each for each in inspect.signature(PUBLIC[name]).parameters if each not in ("self", "cls")]
    if len(arguments) > 1 or "Parameters\n---" in text:
        assert [argument for argument in arguments if argument not in documented(name)] == []


def code_lines(function, lines):
    """Return how many ``lines`` of a file a ``function`` of it has, without its docstring and blank ones."""
    first, own = function.body[0], range(function.lineno, function.end_lineno + 1)
    if ast.get_docstring(function) is not None:
        own = [number for number in own if not first.lineno <= number <= first.end_lineno]
    return sum(bool(lines[number - 1].strip()) for number in own)


@pytest.mark.parametrize("path", FILES, ids=[str(path.relative_to(ROOT)) for path in FILES])
def test_functions_and_files_are_short(path):
    """Every function, private and nested ones too; ruff checks the lines."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    assert len(lines) <= LONGEST_FILE
    nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, FUNCTIONS)]
    lengths = {f"{node.name}, line {node.lineno}": code_lines(node, lines) for node in nodes}
    assert {name: length for name, length in lengths.items() if length > LONGEST_FUNCTION} == {}


def imported(path):
    """Return the rooms that a module imports, inside of its functions too."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return {name.split(".")[1] for name in names if name.startswith("rlswaim.")}


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_only_rooms_behind_it(room):
    """Import-linter's contract says the same; this reads the text of each file."""
    behind = ROOMS[ROOMS.index(room) :]
    found = {path.name: imported(path) for path in (ROOT / "src" / "rlswaim" / room).rglob("*.py")}
    assert found
    assert {name: rooms - set(behind) for name, rooms in found.items() if rooms - set(behind)} == {}


def test_every_module_has_a_room():
    flat = {path.name for path in (ROOT / "src" / "rlswaim").iterdir() if path.name != "__pycache__"}
    assert flat == {*ROOMS, "__init__.py"}


DATACLASSES = {
    f"{name}.{thing.__name__}": thing
    for name, module in modules().items()
    for thing in vars(module).values()
    if inspect.isclass(thing) and thing.__module__ == name and dataclasses.is_dataclass(thing)
}


@pytest.mark.parametrize("name", DATACLASSES)
def test_what_is_made_is_not_changed(name):
    """Functions keep what they found for a vehicle or a loop, so that none may change afterwards."""
    assert DATACLASSES[name].__dataclass_params__.frozen
