"""The ladder's loop with an engine that turns no faster than a largest rate.

The servo delta' = K_C (command - delta) becomes delta' = limit(K_C (command - delta)).  For a sine of
amplitude A the limit is a gain N(A) of 1 down to 0, real and without lag, so the loop opened at the limit
tells by its gain margin downwards at which amplitude it keeps swinging; beyond it, it is lost.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.optimize import brentq

from rlswaim.practice.conclusions_on_rungs import CONCLUSIONS, Cell
from rlswaim.practice.conclusions_on_rungs import cells as linear_cells
from rlswaim.practice.gusts import one_minus_cosine
from rlswaim.practice.ladder import Rung, dual_actuation_on
from rlswaim.practice.ladder_search import modest_gains
from rlswaim.practice.margins import margins
from rlswaim.practice.rungs import ladder_steps
from rlswaim.source import checks
from rlswaim.source.tables import constants

STEP, HORIZON = 0.005, 40.0
"""Of the simulations (s)."""
DURATIONS = (1.0, 2.0, 3.0, 4.0, 5.0)
"""Of the 1-cosine gusts (s)."""
LOST = 1.0
"""An angle (rad) or a pitch rate (rad/s) beyond which a vehicle counts as lost."""
LAST = 5.0
"""So long at the end the rate must be below its limit (s)."""


@dataclass(frozen=True, eq=False)
class RateLimited:
    """A loop opened where the engine's rate is limited: x' = A x + b rate + g alpha_g, wish = c x."""

    A: NDArray
    b: NDArray
    g: NDArray
    c: NDArray
    most: float
    """Largest rate (rad/s)."""

    def loop(self) -> control.StateSpace:
        """Return L(s) from the limit's output round to its input, for 1 + N L = 0."""
        return control.ss(self.A, self.b[:, None], -self.c[None], [[0.0]])


def rate_limited(closed: control.StateSpace, most: float) -> RateLimited:
    """Return a closed loop with its engine's rate limited.

    Parameters
    ----------
    closed : control.StateSpace
        Of `rlswaim.practice.ladder`, its engine of the first order alone.
    most : float
        Largest rate (rad/s).

    Returns
    -------
    RateLimited

    Raises
    ------
    ValueError
        If the engine is not of the first order.
    """
    own = [i for i, name in enumerate(closed.state_labels) if str(name).startswith("engine_x")]
    if len(own) != 1:
        raise ValueError(f"closed in rate_limited: got {len(own)} states of the engine, wanted 1")
    at = own[0]
    # The engine's state counts as delta over this number.
    unit = float(closed.C[closed.output_labels.index("delta"), at])
    A = closed.A.copy()
    wish, b = unit * A[at], np.zeros(len(A))
    A[at], b[at] = 0.0, 1 / unit
    gust = closed.B[:, closed.input_labels.index("alpha_g")]
    return RateLimited(A, b, gust, wish, checks.positive("most", most, "rate_limited"))


def limit_function(amplitude: float, most: float) -> float:
    """Return the describing function of a limit for a sine.

    Parameters
    ----------
    amplitude, most : float
        Of the sine, and what the limit lets pass, in one unit.

    Returns
    -------
    float
        1 up to the limit, then 2/pi (arcsin r + r sqrt(1 - r^2)) with r = most/amplitude.
    """
    if amplitude <= most:
        return 1.0
    r = most / amplitude
    return float(2 / np.pi * (np.arcsin(r) + r * np.sqrt(1 - r * r)))


def foretold(system: RateLimited) -> tuple[float, float]:
    """Return amplitude of the wished rate (rad/s) and frequency (rad/s) of the swing that is the border.

    Raises
    ------
    ValueError
        If the loop bears any fall of its gain.
    """
    down = [m for m in margins(system.loop()).gain if m.dB < 0]
    if not down:
        raise ValueError("system in foretold: got no gain margin downwards, wanted one")
    first = max(down, key=lambda m: m.dB)
    gain, most = 10 ** (first.dB / 20), system.most
    border = brentq(lambda a: limit_function(a, most) - gain, most, 10 * most / gain)
    return float(border), first.omega


