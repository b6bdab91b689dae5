"""What holds for the chapters as files; nbval itself runs every cell again and compares what comes out."""

import ast
import re
from collections import Counter
from pathlib import Path

import nbformat
import pytest
import yaml

ROOT = Path(__file__).parent.parent
NOTEBOOKS = sorted((ROOT / "book").glob("*.ipynb"))
FORBIDDEN = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.While, ast.Try, ast.With)
LONGEST_CELL = 12
LONGEST_WITH_IMPORTS = 15
CHANGES_BY_ITSELF = re.compile(r"0x[0-9a-f]{6,}|\d\d:\d\d:\d\d|/(?:home|root|tmp|Users|work)/")


@pytest.fixture(scope="module", params=NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def notebook(request):
    return nbformat.read(request.param, as_version=4)


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def figures(notebook):
    drawn = [any("image/svg+xml" in o.get("data", {}) for o in cell.outputs) for cell in code_cells(notebook)]
    return [cell for cell, has_figure in zip(code_cells(notebook), drawn, strict=True) if has_figure]


def test_each_view_has_a_name_to_read_its_values_by(notebook):
    views = [c for c in code_cells(notebook) if "jupyter.widget-view" in str(c.outputs)]
    assert [cell.source for cell in views if not cell.source.splitlines()[-1].isidentifier()] == []


def test_there_is_a_notebook_for_each_section():
    chapters = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
    named = [c["file"] for part in chapters["parts"] for c in part["chapters"]]
    numbered = [name for name in named if re.match(r"book/0\d-", name)]
    assert len(numbered) == 9
    for name in [chapters["root"], *named]:
        assert (ROOT / f"{name}.ipynb").is_file() or (ROOT / f"{name}.md").is_file()


def test_outputs_are_in_place(notebook):
    """Nbval compares nothing in a notebook that has never run."""
    cells = code_cells(notebook)
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not cells or any(cell.outputs for cell in cells)


def test_no_output_is_an_error_or_a_warning(notebook):
    outputs = [output for cell in code_cells(notebook) for output in cell.outputs]
    assert [o for o in outputs if o.output_type == "error" or o.get("name") == "stderr"] == []


def test_a_cell_calls_shows_and_stops(notebook):
    """No function, class or unbounded loop of its own, and no long cell."""
    for cell in code_cells(notebook):
        nodes = list(ast.walk(ast.parse(cell.source)))
        assert [type(node).__name__ for node in nodes if isinstance(node, FORBIDDEN)] == [], cell.id
        lines = [line for line in cell.source.splitlines() if not line.startswith(("import ", "from "))]
        assert len([line for line in lines if line.strip()]) <= LONGEST_CELL, cell.id
        assert len(cell.source.splitlines()) <= LONGEST_WITH_IMPORTS, cell.id


def test_imports_and_preparation_are_hidden_in_short_cells_at_the_top(notebook):
    """A cell that a reader can copy as it is has its own imports, and a tag that says so."""
    cells = code_cells(notebook)
    prepared = [i for i, cell in enumerate(cells) if i > 0 and not cell.source.startswith("from rlswaim")]
    first = min(prepared, default=1)
    for cell in cells[:first]:
        assert {"hide-input", "remove-cell"} & set(cell.metadata.tags), cell.id
    for cell in cells[first:]:
        imports = re.search(r"^(?:import|from) ", cell.source, re.MULTILINE)
        assert not imports or "stands-alone" in cell.metadata.get("tags", []), cell.id


def test_a_cell_whose_code_is_shown_shows_something(notebook):
    for cell in code_cells(notebook):
        if not {"hide-input", "hide-cell", "remove-cell"} & set(cell.metadata.get("tags", [])):
            assert cell.outputs, cell.id


def test_a_page_with_figures_sets_the_book_s_style_first(notebook):
    first = code_cells(notebook)[0]
    assert not figures(notebook) or "use_book_style()" in first.source.splitlines()


def test_the_book_s_helper_glues_and_shows(notebook):
    """Numbers and tables come out alike on all pages: `pages.glue_all` and `pages.show`."""
    for cell in code_cells(notebook):
        assert not re.search(r"\bglue\(|\bMarkdown\(|\bto_markdown\(", cell.source), cell.id


def test_a_table_in_markdown_is_read_as_myst(notebook):
    """Else the page shows its bars and dashes as text."""
    for cell in code_cells(notebook):
        texts = [output.get("data", {}).get("text/markdown", "") for output in cell.outputs]
        if any(text.startswith("| ") for text in texts):
            assert cell.metadata.get("mystnb", {}).get("markdown_format") == "myst", cell.id


def test_outputs_hold_nothing_that_changes_by_itself(notebook):
    for cell in code_cells(notebook):
        for output in cell.outputs:
            texts = [output.get("text", ""), *map(str, output.get("data", {}).values())]
            assert [hits for text in texts if (hits := CHANGES_BY_ITSELF.findall(text))] == [], cell.id


def test_metadata_hold_nothing_that_changes_by_itself(notebook):
    assert set(notebook.metadata) <= {"kernelspec", "language_info"}
    assert notebook.metadata.kernelspec.name == "python3"
    assert set(notebook.metadata.get("language_info", {})) <= {"name"}
    assert [cell.id for cell in notebook.cells if "execution" in cell.metadata] == []


def test_cells_keep_their_names(notebook):
    ids = [cell.id for cell in notebook.cells]
    assert len(set(ids)) == len(ids)


def test_each_figure_has_a_caption_and_alt_text(notebook):
    for cell in figures(notebook):
        shown = cell.metadata.get("mystnb", {})
        assert shown.get("figure", {}).get("caption", "").strip(), cell.id
        assert len(shown.get("image", {}).get("alt", "").strip()) > 15, cell.id


def glued(notebook):
    """Return the names of the values that the prose may name, from the outputs that hold them."""
    outputs = [output for cell in code_cells(notebook) for output in cell.outputs]
    names = [output.get("metadata", {}).get("scrapbook", {}).get("name") for output in outputs]
    return [name for name in names if name]


def test_names_of_glued_numbers_are_unique_in_the_book():
    names = Counter(name for path in NOTEBOOKS for name in glued(nbformat.read(path, as_version=4)))
    assert len(names) > 400
    assert {name: count for name, count in names.items() if count > 1} == {}


def test_prose_names_only_numbers_of_its_own_page(notebook):
    prose = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    assert set(re.findall(r"\{glue:text\}`([^`:]+)", prose)) - set(glued(notebook)) == set()
