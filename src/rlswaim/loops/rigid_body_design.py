"""The rigid-body design of Section IV: gains for a wanted short period [Eqs. 60-75].

The characteristic equation of the rigid body, divided by U, is::

    s^4 + [K_C + c_1] s^3 + [c_1 K_C + g_1 y + c_0] s^2 + [c_0 K_C + g_0 y + g_1 x] s + g_0 x = 0

with x = K_A K_C and y = K_A K_C K_R.  The report divides c_0 and c_1 by U but
leaves the division out of g_0 and g_1 [Eq. 61]: its 1940 should be 1.042.
"""

from dataclasses import dataclass

import numpy as np

from rlswaim.source import checks
from rlswaim.source.quantity import quantity, unit_of
from rlswaim.vehicle.equations import PerturbationEquations

WANTED = complex(-1.0, np.sqrt(3.0))
"""The short period that the report asks for: 2 rad/s, damping ratio .5 [Section IV]."""


@dataclass(frozen=True)
class RigidBody:
    """Coefficients of the rigid-body characteristic equation [Eq. 61]."""

    c_0: float = quantity("c_0", "1/s^2", "constant term without control", "Eq. 61")
    c_1: float = quantity("c_1", "1/s", "coefficient of s without control", "Eq. 61")
    g_0: float = quantity("g_0", "1/s^3", "what K_A K_C adds to the constant term", "Eq. 61")
    g_1: float = quantity("g_1", "1/s^2", "what K_A K_C adds to the coefficient of s", "Eq. 61")


@dataclass(frozen=True)
class RigidDesign:
    """Gains that place the short period, and the two real roots that come with them [Eqs. 72-75]."""

    K_A: float = quantity("K_A", unit_of("K_A"), "amplifier gain", "Section IV")
    K_R: float = quantity("K_R", unit_of("K_R"), "rate gyro gain", "Section IV")
    a: float = quantity("a", "1/s", "larger of the two real roots, negated", "Eq. 62")
    b: float = quantity("b", "1/s", "smaller of the two real roots, negated", "Eq. 62")


def rigid_body(eqs: PerturbationEquations, divided: bool = True) -> RigidBody:
    """Return the coefficients of Eq. 61 from Eq. 60.

    Parameters
    ----------
    eqs : PerturbationEquations
    divided : bool
        False leaves the division by U out of the gain terms, as the report does.

    Returns
    -------
    RigidBody
    """
    free = eqs.characteristic_polynomial(order=2)
    gain = eqs.numerator("theta", "delta", order=2) * (1.0 if divided else eqs.U)
    return RigidBody(c_0=float(free[1]), c_1=float(free[2]), g_0=float(gain[0]), g_1=float(gain[1]))


def rigid_design(body: RigidBody, *, omega: float, zeta: float, K_C: float) -> RigidDesign:
    """Return the gains that give the rigid body a wanted short period [Eqs. 64-75].

    Parameters
    ----------
    body : RigidBody
    omega, zeta : float
        Wanted undamped frequency (rad/s) and damping ratio.
    K_C : float
        Actuator gain (1/s).

    Returns
    -------
    RigidDesign

    Raises
    ------
    ValueError
        If an argument is not finite, omega or K_C is not positive, or a and b are not real.
    """
    where = "rigid_design"
    omega, K_C = checks.positive("omega", omega, where), checks.positive("K_C", K_C, where)
    d, w2 = 2 * checks.real("zeta", zeta, where) * omega, omega**2
    total = K_C + body.c_1 - d  # a + b, [Eq. 64]
    matrix = [[0, body.g_1, -1], [body.g_1, body.g_0, -d], [body.g_0, 0, -w2]]
    right = [w2 + d * total - body.c_1 * K_C - body.c_0, w2 * total - body.c_0 * K_C, 0]
    x, y, product = np.linalg.solve(matrix, right)  # K_A K_C, K_A K_C K_R, a b [Eqs. 65-67]
    if total**2 < 4 * product:
        raise ValueError(f"a, b in {where}: got a + b = {total:g}, a b = {product:g}, wanted real roots")
    a = (total + np.sqrt(total**2 - 4 * product)) / 2
    return RigidDesign(K_A=float(x / K_C), K_R=float(y / x), a=float(a), b=float(product / a))
