"""Section III: the vehicle without control [Eqs. 38-54]."""

from rlswaim.perturbation import printed_equations
from rlswaim.polynomials import roots


def computed() -> dict[str, float]:
    """Return our number for each row of ``data/printed_III.csv``, by its id."""
    short_period = printed_equations().characteristic_polynomial(order=2)
    full = roots(printed_equations().characteristic_polynomial())
    return {"eq39-c1": short_period[2], "eq39-c0": short_period[1], "eq41-unstable": max(full.real)}
