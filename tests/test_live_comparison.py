"""Two designs side by side, on the page of Section VIII."""

from collections.abc import Iterator

import pytest

from live_tables import every
from livepage import ROWS, LivePage, library, live, poles_of, relative_mismatch


@pytest.fixture(scope="module")
def shown(visit, request) -> Iterator[LivePage]:
    """A live view on its page, shared by the tests of one view."""
    with live(visit, request.param) as found:
        yield found


@every("comparison")
class TestComparison:
    def choose(self, shown: LivePage, side: int, at: int) -> None:
        chooser = shown.panel.locator(".widget-dropdown select").nth(side)
        if chooser.evaluate("s => s.selectedIndex") != at:
            shown.redrawn(lambda: chooser.select_option(index=at))

    def rows(self, shown: LivePage, side: int):
        return shown.root.locator(".side").nth(side).locator("table.poles").evaluate(ROWS)

    def step(self, shown: LivePage, side: int, key: str = "PageUp") -> None:
        canvas = shown.root.locator(".side").nth(side).locator("canvas[data-plane=locus]")
        canvas.focus()
        shown.redrawn(lambda: shown.page.keyboard.press(key))

    @pytest.fixture
    def view(self, shown):
        view = library("comparison")
        for side, name in enumerate(("IV: Eq. 78 (as printed)", "IV: Eq. 75, divided by U (corrected)")):
            self.choose(shown, side, view.designs.index(name))
        shown.page.wait_for_timeout(200)
        return view

    @pytest.mark.parametrize("side", [0, 1])
    def test_a_design_chosen_shows_the_librarys_poles(self, shown, view, side):
        other = self.rows(shown, 1 - side)
        name = ("left", "right")[side]
        for at in range(len(view.designs) - 1, -1, -1):
            self.choose(shown, side, at)
            setattr(view, name, at)
            assert relative_mismatch(poles_of(self.rows(shown, side)), view.closed_loop(name)) < 1e-6
            assert self.rows(shown, 1 - side) == other

    def test_a_link_keeps_both_sides_apart(self, shown, view, visit):
        self.choose(shown, 0, view.designs.index("V: Search (corrected)"))
        self.choose(shown, 1, view.designs.index("V: Figure 16 (as printed)"))
        self.step(shown, 0)
        self.step(shown, 1, "PageDown")
        shown.page.wait_for_function(
            "() => location.hash.includes('left-') && location.hash.includes('right-')"
        )
        shown.page.wait_for_timeout(300)
        tables = [self.rows(shown, side) for side in (0, 1)]
        assert tables[0] != tables[1]
        with live(visit, "comparison", shown.page.evaluate("location.hash")) as other:
            other.page.wait_for_timeout(400)
            assert [self.rows(other, side) for side in (0, 1)] == tables
        self.choose(shown, 0, view.designs.index("VI: Search (corrected)"))
        shown.page.wait_for_timeout(300)
        address = shown.page.evaluate("location.hash")
        assert "left-" not in address
        assert "right-" in address

    def test_undo_on_one_side_leaves_the_other(self, shown, view):
        start = [self.rows(shown, side) for side in (0, 1)]
        self.step(shown, 0)
        shown.page.wait_for_timeout(500)
        self.step(shown, 1)
        shown.page.wait_for_timeout(500)
        moved = [self.rows(shown, side) for side in (0, 1)]
        assert all(a != b for a, b in zip(start, moved, strict=True))
        left = shown.root.locator(".side").first
        shown.redrawn(left.get_by_role("button", name="undo").click)
        assert [self.rows(shown, side) for side in (0, 1)] == [start[0], moved[1]]
        shown.root.locator(".side").nth(1).locator("canvas[data-plane=locus]").focus()
        shown.redrawn(lambda: shown.page.keyboard.press("Control+z"))
        assert [self.rows(shown, side) for side in (0, 1)] == start
