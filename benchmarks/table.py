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

With given gains both solve the same ones. For "picture" each chooses its own, their number is in
parentheses: ours lie within a quarter pixel of the exact curve, which the tests check, and control's
default does not. For "quarter pixel" control gets evenly spaced gains (in ln k, over the same span),
twice as many each time until its polyline is as true.

| work | ours (ms) | python-control (ms) | ratio |
|---|---:|---:|---:|
"""
MAP = """
## Station map

Largest real part of Section VII's closed loop at every pair of sensor and jet stations.

| pairs | time (s) | per pair (µs) | memory (MB) |
|---|---:|---:|---:|
"""


def median(run):
    return run["stats"]["median"]


def locus_row(group, runs):
    ours, control = (next(run for run in runs if run["name"] == who) for who in ("ours", "control"))
    size = [
        f" ({run['extra_info']['gains']})" if "gains" in run["extra_info"] else "" for run in (ours, control)
    ]
    times = [f"{1e3 * median(run):.2f}{more}" for run, more in zip((ours, control), size, strict=True)]
    return f"| {group} | {times[0]} | {times[1]} | {median(control) / median(ours):.1f} |"


def map_row(run):
    side = int(run["name"].split()[0])
    pairs, memory = side * side, run["extra_info"]["memory_MB"]
    return f"| {pairs:,} | {median(run):.2f} | {1e6 * median(run) / pairs:.1f} | {memory:.0f} |"


def page(data):
    runs = sorted(data["benchmarks"], key=lambda run: run["group"])
    groups = {group: list(found) for group, found in groupby(runs, key=lambda run: run["group"])}
    about = data["machine_info"]
    cpu = about["cpu"].get("brand_raw", "unknown processor")
    machine = f"{cpu}, {about['cpu']['count']} cores, {about['system']}"
    versions = {name: version(name) for name in ("rlswaim", "control", "numpy", "scipy")}
    loci = [locus_row(group, found) for group, found in groups.items() if not group.startswith("station map")]
    maps = sorted(groups["station map of Section VII"], key=median)
    head = HEAD.format(machine=machine, python=about["python_version"], **versions)
    return head + LOCI + "\n".join(loci) + "\n" + MAP + "\n".join(map(map_row, maps)) + "\n"


if __name__ == "__main__":
    text = page(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
    Path(sys.argv[2]).write_text(text, encoding="utf-8")
    sys.stdout.write(text)
