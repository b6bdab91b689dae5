"""Block diagrams of the four control systems, drawn with schemdraw on given axes.

The report's own drawings are lost in the source; these follow its equations.
Every summing point adds what enters from the left and subtracts what is fed back.
"""

from collections.abc import Sequence

import numpy as np
import schemdraw
from matplotlib.axes import Axes
from schemdraw import dsp, elements

Place = tuple[float, float]
Blocks = Sequence[tuple[str, float]]

ACTUATOR = (r"$\dfrac{K_C}{s+K_C}$", 1.9)
GYRO = ("$K_R s+1$", 1.8)
LOW_PASS, HIGH_PASS = ("low-pass", 2.3), ("high-pass", 2.3)


class _Diagram:
    """A row of blocks from left to right; feedback runs below it, or above it at a negative depth."""

    def __init__(self, ax: Axes) -> None:
        ax.set_axis_off()
        ax.set_aspect("equal")
        schemdraw.use("matplotlib")
        self.ax, self.drawing = ax, schemdraw.Drawing(canvas=ax, show=False)
        self.drawing.config(fontsize=10, unit=2, lw=1.2)

    def wire(self, label: str = "", length: float = 0.9) -> None:
        """Draw an arrow to the right."""
        self.drawing.add(dsp.Arrow(headwidth=0.15, headlength=0.2).right(length).label(label, ofst=0.12))

    def block(self, text: str, width: float, height: float = 1.1) -> dsp.Box:
        """Draw a block that is entered from the left."""
        box = self.drawing.add(dsp.Box(w=width, h=height).anchor("W").right().label(text))
        self.drawing.here = box.E
        return box

    def chain(self, *pieces: str | tuple[str, float]) -> None:
        """Draw wires (text alone) and blocks (text and width) one after the other."""
        for piece in pieces:
            if isinstance(piece, str):
                self.wire(piece)
            else:
                self.block(*piece)

    def junction(self) -> Place:
        """Draw a summing point with its signs, and return where feedback enters."""
        point = self.drawing.add(dsp.Circle(radius=0.25).anchor("W").right())
        x, y = point.W
        for dx, dy, sign in ((-0.2, 0.22, "+"), (0.45, -0.5, "-")):
            self.drawing.add(elements.Label().at((x + dx, y + dy)).label(f"${sign}$", fontsize=9))
        self.drawing.here = point.E
        return tuple(point.S)

    def dot(self) -> Place:
        """Mark a branching point and return it."""
        here = tuple(self.drawing.here)
        self.drawing.add(dsp.Dot(radius=0.07).at(here))
        self.drawing.here = here
        return here

    def back(
        self, start: Place, end: Place, depth: float, blocks: Blocks = (), label: str = "", tap: str = ""
    ) -> None:
        """Lead the signal ``tap`` from ``start`` to the left, through blocks, and as ``label`` to ``end``."""
        here, d = self.drawing.here, self.drawing
        x, y = start[0], start[1] - depth
        d.add(dsp.Line().at(start).to((x, y)))
        d.add(elements.Label().at((x + 0.25 + 0.025 * len(tap), start[1] - 0.55 * np.sign(depth))).label(tap))
        gap = (x - end[0] - sum(width for _, width in blocks)) / (len(blocks) + 1)
        for text, width in blocks:
            d.add(dsp.Arrow(headwidth=0.15, headlength=0.2).at((x, y)).to((x - gap, y)))
            x -= gap + width
            d.add(dsp.Box(w=width, h=1.1).anchor("W").at((x, y)).right().label(text))
        d.add(dsp.Line().at((end[0], y)).to((x, y)).label(label, loc="top", ofst=0.12))
        d.add(dsp.Arrow(headwidth=0.15, headlength=0.2).at((end[0], y)).to(end))
        d.here = here

    def done(self) -> Axes:
        """Put the drawing on the axes and return them."""
        self.drawing.draw(show=False)
        return self.ax


def draw_figure_6(ax: Axes) -> Axes:
    """Draw rate and attitude feedback to the thrust vector on ``ax`` [Figure 6, Eqs. 55-58]."""
    d = _Diagram(ax)
    d.wire(r"$\theta_C$")
    foot = d.junction()
    d.chain(r"$\theta_E$", ("$K_A$", 1.2), "", ACTUATOR, r"$\delta$", ("vehicle\nEq. (38)", 2.2))
    d.wire(r"$\theta,q_1,q_2$", 2.0)
    d.block(r"$\theta-\sigma_1 q_1-\sigma_2 q_2$", 4.0)
    d.wire(length=0.6)
    out = d.dot()
    d.wire(r"$\theta_i$")
    d.back(out, foot, 1.9, [GYRO], r"$\theta_F$")
    return d.done()


