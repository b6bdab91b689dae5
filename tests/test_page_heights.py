"""No chapter is too tall to find one's way in: its height at 1280 px, as it opens, all folds closed."""

from pathlib import Path

import pytest

BOOK = Path(__file__).parent.parent / "book"
CHAPTERS = [f"book/{path.stem}.html" for path in sorted(BOOK.glob("0[1-8]-*.ipynb"))]
TALLEST = 20_000  # px
SETTLED = """async () => {
  const all = document.documentElement;
  for (let y = 0; y < all.scrollHeight; y += 800) {
    scrollTo(0, y);
    await new Promise(next => setTimeout(next, 30));
  }
  return all.scrollHeight;
}"""


def test_all_chapters_are_measured():
    assert len(CHAPTERS) == 8


@pytest.mark.parametrize("path", CHAPTERS)
def test_a_chapter_is_at_most_20000_px_tall(visit, path):
    with visit(path) as (page, outside, errors):
        page.wait_for_timeout(500)  # what comes late
        assert page.evaluate("innerWidth") == 1280
        page.evaluate(SETTLED)
        page.wait_for_timeout(300)
        height = page.evaluate("document.documentElement.scrollHeight")
        assert page.locator("details.hide[open], details.sd-dropdown[open]").count() == 0
        assert 5_000 < height <= TALLEST
        assert (outside, errors) == ([], [])
