"""Effectors with limits: a jet whose valve is on or off with a dead band, and an engine with stops.

The describing function of a valve that gives +-F beyond +-d is N(A) = 4 F/(pi A) sqrt(1 - (d/A)^2) for a
command of amplitude A.  A limit cycle is foretold where 1 + N(A) L(j omega) = 0, L opened at the jet.

With bounded effectors an unstable vehicle cannot be brought back from everywhere.  The left eigenvector v of
its root p, v x' = p v x + v B u, gives a bound that no controller passes: |v x| < sum |v B| u_max/p.
"""

from collections.abc import Callable
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.optimize import brentq

from rlswaim.practice.margins import Margins
from rlswaim.source.tables import constants
from rlswaim.vehicle.equations import PerturbationEquations

Effectors = Callable[[NDArray, NDArray], NDArray]
"""Takes the commands and what the effectors did a step before; returns what they do."""


class Limits(NamedTuple):
    """Engine's angle (rad) and rate (rad/s); throttled and on-off jet's force (lb), its dead band (lb)."""

    engine: float
    rate: float
    jet: float
    valve: float
    dead_band: float


def limits() -> Limits:
    """Return the limits of ``data/effector_limits.csv``."""
    given = constants("effector_limits")
    engine, rate = (float(np.radians(given[name])) for name in ("engine", "rate"))
    return Limits(engine, rate, given["jet"], given["valve"], given["dead_band"])


def describing_function(amplitude: float, force: float, dead_band: float) -> float:
    """Return the gain of an on-off valve with a dead band for a sine: its first harmonic over the command.

    Parameters
    ----------
    amplitude : float
        Of the command (lb).
    force, dead_band : float
        Of the valve (lb).

    Returns
    -------
    float
        0 within the dead band; at most 2 force/(pi dead_band).
    """
    if amplitude <= dead_band:
        return 0.0
    return float(4 * force / (np.pi * amplitude) * np.sqrt(1 - (dead_band / amplitude) ** 2))


class Cycle(NamedTuple):
    """A limit cycle: amplitude of the command (lb), frequency (rad/s), whether changes die out."""

    amplitude: float
    omega: float
    stable: bool


def foretold_cycles(found: Margins, force: float, dead_band: float) -> list[Cycle]:
    """Return the limit cycles that the describing function foretells.

    Parameters
    ----------
    found : Margins
        Of the loop opened at the jet: at each gain margin g the loop closes with N = g.
    force, dead_band : float
        Of the valve (lb).

    Returns
    -------
    list of Cycle
        Where N falls through the margin as the amplitude grows, a cycle is stable if less gain is stable,
        which is so at a margin upwards; and the other way round.
    """
    peak = np.sqrt(2) * dead_band
    cycles = []
    for dB, omega in found.gain:
        gain = 10 ** (dB / 20)
        if gain >= describing_function(peak, force, dead_band):
            continue

        def excess(amplitude: float, gain: float = gain) -> float:
            return describing_function(amplitude, force, dead_band) - gain

        large = brentq(excess, peak, 4 * force / (np.pi * gain) + peak)
        small = brentq(excess, dead_band, peak)
        cycles += [Cycle(float(large), omega, dB > 0), Cycle(float(small), omega, dB < 0)]
    return cycles


def on_off(force: float, dead_band: float) -> Effectors:
    """Return an ideal engine and an on-off jet.

    Parameters
    ----------
    force, dead_band : float
        Of the valve (lb).
    """

    def act(commands: NDArray, before: NDArray) -> NDArray:
        valve = force * np.sign(commands[1]) * (abs(commands[1]) > dead_band)
        return np.array([commands[0], valve])

    return act


def limited(bounds: Limits, step: float) -> Effectors:
    """Return an engine with stops and a largest rate, and a jet with a largest force.

    Parameters
    ----------
    bounds : Limits
    step : float
        Of time (s).
    """

    def act(commands: NDArray, before: NDArray) -> NDArray:
        near = before[0] + np.clip(commands[0] - before[0], -bounds.rate * step, bounds.rate * step)
        return np.array(
            [np.clip(near, -bounds.engine, bounds.engine), np.clip(commands[1], -bounds.jet, bounds.jet)]
        )

    return act


def delayed(act: Effectors, steps: int) -> Effectors:
    """Return effectors that do what they should some steps later, for one simulation.

    Parameters
    ----------
    act : callable
    steps : int
        1 or more.
    """
    waiting = [np.zeros(2)] * steps

    def late(commands: NDArray, before: NDArray) -> NDArray:
        waiting.append(act(commands, waiting[-1]))
        return waiting.pop(0)

    return late


