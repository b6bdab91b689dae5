"""Figures show what was computed: data on the axes, units, labels, the same file at every run."""

import io

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
from rlswaim.figures import loci, stations
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
