"""The vehicle's formulas for modes of other sizes, sums written out, and which bad station is told."""

from dataclasses import replace

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.vehicle import coupling
from rlswaim.vehicle.equations import PerturbationEquations, with_reading
from rlswaim.vehicle.stations import as_stations, increasing_stations

BOOSTER = rl.swaim_booster()


def with_first_shape_times(factor):
    """Return the booster with another size of its first mode, which then is not 1 at the thrust point."""
    first, second = BOOSTER.modes
    first = replace(first, deflections=factor * first.deflections, slopes=factor * first.slopes)
    return replace(BOOSTER, modes=(first, second))


@pytest.mark.parametrize("factor", [1.5, -0.7])
def test_eq_52_holds_for_a_first_mode_of_any_size(factor):
    booster = with_first_shape_times(factor)
    exact = coupling.partition(rl.perturbation_equations(booster)).coupling_undivided[1:4]
    np.testing.assert_allclose(coupling.literal_coupling(booster), exact, rtol=1e-3)


@pytest.mark.parametrize("mode", [1, 2])
def test_surface_sums_are_the_sums_written_out(mode):
    """The payload's surface stands at 27 ft, the fins at 407 ft."""
    shape, (front, back) = BOOSTER.modes[mode - 1], BOOSTER.surfaces
    found = coupling.surface_sums(BOOSTER, mode)
    phi = [shape.deflection(s.station) for s in (front, back)]
    sigma = [shape.slope(s.station) for s in (front, back)]
    C, arm = (front.C_Nalpha, back.C_Nalpha), (BOOSTER.l_CG - 27, BOOSTER.l_CG - 407)
    assert found == pytest.approx(
        {
            "phi": C[0] * phi[0] + C[1] * phi[1],
            "phi_l": C[0] * phi[0] * 27 + C[1] * phi[1] * 407,
            "phi_arm": C[0] * phi[0] * arm[0] + C[1] * phi[1] * arm[1],
            "sigma": C[0] * sigma[0] + C[1] * sigma[1],
            "sigma_arm": C[0] * sigma[0] * arm[0] + C[1] * sigma[1] * arm[1],
            "arm": C[0] * arm[0] + C[1] * arm[1],
        }
    )


def test_equations_without_a_weight_across_the_path_have_none():
    given = rl.printed_equations()
    parts = {name: getattr(given, name) for name in ("coefficients", "U", "jet", "l_CG", "modes")}
    assert PerturbationEquations(**parts, source="here").gravity == 0


def test_the_first_station_off_the_vehicle_is_told():
    with pytest.raises(ValueError, match=r"x\[1\] in here: got station 421 ft"):
        as_stations("x", [0.0, 421.0, 10.0, -3.0], "here")


def test_the_first_station_out_of_order_is_told():
    with pytest.raises(ValueError, match=r"x in here: got x\[2\] = 4 ft after 5 ft"):
        increasing_stations("x", [0.0, 5.0, 4.0, 3.0], "here")


def test_a_reading_wants_a_deflection_of_each_mode():
    with pytest.raises(ValueError, match="shorter"):
        with_reading(rl.printed_equations(), 60.0, [1.0])
