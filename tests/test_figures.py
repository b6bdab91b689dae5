"""Figures show what was computed: data on the axes, units, labels, the same file at every run."""

import io
from itertools import combinations

import control
import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import diagrams
import rlswaim as rl
from pages import use_book_style
from redraw import LocusPicture
from rlswaim.edition.designs import instrument_stations
from rlswaim.figures import loci, side_view, stations
from rlswaim.loops import named_branches
from rlswaim.loops import transfer_functions as tf
from rlswaim.loops.transfer_functions import theta_loop

EQS = rl.printed_equations()
DIAGRAMS = (6, 7, 12, 13, 14, 17, 18, 21, 22, 23)


@pytest.fixture
def ax():
    with mpl.rc_context():
        fig, axes = plt.subplots()
        yield axes
        plt.close(fig)


@pytest.fixture(scope="module")
def closure():
    return named_branches.named_locus(
        tf.theta_loop(EQS, 10, 0.618, 60), 1.8, named_branches.open_loop_parts(EQS, 10)
    )


def points(line):
    return np.asarray(line.get_xdata(), float) + 1j * np.asarray(line.get_ydata(), float)


def labelled(ax, label):
    return next(line for line in ax.lines if line.get_label() == label)


def test_a_locus_draws_every_branch_with_poles_and_zeros(ax, closure):
    loci.draw_root_locus(ax, closure.locus, (-11, 4, -1, 12), closure.parts)
    drawn = [points(line) for line in ax.lines]
    for branch in closure.locus.roots.T:
        assert any(d.shape == branch.shape and np.allclose(d, branch) for d in drawn)
    assert points(labelled(ax, "open-loop poles")) == pytest.approx(closure.locus.poles)
    assert points(labelled(ax, "open-loop zeros")) == pytest.approx(closure.locus.zeros)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("real part (1/s)", "imaginary part (1/s)")


def test_parts_are_told_apart_without_color(ax, closure):
    loci.draw_root_locus(ax, closure.locus, (-11, 4, -1, 12), closure.parts)
    styles = {name: labelled(ax, f"from the {loci.PART_NAMES.get(name, name)}") for name in closure.parts}
    assert len({line.get_linestyle() for line in styles.values()}) == len(styles)
    assert len({line.get_color() for line in styles.values()}) == len(styles)


def test_an_arrow_points_to_rising_gain(ax, closure):
    loci.draw_root_locus(ax, closure.locus, (-11, 4, -1, 12), closure.parts)
    column = max(closure.parts["mode 2"], key=lambda j: closure.locus.roots[0, j].imag)
    branch = closure.locus.roots[:, column]
    arrows = [complex(*a.xy) - complex(*a.xyann) for a in ax.texts if isinstance(a, mpl.text.Annotation)]
    heads = [complex(*a.xy) for a in ax.texts if isinstance(a, mpl.text.Annotation)]
    nearest = int(np.argmin([np.abs(branch - head).min() for head in heads]))
    i = int(np.abs(branch - heads[nearest]).argmin())
    assert np.real(np.conj(arrows[nearest]) * (branch[i] - branch[i - 1])) > 0


def test_closed_loop_poles_and_printed_roots_are_marked_where_they_are(ax, closure):
    loci.draw_named_locus(ax, closure, (-11, 4, -1, 12), "closed loop")
    loci.draw_printed_roots(ax, [-1 + 1.73j, 1.375])
    expected = rl.rate_attitude(EQS, K_A=1.8, K_C=10, K_R=0.618, gyro=60).poles()
    assert np.sort_complex(points(labelled(ax, "closed loop"))) == pytest.approx(
        np.sort_complex(expected), abs=1e-6
    )
    assert set(points(labelled(ax, "printed in the report"))) == {-1 + 1.73j, -1 - 1.73j, 1.375}


def test_the_zeros_of_all_stations_are_drawn_once(ax):
    places = np.arange(0.0, 421.0, 30.0)
    zeros = tf.sensor_zeros(EQS, places)
    stations.draw_sensor_zeros(ax, places, zeros, {140.0: [3.2 + 2.625j]})
    drawn = sum(line.get_xdata().size for line in ax.lines[:3])
    assert drawn == np.count_nonzero(zeros.imag >= 0)
    assert ax.get_xlabel().endswith("(ft)")


@pytest.mark.parametrize("number", DIAGRAMS)
def test_a_diagram_draws_on_the_given_axes_the_same_each_time(number):
    files = []
    with mpl.rc_context({"svg.hashsalt": "rlswaim", "svg.fonttype": "none"}):
        for _ in range(2):
            fig, axes = plt.subplots()
            assert getattr(diagrams, f"draw_figure_{number}")(axes) is axes
            stream = io.StringIO()
            fig.savefig(stream, format="svg", metadata={"Date": None})
            plt.close(fig)
            files.append(stream.getvalue())
    assert files[0] == files[1]
    assert files[0].count("<path") > 10


