"""The loop on the first page moves by itself, unless it is paused or the reader wants no motion."""

import numpy as np
import pytest
from playwright.sync_api import Page

import rlswaim as rl
from rlswaim.explorers import moving_loop
from standin import go_to_empty_page
from workbench_page import EQUATIONS

GAIN = "() => Number(el.querySelector('output').textContent)"


@pytest.fixture
def page(browser, request):
    """The loop on a page of its own; anything that the page complains about is an error."""
    motion = getattr(request, "param", "no-preference")
    page = browser.new_context(viewport={"width": 900, "height": 700}, reduced_motion=motion).new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    go_to_empty_page(page)
    view = moving_loop(EQUATIONS)
    page.evaluate(
        """async ([code, css, payload]) => {
             const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
             const { default: views } = await import(address);
             document.head.append(Object.assign(document.createElement('style'), { textContent: css }));
             globalThis.el = document.body.appendChild(document.createElement('div'));
             el.addEventListener('rlswaim:drawn', () => { globalThis.drawn = (globalThis.drawn ?? 0) + 1; });
             globalThis.stop = views.render({ model: { get: () => payload }, el });
           }""",
        [view._esm, view._css, view.payload],
    )
    page.wait_for_function("() => globalThis.drawn")
    yield page
    assert errors == []
    page.context.close()


def gain(page: Page) -> float:
    return page.evaluate(GAIN)


def test_its_gain_runs_at_once_until_it_is_paused(page):
    before = gain(page)
    page.wait_for_function(f"before => ({GAIN})() !== before", arg=before)
    page.get_by_role("button", name="Pause").click()
    page.wait_for_timeout(100)
    here, drawn = gain(page), page.evaluate("drawn")
    page.wait_for_timeout(300)
    assert (gain(page), page.evaluate("drawn")) == (here, drawn)
    page.get_by_role("button", name="Let the gain run").click()
    page.wait_for_function(f"before => ({GAIN})() !== before", arg=here)
    assert abs(np.log(gain(page) / here)) < 0.5, "it goes on from where it was"


@pytest.mark.parametrize("page", ["reduce"], indirect=True)
def test_it_stands_where_no_motion_is_wanted(page):
    before = gain(page)
    page.wait_for_timeout(400)
    assert gain(page) == before == 1.8
    assert page.get_by_role("button", name="Let the gain run").is_visible()


def test_it_rests_while_nobody_sees_it(page):
    page.evaluate("document.body.insertAdjacentHTML('beforeend', '<div style=\"height: 4000px\"></div>')")
    page.evaluate("scrollTo(0, 3000)")
    page.wait_for_timeout(200)
    drawn = page.evaluate("drawn")
    page.wait_for_timeout(300)
    assert page.evaluate("drawn") == drawn


@pytest.mark.parametrize("place", [0, 250, 500, 1000])
def test_by_hand_it_tells_the_librarys_largest_root_and_leads_on_to_that_gain(page, place):
    page.locator("input[type=range]").fill(str(place))
    assert page.get_by_role("button", name="Let the gain run").is_visible()
    K_A, wanted = gain(page), 0.02 * 1000 ** (place / 1000)
    assert abs(K_A - wanted) <= 0.01 * wanted
    worst = max(rl.rate_attitude(EQUATIONS, K_A=K_A, K_C=10, K_R=0.618, gyro=60).poles().real)
    words = page.locator(".verdict").inner_text()
    assert words.startswith("Unstable")
    assert f"+{worst:.3f}"[:5] in words
    assert page.get_by_role("link").get_attribute("href") == (
        f"04-rate-and-attitude-feedback.html#rate-attitude:K_A={K_A:g},K_C=10,K_R=0.618,gyro=60,"
        "feedback=total"
    )


def test_python_names_it_and_its_still(page):
    view = moving_loop(EQUATIONS)
    assert repr(view) == "moving loop: K_A from 0.02 to 20"
    assert set(view._repr_mimebundle_()) >= {"image/png", "text/plain"}
    with pytest.raises(TypeError, match="moving loop"):
        moving_loop(3)
