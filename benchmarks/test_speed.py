"""Times of root loci, redraws and station maps, each beside what people use now, in one run.

Groups of pytest-benchmark: in each, "rlswaim" and "control" do the same work.
"""

import tracemalloc

import control
import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure

import rlswaim as rl
from cases import loops, random_loop
from exact import off_the_polyline
from redraw import LocusPicture
from rlswaim.edition.printed_closures import final_design
from rlswaim.loops.station_maps import station_map
from rlswaim.rootlocus.adaptive_gains import default_axes
from rlswaim.rootlocus.open_loop import open_loop

matplotlib.use("agg")
LOOPS = loops()
WHO = ["rlswaim", "control"]


def timed(benchmark, group, who, work, rounds=9):
    benchmark.group, benchmark.name = group, who
    return benchmark.pedantic(work, rounds=rounds, warmup_rounds=1)


@pytest.mark.parametrize("count", [500, 2000])
@pytest.mark.parametrize("name", LOOPS)
@pytest.mark.parametrize("who", WHO)
def test_given_gains(benchmark, name, count, who):
    """The same gains for both; both return continuous branches."""
    loop, gains = LOOPS[name], np.logspace(-3, 3, count)
    usual = who == "control"
    found = timed(
        benchmark,
        f"{count} given gains: {name}",
        who,
        lambda: control.root_locus_map(loop, gains=gains) if usual else rl.root_locus(loop, gains),
        rounds=5,
    )
    assert len(found.gains) == count


@pytest.mark.parametrize("name", LOOPS)
@pytest.mark.parametrize("who", WHO)
def test_picture(benchmark, name, who):
    """Ours is true to a quarter pixel; control's default is not, and takes what it takes."""
    loop = LOOPS[name]
    usual = who == "control"
    found = timed(
        benchmark,
        f"picture: {name}",
        who,
        lambda: control.root_locus_map(loop) if usual else rl.root_locus(loop),
    )
    benchmark.extra_info["gains"] = len(found.gains)


@pytest.mark.parametrize("name", LOOPS)
@pytest.mark.parametrize("who", WHO)
def test_quarter_pixel(benchmark, name, who):
    """The same quality from both: python-control with as many gains as that takes it, 8192 at most."""
    loop = LOOPS[name]
    own = rl.root_locus(loop)
    count, work = own.gains.size, lambda: rl.root_locus(loop)
    if who == "control":
        span = own.gains[own.gains > 0][[0, -1]]
        exact, count = rl.root_locus(loop, np.geomspace(*span, 700)), 128
        while count < 8192 and strays(exact, even_gains(loop, span, count)) > 0.25:
            count *= 2
        work = lambda: control.root_locus_map(loop, gains=np.geomspace(*span, count))  # noqa: E731
    benchmark.extra_info["gains"] = count
    timed(benchmark, f"quarter pixel: {name}", who, work, rounds=3)


def even_gains(loop, span, count):
    return rl.root_locus(loop, np.geomspace(*span, count))  # the roots are control's, and come sooner


def strays(exact, drawn):
    """Return how far (pixels) drawn branches stray from the exact locus, each root beside its own gain."""
    view, worst = default_axes(exact.loop), 0.0
    for gain, roots in zip(exact.gains, exact.roots, strict=True):
        at = np.searchsorted(drawn.gains, gain)
        beside = slice(max(at - 2, 0), at + 2)
        worst = max(worst, off_the_polyline(roots, drawn.roots[beside], view))
    return worst


@pytest.mark.parametrize("who", WHO)
def test_redraw(benchmark, who):
    """One slider move in a kernel: compute the locus and draw it into the figure's pixels."""
    loop = LOOPS["Section IV, order 8"]
    figure = Figure(figsize=(8, 6), dpi=100)
    matplotlib.backends.backend_agg.FigureCanvasAgg(figure)
    ax = figure.subplots()
    left, right, bottom, top = default_axes(open_loop(loop))
    ax.set(xlim=(left, right), ylim=(bottom, top))
    picture = None if who == "control" else LocusPicture(ax, rl.root_locus(loop))

    def usual():
        figure.clear()
        control.root_locus_plot(loop, ax=figure.subplots())
        figure.canvas.draw()

    timed(
        benchmark,
        "figure redraw: Section IV",
        who,
        (lambda: picture.update(rl.root_locus(loop))) if picture else usual,
    )


@pytest.mark.parametrize("order", [5, 10, 20, 30])
@pytest.mark.parametrize("count", [None, 100, 1000], ids=["picture", "100", "1000"])
def test_growth(benchmark, order, count):
    """What a locus costs against its order and the number of its gains."""
    loop = random_loop(order)
    gains = None if count is None else np.logspace(-3, 3, count)
    name = f"{order} {'picture' if count is None else count}"
    found = timed(benchmark, "growth", name, lambda: rl.root_locus(loop, gains), rounds=3)
    benchmark.extra_info["gains"] = len(found.gains)


@pytest.mark.parametrize("side", [106, 211, 421])
def test_station_map(benchmark, side):
    """Largest real part of Section VII's closed loop over all pairs of stations."""
    design, kK_z = final_design()
    gains = {"K_A": 1.0, "K_C": 1.0, "K_R": 0.286, "kK_z": kK_z, "K_r": design.K_r, "b": design.b}
    stations = np.linspace(0, 420, side)

    def work():
        return station_map(rl.printed_equations(), stations, stations, **gains)

    found = timed(benchmark, "station map of Section VII", f"{side} x {side}", work, rounds=3)
    assert found.shape == (side, side)
    tracemalloc.start()
    work()
    benchmark.extra_info["memory_MB"] = tracemalloc.get_traced_memory()[1] / 1e6
    tracemalloc.stop()
