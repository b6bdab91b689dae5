"""Random and hostile addresses of the built pages: no error, no long task, and the views live on.

100 addresses a page with ``make test``, 2,000 with ``make fuzz``; one of 50 opens a page, the others come by
a change of its address.  A task over 500 ms counts when it is so in each of four tries: a busy machine may
hold up any page once, a state that is slow to draw is slow each time.  To open a page takes its time there:
so long may a task be with an address too.
"""

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page

from conftest import cases
from livepage import ON_PAGES, PAGES, library

BOOK = Path(__file__).parent.parent / "book"
VIEW = re.compile(r"\b(explorers\.\w+|rl\.explore)\(")
COUNT = cases(100)
FRESH = 50
LONGEST = 500  # ms
TRIES = 4
SHOWN = ("map", "input", "printed", "mode", "duration", "gust", "locus", "window", "magnify", "desk")
SHOWN += ("frequency", "compensator", "requirements")
NUMBERS = ["1e308", "-1e308", "1e155", "1e150", "1e60", "-1e60", "1e400", "Infinity", "-Infinity", "NaN"]
NUMBERS += ["0", "-0", "1e-320", "-1e-300", "0x10", "1_000", "1,5", "1e", "", " ", "9" * 400, "3.5", "-1"]
TEXTS = ["%00", "%ZZ", "%E0%A4", "<img src=x onerror=alert(1)>", "%3Cscript%3Ealert(1)%3C/script%3E"]
TEXTS += ["__proto__", "constructor", "total", "rigid body", "coupling", "K_A", "undefined", "null"]
TEXTS += ["'\"`", "\u202e", "=", "a" * 3000]
WINDOWS = ["1e308_1e308_1e308", "0_0_0", "0_0_-1", "1e308_0_1", "0_0_1e-300", "0_0_1e300", "0_0_1", "1_2_3_4"]
WINDOWS += ["_", "NaN_0_1", "1e6_1e6_1e-7", "-4_-1_1e5", "0_0_1e-7", "-1e6_0_1e5", "0_1e308_16"]
DESKS = ["52_57_", "20_80_map.poles", "52_57_map..poles", "99_99_map", "open", "52_57_a" + ".a" * 3000]
COMPENSATORS = ["K_A~1~notch_3_0.05_0.5~delay_0.1_4~lead_-0.5_-20", "k~0.5~delay_1_4~poles_3_-1"]
COMPENSATORS += [
    "K_A~1e4~pole_1000~pole_0~pole_-0.01~delay_10_4~notch_1000_0_0.01",
    "K_A~1~zero_0",
    "K_A~1~pole_1e9",
]
COMPENSATORS += ["kK_z~-1~lead_-1000_-0.01~zeros_0.01_1~poles_1000_0.001", "K_z~1~" + "delay_0.1_4~" * 400]
ASKED = [
    "zeta_0.999~sigma_1000~settling_0.001~overshoot_0.1~gain_60~phase_179",
    "zeta_0",
    "sigma_1e308",
    "gain_6",
]

VISIT = """async (addresses) => {
  const settle = (ms) => new Promise((done) => setTimeout(done, ms));
  const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
  const starts = [];
  for (const address of addresses) {
    starts.push(performance.now());
    location.hash = address;
    await settle(0);
    await frame();
    await frame();
  }
  await settle(100); // long tasks are told late
  const most = (i) => Math.max(0, ...globalThis.tasks
    .filter((task) => task.startTime + task.duration > starts[i] && !(task.startTime > starts[i + 1]))
    .map(({ duration }) => duration));
  return addresses.map((address, i) => [address, most(i)]);
}"""
WATCH = """globalThis.tasks = [];
new PerformanceObserver((list) => tasks.push(...list.getEntries())).observe({ type: 'longtask' });"""
TOLD = """name => {
  const root = document.querySelector(`[data-explorer='${name}']`);
  return root.innerText + [...root.querySelectorAll('canvas')].map((canvas) => canvas.ariaLabel);
}"""
PICTURES = {"comparison": "canvas[data-plane=locus]", "station-map": "canvas[data-plane=stations]"}
"""Views whose sliders are elsewhere: arrow keys on these pictures move something."""


def value(rng: random.Random, grid: tuple) -> str:
    """Return a value for a parameter: one of its places, a number of any size, or nonsense."""
    kind = rng.random()
    if kind < 0.3:
        return str(rng.choice(grid))
    if kind < 0.6:
        return f"{rng.choice([-1, 1]) * 10 ** rng.uniform(-320, 308):.6g}"
    return rng.choice(NUMBERS if kind < 0.85 else TEXTS)


