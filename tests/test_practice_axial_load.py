"""The compression of the body by the thrust: against its integral mass by mass, and for a mere rotation."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

import rlswaim as rl
from rlswaim.practice.axial_load import axial_stiffness, with_axial_load

BOOSTER = rl.swaim_booster()
PRINTED = rl.printed_equations()


def turning(booster):
    """Return the booster with a first mode that is rotation about the center of gravity alone."""
    first = booster.modes[0]
    x = first.stations
    shape = replace(first, deflections=booster.l_CG - x, slope_stations=x[:2], slopes=np.ones(2))
    return replace(booster, modes=(shape, booster.modes[1]))


def product_aft(one, other, start):
    """Return the integral of the product of two modes' slopes from a station to the tail."""
    knots = np.union1d(one.stations, other.stations)
    inside = knots[(knots > start) & (knots < 420)]
    return quad(lambda x: one.slope(x) * other.slope(x), start, 420, points=inside, limit=200)[0]


def test_each_mass_presses_what_lies_aft_of_it():
    """The same integral the other way round: the sum over masses of T m/M times the integral aft of each."""
    weights = BOOSTER.T * BOOSTER.masses / BOOSTER.masses.sum()
    for i, j in np.ndindex(2, 2):
        one, other = BOOSTER.modes[i], BOOSTER.modes[j]
        aft = [product_aft(one, other, at) for at in BOOSTER.stations]
        wanted = -weights @ aft / one.mass
        assert axial_stiffness(BOOSTER)[i, j] == pytest.approx(wanted, rel=1e-5)


def test_turning_the_body_bends_nothing():
    """The compression and the turned thrust of Eq. 29 cancel for a shape that is a rotation."""
    booster = turning(BOOSTER.recomputed())
    first = booster.modes[0]
    G = booster.thrust_station
    thrust = -booster.T * first.slope(G) * first.deflection(G) / first.mass
    assert thrust > 0
    assert axial_stiffness(booster)[0, 0] == pytest.approx(-thrust, rel=1e-9)


def test_the_axial_load_changes_the_bending_stiffness_alone():
    loaded = with_axial_load(PRINTED, BOOSTER)
    changed = {name for name, value in PRINTED.coefficients.items() if loaded.coefficients[name] != value}
    assert changed == {"F1_q1", "F1_q2", "F2_q1", "F2_q2"}
    assert loaded.coefficients["F1_q1"] == pytest.approx(0.312 - 1.657, abs=1e-3)
    assert loaded.coefficients["F2_q2"] == pytest.approx(8.181 - 3.661, abs=1e-3)


def test_without_thrust_there_is_no_axial_load():
    assert not axial_stiffness(replace(BOOSTER, T=0.0)).any()


def test_bad_input():
    with pytest.raises(TypeError, match="booster in axial_stiffness: got"):
        axial_stiffness(PRINTED)
    with pytest.raises(TypeError, match="eqs in with_axial_load: got"):
        with_axial_load(BOOSTER, BOOSTER)
    one = replace(BOOSTER, modes=BOOSTER.modes[:1])
    with pytest.raises(ValueError, match="modes in with_axial_load: got 1 of the booster, wanted 2"):
        with_axial_load(PRINTED, one)
