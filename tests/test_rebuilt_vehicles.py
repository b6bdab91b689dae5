"""Varied vehicles and loops beside the same ones built anew, and the signed values that the book shows."""

from dataclasses import replace
from itertools import product

import control
import numpy as np
import pytest
from scipy.optimize import brentq

import rlswaim as rl
from exact import paired
from rlswaim.edition import conclusions, printed_closures, robustness, search, table_3, table_3_readings
from rlswaim.edition.table_3 import deciding_gains
from rlswaim.loops import closures
from rlswaim.loops.given_shapes import with_shapes
from rlswaim.vehicle.coupling import elastic_poles

BOOSTER = rl.swaim_booster()
EQS, OWN = rl.printed_equations(), rl.perturbation_equations(BOOSTER)
BY_HAND = conclusions.found_gains("dual_actuation")
MODEST = next(w.gains for w in search.winners() if (w.system, w.objective) == ("modest_jet", "pair-all"))
DESIGN, LARGEST = printed_closures.final_design()
TRIALS = table_3.trials(EQS)


# ---- the equation along x


GAMMA_0 = BOOSTER.flight.gamma_0


def with_u(eqs, alpha_0, s):
    """Return the determinant of Eq. 29 with u as a fifth unknown and the equation along x as a fifth row.

    The row is the slope of Newton's law itself along the vehicle's axis, by differences.
    """

    def along(theta, rate):
        weight = 32.2 * (np.sin(GAMMA_0 + alpha_0 + theta) - np.sin(GAMMA_0 + alpha_0))
        return -eqs.U * alpha_0 * rate - weight

    h = 1e-5
    by_theta = (along(h, 0.0) - along(-h, 0.0)) / (2 * h)
    by_rate = (along(0.0, h) - along(0.0, -h)) / (2 * h)
    matrix = np.zeros((5, 5))
    matrix[:4, :4] = eqs.matrix @ [1, s, s * s]
    for i, row in enumerate(("Z", "M", "F1", "F2")):  # the force of alpha_0 goes with the speed squared
        force = eqs.coefficients[f"{row}_alpha"] * alpha_0
        matrix[i, 4] = force * ((1 + 1 / eqs.U) ** 2 - (1 - 1 / eqs.U) ** 2) / 2
    matrix[4, 1], matrix[4, 4] = -by_theta - by_rate * s, s
    return np.linalg.det(matrix / [[eqs.U], [1], [1], [1], [1]])


@pytest.mark.parametrize(
    ("degrees", "shift"), [(1, -0.000256), (2, -0.000842), (5, -0.004598), (10, -0.017782), (-5, -0.003668)]
)
def test_the_equation_along_x_moves_the_divergence_as_its_determinant_does(degrees, shift):
    alpha_0 = np.radians(degrees)
    found = conclusions.with_longitudinal(EQS, alpha_0, GAMMA_0)
    assert found == pytest.approx(brentq(lambda s: with_u(EQS, alpha_0, s), 1.2, 1.4), abs=1e-9)
    assert found - conclusions.with_longitudinal(EQS, 0.0, GAMMA_0) == pytest.approx(shift, abs=2e-6)


# ---- vehicles with other surfaces, frequencies, thrust or air


def varied(payload=1.0, fins=1.0, omega=1.0, **changes):
    """Return a booster of other lift at its two surfaces and other frequencies, datum by datum."""
    factor = {"payload": payload, "fins": fins}
    surfaces = tuple(replace(s, C_Nalpha=factor[s.name] * s.C_Nalpha) for s in BOOSTER.surfaces)
    modes = tuple(replace(m, omega=omega * m.omega) for m in BOOSTER.modes)
    return replace(BOOSTER, surfaces=surfaces, modes=modes, **changes)


def moved(payload=False, fins=False):
    """Return a booster with surfaces at the nodes of the first mode, found where its shape changes sign."""
    feet = np.arange(0.0, 421.0)
    shape = BOOSTER.modes[0].deflection(feet)
    front, rear = (
        brentq(lambda x: float(BOOSTER.modes[0].deflection(x)), feet[i], feet[i + 1])
        for i in np.flatnonzero(shape[:-1] * shape[1:] < 0)
    )
    at = {"payload": front if payload else None, "fins": rear if fins else None}
    surfaces = tuple(replace(s, station=at[s.name] or s.station) for s in BOOSTER.surfaces)
    return replace(BOOSTER, surfaces=surfaces)


