"""Run on all processors the notebooks whose results a build would miss: `python run_notebooks.py CACHE`.

The build takes the results from the cache.  What fails here, it runs again and says why.
"""

import sys
from pathlib import Path

import yaml
from jupyter_cache import get_cache
from jupyter_cache.executors import load_executor

HERE = Path(__file__).parent
CONFIG = HERE.parent / "_config.yml"


def run_missing(folder: str) -> list[str]:
    """Run the notebooks beside this file that the cache does not have; return those that failed.

    Parameters
    ----------
    folder : str
        Of the cache.
    """
    cache = get_cache(folder)
    for path in sorted(HERE.glob("*.ipynb")):
        cache.add_nb_to_project(str(path))
    limit = yaml.safe_load(CONFIG.read_text(encoding="utf-8"))["execute"]["timeout"]
    done = load_executor("local-parallel", cache).run_and_cache(timeout=limit)
    return [*done.excepted, *done.errored]


if __name__ == "__main__":
    for failed in run_missing(sys.argv[1]):
        print(f"{failed}: the build runs it again")
