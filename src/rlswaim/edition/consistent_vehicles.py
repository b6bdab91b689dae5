"""What of Section III would be left if the vehicle's data were consistent: other modes, other flight."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd

from rlswaim.loops.certificates import stability_certificate
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.booster import Booster, FlightCondition
from rlswaim.vehicle.coupling import doubling_time, partition
from rlswaim.vehicle.equations import perturbation_equations
from rlswaim.vehicle.trajectory import (
    Ascent,
    PitchProgram,
    Trajectory,
    closed_form,
    dynamic_pressure,
    fly,
    speed_for,
)


def flight_conditions(
    booster: Booster, ascent: Ascent, gamma_0: PitchProgram
) -> Mapping[str, FlightCondition]:
    """Return the printed flight condition and those that agree with the air and with the path of flight.

    Parameters
    ----------
    booster : Booster
        Its flight condition is the printed one.
    ascent : Ascent
    gamma_0 : callable
        Pitch program of the flown ones: flight path angle (rad) at time (s).
    """
    printed = booster.flight
    t, U, h = printed.t, printed.U, printed.h

    def in_the_air(t: float, U: float, h: float) -> FlightCondition:
        return FlightCondition(float(dynamic_pressure(h, U)[0]), U, h, t, gamma_0(t))

    def flown(path: Trajectory, t: float) -> FlightCondition:
        at = path.at(t)
        return in_the_air(t, at["U"], at["h"])

    times = np.arange(0, ascent.t_burn, 0.05)
    integrated, closed = fly(ascent, gamma_0, times), closed_form(ascent, gamma_0, times)
    sines = ascent.mean_sine_for_speed(t, U), ascent.mean_sine_for_altitude(t, h)
    return {
        "printed": printed,
        "q_D from the printed U and h": in_the_air(t, U, h),
        "U from the printed q_D and h": replace(printed, U=speed_for(printed.q_D, h)),
        "Eqs. 32, 37, mean sine of the printed U": in_the_air(t, U, float(ascent.altitude(t, sines[0]))),
        "Eqs. 32, 37, mean sine of the printed h": in_the_air(t, float(ascent.speed(t, sines[1])), h),
        "Eqs. 32, 37, assumed program": flown(closed, t),
        "integrated, assumed program": flown(integrated, t),
        "integrated, at its largest q_D": flown(integrated, integrated.peak[0]),
    }


def survey(boosters: Mapping[str, Booster]) -> pd.DataFrame:
    """Return what Sections III and IV find, for each of some ``boosters`` by name.

    Returns
    -------
    DataFrame
        Columns: one mode, both modes (largest real pole of the uncontrolled vehicle, 1/s), doubling (s,
        both modes), s^3, s^2, s (coupling over uncoupled part, with its sign), and margin (of
        `stability_certificate`, gyro at station 60: where it is negative, no gains stabilize).
    """
    rows = {}
    for name, booster in boosters.items():
        eqs = perturbation_equations(booster)
        one, both = (float(roots(eqs.characteristic_polynomial(n)).real.max()) for n in (3, 4))
        parts = partition(eqs)
        ratios = {f"s^{k}" if k > 1 else "s": parts.coupling[k] / parts.uncoupled[k] for k in (3, 2, 1)}
        proof = stability_certificate(eqs, 60.0).margin
        rows[name] = {"one mode": one, "both modes": both, "doubling": doubling_time(both)}
        rows[name] |= {name: float(ratio) for name, ratio in ratios.items()} | {"margin": proof}
    return pd.DataFrame.from_dict(rows, orient="index")