@pytest.mark.parametrize(
    ("number", "sums"),
    [(6, 1), (7, 1), (12, 2), (13, 2), (14, 2), (17, 3), (18, 3), (21, 1), (22, 1), (23, 3)],
)
def test_each_summing_point_has_one_plus_and_one_minus(ax, number, sums):
    getattr(diagrams, f"draw_figure_{number}")(ax)
    signs = [text.get_text() for text in ax.texts]
    assert (signs.count("$+$"), signs.count("$-$")) == (sums, sums)


def test_the_book_style_makes_repeatable_vector_figures():
    with mpl.rc_context():
        use_book_style()
        assert mpl.rcParams["svg.hashsalt"]


def test_a_redrawn_locus_has_the_pixels_of_a_new_one():
    """`LocusPicture` leaves nothing of the last locus, and draws the next one where it belongs."""
    eqs = rl.printed_equations()
    first, second = (rl.root_locus(theta_loop(eqs, 10, K_R, 60)) for K_R in (0.618, 0.3))

    def picture(locus):
        canvas = FigureCanvasAgg(Figure(figsize=(4, 3)))
        return LocusPicture(canvas.figure.add_subplot(xlim=(-12, 4), ylim=(-13, 13)), locus)

    def pixels(drawn):
        return np.asarray(drawn.canvas.buffer_rgba()).copy()

    redrawn = picture(first)
    before = pixels(redrawn)
    redrawn.update(second)
    assert not np.array_equal(pixels(redrawn), before)
    assert np.array_equal(pixels(redrawn), pixels(picture(second)))
    with pytest.raises(ValueError, match="LocusPicture: got 1 branches, wanted 8"):
        redrawn.update(rl.root_locus(control.tf([1], [1, 1])))


def test_ill_determined_roots_are_marked(ax):
    """Only the double root of 1/(s (s + 2)) at k = 1 is marked, where it lies."""
    locus = rl.root_locus(control.tf([1], [1, 2, 0]), [0.5, 1.0, 3.0])
    marked = points(labelled(loci.draw_ill_determined(ax, locus), "ill-determined"))
    assert marked == pytest.approx([-1, -1], abs=1e-6)


@pytest.fixture
def vehicle():
    """Figure 1 as chapter I draws it, its figure laid out."""
    with mpl.rc_context():
        use_book_style()
        fig, (above, below) = plt.subplots(
            2, 1, figsize=(7.0, 5.6), height_ratios=(5, 2), layout="constrained"
        )
        side_view.draw_side_view(above, rl.swaim_booster(), instrument_stations())
        side_view.draw_masses(below, rl.swaim_booster())
        fig.canvas.draw()
        yield above, below
        plt.close(fig)


def boxes(axes):
    """Return the texts of axes that show something, and the boxes that they cover."""
    shown = [text for text in axes.texts if text.get_text()]
    return [text.get_text() for text in shown], [text.get_window_extent() for text in shown]


def test_the_labels_of_the_vehicle_overlap_nothing(vehicle):
    above, below = vehicle
    names, covered = boxes(above)
    assert len(names) > 20
    assert boxes(below) == ([], [])
    pairs = [
        (names[i], names[j]) for i, j in combinations(range(len(names)), 2) if covered[i].overlaps(covered[j])
    ]
    assert pairs == []
    page = above.figure.bbox
    assert [
        name for name, box in zip(names, covered, strict=True) if box.x0 < page.x0 or box.x1 > page.x1
    ] == []


def test_no_mark_or_line_of_the_vehicle_crosses_a_label(vehicle):
    axes, crossed = vehicle[0], []
    solid = [line for line in axes.lines if line.get_linestyle() == "-"]
    marks = [line for line in axes.lines if line.get_marker() != "None"]
    assert len(solid) > 10
    assert len(marks) == 5
    for name, box in zip(*boxes(axes), strict=True):
        paths = [line.get_transform().transform_path(line.get_path()) for line in solid]
        points = [point for line in marks for point in line.get_transform().transform(line.get_xydata())]
        touched = [np.hypot(*(np.clip(point, box.min, box.max) - point)) < 3 for point in points]
        crossed += [name] * (any(path.intersects_bbox(box) for path in paths) or any(touched))
    assert crossed == []


def test_the_vehicle_is_drawn_where_its_data_say(vehicle):
    above, below = vehicle
    booster = rl.swaim_booster()
    marks = {line.get_marker(): list(line.get_xdata()) for line in above.lines if line.get_marker() != "None"}
    assert marks["^"] == [60, 304, 400]
    assert marks["D"] == [20, 39, 140, 300, 420]
    assert marks["v"] == [140]
    assert marks["P"] == [booster.l_CG]
    assert marks["o"] == [booster.thrust_station]
    forces = [t.xy[0] for t in above.texts if isinstance(t, mpl.text.Annotation) and t.xy[1] == 52]
    assert forces == [surface.station for surface in booster.surfaces]
    assert above.get_xlim() == below.get_xlim()
    assert [bar.get_height() * 1000 for bar in below.patches] == pytest.approx(booster.masses)
    assert [bar.get_x() + bar.get_width() / 2 for bar in below.patches] == pytest.approx(booster.stations)
    assert below.get_ylabel() == "mass (1000 slug)"
