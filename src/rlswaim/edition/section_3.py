"""Section III: the vehicle without control [Eqs. 38-54]."""

import numpy as np
from numpy.typing import NDArray

from rlswaim.edition.matching import as_written
from rlswaim.rootlocus.polynomials import roots
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.coupling import partition
from rlswaim.vehicle.equations import ROWS, perturbation_equations, printed_equations


def _modal(name: str, polynomial: NDArray) -> dict[str, float]:
    """Return the real roots of a polynomial, and c1, c0, omega, zeta of each pair s^2 + c1 s + c0."""
    found = roots(polynomial)
    numbers = {f"{name}-unstable": max(found.real), f"{name}-stable": -min(found.real)}
    pairs = sorted((r for r in found if r.imag > 0), key=abs)
    for i, root in enumerate(pairs, start=1):
        omega = abs(root)
        numbers |= {f"{name}-c1_{i}": -2 * root.real, f"{name}-c0_{i}": omega**2}
        numbers |= {f"{name}-omega_{i}e": omega, f"{name}-zeta_{i}e": -root.real / omega}
    return numbers


def _coefficients() -> dict[str, float]:
    """Return Eq. 38 from the data of Section II: coefficients and the gust's column."""
    eqs = perturbation_equations(swaim_booster())
    gust = zip(ROWS, eqs.forcing("alpha_g"), strict=True)
    numbers = as_written(eqs, "eq38-")
    own = {"eq45-c1": eqs.coefficients["F1_q1dot"], "eq46-c0": eqs.coefficients["F1_q1"]}
    return numbers | own | {f"eq38-gust_{row}": float(value) for row, value in gust}


def computed() -> dict[str, float]:
    """Return our number for each row of section III of ``data/printed.csv``, by its id."""
    printed = printed_equations()
    rigid, parts = printed.characteristic_polynomial(order=2), partition(printed)
    omega = np.sqrt(rigid[1])
    return {
        **_coefficients(),
        "sec3-zeta_1": printed.modes[0].zeta,
        **as_written(printed, "eq42-", "eq48-"),
        **{"eq39-c1": rigid[2], "eq39-c0": rigid[1]},
        **{"eq39-omega_sp": omega, "eq39-zeta_sp": rigid[2] / (2 * omega)},
        **_modal("eq40", printed.characteristic_polynomial(order=3)),
        **_modal("eq41", printed.characteristic_polynomial()),
        **{f"eq50-s{power}": parts.uncoupled[power] for power in (4, 3, 2, 1)},
        **{f"eq51-s{power}": parts.coupling_undivided[power] for power in (3, 2, 1)},
    }
