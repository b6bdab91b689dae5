"""The whole burn: the vehicle over 0 to 110 s, designs fixed and scheduled, frozen and varying in time.

The report gives masses and modes at 57.5 s alone.  What is assumed here for the rest of the burn:

- the propellant leaves the five stations of the first stage (255 ft and aft) evenly;
- the stiffness stays, so that modes and frequencies follow from the masses: the free-free modes in the space
  of translation, rotation and the two shapes of the consistent vehicle at 57.5 s (Rayleigh and Ritz);
- thrust, slopes of the normal force and damping ratios stay; speed and air are those of the integrated
  ascent in the standard atmosphere with the book's pitch program.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh, expm

from rlswaim.practice.designs import BASE, NOSE
from rlswaim.practice.dispersed import consistent_booster, with_gravity
from rlswaim.practice.gusts import shear_with_gust
from rlswaim.practice.hardware import closed_loop, plant
from rlswaim.practice.instruments import Instrument, gyros
from rlswaim.practice.optimal import Wishes, lqg
from rlswaim.source.tables import constants, read_table
from rlswaim.vehicle.booster import Booster, FlightCondition
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations
from rlswaim.vehicle.modes import BendingMode
from rlswaim.vehicle.trajectory import Trajectory, fly, level_at_burnout, swaim_ascent

FIRST_STAGE = 255.0
"""The foremost station that loses propellant (ft)."""
READS = (*gyros(60.0), Instrument("accelerometer", NOSE))
WISHES = Wishes(BASE, recovery=1.0)
EACH = 2.5
"""Between one design and the next if it is made anew all the time (s)."""
STEP, HOLD = 0.02, 0.5
"""Of the simulation, and how long the vehicle is held constant in it (s)."""


@cache
def flown_path() -> Trajectory:
    """Return the integrated ascent with the book's pitch program, at each half second."""
    ascent = swaim_ascent()
    return fly(ascent, level_at_burnout(ascent), np.linspace(0.0, ascent.t_burn, 221))


def masses_at(t: float) -> NDArray:
    """Return the concentrated masses (slug) at a time ``t`` (s); those of Table 1 at 57.5 s."""
    booster, given = consistent_booster(), constants("vehicle")
    loses = booster.stations >= FIRST_STAGE
    return booster.masses + given["m_p"] * (given["t"] - t) * loses / loses.sum()


def modes_for(booster: Booster, masses: NDArray) -> tuple[BendingMode, ...]:
    """Return the free-free modes of a vehicle with other masses and the same stiffness.

    Parameters
    ----------
    booster : Booster
        Its modes are orthogonal with its own masses.
    masses : ndarray, shape (n,)
        In slug.

    Returns
    -------
    tuple of BendingMode
        Each with the generalized mass that it has with the vehicle's own masses.
    """
    count = len(booster.modes)

    def basis(x: NDArray, slope: bool = False) -> NDArray:
        line = [0 * x, 0 * x - 1.0] if slope else [0 * x + 1.0, x]
        own = [mode.slope(x) if slope else mode.deflection(x) for mode in booster.modes]
        return np.column_stack([*line, *own])

    at_masses = basis(booster.stations)
    stiffness = np.diag([0.0, 0.0, *(mode.mass * mode.omega**2 for mode in booster.modes)])
    squares, vectors = eigh(stiffness, at_masses.T @ (masses[:, None] * at_masses))
    found = []
    for i, mode in enumerate(booster.modes):
        vector = vectors[:, i - count]
        shape = vector * np.sqrt(mode.mass) * np.sign(vector[2 + i])
        deflections, slopes = basis(mode.stations) @ shape, basis(mode.slope_stations, slope=True) @ shape
        omega = float(np.sqrt(squares[i - count]))
        found.append(replace(mode, deflections=deflections, slopes=slopes, omega=omega))
    return tuple(found)


def booster_at(t: float) -> Booster:
    """Return the vehicle at a time ``t`` of the burn (s)."""
    own, path = consistent_booster(), flown_path().at(t)
    masses = masses_at(t)
    total = float(masses.sum())
    centre = float(masses @ own.stations / total)
    gamma_0 = level_at_burnout(swaim_ascent())(t)
    return replace(
        own,
        masses=masses,
        M=total,
        l_CG=centre,
        I_y=float(masses @ (own.stations - centre) ** 2),
        l_G=own.thrust_station - centre,
        modes=modes_for(own, masses),
        flight=FlightCondition(path["q_D"], max(path["U"], 1.0), path["h"], t, gamma_0),
        name=f"Swaim's booster at {t:g} s",
    )


def equations_at(t: float, *, U: float, q_D: float) -> PerturbationEquations:
    """Return Eq. 29 for the vehicle of a time, in a flight of another pitch program.

    Parameters
    ----------
    t : float
        In s.
    U : float
        Speed of that flight (ft/s); one below 1 counts as 1, since Eq. 29 divides by it.
    q_D : float
        Its dynamic pressure (lb/ft^2).
    """
    booster = booster_at(t)
    flight = replace(booster.flight, U=max(U, 1.0), q_D=q_D)
    return perturbation_equations(replace(booster, flight=flight))


