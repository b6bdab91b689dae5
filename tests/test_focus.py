"""Focus can be seen where the reader's system sets the colours: an outline at each stop of the Tab key."""

PAGE = "book/04-rate-and-attitude-feedback.html"
FIRST = ".live-view [role=slider]"
STOP = """() => {
  const at = document.activeElement, { outlineStyle, outlineWidth } = getComputedStyle(at);
  const name = `${at.tagName} ${at.getAttribute('aria-label') ?? at.textContent.trim().slice(0, 40)}`;
  return [Boolean(at.closest('.live-view')), name, outlineStyle, parseFloat(outlineWidth)];
}"""


def test_each_stop_of_a_workbench_has_an_outline_in_forced_colours(browser, plain_site):
    page = browser.new_context(forced_colors="active", viewport={"width": 1280, "height": 900}).new_page()
    page.goto(f"{plain_site}/{PAGE}")
    page.locator(FIRST).first.focus()
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Tab")
    stops = []
    while (stop := page.evaluate(STOP))[0]:
        stops.append(stop[1:])
        assert len(stops) < 200
        page.keyboard.press("Tab")
    assert len(stops) > 20
    assert [name for name, style, width in stops if style == "none" or not width] == []
    page.context.close()
