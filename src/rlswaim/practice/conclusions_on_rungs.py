"""The report's conclusions on each rung of the ladder: stands, falls or depends, with its number."""

import re
from collections.abc import Callable, Mapping
from functools import cache
from typing import NamedTuple

import control
import numpy as np
import pandas as pd

from rlswaim.edition.printed_closures import final_design
from rlswaim.edition.slow_roots import abscissas
from rlswaim.practice.blocks import delay, gain, low_pass
from rlswaim.practice.complementary import complementary
from rlswaim.practice.ladder import Rung, dual_actuation_on, reads_the_whole, vehicle_on
from rlswaim.practice.ladder_search import SEARCHED, modest_gains, stored
from rlswaim.practice.limits import Limits, limits
from rlswaim.practice.measurements import angle
from rlswaim.practice.rungs import Step, ladder_steps
from rlswaim.source.tables import constants


class Cell(NamedTuple):
    """One conclusion on one rung: stands, falls or depends, and the number that says so."""

    verdict: str
    number: float
    unit: str = ""

    def __str__(self) -> str:
        """Return verdict and number as a page shows them."""
        return f"{self.verdict} {self.number:.3g}{self.unit}".replace("-", "−")


def unstable_root(step: Step) -> float:
    """Return the largest real part of the uncontrolled vehicle's poles on a rung (1/s)."""
    return float(vehicle_on(*step).poles().real.max())


def with_the_jet(step: Step) -> control.StateSpace:
    """Return the vehicle with the jet's loop of Figure 24 closed, and the engine's fed nothing."""
    loop, kK_z = final_design()
    return dual_actuation_on(*step, K_A=0.0, K_C=1.0, K_R=0.0, kK_z=kK_z, **loop._asdict()).closed


def root_with_the_jet(step: Step) -> float:
    """Return the largest real part (1/s) with the jet's loop of Figure 24 closed and the engine at rest.

    It is the report's own choice, made to raise both coupled frequencies [conclusion 1b].
    """
    return float(with_the_jet(step).poles().real.max())


def rigid_root(step: Step) -> float:
    """Return the largest real part (1/s), a slow real root apart, of the vehicle with no bending at all.

    It is the limit of bending frequencies without bound [conclusion 2].
    """
    vehicle = vehicle_on(*step)
    kept = [not label.startswith("q") for label in vehicle.output_labels]
    poles = np.linalg.eigvals(vehicle.A[np.ix_(kept, kept)])
    return float(abscissas(poles[None], apart=True)[0])


def _actuation(rung: Rung) -> control.StateSpace:
    """Return what a rung has between command and angle: actuator, delay, gyro and low-pass."""
    c = constants("ladder")
    parts = {"actuator": rung.actuator, "gyro": rung.gyro, "filter": rung.low_pass}
    chain = [low_pass(omega, c[f"{name}_zeta"]) for name, omega in parts.items()]
    if rung.delay:
        chain.append(delay(rung.delay, int(c["pade_order"])))
    return control.ss(control.series(*chain))


def angle_limits(step: Step) -> Limits:
    """Return the limits of the angle that Sections V to VII feed back, with a rung's hardware.

    With filters that can be built it is the whole angle at the gyro, else the rigid body's alone.
    """
    eqs, rung = step
    vehicle, station = vehicle_on(eqs, rung), constants("ladder")["gyro_station"]
    gyros = {station: 1.0} if reads_the_whole(rung) else {}
    row = angle(eqs, gyros)
    read = [gain([list(row.values())], name="gyro", inputs=list(row), outputs="theta_i")]
    if rung.blend:
        read = complementary(eqs, rung.blend, 0.0, station)
    plant = control.interconnect(
        [vehicle, *read], inputs=["delta"], outputs=["theta_i"], warn_duplicate=False, check_unused=False
    )
    return limits(control.ss(control.series(_actuation(rung), plant)))


def as_found(step: Step) -> float:
    """Return the largest real part (1/s), a slow real root apart, of Section VII's modest loop as it is."""
    gains = {name: value for name, value in modest_gains().items() if name not in ("sensor", "jet")}
    return float(abscissas(SEARCHED["VII"].closed_loop(step, **gains).poles()[None], apart=True)[0])


