"""Bad input is refused with what, where, got and wanted; nothing is clipped and nothing passes as nan."""

from dataclasses import FrozenInstanceError, replace

import control
import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import conclusions, conditioning, printed_closures, robustness, table_3, table_3_readings
from rlswaim.loops import certificates, closed_loops, closures, named_branches, transfer_functions
from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.vehicle import coupling
from rlswaim.vehicle.equations import with_reading
from systems import LOOPS, closed_loop

NOT_NUMBERS = {
    "text": "1.0",
    "complex": 1 + 0j,
    "None": None,
    "bool": True,
    "list": [1.0],
    "array": np.array([1.0, 2.0]),
    "numpy bool": np.bool_(False),
}
NOT_FINITE = {"nan": np.nan, "inf": np.inf, "-inf": -np.inf, "numpy nan": np.float64("nan")}
OFF_THE_VEHICLE = {"ahead of the nose": -1, "behind the thrust point": 421, "just outside": 420.0001}
STATION_NAMES = ("gyro", "sensor", "sensor_a", "sensor_b", "jet")


@pytest.fixture(scope="module")
def eqs():
    return rl.printed_equations()


def refused(error, call, *words):
    """Check that a call is refused, and that the message has each word, what was got and what was wanted."""
    with pytest.raises(error) as caught:
        call()
    message = str(caught.value)
    for word in (*words, "got", "wanted"):
        assert word in message, f"{word!r} is missing in: {message}"


def cases(*tables):
    """Return the rows of the tables as pytest parameters with readable ids."""
    return [pytest.param(value, id=name) for table in tables for name, value in table.items()]


# ---- the control systems

PAIRS = [(name, argument) for name in LOOPS for argument in LOOPS[name]]
ARGUMENTS = [pytest.param(*pair, id="-".join(pair)) for pair in PAIRS]
STATIONS = [pytest.param(*pair, id="-".join(pair)) for pair in PAIRS if pair[1] in STATION_NAMES]


@pytest.mark.parametrize("bad", cases(NOT_NUMBERS))
@pytest.mark.parametrize(("name", "argument"), ARGUMENTS)
def test_an_argument_must_be_a_number(eqs, name, argument, bad):
    if argument == "gyro" and bad is None:
        assert closed_loop(name, eqs, gyro=None).nstates == 8  # the one place where None means something
        return
    refused(TypeError, lambda: closed_loop(name, eqs, **{argument: bad}), argument, name)


@pytest.mark.parametrize("bad", cases(NOT_FINITE))
@pytest.mark.parametrize(("name", "argument"), ARGUMENTS)
def test_an_argument_must_be_finite(eqs, name, argument, bad):
    refused(ValueError, lambda: closed_loop(name, eqs, **{argument: bad}), argument, name)


@pytest.mark.parametrize("bad", cases(OFF_THE_VEHICLE))
@pytest.mark.parametrize(("name", "argument"), STATIONS)
def test_a_station_must_lie_on_the_vehicle(eqs, name, argument, bad):
    words = argument, name, f"{bad:g} ft", "0 to 420 ft"
    refused(ValueError, lambda: closed_loop(name, eqs, **{argument: bad}), *words)


@pytest.mark.parametrize("name", LOOPS)
def test_an_unknown_or_missing_argument_is_a_type_error(eqs, name):
    with pytest.raises(TypeError, match="K_Q"):
        closed_loop(name, eqs, K_Q=1.0)
    with pytest.raises(TypeError, match="K_A"):
        getattr(rl, name)(eqs, **{key: value for key, value in LOOPS[name].items() if key != "K_A"})


@pytest.mark.parametrize(
    "bad", [None, "printed", 1.0, rl.swaim_booster()], ids=["None", "text", "number", "booster"]
)
def test_the_equations_must_be_equations(bad):
    for name in LOOPS:
        refused(TypeError, lambda name=name: closed_loop(name, bad), "eqs", name, "PerturbationEquations")
    if not isinstance(bad, rl.Booster):
        refused(
            TypeError, lambda: rl.perturbation_equations(bad), "booster", "perturbation_equations", "Booster"
        )


@pytest.mark.parametrize("name", LOOPS)
def test_gains_are_given_by_name(eqs, name):
    with pytest.raises(TypeError, match="positional"):
        getattr(rl, name)(eqs, *LOOPS[name].values())


@pytest.mark.parametrize(
    "good", [2, np.int64(2), np.float32(2), np.array(2.0)], ids=["int", "int64", "float32", "0-d"]
)
def test_every_kind_of_real_number_is_taken(eqs, good):
    wanted = closed_loop("rate_attitude", eqs, K_A=2.0).A
    assert np.array_equal(closed_loop("rate_attitude", eqs, K_A=good).A, wanted)


@pytest.mark.parametrize("end", [0, 420])
def test_both_ends_of_the_vehicle_are_on_it(eqs, end):
    assert np.isfinite(closed_loop("dual_actuation", eqs, sensor=end, jet=end).A).all()


