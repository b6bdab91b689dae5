"""Print the whole book, built as one page, into a PDF: `python book/whole_book.py FOLDER OUTPUT`.

Chromium prints it, with an outline from the headings, contents with numbers of pages, and links that lead
within the PDF.  Folded solutions and tables are open.
"""

import shutil
import sys
import threading
from io import BytesIO
from pathlib import Path

import yaml
from playwright.sync_api import Page, sync_playwright
from pypdf import PdfReader

from chromium import FLAGS, find_chromium
from serve import server

ROOT = Path(__file__).parent.parent
READY = """async () => {
  for (const link of document.querySelectorAll('a[href*="#"]'))
    if (link.host === location.host && document.getElementById(decodeURIComponent(link.hash.slice(1))))
      link.setAttribute('href', link.hash);
  for (const fold of document.querySelectorAll('.bd-article details')) fold.open = true;
  await window.MathJax?.startup.promise;
  await Promise.all([...document.images].map(image => { image.loading = 'eager'; return image.decode(); }));
}"""
CONTENTS = """() => {  // where the theme prints a list of its own, without numbers of pages
  const title = document.querySelector('#jb-print-docs-body h1');
  const whole = document.querySelector('article section');
  const chapters = [whole,
    ...document.querySelectorAll('span[id^="document-"] + section')];
  const isChapter = (section) => section.previousElementSibling?.id.startsWith('document-');
  let count = 0;
  const entry = (section) => {
    const heading = section === whole ? title : section.querySelector(':is(h1, h2, h3, h4, h5, h6)');
    const [item, line, words, page] = ['li', 'a', 'span', 'b'].map((tag) => document.createElement(tag));
    const sections = [...section.children].filter((part) => part.matches('section') && !isChapter(part));
    heading.id = `contents-${++count}`;
    line.href = `#${heading.id}`;
    words.append(...[...heading.childNodes].filter((part) => !part.matches?.('.headerlink'))
      .map((part) => part.cloneNode(true)));
    line.append(words, page);
    item.append(line);
    if (chapters.includes(section) && sections.length) {
      const inner = document.createElement('ul');
      inner.append(...sections.map(entry));
      item.append(inner);
    }
    return item;
  };
  const contents = document.createElement('nav');
  const [caption, list, style] = ['h2', 'ul', 'style'].map((tag) => document.createElement(tag));
  contents.id = 'whole-contents';
  caption.textContent = 'Contents';
  list.append(...chapters.map(entry));
  style.textContent = `
    #whole-contents { break-after: page; }
    #whole-contents > ul { columns: 2; column-gap: 3em; }
    #whole-contents ul { list-style: none; margin: 0; padding: 0; font-size: 9px; line-height: 1.35; }
    #whole-contents > ul > li > a { font-weight: bold; margin-top: .5em; break-after: avoid; }
    #whole-contents ul ul { padding-left: 1em; }
    #whole-contents a { display: flex; justify-content: space-between; break-inside: avoid; }
    #whole-contents a { color: inherit; text-decoration: none; }
    #whole-contents b { flex: none; width: 2.5em; text-align: right; font-weight: inherit; }`;
  contents.append(caption, list);
  document.head.append(style);
  document.getElementById('jb-print-toc').replaceWith(contents);
}"""
FILL = """numbers => {
  for (const line of document.querySelectorAll('#whole-contents a'))
    line.lastChild.textContent = numbers[line.hash.slice(1)];
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


def _pdf(page: Page) -> bytes:
    return page.pdf(
        format="A4",
        outline=True,
        tagged=True,
        prefer_css_page_size=True,
        display_header_footer=True,
        header_template="<span></span>",
        footer_template=NUMBER,
    )


def numbers(book: bytes) -> dict[str, int]:
    """Return on which page of a PDF, counted from 1, the place of each line of the contents stands."""
    reader = PdfReader(BytesIO(book))
    return {
        name.removeprefix("/"): reader.get_destination_page_number(place) + 1
        for name, place in reader.named_destinations.items()
        if name.removeprefix("/").startswith("contents-")
    }


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
        If a script of the page fails, or if the contents with their numbers move what follows them.
    """
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.set_default_timeout(MINUTES * 60_000)
    page.goto(address, wait_until="load")
    page.evaluate(READY)
    page.evaluate(CONTENTS)
    found = numbers(_pdf(page))
    page.evaluate(FILL, found)
    book = _pdf(page)
    if errors:
        raise RuntimeError(f"scripts of {address} in whole_book: got {errors}, wanted none")
    if numbers(book) != found:
        raise RuntimeError("pages in whole_book: got other ones with their numbers, wanted the same")
    output.write_bytes(book)


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
