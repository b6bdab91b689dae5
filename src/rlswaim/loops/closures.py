"""Section VII: three closures, a reaction jet for the modes and the thrust for the rigid body.

Polynomials run from the constant term up, over U as everywhere; gains have the report's signs.
"""

from typing import NamedTuple

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.loops.transfer_functions import elastic_numerator, transfer
from rlswaim.rootlocus.polynomials import determinant
from rlswaim.source import checks
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
