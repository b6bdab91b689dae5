"""Section VII: the reaction jet, its three closures and Table 3 [Eqs. 120-137]."""

import numpy as np

from rlswaim.edition import table_3
from rlswaim.edition.matching import as_written, choices, printed_roots, roots_beside
from rlswaim.edition.printed_closures import final_design, printed_closure_2
from rlswaim.loops import closures
from rlswaim.loops.transfer_functions import closed_polynomial, elastic_numerator
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source.tables import printed
from rlswaim.vehicle.booster import swaim_booster
from rlswaim.vehicle.equations import ROWS, PerturbationEquations, perturbation_equations, printed_equations


def _determinants(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the entries of the determinants in Eqs. 131 and 132."""
    jets = {f"jet_{row}": closures.ARMS[row] * eqs.jet[row] for row in ROWS}
    number = as_written(eqs, "eq131-", "eq132-")
    return number | {f"{eq}-{name}": value for eq in ("eq131", "eq132") for name, value in jets.items()}


def _bracket(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the numbers in the braces of Eq. 133, and the factor before them."""
    bracket = closures.literal_bracket(eqs)
    numbers = {"eq133-scale": 1e-3 / eqs.U, "eq133-s4-1": -bracket[4, 0, 2], "eq133-s4-2": -bracket[4, 1, 3]}
    for power in range(4):
        for i in range(2):
            numbers |= {f"eq133-s{power}-{i + 1}-{row}": bracket[power, i, r] for r, row in enumerate(ROWS)}
    return numbers


def _closures(eqs: PerturbationEquations) -> dict[str, float]:
    """Return the roots and gains of Eqs. 135 to 137: each from what the report has printed before it."""
    loop, kK_z = final_design()
    wanted, printed_2 = closures.jet_numerator(eqs, loop), printed_closure_2()
    opened = closures.closure_2_open_loop(eqs, loop, kK_z, as_printed=True)
    gain = opened.num[0][0][0] / opened.den[0][0][0]
    closed = roots(closed_polynomial(printed_2))
    starts = ("eq135-", "text-closure1-", "text-closure2-")
    before = [list(printed_roots("VII", start).values()) for start in starts]
    elastic = roots(elastic_numerator(eqs, loop.sensor, "delta", loop.jet)[:6])
    theta, delta = roots(eqs.numerator("theta", "delta")), roots(eqs.characteristic_polynomial())
    return {
        "eq135-gain": wanted[5],
        **roots_beside("VII", "eq135-", roots(wanted[:6])),
        **roots_beside("VII", "text-closure1-", roots(closures.closure_1_polynomial(eqs, loop, kK_z))[1:]),
        "eq136-gain": gain,
        **roots_beside("VII", "eq136-zero-", np.array([-loop.b, *before[0], *elastic[1:]])),
        **roots_beside("VII", "eq136-pole-", np.array([*theta, *before[1]])),
        **roots_beside("VII", "text-closure2-", closed),
        "eq137-gain": eqs.numerator("theta", "delta")[5],
        **roots_beside("VII", "eq137-zero-", np.array(before[2])),
        **roots_beside("VII", "eq137-pole-", np.array([*delta[1:], *before[1]])),
    }


def factors_as_printed() -> tuple[float, float]:
    """Return the printed frequencies of closure 1 over those without the jet [Eq. 92], smaller ones first."""
    alone = sorted(abs(pole) for pole in printed_roots("IV", "eq92-p").values() if pole.imag)
    closed = sorted(abs(root) for root in printed_roots("VII", "text-closure1-").values() if root.imag)
    first, second = (after / before for before, after in zip(alone, closed, strict=True))
    return first, second


def _text(eqs: PerturbationEquations) -> dict[str, float]:
    """Return what the text counts and says of Table 3 and of Figures 24 and 25."""
    loop, kK_z = final_design()
    chosen, pairs = printed("VII", "fig25-"), table_3.trials(eqs)
    poles = roots(closures.closure_1_polynomial(eqs, loop, kK_z))[1:]
    third = closures.closure_3_open_loop(eqs, loop, kK_z, chosen["K_C"], chosen["K_R"])
    closed = roots(closed_polynomial(third))
    pseudo = (poles.imag == 0) & (np.abs(poles + loop.b) > 0.1)  # one real root is the sensor's, near -b
    return {
        "text-pairs": float(len(pairs)),
        "text-stiffened": float(sum(p.outcome == "rises throughout" for p in pairs)),
        "text-factor": float(min(factors_as_printed()) >= 10),
        "text-elastic": float(np.sum(poles.imag > 0)),
        "text-short": float(np.sum(pseudo)),
        "text-unstable": float(np.sum(closed.real > 0)),
        **choices("VII"),
    }


def computed() -> dict[str, float]:
    """Return our number for each row of section VII of ``data/printed.csv``, by its id."""
    eqs, own = printed_equations(), perturbation_equations(swaim_booster())
    jet = {f"eq125-{row}": -closures.ARMS[row] * own.jet[row] for row in ROWS}
    return jet | _determinants(eqs) | _bracket(eqs) | _closures(eqs) | _text(eqs)