def simulate(
    whole: control.StateSpace,
    made: control.StateSpace,
    act: Effectors,
    start: dict[str, float],
    horizon: float,
    step: float = 0.01,
) -> dict[str, NDArray]:
    """Return how a vehicle moves under a controller through effectors that are not linear, without wind.

    Parameters
    ----------
    whole : control.StateSpace
        From `hardware.plant`, with a jet.
    made : control.StateSpace
        A controller without a direct way from what it reads to its commands.
    act : callable
        As `on_off` and `limited` return them.
    start : dict of str to float
        The vehicle's states that are not 0 at first.
    horizon, step : float
        In s.

    Returns
    -------
    dict of str to ndarray, shape (n,)
        t, the plant's outputs, the commands before the effectors, and what these do ("done delta_c" ...).
    """
    names, n, k = list(whole.output_labels), whole.nstates, made.nstates
    rows = [names.index(name) for name in made.input_labels[1:]]
    B, D, reads = whole.B[:, 1:], whole.D[rows][:, 1:], made.B[:, 1:]
    A = np.block([[whole.A, np.zeros((n, k))], [reads @ whole.C[rows], made.A]])
    drive = np.vstack([B, reads @ D])
    step_matrix = expm(step * np.block([[A, drive], [np.zeros((2, n + k + 2))]]))[: n + k]
    x, u = np.zeros(n + k), np.zeros(2)
    vehicle = names[: names.index("delta")]
    x[:n] = np.linalg.lstsq(whole.C[: len(vehicle)], [start.get(name, 0.0) for name in vehicle])[0]
    t = np.arange(0, horizon, step)
    states, commands, done = np.zeros((t.size, n)), np.zeros((t.size, 2)), np.zeros((t.size, 2))
    for i in range(t.size):
        commands[i] = made.C @ x[n:]
        u = act(commands[i], u)
        states[i], done[i] = x[:n], u
        x = step_matrix @ np.concatenate([x, u])
    moved = dict(zip(names, (states @ whole.C.T + done @ whole.D[:, 1:].T).T, strict=True))
    after = {f"done {name}": value for name, value in zip(made.output_labels, done.T, strict=True)}
    return {"t": t} | moved | dict(zip(made.output_labels, commands.T, strict=True)) | after


def cycle_in(t: NDArray, signal: NDArray) -> tuple[float, float]:
    """Return amplitude and frequency (rad/s) of the strongest harmonic of the last two thirds of a signal.

    Parameters
    ----------
    t, signal : ndarray, shape (n,)
        Equally spaced times (s).

    Returns
    -------
    float, float
    """
    late = signal[t > t[-1] / 3]
    window = np.hanning(late.size)
    points = 8 * late.size  # zeros behind the signal make the steps between frequencies small
    size = np.abs(np.fft.rfft((late - late.mean()) * window, points)) * 2 / window.sum()
    at = int(size.argmax())
    return float(size[at]), float(2 * np.pi * np.fft.rfftfreq(points, t[1] - t[0])[at])


def authority(eqs: PerturbationEquations, jet: float) -> dict[str, float]:
    """Return what the effectors must do to hold the unstable root against a steady incidence of the air.

    Parameters
    ----------
    eqs : PerturbationEquations
    jet : float
        Station of the jet (ft).

    Returns
    -------
    dict of str to float
        root (1/s); engine, its angle over the incidence (1); jet, its force for each degree of it (lb);
        each alone, with its sign.
    """
    root, row, B = _unstable(eqs, jet)
    return {
        "root": root,
        "engine": float(-row @ B[:, 2] / (row @ B[:, 0])),
        "jet": float(-row @ B[:, 2] / (row @ B[:, 1]) * np.radians(1.0)),
    }


def _unstable(eqs: PerturbationEquations, jet: float) -> tuple[float, NDArray, NDArray]:
    """Return the fastest unstable root, its left eigenvector and B of the vehicle."""
    vehicle = eqs.state_space(jet)
    values, vectors = np.linalg.eig(vehicle.A.T)
    at = int(values.real.argmax())
    return float(values[at].real), vectors[:, at].real, vehicle.B


def farthest(eqs: PerturbationEquations, jet: float, bounds: Limits, state: str = "alpha") -> float:
    """Return the bound of a state (rad), all others 0, from which any controller can bring the vehicle back.

    Parameters
    ----------
    eqs : PerturbationEquations
    jet : float
        Station of the jet (ft).
    bounds : Limits
    state : str
    """
    root, row, B = _unstable(eqs, jet)
    reach = abs(row @ B[:, 0]) * bounds.engine + abs(row @ B[:, 1]) * bounds.jet
    return float(reach / root / abs(row[eqs.states.index(state)]))


def region(
    whole: control.StateSpace, made: control.StateSpace, bounds: Limits, most: float, state: str = "alpha"
) -> float:
    """Return the largest value of a state (rad), all others 0, that a design holds, limits and all.

    It counts as held if alpha is no larger after 25 s; with theta = 0 it is a drift, which decays slowly.

    Parameters
    ----------
    whole, made : control.StateSpace
        As in `simulate`.
    bounds : Limits
    most : float
        Where it fails (rad).
    state : str

    Returns
    -------
    float
        Found by halving to a thousandth of ``most``.
    """
    step, low, high = 0.01, 0.0, most
    while high - low > most / 1000:
        middle = (low + high) / 2
        run = simulate(whole, made, limited(bounds, step), {state: middle}, 25.0, step)
        held = np.abs(run["alpha"][-200:]).max() < middle
        low, high = (middle, high) if held else (low, middle)
    return low
