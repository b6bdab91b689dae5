"""Section VII: three closures, a reaction jet for the modes and the thrust for the rigid body.

Polynomials run from the constant term up, over U as everywhere; gains have the report's signs.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.loops.factors import from_factors
from rlswaim.loops.transfer_functions import elastic_numerator, transfer
from rlswaim.rootlocus.locus import RootLocus, root_locus
from rlswaim.rootlocus.polynomials import determinant, roots
from rlswaim.source import checks
from rlswaim.source.tables import column, constants, printed
from rlswaim.vehicle.equations import JET_STATION, OUTPUTS, ROWS, PerturbationEquations

ARMS = {"Z": 1.0, "M": 1.0, "F1": -1.0, "F2": -1.0}
"""Sign of the jet's force in each equation; M has the arm l_r - l_CG, F_i has phi_i(r) [Eq. 125]."""


class JetLoop(NamedTuple):
    """The jet's loop: valve gain K_r (1/s), sensor's ratio b (1/s), and both stations (ft)."""

    K_r: float
    b: float
    sensor: float
    jet: float = JET_STATION

    @property
    def valve(self) -> NDArray:
        """The valve's s + K_r; ValueError if K_r is not finite."""
        return np.array([checks.real("K_r", self.K_r, "JetLoop"), 1.0])

    @property
    def reading(self) -> NDArray:
        """The sensor's s + b; ValueError if b is not finite."""
        return np.array([checks.real("b", self.b, "JetLoop"), 1.0])


def final_design() -> tuple[JetLoop, float]:
    """Return the jet's loop of Figures 24 and 25 and its gain k K_z (lb s/ft)."""
    chosen = constants("section_7")
    return JetLoop(*(chosen[name] for name in ("K_r", "b", "sensor", "jet"))), chosen["kK_z"]


def coupling_numerator(eqs: PerturbationEquations, first: str, second: str, jet: float) -> NDArray:
    """Return the determinant with the thrust's column at ``first`` and the jet's at ``second``, over U.

    Parameters
    ----------
    eqs : PerturbationEquations
    first, second : str
        Two of alpha, theta, q1, q2.
    jet : float
        Station of the reaction jet (ft).

    Returns
    -------
    ndarray, shape (7,)
        Times Delta it is N(first/delta) N(second/delta_r) - N(first/delta_r) N(second/delta):
        two-input products divide by Delta exactly (Sylvester's identity, ours; not in the report).
    """
    replaced = eqs.matrix.copy()
    for name, signal in ((first, "delta"), (second, "delta_r")):
        j = OUTPUTS.index(checks.one_of("output", name, OUTPUTS, "coupling_numerator"))
        replaced[:, j] = 0.0
        replaced[:, j, 0] = eqs.forcing(signal, jet)
    return determinant(replaced)[:7] / eqs.U


def literal_bracket(eqs: PerturbationEquations) -> NDArray:
    """Return the braces of Eq. 133 as numbers: shape (5, 2, 4).

    Returns
    -------
    ndarray
        Axis 0: s^0 to s^4.  Axis 1: the factor phi_1(z) or phi_2(z).  Axis 2: what stands alone,
        with l_r - l_CG, with phi_1(r), with phi_2(r).  Scaled by 1000 U, as the report's.
    """
    bracket = np.zeros((5, 2, 4))
    for i in range(2):
        for r, row in enumerate(ROWS):
            replaced = eqs.matrix.copy()
            replaced[:, 2 + i] = 0.0
            replaced[r, 2 + i, 0] = 1000 * ARMS[row] * eqs.jet[row]
            bracket[:, i, r] = determinant(replaced)[1:6]
    return bracket


def dropped_product(eqs: PerturbationEquations) -> NDArray:
    """Return what phi_1(z) phi_1(r) loses in Eq. 133, powers s^0 to s^3: shape (4,).

    The report's figures come out without Z_alpha (s + M_thetadot)(s^2 + F2_q2dot s + F2_q2), a
    product of the cofactor (ours: the cause, found by subtracting).
    """
    c = eqs.coefficients
    product = npp.polymul([c["M_thetadot"], 1.0], [c["F2_q2"], c["F2_q2dot"], 1.0])
    return -1000 * eqs.jet["F1"] * c["Z_alpha"] * product


