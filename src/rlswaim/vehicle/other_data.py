"""The vehicle with other data than the report's: its frequencies, its surfaces, the pressure of the air."""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from rlswaim.source import checks
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations
from rlswaim.vehicle.modes import BendingMode


def own_data(booster: Booster) -> dict[str, float]:
    """Return what `with_data` can change, as it is: omega_<i>, q_D, C_<surface> and l_<surface>."""
    values = {f"omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    values["q_D"] = booster.flight.q_D
    for surface in booster.surfaces:
        values |= {f"C_{surface.name}": surface.C_Nalpha, f"l_{surface.name}": surface.station}
    return values


def with_data(booster: Booster, **data: float) -> Booster:
    """Return a booster with other data; what is not given stays.

    Parameters
    ----------
    booster : Booster
    **data : float
        omega_1, omega_2 and so on (rad/s), q_D (lb/ft^2), and of each surface C_<name> (1/rad) and
        l_<name> (ft).

    Raises
    ------
    TypeError
        If a name is unknown.
    ValueError
        If a number makes no vehicle.
    """
    own = own_data(booster)
    for name in data:
        if name not in own:
            raise TypeError(f"with_data: got an unknown {name!r}, wanted {', '.join(own)}")
    given = own | data
    modes = tuple(_tuned(mode, given[f"omega_{i}"]) for i, mode in enumerate(booster.modes, start=1))
    surfaces = tuple(
        replace(s, C_Nalpha=given[f"C_{s.name}"], station=given[f"l_{s.name}"]) for s in booster.surfaces
    )
    return replace(booster, modes=modes, surfaces=surfaces, flight=replace(booster.flight, q_D=given["q_D"]))


@lru_cache(maxsize=512)
def _tuned(mode: BendingMode, omega: float) -> BendingMode:
    """Return the mode at another frequency (rad/s); kept, since its curve is costly."""
    return replace(mode, omega=omega)


def with_other_data(
    eqs: PerturbationEquations, *, gravity: bool | None = None, **data: float
) -> PerturbationEquations:
    """Return the report's equations for other data, each coefficient moved by as much as its formula.

    So the printed equations keep their rounded numbers where nothing changes, and equations from the data
    are those of the changed vehicle.

    Parameters
    ----------
    eqs : PerturbationEquations
        `printed_equations`, or `perturbation_equations` of `swaim_booster`.
    gravity : bool, optional
        Keep Eq. 1's weight across the path, or leave it out as Eq. 29 does; without it, as it is.
    **data : float
        As in `with_data`.

    Returns
    -------
    PerturbationEquations

    Raises
    ------
    TypeError
        If a name is unknown.
    ValueError
        If a number makes no vehicle.
    """
    checks.instance("eqs", eqs, PerturbationEquations, "with_other_data")
    booster = swaim_booster()
    weight = {None: eqs.gravity, True: booster.flight.weight_across, False: 0.0}[gravity]
    changed = with_data(booster, **data)
    before, after = (perturbation_equations(vehicle).coefficients for vehicle in (booster, changed))
    return replace(eqs, coefficients=_moved(eqs.coefficients, before, after), gravity=weight)


def _moved(
    own: Mapping[str, float], before: Mapping[str, float], after: Mapping[str, float]
) -> dict[str, float]:
    return {name: value + (after[name] - before[name]) for name, value in own.items()}