CURES = {
    "as it is": (varied(), 1.3074),
    "no air (q_D = 0)": (varied(0, 0), 0),  # without lift the air has no other part
    "no thrust": (varied(T=0.0), 1.2750),
    "payload surface halved": (varied(payload=0.5), 0.7203),
    "no payload surface": (varied(payload=0), 0),
    "fins halved": (varied(fins=0.5), 1.3146),
    "no fins": (varied(fins=0), 1.3235),
    "no surface at all": (varied(0, 0), 0),
    "fins doubled": (varied(fins=2), 1.2965),
    "both frequencies doubled": (varied(omega=2), 0.6948),
    "both frequencies five times": (varied(omega=5), 0),
    "payload surface at the first mode's front node": (moved(payload=True), 0),
    "fins at its rear node": (moved(fins=True), 1.2923),
    "both surfaces at its nodes": (moved(payload=True, fins=True), 0),
}


def test_every_cure_is_here():
    assert set(CURES) == set(conclusions.cures(BOOSTER))
    assert [s.name for s in BOOSTER.surfaces] == ["payload", "fins"]
    assert BOOSTER.surfaces[0].station < BOOSTER.l_CG < BOOSTER.surfaces[1].station


@pytest.mark.parametrize("name", CURES)
def test_a_cure_has_the_unstable_root_of_the_vehicle_built_anew(name):
    vehicle, root = CURES[name]
    found = conclusions.cures(BOOSTER)[name]
    eigenvalues = np.linalg.eigvals(rl.perturbation_equations(vehicle).state_space().A)
    assert found == pytest.approx(max(eigenvalues.real), abs=1e-6)
    assert found == pytest.approx(root, abs=5e-5)


@pytest.mark.parametrize("name", conclusions.surfaces_cut(BOOSTER))
def test_a_cut_changes_the_surface_that_it_names(name):
    cut, vehicle = conclusions.surfaces_cut(BOOSTER)[name], CURES[name][0]
    assert cut.surfaces == vehicle.surfaces
    assert cut.modes == BOOSTER.modes


# ---- whole mode shapes at 5 %


def scaled_shapes(eqs, factors, loop):
    """Return equations with each mode's shape times a factor, coefficient by coefficient.

    What the air and the thrust bring goes with the shape of its row and that of its column; the structure's
    own damping and spring stay.
    """
    by = {"1": factors[0], "2": factors[1]}
    own = {f"F{i + 1}_q{i + 1}dot": 2 * m.zeta * m.omega for i, m in enumerate(BOOSTER.modes)}
    own |= {f"F{i + 1}_q{i + 1}": m.omega**2 for i, m in enumerate(BOOSTER.modes)}
    found = {}
    for name, value in eqs.coefficients.items():
        row, column = name.split("_")
        factor = by.get(row[1:2], 1) * (by[column[1]] if column[0] == "q" else 1)
        found[name] = own.get(name, 0) + factor * (value - own.get(name, 0))
    places = [loop["sensor"], loop["jet"]]
    phi = {x: [f * m.deflection(x) for m, f in zip(eqs.modes, factors, strict=True)] for x in places}
    return with_shapes(replace(eqs, coefficients=found), phi)


@pytest.mark.parametrize("chosen", [BY_HAND, MODEST], ids=["by hand", "modest jet"])
@pytest.mark.parametrize("at", range(4), ids=["both down", "second up", "first up", "both up"])
def test_scaled_shapes_are_those_of_the_vehicle_built_anew(chosen, at):
    signs = list(product((-1, 1), repeat=2))[at]
    poles = robustness.reshaped(BOOSTER, chosen)[at]
    eqs = scaled_shapes(OWN, [1 + 0.05 * sign for sign in signs], chosen)
    wanted = rl.dual_actuation(eqs, **chosen).poles()
    assert np.abs(poles - paired(poles, wanted)).max() < 1e-5
    unscaled = rl.dual_actuation(OWN, **chosen).poles()
    assert np.abs(poles - paired(poles, unscaled)).max() > 0.01