def direct_response(eqs: PerturbationEquations, sensor: NDArray, jet: NDArray) -> NDArray:
    """Return sum of phi_i(z) phi_i(r)/m_i (1/slug): acceleration at the sensor for each lb of the jet.

    Parameters
    ----------
    eqs : PerturbationEquations
    sensor, jet : ndarray
        Stations (ft); their shapes broadcast.

    Notes
    -----
    It is, but for its sign, the s^4 coefficient of Eq. 133.
    """
    first, second = (mode.deflection(sensor) * mode.deflection(jet) for mode in eqs.modes)
    return eqs.jet["F1"] * first + eqs.jet["F2"] * second


def closure_1_open_loop(eqs: PerturbationEquations, loop: JetLoop) -> control.TransferFunction:
    """Return closure 1's open loop for k K_z = 1 [Eq. 133].

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    """
    top = -loop.K_r * npp.polymul(loop.reading, elastic_numerator(eqs, loop.sensor, "delta_r", loop.jet)[:6])
    return transfer(top, npp.polymul(loop.valve, eqs.characteristic_polynomial()))


def closure_1_polynomial(eqs: PerturbationEquations, loop: JetLoop, kK_z: float) -> NDArray:
    """Return the characteristic polynomial of closure 1, shape (9,) [Eq. 133].

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    kK_z : float
        Gain of the jet's loop (lb s/ft).
    """
    moved = npp.polymul(loop.reading, elastic_numerator(eqs, loop.sensor, "delta_r", loop.jet)[:6])
    gain = checks.real("kK_z", kK_z, "closure_1_polynomial") * loop.K_r
    return npp.polysub(npp.polymul(loop.valve, eqs.characteristic_polynomial()), gain * moved)


def jet_numerator(eqs: PerturbationEquations, loop: JetLoop, as_printed: bool = False) -> NDArray:
    """Return N of theta/delta_r [Eq. 135 as it should be].

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    as_printed : bool
        Return what Eq. 135 prints in its place: N of alpha/delta_r, not divided by U.
    """
    if as_printed:
        return eqs.numerator("alpha", "delta_r", loop.jet) * eqs.U
    return eqs.numerator("theta", "delta_r", loop.jet)


def closure_2_open_loop(
    eqs: PerturbationEquations, loop: JetLoop, kK_z: float, as_printed: bool = False
) -> control.TransferFunction:
    """Return closure 2's open loop [Eq. 134].

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    kK_z : float
        Gain of the jet's loop (lb s/ft).
    as_printed : bool
        Take the numerator that Eq. 135 prints, not the one that it should be.
    """
    elastic = elastic_numerator(eqs, loop.sensor, "delta", loop.jet)[:6]
    top = npp.polymul(jet_numerator(eqs, loop, as_printed), elastic)
    top = checks.real("kK_z", kK_z, "closure_2_open_loop") * loop.K_r * npp.polymul(loop.reading, top)
    bottom = npp.polymul(eqs.numerator("theta", "delta")[:6], closure_1_polynomial(eqs, loop, kK_z))
    return transfer(np.where(np.abs(top) > 1e-12 * np.abs(top).max(), top, 0.0), bottom)


def theta_numerator(eqs: PerturbationEquations, loop: JetLoop, kK_z: float) -> NDArray:
    """Return N of theta/delta with the jet's loop closed: closure 2's polynomial over Delta, shape (8,).

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    kK_z : float
        Gain of the jet's loop (lb s/ft).
    """
    phi = [mode.deflection(loop.sensor) for mode in eqs.modes]
    coupled = [
        p * coupling_numerator(eqs, "theta", q, loop.jet) for p, q in zip(phi, ("q1", "q2"), strict=True)
    ]
    own = npp.polymul(loop.valve, eqs.numerator("theta", "delta")[:6])
    gain = checks.real("kK_z", kK_z, "theta_numerator") * loop.K_r
    return npp.polysub(own, gain * npp.polymul(loop.reading, coupled[0] + coupled[1]))


