"""Stability margins of a loop with one input and one output: gain, phase, delay and disk, by named mode.

All of them are read from L(j omega) on a grid that is dense about every pole and zero, and each
crossing is then solved for.  The loop closes with 1 + L = 0.
"""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, minimize_scalar

from rlswaim.source import checks


class GainMargin(NamedTuple):
    """The factor by which the loop gain reaches the border, in dB: below 0 if the gain must fall."""

    dB: float
    omega: float


class PhaseMargin(NamedTuple):
    """The phase (deg, -180 to 180) and the delay (s) that bring the loop to the border at one frequency."""

    deg: float
    delay: float
    omega: float


class Margins(NamedTuple):
    """Every crossing of a loop, and the size of the disk that it leaves free about -1."""

    gain: tuple[GainMargin, ...]
    phase: tuple[PhaseMargin, ...]
    disk: float
    """Largest alpha for which gain and phase may vary together in the symmetric disk; 0 at the border."""
    disk_omega: float
    peak_sensitivity: float

    @property
    def disk_gain_dB(self) -> float:
        """Factor (dB) by which the gain may rise or fall, whatever the phase does within the disk."""
        half = min(self.disk, 2.0) / 2
        return float("inf") if half >= 1 else float(20 * np.log10((1 + half) / (1 - half)))

    @property
    def disk_phase_deg(self) -> float:
        """Phase (deg) by which the loop may turn either way within the disk."""
        return float(np.degrees(2 * np.arctan(self.disk / 2)))


def frequency_response(system: control.StateSpace, omega: NDArray) -> NDArray:
    """Return a system's response over frequency, all frequencies at once.

    Parameters
    ----------
    system : control.StateSpace
    omega : ndarray, shape (n,)
        In rad/s.

    Returns
    -------
    ndarray, shape (n, outputs, inputs), complex
    """
    shifted = 1j * omega[:, None, None] * np.eye(system.nstates) - system.A
    inputs = np.broadcast_to(system.B, (omega.size, *system.B.shape))
    return system.C @ np.linalg.solve(shifted, inputs) + system.D


def _frequencies(loop: control.StateSpace, points: int) -> NDArray:
    """Return frequencies (rad/s) over all poles and zeros, dense about those near the axis."""
    marks = np.concatenate([loop.poles(), loop.zeros()])
    sizes = np.abs(marks)
    sizes = sizes[(sizes > 1e-9) & (sizes < 1e6)]
    ends = (sizes.min() / 100, sizes.max() * 100) if sizes.size else (1e-2, 1e2)
    grids = [np.geomspace(ends[0], ends[1], points)]
    for mark in marks[(marks.imag > 0) & (np.abs(marks) < 1e6)]:
        width = max(abs(mark.real), 1e-6 * abs(mark))
        grids.append(mark.imag + width * np.sinh(np.linspace(-6, 6, 121)))
    joined = np.unique(np.concatenate(grids))
    return joined[(joined >= ends[0]) & (joined <= ends[1])]


def _crossings(values: NDArray, at: NDArray, function: Callable[[float], float]) -> list[float]:
    """Return where a real function changes its sign, given its values at some places."""
    change = np.flatnonzero(np.signbit(values[:-1]) != np.signbit(values[1:]))
    return [float(brentq(function, at[i], at[i + 1], xtol=1e-14, rtol=1e-13)) for i in change]


def margins(loop: control.StateSpace, points: int = 2000) -> Margins:
    """Return all margins of a loop.

    Parameters
    ----------
    loop : control.StateSpace
        Open loop L(s) with one input and one output, for negative feedback.
    points : int
        Of the grid that crossings are looked for on.

    Returns
    -------
    Margins
        Crossings in the order of their frequencies.

    Raises
    ------
    ValueError
        If the loop has more than one input or output.
    TypeError
        If it is no state space.
    """
    checks.instance("loop", loop, control.StateSpace, "margins")
    if not loop.issiso():
        raise ValueError(f"loop in margins: got {loop.ninputs} inputs, {loop.noutputs} outputs, wanted 1, 1")

    def L(omega: float) -> complex:
        return complex(frequency_response(loop, np.array([omega]))[0, 0, 0])

    omega = _frequencies(loop, points)
    values = frequency_response(loop, omega)[:, 0, 0]
    gain = [
        GainMargin(float(-20 * np.log10(abs(L(w)))), w)
        for w in _crossings(values.imag, omega, lambda w: L(w).imag)
        if L(w).real < 0
    ]
    phase = []
    for w in _crossings(np.abs(values) - 1, omega, lambda w: abs(L(w)) - 1):
        angle = float(np.angle(-L(w)))
        phase.append(PhaseMargin(float(np.degrees(angle)), angle % (2 * np.pi) / w, w))
    difference = _peak(lambda L: abs((1 - L) / (1 + L)) / 2, L, values, omega)
    sensitivity = _peak(lambda L: 1 / abs(1 + L), L, values, omega)
    return Margins(tuple(gain), tuple(phase), 1 / difference[0], difference[1], sensitivity[0])


def _peak(
    size: Callable, L: Callable[[float], complex], values: NDArray, omega: NDArray
) -> tuple[float, float]:
    """Return the largest size of L over frequencies, refined between its neighbours, and where it is."""
    sizes = size(values)
    at = int(sizes.argmax())
    ends = (omega[max(at - 1, 0)], omega[min(at + 1, omega.size - 1)])
    found = minimize_scalar(lambda w: -size(L(w)), bounds=ends, method="bounded")
    return max((float(-found.fun), float(found.x)), (float(sizes[at]), float(omega[at])))


NEAR = 1.25
"""Factor within which the frequency of a crossing is that of a bending mode."""


def by_mode(found: Margins, modes: Mapping[str, float], near: float = NEAR) -> dict[str, dict[str, float]]:
    """Return the smallest margins of each mode by name.

    Parameters
    ----------
    found : Margins
    modes : mapping of str to float
        Frequencies (rad/s) of the bending modes by name.
    near : float
        A crossing belongs to the nearest of the modes if their frequencies differ by less than this
        factor; any other is the rigid body's, or "aero" if the gain must fall to reach it.

    Returns
    -------
    dict of str to dict
        By mode ("rigid", "aero" and the given names): ``gain_dB``, ``phase_deg``, ``delay_s``, those of
        the nearest crossing, inf where there is none.
    """
    names = ("rigid", "aero", *modes)
    table = {name: {"gain_dB": np.inf, "phase_deg": np.inf, "delay_s": np.inf} for name in names}

    def owner(omega: float, falls: bool) -> str:
        distance = {name: abs(np.log(omega / at)) for name, at in modes.items()}
        closest = min(distance, key=distance.__getitem__, default="")
        if closest and distance[closest] < np.log(near):
            return closest
        return "aero" if falls else "rigid"

    for dB, omega in found.gain:
        row = table[owner(omega, dB < 0)]
        row["gain_dB"] = min(row["gain_dB"], dB, key=abs)
    for deg, delay, omega in found.phase:
        row = table[owner(omega, False)]
        row["phase_deg"] = min(row["phase_deg"], deg, key=abs)
        row["delay_s"] = min(row["delay_s"], delay)
    return table