# ---- Table 3


def right_of_the_axis(sensor, jet, gains):
    """Return how many roots of the jet's loop alone lie right of the axis, the one at rest left out."""
    loop = DESIGN._replace(sensor=sensor, jet=jet)
    closed = {"K_A": 0.0, "K_C": 1.0, "K_R": 0.0, "K_r": loop.K_r, "b": loop.b}
    poles = [rl.dual_actuation(EQS, **closed, kK_z=k, sensor=sensor, jet=jet).poles() for k in gains]
    return [int(np.sum(p.real > 1e-5)) for p in poles]


@pytest.mark.parametrize("pair", TRIALS, ids=lambda pair: f"case {pair.case}")
def test_a_trial_counts_the_unstable_roots_of_the_wired_loop(pair):
    ends = [pair.sign * abs(LARGEST)]
    assert right_of_the_axis(pair.sensor, pair.jet, ends) == [pair.unstable]
    gains = pair.sign * np.geomspace(1e3, abs(LARGEST), 6)
    assert pair.steadies or 0 not in right_of_the_axis(pair.sensor, pair.jet, gains)


@pytest.mark.parametrize(
    ("sensor", "jet", "inside", "sign"),
    [(264.0, 72.0, 1e6, -1), (420.0, 72.0, 5e6, 1), (336.0, 84.0, 8e5, -1)],
)
def test_a_pair_may_steady_at_gains_between_and_not_at_the_last(sensor, jet, inside, sign):
    found = table_3.trial(EQS, 0, DESIGN._replace(sensor=sensor, jet=jet), LARGEST)
    assert right_of_the_axis(sensor, jet, [sign * inside, sign * abs(LARGEST)]) == [0, 2]
    assert (found.sign, found.steadies, found.unstable) == (sign, True, 2)


def test_the_pairs_that_steady_do_so_at_the_gain_of_figure_24():
    steady = [p for p in TRIALS if p.steadies]
    assert [(p.case, p.sign, p.unstable) for p in steady] == [(1, 1, 0), (4, -1, 0)]


def sign_changes(function, edges):
    """Return where a function changes its sign between edges."""
    values = [function(x) for x in edges]
    pairs = zip(edges[:-1], edges[1:], values[:-1], values[1:], strict=True)
    return [brentq(function, a, b, xtol=1e-13) for a, b, left, right in pairs if left * right < 0]


@pytest.mark.parametrize(("sensor", "jet"), [(264.0, 72.0), (420.0, 72.0), (39.0, 140.0)])
def test_deciding_gains_are_those_at_which_something_changes(sensor, jet):
    """Double real roots, roots on the imaginary axis and roots as far out as the modes, from -D/N itself.

    A root at rest belongs to N and D alike, and is left out.
    """
    opened = closures.closure_1_open_loop(EQS, DESIGN._replace(sensor=sensor, jet=jet))
    N, D = (np.polynomial.Polynomial(p[0][0][::-1][1:]) for p in (opened.num, opened.den))
    sizes, span = [abs(pole) for pole in elastic_poles(EQS)], np.linspace(1e-3, np.pi - 1e-3, 4001)
    meetings = (D * N.deriv() - N * D.deriv()).roots()
    places = [s.real for s in meetings if abs(s.imag) < 1e-7 * abs(s)]

    def phase(s):
        return float((-D(s) * np.conj(N(s))).imag)

    places += [1j * w for w in sign_changes(lambda w: phase(1j * w), np.geomspace(1e-4, 1e3, 8001))]
    for size in sizes:  # the modes themselves are so far out at gain 0
        on = sign_changes(lambda x, size=size: phase(size * np.exp(1j * x)), span)
        places += [*(size * np.exp(1j * np.array(on))), size, -size]
    wanted = np.array([(-D(s) / N(s)).real for s in [*places, 0.0]])
    wanted = wanted[(np.abs(wanted) <= abs(LARGEST)) & (np.abs(wanted) > 1e-6)]
    found = deciding_gains(opened, sizes, LARGEST)
    assert len(wanted) > 4
    for gain in wanted:
        assert np.abs(found - gain).min() <= 1e-6 * abs(gain)
    for gain in found[np.abs(found) > 1e-6]:
        assert np.abs(wanted - gain).min() <= 1e-6 * abs(gain)


