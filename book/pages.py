"""What the pages of the book share: tables, numbers for the prose, and the look of the figures.

Notebooks run in this folder and import it by its name.
"""

from collections.abc import Mapping
from numbers import Integral, Real
from urllib.parse import quote

import matplotlib as mpl
import pandas as pd
from IPython.display import HTML, Markdown
from matplotlib_inline.backend_inline import set_matplotlib_formats
from myst_nb import glue


def use_book_style() -> None:
    """Draw the notebook's figures as SVG that is the same file at every run."""
    set_matplotlib_formats("svg", metadata={"Date": None, "Creator": None})
    mpl.rcParams.update(
        {
            "svg.hashsalt": "rlswaim",
            "svg.fonttype": "none",
            "figure.figsize": (7.0, 4.3),
            "font.size": 10,
            "font.family": "sans-serif",
            "axes.grid": True,
            "grid.alpha": 0.3,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "legend.frameon": False,
            "lines.linewidth": 1.6,
        }
    )


def rounded(value: Real | str, digits: int) -> float | int | str:
    """Return a number with so many significant digits.

    Parameters
    ----------
    value : number or str
        Texts and whole numbers stay as they are.
    digits : int

    Returns
    -------
    float, int or str

    Examples
    --------
    >>> rounded(3.14159265, 3), rounded(1234567, 3), rounded("1.80", 1)
    (3.14, 1234567, '1.80')
    """
    if isinstance(value, str):
        return value
    return int(value) if isinstance(value, Integral) else float(f"{value:.{digits}g}")


def glue_all(prefix: str, values: Mapping[str, Real | str], digits: int = 6) -> None:
    """Give values to the prose, which names each of them ``prefix-name``.

    Parameters
    ----------
    prefix : str
        It stands in front of every name, and begins with the chapter's number.
    values : mapping of str to number or str
    digits : int
        Significant digits to which numbers are rounded that are not whole.
    """
    for name, value in values.items():
        glue(f"{prefix}-{name}", rounded(value, digits), display=False)


def show(frame: pd.DataFrame, index: str | None = None) -> Markdown:
    """Return a table whose formulas the page sets.

    Parameters
    ----------
    frame : DataFrame
        Its cells are texts, or print as they should.
    index : str, optional
        The head of a first column that holds the index; without it the index is not shown.

    Returns
    -------
    Markdown

    Examples
    --------
    >>> print(show(pd.DataFrame({"root": ["$s_1$"]}, index=["gyro"]), index="loop").data)
    | loop | root |
    | --- | --- |
    | gyro | $s_1$ |
    """
    shown = frame if index is None else frame.rename_axis(index).reset_index()
    lines = [shown.columns, ["---"] * shown.shape[1], *shown.to_numpy()]
    return Markdown("\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines))


def reasons(rows: pd.DataFrame, place: str) -> pd.DataFrame:
    """Return why rows of the ledger differ, each reason once, with its places and their number.

    Parameters
    ----------
    rows : DataFrame
        From `rlswaim.edition.ledger.frame`.
    place : str
        The column that tells the rows of one reason apart.

    Returns
    -------
    DataFrame
        Columns: verdict, why, and the places.

    Examples
    --------
    >>> where = ["Eq. 1", "Eq. 2", "Eq. 2"]
    >>> rows = pd.DataFrame({"verdict": "rounding", "why": "last digit", "where": where})
    >>> reasons(rows, "where").iloc[0].to_list()
    ['rounding', 'last digit', 'Eq. 1, Eq. 2 (3)']
    """
    groups = rows.groupby(["verdict", "why"], sort=False)[place]
    places = groups.agg(lambda found: f"{', '.join(dict.fromkeys(found))} ({len(found)})")
    return places.reset_index().rename(columns={place: f"{place} (how many)"})


def glue_state(name: str, words: str, view: str, **values: float | str) -> None:
    """Give the prose a link that opens a live view of its page at these values.

    Parameters
    ----------
    name : str
        The prose names the link by it: ``{glue}`name` ``.
    words : str
        What the link says.
    view : str
        The view's name in addresses, such as ``rate-attitude``.
    **values : float or str
        All parameters of the view; numbers are rounded to five significant digits.
    """
    texts = {key: value if isinstance(value, str) else f"{value:.5g}" for key, value in values.items()}
    state = ",".join(f"{key}={quote(text)}" for key, text in texts.items())
    glue(name, HTML(f'<a class="view-state" href="#{view}:{state}">{words}</a>'), display=False)
