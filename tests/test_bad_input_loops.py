"""The loops beside the control systems refuse bad input: polynomials, the jet, many loops at once."""

import control
import numpy as np
import pytest

import rlswaim as rl
from bad_input import NOT_FINITE, OFF_THE_VEHICLE, cases, refused
from rlswaim.edition import conclusions, conditioning, printed_closures, robustness, table_3, table_3_readings
from rlswaim.loops import (
    certificates,
    closed_loops,
    closures,
    cut_loop,
    gain_terms,
    named_branches,
    transfer_functions,
)
from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.vehicle.equations import with_reading

PLANT = control.tf([1.0, 1.0], [1.0, 2.0, 5.0, 0.0])
JET, KK_Z = printed_closures.final_design()
FOUND = conclusions.found_gains("dual_actuation")
ATTITUDE = {"K_A": 1.0, "K_C": 10.0, "K_R": 0.6}


@pytest.fixture(scope="module")
def eqs():
    return rl.printed_equations()


def many(**changes):
    """Return the loop found by hand as columns of one, for `ControlledVehicle.matrices`."""
    return {name: np.array([float(value)]) for name, value in (FOUND | changes).items()}


OF_A_NUMBER = {
    "K_r": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(K_r=x), KK_Z),
    "b": lambda eqs, x: closures.closure_1_open_loop(eqs, JET._replace(b=x)),
    "kK_z": lambda eqs, x: closures.closure_2_open_loop(eqs, JET, x),
    "kK_z of theta": lambda eqs, x: closures.theta_numerator(eqs, JET, x),
    "kK_z of a fit": lambda eqs, x: printed_closures.fitted_deflections(eqs, JET, x),
    "largest": lambda eqs, x: table_3.trial(eqs, 1, JET, x),
    "b of a sensor": lambda eqs, x: transfer_functions.displacement_numerator(eqs, 140.0, x),
    "K_C": named_branches.open_loop_parts,
    "K_R": lambda eqs, x: transfer_functions.theta_loop(eqs, 10.0, x, 60.0),
    "K_z": lambda eqs, x: transfer_functions.denominator(eqs, 10.0, [(x, 140.0)]),
    "gain": lambda eqs, x: transfer_functions.closed_polynomial(PLANT, x),
    "numerator": lambda eqs, x: transfer_functions.transfer([x], [1.0, 1.0]),
    "denominator": lambda eqs, x: transfer_functions.transfer([1.0], [x, 1.0]),
    "K_C of a pole": lambda eqs, x: gain_terms.gains_for_pole(eqs, -1 + 1j, x, 60.0),
    "pole": lambda eqs, x: gain_terms.gains_for_pole(eqs, complex(x, 1.0), 10.0, 60.0),
    "slow": lambda eqs, x: certificates.slow_root_certificate(eqs, 60.0, slow=x),
    "within": lambda eqs, x: table_3_readings.readings(eqs, (), within=x),
    "least": lambda eqs, x: table_3_readings.readings(eqs, (), least=x),
    "phi": lambda eqs, x: table_3_readings.starting_rates(eqs, JET, [[1.0, 1.0, 1.0, x]]),
    "K_A": lambda eqs, x: DUAL_ACTUATION.around(eqs).matrices(**many(K_A=x)),
    "K_R of a polynomial": lambda eqs, x: closed_loops.polynomial(eqs, "rigid_angle", ATTITUDE | {"K_R": x}),
    "pole of a pair": lambda eqs, x: DUAL_ACTUATION.around(eqs).with_pair(many(), complex(x, 1.0)),
    "K_A of a margin": lambda eqs, x: robustness.margins(eqs, FOUND | {"K_A": x}, "jet"),
    "alpha_0": lambda eqs, x: conclusions.with_longitudinal(eqs, x, 0.75),
    "gamma_0": lambda eqs, x: conclusions.with_longitudinal(eqs, 0.1, x),
    "gain of a cut": lambda eqs, x: cut_loop.cut_loop(
        lambda k: rl.rate_attitude(eqs, **ATTITUDE | {"K_A": k}, gyro=60), x
    ),
}
OF_A_STATION = {
    "sensor of a jet": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(sensor=x), KK_Z),
    "jet": lambda eqs, x: closures.closure_1_polynomial(eqs, JET._replace(jet=x), KK_Z),
    "jet of a coupling": lambda eqs, x: closures.coupling_numerator(eqs, "theta", "q1", x),
    "reading": lambda eqs, x: with_reading(eqs, x, (1.0, 1.0)),
    "displacement": transfer_functions.displacement_numerator,
    "attitude": transfer_functions.attitude_numerator,
    "gyro": gain_terms.gain_terms,
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
