"""Print the whole book, built as one page, into a PDF: `python book/whole_book.py FOLDER OUTPUT`.

Chromium prints it, with an outline from the headings and with links that lead within the PDF.
"""

import shutil
import sys
import threading
from pathlib import Path

import yaml
from playwright.sync_api import Page, sync_playwright

from chromium import FLAGS, find_chromium
from serve import server

ROOT = Path(__file__).parent.parent
READY = """async () => {
  for (const link of document.querySelectorAll('a[href*="#"]'))
    if (link.host === location.host && document.getElementById(decodeURIComponent(link.hash.slice(1))))
      link.setAttribute('href', link.hash);
  await window.MathJax?.startup.promise;
  await Promise.all([...document.images].map(image => { image.loading = 'eager'; return image.decode(); }));
}"""
NUMBER = '<div style="width: 100%; text-align: center; font-size: 8px"><span class="pageNumber"></span></div>'
MINUTES = 10


def at_the_root(folder: Path) -> str:
    """Move the page up to where its own links expect it, and return its name.

    Sphinx writes it in the folder of the first page, with links as from the root.

    Parameters
    ----------
    folder : Path
        What the builder ``singlehtml`` wrote.
    """
    first = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))["root"]
    shutil.copy(folder / f"{first}.html", folder / "whole.html")
    return "whole.html"


def printed(page: Page, address: str, output: Path) -> None:
    """Print the page at an address.

    Parameters
    ----------
    page : playwright.sync_api.Page
    address : str
    output : Path

    Raises
    ------
    RuntimeError
        If a script of the page fails.
    """
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.set_default_timeout(MINUTES * 60_000)
    page.goto(address, wait_until="load")
    page.evaluate(READY)
    page.pdf(
        path=output,
        format="A4",
        outline=True,
        tagged=True,
        prefer_css_page_size=True,
        display_header_footer=True,
        header_template="<span></span>",
        footer_template=NUMBER,
    )
    if errors:
        raise RuntimeError(f"scripts of {address} in whole_book: got {errors}, wanted none")


def main(folder: str, output: str) -> None:
    """Print the book.

    Parameters
    ----------
    folder : str
        What the builder ``singlehtml`` wrote.
    output : str
        The PDF.
    """
    name = at_the_root(Path(folder))
    with server(Path(folder)) as running, sync_playwright() as playwright:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        chromium = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS)
        printed(chromium.new_page(), f"http://127.0.0.1:{running.server_port}/{name}", Path(output))
        chromium.close()
        running.shutdown()


if __name__ == "__main__":
    main(*sys.argv[1:])
