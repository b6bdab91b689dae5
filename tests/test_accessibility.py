"""No page has a fault that axe calls serious or critical: light, dark, in forced colors, all folds open."""

from pathlib import Path

import pytest

from conftest import MATHJAX
from test_pages import PAGES

ROOT = Path(__file__).parent.parent
FORMULAS_SET = ["book/notation.html"]
"""Formulas and icons are alike on all pages, and axe takes most of its time for them: others go without."""
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
SCHEMES = {
    "light": {"color_scheme": "light", "forced_colors": "none"},
    "dark": {"color_scheme": "dark", "forced_colors": "none"},
    "forced": {"color_scheme": "light", "forced_colors": "active"},
}
COLORS_ALONE = {"runOnly": {"type": "rule", "values": ["color-contrast", "link-in-text-block"]}}
"""What depends on the scheme: all else is the same in each."""
OPENED = """async () => {
  await window.MathJax?.startup.promise;
  for (const fold of document.querySelectorAll('details')) fold.open = true;
}"""
SETTLED = """async () => {
  await new Promise((done) => setTimeout(done, 100));
  await Promise.all(document.getAnimations().map((one) => one.finished.catch(() => null)));
}"""
FAULTS = """async (rules) => {
  const found = await axe.run(document, { resultTypes: ['violations'], ...rules });
  return found.violations.filter(one => ['serious', 'critical'].includes(one.impact))
    .flatMap(one => one.nodes.map(node => `${one.id}: ${node.target} ${node.html.slice(0, 100)}`));
}"""


@pytest.mark.parametrize("path", PAGES)
def test_page_has_no_serious_fault(browser, site, plain_site, path):
    context = browser.new_context(viewport={"width": 1280, "height": 900}, bypass_csp=True)
    page = context.new_page()
    page.goto(f"{site if path in FORMULAS_SET else plain_site}/{path}")
    page.wait_for_function(MATHJAX)
    page.wait_for_timeout(250)
    page.evaluate(OPENED)
    page.add_script_tag(path=AXE)
    found = {}
    for name, scheme in SCHEMES.items():
        page.emulate_media(**scheme)
        page.evaluate(SETTLED)
        found[name] = page.evaluate(FAULTS, {} if name == "light" else COLORS_ALONE)
    assert found == {name: [] for name in SCHEMES}
    context.close()
