"""The scripts of a live view, joined to the one ES module that it needs."""

import re

from rlswaim.tables import script

IMPORT = re.compile(r"^import (\{[^}]*\}) from '\./(\w+)\.js';$", flags=re.MULTILINE)
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
    text = script("js", f"{name}.js")
    for _, needed in IMPORT.findall(text):
        if needed not in scopes:
            scopes[needed] = _scope(needed, _bound(needed, scopes))
    return IMPORT.sub(r"const \1 = $\2;", text)


def _scope(name: str, text: str) -> str:
    """Return a script as an object of what it exports."""
    exported = ", ".join(EXPORT.findall(text))
    return f"const ${name} = (() => {{\n{EXPORT.sub('', text)}\nreturn {{ {exported} }};\n}})();"
