"""Write a run's medians and ratios as a page of the book: ``python benchmarks/table.py RUN.json PAGE.md``."""

import json
import sys
from importlib.metadata import version
from itertools import groupby
from pathlib import Path

HEAD = """# Speed, measured

What a root locus costs here, beside python-control's `root_locus_map` and `root_locus_plot`, in one
run on one machine. The ratios carry over to other machines, the times do not. `make bench` runs all
again and writes this page.

Machine: {machine}. Python {python}, rlswaim {rlswaim}, python-control {control}, numpy {numpy},
scipy {scipy}.
Each figure is a median; BLAS has one thread.
"""
LOCI = """
## Root loci

The ratios are python-control's time over ours. Nothing is compiled: an earlier form with numba followed the
branches of a picture several times faster, but its start in each process took longer than dozens of pictures
take now.

With given gains all solve the same ones, ours without the list of crossings, which is found when first
asked for. For "picture" each chooses its own, their number is in
parentheses: ours lie within a quarter pixel of the exact curve, which the tests check, and control's
default does not. For "quarter pixel" control gets evenly spaced gains (in ln k, over the same span),
twice as many each time until its polyline is as true, or 8192.

| work | ours (ms) | python-control (ms) | ratio |
|---|---:|---:|---:|
"""
GROWTH = """
## Order and number of gains

Random loops, with gains chosen for a picture (their number is in parentheses) and with given gains.

| order | picture (ms) | 100 gains (ms) | 1000 gains (ms) |
|---:|---:|---:|---:|
"""
MAP = """
## Station map

Largest real part of Section VII's closed loop at every pair of sensor and jet stations.

| pairs | time (s) | per pair (µs) | memory (MB) |
|---|---:|---:|---:|
"""
LIVE = """
## Live views

Each view of the book in Chromium, on the built pages: all its sliders are moved by keys, a press every
other frame, and the first one is dragged by the mouse. "Key to picture" runs from the key press to the
finished drawing: a view draws before the key's event is over, and the browser shows it with its next frame,
every 16.7 ms. "Compute and draw" is that part of it which is the view's own. The usual way,
`interactive_output` with `control.root_locus_plot` through a real kernel, takes {usual:.0f} ms (median; 95
percent within {usual_95:.0f} ms) from a slider's message to the picture's, the browser's own work not
counted; the ratio is that median over ours. The scripts of widgets and views have {runtime:.0f} kB
gzipped together, for the whole book.

| view | key to picture (ms) | 95 % | compute and draw (ms) | 95 % | tasks over 50 ms | ratio |
|---|---:|---:|---:|---:|---:|---:|
"""
PAGES = """
From opening a page (empty cache, a server on the same machine) to its first view's picture, which a hand
can then move:

| page | first picture after (ms) | own data and code (kB gzipped) |
|---|---:|---:|
"""


def median(run):
    return run["stats"]["median"]


def locus_row(group, runs):
    by_who = {run["name"]: run for run in runs}
    ours, control = (by_who[who] for who in ("rlswaim", "control"))
    return f"| {group} | {time(ours)} | {time(control)} | {median(control) / median(ours):.1f} |"


def time(run):
    """Return a run's time (ms), and the number of its gains where it tells them."""
    size = f" ({run['extra_info']['gains']})" if "gains" in run["extra_info"] else ""
    return f"{1e3 * median(run):.2f}{size}"


def map_row(run):
    side = int(run["name"].split()[0])
    pairs, memory = side * side, run["extra_info"]["memory_MB"]
    return f"| {pairs:,} | {median(run):.2f} | {1e6 * median(run) / pairs:.1f} | {memory:.0f} |"


def loci(groups):
    others = "station map", "live", "growth"
    rows = [locus_row(n, runs) for n, runs in groups.items() if not n.startswith(others)]
    return LOCI + "\n".join(rows) + "\n"


def growth(groups):
    by_name = {run["name"]: run for run in groups.get("growth", [])}
    rows = []
    for order in sorted({int(name.split()[0]) for name in by_name}):
        picture, few, many = (by_name[f"{order} {count}"] for count in ("picture", 100, 1000))
        rows.append(f"| {order} | {time(picture)} | {1e3 * median(few):.2f} | {1e3 * median(many):.2f} |")
    return GROWTH + "\n".join(rows) + "\n" if rows else ""


def maps(groups):
    rows = [map_row(run) for run in sorted(groups.get("station map of Section VII", []), key=median)]
    return MAP + "\n".join(rows) + "\n" if rows else ""


def quantile(times, percent):
    return sorted(times)[min(len(times) * percent // 100, len(times) - 1)]


def view_row(view, usual):
    times = [quantile(view[what], percent) for what in ("drawn", "ms") for percent in (50, 95)]
    shown = " | ".join(f"{t:.1f}" for t in times)
    return f"| {view['name']} | {shown} | {view['long_tasks']} | {usual / times[0]:.0f} |"


def live(groups):
    if "live views" not in groups:
        return ""
    runs = [run["extra_info"] for run in groups["live views"]]
    usual = next(run["live_usual_ms"] for run in runs if "live_usual_ms" in run)
    pages = [run["live"] for run in runs if "live" in run]
    head = LIVE.format(
        usual=quantile(usual, 50), usual_95=quantile(usual, 95), runtime=pages[0]["runtime_kB"]
    )
    views = [view_row(view, quantile(usual, 50)) for page in pages for view in page["views"]]
    weights = [f"| {p['page']} | {p['first_ms']:.0f} | {p['own_kB']:.0f} |" for p in pages]
    return head + "\n".join(views) + "\n" + PAGES + "\n".join(weights) + "\n"


END = """
## What follows from this

- A locus that is true to a quarter pixel costs milliseconds, so a picture can follow a slider.
- In the browser a whole move, key to picture, costs a fraction of what a kernel needs for the picture alone.
- A map of every pair of stations costs seconds and little memory: the whole vehicle instead of 24 pairs.
- What the ratios rest on, and how the gains are chosen, stands in [chapter X](10-loci-and-maps).
"""


def end(groups):
    return END


SECTIONS = [loci, growth, maps, live, end]
"""What the page shows below its head: each takes the runs by group and returns Markdown, "" without runs."""


def page(data):
    runs = sorted(data["benchmarks"], key=lambda run: run["group"])
    groups = {group: list(found) for group, found in groupby(runs, key=lambda run: run["group"])}
    about = data["machine_info"]
    cpu = about["cpu"].get("brand_raw", "unknown processor")
    machine = f"{cpu}, {about['cpu']['count']} cores, {about['system']}"
    versions = {name: version(name) for name in ("rlswaim", "control", "numpy", "scipy")}
    head = HEAD.format(machine=machine, python=about["python_version"], **versions)
    return head + "".join(section(groups) for section in SECTIONS)


if __name__ == "__main__":
    text = page(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
    Path(sys.argv[2]).write_text(text, encoding="utf-8")
    sys.stdout.write(text)