@pytest.mark.parametrize("pair", TRIALS, ids=lambda pair: f"case {pair.case}")
@pytest.mark.parametrize(("points", "off"), [(600, 0.0), (1500, 0.0), (5000, 0.0), (200, 1e-12)])
def test_no_grid_and_no_last_digit_decides_a_trial(pair, points, off):
    """The judgement is the same on any grid of gains, and with coefficients off by rounding."""
    loop, elastic = DESIGN._replace(sensor=pair.sensor, jet=pair.jet), elastic_poles(EQS)
    opened, rng = closures.closure_1_open_loop(EQS, loop), np.random.default_rng(pair.case)
    top, bottom = (p[0][0] * (1 + off * rng.uniform(-1, 1, p[0][0].size)) for p in (opened.num, opened.den))
    gains = pair.sign * np.concatenate([[0.0], abs(LARGEST) * np.geomspace(1e-7, 1, points)])
    roots = rl.root_locus(control.tf(top, bottom), gains).roots
    found = table_3._trial(pair.case, loop, pair.sign, elastic, roots)
    assert (found.outcome, found.unstable) == (pair.outcome, pair.unstable)
    assert found.factors == pytest.approx(pair.factors, rel=1e-5, nan_ok=True)


def ends_on_the_axis(loop, sign, mode):
    """Return whether a mode's pair becomes real on the way, from companion matrices in small steps."""
    opened = closures.closure_1_open_loop(EQS, loop)
    root = elastic_poles(EQS)[mode]
    for gain in sign * abs(LARGEST) * np.geomspace(1e-7, 1, 4001):
        roots = np.roots(np.polyadd(opened.den[0][0], gain * opened.num[0][0]))
        root = roots[np.abs(roots - root).argmin()]
        if root.imag == 0:
            return True
    return False


@pytest.mark.parametrize("case", [3, 5, 8, 9, 21, 22])
def test_a_mode_ends_where_its_roots_meet_on_the_axis(case):
    pair = TRIALS[case - 1]
    loop = DESIGN._replace(sensor=pair.sensor, jet=pair.jet)
    ended = [ends_on_the_axis(loop, pair.sign, mode) for mode in range(2)]
    assert list(np.isnan(pair.factors)) == ended


def first_changes(loop, phi):
    """Return how the distances of both modes' roots from the origin change at a little gain."""
    eqs, ends = table_3_readings.read_so(EQS, loop, phi), []
    for gain in (1e-3, -1e-3):
        found = np.roots(closures.closure_1_polynomial(eqs, loop, gain)[::-1])
        ends.append(sorted(np.abs(found[found.imag > 0])))
    return np.subtract(*ends) / 2e-3


@pytest.mark.parametrize(("case", "barred"), [(1, False), (3, True), (16, False)])
def test_a_pair_is_barred_if_each_sign_lowers_one_mode_at_every_corner_of_the_box(case, barred):
    loop = DESIGN._replace(sensor=TRIALS[case - 1].sensor, jet=TRIALS[case - 1].jet)
    phi = np.array([m.deflection(x) for x in (loop.sensor, loop.jet) for m in EQS.modes])
    rates = [first_changes(loop, phi * (1 + 0.05 * np.array(signs))) for signs in product((-1, 1), repeat=4)]
    falls, rises = ((np.sign(rates) == sign).all(axis=0).any() for sign in (-1, 1))
    (found,) = table_3_readings.readings(EQS, [TRIALS[case - 1]], samples=0)
    assert found.barred == (falls and rises) == barred
    assert found.total == 17
    assert sorted(map(tuple, table_3_readings.CORNERS)) == list(product((-1, 1), repeat=4))
