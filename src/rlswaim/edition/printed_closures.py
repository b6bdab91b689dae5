"""The printed numbers of Section VII's closures: the chosen gains, printed roots, Eqs. 136 and 137."""

import control
import numpy as np
from numpy.polynomial import polynomial as npp

from rlswaim.edition.matching import printed_roots
from rlswaim.loops.closures import JetLoop
from rlswaim.loops.factors import from_factors
from rlswaim.source import checks
from rlswaim.source.tables import printed
from rlswaim.vehicle.equations import PerturbationEquations


def final_design() -> tuple[JetLoop, float]:
    """Return the jet's loop of Figures 24 and 25 and its gain k K_z (lb s/ft)."""
    chosen = printed("VII", "fig25-")
    return JetLoop(*(chosen[name] for name in ("K_r", "b", "sensor", "jet"))), chosen["kK_z"]


def printed_closure_2() -> control.TransferFunction:
    """Return Eq. 136 from its printed factors."""
    zeros, poles = (printed_roots("VII", f"eq136-{part}-").values() for part in ("zero", "pole"))
    return from_factors(printed("VII", "eq136-")["gain"], [*zeros, 0.0, 0.0], [*poles, 0.0])


def printed_closure_3(K_C: float, K_R: float) -> control.TransferFunction:
    """Return Eq. 137 from its printed factors, for K_A = 1.

    Parameters
    ----------
    K_C, K_R : float
        Actuator (1/s) and rate gyro (s) gains.
    """
    zeros, poles = (printed_roots("VII", f"eq137-{part}-").values() for part in ("zero", "pole"))
    gain = printed("VII", "eq137-")["gain"] * K_C * K_R
    return from_factors(gain, [*zeros, 0.0, -1 / K_R], [*poles, -K_C, 0.0, 0.0])


def fitted_deflections(eqs: PerturbationEquations, loop: JetLoop, kK_z: float) -> tuple[float, float]:
    """Return phi_1(z), phi_2(z) that bring closure 1 nearest to its printed roots.

    The relative errors of the coefficients of s to s^6, in which both are linear, have the least sum
    of squares.

    Parameters
    ----------
    eqs : PerturbationEquations
    loop : JetLoop
    kK_z : float
        Gain of the jet's loop (lb s/ft).

    Returns
    -------
    tuple of float
    """
    p = printed_roots("VII", "text-closure1-").values()
    wanted = npp.polyfromroots([0.0, *p, *(z.conjugate() for z in p if z.imag)]).real[1:7]
    base = npp.polymul(loop.valve, eqs.characteristic_polynomial())[1:7]
    numerators = [eqs.numerator(q, "delta_r", loop.jet)[:6] for q in ("q1", "q2")]
    gain = -checks.real("kK_z", kK_z, "fitted_deflections") * loop.K_r
    effect = [gain * npp.polymul(loop.reading, n)[1:7] / wanted for n in numerators]
    phi = np.linalg.lstsq(np.array(effect).T, (wanted - base) / wanted, rcond=None)[0]
    return float(phi[0]), float(phi[1])
