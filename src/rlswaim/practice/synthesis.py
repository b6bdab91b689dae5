"""Gains of a fixed structure that make the worst of several vehicles as good as may be.

``python -m rlswaim.practice.synthesis`` prints ``data/synthesis.csv``.  The cost is the largest ratio of a
criterion to what is wanted of it, over all criteria and all vehicles: at most 1 where everything is met.
Several starts share nothing; the richer structure also starts at the winner of the poorer one.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from rlswaim.edition.adaptation import adapted
from rlswaim.practice.criteria import DEG, Wanted, wanted, with_motion
from rlswaim.practice.dispersed import consistent_booster, dispersed, vehicles, with_gravity
from rlswaim.practice.gusts import one_minus_cosine
from rlswaim.practice.hardware import closed_loop, plant
from rlswaim.practice.margins import frequency_response
from rlswaim.practice.structures import BLEND, ENGINE, JET, controller, instruments_of
from rlswaim.source import checks
from rlswaim.source.tables import constants, number, read_table
from rlswaim.vehicle.equations import PerturbationEquations

STRUCTURES = {"VII, realizable": ENGINE + JET, "VII, integral, blended gyros, notch": ENGINE + JET + BLEND}
DURATIONS = (1.0, 2.5, 6.0, 15.0)
"""Of the gusts that are tried (s)."""
STEP, HORIZON = 0.1, 25.0
"""Of the responses (s)."""
FREQUENCIES = np.geomspace(0.05, 40.0, 50)
"""Frequencies at which the loops are looked at (rad/s)."""
UNSTABLE = 1000.0
"""Cost of each vehicle from the first on that is not stable; the rest of the cost is its root (1/s)."""
SEEDS, ROUNDS = (1964, 1965), 25
RANDOM = 200
"""Places among which each start is the best."""
MEAN = 0.05
"""Weight of the mean of the ratios beside the largest."""
BANDS = 3.0
"""Theta shall come so many bands near its command, as gains without an integral never end in it."""
SLOW = {"q_D": 0.9, "omega_1": 1.1, "omega_2": 1.1}
FAST = {"q_D": 1.1, "omega_1": 0.9, "omega_2": 0.9}


class Synthesized(NamedTuple):
    """The best gains of one structure, their cost, and what each start came to."""

    structure: str
    gains: dict[str, float]
    cost: float
    starts: tuple[float, ...]


def worst_cases() -> tuple[PerturbationEquations, ...]:
    """Return the vehicles of the worst case: three readings of the data, two corners."""
    corners = (dispersed(consistent_booster(), factors) for factors in (SLOW, FAST))
    return tuple(with_gravity(booster) for booster in (*vehicles().values(), *corners))


def slowest() -> float:
    """Return the real part (1/s) of a root that doubles in what is left of the burn: guidance can meet it."""
    given = constants("vehicle")
    return float(np.log(2) / (given["t_burn"] - given["t"]))


def responses(closed: control.StateSpace, U: float, gust: float) -> dict[str, NDArray]:
    """Return what moves in gusts of `DURATIONS`, and theta after a step of its command.

    Parameters
    ----------
    closed : control.StateSpace
    U, gust : float
        Speed, and peak of the gusts (ft/s).

    Returns
    -------
    dict of str to ndarray, shape (times, gusts + 1)
        Outputs of `criteria.with_motion`; the last column is the step's.
    """
    moving = with_motion(closed, U)
    t = np.arange(0, HORIZON, STEP)
    winds = np.column_stack([one_minus_cosine(t, gust / U, duration) for duration in DURATIONS])
    n, count = moving.nstates, len(DURATIONS) + 1
    drive = np.column_stack([moving.B[:, 0], closed.B[:, closed.input_labels.index("theta_c")]])
    step = expm(STEP * np.block([[closed.A, drive], [np.zeros((2, n + 2))]]))[:n]
    x, states = np.zeros((n, count)), np.zeros((t.size, n, count))
    for k in range(t.size - 1):
        x = step[:, :n] @ x
        x[:, :-1] += np.outer(step[:, n], (winds[k] + winds[k + 1]) / 2)
        x[:, -1] += step[:, n + 1]
        states[k + 1] = x
    values = np.einsum("on,tnc->otc", moving.C, states)
    values[:, :, :-1] += moving.D[:, :1, None] * winds
    return dict(zip(moving.output_labels, values, strict=True))


def ratios(eqs: PerturbationEquations, gains: Mapping[str, float], want: Wanted) -> dict[str, float]:
    """Return each criterion over what is wanted of it, for one vehicle; or "unstable" alone: how far (1/s).

    Parameters
    ----------
    eqs : PerturbationEquations
    gains : mapping of str to float
        As in `structures.controller`.
    want : Wanted
    """
    made = controller(gains)
    whole = plant(eqs, instruments_of(gains), jet=gains["jet"])
    closed = closed_loop(whole, made)
    poles = closed.poles()
    allowed = slowest()
    if (worst := float(poles.real.max())) > allowed:
        return {"unstable": worst - allowed}
    moved = responses(closed, eqs.U, want.gust_ft_s)
    settled = moved["theta"][round(want.settling / STEP) :, -1]
    found = {"following": float(np.abs(settled - 1).max()) / (BANDS * want.band)}
    for name, output, unit in (
        ("alpha_deg", "incidence", DEG),
        ("delta_deg", "delta", DEG),
        ("delta_rate_deg_s", "delta_rate", DEG),
        ("jet_lb", "delta_r", 1.0),
    ):
        found[name] = float(np.abs(moved[output][:, :-1]).max()) * unit / getattr(want, name)
    for command in ("delta_c", "delta_r_c"):
        L = frequency_response(closed_loop(whole, made, command), FREQUENCIES)[:, 0, 0]
        found[f"disk {command}"] = float(np.abs((1 - L) / (1 + L)).max()) / 2 * want.disk
    return found


def weighed(found: Sequence[Mapping[str, float]]) -> float:
    """Return the largest of all ratios, and a little of their mean, so that each improvement counts.

    Parameters
    ----------
    found : sequence of mapping of str to float
        From `ratios`, by vehicle.
    """
    values = [value for by_name in found for value in by_name.values()]
    return float(max(values) + MEAN * np.mean(values))


def cost_of(
    structure: str, cases: Sequence[PerturbationEquations], want: Wanted
) -> tuple[Callable[[NDArray], NDArray], Callable[[NDArray], dict[str, float]]]:
    """Return the cost over the unit cube of one structure's parameters, and the gains at a place of it.

    Parameters
    ----------
    structure : str
        One of `STRUCTURES`.
    cases : tuple of PerturbationEquations
    want : Wanted
    """
    names = STRUCTURES[checks.one_of("structure", structure, tuple(STRUCTURES), "cost_of")]
    rows = {row["parameter"]: row for row in read_table("synthesis_bounds")}

    def gains(u: NDArray) -> dict[str, float]:
        found = {}
        for name, x in zip(names, u, strict=True):
            low, high = number(rows[name]["low"]), number(rows[name]["high"])
            value = low * (high / low) ** x if rows[name]["spread"] == "log" else low + (high - low) * x
            found[name] = float(f"{value:.5g}") if rows[name]["unit"] != "ft" else float(round(value))
        return found

    def one(u: NDArray) -> float:
        tried: list[dict[str, float]] = []
        for left, eqs in zip(range(len(cases), 0, -1), cases, strict=True):
            tried.append(ratios(eqs, gains(u), want))
            if "unstable" in tried[-1]:
                return UNSTABLE * left + tried[-1]["unstable"]
        return weighed(tried)

    return lambda places: np.array([one(u) for u in places.T]), gains


def place_of(structure: str, gains: Mapping[str, float]) -> NDArray:
    """Return where in the unit cube some gains are; what they lack stands where it does nothing.

    Parameters
    ----------
    structure : str
    gains : mapping of str to float
    """
    rows = {row["parameter"]: row for row in read_table("synthesis_bounds")}
    neutral = {
        "K_I": 0.001,
        "blend": 1.0,
        "second_gyro": 400.0,
        "notch": 3.0,
        "notch_zeros": 0.5,
        "notch_poles": 0.5,
    }
    found = []
    for name in STRUCTURES[structure]:
        low, high = number(rows[name]["low"]), number(rows[name]["high"])
        value = (neutral | dict(gains))[name]
        log = rows[name]["spread"] == "log"
        found.append(np.log(value / low) / np.log(high / low) if log else (value - low) / (high - low))
    return np.array(found)


def synthesize(
    structure: str, better: Synthesized | None = None, seeds: tuple[int, ...] = SEEDS, rounds: int = ROUNDS
) -> Synthesized:
    """Return the best gains that several starts find.

    Parameters
    ----------
    structure : str
    better : Synthesized, optional
        Winner of a poorer structure, where one more start begins.
    seeds : tuple of int
        One start for each.
    rounds : int
        Generations of each.
    """
    cost, gains = cost_of(structure, worst_cases(), wanted())
    tries = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        some = rng.random((len(STRUCTURES[structure]), RANDOM))
        tries.append(adapted(cost, some[:, cost(some).argmin()], 0.15, rng, rounds))
    if better is not None:
        rng = np.random.default_rng(seeds[0])
        tries.append(adapted(cost, place_of(structure, better.gains), 0.05, rng, rounds))
    place, least = min(tries, key=lambda found: found[1])
    return Synthesized(structure, gains(place), least, tuple(value for _, value in tries))


def main() -> None:
    """Print the table ``data/synthesis.csv``."""
    units = {row["parameter"]: row["unit"] for row in read_table("synthesis_bounds")}
    print("structure,parameter,value,unit")
    better = None
    for structure in STRUCTURES:
        better = synthesize(structure, better, SEEDS[:1] if better else SEEDS)
        rows = [(name, f"{value:.5g}", units[name]) for name, value in better.gains.items()]
        rows += [("cost", f"{better.cost:.5g}", "1")]
        rows += [(f"start {i}", f"{value:.5g}", "1") for i, value in enumerate(better.starts, start=1)]
        for row in rows:
            print(f'"{structure}"', *row, sep=",", flush=True)


if __name__ == "__main__":
    main()
