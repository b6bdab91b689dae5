"""Eq. 29's matrix formula against the report's own formulas written out, for any number of modes; gravity."""

from dataclasses import replace
from math import pi, radians, sin

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import polynomial as npp

import rlswaim as rl
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source.tables import constants
from rlswaim.vehicle import eq_29
from rlswaim.vehicle.equations import COEFFICIENTS, printed_coefficients
from rlswaim.vehicle.modes import BendingMode
from systems import boosters, mismatch

BOOSTER = rl.swaim_booster()


def third_mode(omega=8.0, zeta=0.01, mass=4e5):
    """Return a made-up third bending mode."""
    x = [0.0, 60.0, 140.0, 220.0, 300.0, 380.0, 420.0]
    phi = [-3.0, 1.5, 2.5, -2.0, -1.5, 0.8, 1.0]
    return BendingMode(np.array(x), np.array(phi), np.array([420.0]), np.array([-0.03]), omega, zeta, mass)


def with_modes(booster, count):
    """Return a booster with the first of its own two modes and the third one, ``count`` in all."""
    return replace(booster, modes=(*booster.modes, third_mode())[:count])


def written_out(booster, number=float):
    """Return the coefficients by the formulas at the end of Section I, sum by sum, in any kind of number."""
    q_D, U, S, T = (number(x) for x in (booster.flight.q_D, booster.flight.U, booster.S, booster.T))
    M, I_y, l_CG, l_G = (number(x) for x in (booster.M, booster.I_y, booster.l_CG, booster.l_G))
    G = booster.thrust_station

    def integral(of):
        """Return the integral of C_N_alpha times a function of the station: a sum over the surfaces."""
        return sum((number(s.C_Nalpha) * of(s.station) for s in booster.surfaces), number(0))

    def arm(x):
        return l_CG - number(x)

    def phi(i):
        return lambda x: number(booster.modes[i].deflection(x))

    def sigma(i):
        return lambda x: number(booster.modes[i].slope(x))

    c = {
        "Z_alpha": q_D * S / M * integral(lambda x: 1),
        "Z_thetadot": -q_D * S / (M * U) * integral(arm),
        "Z_delta": -T / M,
        "M_alpha": -q_D * S / I_y * integral(arm),
        "M_thetadot": q_D * S / (I_y * U) * integral(lambda x: arm(x) ** 2),
        "M_delta": -T * l_G / I_y,
    }
    for i, mode in enumerate(booster.modes):
        q, F, m = f"q{i + 1}", f"F{i + 1}", number(mode.mass)
        c[f"Z_{q}dot"] = -q_D * S / (M * U) * integral(phi(i))
        c[f"Z_{q}"] = q_D * S / M * integral(sigma(i)) + T / M * sigma(i)(G)
        c[f"M_{q}dot"] = q_D * S / (I_y * U) * integral(lambda x, i=i: phi(i)(x) * arm(x))
        bent = T / I_y * (l_G * sigma(i)(G) + phi(i)(G))
        c[f"M_{q}"] = -q_D * S / I_y * integral(lambda x, i=i: sigma(i)(x) * arm(x)) + bent
        c[f"{F}_alpha"] = -q_D * S / m * integral(phi(i))
        c[f"{F}_thetadot"] = q_D * S / (m * U) * integral(lambda x, i=i: phi(i)(x) * arm(x))
        c[f"{F}_delta"] = T / m * phi(i)(G)
        for j in range(len(booster.modes)):
            air = q_D * S / (m * U) * integral(lambda x, i=i, j=j: phi(i)(x) * phi(j)(x))
            c[f"{F}_q{j + 1}dot"] = air
            air = q_D * S / m * integral(lambda x, i=i, j=j: sigma(j)(x) * phi(i)(x))
            c[f"{F}_q{j + 1}"] = -air - T / m * sigma(j)(G) * phi(i)(G)
        c[f"{F}_{q}dot"] += 2 * number(mode.zeta) * number(mode.omega)
        c[f"{F}_{q}"] += number(mode.omega) ** 2
    return c


def determinant_at(c, s, U, modes, gravity=0):
    """Return the determinant of Eq. 29 at one s, its matrix written out entry by entry, by mpmath."""
    rows = ["Z", "M", *(f"F{i}" for i in range(1, modes + 1))]
    matrix = mpmath.matrix(len(rows))
    for i, row in enumerate(rows):
        matrix[i, 0] = c[f"{row}_alpha"]
        matrix[i, 1] = c[f"{row}_thetadot"] * s
        for j in range(1, modes + 1):
            matrix[i, j + 1] = c[f"{row}_q{j}dot"] * s + c[f"{row}_q{j}"]
        if i:
            matrix[i, i] += s**2
    matrix[0, 0] += U * s
    matrix[0, 1] += gravity - U * s
    return mpmath.det(matrix)


