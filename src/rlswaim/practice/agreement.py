"""Printed results of other people's vehicles beside ours, in the manner of the ledger.

A printed number is text, and half a unit in its last digit is its tolerance; a printed word agrees if
ours is the same.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Any

import control
import numpy as np
import pandas as pd
from scipy.optimize import fsolve

from rlswaim.practice import greensite as g
from rlswaim.practice.gusts import one_minus_cosine, response
from rlswaim.practice.margins import Margins, margins
from rlswaim.source import checks
from rlswaim.source.tables import constants, half_unit, read_table

RIGID: dict[str, Any] = {"K_p": 1.78, "K_d": 0.44, "notch": False}
WITH_NOTCH: dict[str, Any] = {"K_p": 1.73, "K_d": 0.69}
GUST = {"amplitude": 6.4, "duration": 3.0}
"""The printed gust: m/s, s."""
AFTER = 27.0
"""So long after a gust the peaks are looked for (s)."""
ROUNDING = 1e-9
"""Real part (1/s) up to which a root counts as one at 0: without K_z the drift itself is such a root."""


@dataclass(frozen=True)
class Row:
    """One printed result and what became of it."""

    id: str
    case: str
    quantity: str
    printed: str
    unit: str
    computed: float | str
    verdict: str
    why: str

    @property
    def agrees(self) -> bool:
        """Whether the computed result rounds to the printed number, or is the printed word."""
        if isinstance(self.computed, str):
            return self.computed == self.printed
        return abs(self.computed - float(self.printed)) <= half_unit(self.printed) * (1 + 1e-9)


def _named(found: Margins) -> dict[str, float]:
    """Return the margins that the source prints; it prints the aero gain margin, a fall, as positive."""
    aero = max((m for m in found.gain if m.dB < 0), key=lambda m: m.dB)
    above = min((m.dB for m in found.gain if m.dB > 0), default=np.inf)
    phase = min((m for m in found.phase if m.deg > 0), key=lambda m: m.deg)
    return {
        "aero_margin": -aero.dB,
        "aero_omega": aero.omega,
        "gain_margin": above,
        "phase_margin": phase.deg,
        "phase_omega": phase.omega,
    }


def margins_with(**given: Any) -> dict[str, float]:
    """Return aero gain, gain and phase margin of Greensite's loop, and where they lie (dB, deg, rad/s).

    Parameters
    ----------
    **given
        As in `rlswaim.greensite`.

    Returns
    -------
    dict of str to float
    """
    return _named(margins(g.greensite(**given)))


def gust_peaks(
    amplitude: float = GUST["amplitude"], duration: float = GUST["duration"], **given: Any
) -> dict[str, float]:
    """Return the largest sizes in a 1-cosine gust, by default the printed one, until 27 s after it.

    Parameters
    ----------
    amplitude : float
        Of the gust (m/s).
    duration : float
        Of the gust (s).
    **given
        As in `rlswaim.greensite`.

    Returns
    -------
    dict of str to float
        alpha_w, theta, delta, alpha (deg) and z (m).

    Raises
    ------
    ValueError
        If a number is not finite, the duration is not positive, or a root lies right of the axis.
    """
    where = "gust_peaks"
    checks.real("amplitude", amplitude, where)
    t = np.arange(0, checks.positive("duration", duration, where) + AFTER, 0.001)
    wind = one_minus_cosine(t, amplitude / constants("greensite")["V"], duration)
    closed = g.closed_loop(**given)
    if (root := float(closed.poles().real.max())) > ROUNDING:
        raise ValueError(f"loop in {where}: got a root at {root:.3g} 1/s, wanted none right of the axis")
    found = response(closed, t, wind) | {"alpha_w": wind}
    units = dict.fromkeys(("alpha_w", "theta", "delta", "alpha"), 180 / np.pi) | {"z": 1.0}
    return {name: float(np.abs(found[name]).max()) * unit for name, unit in units.items()}


def unrounded_gains() -> dict[str, float]:
    """Return the gains, printed as 1.73 and .69, that give 6 dB and 30 deg exactly, with the notch."""

    def miss(gains: np.ndarray) -> list[float]:
        found = margins_with(K_p=float(gains[0]), K_d=float(gains[1]))
        return [found["aero_margin"] - 6, found["phase_margin"] - 30]

    return dict(zip(("K_p", "K_d"), map(float, fsolve(miss, list(WITH_NOTCH.values()))), strict=True))


def largest_real_part(loop: control.StateSpace) -> float:
    """Return the largest real part of the roots when a ``loop`` is closed by 1 + L = 0 (1/s)."""
    return float(control.feedback(loop, 1).poles().real.max())


def _computed() -> dict[str, float | str]:
    """Return every printed result of Greensite's vehicle as we compute it, by its id."""
    rigid = RIGID | {"bending": False, "actuator": False}
    found: dict[str, float | str] = {f"rigid-{k}": v for k, v in margins_with(**rigid).items()}
    found |= {f"notch-{k}": v for k, v in margins_with(**WITH_NOTCH).items()}
    found |= {f"gust-{k}": v for k, v in gust_peaks(**rigid).items()}
    poles = g.closed_loop(**rigid).poles()
    drift = min(poles[poles.imag > 0], key=abs)
    bent = g.greensite(**RIGID)
    omega = constants("greensite")["omega"]
    found |= {"drift-re": float(drift.real), "drift-im": float(drift.imag)}
    found |= {"mode-L": float(20 * np.log10(abs(bent(1j * omega)))), "mode-re": largest_real_part(bent)}
    for factor in (0.9, 0.95, 1.0, 1.05, 1.1):
        real = largest_real_part(g.greensite(**WITH_NOTCH, omega=factor))
        found[f"omega-{factor:.2f}"] = "stable" if real < 0 else "unstable"
    return found


@cache
def greensite_rows() -> tuple[Row, ...]:
    """Return every printed result of Greensite's vehicle beside ours."""
    found = _computed()
    return tuple(Row(computed=found[row["id"]], **row) for row in read_table("greensite_printed"))


def table(rows: Iterable[Row]) -> pd.DataFrame:
    """Return ``rows`` as a table for a page, every cell as text, indexed by id."""
    chosen = list(rows)
    return pd.DataFrame(
        [
            {
                "case": row.case,
                "quantity": row.quantity,
                "printed": row.printed,
                "computed": row.computed if isinstance(row.computed, str) else f"{row.computed:.5g}",
                "unit": row.unit,
                "verdict": row.verdict,
                "why": row.why,
            }
            for row in chosen
        ],
        index=pd.Index([row.id for row in chosen], name="id"),
        dtype=object,
    )