def closure_3_open_loop(
    eqs: PerturbationEquations, loop: JetLoop, kK_z: float, K_C: float, K_R: float
) -> control.TransferFunction:
    """Return closure 3's open loop for K_A = 1, with Delta cancelled [Eq. 137 as it should be].

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    kK_z : float
        Gain of the jet's loop (lb s/ft).
    K_C, K_R : float
        Actuator (1/s) and rate gyro (s) gains of the outer loop.
    """
    top = K_C * npp.polymul([1.0, K_R], theta_numerator(eqs, loop, kK_z))
    return transfer(top, npp.polymul([K_C, 1.0], closure_1_polynomial(eqs, loop, kK_z)))


def listed(values: Iterable[complex], digits: int = 3) -> str:
    """Return roots (``values``) to so many ``digits``, one of each pair: ``-1.543, -0.012 ± 1.150j``."""
    upper = sorted((complex(v) for v in values if np.imag(v) >= 0), key=lambda v: (v.real, v.imag))
    return ", ".join(f"{v.real:.{digits}f}" + (f" ± {v.imag:.{digits}f}j" if v.imag else "") for v in upper)


def printed_factors(start: str) -> list[complex]:
    """Return printed roots (1/s): ids ``<start>r1`` real, ``<start>c1-re`` and ``<start>c1-im`` complex."""
    number = printed("VII", start)
    real = [complex(value) for name, value in number.items() if name[0] == "r"]
    pairs = [
        complex(v, number[name.replace("-re", "-im")]) for name, v in number.items() if name.endswith("-re")
    ]
    return real + pairs


def printed_closure_2() -> control.TransferFunction:
    """Return Eq. 136 from its printed factors."""
    zeros, poles = printed_factors("eq136-zero-"), printed_factors("eq136-pole-")
    return from_factors(printed("VII", "eq136-")["gain"], [*zeros, 0.0, 0.0], [*poles, 0.0])


def printed_closure_3(K_C: float, K_R: float) -> control.TransferFunction:
    """Return Eq. 137 from its printed factors, for K_A = 1."""
    zeros, poles = printed_factors("eq137-zero-"), printed_factors("eq137-pole-")
    gain = printed("VII", "eq137-")["gain"] * K_C * K_R
    return from_factors(gain, [*zeros, 0.0, -1 / K_R], [*poles, -K_C, 0.0, 0.0])


def fitted_deflections(eqs: PerturbationEquations, loop: JetLoop, kK_z: float) -> tuple[float, float]:
    """Return phi_1(z), phi_2(z) that bring closure 1 nearest to its printed roots.

    Least squares on the relative error of the coefficients of s to s^6, in which both are linear.
    """
    p = printed_factors("text-closure1-")
    wanted = npp.polyfromroots([0.0, *p, *(z.conjugate() for z in p if z.imag)]).real[1:7]
    base = npp.polymul(loop.valve, eqs.characteristic_polynomial())[1:7]
    numerators = [eqs.numerator(q, "delta_r", loop.jet)[:6] for q in ("q1", "q2")]
    gain = -checks.real("kK_z", kK_z, "fitted_deflections") * loop.K_r
    effect = [gain * npp.polymul(loop.reading, n)[1:7] / wanted for n in numerators]
    phi = np.linalg.lstsq(np.array(effect).T, (wanted - base) / wanted, rcond=None)[0]
    return float(phi[0]), float(phi[1])