# ---- the formula


@given(booster=boosters(), count=st.integers(0, 3))
def test_matrix_formula_is_the_report_s_formulas(booster, count):
    booster = with_modes(booster, count)
    exact = written_out(booster, mpmath.mpf)
    found = rl.perturbation_equations(booster).coefficients
    assert set(found) == set(exact)
    size = {name: float(abs(value)) for name, value in exact.items()}
    for name, value in found.items():
        row, column = name.split("_")
        alone = replace(booster, T=0.0)  # M_q and F_q are small differences of what these hold
        terms = size[name] + abs(written_out(alone)[name]) if column.startswith("q") else size[name]
        assert abs(value - float(exact[name])) <= 1e-14 * max(terms, size[name]), (row, column)


@pytest.mark.parametrize("gravity", [False, True])
@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_any_number_of_modes_in_fifty_digits(count, gravity):
    booster = with_modes(BOOSTER, count)
    eqs = rl.perturbation_equations(booster, gravity=gravity)
    p, poles = eqs.characteristic_polynomial(), eqs.state_space().poles()
    assert p.size == poles.size + 1 == 4 + 2 * count
    with mpmath.workdps(50):
        exact, U = written_out(booster, mpmath.mpf), mpmath.mpf(booster.flight.U)
        g = mpmath.mpf(constants("vehicle")["g"]) * mpmath.sin(booster.flight.gamma_0) if gravity else 0
        for s in (mpmath.mpc(0.3, 1.1), mpmath.mpc(-2.0, 4.0), mpmath.mpc(7.0, -3.0)):
            wanted = complex(determinant_at(exact, s, U, count, g) / U)
            assert npp.polyval(complex(s), p) == pytest.approx(wanted, rel=1e-12)
    assert mismatch(poles, roots(p)) < 1e-9


@pytest.mark.parametrize("count", [0, 1])
def test_fewer_modes_are_the_leading_rows_and_columns(count):
    few, both = rl.perturbation_equations(with_modes(BOOSTER, count)), rl.perturbation_equations(BOOSTER)
    n = 2 + count
    np.testing.assert_array_equal(few.matrix, both.matrix[:n, :n])
    np.testing.assert_array_equal(few.characteristic_polynomial(), both.characteristic_polynomial(order=n))
    for signal in ("delta", "delta_r", "alpha_g"):
        np.testing.assert_array_equal(few.forcing(signal, 200.0), both.forcing(signal, 200.0)[:n])
        np.testing.assert_array_equal(
            few.numerator("theta", signal), both.numerator("theta", signal, order=n)
        )


def test_three_modes_have_nine_states_and_answer_as_cramer_says():
    eqs, s = rl.perturbation_equations(with_modes(BOOSTER, 3)), 0.4 + 2j
    vehicle = eqs.state_space(jet=90.0)
    assert eqs.states == ("alpha", "theta", "thetadot", "q1", "q1dot", "q2", "q2dot", "q3", "q3dot")
    assert vehicle.output_labels == list(eqs.states)
    solved = np.linalg.solve(s * np.eye(9) - vehicle.A, vehicle.B)
    for j, signal in enumerate(vehicle.input_labels):
        for output in eqs.outputs:
            over = npp.polyval(s, eqs.numerator(output, signal, jet=90.0))
            wanted = solved[eqs.states.index(output), j]
            assert over / npp.polyval(s, eqs.characteristic_polynomial()) == pytest.approx(wanted, rel=1e-9)


@given(booster=boosters(), count=st.integers(0, 3))
def test_without_air_and_thrust_every_motion_is_by_itself(booster, count):
    still = with_modes(replace(booster, T=0.0, flight=replace(booster.flight, q_D=0.0)), count)
    matrix = rl.perturbation_equations(still).matrix
    own = np.zeros_like(matrix)
    own[0, :2, 1] = still.flight.U, -still.flight.U
    own[1, 1, 2] = 1.0
    for i, mode in enumerate(still.modes, start=2):
        own[i, i] = mode.omega**2, 2 * mode.zeta * mode.omega, 1.0
    np.testing.assert_array_equal(matrix, own)


@given(booster=boosters(), count=st.integers(0, 3))
def test_products_add_up_to_the_coefficients(booster, count):
    booster = with_modes(booster, count)
    known = {"q_D": booster.flight.q_D}
    known |= {f"omega_{i}": mode.omega for i, mode in enumerate(booster.modes, start=1)}
    for surface in booster.surfaces:
        at, x = {"arm": surface.station - booster.l_CG}, surface.station
        for i, mode in enumerate(booster.modes, start=1):
            at |= {f"phi_{i}": mode.deflection(x), f"sigma_{i}": mode.slope(x)}
        known |= {f"{name}_{surface.name}": value for name, value in at.items()}
        known[f"C_{surface.name}"] = surface.C_Nalpha
    wanted = rl.perturbation_equations(booster).coefficients
    found = eq_29.products(booster)
    assert set(found) == {name for name in wanted if not name.endswith("delta")}
    for name, sums in found.items():
        terms = [weight * np.prod([known[f] for f in factors]) for weight, factors in sums]
        assert sum(terms) == pytest.approx(wanted[name], rel=1e-13, abs=1e-14 * np.abs(terms).sum())