def draw_figure_7(ax: Axes) -> Axes:
    """Draw the unity feedback form of Figure 6 on ``ax`` [Figure 7, Eqs. 88-90]."""
    d = _Diagram(ax)
    d.chain(r"$\theta_C$", (r"$\dfrac{1/K_R}{s+1/K_R}$", 2.2), "")
    foot = d.junction()
    d.chain(
        r"$\delta_1$",
        (r"$\dfrac{K_A K_C K_R\,(s+1/K_R)}{s+K_C}$", 4.2),
        r"$\delta$",
        (r"$\theta_i/\delta$", 1.8),
    )
    d.wire(length=0.6)
    out = d.dot()
    d.wire(r"$\theta_i$")
    d.back(out, foot, 1.4)
    return d.done()


def _sensed_system(ax: Axes, sensors: Sequence[str]) -> Axes:
    """Draw linear sensors in inner loops, and the attitude loop around them [Figures 12, 17]."""
    d = _Diagram(ax)
    d.wire(r"$\theta_C$")
    outer = d.junction()
    d.chain("", ("$K_A$", 1.2), "")
    feet = []
    for _ in sensors:
        feet.append(d.junction())
        d.wire(length=0.7)
    d.block(*ACTUATOR)
    d.wire(r"$\delta$", 0.7)
    d.block("vehicle\nEq. (38)", 2.2)
    taps = []
    for _ in (*sensors, "angle"):
        d.wire(length=1.1)
        taps.append(d.dot())
    depth = 1.9
    for name, tap, foot in zip(sensors[::-1], taps[:-1], feet[::-1], strict=True):
        d.back(
            tap, foot, depth, [(f"$K_{{z{name}}}(s+1)$", 2.3), HIGH_PASS], rf"$\bar{{z}}{name}$", f"$z{name}$"
        )
        depth += 1.6
    d.wire(r"$\theta$")
    d.back(taps[-1], outer, depth, [GYRO, LOW_PASS], r"$\bar{\theta}_i$", r"$\theta_i$")
    return d.done()


def _unity_system(ax: Axes, blocks: Blocks, signals: Sequence[str], source: str) -> Axes:
    """Draw nested unity feedback loops, the innermost around the first block [Figures 14, 18]."""
    d = _Diagram(ax)
    d.wire(source, 1.4)
    feet = []
    for _ in blocks:
        feet.append(d.junction())
        d.wire(length=0.7)
    taps = []
    for i, (block, signal) in enumerate(zip(blocks, signals, strict=True)):
        if i:
            d.wire(length=0.5)
        d.block(*block)
        d.wire(signal, 1.1)
        taps.append(d.dot())
    for i, (tap, foot) in enumerate(zip(taps, feet[::-1], strict=True)):
        d.back(tap, foot, 1.3 + 0.8 * i)
    return d.done()


def draw_figure_12(ax: Axes) -> Axes:
    """Draw one linear sensor in an inner loop on ``ax`` [Figure 12]."""
    return _sensed_system(ax, [""])


def draw_figure_13(ax: Axes) -> Axes:
    """Draw Figure 12 on ``ax`` with its feedback in two transfer functions [Figure 13, Eqs. 98-102]."""
    d = _Diagram(ax)
    d.wire(r"$\theta_C$")
    outer = d.junction()
    d.chain("", ("$K_A$", 1.2), "")
    inner = d.junction()
    d.chain(r"$\delta_2$", ACTUATOR)
    d.wire(length=0.8)
    tap = d.dot()
    d.chain(r"$\delta$", (r"$\theta_i/\delta$", 1.8))
    d.wire(length=0.8)
    out = d.dot()
    d.wire(r"$\theta_i$")
    d.back(tap, inner, 1.5, [(r"$\bar{z}/\delta$", 1.6)], r"$\bar{z}$")
    d.back(out, outer, 3.1, [(r"$\bar{\theta}_i/\theta_i$", 1.8)], r"$\bar{\theta}_i$")
    return d.done()


