"""The control systems refuse bad equations, gains and stations; they clip nothing and return no nan."""

import numpy as np
import pytest

import rlswaim as rl
from bad_input import NOT_FINITE, NOT_NUMBERS, OFF_THE_VEHICLE, cases, refused
from systems import LOOPS, closed_loop

STATION_NAMES = ("gyro", "sensor", "sensor_a", "sensor_b", "jet")


@pytest.fixture(scope="module")
def eqs():
    return rl.printed_equations()


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