def fixed(t: float) -> control.StateSpace:
    """Return the design for 57.5 s, whatever the time ``t``."""
    return made_for(constants("vehicle")["t"])


@cache
def made_for(t: float) -> control.StateSpace:
    """Return the design for one time ``t`` of the burn (s)."""
    return lqg(booster_at(t), READS, WISHES, NOSE)


@cache
def switched() -> dict[float, float]:
    """Return when a design of the schedule begins, and the time that it is made for (s).

    They come from `rlswaim.practice.schedule_search` [data/schedule.csv].
    """
    return {float(row["begins"]): float(row["made_for"]) for row in read_table("schedule")}


def scheduled(t: float) -> control.StateSpace:
    """Return the design of `switched` that flies at a time ``t`` (s).

    Its states are estimates of the vehicle's, so they are kept when one design follows another.
    """
    begins = np.array([*switched()])
    return made_for(switched()[float(begins[begins <= t][-1])])


def redesigned(t: float) -> control.StateSpace:
    """Return the design made for a time ``t`` (s), to the nearest `EACH`."""
    return made_for(float(np.clip(EACH * np.round(t / EACH), 2 * EACH, 107.5)))


@cache
def plant_at(t: float) -> control.StateSpace:
    """Return the vehicle of a time ``t`` (s), its weight kept, with hardware and the instruments `READS`."""
    return plant(with_gravity(booster_at(t)), READS, jet=NOSE)


def loop_at(t: float, design: Callable[[float], control.StateSpace]) -> control.StateSpace:
    """Return the closed loop, the vehicle frozen at one time.

    Parameters
    ----------
    t : float
        In s.
    design : callable
        `fixed`, `scheduled` or `redesigned`.
    """
    return closed_loop(plant_at(t), design(t))


def frozen_poles(times: Sequence[float], design: Callable[[float], control.StateSpace]) -> NDArray:
    """Return the poles (1/s) of the loop frozen at each of several times.

    Parameters
    ----------
    times : sequence of float
        In s.
    design : callable
        As in `loop_at`.

    Returns
    -------
    ndarray of complex, shape (times, states)
    """
    return np.array([loop_at(float(t), design).poles() for t in times])


def held(design: Callable[[float], control.StateSpace], times: Sequence[float]) -> tuple[float, float]:
    """Return the first and the last of several times at which the frozen loop has all poles left of the axis.

    Times between them may be lost.

    Parameters
    ----------
    design : callable
        As in `loop_at`.
    times : sequence of float
        In s.
    """
    good = [float(t) for t in times if loop_at(float(t), design).poles().real.max() < 0]
    return good[0], good[-1]


def wind(t: NDArray) -> NDArray:
    """Return the wind of ``data/winds.csv`` (ft/s) at times ``t`` (s) of the burn, the late gust with it."""
    given = constants("winds")
    parts = {name: given[name] for name in ("wind", "build_up", "gust", "edge", "plateau")}
    alone = parts | {"wind": 0.0, "build_up": given["edge"]}
    return shear_with_gust(t - given["start"], **parts) + shear_with_gust(t - given["late"], **alone)


def tilted(loop: control.StateSpace, theta: float) -> NDArray:
    """Return the states of a loop at rest but for an attitude, the incidence being as large.

    Parameters
    ----------
    loop : control.StateSpace
    theta : float
        In rad.
    """
    rows = [list(loop.output_labels).index(name) for name in ("alpha", "theta")]
    return np.asarray(np.linalg.pinv(loop.C[rows]) @ [theta, theta])


def flight(
    design: Callable[[float], control.StateSpace],
    start: float,
    end: float,
    frozen: float | None = None,
    theta: float = 0.0,
) -> dict[str, NDArray]:
    """Return how the vehicle moves in the wind over a part of the burn, its data changing on the way.

    Parameters
    ----------
    design : callable
        As in `loop_at`.
    start, end : float
        In s.
    frozen : float, optional
        Keep the loop of this time all the way (s); the wind's incidence goes with it.
    theta : float
        Attitude at the start (rad), the path being undisturbed: the incidence is as large.

    Returns
    -------
    dict of str to ndarray, shape (n,)
        t (s), alpha_g (rad), and the outputs of the loop.
    """
    times = np.arange(start, end, STEP)
    hold, rows = round(HOLD / STEP), []
    x = tilted(loop_at(start, design), theta)
    speeds = np.maximum(np.interp(times if frozen is None else frozen, flown_path().times, flown_path().U), 1)
    gust = wind(times) / speeds
    middle = (gust + np.append(gust[1:], gust[-1])) / 2
    for first in range(0, times.size, hold):
        if frozen is None or not first:
            loop = loop_at(frozen if frozen is not None else float(times[first]) + HOLD / 2, design)
            n, at = loop.nstates, loop.input_labels.index("alpha_g")
            whole = expm(STEP * np.block([[loop.A, loop.B[:, [at]]], [np.zeros((1, n + 1))]]))
        for now, drive in zip(gust[first : first + hold], middle[first : first + hold], strict=True):
            rows.append(loop.C @ x + loop.D[:, at] * now)
            x = whole[:n, :n] @ x + whole[:n, n] * drive
    return {"t": times, "alpha_g": gust} | dict(zip(loop.output_labels, np.array(rows).T, strict=True))
