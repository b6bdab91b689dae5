"""Why printed numbers are as they are: computations that repeat the slip and end at the printed number.

``data/causes.csv`` says for each disagreement of more than rounding what was found, or what was
tried in vain.  This module computes the number that each found cause leads to.
"""

from typing import NamedTuple

import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import NDArray

from rlswaim.edition.matching import printed_roots, roots_beside
from rlswaim.edition.printed_closures import final_design, printed_closure_3
from rlswaim.edition.section_4 import closed_loop_roots
from rlswaim.edition.section_5 import quartic
from rlswaim.loops import closures
from rlswaim.loops.rigid_body_design import RigidBody, rigid_body, rigid_design
from rlswaim.loops.transfer_functions import closed_polynomial, displacement_numerator, elastic_numerator
from rlswaim.rootlocus.polynomials import roots
from rlswaim.source.tables import printed, read_table
from rlswaim.vehicle.equations import ROWS, PerturbationEquations, printed_equations, with_reading


class Cause(NamedTuple):
    """What went wrong in some rows of the ledger.

    ``found`` is "yes", "reading" (a value read off a figure) or "no".  ``to`` tells how near the repeated
    slip comes to the printed number: "last digit", "half a percent", "plot" (five percent of a root's
    size); it is empty where nothing can be repeated.
    """

    name: str
    rows: tuple[str, ...]
    found: str
    to: str
    what: str


def causes() -> tuple[Cause, ...]:
    """Return all causes, found or not, in the order of the report."""
    return tuple(
        Cause(r["cause"], tuple(r["rows"].split()), r["found"], r["to"], r["what"])
        for r in read_table("causes")
    )


def read_off() -> dict[int, tuple[float, float]]:
    """Return the deflections of both modes with which the report's later numbers are met, by station (ft)."""
    rows = read_table("deflections_read")
    return {int(row["station_ft"]): (float(row["phi_1"]), float(row["phi_2"])) for row in rows}


def rounded(x: float, digits: int) -> float:
    """Return a number rounded to some significant digits, halves away from zero.

    Parameters
    ----------
    x : float
    digits : int
        How many significant digits are kept.
    """
    return float(f"{x * (1 + 1e-12):.{digits - 1}e}")  # 24.65 goes up, as it does on paper


