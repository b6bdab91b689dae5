"""Run a command while no other one holds the lock: `python tests/one_at_a_time.py LOCK COMMAND ...`."""

import fcntl
import os
import subprocess
import sys


def main(lock: str, *command: str) -> int:
    """Wait for the lock, run the command, and return its exit status.

    Parameters
    ----------
    lock : str
        A file.  Its lock ends with the command, however that ends, so that no lock is left behind.
    *command : str
    """
    with open(lock, "w", encoding="utf-8") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            print("rlswaim: another make works in this folder; this one waits for it", file=sys.stderr)
            fcntl.flock(file, fcntl.LOCK_EX)
        os.set_inheritable(file.fileno(), True)  # the command holds the lock even if this script is killed
        return subprocess.call(command, close_fds=False)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