# ---- the vehicle

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


# ---- mode shapes


@pytest.mark.parametrize("what", ["deflection", "slope"])
@pytest.mark.parametrize("bad", cases(OFF_THE_VEHICLE, NOT_FINITE))
def test_a_mode_has_no_shape_off_the_vehicle(what, bad):
    shape = getattr(rl.swaim_booster().modes[0], what)
    refused(ValueError, lambda: shape(bad), "station")
    refused(ValueError, lambda: shape([0.0, bad]), "station[1]")


@pytest.mark.parametrize("bad", ["27", 1j, None, True, ["nose"]])
def test_a_station_must_be_a_number(bad):
    refused(TypeError, lambda: rl.swaim_booster().modes[0].deflection(bad), "station")


# ---- the equations


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


# ---- root loci

PLANT = control.tf([1.0, 1.0], [1.0, 2.0, 5.0, 0.0])


@pytest.mark.parametrize("bad", [None, "G(s)", 3.0, np.eye(2), {"A": 1}], ids=repr)
def test_a_locus_needs_a_system(bad):
    refused(TypeError, lambda: rl.root_locus(bad), "root_locus")


@pytest.mark.parametrize(
    "system",
    [
        control.tf([1.0, 0.0, 0.0], [1.0, 1.0]),
        control.ss(-np.eye(2), np.eye(2), np.eye(2), np.zeros((2, 2))),
        control.ss([[np.nan]], [[1.0]], [[1.0]], [[0.0]]),
    ],
    ids=["improper", "two by two", "nan"],
)
def test_a_locus_needs_a_proper_single_loop(system):
    refused(ValueError, lambda: rl.root_locus(system), "root_locus")


@pytest.mark.parametrize(
    "bad", [[np.nan], [1.0, np.inf], np.ones((2, 2))], ids=["nan", "inf", "two dimensions"]
)
def test_gains_must_be_a_row_of_finite_numbers(bad):
    refused(ValueError, lambda: rl.root_locus(PLANT, bad), "gains", "root_locus")


@pytest.mark.parametrize("bad", ["1", [1j], [None]], ids=["text", "complex", "None"])
def test_gains_must_be_real_numbers(bad):
    refused(TypeError, lambda: rl.root_locus(PLANT, bad), "gains", "root_locus")


@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan])
def test_the_tolerance_must_be_positive(bad):
    refused(ValueError, lambda: rl.root_locus(PLANT, tolerance=bad), "tolerance")


@pytest.mark.parametrize("bad", [[np.nan], [0.0, np.inf]])
def test_values_of_a_parameter_must_be_finite(eqs, bad):
    refused(
        ValueError,
        lambda: rl.parameter_locus(lambda k: closed_loop("rate_attitude", eqs, K_A=k), bad),
        "values",
    )


def test_a_parameter_must_keep_the_order():
    def grows(k):
        return PLANT if k < 1 else PLANT * PLANT

    refused(ValueError, lambda: rl.parameter_locus(grows, [0.0, 2.0]), "parameter_locus", "6 poles", "3")


def test_a_parameter_passes_the_system_s_own_complaint_on(eqs):
    with pytest.raises(ValueError, match="gyro in rate_attitude"):
        rl.parameter_locus(lambda x: closed_loop("rate_attitude", eqs, gyro=x), [400.0, 430.0])


# ---- the loops beside the control systems: polynomials, the jet, many loops at once

JET, KK_Z = printed_closures.final_design()
FOUND = conclusions.found_gains("dual_actuation")
ATTITUDE = {"K_A": 1.0, "K_C": 10.0, "K_R": 0.6}


def many(**changes):
    """Return the loop found by hand as columns of one, for `ControlledVehicle.matrices`."""
    return {name: np.array([float(value)]) for name, value in (FOUND | changes).items()}


