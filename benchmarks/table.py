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
scipy {scipy}, numba {numba}.
Each figure is a median; BLAS has one thread.
"""
LOCI = """
## Root loci

Numba is an optional extra, `pip install rlswaim[fast]`: where it is installed, loci are followed by compiled
code, with the same roots to 1e-10. Both ways are timed, numba after a first call, which once on a machine
compiles for some 20 s. The ratios are python-control's time over ours.

With given gains all solve the same ones. For "picture" each chooses its own, their number is in
parentheses: ours lie within a quarter pixel of the exact curve, which the tests check, and control's
default does not. For "quarter pixel" control gets evenly spaced gains (in ln k, over the same span),
twice as many each time until its polyline is as true, or 8192.

| work | ours, numpy (ms) | ours, numba (ms) | python-control (ms) | ratio, numpy | ratio, numba |
|---|---:|---:|---:|---:|---:|
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
    by_who = {run["name"]: run for run in runs}
    ours_and_control = [by_who[who] for who in ("numpy", "numba", "control")]
    sizes = [f" ({run['extra_info']['gains']})" if "gains" in run["extra_info"] else "" for run in runs]
    sizes = dict(zip(by_who, sizes, strict=True))
    times = [f"{1e3 * median(run):.2f}{sizes[run['name']]}" for run in ours_and_control]
    ratios = [f"{median(by_who['control']) / median(run):.1f}" for run in ours_and_control[:2]]
    return f"| {group} | {' | '.join([*times, *ratios])} |"


def map_row(run):
    side = int(run["name"].split()[0])
    pairs, memory = side * side, run["extra_info"]["memory_MB"]
    return f"| {pairs:,} | {median(run):.2f} | {1e6 * median(run) / pairs:.1f} | {memory:.0f} |"


def loci(groups):
    rows = [locus_row(name, runs) for name, runs in groups.items() if not name.startswith("station map")]
    return LOCI + "\n".join(rows) + "\n"


def maps(groups):
    rows = map(map_row, sorted(groups["station map of Section VII"], key=median))
    return MAP + "\n".join(rows) + "\n"


END = """
## What follows from this

- A locus that is true to a quarter pixel costs milliseconds, so a picture can follow a slider.
- A map of every pair of stations costs seconds and little memory: the whole vehicle instead of 24 pairs.
- What the ratios rest on, and how the gains are chosen, stands in [chapter X](10-loci-and-maps).
"""


def end(groups):
    return END


SECTIONS = [loci, maps, end]
"""What the page shows below its head: each is called with the runs by group and returns Markdown."""


def page(data):
    runs = sorted(data["benchmarks"], key=lambda run: run["group"])
    groups = {group: list(found) for group, found in groupby(runs, key=lambda run: run["group"])}
    about = data["machine_info"]
    cpu = about["cpu"].get("brand_raw", "unknown processor")
    machine = f"{cpu}, {about['cpu']['count']} cores, {about['system']}"
    versions = {name: version(name) for name in ("rlswaim", "control", "numpy", "scipy", "numba")}
    head = HEAD.format(machine=machine, python=about["python_version"], **versions)
    return head + "".join(section(groups) for section in SECTIONS)


if __name__ == "__main__":
    text = page(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
    Path(sys.argv[2]).write_text(text, encoding="utf-8")
    sys.stdout.write(text)