@given(booster=boosters())
def test_a_force_of_the_jet_enters_by_the_lever_of_its_station(booster):
    booster = with_modes(booster, 3)
    forcing = rl.perturbation_equations(booster).forcing("delta_r", jet=77.0)
    wanted = [1 / booster.M, (77.0 - booster.l_CG) / booster.I_y]
    wanted += [-mode.deflection(77.0) / mode.mass for mode in booster.modes]
    np.testing.assert_allclose(forcing, wanted, rtol=1e-14)


# ---- the printed coefficients


def test_each_printed_coefficient_is_taken_where_it_has_most_figures():
    texts = printed_coefficients()
    assert tuple(texts) == COEFFICIENTS
    assert (texts["Z_delta"], texts["Z_thetadot"], texts["F1_q2dot"]) == ("-81.0", "-1859", "-.0482")
    assert rl.printed_equations().coefficients["Z_thetadot"] == 1.0
    assert dict(rl.printed_equations().jet) == {"Z": 6.61e-6, "M": 6.545e-10, "F1": 1.61e-6, "F2": 1.57e-6}


# ---- gravity on the path


@pytest.fixture(params=["data", "printed"])
def both_ways(request):
    """Return the equations without and with gravity."""
    if request.param == "printed":
        return rl.printed_equations(), rl.printed_equations(gravity=True)
    return rl.perturbation_equations(BOOSTER), rl.perturbation_equations(BOOSTER, gravity=True)


def test_gravity_enters_the_first_row_s_theta_and_nothing_else(both_ways):
    without, kept = both_ways
    moved = kept.matrix - without.matrix
    assert moved[0, 1, 0] == kept.gravity == pytest.approx(32.2 * sin(radians(90 * (1 - 57.5 / 110))))
    moved[0, 1, 0] = 0.0
    assert not moved.any()
    assert kept.coefficients == without.coefficients
    assert without.gravity == 0.0
    A = kept.state_space().A - without.state_space().A
    assert A[0, 1] == pytest.approx(-kept.gravity / kept.U)
    A[0, 1] = 0.0
    assert not A.any()


def test_gravity_moves_the_pole_at_the_origin(both_ways):
    """It makes the path itself unstable, at nearly g sin gamma_0/U: a path that sinks turns down more."""
    without, kept = both_ways
    poles = [eqs.state_space().poles() for eqs in both_ways]
    assert min(abs(poles[0])) < 1e-12
    slow = poles[1][np.argmin(abs(poles[1]))]
    assert slow == pytest.approx(0.0118, abs=5e-5)
    assert slow.real == pytest.approx(kept.gravity / kept.U, rel=5e-3)
    others = [p[np.argsort(abs(p))][1:] for p in poles]
    assert mismatch(*others) < 4e-3
    assert without.characteristic_polynomial()[0] == 0.0


def test_gravity_alone_turns_a_pitched_path_away():
    """In vacuum without thrust, U (theta' - alpha') = g sin(gamma_0) theta, from Eq. 1 with F_z = 0."""
    still = replace(BOOSTER, T=0.0, flight=replace(BOOSTER.flight, q_D=0.0, gamma_0=0.6))
    vehicle = rl.perturbation_equations(still, gravity=True).state_space()
    state = np.zeros(7)
    state[1] = 0.1
    rates = vehicle.A @ state
    assert rates[1] - rates[0] == pytest.approx(32.2 * sin(0.6) * 0.1 / still.flight.U)


@pytest.mark.parametrize(("gamma_0", "weight"), [(0.0, 0.0), (pi / 2, 32.2), (-pi / 6, -16.1)])
def test_weight_across_the_path_goes_with_its_angle(gamma_0, weight):
    at = replace(BOOSTER, flight=replace(BOOSTER.flight, gamma_0=gamma_0))
    assert rl.perturbation_equations(at, gravity=True).gravity == pytest.approx(weight)


def test_gravity_needs_the_angle_of_the_path():
    unknown = replace(BOOSTER, flight=replace(BOOSTER.flight, gamma_0=None))
    assert rl.perturbation_equations(unknown).gravity == 0.0
    with pytest.raises(ValueError, match=r"gamma_0 in FlightCondition: got None, wanted"):
        rl.perturbation_equations(unknown, gravity=True)