def part(rng: random.Random, name: str) -> str:
    """Return what an address says of one view: its parameters, what it shows, and names that it hasn't."""
    if name == "comparison":
        pairs = {key: rng.choice([str(rng.randrange(-2, 40)), *NUMBERS]) for key in ("left", "right")}
        side = f"{rng.choice(['left', 'right'])}-{library(name).left}"
        return (
            f"{name}:"
            + ",".join(f"{k}={v}" for k, v in pairs.items())
            + f"&{said(rng, 'rate-attitude', side)}"
        )
    return said(rng, name, name)


def said(rng: random.Random, name: str, by: str) -> str:
    """Return what an address says of the view with the parameters of ``name``, called ``by`` in it."""
    pairs = {p.name: value(rng, p.grid) for p in library(name).parameters if rng.random() < 0.6}
    for key in SHOWN:
        if rng.random() < 0.15:
            pairs[f"view.{key}"] = rng.choice([str(rng.randrange(-2, 20)), *NUMBERS, *TEXTS])
    if rng.random() < 0.3:
        pairs["view.window"] = rng.choice(WINDOWS)
    if rng.random() < 0.1:
        pairs["view.desk"] = rng.choice(DESKS)
    if rng.random() < 0.2:
        pairs["view.compensator"] = rng.choice(COMPENSATORS)
        pairs["view.frequency"] = rng.choice(["bode", "nichols", "nyquist", "all"])
    if rng.random() < 0.2:
        pairs["view.requirements"] = rng.choice(ASKED)
    if rng.random() < 0.2:
        pairs[rng.choice(TEXTS)] = rng.choice(NUMBERS)
    return f"{by}:" + rng.choice([",", ",", ",", ",,", "=,"]).join(f"{k}={v}" for k, v in pairs.items())


def addresses(path: str, count: int) -> list[str]:
    """Return addresses of a page, the same on each run: whole ones, and now and then mere rubbish."""
    rng = random.Random(f"1964 {path}")
    names = ON_PAGES[path]
    rubbish = [
        "&&::,,==",
        "%",
        "fig-8",
        "desk",
        ":",
        "comparison:left",
        f"{names[0]}:",
        f"{names[0]}.2:K_A=1",
        "x" * 20000,
    ]
    found = []
    for _ in range(count):
        parts = [part(rng, rng.choice(names)) for _ in range(rng.choice([1, 1, 1, 2]))]
        if rng.random() < 0.1:
            parts.insert(rng.randrange(len(parts) + 1), rng.choice(rubbish))
        found.append("&".join(parts))
    return found


@pytest.fixture
def errors() -> Iterator[list[str]]:
    """All that goes wrong on any page of a test; at its end there must be nothing."""
    found: list[str] = []
    yield found
    assert found == []


def test_no_page_with_a_view_is_left_out():
    """The views of one's own loop and of the preface are tried in tests of their own."""
    made = {
        f"book/{path.stem}.html"
        for path in BOOK.glob("*.ipynb")
        if VIEW.search(path.read_text(encoding="utf-8"))
    }
    assert made == {*ON_PAGES, "book/20-own-loop.html", "book/preface.html"}