def _undivided(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    """Return Eqs. 61 to 76 with gain terms that are not divided by U."""
    body, K_C = rigid_body(eqs), p["fig8-K_C"]
    as_printed = RigidBody(*(p[f"eq61-{name}"] for name in ("c_0", "c_1", "g_0", "g_1")))
    gains = rigid_design(as_printed, omega=2.0, zeta=0.5, K_C=K_C)
    return {
        "eq61-g_1": body.g_1 * eqs.U,
        "eq61-g_0": body.g_0 * eqs.U,
        "eq73-gain": p["eq61-g_1"] * K_C,
        "eq74-gain": p["eq61-g_0"] * K_C,
        "eq75-K_A": gains.K_A,
        "eq76-s": 1 / (p["eq75-K_A"] * K_C),
        "eq76-1": 1 / p["eq75-K_A"],
    }


def _digits(eqs: PerturbationEquations, p: dict[str, float]) -> dict[str, float]:
    """Return the numbers with a digit too many or lost, or with the point elsewhere."""
    mode = closed_loop_roots(eqs, p["eq75-K_A"], p["eq75-K_R"], 400, order=3)
    short = f"{max(abs(mode[mode.imag > 0])) ** 2:.3g}"
    s3 = closures.literal_bracket(eqs)[3, 0, 1]
    return {
        "eq38-gust_M": -100 * eqs.coefficients["M_alpha"],
        "eq79-mode1-w2": float(short[:2] + "1" + short[2:]),
        "eq133-s3-1-M": np.trunc(s3 * 1e3) / 1e3,
    }


def _readings(eqs: PerturbationEquations) -> dict[str, float]:
    """Return gains and zeros that depend on deflections read off Figure 5."""
    drive = [eqs.coefficients["F1_delta"], eqs.coefficients["F2_delta"]]
    sums = {x: sum(rounded(p * f, 3) for p, f in zip(read_off()[x], drive, strict=True)) for x in (140, 300)}
    loop, kK_z = final_design()
    read = with_reading(eqs, loop.sensor, read_off()[39])
    top = sum(rounded(p * f, 3) for p, f in zip(read_off()[39], drive, strict=True))
    gain = -kK_z * loop.K_r * eqs.jet["Z"] * top / printed("IV")["eq92-gain"]
    zeros = roots_beside("VII", "eq136-zero-", _eq136_zeros(read, loop))
    names = ("gain", "zero-r5", "zero-r6", "zero-c2-re", "zero-c2-im")
    found = {f"eq136-{name}": ({"eq136-gain": gain} | zeros)[f"eq136-{name}"] for name in names}
    return found | {"eq108-gain": sums[140], "eq115-gain": sums[300]}


def _eq136_zeros(eqs: PerturbationEquations, loop: closures.JetLoop) -> NDArray:
    before = printed_roots("VII", "eq135-").values()
    elastic = roots(elastic_numerator(eqs, loop.sensor, "delta", loop.jet)[:6])
    return np.array([-loop.b, *before, *elastic[1:]])


def printed_bracket() -> NDArray:
    """Return the braces of Eq. 133 with the printed slips, in the form of `closures.literal_bracket`."""
    number = printed("VII", "eq133-")
    bracket = np.zeros((5, 2, 4))
    bracket[4, 0, 2], bracket[4, 1, 3] = -number["s4-1"], -number["s4-2"]
    for power in range(4):
        for i in range(2):
            bracket[power, i] = [number[f"s{power}-{i + 1}-{row}"] for row in ROWS]
    return bracket


def dropped_product(eqs: PerturbationEquations) -> NDArray:
    """Return the product that the factor of phi_1(z) phi_1(r) in Eq. 133 lacks, s^0 to s^3: shape (4,).

    The report's numbers follow if Z_alpha (s + M_thetadot)(s^2 + F2_q2dot s + F2_q2), a product of the
    cofactor, is left out.  The report does not say so; the cause was found here, by subtraction.
    """
    c = eqs.coefficients
    product = npp.polymul([c["M_thetadot"], 1.0], [c["F2_q2"], c["F2_q2dot"], 1.0])
    return -1000 * eqs.jet["F1"] * c["Z_alpha"] * product


def printed_closure_1_polynomial(eqs: PerturbationEquations) -> NDArray:
    """Return the characteristic polynomial of closure 1 from Eq. 133 as printed and `read_off`."""
    loop, kK_z = final_design()
    arms = [1, loop.jet - eqs.l_CG, *read_off()[140]]
    braces = np.einsum("kij,i,j->k", printed_bracket(), read_off()[39], arms)
    top = -printed("VII", "eq133-")["scale"] * kK_z * loop.K_r * npp.polymul([loop.b, 1.0], [0.0, *braces])
    return npp.polyadd(npp.polymul([loop.K_r, 1.0], eqs.characteristic_polynomial()), top)


def _section_7(eqs: PerturbationEquations) -> dict[str, float]:
    loop, _ = final_design()
    less = closures.literal_bracket(eqs)[:4, 0, 2] - dropped_product(eqs)
    alpha = closures.jet_numerator(eqs, loop, as_printed=True)
    return {
        **{f"eq133-s{power}-1-F1": float(value) for power, value in enumerate(less)},
        "eq135-gain": alpha[6],
        **roots_beside("VII", "eq135-", roots(alpha[:7])[1:]),
        **roots_beside("VII", "text-closure1-", roots(printed_closure_1_polynomial(eqs))[1:]),
        **_counts(loop),
    }


def _counts(loop: closures.JetLoop) -> dict[str, float]:
    """Return the numbers of roots that the text states, counted in Eq. 137 as printed."""
    poles = np.array(list(printed_roots("VII", "eq137-pole-").values()))
    real = poles[poles.imag == 0]
    opened = printed_closure_3(*(printed("VII", "fig25-")[name] for name in ("K_C", "K_R")))
    closed = roots(closed_polynomial(opened, 1e-6))
    return {
        "text-short": float(np.sum(np.abs(real + loop.b) > 0.1)),
        "text-elastic": float(np.sum(poles.imag > 0)),
        "text-unstable": float(np.sum(closed.real > 0)),
    }


def results() -> dict[str, float]:
    """Return the number that each repeated slip leads to, by the id of its row."""
    eqs, p = printed_equations(), printed("IV")
    found = _undivided(eqs, p) | _digits(eqs, p) | _readings(eqs) | _section_7(eqs)
    named = {row for cause in causes() if cause.to for row in cause.rows}
    return {row: float(value) for row, value in found.items() if row in named}


def quartic_differences(eqs: PerturbationEquations) -> NDArray:
    """Return the printed less our quartic of the sensors' zeros, at stations 140 and 300: shape (2, 5).

    From Eqs. 108 and 115, leading coefficients 1, constant term first.
    """
    rows = []
    for section, start, station in (("V", "eq108-z", 140), ("VI", "eq115-z", 300)):
        theirs = quartic(np.array(list(printed_roots(section, start).values())))
        ours = displacement_numerator(with_reading(eqs, station, read_off()[station]), station, b=0.0)[2:7]
        rows.append(theirs - ours / ours[-1])
    return np.array(rows)
