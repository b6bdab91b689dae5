"""The live view of somebody else's vehicle: Greensite's loop on the workbench of Sections IV to VII.

The characteristic polynomial is affine in each gain, as actuator, delay and notch are fixed polynomials.
The frequency of the mode enters by itself and by its square, as a station enters by the mode shapes there.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from rlswaim.explorers.criteria_card import told_card
from rlswaim.explorers.parameter import Parameter, Value
from rlswaim.explorers.workbench import Explorer
from rlswaim.figures.style import COLORS
from rlswaim.loops.family import Family
from rlswaim.loops.multiaffine import Forms, MultiAffine, forms
from rlswaim.practice import criteria
from rlswaim.practice.agreement import RIGID, WITH_NOTCH, unrounded_gains
from rlswaim.practice.greensite import closed_loop, greensite, judged, vehicle, wanted_in_metres
from rlswaim.source import checks
from rlswaim.source.tables import constants

PERCENT = tuple(range(80, 121))
"""Places of the slider of the mode's frequency, in percent of its own."""
GAINS: dict[str, tuple[str, str, str, float, float, bool]] = {
    "K_p": ("K_p", "", "gain of the pitch angle (rad/rad)", 1e-2, 1e2, True),
    "K_d": ("K_d", "s", "gain of the pitch rate (s)", 1e-2, 1e2, True),
    "K_z": ("K_z", "rad/m", "gain of the drift (rad/m)", 1e-5, 1e-1, True),
    "K_zdot": (r"K_{\dot z}", "rad s/m", "gain of the drift rate (rad s/m)", 1e-5, 1e-1, True),
    "k": ("k", "", "factor of all gains", 1e-2, 1e2, False),
}
"""Symbol (TeX), unit, meaning, smallest and largest size, and whether of both signs."""
UNITS = {"z": "m", "theta": "rad", "eta": "m", "delta": "rad"}
BRANCHES = {
    "drift": COLORS["jet"],
    "pitch": COLORS["rigid"],
    "mode 1": COLORS["mode 1"],
    "actuator": COLORS["actuator"],
    "delay": COLORS["neutral"],
    "notch": COLORS["corrected"],
}

UNKNOWN = (
    "Nothing commands the pitch angle here, so nothing settles. Masses along the vehicle are not known, so "
    "neither is its bending moment."
)
"""What the card of criteria cannot tell of this vehicle."""


def family(notch: bool) -> Family:
    """Return the closed loops of Greensite's vehicle, with or without the ``notch``, as one family.

    Returns
    -------
    Family
        Factors: the gains, ``omega_1`` and ``omega_2``, the factor of the mode's frequency and its square.
    """
    gains = [name for name in GAINS if name != "k"]
    found = Family.of(
        lambda **factors: closed_loop(notch=notch, **factors),
        [(name, "k") for name in gains],
        tolerance=1e-12,
    )
    spring, damper = (found.states.index(f"vehicle_x_{state}") for state in ("eta", "etadot"))
    fixed, terms = found.terms[()].copy(), dict(found.terms)
    for factor, column in (("omega_2", spring), ("omega_1", damper)):
        alone = 0 * fixed
        alone[damper, column], fixed[damper, column] = fixed[damper, column], 0
        terms[factor,] = alone
    return replace(found, factors=(*found.factors, "omega_1", "omega_2"), terms={**terms, (): fixed})


def _sent(form: MultiAffine) -> list[dict[str, Any]]:
    return [term._asdict() for term in form.terms]


def open_poles(notch: bool) -> list[dict[str, Any]]:
    """Return the open loop's poles (1/s) with their branches; the mode's go with its frequency.

    Parameters
    ----------
    notch : bool
    """
    rigid = vehicle(bending=False).poles()
    named = [(p, "drift" if abs(p) < 0.5 else "pitch") for p in rigid]
    bent = [p for p in vehicle().poles() if abs(p) > 10]
    rest = [p for p in greensite(K_p=0.0, K_d=0.0, notch=notch).poles() if abs(p) > 10]
    for p in bent:
        rest.remove(min(rest, key=lambda other: abs(other - p)))
    kinds = [("notch", 2 * notch), ("actuator", 2), ("delay", 3)]
    names = [name for name, count in kinds for _ in range(count)]
    named += list(zip(sorted(rest, key=abs), names, strict=True))
    each = {"at": "omega", "each": [place / 100 for place in range(201)]}
    found = [{"re": p.real, "im": p.imag, "branch": name} for p, name in named]
    return found + [{"re": p.real, "im": p.imag, "branch": "mode 1", **each} for p in bent]


def _percent(name: str, value: object, where: str) -> int:
    number = checks.real(name, value, where)
    if number != int(number) or not PERCENT[0] <= number <= PERCENT[-1]:
        raise ValueError(f"{name} in {where}: got {number:g} %, wanted a whole number from 80 to 120")
    return int(number)


def parameters() -> tuple[Parameter, ...]:
    """Return the sliders: the four gains, the loop gain, and the mode's frequency in percent."""
    known = presets()
    found = []
    for name, (symbol, unit, meaning, least, most, signed) in GAINS.items():
        size = np.geomspace(least, most, 121)
        places = [*-size, 0.0, *size] if signed else list(size)
        rounded = [float(f"{place:.3g}") for place in places]
        grid = np.union1d(rounded, [preset["values"][name] for preset in known])
        found.append(Parameter(name, rf"\({symbol}\)", unit, f"{name}, {meaning}", tuple(grid.tolist())))
    what = "frequency of the bending mode, in percent of its own; the notch stays"
    return (*found, Parameter("omega", r"\(\omega\)", "%", what, PERCENT, _percent))


