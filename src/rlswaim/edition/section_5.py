"""Section V: one linear sensor in an inner loop [Eqs. 108-111, Figures 15 and 16]."""

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from scipy.optimize import brentq

from rlswaim.edition.matching import KINDS, choices, printed_roots, roots_beside
from rlswaim.loops.factors import factored, from_factors
from rlswaim.loops.rigid_body_design import WANTED
from rlswaim.loops.systems import single_sensor
from rlswaim.loops.transfer_functions import inner_loop
from rlswaim.rootlocus.locus import root_locus
from rlswaim.source.tables import printed
from rlswaim.vehicle.equations import PerturbationEquations, printed_equations


def printed_poles() -> list[complex]:
    """Return the open-loop poles (1/s) of Eqs. 108 and 115 as printed, those at the origin and -K_C too."""
    return [0.0, -printed("V")["fig15-K_C"], *printed_roots("IV", "eq92-p").values()]


def printed_inner_loop() -> control.TransferFunction:
    """Return Eq. 108 as printed, for K_z = 1 and K_C = 10."""
    zeros = [0.0, -1.0, *printed_roots("V", "eq108-z").values()]
    p = printed("V")
    return from_factors(p["fig15-K_C"] * p["eq108-gain"], zeros, printed_poles())


def printed_outer_loop(K_z: float | None = None) -> control.TransferFunction:
    """Return Eq. 111 for K_A = 1; its poles are the roots of the printed Eq. 108 closed at ``K_z``.

    Without a ``K_z`` (rad s/ft) it is that of Figure 16.
    """
    chosen = printed("V", "fig16-")
    K_R, K_z = chosen["K_R"], chosen["K_z"] if K_z is None else K_z
    zeros = [-1 / K_R, *printed_roots("IV", "eq92-z").values()]
    poles = root_locus(printed_inner_loop(), [K_z]).roots[0]
    gain = printed("V")["eq109-gain"] * chosen["K_C"] * K_R
    return from_factors(gain, zeros, poles[poles.imag >= 0])


def nearest_gain(
    loop: control.TransferFunction, wanted: complex, least: float, most: float
) -> tuple[float, complex]:
    """Return which gain brings a closed-loop root nearest to a wanted one, and that root (1/s).

    Where the distance is least, the root's way is square to the line to the wanted root; that equation
    is solved, between the gains of the drawn locus on both sides of the least distance.

    Parameters
    ----------
    loop : control.TransferFunction
        Open loop.
    wanted : complex
        In 1/s.
    least, most : float
        Bounds of the gain, above 0.
    """
    top, bottom = loop.num[0][0], loop.den[0][0]

    def nearest(gain: float) -> complex:
        found = root_locus(loop, [gain]).roots[0]
        return complex(found[np.abs(found - wanted).argmin()])

    def slope(gain: float) -> float:
        at = nearest(gain)
        way = -np.polyval(top, at) / np.polyval(np.polyadd(np.polyder(bottom), gain * np.polyder(top)), at)
        return float((np.conj(at - wanted) * way).real)

    gains = np.unique(np.clip(root_locus(loop).gains, least, most))
    at = int(np.argmin([abs(nearest(gain) - wanted) for gain in gains]))
    before, after = gains[max(at - 1, 0)], gains[min(at + 1, gains.size - 1)]
    gain = float(gains[at])
    if slope(before) < 0 < slope(after):
        gain = float(brentq(slope, before, after, xtol=1e-12 * gain, rtol=1e-14))
    return gain, nearest(gain)


def quartic(zeros: np.ndarray) -> np.ndarray:
    """Return s^4 + ... with these ``zeros`` (1/s; of a pair the upper one), constant term first."""
    pairs = np.concatenate([zeros, zeros[zeros.imag != 0].conj()])
    return npp.polyfromroots(pairs).real


def best_station(eqs: PerturbationEquations) -> float:
    """Return which sensor station (ft) of those tried leaves the rightmost root least far right.

    The gains are those of Figure 16, with K_z of either sign.
    """
    chosen = printed("V", "fig16-")
    gains, K_z = {name: chosen[name] for name in ("K_A", "K_C", "K_R")}, chosen["K_z"]

    def abscissa(station: float) -> float:
        loops = (single_sensor(eqs, **gains, K_z=sign * K_z, sensor=station) for sign in (1, -1))
        return float(min(loop.poles().real.max() for loop in loops))

    return min(printed("V", "sec5-sensor-").values(), key=abscissa)


def computed() -> dict[str, float]:
    """Return our number for each row of section V of ``data/printed.csv``, by its id.

    The zeros of Eq. 108 come from the equations of motion and the mode shapes; Figure 16 is
    followed along the printed zeros.
    """
    eqs = printed_equations()
    chosen, outer = printed("V", "fig16-"), printed_outer_loop()
    gain, zeros, _ = factored(inner_loop(eqs, chosen["K_C"], chosen["sensor"]))
    short = root_locus(outer, [chosen["K_A"]]).roots[0]
    at = min(short[short.imag > 0], key=lambda s: abs(s - WANTED))
    return {
        **choices("V"),
        "sec5-best": best_station(eqs),
        "eq108-gain": gain / chosen["K_C"],
        "eq109-gain": float(eqs.numerator("theta", "delta")[5]),
        "fig16-K_A": nearest_gain(outer, WANTED, least=1.0, most=1e3)[0],
        "fig16-sp-omega": KINDS["omega"](at),
        "fig16-sp-zeta": KINDS["zeta"](at),
    } | roots_beside("V", "eq108-z", zeros)
