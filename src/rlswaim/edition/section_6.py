"""Section VI: two linear sensors in inner loops [Eqs. 115-118, Figures 19 and 20]."""

import control

from rlswaim.edition.matching import printed_roots, roots_beside
from rlswaim.edition.section_4 import K_C
from rlswaim.edition.section_5 import printed_poles
from rlswaim.loops.factors import factored, from_factors
from rlswaim.loops.transfer_functions import inner_loop
from rlswaim.rootlocus.locus import root_locus
from rlswaim.source.tables import printed
from rlswaim.vehicle.equations import printed_equations

K_ZA, SENSOR_A, SENSOR_B = -0.144, 300.0, 140.0


def printed_first_loop() -> control.TransferFunction:
    """Return Eq. 115 as printed, for K_za = 1 and K_C = 10."""
    zeros = [0.0, -1.0, *printed_roots("VI", "eq115-z").values()]
    return from_factors(K_C * printed("VI")["eq115-gain"], zeros, printed_poles())


def printed_second_loop() -> control.TransferFunction:
    """Return Eq. 118 as printed, for K_zb = 1."""
    zeros = [0.0, -1.0, *printed_roots("V", "eq108-z").values()]
    return from_factors(printed("VI")["eq118-gain"], zeros, [0.0, *printed_roots("VI", "eq118-p").values()])


def computed() -> dict[str, float]:
    """Return our number for each row of section VI of ``data/printed.csv``, by its id.

    The zeros of Eq. 115 come from the equations of motion and the mode shapes; the poles of
    Eq. 118 are followed along the printed zeros.
    """
    gain, zeros, _ = factored(inner_loop(printed_equations(), K_C, SENSOR_A))
    choices = {"fig19-K_C": K_C, "fig19-sensor": SENSOR_A, "fig20-K_C": K_C, "fig20-K_za": K_ZA}
    choices |= {"fig20-sensor_a": SENSOR_A, "fig20-sensor_b": SENSOR_B}
    return (
        choices
        | {"eq115-gain": gain / K_C, "eq118-gain": K_C * printed("V")["eq108-gain"]}
        | roots_beside("VI", "eq115-z", zeros)
        | roots_beside("VI", "eq118-p", root_locus(printed_first_loop(), [K_ZA]).roots[0])
    )
