"""The vehicle, its mode shapes and its equations refuse bad data; they clip nothing and return no nan."""

from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest

import rlswaim as rl
from bad_input import NOT_FINITE, NOT_NUMBERS, OFF_THE_VEHICLE, cases, refused
from rlswaim.vehicle import coupling


@pytest.fixture(scope="module")
def eqs():
    return rl.printed_equations()


POSITIVE = ("M", "I_y", "S", "l_G")


@pytest.mark.parametrize("field", [*POSITIVE, "l_CG", "T"])
@pytest.mark.parametrize("bad", cases(NOT_NUMBERS))
def test_a_datum_must_be_a_number(field, bad):
    refused(TypeError, lambda: replace(rl.swaim_booster(), **{field: bad}), field)


@pytest.mark.parametrize("field", [*POSITIVE, "l_CG", "T"])
@pytest.mark.parametrize("bad", cases(NOT_FINITE))
def test_a_datum_must_be_finite(field, bad):
    refused(ValueError, lambda: replace(rl.swaim_booster(), **{field: bad}), field)


@pytest.mark.parametrize("field", POSITIVE)
@pytest.mark.parametrize("bad", [0, -1.0])
def test_masses_inertia_and_lengths_must_be_positive(field, bad):
    refused(ValueError, lambda: replace(rl.swaim_booster(), **{field: bad}), field, "above 0")


def test_thrust_may_be_zero_but_not_negative():
    assert replace(rl.swaim_booster(), T=0).T == 0
    refused(ValueError, lambda: replace(rl.swaim_booster(), T=-1.0), "T")


@pytest.mark.parametrize("bad", [-5.0, 0.0])
def test_each_concentrated_mass_must_be_positive(bad):
    masses = rl.swaim_booster().masses.copy()
    masses[3] = bad
    refused(ValueError, lambda: replace(rl.swaim_booster(), masses=masses), "masses[3]")


def test_masses_and_stations_must_be_equally_many():
    refused(ValueError, lambda: replace(rl.swaim_booster(), masses=np.ones(10)), "masses", "(10,)", "(11,)")


@pytest.mark.parametrize(
    "change",
    [
        lambda x: x.put(3, x[2]),
        lambda x: x.put(3, 20.0),
        lambda x: x.put(0, -1.0),
        lambda x: x.put(10, 421.0),
    ],
    ids=["repeated", "falling", "ahead of the nose", "behind the thrust point"],
)
def test_stations_must_increase_along_the_vehicle(change):
    stations = rl.swaim_booster().stations.copy()
    change(stations)
    refused(ValueError, lambda: replace(rl.swaim_booster(), stations=stations), "stations")
    mode = rl.swaim_booster().modes[0]
    refused(ValueError, lambda: replace(mode, stations=np.append(stations, 420.5)), "stations")


@pytest.mark.parametrize(
    "bad", ["abc", np.array([1j] * 11), np.array([None] * 11)], ids=["text", "complex", "object"]
)
def test_arrays_must_hold_real_numbers(bad):
    refused(TypeError, lambda: replace(rl.swaim_booster(), masses=bad), "masses")


def test_the_thrust_point_must_lie_on_the_vehicle():
    refused(ValueError, lambda: replace(rl.swaim_booster(), l_G=131.0), "thrust point", "421 ft")


@pytest.mark.parametrize("count", [0, 1, 3])
def test_there_are_as_many_coefficients_as_the_modes_ask_for(eqs, count):
    modes = (rl.swaim_booster().modes * 2)[:count]
    refused(ValueError, lambda: replace(eqs, modes=modes), "coefficients", "name")


@pytest.mark.parametrize(
    ("field", "bad"),
    [("q_D", -1.0), ("U", 0.0), ("U", -1860.0), ("t", -1.0), ("h", np.nan), ("gamma_0", np.inf)],
)
def test_a_flight_condition_must_be_possible(field, bad):
    refused(ValueError, lambda: replace(rl.swaim_booster().flight, **{field: bad}), field, "FlightCondition")


@pytest.mark.parametrize(("field", "bad"), [("omega", 0.0), ("omega", -1.0), ("zeta", -0.01), ("mass", 0.0)])
def test_a_mode_must_be_possible(field, bad):
    refused(ValueError, lambda: replace(rl.swaim_booster().modes[1], **{field: bad}), field, "mode 2")