def with_reading(
    eqs: PerturbationEquations, station: float, phi: tuple[float, float]
) -> PerturbationEquations:
    """Return the equations with both modes bent to pass through given deflections at one more station.

    Parameters
    ----------
    eqs : PerturbationEquations
    station : float
        In feet.
    phi : tuple of float
        Deflections phi_1 and phi_2 there.
    """
    modes = []
    for mode, value in zip(eqs.modes, phi, strict=True):
        at = int(np.searchsorted(mode.stations, station))
        points = np.insert(mode.stations, at, station), np.insert(mode.deflections, at, value)
        modes.append(replace(mode, stations=points[0], deflections=points[1]))
    return replace(eqs, modes=(modes[0], modes[1]))


def elastic_poles(eqs: PerturbationEquations) -> list[complex]:
    """Return the pole above the real axis (1/s) of each bending mode, the first mode's first."""
    poles = roots(eqs.characteristic_polynomial())
    return sorted(poles[poles.imag > 1e-6], key=abs)


class Stiffening(NamedTuple):
    """What closure 1 does to both bending modes for one pair of Table 3, for the better sign of k K_z.

    ``factors`` are the coupled frequencies at the largest gain over those without the jet.  ``verdict``:
    "rises throughout" if at no gain up to there either frequency is below its own and both roots stay
    complex; "higher at the end" if that holds at the largest gain only; else "no".  ``unstable`` counts
    the roots right of the axis at the largest gain; ``steadies`` tells whether some gain leaves none there.
    """

    case: int
    sensor: float
    jet: float
    sign: int
    factors: tuple[float, float]
    verdict: str
    unstable: int
    steadies: bool


VERDICTS = ("no", "higher at the end", "rises throughout")


def table_3_pairs() -> tuple[tuple[int, float, float], ...]:
    """Return the cases of Table 3: number, station of the sensor, station of the jet (ft)."""
    columns = (column("table3", name) for name in ("case", "sensor_ft", "jet_ft"))
    return tuple((int(case), sensor, jet) for case, sensor, jet in zip(*columns, strict=True))


def table_3(eqs: PerturbationEquations, points: int = 600) -> tuple[Stiffening, ...]:
    """Return `Stiffening` for each of Table 3's pairs, with ``points`` gains up to that of Figure 24."""
    design, largest = final_design()
    gains = gains_to(largest, points)
    return tuple(
        stiffening(eqs, case, design._replace(sensor=sensor, jet=jet), gains)
        for case, sensor, jet in table_3_pairs()
    )


def gains_to(largest: float, points: int) -> NDArray:
    """Return 0 and so many ``points`` up to the size of the ``largest`` gain, evenly in the logarithm."""
    size = abs(checks.real("largest", largest, "gains_to"))
    return np.concatenate([[0.0], np.geomspace(1e-7, 1.0, points) * size])


def stiffening(eqs: PerturbationEquations, case: int, loop: JetLoop, gains: NDArray) -> Stiffening:
    """Return `Stiffening` of one ``case`` for the better sign; ``gains`` are sizes (lb s/ft) from 0 up."""
    opened = closure_1_open_loop(eqs, loop)
    found = [_stiffening(eqs, case, loop, sign, root_locus(opened, sign * gains)) for sign in (1, -1)]
    return max(found, key=lambda s: (VERDICTS.index(s.verdict), min(s.factors)))


def _stiffening(
    eqs: PerturbationEquations, case: int, loop: JetLoop, sign: int, locus: RootLocus
) -> Stiffening:
    elastic = elastic_poles(eqs)
    way = locus.roots[:, [int(np.argmin(np.abs(locus.roots[0] - pole))) for pole in elastic]]
    factors = np.abs(way) / np.abs(way[0])
    good = ((factors >= 1 - 1e-6) & (way.imag > 1e-6)).all(axis=1)
    right = (locus.roots.real > 1e-7).sum(axis=1)
    return Stiffening(
        case,
        loop.sensor,
        loop.jet,
        sign,
        (float(factors[-1, 0]), float(factors[-1, 1])),
        VERDICTS[int(good[-1]) + int(good.all())],
        int(right[-1]),
        bool((right == 0).any()),
    )