def draw_figure_14(ax: Axes) -> Axes:
    """Draw Figure 13 as two nested unity feedback loops on ``ax`` [Figure 14, Eqs. 103-110]."""
    blocks = [
        (r"$\dfrac{K_C}{s+K_C}\cdot\dfrac{\bar{z}}{\delta}$", 3.0),
        (r"$K_A\dfrac{\bar{\theta}_i}{\bar{z}}$", 2.3),
    ]
    return _unity_system(ax, blocks, [r"$\bar{z}$", r"$K_A\bar{\theta}_i$"], r"$K_A\theta_C$")


def draw_figure_17(ax: Axes) -> Axes:
    """Draw two linear sensors in inner loops on ``ax`` [Figure 17]."""
    return _sensed_system(ax, ["_b", "_a"])


def draw_figure_18(ax: Axes) -> Axes:
    """Draw Figure 17 as three nested unity feedback loops on ``ax`` [Figure 18, Eqs. 112-114]."""
    blocks = [
        (r"$\dfrac{K_C}{s+K_C}\cdot\dfrac{\bar{z}_1}{\delta}$", 3.0),
        (r"$\dfrac{\bar{z}_2}{\bar{z}_1}$", 1.4),
        (r"$K_A\dfrac{\bar{\theta}_i}{\bar{z}_2}$", 2.3),
    ]
    return _unity_system(
        ax, blocks, [r"$\bar{z}_1$", r"$\bar{z}_2$", r"$K_A\bar{\theta}_i$"], r"$K_A\theta_C$"
    )


def draw_figure_21(ax: Axes) -> Axes:
    """Draw thrust vector and reaction jet, each with its own sensor on ``ax`` [Figure 21, Eqs. 120-128]."""
    d = _Diagram(ax)
    d.wire(r"$\theta_C$")
    foot = d.junction()
    d.chain("", ("$K_A$", 1.2), "", ACTUATOR, r"$\delta$")
    vehicle = d.block("vehicle\nEq. (125)", 2.2)
    d.wire(length=7.6)
    tap = d.dot()
    d.wire(r"$\theta$", 1.6)
    jet = [("$-K_z(s+b)$", 2.2), HIGH_PASS, (r"$\dfrac{K_r}{s+K_r}$", 1.8)]
    d.back(tap, tuple(vehicle.N), -1.9, jet, r"$\delta_r$", "$z$")
    d.back(tap, foot, 1.7, [GYRO, LOW_PASS], r"$\bar{\theta}_i$", r"$\theta_i$")
    return d.done()


def draw_figure_22(ax: Axes) -> Axes:
    """Draw Figure 21 with unity feedback of the angle on ``ax`` [Figure 22, Eqs. 126-129]."""
    d = _Diagram(ax)
    d.chain(r"$\theta_C$", (r"$\dfrac{1}{K_R(s+1/K_R)}$", 2.6), "")
    foot = d.junction()
    d.chain("", ("$G_{21}$", 1.2), r"$\delta$")
    vehicle = d.block("vehicle\nEq. (125)", 2.2)
    d.wire(length=4.6)
    tap = d.dot()
    d.wire(length=1.6)
    d.back(tap, tuple(vehicle.N), -1.5, [("$-G_{12}q_1-G_{14}q_2$", 3.4)], r"$\delta_r$", r"$q_1, q_2$")
    d.back(tap, foot, 1.3, tap=r"$\theta$")
    return d.done()


def draw_figure_23(ax: Axes) -> Axes:
    """Draw the three closures on ``ax``, each with unity feedback [Figure 23, Eq. 130]."""
    d = _Diagram(ax)
    numerators = r"G_{1%d}\dfrac{\theta}{\delta_r}\dfrac{A_{q_%d}N_{q_%d}}{A_\theta N_\theta}"
    texts = (
        r"$G_{12}\dfrac{q_1}{\delta_r}+G_{14}\dfrac{q_2}{\delta_r}$",
        rf"$\dfrac{{-{numerators % (2, 1, 1)}-{numerators % (4, 2, 2)}}}{{1+\mathrm{{closure\ 1}}}}$",
        r"$G_{21}\dfrac{\theta}{\delta}\,\left[1+\mathrm{closure\ 2}\right]$",
    )
    for i, text in enumerate(texts):
        d.drawing.here = (0, -4.0 * i)
        d.wire(f"closure {i + 1}", 3.0)
        foot = d.junction()
        d.wire()
        d.block(text, 8.4, 2.3)
        d.wire(length=0.6)
        out = d.dot()
        d.wire()
        d.back(out, foot, 1.8)
    return d.done()
