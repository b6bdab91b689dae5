"""The live view of Section IV: rate and attitude feedback to the thrust vector."""

import control
import numpy as np
from numpy.typing import ArrayLike

from rlswaim import checks
from rlswaim.branches import continuous_branches
from rlswaim.explorers.multiaffine import MultiAffine, multiaffine_form, with_shapes
from rlswaim.explorers.widget import Explorer, Parameter, Value
from rlswaim.figures.style import COLORS
from rlswaim.perturbation import STATES, PerturbationEquations
from rlswaim.systems import rate_attitude
from rlswaim.tables import read_table

SYSTEM = "rate-attitude"
MAGNITUDES = (1e-4, 1e3)
"""Smallest and largest size of K_A on its slider (rad/rad)."""
FEEDBACKS = ("total", "rigid body")
BRANCHES = {
    "attitude": COLORS["rigid"],
    "short period": COLORS["rigid"],
    "mode 1": COLORS["mode 1"],
    "mode 2": COLORS["mode 2"],
    "actuator": COLORS["actuator"],
}


def designs(section: str) -> dict[str, dict[str, Value]]:
    """Return the report's designs of one section: parameters by name of the design [data/designs.csv]."""
    found: dict[str, dict[str, Value]] = {}
    for row in read_table("designs"):
        if row["section"] == section:
            try:
                value: Value = float(row["value"])
            except ValueError:
                value = row["value"]
            found.setdefault(row["name"], {})[row["parameter"]] = value
    return found


def _grid(name: str, *places: ArrayLike) -> tuple[float, ...]:
    """Return a slider's places, rounded to three digits, and the values that the report's designs take."""
    rounded = [float(f"{place:.3g}") for place in np.hstack(places)]
    return tuple(np.union1d(rounded, [design[name] for design in designs("IV").values()]).tolist())


def _whole_station(name: str, value: object, where: str) -> int:
    station = checks.station(name, value, where)
    if station != int(station):
        raise ValueError(f"{name} in {where}: got station {station:g} ft, wanted a whole number of feet")
    return int(station)


def _feedback(name: str, value: object, where: str) -> str:
    return checks.one_of(name, value, FEEDBACKS, where)


def parameters() -> tuple[Parameter, ...]:
    """Return the parameters of Section IV with the places of their sliders."""
    size = np.geomspace(*MAGNITUDES, 281)
    grids = {
        "K_A": _grid("K_A", -size, 0.0, size),
        "K_C": _grid("K_C", np.geomspace(0.1, 100, 121)),
        "K_R": _grid("K_R", np.linspace(-1, 1, 201)),
    }
    return (
        Parameter("K_A", r"\(K_A\)", "", "K_A, amplifier gain (rad/rad)", grids["K_A"]),
        Parameter("K_C", r"\(K_C\)", "1/s", "K_C, actuator gain (1/s)", grids["K_C"]),
        Parameter("K_R", r"\(K_R\)", "s", "K_R, rate gyro gain (s)", grids["K_R"]),
        Parameter("gyro", "Gyro", "ft", "station of the gyro (ft)", tuple(range(421)), _whole_station),
        Parameter("feedback", "Feedback", "", "angle fed back", FEEDBACKS, _feedback),
    )


def form(eqs: PerturbationEquations) -> MultiAffine:
    """Return Section IV's characteristic polynomial in its gains and the slopes at the gyro [Eqs. 59, 83]."""

    def closed_loop(K_A: float, K_C: float, K_R: float, sigma_1: float, sigma_2: float) -> control.StateSpace:
        here = with_shapes(eqs, slopes={0.0: (sigma_1, sigma_2)})
        return rate_attitude(here, K_A=K_A, K_C=K_C, K_R=K_R, gyro=0.0)

    return multiaffine_form(closed_loop, ("K_A", "K_C", "K_R", "sigma_1", "sigma_2"))


def named_poles(eqs: PerturbationEquations) -> list[tuple[complex, str]]:
    """Return the vehicle's poles (1/s), each with the name of the uncoupled motion that it grows out of.

    The coupling between rigid body, mode 1 and mode 2 (the off-diagonal blocks
    of Eq. 29) is raised from nothing to its size.  The attitude is left out on
    the way: it is the integral of its rate, always a pole at the origin.
    """
    kept = [i for i, state in enumerate(STATES) if state != "theta"]
    A = eqs.state_space().A[np.ix_(kept, kept)]
    block = np.array([0, 0, 1, 1, 2, 2])
    own = block[:, None] == block
    on_the_way = [np.linalg.eigvals(np.where(own, A, share * A)) for share in np.linspace(0, 1, 401)]
    names = np.empty(6, dtype=object)
    for i, name in enumerate(("short period", "mode 1", "mode 2")):
        rows = block == i
        for pole in np.linalg.eigvals(A[np.ix_(rows, rows)]):
            names[np.abs(on_the_way[0] - pole).argmin()] = name
    poles = continuous_branches(np.array(on_the_way, dtype=complex))[-1]
    return [(0j, "attitude"), *zip(poles.tolist(), names.tolist(), strict=True)]


def rate_attitude_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section IV's control system.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float or str
        Where the sliders start: K_A (rad/rad), K_C (1/s), K_R (s), gyro (ft, whole),
        feedback ("total" or "rigid body"); what is not given is that of Figure 8.

    Returns
    -------
    Explorer
        Shows root locus, poles and pole map; its attributes are the parameters,
        ``closed_loop()`` is `rate_attitude` under the sliders.

    Raises
    ------
    ValueError
        If a gain is not finite, the gyro's station is not a whole number of feet
        on the vehicle, or the feedback is unknown.
    TypeError
        If a gain is not a real number or a parameter is unknown.

    Notes
    -----
    Figures 8 to 11, Eqs. 58, 59 and 83.
    """
    feet = np.arange(421.0)
    named = named_poles(eqs)
    presets = designs("IV")

    def closed_loop(K_A: float, K_C: float, K_R: float, gyro: int, feedback: str) -> control.StateSpace:
        seen = gyro if feedback == "total" else None
        return rate_attitude(eqs, K_A=K_A, K_C=K_C, K_R=K_R, gyro=seen)

    payload = {
        "shapes": {
            f"sigma_{i}": {"at": "gyro", "values": np.asarray(mode.slope(feet)).tolist()}
            for i, mode in enumerate(eqs.modes, start=1)
        },
        "choice": {"name": "feedback", "zero": {"total": [], "rigid body": ["sigma_1", "sigma_2"]}},
        "poles": [{"re": pole.real, "im": pole.imag, "branch": name} for pole, name in named],
        "actuators": [{"factor": "K_C", "branch": "actuator"}],
        "branches": BRANCHES,
        "locus": {"parameter": "K_A", "magnitudes": MAGNITUDES},
        "map": {"parameter": "gyro", "ends": [0, 420], "step": 10, "unit": "ft"},
        "presets": [{"name": name, "values": design} for name, design in presets.items()],
    }
    start = {**presets["Figure 8"], **values}
    return Explorer(SYSTEM, parameters(), form(eqs), payload, closed_loop, start)
