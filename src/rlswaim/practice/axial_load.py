"""The thrust's compression of the bent body, which the report leaves out.

The thrust T pushes at G and the masses resist along the body, so that at a station l the body is pressed
by P(l) = T (mass ahead of l)/M, without drag.  A pressed body is easier to bend.  In the equation of mode i
the compression adds to F_iq_j ::

    K_ij = -(1/M_i) times the integral of P sigma_i sigma_j from nose to tail        (1/s^2)

Eq. 29 has the other half of the thrust's work alone, -(T/M_i) sigma_j(G) phi_i(G), because it turns with the
axis at G.  For a shape that is a mere rotation the two cancel, as they must: turning a body bends nothing.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from rlswaim.source import checks
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import PerturbationEquations

STEP = 0.05
"""Width of the cells that the integral sums (ft): a part of 1 ft, so that no cell holds a mass inside."""


def axial_stiffness(booster: Booster) -> NDArray:
    """Return what the compression adds to the coefficients F_iq_j.

    Parameters
    ----------
    booster : Booster
        Its masses stand at whole feet.

    Returns
    -------
    ndarray, shape (n, n)
        1/s^2, by equation i and column q_j, for n modes.

    Raises
    ------
    TypeError
        If it is no booster.
    """
    checks.instance("booster", booster, Booster, "axial_stiffness")
    middles = np.arange(STEP / 2, booster.thrust_station, STEP)
    ahead = booster.masses @ (booster.stations[:, None] < middles)
    compression = booster.T * ahead / booster.masses.sum()
    slopes = np.array([mode.slope(middles) for mode in booster.modes])
    masses = np.array([mode.mass for mode in booster.modes])
    return -(slopes * compression) @ slopes.T * STEP / masses[:, None]


def with_axial_load(eqs: PerturbationEquations, booster: Booster) -> PerturbationEquations:
    """Return the equations of motion with the compression of the body.

    Parameters
    ----------
    eqs : PerturbationEquations
        Made from the booster, or with the report's rounded coefficients.
    booster : Booster

    Returns
    -------
    PerturbationEquations

    Raises
    ------
    ValueError
        If the equations have another number of modes.
    TypeError
        If one of both is of another class.
    """
    checks.instance("eqs", eqs, PerturbationEquations, "with_axial_load")
    added = axial_stiffness(booster)
    if len(eqs.modes) != len(added):
        raise ValueError(
            f"modes in with_axial_load: got {len(added)} of the booster, wanted {len(eqs.modes)}"
        )
    more = {f"F{i + 1}_q{j + 1}": float(value) for (i, j), value in np.ndenumerate(added)}
    both = {name: value + more.get(name, 0.0) for name, value in eqs.coefficients.items()}
    return replace(eqs, coefficients=both, source=f"{eqs.source}, with axial load")
