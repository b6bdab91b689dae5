"""Section VI: two linear sensors in inner loops [Eqs. 115-118, Figures 19 and 20]."""

import control

from rlswaim.edition.matching import choices, printed_roots, roots_beside
from rlswaim.edition.section_5 import printed_poles
from rlswaim.loops.factors import factored, from_factors
from rlswaim.loops.transfer_functions import inner_loop
from rlswaim.rootlocus.locus import root_locus
from rlswaim.source.tables import printed
from rlswaim.vehicle.equations import printed_equations


def printed_first_loop() -> control.TransferFunction:
    """Return Eq. 115 as printed, for K_za = 1 and K_C = 10."""
    zeros = [0.0, -1.0, *printed_roots("VI", "eq115-z").values()]
    p = printed("VI")
    return from_factors(p["fig19-K_C"] * p["eq115-gain"], zeros, printed_poles())


def printed_second_loop() -> control.TransferFunction:
    """Return Eq. 118 as printed, for K_zb = 1."""
    zeros = [0.0, -1.0, *printed_roots("V", "eq108-z").values()]
    return from_factors(printed("VI")["eq118-gain"], zeros, [0.0, *printed_roots("VI", "eq118-p").values()])


def computed() -> dict[str, float]:
    """Return our number for each row of section VI of ``data/printed.csv``, by its id.

    The zeros of Eq. 115 come from the equations of motion and the mode shapes; the poles of
    Eq. 118 are followed along the printed zeros.
    """
    chosen = printed("VI", "fig20-")
    K_C = chosen["K_C"]
    gain, zeros, _ = factored(inner_loop(printed_equations(), K_C, chosen["sensor_a"]))
    return (
        choices("VI")
        | {"eq115-gain": gain / K_C, "eq118-gain": K_C * printed("V")["eq108-gain"]}
        | roots_beside("VI", "eq115-z", zeros)
        | roots_beside("VI", "eq118-p", root_locus(printed_first_loop(), [chosen["K_za"]]).roots[0])
    )
