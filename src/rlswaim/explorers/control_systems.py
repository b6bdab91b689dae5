"""The live views of Sections IV to VII: what the browser gets of each, and the calls that show them."""

from functools import partial
from typing import Any

import control

from rlswaim.explorers.criteria_card import judged, sent_criteria
from rlswaim.explorers.parameter import FEET, Value
from rlswaim.explorers.presets import presets
from rlswaim.explorers.system_views import (
    DUAL_ACTUATION,
    RATE_ATTITUDE,
    SINGLE_SENSOR,
    TWO_SENSOR,
    View,
)
from rlswaim.explorers.vehicle_sliders import (
    data_parameters,
    data_values,
    dispersed_data,
    nodes,
    plant,
    vehicle_at,
)
from rlswaim.explorers.workbench import Explorer
from rlswaim.figures.style import COLORS
from rlswaim.loops.control_systems import AT_GYRO
from rlswaim.loops.multiaffine import MultiAffine
from rlswaim.loops.named_branches import named_poles
from rlswaim.source import checks
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations
from rlswaim.vehicle.stations import LENGTH

BRANCHES = {
    "attitude": COLORS["rigid"],
    "short period": COLORS["rigid"],
    "mode 1": COLORS["mode 1"],
    "mode 2": COLORS["mode 2"],
    "actuator": COLORS["actuator"],
}
UNITS = {"alpha": "rad", "theta": "rad", "q1": "ft", "q2": "ft", "delta": "rad", "delta_r": "lb"}


def payload(view: View, eqs: PerturbationEquations, polynomial: MultiAffine) -> dict[str, Any]:
    """Return what the browser gets of a control system; the sliders' values are traits of the widget.

    The numerators are not in it: the browser finds them from the matrices in ``plant``.

    Parameters
    ----------
    view : View
    eqs : PerturbationEquations
    polynomial : MultiAffine
        Of the view's system around ``eqs``.
    """
    parameters = (*view.parameters(eqs), *data_parameters())
    return {
        **loop_payload(view, eqs),
        "parameters": [p.told for p in parameters],
        "terms": [term._asdict() for term in polynomial.terms],
        "shapes": view.shape_values(eqs),
        "vehicle": _vehicle(eqs),
        "plant": plant(view.system, eqs),
        "dispersed": dispersed_data(),
        "criteria": sent_criteria(view.system, eqs),
    }


def loop_payload(view: View, eqs: PerturbationEquations) -> dict[str, Any]:
    """Return what the browser gets of a control system beside the vehicle in it.

    Parameters
    ----------
    view : View
    eqs : PerturbationEquations
        Their poles have names, and their designs are the presets.
    """
    jet = {"valve": COLORS["jet"]} if "K_r" in view.system.actuators else {}
    zeros = {"zero": COLORS["neutral"]} if any(locus["of"] == "zeros" for locus in view.loci) else {}
    return {
        "system": view.name,
        "units": {name: UNITS[name] for name in view.system.outputs},
        "choice": {"name": "feedback", "zero": {"total": [], "rigid body": list(AT_GYRO)}}
        if view.choice
        else None,
        "poles": [{"re": pole.real, "im": pole.imag, "branch": name} for pole, name in named_poles(eqs)],
        "actuators": [{"factor": factor, "branch": name} for factor, name in view.system.actuators.items()],
        "branches": {**BRANCHES, **jet, **zeros},
        "locus_gains": [locus["running"] for locus in view.loci if locus["of"] == "poles"],
        "loci": list(view.loci),
        "running": {
            **{n: {"magnitudes": [a, z], "signed": signed} for n, (a, z, signed) in view.gains.items()},
            **{
                station: {"ends": [FEET[0], FEET[-1]], "step": 5, "unit": "ft"}
                for station in view.system.stations
            },
        },
        "maps": list(view.system.stations),
        "presets": presets(view.section, eqs, view.loci),
        "python": {
            "function": view.system.function.__name__,
            "equations": _source(eqs),
            "arguments": {name: name for name in (*view.gains, *view.system.stations)},
            "none": {"gyro": {"feedback": "rigid body"}} if view.choice else {},
        },
    }


def _vehicle(eqs: PerturbationEquations) -> dict[str, Any]:
    """Return what a picture of the bent vehicle needs: stations (ft), speed (ft/s) and mode shapes."""
    return {
        **vehicle_scales(eqs),
        **{f"phi_{i + 1}": nodes(mode) for i, mode in enumerate(eqs.modes)},
    }


def vehicle_scales(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the vehicle's length, the places of thrust and center of gravity (ft), and its speed (ft/s)."""
    thrust = swaim_booster().thrust_station
    return {"length": LENGTH, "thrust": thrust, "l_CG": eqs.l_CG, "U": eqs.U}


def _source(eqs: PerturbationEquations) -> str:
    """Return the Python call that makes these equations, or ``eqs`` if the book has no such call."""
    if eqs.source == printed_equations().source:
        return "rl.printed_equations()"
    return "rl.perturbation_equations(rl.swaim_booster())" if eqs.source == swaim_booster().name else "eqs"


def _start(sent: dict[str, Any]) -> dict[str, Any]:
    """Return the preset that a view opens with: the first that closes the attitude loop."""
    return next(preset for preset in sent["presets"] if preset["values"]["K_A"])


def explorer(view: View, eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of a control system; values not given are those of its first closed attitude loop.

    Parameters
    ----------
    view : View
    eqs : PerturbationEquations
    **values : float or str
        Where the sliders start, by parameter.

    Returns
    -------
    Explorer
    """
    checks.instance("eqs", eqs, PerturbationEquations, f"{view.name} explorer")
    sent, loop = payload(view, eqs, view.system.polynomial(eqs)), partial(_closed_loop, view, eqs)
    return Explorer(
        view.name,
        (*view.parameters(eqs), *data_parameters()),
        sent,
        loop,
        {**_start(sent)["values"], **data_values(eqs), **values},
        partial(judged, view.system, eqs, loop),
    )


def _closed_loop(view: View, eqs: PerturbationEquations, **values: Any) -> control.StateSpace:
    """Return the closed loop at all of a view's sliders, the vehicle's among them."""
    vehicle = vehicle_at(eqs, values)
    return view.closed_loop(vehicle, **values)


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
        Its attributes are the parameters; ``closed_loop()`` is `rate_attitude` under the sliders.

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
    return explorer(RATE_ATTITUDE, eqs, **values)


def single_sensor_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section V's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, K_z (rad s/ft) and sensor (ft, whole); what is not given is that of Figure 16.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `single_sensor` under the sliders [Eqs. 98 to 110].
    """
    return explorer(SINGLE_SENSOR, eqs, **values)


def two_sensor_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section VI's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, K_za, K_zb (rad s/ft), sensor_a and sensor_b (ft, whole); what is not given
        is that of the book's search, as the report closes no attitude loop here.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `two_sensor` under the sliders [Eqs. 112 to 114].
    """
    return explorer(TWO_SENSOR, eqs, **values)


def dual_actuation_explorer(eqs: PerturbationEquations, **values: Value) -> Explorer:
    """Return the live view of Section VII's control system, as `rate_attitude_explorer`.

    Parameters
    ----------
    eqs : PerturbationEquations
    **values : float
        K_A, K_C, K_R, kK_z (lb s/ft), K_r, b (1/s), sensor and jet (ft, whole); what is not given
        is that of Figure 25.

    Returns
    -------
    Explorer
        ``closed_loop()`` is `dual_actuation` under the sliders [Eqs. 120 to 130].
    """
    return explorer(DUAL_ACTUATION, eqs, **values)
