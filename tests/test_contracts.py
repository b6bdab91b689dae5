"""What holds for the code as text: which way imports point, types, style, documented arguments."""

import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest
from numpydoc.validate import validate

import rlswaim

ROOT = Path(__file__).parent.parent
SAME_EVERYWHERE = {
    "ax": "the matplotlib axes that are drawn on and returned",
    "booster": "a Booster",
    "eqs": "PerturbationEquations",
    "loop": "an open loop, as python-control or this package has it",
    "K_A K_C K_R K_z K_za K_zb kK_z K_r b gyro sensor jet": "gains and stations: see the notation page",
    "what where": "in checks: the name of a value, and of the place that it was given to",
}
"""Arguments that mean the same wherever they stand: documented once in full, elsewhere by their type."""


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
    run("ruff", "check", "src", "tests", "benchmarks", "book/extensions")


def test_code_is_formatted():
    run("ruff", "format", "--check", "src", "tests", "benchmarks", "book/extensions")


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


@pytest.mark.parametrize("name", PUBLIC)
def test_every_argument_is_documented(name):
    """Each argument is named in the docstring: under Parameters, or in a short function's one sentence."""
    text = inspect.getdoc(PUBLIC[name]) or ""
    assert text
    known = {"self", "cls", *" ".join(SAME_EVERYWHERE).split(), *re.findall(r"\w+", text)}
    assert [
        argument for argument in inspect.signature(PUBLIC[name]).parameters if argument not in known
    ] == []


@pytest.mark.parametrize("name", PUBLIC)
def test_functions_are_short(name):
    lines = [line for line in inspect.getsource(PUBLIC[name]).splitlines() if line.strip()]
    documented = len((inspect.getdoc(PUBLIC[name]) or "").splitlines())
    assert len(lines) - documented <= 60


@pytest.mark.parametrize("name", modules())
def test_modules_are_rooms(name):
    assert len(inspect.getsource(modules()[name]).splitlines()) <= 400
