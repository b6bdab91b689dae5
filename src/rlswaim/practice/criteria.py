"""Criteria in time and frequency, evaluated for any closed loop of a vehicle that flies through a gust.

What is wanted stands in ``data/criteria.csv``, with its source; `Wanted` holds it and can be varied.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace

import control
import numpy as np
import pandas as pd

from rlswaim.practice.gusts import one_minus_cosine, response, worst_gust
from rlswaim.practice.margins import Margins, by_mode, margins
from rlswaim.source import checks
from rlswaim.source.tables import constants

DEG = 180 / np.pi
GUST_PEAKS = {  # criterion: output of the loop in a gust, and what one unit of it counts
    "alpha_deg": ("incidence", DEG),
    "delta_deg": ("delta", DEG),
    "delta_rate_deg_s": ("delta_rate", DEG),
    "jet_lb": ("delta_r", 1.0),
    "drift_ft_s": ("drift", 1.0),
}
UNITS = {
    "alpha_deg": "deg",
    "delta_deg": "deg",
    "delta_rate_deg_s": "deg/s",
    "jet_lb": "lb",
    "drift_ft_s": "ft/s",
}
GUST_STEP = 0.02
"""Step of time of the gusts (s)."""
HORIZON, SAMPLES = 60.0, 6001
"""The time (s) over which theta must stay in its band, and how many times are looked at."""


@dataclass(frozen=True)
class Wanted:
    """What a closed loop shall keep to: upper bounds of peaks, lower bounds of margins."""

    band: float
    settling: float
    alpha_deg: float
    delta_deg: float
    delta_rate_deg_s: float
    jet_lb: float
    drift_ft_s: float
    gain_dB: float
    phase_deg: float
    bending_gain_dB: float
    bending_phase_deg: float
    delay_s: float
    disk: float
    gust_ft_s: float

    def __post_init__(self) -> None:
        """Check that each number is positive."""
        for field in fields(self):
            checks.positive(field.name, getattr(self, field.name), "Wanted")


def wanted() -> Wanted:
    """Return the criteria of ``data/criteria.csv``; `dataclasses.replace` varies them."""
    return Wanted(**constants("criteria"))


@dataclass(frozen=True)
class Criterion:
    """One criterion: its value for a loop, what is wanted (nan if nothing is), and whether it is met."""

    name: str
    value: float
    wanted: float
    unit: str
    at_most: bool

    @property
    def met(self) -> bool | None:
        """Whether the value keeps to what is wanted, nan does not; None where nothing is wanted."""
        if np.isnan(self.wanted):
            return None
        return self.value <= self.wanted if self.at_most else self.value >= self.wanted


STABLE = 1e-7
"""Largest real part (1/s) that counts as stable, where nothing slower is allowed."""


def settling_time(
    closed_loop: control.StateSpace, band: float, horizon: float = HORIZON, allowed: float = STABLE
) -> float:
    """Return when theta comes to stay within a band about a step of its command (s).

    Parameters
    ----------
    closed_loop : control.StateSpace
        With an input theta_c and an output theta.
    band : float
        Half its width, of the step (1).
    horizon : float
        Time over which it must stay (s).
    allowed : float
        Largest real part of a root (1/s).

    Returns
    -------
    float
        inf if it is outside at the horizon, or the loop is not stable.
    """
    if closed_loop.poles().real.max() > allowed:
        return float("inf")
    t = np.linspace(0, horizon, SAMPLES)
    step = closed_loop[closed_loop.output_labels.index("theta"), closed_loop.input_labels.index("theta_c")]
    theta = np.asarray(control.forced_response(step, t, np.ones_like(t)).y).ravel()
    outside = np.flatnonzero(np.abs(theta - 1) > band)
    if not outside.size:
        return 0.0
    return float("inf") if outside[-1] == t.size - 1 else float(t[outside[-1] + 1])


def with_motion(closed_loop: control.StateSpace, U: float) -> control.StateSpace:
    """Return a closed loop, driven by the gust alone, with the outputs that the criteria ask for.

    Parameters
    ----------
    closed_loop : control.StateSpace
        Inputs alpha_g and others; outputs alpha, theta, delta and, if there is a jet, delta_r.
    U : float
        Speed (ft/s).

    Returns
    -------
    control.StateSpace
        Further outputs: incidence = alpha + alpha_g (rad), drift = U (alpha - theta), the velocity across
        the path (ft/s), and delta_rate (rad/s).
    """
    names, gust = list(closed_loop.output_labels), closed_loop.input_labels.index("alpha_g")
    C, B, D = closed_loop.C, closed_loop.B[:, [gust]], closed_loop.D[:, [gust]]
    alpha, theta, delta = (names.index(name) for name in ("alpha", "theta", "delta"))
    if np.any(D[delta]):
        raise ValueError("closed_loop in with_motion: got a gust passed straight to delta, wanted a lag")
    rows = [C[alpha], U * (C[alpha] - C[theta]), C[delta] @ closed_loop.A]
    through = [D[alpha] + 1, U * (D[alpha] - D[theta]), C[[delta]] @ B]
    return control.ss(
        closed_loop.A,
        B,
        np.vstack([C, *rows]),
        np.vstack([D, *through]),
        inputs="alpha_g",
        outputs=[*names, "incidence", "drift", "delta_rate"],
    )


def evaluate(
    closed_loop: control.StateSpace,
    U: float,
    open_loop: control.StateSpace | None = None,
    modes: Mapping[str, float] | None = None,
    want: Wanted | None = None,
    allowed: float = STABLE,
) -> tuple[Criterion, ...]:
    """Return every criterion that a closed loop can be asked.

    Parameters
    ----------
    closed_loop : control.StateSpace
        Inputs alpha_g, perhaps theta_c, without which nothing settles; outputs alpha, theta, delta,
        perhaps delta_r and "moment <station>".
    U : float
        Speed (ft/s).
    open_loop : control.StateSpace, optional
        L(s) of the same loop, opened where its margins are asked; no margins without it.
    modes : mapping of str to float, optional
        Frequencies (rad/s) of the bending modes by name, to name the margins by.
    want : Wanted, optional
        `wanted` without it.
    allowed : float
        Largest real part of a root (1/s) with which the loop counts as stable.

    Returns
    -------
    tuple of Criterion
        Peaks are those of the worst 1-cosine gust for each; inf for a loop that is not stable.  Moments
        have no bound of their own: what is wanted of them is nan.  A loop that is not stable has no
        margins: they are nan, and not met.
    """
    want, found = want or wanted(), []
    if "theta_c" in closed_loop.input_labels:
        settled = settling_time(closed_loop, want.band, allowed=allowed)
        found.append(Criterion("settling", settled, want.settling, "s", True))
    found += _gust_criteria(closed_loop, U, want, allowed)
    if open_loop is None:
        return tuple(found)
    if closed_loop.poles().real.max() <= allowed:
        return (*found, *_margin_criteria(margins(open_loop), modes or {}, want))
    none = Margins((), (), np.nan, np.nan, np.nan)
    return (*found, *(replace(c, value=np.nan) for c in _margin_criteria(none, modes or {}, want)))


def _gust_criteria(
    closed_loop: control.StateSpace, U: float, want: Wanted, allowed: float
) -> list[Criterion]:
    """Return the peaks in the worst gust of each kind."""
    stable = closed_loop.poles().real.max() <= allowed
    system = with_motion(closed_loop, U)

    def peak(output: str) -> float:
        return worst_gust(system, output, want.gust_ft_s / U, step=GUST_STEP).peak if stable else float("inf")

    found = [
        Criterion(name, peak(output) * unit, getattr(want, name), UNITS[name], True)
        for name, (output, unit) in GUST_PEAKS.items()
        if output in system.output_labels
    ]
    moments = (name for name in system.output_labels if name.startswith("moment "))
    return found + [Criterion(name, peak(name), float("nan"), "lb ft", True) for name in moments]


def _margin_criteria(all_margins: Margins, modes: Mapping[str, float], want: Wanted) -> list[Criterion]:
    """Return the margins by mode; gain margins count as sizes, the aero margin's fall among them.

    A mode at which |L| stays below 1 is stabilized by gain, and has a gain margin of its own.
    """
    found = [Criterion("disk", all_margins.disk, want.disk, "1", False)]
    for mode, row in by_mode(all_margins, modes).items():
        kind = "bending_" if mode in modes else ""
        gained = "bending_" if mode in modes and not np.isfinite(row["phase_deg"]) else ""
        for name, unit in (("gain_dB", "dB"), ("phase_deg", "deg")):
            bound = getattr(want, (gained if name == "gain_dB" else kind) + name)
            if not (mode == "aero" and name == "phase_deg"):
                found.append(Criterion(f"{mode} {name}", abs(row[name]), bound, unit, False))
        if mode != "aero":
            found.append(Criterion(f"{mode} delay_s", row["delay_s"], want.delay_s, "s", False))
    return found


def table(found: tuple[Criterion, ...]) -> pd.DataFrame:
    """Return criteria that were ``found`` as a table: value, wanted, unit, met; indexed by name.

    Where nothing is wanted, "wanted" is empty and "met" None.
    """
    rows = [
        {
            "value": c.value,
            "wanted": "" if c.met is None else f"{'<=' if c.at_most else '>='} {c.wanted:g}",
        }
        | {"unit": c.unit, "met": c.met}
        for c in found
    ]
    return pd.DataFrame(rows, index=pd.Index([c.name for c in found], name="criterion"))


def gust_response(closed_loop: control.StateSpace, U: float, gust: float, duration: float) -> pd.DataFrame:
    """Return how a closed loop moves in one 1-cosine gust, each output a column, indexed by time (s).

    Parameters
    ----------
    closed_loop : control.StateSpace
        As in `with_motion`.
    U, gust : float
        Speed, and peak of the gust (ft/s).
    duration : float
        Of the gust (s).

    Returns
    -------
    DataFrame
    """
    t = np.arange(0, 4 * duration + 20, 0.01)
    found = response(with_motion(closed_loop, U), t, one_minus_cosine(t, gust / U, duration))
    return pd.DataFrame(found, index=pd.Index(t, name="t"))
