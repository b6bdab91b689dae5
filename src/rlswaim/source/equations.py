r"""The report's equations as templates: TeX in which each printed number is the id of its row in the ledger.

A file of ``data/equations`` holds one section of the report.  ``% eq 38`` begins Eq. 38; ``% eq 46a``
begins what the report prints below Eq. 46 without a number.  ``% note:`` says how the text departs
from the machine reading, and goes on in lines that begin with ``%``.  In the TeX

- ``\printed{eq38-Z_alpha}`` is the row's number as it stands there,
- ``\turned{...}`` the number with its sign turned,
- ``\plus{...}`` adds the number: a sign, and the digits,
- ``\minus{...}`` subtracts it, as a root is subtracted in ``(s\minus{eq92-p1-root})``.

The gain that the reading has as K_C and K_c, and the length that it has as a script and an upright l,
are one letter each throughout.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from types import MappingProxyType

PLACE = re.compile(r"\\(printed|turned|plus|minus)\{([^{}]+)\}")
"""A printed number's place in a template: what is done with the number, and its id."""

HEAD = re.compile(r"^% eq (\d+[a-z]?)\n", re.MULTILINE)
NOTE = re.compile(r"^% note: (.+(?:\n% .+)*)\n?", re.MULTILINE)
SECTIONS = 7


@dataclass(frozen=True)
class Template:
    """One equation of the report: its key (``"38"``, ``"46a"``), its TeX, and a note on the reading."""

    key: str
    tex: str
    note: str

    @property
    def numbered(self) -> bool:
        """Whether the report prints a number beside the equation."""
        return self.key.isdigit()

    @property
    def entries(self) -> tuple[str, ...]:
        """Ids of the printed numbers in it, in their order; a number that stands twice is named twice."""
        return tuple(match[2] for match in PLACE.finditer(self.tex))


def parse(text: str) -> dict[str, Template]:
    """Return the templates of one file's ``text`` by their keys."""
    _, *parts = HEAD.split(text)
    found = {}
    for key, body in zip(parts[::2], parts[1::2], strict=True):
        note = NOTE.search(body)
        words = re.sub(r"\s*\n%\s*", " ", note[1]) if note else ""
        found[key] = Template(key, NOTE.sub("", body).strip(), words)
    return found


@cache
def templates() -> Mapping[str, Template]:
    """Return all templates by key, in the order of the report.

    Raises
    ------
    ValueError
        If a key stands twice.
    """
    found: dict[str, Template] = {}
    folder = files("rlswaim.source").joinpath("data", "equations")
    for section in range(1, SECTIONS + 1):
        more = parse(folder.joinpath(f"section_{section}.tex").read_text(encoding="utf-8"))
        if twice := sorted(found.keys() & more.keys()):
            raise ValueError(f"equations in section_{section}.tex: got {twice} again, wanted each key once")
        found |= more
    return MappingProxyType(found)
