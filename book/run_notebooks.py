"""Run on all processors the notebooks whose results a build would miss: `python run_notebooks.py CACHE`.

The build takes the results from the cache.  What fails here, it runs again and says why.
"""

import sys
from pathlib import Path

from jupyter_cache import get_cache
from jupyter_cache.executors import load_executor


def run_missing(folder: str) -> list[str]:
    """Run the notebooks beside this file that the cache does not have; return those that failed.

    Parameters
    ----------
    folder : str
        Of the cache.
    """
    cache = get_cache(folder)
    for path in sorted(Path(__file__).parent.glob("*.ipynb")):
        cache.add_nb_to_project(str(path))
    done = load_executor("local-parallel", cache).run_and_cache(timeout=600)
    return [*done.excepted, *done.errored]


if __name__ == "__main__":
    for failed in run_missing(sys.argv[1]):
        print(f"{failed}: the build runs it again")