OF_A_NUMBER = {
    "K_r": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(K_r=x), KK_Z),
    "b": lambda eqs, x: closures.closure_1_open_loop(eqs, JET._replace(b=x)),
    "kK_z": lambda eqs, x: closures.closure_2_open_loop(eqs, JET, x),
    "kK_z of theta": lambda eqs, x: closures.theta_numerator(eqs, JET, x),
    "kK_z of a fit": lambda eqs, x: printed_closures.fitted_deflections(eqs, JET, x),
    "largest": lambda eqs, x: table_3.gains_to(x, 5),
    "b of a sensor": lambda eqs, x: transfer_functions.displacement_numerator(eqs, 140.0, x),
    "K_C": named_branches.open_loop_parts,
    "K_R": lambda eqs, x: transfer_functions.theta_loop(eqs, 10.0, x, 60.0),
    "K_z": lambda eqs, x: transfer_functions.denominator(eqs, 10.0, [(x, 140.0)]),
    "gain": lambda eqs, x: transfer_functions.closed_polynomial(PLANT, x),
    "numerator": lambda eqs, x: transfer_functions.transfer([x], [1.0, 1.0]),
    "denominator": lambda eqs, x: transfer_functions.transfer([1.0], [x, 1.0]),
    "K_C of a pole": lambda eqs, x: certificates.gains_for_pole(eqs, -1 + 1j, x, 60.0),
    "pole": lambda eqs, x: certificates.gains_for_pole(eqs, complex(x, 1.0), 10.0, 60.0),
    "slow": lambda eqs, x: certificates.slow_root_certificate(eqs, 60.0, slow=x),
    "within": lambda eqs, x: table_3_readings.readings(eqs, (), within=x),
    "least": lambda eqs, x: table_3_readings.readings(eqs, (), least=x),
    "phi": lambda eqs, x: table_3_readings.starting_rates(eqs, JET, [[1.0, 1.0, 1.0, x]]),
    "K_A": lambda eqs, x: DUAL_ACTUATION.around(eqs).matrices(**many(K_A=x)),
    "K_R of a polynomial": lambda eqs, x: closed_loops.polynomial(eqs, "rigid_angle", ATTITUDE | {"K_R": x}),
    "pole of a pair": lambda eqs, x: DUAL_ACTUATION.around(eqs).with_pair(many(), complex(x, 1.0)),
    "K_A of a margin": lambda eqs, x: robustness.margins(eqs, FOUND | {"K_A": x}, "jet"),
    "alpha_0": conclusions.with_longitudinal,
}
OF_A_STATION = {
    "sensor of a jet": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(sensor=x), KK_Z),
    "jet": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(jet=x), KK_Z),
    "jet of a coupling": lambda eqs, x: closures.coupling_numerator(eqs, "theta", "q1", x),
    "reading": lambda eqs, x: with_reading(eqs, x, (1.0, 1.0)),
    "displacement": transfer_functions.displacement_numerator,
    "attitude": transfer_functions.attitude_numerator,
    "gyro": certificates.gain_terms,
    "sensor": lambda eqs, x: certificates.stability_certificate(eqs, None, [x]),
    "many sensors": lambda eqs, x: DUAL_ACTUATION.around(eqs).matrices(**many(sensor=x)),
    "many jets": lambda eqs, x: DUAL_ACTUATION.around(eqs).matrices(**many(jet=x)),
}


@pytest.mark.parametrize("bad", cases(NOT_FINITE))
@pytest.mark.parametrize("name", OF_A_NUMBER)
def test_a_loop_s_number_must_be_finite(eqs, name, bad):
    refused(ValueError, lambda: OF_A_NUMBER[name](eqs, bad), name.split()[0])


@pytest.mark.parametrize("bad", cases(OFF_THE_VEHICLE))
@pytest.mark.parametrize("name", OF_A_STATION)
def test_a_loop_s_station_must_lie_on_the_vehicle(eqs, name, bad):
    refused(ValueError, lambda: OF_A_STATION[name](eqs, bad), f"{bad:g} ft", "0 to 420 ft")


@pytest.mark.parametrize("call", [closed_loops.state_space, closed_loops.polynomial])
def test_a_loop_must_be_known_and_have_its_gains(eqs, call):
    refused(ValueError, lambda: call(eqs, "triple_sensor", ATTITUDE), "system", "two_sensor")
    with pytest.raises(TypeError, match="K_R"):
        call(eqs, "rigid_angle", {"K_A": 1.0, "K_C": 10.0})
    with pytest.raises(TypeError, match="K_Q"):
        call(eqs, "rigid_angle", ATTITUDE | {"K_Q": 1.0})


def test_what_else_a_loop_needs(eqs):
    loops = DUAL_ACTUATION.around(eqs)
    refused(TypeError, lambda: loops.matrices(**{**many(), "K_Q": [1.0]}), "K_Q")
    lacking = {name: value for name, value in many().items() if name != "K_R"}
    refused(TypeError, lambda: loops.matrices(**lacking), "K_R")
    refused(ValueError, lambda: loops.family.matrices({"K_A": 1.0}), "Family.matrices", "K_C")
    refused(ValueError, lambda: loops.with_pair(many(), -1.0), "pole", "with_pair")
    refused(ValueError, lambda: robustness.margins(eqs, FOUND, "fins"), "actuator", "thrust, jet")
    refused(ValueError, lambda: conclusions.found_gains("fins"), "system", "dual_actuation")
    refused(ValueError, lambda: closures.coupling_numerator(eqs, "q3", "q1", 56.0), "output")
    refused(ValueError, lambda: table_3_readings.starting_rates(eqs, JET, np.ones((2, 3))), "phi", "(2, 4)")
    refused(ValueError, lambda: certificates.slow_root_certificate(eqs, 60.0, slow=-1.0), "slow")
    refused(
        TypeError,
        lambda: conditioning.loop_in_coefficients(None, lambda e: e),
        "eqs",
        "PerturbationEquations",
    )