def opened(browser, plain_site: str, path: str, errors: list[str], address: str = "") -> Page:
    """Open a page that keeps its long tasks, and wait until each of its views has been drawn."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.set_default_timeout(120_000)
    page.add_init_script(WATCH)
    page.on("pageerror", lambda error: errors.append(f"{page.url[:300]}: {error}"))
    page.on("console", lambda line: line.type == "error" and errors.append(f"{page.url[:300]}: {line.text}"))
    page.on("dialog", lambda dialog: (errors.append(f"dialog: {page.url[:300]}"), dialog.dismiss()))
    page.goto(f"{plain_site}/{path}#{address}" if address else f"{plain_site}/{path}")
    for name in ON_PAGES[path]:
        page.locator(f"[data-explorer='{name}'] canvas").first.wait_for()
    return page


def assert_alive(page: Page, path: str) -> None:
    """Off the desk, a key on the first slider of each view, or on its picture, changes what it tells."""
    page.keyboard.press("Escape")
    for name in ON_PAGES[path]:
        panel = page.locator(".live-view", has=page.locator(f"[data-explorer='{name}']")).first
        target = panel.locator(PICTURES.get(name, "[role=slider]")).first
        target.scroll_into_view_if_needed()
        page.wait_for_timeout(100)
        before = page.evaluate(TOLD, name)
        at, first = (target.get_attribute(f"aria-value{which}") for which in ("now", "min"))
        target.press("ArrowLeft" if name in PICTURES else "ArrowRight" if at == first else "Home")
        page.wait_for_function(f"([name, before]) => ({TOLD})(name) !== before", arg=[name, before])


def is_always_slow(browser, plain_site, path, errors, address) -> bool:
    """Whether an address has a long task each time that a page of its own goes there."""
    for _ in range(TRIES - 1):
        page = opened(browser, plain_site, path, errors)
        page.wait_for_timeout(500)
        page.evaluate("() => { globalThis.tasks.length = 0; }")
        slow = page.evaluate(VISIT, [address])
        page.close()
        if all(ms <= LONGEST for _, ms in slow):
            return False
    return True


def longest_task(page: Page) -> float:
    """Return the longest task (ms) of a page so far, once it has come to rest."""
    page.wait_for_timeout(300)
    return page.evaluate("() => Math.max(0, ...globalThis.tasks.map(({ duration }) => duration))")


def is_always_slow_to_open(browser, plain_site, path, errors, address) -> bool:
    """Whether a page opens with a long task each time, longer than it has without the address beside it."""
    for _ in range(TRIES - 1):
        times = []
        for hash_ in (address, ""):
            page = opened(browser, plain_site, path, errors, hash_)
            times.append(longest_task(page))
            page.close()
        if times[0] <= max(LONGEST, 1.5 * times[1]):
            return False
    return True


@pytest.mark.parametrize("path", ON_PAGES)
def test_addresses(browser, plain_site, errors, path):
    """The first of 50 opens a page, and the others change its address."""
    given, suspects = addresses(path, COUNT), []
    for start in range(0, COUNT, FRESH):
        first, *changing = given[start : start + FRESH]
        page = opened(browser, plain_site, path, errors, first)
        if longest_task(page) > LONGEST:
            assert not is_always_slow_to_open(browser, plain_site, path, errors, first), first
        assert_alive(page, path)
        suspects += page.evaluate(VISIT, changing)
        assert errors == []
        assert_alive(page, path)
        page.close()
    slow = [(address, ms) for address, ms in suspects if ms > LONGEST]
    assert [(a, ms) for a, ms in slow if is_always_slow(browser, plain_site, path, errors, a)] == []


def test_what_was_changed_is_said(browser, plain_site, errors):
    page = opened(browser, plain_site, PAGES["rate-attitude"], errors, "rate-attitude:K_A=1e308,K_R=x,Q=1")
    said = page.locator("[data-explorer=rate-attitude] output")
    assert said.inner_text() == (
        "A shared state was opened. "
        "K_A from the address is beyond its range −1,000 to 1,000: 1,000 is shown. "
        "K_R from the address is not a number and is left out. "
        "Q from the address is not known here and is left out."
    )
    page.wait_for_function(
        """() => {
             const el = document.querySelector('[data-explorer=rate-attitude]');
             const { top, bottom } = el.getBoundingClientRect();
             return top < innerHeight && bottom > 0;
           }"""
    )
    page.get_by_role("button", name="Back to the start").click()
    page.wait_for_function("() => !location.hash.includes('K_A')")
    assert said.inner_text() == ""
    page.close()


def test_a_drawing_that_fails_stops_no_later_one(browser, plain_site):
    page = opened(browser, plain_site, PAGES["coupling"], [])
    root = page.locator("[data-explorer=coupling]")
    root.scroll_into_view_if_needed()
    page.wait_for_function("() => document.querySelector('[data-explorer=coupling] table')?.innerText")
    page.evaluate(
        """() => {
             const draw = CanvasRenderingContext2D.prototype.fillRect;
             CanvasRenderingContext2D.prototype.fillRect = function (...given) {
               if (window.noInk && this.canvas.closest('[data-explorer=coupling]')) throw new Error('no ink');
               draw.apply(this, given);
             };
             window.noInk = true;
           }"""
    )
    slider = page.locator(".live-view", has=root).first.locator("[role=slider]").first
    slider.press("ArrowRight")
    page.wait_for_function("() => document.querySelector('[data-explorer=coupling] output').innerText")
    assert "could not be drawn (no ink)" in root.locator("output").inner_text()
    before = root.locator("table").first.inner_text()
    page.evaluate("window.noInk = false")
    slider.press("ArrowRight")
    page.wait_for_function(
        "before => document.querySelector('[data-explorer=coupling] table').innerText !== before", arg=before
    )
    page.wait_for_function("() => !document.querySelector('[data-explorer=coupling] output').innerText")
    page.close()