def held(system: RateLimited, starts: NDArray, winds: NDArray) -> NDArray:
    """Return whether a loop ends where its rate is no longer limited, so that it comes to rest.

    Parameters
    ----------
    system : RateLimited
    starts : ndarray, shape (n, cases)
        Its states, the vehicle's first.
    winds : ndarray, shape (m, cases)
        Incidence of the gust (rad), every `STEP`.

    Returns
    -------
    ndarray of bool, shape (cases,)
    """
    n, first = len(system.A), len(winds) - round(LAST / STEP)
    drive = np.column_stack([system.b, system.g])
    step = expm(STEP * np.block([[system.A, drive], [np.zeros((2, n + 2))]]))[:n]
    x, good = starts.copy(), np.ones(starts.shape[1], dtype=bool)
    for i, gust in enumerate(winds):
        wish = system.c @ x
        x = step @ np.vstack([x, np.clip(wish, -system.most, system.most), gust])
        good &= np.abs(x[:3]).max(axis=0) < LOST
        if i >= first:
            good &= np.abs(wish) < system.most
        x[:, ~good] = 0.0
    return good


def _border(holds: Callable[[NDArray], NDArray], low: float, high: float) -> float:
    """Return the largest factor up to which all that are tried are held, to a few parts in a thousand."""
    for count in (40, 40):
        tried = np.geomspace(low, high, count)
        lost = np.flatnonzero(~holds(tried))
        if not lost.size or lost[0] == 0:
            return float(high if not lost.size else low)
        low, high = tried[lost[0] - 1], tried[lost[0]]
    return float(low)


def found_beside_foretold(system: RateLimited) -> float:
    """Return the amplitude of the swing from which a simulation is lost, over the foretold one (1).

    The simulations start on the foretold swing, made larger or smaller.
    """
    amplitude, omega = foretold(system)
    passed = limit_function(amplitude, system.most) * amplitude
    swing = np.linalg.solve(1j * omega * np.eye(len(system.A)) - system.A, system.b * passed)
    steps = round(HORIZON / STEP)
    return _border(lambda k: held(system, np.outer(swing.real, k), np.zeros((steps, k.size))), 0.1, 10.0)


def largest_gust(system: RateLimited, U: float, duration: float) -> float:
    """Return the peak (ft/s) of the largest 1-cosine gust of a duration (s) that a loop at speed U holds.

    Parameters
    ----------
    system : RateLimited
    U : float
        In ft/s.
    duration : float
        In s.
    """
    t = np.arange(0, duration + HORIZON, STEP)
    one = one_minus_cosine(t, 1 / U, duration)
    return _border(
        lambda peak: held(system, np.zeros((len(system.A), peak.size)), np.outer(one, peak)), 1.0, 1e4
    )


@cache
def modest_loop() -> RateLimited:
    """Return Section VII's modest loop on the printed equations with the rate limit of data/ladder.csv."""
    eqs = ladder_steps()["as printed"].eqs
    most = float(np.radians(constants("ladder")["rate_limit"]))
    return rate_limited(dual_actuation_on(eqs, Rung(), **modest_gains()).closed, most)


@cache
def worst_gust_held() -> tuple[float, float]:
    """Return peak (ft/s) and duration (s) of the least of the largest gusts that the modest loop holds."""
    U = ladder_steps()["as printed"].eqs.U
    return min((largest_gust(modest_loop(), U, duration), duration) for duration in DURATIONS)


@cache
def cells() -> dict[str, Cell]:
    """Return the row of the table of conclusions for the rate limit.

    Small motions are those of the linear loop, and so are the cells; the modest loop holds up to a gust.
    """
    row = dict(linear_cells()["as printed"])
    row["modest"] = Cell("depends", worst_gust_held()[0], " ft/s")
    return {name: row[name] for name in CONCLUSIONS}
