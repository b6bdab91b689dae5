"""The scripts of a live view, joined to the one ES module that it needs."""

import re
from importlib.resources import files

from rlswaim.source.tables import script

IMPORT = re.compile(r"^import (\{[^}]*\}) from '\.{1,2}/(?:\w+/)?(\w+)\.js';$", flags=re.MULTILINE)
ROOMS = ("maths", "drawing", "page", "views")
EXPORT = re.compile(r"^export (?=(?:async )?(?:function\*?|const|class) (\w+))", flags=re.MULTILINE)


def module(view: str) -> str:
    """Return the script ``view`` and those that it imports as one, each import in a scope of its own.

    Parameters
    ----------
    view : str
        Name of an ES module in ``js``; what it exports, the whole exports.

    Returns
    -------
    str
    """
    scopes: dict[str, str] = {}
    last = _bound(view, scopes)
    return "\n".join([*scopes.values(), last])


def _bound(name: str, scopes: dict[str, str]) -> str:
    """Return a script that takes what it imports from ``scopes``; those that it needs are added there."""
    room = next(room for room in ROOMS if (files("rlswaim.explorers") / "js" / room / f"{name}.js").is_file())
    text = script("js", room, f"{name}.js")
    for _, needed in IMPORT.findall(text):
        if needed not in scopes:
            scopes[needed] = _scope(needed, _bound(needed, scopes))
    return IMPORT.sub(r"const \1 = $\2;", text)


def _scope(name: str, text: str) -> str:
    """Return a script as an object of what it exports."""
    exported = ", ".join(EXPORT.findall(text))
    return f"const ${name} = (() => {{\n{EXPORT.sub('', text)}\nreturn {{ {exported} }};\n}})();"
