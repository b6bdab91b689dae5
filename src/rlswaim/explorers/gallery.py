"""Loops that other tools got wrong, from their bug reports: what went wrong there, and what is right.

Each right value is computed by the engine of `rl.root_locus` when it is asked for.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import control
import numpy as np

from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.rootlocus.open_loop import System


@dataclass(frozen=True)
class Case:
    """One loop of the gallery.

    Attributes
    ----------
    name : str
    thread : str
        Repository and number of the public report; empty if it has none.
    system : StateSpace, TransferFunction or factors
    wrong : str
        What was seen elsewhere.
    right : callable
        Of the locus: what is right, in words with computed numbers.
    k : float
        The gain to look at.
    """

    name: str
    thread: str
    system: System
    wrong: str
    right: Callable[[RootLocus], str]
    k: float = 1.0

    def line(self) -> str:
        """Return the one line: what goes wrong elsewhere, and what is right."""
        source = f" ({self.thread})" if self.thread else ""
        return f"Elsewhere{source}: {self.wrong}. Here: {self.right(root_locus(self.system))}."


def _crossings(locus: RootLocus) -> str:
    border = "the unit circle" if locus.discrete else "the imaginary axis"
    unit = "angle" if locus.discrete else "ω ="
    rows = [f"k = {c.gain:.4g} ({unit} {c.omega:.4g})" for c in locus.crossings if c.gain > 0 and c.omega]
    return f"{border} is crossed at {' and '.join(rows)}"


def _break_aways(locus: RootLocus) -> str:
    found = [b for b in locus.break_aways if b.gain]
    if not found:
        return "no two branches meet at any gain"
    if len(found) > 3:
        gains = [b.gain for b in found]
        return f"{len(found)} break-aways, at gains from {min(gains):.3g} to {max(gains):.3g}"
    rows = [f"k = {b.gain:.4g} (s = {b.point:.4g})".replace("+0j", "") for b in found]
    return f"branches meet at {' and '.join(rows)} alone"


def _real_poles(locus: RootLocus) -> str:
    poles = locus.poles
    apart = "all real" if not poles.imag.any() else "some complex"
    return f"{poles.size} poles, {apart}, from {poles.real.min():.4g} to {poles.real.max():.4g}"


def _zeros(locus: RootLocus) -> str:
    return f"{locus.poles.size} poles and {locus.zeros.size or 'no'} zeros"


def _rightmost(locus: RootLocus) -> str:
    return f"all {locus.poles.size} poles lie left of {locus.poles.real.max():.5g} 1/s"


def _double_pole(locus: RootLocus) -> str:
    start = [b.point for b in locus.break_aways if b.gain == 0]
    return f"the double pole at {start[0].real:g} leaves the axis at right angles; for k > 0 none goes left"


def _diagonal(values: np.ndarray, first: bool = False) -> control.StateSpace:
    n = values.size
    B = np.eye(n)[:, :1] if first else np.ones((n, 1))
    return control.ss(np.diag(values), B, np.ones((1, n)), 0)


def _motor() -> control.StateSpace:
    Li, k, Rm, Lm = 1e-7, 1e-3, 1.0, 1e-3
    A = [[0, 1, 0], [0, 0, k / Li], [0, -k / Lm, -Rm / Lm]]
    return control.ss(A, [[0], [0], [1 / Lm]], [[1, 0, 0]], 0)


SIXTEEN = (
    "9.94004350e-13 2.67602795e-11 2.31058712e-10 1.15119493e-09 5.04635153e-09 1.34066064e-08 "
    "2.11938725e-08 2.39940325e-08 2.05897777e-08 1.17092854e-08 4.71236875e-09 "
    "1.19497537e-09 1.90815347e-10 1.00655454e-11 1.47388887e-13 8.40314881e-16 1.67195685e-18",
    "9.43513863e-11 6.05312352e-08 7.92752628e-07 5.23764693e-06 1.82502556e-05 1.24355899e-05 "
    "8.68206174e-06 2.73818482e-06 4.29133144e-07 3.85554417e-08 1.62631575e-09 8.41098151e-12 "
    "9.85278302e-15 4.07646645e-18 5.55496497e-22 3.06560494e-26 5.98908988e-31",
)
"""Numerator and denominator of the loop of python-control#935, highest power first."""


