"""Vehicles that differ from the nominal one as the data may be wrong: frequency, damping, shape, air, mass.

The spreads stand in ``data/dispersions.csv``.  Each draw has a seed of its own, so the first hundred of many
draws are those of a hundred.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from rlswaim.source import checks
from rlswaim.source.tables import number, read_table
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations

SEED = 1964


@cache
def consistent_booster(last_first: bool = False) -> Booster:
    """Return the report's booster with its totals summed and its modes orthogonal.

    Its forces balance, so that bending moments along it mean something.

    Parameters
    ----------
    last_first : bool
        As in `Booster.orthogonalized`: which mode keeps its part along the other.
    """
    return swaim_booster().recomputed().orthogonalized(last_first=last_first)


@lru_cache(maxsize=8)
def with_gravity(booster: Booster) -> PerturbationEquations:
    """Return the equations of a ``booster`` with the weight across its path."""
    return perturbation_equations(booster, gravity=True)


def vehicles() -> dict[str, Booster]:
    """Return the three vehicles that the report's data allow: its own, and two with orthogonal modes."""
    return {
        "consistent": consistent_booster(),
        "consistent, second mode first": consistent_booster(last_first=True),
        "the report's": swaim_booster(),
    }


def dispersed(booster: Booster, factors: Mapping[str, float]) -> Booster:
    """Return a booster with some of its data multiplied.

    Parameters
    ----------
    booster : Booster
    factors : mapping of str to float
        By the names of ``data/dispersions.csv``; what is left out is 1.

    Returns
    -------
    Booster

    Raises
    ------
    ValueError
        If a name is unknown, or the booster that would come out is none.
    """
    for name in factors:
        checks.one_of("factor", name, factor_names(), "dispersed")
    f = dict.fromkeys(factor_names(), 1.0) | dict(factors)
    modes = tuple(
        replace(
            mode,
            omega=mode.omega * f[f"omega_{i}"],
            zeta=mode.zeta * f[f"zeta_{i}"],
            mass=mode.mass * f["mass"],
            deflections=mode.deflections * f[f"shape_{i}"],
            slopes=mode.slopes * f[f"shape_{i}"],
        )
        for i, mode in enumerate(booster.modes, start=1)
    )
    surfaces = tuple(
        replace(one, C_Nalpha=one.C_Nalpha * f[f"lift_{i}"])
        for i, one in enumerate(booster.surfaces, start=1)
    )
    heavier = {name: getattr(booster, name) * f["mass"] for name in ("masses", "M", "I_y")}
    flight = replace(booster.flight, q_D=booster.flight.q_D * f["q_D"])
    return replace(
        booster, **heavier, T=booster.T * f["thrust"], modes=modes, surfaces=surfaces, flight=flight
    )


def factor_names() -> tuple[str, ...]:
    """Return the names of all factors, in the order of ``data/dispersions.csv``."""
    return tuple(row["factor"] for row in read_table("dispersions"))


def factors_at(d: NDArray) -> dict[str, float]:
    """Return the factors of a vehicle by name.

    Parameters
    ----------
    d : ndarray, shape (factors,)
        1 and -1 are the ends of each spread; larger values go on beyond.
    """
    found = {}
    for row, x in zip(read_table("dispersions"), d, strict=True):
        spread = number(row["spread"])
        found[row["factor"]] = float(spread**x if row["kind"] == "log" else 1 + spread * x)
    return found


def drawn(index: int, seed: int = SEED) -> dict[str, float]:
    """Return the factors of one draw.

    Parameters
    ----------
    index : int
        Its number, from 0.
    seed : int
        Of all draws.

    Returns
    -------
    dict of str to float
        Even between 1 - spread and 1 + spread, or in the logarithm between 1/spread and spread.
    """
    rng = np.random.default_rng([seed, index])
    return factors_at(rng.uniform(-1, 1, len(factor_names())))
