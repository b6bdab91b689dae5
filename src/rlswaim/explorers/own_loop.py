"""The live view of any single loop: a workbench for one's own zeros, poles and gain.

The view reads the loop from a text; the one that it opens with comes from the engine of `rl.root_locus`, so
that a state space keeps its eigenvalues.
"""

from dataclasses import dataclass
from typing import Any

import control
import ipywidgets as widgets
import numpy as np
import traitlets
from matplotlib.axes import Axes
from numpy.typing import NDArray
from scipy.signal import ZerosPolesGain

from rlswaim.explorers.gallery import presets
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import Parameter
from rlswaim.explorers.still import Drawing
from rlswaim.figures.loci import draw_poles, draw_root_locus
from rlswaim.figures.style import COLORS
from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.rootlocus.open_loop import OpenLoop, System, open_loop
from rlswaim.source import checks

HIGHEST = 30
"""The largest order that the view takes."""
LARGEST = 1e30
"""The largest size of a gain that the view takes."""


@dataclass(frozen=True)
class TextParameter(Parameter):
    """A parameter that is a text, typed in the view itself."""

    def controls(self, view: Any) -> widgets.Widget:
        """Return nothing that is seen."""
        return widgets.VBox([], layout={"display": "none"})


def _text(name: str, value: object, where: str) -> str:
    checks.instance(name, value, str, where)
    return str(value)


def _gain(name: str, value: object, where: str) -> float:
    gain = checks.real(name, value, where)
    if abs(gain) > LARGEST:
        raise ValueError(f"{name} in {where}: got {gain:g}, wanted at most {LARGEST:g} in size")
    return gain


def _numbers(values: NDArray) -> str:
    """Return numbers as a text that gives them back, complex ones with j."""
    return "[" + ", ".join(repr(v if v.imag else v.real).strip("()") for v in values.tolist()) + "]"


def _rows(matrix: NDArray) -> str:
    return "[" + ", ".join(_numbers(row) for row in matrix) + "]"


def _factor_lines(zeros: Any, poles: Any, gain: Any) -> list[str]:
    named = {"zeros": zeros, "poles": poles}
    return [*(f"{name} = {_numbers(np.asarray(x))}" for name, x in named.items()), f"gain = {float(gain)!r}"]


def loop_text(system: System) -> str:
    """Return a loop as the text that the view reads, from which it comes back exactly.

    Parameters
    ----------
    system : StateSpace, TransferFunction, ZerosPolesGain, (A, B, C) or (zeros, poles, gain)

    Returns
    -------
    str
    """
    if isinstance(system, control.TransferFunction):
        num, den = (np.asarray(part[0][0], float) for part in (system.num, system.den))
        lines = [f"num = {_numbers(num)}", f"den = {_numbers(den)}"]
    elif isinstance(system, control.StateSpace):
        lines = [f"{name} = {_rows(np.asarray(getattr(system, name), float))}" for name in "ABCD"]
    elif isinstance(system, ZerosPolesGain):
        lines = _factor_lines(system.zeros, system.poles, system.gain)
    elif np.ndim(system[0]) == 1:
        lines = _factor_lines(*system)
    else:
        lines = [
            f"{name} = {_rows(np.asarray(part, float))}" for name, part in zip("ABC", system, strict=True)
        ]
        lines.append("D = [[0.0]]")
    dt = getattr(system, "dt", 0)
    return "\n".join([*lines, f"dt = {dt if dt is True else float(dt or 0)!r}"])


def known_roots(loop: OpenLoop, exact: bool) -> dict[str, Any]:
    """Return what the engine knows of a loop, as the view takes it.

    Parameters
    ----------
    loop : OpenLoop
    exact : bool
        Whether its poles and zeros are known better than the coefficients tell.

    Returns
    -------
    dict
        Coefficients, constant term first, over the denominator's leading one; poles and zeros, common ones
        equal in both.
    """
    poles, zeros = loop.poles, loop.zeros.copy()
    gone_poles, gone = loop.common
    left = poles[gone_poles]
    for i in np.flatnonzero(gone):
        at = int(np.abs(left - zeros[i]).argmin())
        zeros[i], left = left[at], np.delete(left, at)
    lead = loop.denominator[-1]
    N = np.zeros(loop.denominator.size)
    N[: loop.numerator.size] = loop.numerator / lead
    return {
        "D": (loop.denominator / lead).tolist(),
        "N": N.tolist(),
        "poles": {"x": poles.real.tolist(), "y": poles.imag.tolist()},
        "zeros": {"x": zeros.real.tolist(), "y": zeros.imag.tolist()},
        "gain": float(loop.gain),
        "exact": exact,
        "dt": loop.dt if loop.dt is True else float(loop.dt or 0),
    }