def diverges(rung: str) -> Cell:
    """Return whether the uncontrolled vehicle diverges on a rung; its unstable root (1/s)."""
    root = unstable_root(ladder_steps()[rung])
    return Cell("stands" if root > 0 else "falls", root)


def jet_leaves_it(rung: str) -> Cell:
    """Return whether the jet that raises both frequencies leaves the vehicle diverging; the root (1/s)."""
    root = root_with_the_jet(ladder_steps()[rung])
    return Cell("stands" if root > 0 else "falls", root)


def stiffness_ends_it(rung: str) -> Cell:
    """Return whether the vehicle no longer diverges when nothing of it bends; its largest real part (1/s).

    It depends where a divergence is left, but a slower one.
    """
    step = ladder_steps()[rung]
    root = rigid_root(step)
    return Cell("stands" if root <= 0 else "depends" if root < unstable_root(step) else "falls", root)


def no_stable_controller(rung: str) -> Cell:
    """Return whether no stable controller stabilizes the angle fed back; the least peak of |S|."""
    found = angle_limits(ladder_steps()[rung])
    return Cell("falls" if found.stable_controller else "stands", found.peak)


def _no_gains(section: str) -> Callable[[str], Cell]:
    def cell(rung: str) -> Cell:
        least = stored()[rung, section].abscissa
        return Cell("stands" if least > 0 else "falls", least)

    return cell


def design_holds(rung: str) -> Cell:
    """Return whether Section VII's modest loop is stable on a rung as it is, and what it would be retuned.

    It depends where other gains at the same stations do it.
    """
    here = as_found(ladder_steps()[rung])
    retuned = stored()[rung, "VII"].abscissa
    return Cell("stands" if here < 0 else "depends" if retuned < 0 else "falls", here)


def gains_exist(rung: str) -> Cell:
    """Return whether gains of Section VII's structure stabilize on a rung, at the modest loop's stations."""
    least = stored()[rung, "VII"].abscissa
    return Cell("stands" if least < 0 else "falls", least)


class Conclusion(NamedTuple):
    """What is said, the page that says it, and the cell on a rung."""

    words: str
    page: str
    cell: Callable[[str], Cell]

    @property
    def of_report(self) -> str:
        """The number of the report's conclusion that it is about; empty for a claim of this edition."""
        found = re.search(r"\d[a-c]?", self.words)
        return found.group() if found else ""


CONCLUSIONS: Mapping[str, Conclusion] = {
    "diverges": Conclusion("3b: diverges", "03-forward-loop", diverges),
    "jet": Conclusion("1b: jet leaves that", "07-dual-actuation", jet_leaves_it),
    "rigid": Conclusion("2: stiffness ends it", "08-conclusions", stiffness_ends_it),
    "parity": Conclusion("no stable controller", "15-limits-of-performance", no_stable_controller),
    "IV": Conclusion("3a: IV fails", "04-rate-and-attitude-feedback", _no_gains("IV")),
    "V": Conclusion("6b: V fails", "05-single-sensor", _no_gains("V")),
    "VI": Conclusion("6b: VI fails", "06-two-sensors", _no_gains("VI")),
    "modest": Conclusion("not 1c: a jet does it", "07-dual-actuation", design_holds),
    "VII": Conclusion("or other gains", "07-dual-actuation", gains_exist),
}


@cache
def cells() -> dict[str, dict[str, Cell]]:
    """Return all cells by rung and conclusion."""
    return {rung: {name: one.cell(rung) for name, one in CONCLUSIONS.items()} for rung in ladder_steps()}


def table(more: Mapping[str, Mapping[str, Cell]]) -> pd.DataFrame:
    """Return all cells as texts with links, one row a rung and one column a conclusion.

    Parameters
    ----------
    more : mapping of str to mapping of str to Cell
        Rungs below those of `cells`, in the same form.

    Returns
    -------
    DataFrame
    """
    rows = {**cells(), **more}
    return pd.DataFrame(
        {
            one.words: [f"[{found[name]}]({one.page})" for found in rows.values()]
            for name, one in CONCLUSIONS.items()
        },
        index=list(rows),
    )