def _conversions() -> tuple[Case, ...]:
    """Return loops that were lost on the way to another form, or drawn wrong after it."""
    pendulum = control.ss(
        [[0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1], [0, 0, 5, 0]], [[0], [1], [0], [-2]], [[1, 0, 0, 0]], 0
    )
    return (
        Case(
            "Pendulum",
            "python-control/python-control#715",
            pendulum,
            "a branch was drawn on the axis left of the double pole at 0",
            _double_pole,
            -1.0,
        ),
        Case(
            "Motor",
            "python-control/python-control#1068",
            _motor(),
            "conversion added two zeros at 120 ± 6.6·10⁹ j",
            _zeros,
            0.5,
        ),
        Case(
            "Diagonal of 1/n",
            "scipy/scipy#5914",
            _diagonal(1 / np.arange(1.0, 21.0), first=True),
            "conversion to poles and zeros made complex poles of real ones",
            _real_poles,
        ),
        Case(
            "Order 16",
            "python-control/python-control#935",
            control.tf(*([float(c) for c in part.split()] for part in SIXTEEN)),
            "conversion to a state space made this stable loop unstable",
            _rightmost,
        ),
    )


def _plots() -> tuple[Case, ...]:
    """Return loops whose pictures or lists were wrong."""
    four = np.polymul(np.polymul([1, 0], [1, 5]), np.polymul([1, 15], [1, 20]))
    return (
        Case(
            "Gain at the axis",
            "python-control/python-control#306",
            control.tf([1], [1, 2, 2, 0]),
            "the plot told a gain of about 0.7 where the locus crosses the axis",
            _crossings,
        ),
        Case(
            "No break-in",
            "JuliaControl/ControlSystems.jl#231",
            control.tf([1, 9], [1, 4, 11, 0]),
            "a break-in was drawn where no two poles or zeros are neighbors on the locus",
            _break_aways,
        ),
        Case(
            "Four poles",
            "sympy/sympy#25251",
            control.tf([1, 7], four),
            "the thread asks which way to find the gain of the break-away, and by a discriminant gets 308",
            _break_aways,
            308.0,
        ),
    )


def _kinds() -> tuple[Case, ...]:
    """Return kinds of loops that are easy to get wrong."""
    return (
        Case(
            "Twenty states",
            "",
            _diagonal(-np.arange(1.0, 21.0)),
            "poles through the characteristic polynomial are off by 0.25",
            _real_poles,
        ),
        Case(
            "Twenty poles",
            "",
            ([], [-float(i) for i in range(1, 21)], 1.0),
            "a tolerance takes neighboring poles for one, and their break-aways get the gain 0",
            _break_aways,
            1e15,
        ),
        Case(
            "Common factor",
            "",
            control.tf([1, 0], [1, 3, 2, 0]),
            "the cancelled root at 0 counts as two break-aways",
            _break_aways,
            0.25,
        ),
        Case(
            "Discrete",
            "",
            control.tf([1], [1, -1.5, 0.5], True),
            "crossings of the imaginary axis are told, which says nothing in z",
            _crossings,
            0.25,
        ),
    )


def gallery() -> tuple[Case, ...]:
    """Return the loops, public reports first."""
    return (*_plots(), *_conversions(), *_kinds())


def presets(text: Callable[[System], str]) -> list[dict[str, Any]]:
    """Return the gallery as the view's presets.

    Parameters
    ----------
    text : callable
        Of a system: the text that the view reads.

    Returns
    -------
    list of dict
    """
    return [
        {
            "name": c.name,
            "label": c.line(),
            "values": {"loop": text(c.system), "k": c.k},
            "printed": [],
            "note": "",
        }
        for c in gallery()
    ]
