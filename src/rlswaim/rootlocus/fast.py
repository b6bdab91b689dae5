"""The one switch between compiled continuation and numpy: numba, where it is installed, is used."""

import os
from functools import cache
from importlib import import_module
from types import ModuleType

ENABLED = os.environ.get("RLSWAIM_FAST") != "0"
"""Set it to False, or the environment's RLSWAIM_FAST to 0, and numpy does all."""


@cache
def _compiled() -> ModuleType | None:
    try:
        return import_module("rlswaim.rootlocus.compiled")
    except (ImportError, RuntimeError):  # no numba, or no folder where it may keep what it compiles
        return None


def compiled() -> ModuleType | None:
    """Return `rlswaim.rootlocus.compiled`, or None where numpy is to do the work.

    Numba is imported at the first call, not with ``import rlswaim``.  The very first
    use on a machine compiles for some 20 s; later ones load what was kept.
    """
    return _compiled() if ENABLED else None
