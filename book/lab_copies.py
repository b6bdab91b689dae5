"""Copy the notebooks for JupyterLab, which knows none of the book's roles: `python lab_copies.py FOLDER`.

In the copies the prose has the numbers of the last run, and equations, tables, notes and citations are
plain Markdown.  The code is the same.
"""

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from shutil import copytree, ignore_patterns

import nbformat
from pybtex.database import Entry, Person, parse_file

from rlswaim.edition.equations_as_printed import as_tex
from rlswaim.edition.ledger import ledger
from rlswaim.edition.tables_as_printed import printed_table, row_of

HERE = Path(__file__).parent
DIRECTIVE = re.compile(r"^(:{3,}|`{3,})\{([\w-]+)\} ?(.*)\n((?:.*\n)*?)\1 *$", re.MULTILINE)
ROLE = re.compile(r"\{([\w:]+)\}`([^`]+)`")
TARGET = re.compile(r"^\([\w-]+\)=\n", re.MULTILINE)
MARK = re.compile(r"\\class\{printed[^}]*\}")
LABEL = re.compile(r"^\$\$ *\(([\w-]+)\) *$", re.MULTILINE)
OPTION = re.compile(r"^:[\w-]+:.*\n", re.MULTILINE)
TEXTS = ("text/plain", "text/html")


def glued(notebook: nbformat.NotebookNode) -> dict[str, str]:
    """Return what the cells of a notebook gave to its prose, by name."""
    found: dict[str, str] = {}
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            name = output.get("metadata", {}).get("scrapbook", {}).get("name")
            for kind in TEXTS if name else ():
                if text := output.data.get(f"application/papermill.record/{kind}"):
                    found[name] = text
    return found


def number(glued_name: str, values: dict[str, str]) -> str:
    """Return a glued value as the book prints it: ``name`` or ``name:.2f``."""
    name, _, form = glued_name.partition(":")
    text = re.sub(r"<[^>]*>|^['\"]|['\"]$", "", values[name])
    return format(float(text), form) if form else text


def cited(keys: str) -> str:
    """Return names and years for the ``keys`` of a citation."""
    entries = parse_file(HERE / "references.bib").entries

    def names(people: list[Person]) -> str:
        return " and ".join(" ".join(person.last_names) for person in people[:2]) + " et al." * (
            len(people) > 2
        )

    def short(entry: Entry) -> str:
        who = names(entry.persons.get("author", [])) or entry.fields["title"]
        return f"{who} {entry.fields.get('year', '')}".strip()

    return "; ".join(short(entries[key.strip()]) for key in keys.split(","))


def equation(key: str) -> str:
    """Return an equation of the report as plain TeX, with its number."""
    tex = MARK.sub("", as_tex(key))
    return f"$$\n{tex}\n\\tag{{{key}}}\n$$\n"


def table(key: str) -> str:
    """Return a table of the report in Markdown."""
    found = printed_table(key)
    printed = {entry.id: entry.printed for entry in ledger()}
    lines = [[printed[cell] if row_of(cell) else cell for cell in line] for line in found.lines]
    rows = [found.heads, ["---"] * len(found.heads), *lines]
    return f"{found.caption}\n\n" + "".join(f"| {' | '.join(map(str, row))} |\n" for row in rows)


def noted(title: str, body: str) -> str:
    """Return a note or an answer as a quotation with its title."""
    lines = [f"**{title}**", "", *OPTION.sub("", body).strip().splitlines()]
    return "".join(f"> {line}".rstrip() + "\n" for line in lines)


def directive(match: re.Match[str]) -> str:
    """Return plain Markdown for a directive of the book."""
    _, name, title, body = match.groups()
    made: dict[str, Callable[[], str]] = {
        "report-equation": lambda: "\n".join(map(equation, f"{title} {body}".replace(",", " ").split())),
        "report-table": lambda: table(title.strip()),
        "verdict-legend": lambda: "",
    }
    return made.get(name, lambda: noted(title, body))()


def readable(text: str, values: dict[str, str]) -> str:
    """Return the prose of a cell as JupyterLab can show it.

    Parameters
    ----------
    text : str
        In the book's Markdown.
    values : dict of str to float or str
        What the notebook's cells gave to its prose.
    """
    made: dict[str, Callable[[str], str]] = {
        "glue": lambda given: number(given, values),
        "glue:text": lambda given: number(given, values),
        "eq": lambda given: f"({given.removeprefix('eq-')})",
        "numref": lambda given: re.sub(r".*<(.*)>", r"\1", given),
        "download": lambda given: re.sub(r" *<.*>", "", given),
        "cite:p": lambda given: f"({cited(given)})",
        "cite:t": cited,
    }
    plain = DIRECTIVE.sub(directive, text + "\n").rstrip("\n")
    plain = LABEL.sub(r"$$", TARGET.sub("", plain))
    return ROLE.sub(lambda match: made[match[1]](match[2]), plain)


def copy_all(folder: Path) -> None:
    """Write copies of all notebooks, and what they import and show, into a folder."""
    copytree(
        HERE, folder, ignore=ignore_patterns("*.ipynb", "*.md", "__pycache__", "widgets"), dirs_exist_ok=True
    )
    for path in sorted(HERE.glob("*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        values = glued(notebook)
        for cell in notebook.cells:
            if cell.cell_type == "markdown":
                cell.source = readable(cell.source, values)
        (folder / path.name).write_text(json.dumps(notebook, indent=1), encoding="utf-8")


if __name__ == "__main__":
    copy_all(Path(sys.argv[1]))
