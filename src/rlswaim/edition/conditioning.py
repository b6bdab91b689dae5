"""How well printed coefficients fix the roots: first order, and Monte Carlo within the last digit.

The state matrix of every loop here is an affine function of the 28 coefficients of Eq. 38 (U is taken as
exact).  So the loops are a `Family` with the coefficients as its factors, and are evaluated for many sets of
coefficients at once.  Zeros are roots too: those of theta over delta are the poles that are
left when the thrust holds theta at rest.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import control
import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from rlswaim.edition.printed_closures import final_design
from rlswaim.edition.section_4 import CLOSED_LOOPS
from rlswaim.loops.factors import as_text
from rlswaim.loops.family import Family
from rlswaim.loops.systems import dual_actuation, rate_attitude
from rlswaim.source import checks
from rlswaim.source.tables import half_unit, printed, read_table
from rlswaim.vehicle.equations import COEFFICIENTS, PerturbationEquations, printed_coefficients

Reduce = Callable[[NDArray, list[str]], NDArray]


def without(*names: str) -> Reduce:
    """Return a reduction that holds the states with these ``names`` at zero."""

    def reduced(A: NDArray, states: list[str]) -> NDArray:
        """Return the rows and columns of ``A`` that belong to the other ``states``."""
        kept = [i for i, state in enumerate(states) if state not in names]
        return A[..., kept, :][..., kept]

    return reduced


WHOLE = without()


def zeros_of_theta(A: NDArray, states: list[str]) -> NDArray:
    """Return the state matrices of what still moves while the thrust keeps theta at rest.

    Parameters
    ----------
    A : ndarray, shape (..., n, n)
        State matrices of a loop.
    states : list of str
        Names of its states.

    Returns
    -------
    ndarray, shape (..., n - 3, n - 3)
        Their eigenvalues are the zeros of theta over delta.
    """
    at, thrust = states.index("x_thetadot"), states.index("x_delta")
    rest = [i for i, state in enumerate(states) if state not in ("x_theta", "x_thetadot", "x_delta")]
    delta = -A[..., [at], :][..., rest] / A[..., [at], :][..., [thrust]]
    return A[..., rest, :][..., rest] + A[..., rest, :][..., [thrust]] * delta


class LoopInCoefficients(NamedTuple):
    """One loop for any coefficients: a family with them as factors, and the states that ``reduce`` leaves."""

    family: Family
    coefficients: NDArray
    reduce: Reduce

    def matrices(self, coefficients: NDArray) -> NDArray:
        """Return the state matrices (..., n, n) for ``coefficients`` (..., 28), ordered as COEFFICIENTS."""
        factors = dict(zip(COEFFICIENTS, np.moveaxis(coefficients, -1, 0), strict=True))
        return self.reduce(self.family.matrices(factors), list(self.family.states))

    @property
    def roots(self) -> NDArray:
        """The roots (1/s) for the printed coefficients, shape (n,), by size and then imaginary part."""
        found = np.linalg.eigvals(self.matrices(self.coefficients))
        return found[np.lexsort((found.imag, np.round(np.abs(found), 9)))]


def loop_in_coefficients(
    eqs: PerturbationEquations,
    build: Callable[[PerturbationEquations], control.StateSpace],
    reduce: Reduce = WHOLE,
) -> LoopInCoefficients:
    """Return one loop for any coefficients.

    Parameters
    ----------
    eqs : PerturbationEquations
        Where it starts from.
    build : callable
        Equations to closed loop, for instance a call of `rate_attitude` with fixed gains.
    reduce : callable
        From state matrices and names of the states to those wanted: `without` or `zeros_of_theta`.

    Returns
    -------
    LoopInCoefficients
    """
    checks.instance("eqs", eqs, PerturbationEquations, "loop_in_coefficients")

    def closed_loop(**coefficients: float) -> control.StateSpace:
        return build(replace(eqs, coefficients=coefficients))

    # The first row is divided by U, so that a sum of its entries is rounded.
    family = Family.of(closed_loop, [(name,) for name in COEFFICIENTS], tolerance=1e-12)
    return LoopInCoefficients(family, np.array([eqs.coefficients[name] for name in COEFFICIENTS]), reduce)


def sensitivity(loop: LoopInCoefficients) -> NDArray:
    """Return c ds/dc (1/s) of each root of a ``loop``: shape (n, 28), complex.

    An entry is by how much the root moves for a relative change 1 of a coefficient, to first order.
    The derivative of the matrix is taken with a complex step, so that it has no truncation error.
    """
    step = 1e-30 * loop.coefficients * np.eye(len(COEFFICIENTS))
    moved = loop.matrices(loop.coefficients + 1j * step).imag / 1e-30
    values, right = np.linalg.eig(loop.matrices(loop.coefficients))
    left = np.linalg.inv(right)
    slopes = np.einsum("ki,cij,jk->kc", left, moved, right)
    order = [int(np.abs(values - root).argmin()) for root in loop.roots]
    return slopes[order]


def half_units() -> NDArray:
    """Return half a unit of the last printed digit of each coefficient, shape (28,)."""
    return np.array([half_unit(text) for text in printed_coefficients().values()])


def monte_carlo(loop: LoopInCoefficients, samples: int = 2000, seed: int = 1964) -> NDArray:
    """Return the roots for coefficients uniform within half a unit of their last printed digit.

    Parameters
    ----------
    loop : LoopInCoefficients
    samples : int
    seed : int

    Returns
    -------
    ndarray of complex, shape (samples, n)
        Column j holds what `LoopInCoefficients.roots` [j] becomes: sets are paired by least total distance.
    """
    offsets = np.random.default_rng(seed).uniform(-1, 1, (samples, len(COEFFICIENTS))) * half_units()
    found = np.linalg.eigvals(loop.matrices(loop.coefficients + offsets))
    distance = np.abs(loop.roots[None, :, None] - found[:, None, :])
    columns = np.array([linear_sum_assignment(d)[1] for d in distance])
    return np.take_along_axis(found, columns, axis=1)


def first_order_spread(loop: LoopInCoefficients) -> NDArray:
    """Return the standard deviation (1/s) of each root of a ``loop``, shape (n,), to first order."""
    relative = half_units() / np.abs(loop.coefficients)
    return np.sqrt((np.abs(sensitivity(loop)) ** 2) @ (relative**2 / 3))


def printed_loops(eqs: PerturbationEquations, K_A: float = 3.0) -> dict[str, LoopInCoefficients]:
    """Return the loops whose roots the report prints or plots, by the place where it does.

    Parameters
    ----------
    eqs : PerturbationEquations
    K_A : float
        Amplifier gain of closure 3, for which the report names none; the other gains are printed.
    """
    number, chosen, (jet, kK_z) = printed("IV"), printed("VII", "fig25-"), final_design()

    def attitude(gyro: float | None, gain: float, reduce: Reduce = WHOLE) -> LoopInCoefficients:
        K_C, K_R = number["fig8-K_C"], number["eq75-K_R"]
        fixed: dict[str, Any] = {"K_A": gain, "K_C": K_C, "K_R": K_R, "gyro": gyro}
        return loop_in_coefficients(eqs, lambda e: rate_attitude(e, **fixed), reduce)

    def closure(gain: float, reduce: Reduce = WHOLE) -> LoopInCoefficients:
        rest = {"K_C": chosen["K_C"], "K_R": chosen["K_R"], "kK_z": kK_z, **jet._asdict()}
        return loop_in_coefficients(eqs, lambda e: dual_actuation(e, K_A=gain, **rest), reduce)

    loops = {"Eq. 41": attitude(None, 0.0, without("x_theta", "x_delta"))}
    loops["Eq. 92, zeros"] = attitude(None, 1.0, zeros_of_theta)
    for equation, (gyro, order) in CLOSED_LOOPS.items():
        reduce = WHOLE if order == 4 else without("x_q2", "x_q2dot")
        loops[f"Eq. {equation}"] = attitude(gyro, number["eq75-K_A"], reduce)
    loops["Figure 8"] = attitude(60, number["eq84-K_A"])
    loops["closure 1"] = closure(0.0, without("x_theta", "x_delta"))
    return loops | {"closure 2": closure(1.0, zeros_of_theta), "closure 3": closure(K_A)}


def root_spreads(loops: Mapping[str, LoopInCoefficients], samples: int = 2000) -> pd.DataFrame:
    """Return what the printed digits say of each root of some loops, one row for a real root or a pair.

    Parameters
    ----------
    loops : mapping of str to LoopInCoefficients
        By a name for the table.
    samples : int
        How many sets of coefficients are drawn.

    Returns
    -------
    DataFrame
        Columns: loop; root (1/s, upper one of a pair); spread (standard deviation of the samples
        over |root|); first order (the same to first order); real part (standard deviation of the real
        part over its size); right (share of samples right of the axis); coefficient (the one that moves
        the root most) and factor (percent of |root| for one percent of that coefficient).
    """
    rows: list[dict[str, object]] = []
    for name, loop in loops.items():
        roots, slopes, first, cloud = (
            loop.roots,
            sensitivity(loop),
            first_order_spread(loop),
            monte_carlo(loop, samples),
        )
        for k in np.flatnonzero((roots.imag >= 0) & (np.abs(roots) > 1e-9)):
            most, off, size = int(np.abs(slopes[k]).argmax()), cloud[:, k] - roots[k], abs(roots[k])
            rows.append(
                {
                    "loop": name,
                    "root": roots[k],
                    "spread": float(np.sqrt(np.mean(np.abs(off) ** 2)) / size),
                    "first order": first[k] / size,
                    "real part": float(np.sqrt(np.mean(off.real**2)) / abs(roots[k].real)),
                    "right": float((cloud[:, k].real > 0).mean()),
                    "coefficient": COEFFICIENTS[most],
                    "factor": abs(slopes[k, most]) / size,
                }
            )
    return pd.DataFrame(rows)


def as_texts(rows: pd.DataFrame) -> pd.DataFrame:
    """Return the ``rows`` of `root_spreads` as texts for a page, with numbers in percent."""
    latex = {row["symbol"]: f"${row['latex']}$" for row in read_table("coefficients")}
    percent = {
        "spread (%)": "spread",
        "to first order (%)": "first order",
        "of the real part (%)": "real part",
        "right of the axis (%)": "right",
    }
    found = {"loop": rows["loop"], "root (1/s)": [as_text([root], 4) for root in rows["root"]]}
    found |= {name: [f"{100 * x:.3g}" for x in rows[key]] for name, key in percent.items()}
    found["moved most by"] = [latex[name] for name in rows["coefficient"]]
    return pd.DataFrame(found | {"percent per percent": [f"{x:.3g}" for x in rows["factor"]]})