def parameters(text: str, loop: OpenLoop) -> tuple[Parameter, ...]:
    """Return the loop's text and the slider of its gain, whose decades reach the gains of note.

    Parameters
    ----------
    text : str
    loop : OpenLoop
    """
    size = np.geomspace(1e-4, 1e6, 201)
    rounded = [float(f"{place:.3g}") for place in [*-size, 0.0, *size]]
    return (
        TextParameter("loop", "Loop", "", "the open loop", (text,), _text),
        Parameter("k", r"\(k\)", "", "k, gain of the loop", tuple(np.unique(rounded).tolist()), _gain),
    )


class OwnLoop(LiveView):
    """One's own loop under a slider of its gain, with a field in which another one can be typed.

    Parameters
    ----------
    system : StateSpace, TransferFunction, ZerosPolesGain, (A, B, C) or (zeros, poles, gain)
    k : float
        Where the gain starts.

    Attributes
    ----------
    loop : str
        The text of the loop that is shown, as it was given or typed.
    k : float
        The gain.
    """

    view, system = "own-loop", "own-loop"
    magnify = traitlets.Float(1.0, help="how much the inset enlarges the origin; 1: no inset").tag(sync=True)

    def __init__(self, system: System, k: float = 1.0) -> None:
        where = f"{self.system} explorer"
        self._system, found = system, open_loop(system)
        if found.poles.size > HIGHEST:
            raise ValueError(
                f"order of the loop in {where}: got {found.poles.size}, wanted at most {HIGHEST}"
            )
        text = loop_text(system)
        known = known_roots(found, exact=not isinstance(system, control.TransferFunction))
        payload: dict[str, Any] = {
            "known": {text: known},
            "colors": [
                COLORS[name] for name in ("rigid", "mode 1", "mode 2", "actuator", "jet", "corrected")
            ],
            "designs": "Gallery",
            "presets": presets(loop_text),
            "shapes": {},
            "choice": None,
            "actuators": [],
            "locus_gains": ["k"],
            "loci": [],
            "maps": [],
            "vehicle": None,
            "numerators": {"r": {}},
            "excitations": [
                {"input": "r", "kind": "step", "amplitude": 1, "text": "unit step of the reference"}
            ],
            "units": {"y": ""},
        }
        super().__init__(parameters(text, found), payload, {"loop": text, "k": k})

    def locus(self) -> RootLocus:
        """Return the library's root locus of the loop that the view opened with."""
        return root_locus(self._system)

    def poles(self) -> NDArray:
        """Return the closed-loop poles at the gain, of the loop that the view opened with."""
        return root_locus(self._system, gains=[float(self.k)]).roots[0]

    def draw(self, ax: Axes) -> Axes:
        """Draw the root locus and the closed-loop poles."""
        poles, locus = self.poles(), self.locus()
        seen = np.hstack([locus.poles, poles, [1, -1, 1j] if locus.discrete else []])
        reach = 1.3 * max(float(np.abs(np.hstack([seen.real, seen.imag])).max()), 1e-6)
        draw_root_locus(ax, locus, (-reach, reach, -reach, reach))
        draw_poles(ax, poles, f"poles at k = {self.k:g}").legend(loc="upper left", fontsize=7)
        return ax

    def drawings(self) -> list[Drawing]:
        """Return `draw` alone."""
        return [self.draw]


def explore(system: System, k: float = 1.0) -> OwnLoop:
    """Show any single loop on a live view: root locus, poles, margins and step response under its gain.

    Parameters
    ----------
    system : StateSpace, TransferFunction, ZerosPolesGain, (A, B, C) or (zeros, poles, gain)
        The open loop G(s), or G(z) where its ``dt`` is a sampling time (s) or True; negative feedback,
        1 + k G = 0.  At most of order 30.
    k : float
        The gain at which the view opens.

    Returns
    -------
    OwnLoop
        A widget that displays itself; ``k`` can be read and set.

    Raises
    ------
    TypeError
        If the system is no LTI system, or not real, or ``k`` is no number.
    ValueError
        If it has more than one input or output, no poles, a zero numerator, is improper, not finite or of an
        order above 30, or ``k`` is not finite.
    """
    return OwnLoop(system, k)
