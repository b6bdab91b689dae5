"""Two makes at once: the second one waits, says so, and goes on when the first one ends, however it ends."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parent / "one_at_a_time.py"
SECONDS = 30


def started(lock: Path, code: str) -> subprocess.Popen[str]:
    command = [sys.executable, str(SCRIPT), str(lock), sys.executable, "-c", code]
    pipe = subprocess.PIPE
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, start_new_session=True)


@pytest.fixture
def holder(tmp_path):
    """A command that holds the lock until a line comes in."""
    first = started(tmp_path / "lock", "print('here', flush=True); input()")
    assert first.stdout.readline() == "here\n"
    yield first
    if first.poll() is None:
        os.killpg(first.pid, signal.SIGKILL)
    first.communicate()


@pytest.mark.parametrize("end", ["by itself", "killed"])
def test_the_second_waits_says_so_and_goes_on(holder, tmp_path, end):
    second = started(tmp_path / "lock", "print('mine')")
    assert "waits for it" in second.stderr.readline()
    assert second.poll() is None
    if end == "killed":
        os.killpg(holder.pid, signal.SIGKILL)
    else:
        holder.stdin.write("\n")
        holder.stdin.flush()
    assert second.communicate(timeout=SECONDS)[0] == "mine\n"
    assert second.returncode == 0


def test_the_lock_outlives_the_script_while_the_command_runs(holder, tmp_path):
    os.kill(holder.pid, signal.SIGKILL)  # the script alone, not its command
    holder.wait(SECONDS)
    second = started(tmp_path / "lock", "print('mine')")
    assert "waits for it" in second.stderr.readline()
    os.killpg(holder.pid, signal.SIGKILL)
    assert second.communicate(timeout=SECONDS)[0] == "mine\n"


def test_the_exit_status_is_the_command_s(tmp_path):
    failing = started(tmp_path / "lock", "raise SystemExit(3)")
    failing.communicate(timeout=SECONDS)
    assert failing.returncode == 3