@pytest.mark.parametrize(("field", "size"), [("deflections", 11), ("slopes", 5)])
def test_a_mode_s_arrays_must_be_equally_long(field, size):
    refused(ValueError, lambda: replace(rl.swaim_booster().modes[0], **{field: np.zeros(size)}), field)


@pytest.mark.parametrize(
    ("field", "bad"), [("modes", (None, None)), ("surfaces", ("fins",)), ("flight", 57.5)]
)
def test_a_part_must_be_of_its_kind(field, bad):
    refused(TypeError, lambda: replace(rl.swaim_booster(), **{field: bad}), field)


def test_a_surface_must_lie_on_the_vehicle():
    refused(ValueError, lambda: rl.Surface("fins", 421.0, 0.2), "station", "fins", "421 ft")


def test_an_unknown_field_is_a_type_error():
    with pytest.raises(TypeError, match="weight"):
        replace(rl.swaim_booster(), weight=1.0)


def test_the_vehicle_is_frozen_and_its_arrays_too():
    booster = rl.swaim_booster()
    with pytest.raises(FrozenInstanceError):
        booster.M = 1.0
    for array in (booster.masses, booster.stations, booster.modes[0].deflections, booster.modes[0].slopes):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0


@pytest.mark.parametrize("what", ["deflection", "slope"])
@pytest.mark.parametrize("bad", cases(OFF_THE_VEHICLE, NOT_FINITE))
def test_a_mode_has_no_shape_off_the_vehicle(what, bad):
    shape = getattr(rl.swaim_booster().modes[0], what)
    refused(ValueError, lambda: shape(bad), "station")
    refused(ValueError, lambda: shape([0.0, bad]), "station[1]")


@pytest.mark.parametrize("bad", ["27", 1j, None, True, ["nose"]])
def test_a_station_must_be_a_number(bad):
    refused(TypeError, lambda: rl.swaim_booster().modes[0].deflection(bad), "station")


@pytest.mark.parametrize("mode", [-1, 0, 3])
def test_a_sum_over_the_surfaces_is_of_a_mode_of_the_vehicle(mode):
    refused(ValueError, lambda: coupling.surface_sums(rl.swaim_booster(), mode), "mode", str(mode))


def test_no_mode_couples_with_nothing():
    rigid = rl.perturbation_equations(replace(rl.swaim_booster(), modes=()))
    refused(ValueError, lambda: coupling.partition(rigid), "modes")


def test_coefficients_must_be_the_report_s_28(eqs):
    missing = {name: value for name, value in eqs.coefficients.items() if name != "M_q2"}
    refused(ValueError, lambda: replace(eqs, coefficients=missing), "M_q2")
    refused(ValueError, lambda: replace(eqs, coefficients={**eqs.coefficients, "M_q3": 0.0}), "M_q3")


@pytest.mark.parametrize(
    ("bad", "error"), [(np.nan, ValueError), ("1", TypeError), (1j, TypeError), (None, TypeError)]
)
def test_a_coefficient_must_be_a_finite_number(eqs, bad, error):
    refused(error, lambda: replace(eqs, coefficients={**eqs.coefficients, "F1_q1": bad}), "F1_q1")


def test_coefficients_are_read_only(eqs):
    with pytest.raises(TypeError):
        eqs.coefficients["M_alpha"] = 0.0


@pytest.mark.parametrize("bad", ["thetta", "", None, 1])
def test_unknown_signals_are_named(eqs, bad):
    refused(ValueError, lambda: eqs.numerator(bad, "delta"), "output", "alpha, theta, q1, q2")
    refused(ValueError, lambda: eqs.numerator("theta", bad), "input", "delta, delta_r, alpha_g")


@pytest.mark.parametrize("bad", cases(OFF_THE_VEHICLE, NOT_FINITE))
def test_a_jet_must_be_on_the_vehicle(eqs, bad):
    refused(ValueError, lambda: eqs.state_space(jet=bad), "jet")
    refused(ValueError, lambda: eqs.numerator("q1", "delta_r", jet=bad), "jet")
