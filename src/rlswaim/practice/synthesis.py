"""Gains of a fixed structure that make the worst of several vehicles as good as may be.

``python -m rlswaim.practice.synthesis`` prints ``data/synthesis.csv``.  The cost is the largest ratio of a
criterion to what is wanted of it, over all criteria and all vehicles: at most 1 where everything is met.
Two kinds of evolution start at random places, and the second kind once more at the best of these.
"""

import sys
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from rlswaim.edition import spreads
from rlswaim.edition.adaptation import adapted
from rlswaim.edition.search import evolved
from rlswaim.practice.criteria import DEG, Wanted, wanted, with_motion
from rlswaim.practice.dispersed import consistent_booster, dispersed, vehicles, with_gravity
from rlswaim.practice.gusts import one_minus_cosine
from rlswaim.practice.hardware import COMMANDS, plant
from rlswaim.practice.margins import frequency_response
from rlswaim.practice.structures import STRUCTURES
from rlswaim.source import checks
from rlswaim.source.tables import constants, read_table
from rlswaim.vehicle.equations import PerturbationEquations

DURATIONS = (1.0, 2.5, 6.0, 15.0)
"""Of the gusts that are tried (s)."""
STEP, HORIZON = 0.1, 25.0
"""Of the responses (s)."""
FREQUENCIES = np.geomspace(0.05, 40.0, 50)
"""Frequencies at which the loops are looked at (rad/s)."""
UNSTABLE = 1000.0
"""Cost of each vehicle from the first on that is not stable; the rest of the cost is its root (1/s)."""
SEEDS = (1964, 1965)
ROUNDS, PEOPLE = 12, 3
"""Generations of differential evolution, and places in each for each parameter."""
ADAPTED = 18
"""Generations of the adaptation of a covariance matrix."""
RANDOM = 100
"""Places among which that one's start is the best."""
MEAN = 0.05
"""Weight of the mean of the ratios beside the largest."""
BANDS = 3.0
"""Theta must come within so many bands of its command: without an integral it never reaches it in full."""
SLOW = {"q_D": 0.9, "omega_1": 1.1, "omega_2": 1.1}
FAST = {"q_D": 1.1, "omega_1": 0.9, "omega_2": 0.9}


class Synthesized(NamedTuple):
    """The best gains of one structure, their cost, and what each way came to."""

    structure: str
    gains: dict[str, float]
    cost: float
    ways: dict[str, float]


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
    pushes = np.zeros((t.size - 1, n, count))
    pushes[:, :, :-1] = step[:, n, None] * ((winds[:-1] + winds[1:]) / 2)[:, None]
    pushes[:, :, -1] = step[:, n + 1]
    over, states = step[:, :n], np.zeros((t.size, n, count))
    for k, push in enumerate(pushes):
        states[k + 1] = over @ states[k] + push
    values = np.moveaxis(moving.C @ states, 1, 0)
    values[:, :, :-1] += moving.D[:, :1, None] * winds
    return dict(zip(moving.output_labels, values, strict=True))


def joined(
    whole: control.StateSpace, made: control.StateSpace, opened: str | None = None
) -> control.StateSpace:
    """Return a plant under a controller without a direct way, as `hardware.closed_loop` does, in less time.

    Parameters
    ----------
    whole, made : control.StateSpace
        As in `hardware.closed_loop`; the controller's D is 0.
    opened : str, optional
        A command at which the loop is opened instead.

    Returns
    -------
    control.StateSpace
        As from `hardware.closed_loop`.

    Raises
    ------
    ValueError
        If the controller's D is not 0.
    """
    if np.any(made.D):
        raise ValueError("made in joined: got a direct way from readings to commands, wanted none")
    names, n = list(whole.output_labels), whole.nstates
    reads = [names.index(name) for name in made.input_labels[1:]]
    driven = [list(whole.input_labels).index(name) for name in made.output_labels]
    B, K, F = whole.B[:, driven], made.C.copy(), made.B[:, 1:]
    D = whole.D[:, driven]
    at = list(made.output_labels).index(opened) if opened else 0
    cut = K[[at]].copy()
    if opened:
        K[at] = 0.0
    A = np.block([[whole.A, B @ K], [F @ whole.C[reads], made.A + F @ D[reads] @ K]])
    if opened:
        enters = np.vstack([B[:, [at]], F @ D[reads][:, [at]]])
        return control.ss(A, enters, np.hstack([np.zeros((1, n)), -cut]), [[0.0]])
    gust = whole.B[:, [0]], F @ whole.D[reads][:, [0]]
    enters = np.block([[np.zeros((n, 1)), gust[0]], [made.B[:, [0]], gust[1]]])
    passed = np.hstack([np.zeros((len(names), 1)), whole.D[:, [0]]])
    return control.ss(
        A, enters, np.hstack([whole.C, D @ K]), passed, inputs=["theta_c", "alpha_g"], outputs=names
    )