def presets() -> list[dict[str, Any]]:
    """Return the printed designs, and the one whose margins come out exactly, as values of the sliders."""
    drift = {"K_z": -1e-3, "K_zdot": -1e-3, "k": 1.0, "omega": 100}
    with_notch = {"K_p": WITH_NOTCH["K_p"], "K_d": WITH_NOTCH["K_d"], **drift}
    exact = {name: round(gain, 4) for name, gain in unrounded_gains().items()}
    cases = [
        ("As printed", "the printed gains for the loop with notch", with_notch),
        ("6 dB and 30°", "gains that round to the printed ones", {**exact, **drift}),
        ("Mode 5 % up", "the mode's frequency above the notch's", {**with_notch, "omega": 105}),
        ("Rigid gains", "the gains of the rigid case", {"K_p": RIGID["K_p"], "K_d": RIGID["K_d"], **drift}),
        ("No drift control", "pitch alone", {**with_notch, "K_z": 0.0, "K_zdot": 0.0}),
    ]
    return [
        {"name": name, "label": label, "values": values, "locus": 0, "printed": [], "note": ""}
        for name, label, values in cases
    ]


def sent_criteria() -> dict[str, Any]:
    """Return what the browser evaluates the criteria from, in m/s."""
    c, units = constants("greensite"), {**criteria.UNITS, "drift_m_s": "m/s"}
    terms: dict[str, list[tuple[str, int, float, tuple[str, ...]]]] = {
        "alpha_deg": [("theta", 0, 1.0, ()), ("z", 1, 1 / c["V"], ()), ("alpha_w", 0, -1.0, ())],
        "delta_deg": [("delta", 0, 1.0, ())],
        "delta_rate_deg_s": [("delta", 1, 1.0, ())],
        "drift_m_s": [("z", 1, 1.0, ())],
    }
    factors = {name: factor for name, (_, factor) in criteria.GUST_PEAKS.items()} | {"drift_m_s": 1.0}
    peaks: list[dict[str, Any]] = [
        {"name": name, "terms": sums, "factor": factors[name], "unit": units[name]}
        for name, sums in terms.items()
    ]
    return {
        **told_card(peaks, UNKNOWN, "alpha_w", "m/s"),
        "wanted": wanted_in_metres(criteria.wanted()),
        "engine": ["k"],
        "modes": {"bending 1": ("omega", c["omega"] / 100)},
        "speed": c["V"],
    }


def payload(notch: bool, found: Forms) -> dict[str, Any]:
    """Return what the browser gets.

    Parameters
    ----------
    notch : bool
    found : Forms
        Of `family` with the same notch.
    """
    places = [place / 100 for place in range(201)]
    values = {"omega_1": places, "omega_2": [place**2 for place in places]}
    gains = {n: {"magnitudes": [least, most], "signed": s} for n, (*_, least, most, s) in GAINS.items()}
    return {
        "terms": _sent(found.polynomial),
        "numerators": {i: {o: _sent(f) for o, f in by.items()} for i, by in found.numerators.items()},
        "units": UNITS,
        "shapes": {name: {"at": "omega", "values": table} for name, table in values.items()},
        "choice": None,
        "poles": open_poles(notch),
        "actuators": [],
        "branches": BRANCHES,
        "locus_gains": [name for name in reversed(GAINS) if name != "k"],
        "loci": [{"name": "all gains", "running": "k", "off": [], "of": "poles"}],
        "running": {**gains, "omega": {"ends": [PERCENT[0], PERCENT[-1]], "step": 1, "unit": "%"}},
        "maps": ["omega"],
        "vehicle": None,
        "criteria": sent_criteria(),
        "reach": 30.0,
        "presets": presets(),
        "python": {
            "module": closed_loop.__module__,
            "function": closed_loop.__name__,
            "arguments": {name: name for name in (*GAINS, "omega")},
            "over": {"omega": [100]},
        },
    }


def greensite_explorer(notch: bool = True, **values: Value) -> Explorer:
    """Return the live view of Greensite's vehicle, on the workbench of Sections IV to VII.

    Parameters
    ----------
    notch : bool
        Whether the notch is in the loop.
    **values : float
        Where the sliders start: K_p, K_d (s), K_z (rad/m), K_zdot (rad s/m), k, omega (percent of
        the mode's own frequency, whole).

    Returns
    -------
    Explorer
        ``closed_loop()`` is that of `rlswaim.practice.greensite` under the sliders.

    Raises
    ------
    ValueError
        If a value is not finite or out of range.
    TypeError
        If a value is not of its kind or a parameter is unknown, or ``notch`` is no bool.
    """
    checks.instance("notch", notch, bool, "greensite explorer")
    sent = payload(notch, forms(family(notch), tuple(UNITS)))

    def loop(omega: float, **gains: float) -> Any:
        return closed_loop(notch=notch, omega=omega / 100, **gains)

    def criteria_at(values: Mapping[str, Any]) -> tuple[criteria.Criterion, ...]:
        return judged(**{**values, "omega": values["omega"] / 100}, notch=notch)

    start = {**sent["presets"][0]["values"], **values}
    return Explorer("greensite", parameters(), sent, loop, start, criteria_at)
