"""Section II: mass and mode tables, flight condition [Tables 1, 2, Figures 3, 4]."""

import numpy as np

from rlswaim.source.tables import constants, printed
from rlswaim.vehicle.booster import Booster, swaim_booster
from rlswaim.vehicle.modes import generalized_mass, translation_product
from rlswaim.vehicle.trajectory import dynamic_pressure, fly, level_at_burnout, swaim_ascent


def printed_sum(start: str) -> float:
    """Return the sum of the printed cells of ``data/printed.csv`` whose ids start so."""
    return sum(printed("II", start).values())


def _tables(booster: Booster) -> dict[str, float]:
    """Return every cell and sum of Tables 1 and 2; a sum is that of the printed cells."""
    m, arms = booster.masses, booster.arms
    columns = {"tab1-m": m, "tab1-arm": arms, "tab1-I_y": m * arms**2}
    read: dict[str, float] = {}
    for i, mode in enumerate(booster.modes, start=1):
        columns[f"tab2-mass_{i}"] = m * np.asarray(mode.deflection(booster.stations)) ** 2
        stations = (*booster.stations, booster.thrust_station)
        read |= {f"tab2-phi_{i}-{x:g}": float(mode.deflection(x)) for x in stations}
        read |= {f"tab2-sigma_{i}-{x:g}": float(mode.slope(x)) for x in stations}
    cells = {
        f"{name}-{x:g}": value
        for name, values in columns.items()
        for x, value in zip(booster.stations, values, strict=True)
    }
    sums = {name: printed_sum(f"{name}-") for name in ("tab1-I_y", "tab2-mass_1", "tab2-mass_2")}
    return cells | sums | read | {"tab1-M": m.sum(), "tab1-l_CG": booster.recomputed().l_CG}


def _data() -> dict[str, float]:
    """Return data of the text, and two masses that confirm Table 1 with our g."""
    booster, ascent, data = swaim_booster(), swaim_ascent(), constants("vehicle")
    named = {name: data[name] for name in ("W_0", "W_burnout", "t_burn", "T", "S")}
    named |= {f"C_Nalpha-{surface.name}": surface.C_Nalpha for surface in booster.surfaces}
    named |= {f"omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    named["payload"] = float(booster.masses[0] * ascent.g)
    named["M"] = ascent.M_0 - ascent.m_p * booster.flight.t
    named["m_p"] = (data["W_0"] - data["W_burnout"]) / data["g"] / data["t_burn"]
    return {f"sec2-{name}": value for name, value in named.items()}


def computed() -> dict[str, float]:
    """Return our number for each row of section II of ``data/printed.csv``, by its id."""
    booster, ascent = swaim_booster(), swaim_ascent()
    phi = [np.asarray(mode.deflection(booster.stations)) for mode in booster.modes]
    flown = fly(ascent, level_at_burnout(ascent), np.arange(0, ascent.t_burn, 0.05))
    at = flown.at(booster.flight.t)
    numbers = _data() | _tables(booster)
    return numbers | {
        "sec2-translation_1": translation_product(booster.masses, phi[0]),
        "sec2-translation_2": translation_product(booster.masses, phi[1]),
        "sec2-orthogonality": generalized_mass(booster.masses, *phi),
        "fig3-q_D": float(dynamic_pressure(booster.flight.h, booster.flight.U)[0]),
        "fig3-t": flown.peak[0],
        "fig4-U": at["U"],
        "fig3-h": at["h"],
    }
