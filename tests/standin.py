"""A live view on a blank page, with a stand-in for the notebook's model."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from playwright.sync_api import Browser, Page
from scipy.optimize import linear_sum_assignment

import rlswaim.explorers
from rlswaim.explorers import Comparison
from rlswaim.explorers.live_view import LiveView

SITE = "http://view.test/"
MODEL = (Path(__file__).parent / "explorer_model.js").read_text(encoding="utf-8")


def paired(first: np.ndarray, second: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return both root sets in the order of the pairing of least distance."""
    rows, columns = linear_sum_assignment(abs(first[:, None] - second))
    return first[rows], second[columns]


def model_state(explorer: LiveView | Comparison) -> dict:
    """Return the traits that the view reads."""
    if isinstance(explorer, Comparison):
        return {"left": explorer.left, "right": explorer.right, "payload": explorer.payload}
    places = {f"{p.name}_at": getattr(explorer, f"{p.name}_at") for p in explorer.parameters}
    magnify = getattr(explorer, "magnify", 1.0)
    return {**explorer.values(), **places, "magnify": magnify, "payload": explorer.payload}


SCRIPTS = Path(rlswaim.explorers.__file__).parent / "js"


def go_to_empty_page(page: Page, address: str = SITE) -> None:
    """Open an empty page that has an address, as a view on about:blank has none to write.

    The scripts of the views are there one by one: the page may import "/js/maths/roots.js".
    """
    page.route(f"{SITE}js/**", lambda route: route.fulfill(path=SCRIPTS / route.request.url.split("/js/")[1]))
    blank = "<!doctype html><title>view</title>"
    page.route(SITE, lambda route: route.fulfill(body=blank, content_type="text/html"))
    page.goto(address)


@contextmanager
def opened(
    browser: Browser, explorer: LiveView | Comparison, address: str = SITE, **context
) -> Iterator[Page]:
    """Show the view on an empty page of its own; anything that the page complains about is an error."""
    page = browser.new_context(**{"viewport": {"width": 900, "height": 900}, **context}).new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: line.type == "error" and errors.append(line.text))
    go_to_empty_page(page, address)
    page.evaluate(MODEL, [explorer._esm, explorer._css, model_state(explorer)])
    yield page
    assert not errors, errors
    page.context.close()


def show(page: Page, **values: object) -> None:
    """Set values of the model and wait for the drawing; nothing is drawn where they are the present ones."""
    page.evaluate(
        """async (values) => {
             if (Object.entries(values).every(([name, value]) => model.get(name) === value)) return;
             const done = drawn();
             for (const [name, value] of Object.entries(values)) model.set(name, value);
             await done;
           }""",
        values,
    )


def table(page: Page) -> np.ndarray:
    """Return the poles in the table at full precision."""
    rows = page.evaluate(
        "() => [...el.querySelectorAll('.poles tbody tr')].map(r => [+r.dataset.re, +r.dataset.im])"
    )
    return np.array(rows) @ [1, 1j]