def ratios(
    eqs: PerturbationEquations, structure: str, gains: Mapping[str, float], want: Wanted
) -> dict[str, float]:
    """Return each criterion over what is wanted of it, for one vehicle; or "unstable" alone: how far (1/s).

    Parameters
    ----------
    eqs : PerturbationEquations
    structure : str
        One of `structures.STRUCTURES`.
    gains : mapping of str to float
        As its controller wants them, with the station of the jet.
    want : Wanted
    """
    kind = STRUCTURES[structure]
    made = kind.controller(gains)
    whole = plant(eqs, kind.instruments(gains), jet=gains["jet"])
    closed = joined(whole, made)
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
    for command in COMMANDS:
        L = frequency_response(joined(whole, made, command), FREQUENCIES)[:, 0, 0]
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


class Sought:
    """One structure's search over the unit cube of its parameters, as `rlswaim.edition.search.evolved` wants.

    Parameters
    ----------
    structure : str
        One of `structures.STRUCTURES`.
    """

    def __init__(self, structure: str) -> None:
        checks.one_of("structure", structure, tuple(STRUCTURES), "Sought")
        self.structure, self.cases, self.want = structure, worst_cases(), wanted()
        self.sought = list(STRUCTURES[structure].parameters)
        self.rows = {row["parameter"]: row for row in read_table("synthesis_bounds")}

    def rounded(self, u: NDArray) -> dict[str, float]:
        """Return the gains at one place ``u``, shape (n,): to five digits, stations to a foot."""
        found = dict(STRUCTURES[self.structure].fixed)
        for name, x in zip(self.sought, u, strict=True):
            value = float(spreads.spread(self.rows[name], x))
            found[name] = float(round(value)) if self.rows[name]["unit"] == "ft" else float(f"{value:.5g}")
        return found

    def place(self, gains: Mapping[str, float]) -> NDArray:
        """Return where in the unit cube some ``gains`` are."""
        return np.array([spreads.place(self.rows[name], gains[name]) for name in self.sought])

    def of(self, gains: Mapping[str, float]) -> float:
        """Return the cost of some ``gains``: vehicle by vehicle, up to the first that is not stable."""
        tried: list[dict[str, float]] = []
        for left, eqs in zip(range(len(self.cases), 0, -1), self.cases, strict=True):
            tried.append(ratios(eqs, self.structure, gains, self.want))
            if "unstable" in tried[-1]:
                return UNSTABLE * left + tried[-1]["unstable"]
        return weighed(tried)

    def cost(self, u: NDArray) -> NDArray:
        """Return the costs at places ``u``, shape (n, S)."""
        return np.array([self.of(self.rounded(place)) for place in u.T])


def synthesize(
    structure: str, seeds: tuple[int, ...] = SEEDS, rounds: int = ROUNDS, adapting: int = ADAPTED
) -> Synthesized:
    """Return the best gains that several ways find.

    Parameters
    ----------
    structure : str
        One of `structures.STRUCTURES`.
    seeds : tuple of int
        Differential evolution and adaptation start once for each.
    rounds, adapting : int
        Generations of each.
    """
    problem, found = Sought(structure), {}
    for seed in seeds:
        gains, _ = evolved(problem, rounds, PEOPLE, seed)  # type: ignore[arg-type]
        found[f"evolution {seed}"] = gains
        rng = np.random.default_rng(seed)
        some = rng.random((len(problem.sought), RANDOM))
        place, _ = adapted(problem.cost, some[:, problem.cost(some).argmin()], 0.15, rng, adapting)
        found[f"adaptation {seed}"] = problem.rounded(place)
    best = min(found.values(), key=problem.of)
    rng = np.random.default_rng(seeds[0])
    place, _ = adapted(problem.cost, problem.place(best), 0.05, rng, adapting)
    found["adaptation from the best"] = problem.rounded(place)
    costs = {way: problem.of(gains) for way, gains in found.items()}
    way = min(costs, key=costs.__getitem__)
    return Synthesized(structure, found[way], costs[way], costs)


def main() -> None:
    """Print the table ``data/synthesis.csv``."""
    units = {row["parameter"]: row["unit"] for row in read_table("synthesis_bounds")}
    print("structure,parameter,value,unit")
    for structure in STRUCTURES:
        best = synthesize(structure)
        rows = [(name, f"{value:.5g}", units[name]) for name, value in best.gains.items()]
        rows += [("cost", f"{best.cost:.5g}", "1")]
        rows += [(way, f"{value:.5g}", "1") for way, value in best.ways.items()]
        for row in rows:
            print(f'"{structure}"', *row, sep=",", flush=True)
        print(best.ways, file=sys.stderr)


if __name__ == "__main__":
    main()
