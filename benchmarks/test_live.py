"""The live views in Chromium on the built book, beside the usual way: a figure redrawn by a kernel.

Each view's slider is moved by keys; the page's own clock says how long a move takes until all is drawn.
"""

import gzip
import re
import threading
import time

import numpy as np
import pytest
from jupyter_client.manager import start_new_kernel
from playwright.sync_api import sync_playwright

from chromium import find_chromium
from conftest import FLAGS, HTML
from serve import server

VIEW = "application/vnd.jupyter.widget-view+json"
PAGES = sorted(p.name for p in (HTML / "book").glob("*.html") if VIEW in p.read_text(encoding="utf-8"))
WATCH = """() => {
  const seen = (globalThis.live = { name: null, drawn: [], ms: [], long: 0, first: null, pressed: null });
  addEventListener('keydown', (e) => (seen.pressed = e.timeStamp), true);
  addEventListener('rlswaim:drawn', (e) => {
    seen.first ??= performance.now();
    if (e.target.dataset.explorer !== seen.name) return;
    seen.ms.push(e.detail.ms);
    if (seen.pressed !== null) seen.drawn.push(performance.now() - seen.pressed);
    seen.pressed = null;
  }, true);
  new PerformanceObserver((list) => (seen.long += list.getEntries().length)).observe({ type: 'longtask' });
}"""
NEXT_FRAMES = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
USUAL = """
import warnings; warnings.simplefilter("ignore")
%matplotlib inline
import control, ipywidgets, rlswaim as rl
from matplotlib import pyplot as plt
from rlswaim.loops.transfer_functions import theta_loop
eqs, slider = rl.printed_equations(), ipywidgets.FloatSlider(0.618, min=-1, max=1, step=0.01)
def draw(K_R):
    control.root_locus_plot(theta_loop(eqs, K_C=10, K_R=K_R, gyro=60), ax=plt.figure().subplots())
    plt.show()
out = ipywidgets.interactive_output(draw, {"K_R": slider})
print(slider.comm.comm_id)
"""


@pytest.fixture(scope="module")
def site():
    with server(HTML) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}/book"
        running.shutdown()


@pytest.fixture(scope="module")
def browser():
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=find_chromium(window=True), args=FLAGS)
        yield chromium
        chromium.close()


def moved(page, handle, presses):
    """Press a slider's keys, to and fro; a press for every two frames."""
    handle.focus()
    for i in range(presses):
        page.keyboard.press("ArrowLeft" if i // 10 % 2 else "ArrowRight")
        page.evaluate(NEXT_FRAMES)


def dragged(page, handle):
    """Drag a slider by the mouse over its whole length."""
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    for step in range(60):
        page.mouse.move(box["x"] + 4 * step, box["y"] + box["height"] / 2)
    page.mouse.up()


def weights(path):
    """Return the gzipped sizes (kB) of a page's own data, and of what all pages with views share."""
    text = path.read_text(encoding="utf-8")
    states = re.findall(
        r'<script type="application/vnd.jupyter.widget-state\+json">(.*?)</script>', text, re.S
    )
    names = ("rlswaim-widgets.js", "rlswaim-views.js", "rlswaim-views.css")
    shared = [HTML / "_static" / name for name in names]
    parts = ["".join(states).encode(), b"".join(path.read_bytes() for path in shared)]
    return [len(gzip.compress(part)) / 1e3 for part in parts]


BENCH = "contains(concat(' ', @class, ' '), ' bench ')"
"""A view that the page alone holds, with its own sliders."""


@pytest.mark.parametrize("page_name", PAGES)
def test_live_views(benchmark, browser, site, page_name):
    """Every slider of every view of a page, by keys, then one of them by the mouse."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.add_init_script(f"({WATCH})()")
    page.goto(f"{site}/{page_name}")
    views = page.locator("[data-explorer]:not(:has([data-explorer]))")  # the comparison's are its two sides
    page.wait_for_function("() => live.first !== null")
    found = {"page": page_name, "first_ms": page.evaluate("() => live.first"), "views": []}
    found["own_kB"], found["runtime_kB"] = weights(HTML / "book" / page_name)

    def work():
        for at in range(views.count()):
            name = views.nth(at).get_attribute("data-explorer")
            handles = (
                views.nth(at)
                .locator(f"xpath=ancestor::*[{BENCH} or contains(@class, 'live-view')][1]")
                .get_by_role("slider")
            )
            if not handles.count():
                continue
            page.evaluate("(name) => Object.assign(live, { name, drawn: [], ms: [], long: 0 })", name)
            for i in range(handles.count()):
                moved(page, handles.nth(i), 200 // handles.count())
            keys = page.evaluate("() => ({ drawn: live.drawn, ms: live.ms })")
            page.evaluate("() => (live.long = 0)")
            dragged(page, handles.first)
            found["views"].append({"name": name, **keys, "long_tasks": page.evaluate("() => live.long")})

    benchmark.group, benchmark.name = "live views", page_name
    benchmark.pedantic(work, rounds=1)
    benchmark.extra_info["live"] = found
    page.close()
    assert all(view["drawn"] for view in found["views"])


def test_usual_way(benchmark):
    """A slider of ``interactive_output`` moves, and a kernel draws control's root locus anew."""
    manager, client = start_new_kernel()
    out = []
    client.execute_interactive(USUAL, output_hook=out.append, timeout=120)
    comm = next(m["content"]["text"].strip() for m in out if m["msg_type"] == "stream")
    times = []

    def work():
        for value in np.linspace(-0.9, 0.9, 15):
            content = {"comm_id": comm, "data": {"method": "update", "state": {"value": value}}}
            message, start = client.session.msg("comm_msg", content), time.perf_counter()
            client.shell_channel.send(message)
            kinds = []
            while True:
                reply = client.get_iopub_msg(timeout=60)
                if reply["parent_header"].get("msg_id") != message["header"]["msg_id"]:
                    continue
                kinds.append(reply["msg_type"])
                if reply["msg_type"] == "status" and reply["content"]["execution_state"] == "idle":
                    break
            times.append(1e3 * (time.perf_counter() - start))
            assert "display_data" in kinds

    benchmark.group, benchmark.name = "live views", "usual way"
    benchmark.pedantic(work, rounds=1, warmup_rounds=1)
    benchmark.extra_info["live_usual_ms"] = times
    client.stop_channels()
    manager.shutdown_kernel(now=True)
