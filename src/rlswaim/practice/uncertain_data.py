"""How far all data of a vehicle may be off at once: bounds of the structured singular value.

``python -m rlswaim.practice.uncertain_data`` prints ``data/uncertain_data.csv``.

Each factor of ``data/dispersions.csv`` is nominal at d_i = 0 and at its ends at d_i = -1 and 1.  To the first
order the closed loop is A + sum d_i E_i F_i, with thin E_i and F_i.  On the line s = a + j omega, a being the
slowest root that counts as stable, det(I - M diag(d_i)) = 0 says that a root has come upon it, with
M = F (s I - A)^-1 E.  mu is one over the least size of all real d_i for which that happens.

Above, mu is bounded by `singular_value.upper_bound`.  Below, a vehicle that is lost is a proof; it is closed
in full too, not to the first order alone.
"""

import sys
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import matrix_balance
from scipy.optimize import brentq

from rlswaim.edition.adaptation import adapted
from rlswaim.practice.designs import Design, designs
from rlswaim.practice.dispersed import (
    consistent_booster,
    dispersed,
    factor_names,
    factors_at,
    with_gravity,
)
from rlswaim.practice.singular_value import upper_bound
from rlswaim.practice.synthesis import slowest
from rlswaim.source.tables import number, read_table

SMALL = 1e-3
"""Step of d for the derivatives."""
THIN = 1e-7
"""Singular values of a derivative below this share of the largest are its rounding."""
FREQUENCIES = np.r_[0.0, np.geomspace(0.03, 20.0, 19)]
"""Where mu is bounded before its peaks are refined (rad/s)."""
SEED, GENERATIONS, HALVINGS = 1964, 50, 6
LEAST, MOST = 0.05, 8.0
"""Times the spreads, between which a lost vehicle is looked for: beyond, data would change their sign."""
JUDGED = (
    "VII, modest jet, ideal",
    "LQG, nose jet",
    "LQG with recovery, nose jet",
)
"""Designs whose bounds are stored."""
REFINED = 4
"""Rounds in which two frequencies are added about the highest peak."""


def matrix_at(design: Design, d: NDArray) -> NDArray:
    """Return the matrix of a design's closed loop around a vehicle.

    Parameters
    ----------
    design : Design
    d : ndarray, shape (factors,)
        As in `dispersed.factors_at`.
    """
    return np.asarray(design.closed(with_gravity(dispersed(consistent_booster(), factors_at(d)))).A)


class Uncertain(NamedTuple):
    """A closed loop to the first order: A, and the derivatives E_i F_i in thin factors."""

    A: NDArray
    E: tuple[NDArray, ...]
    F: tuple[NDArray, ...]

    def at(self, d: NDArray) -> NDArray:
        """Return A + sum d_i E_i F_i."""
        return self.A + sum(x * E @ F for x, E, F in zip(d, self.E, self.F, strict=True))

    def M(self, s: complex) -> NDArray:
        """Return F (s I - A)^-1 E, with all factors side by side."""
        inner = np.linalg.solve(s * np.eye(len(self.A)) - self.A, np.hstack(self.E))
        return np.vstack(self.F) @ inner


def uncertain(design: Design) -> Uncertain:
    """Return a design's closed loop to the first order in all factors, states in like sizes.

    Parameters
    ----------
    design : Design
    """
    zero = np.zeros(len(factor_names()))
    A, (scale, _) = matrix_balance(matrix_at(design, zero), permute=False, separate=True)
    E, F = [], []
    for unit in np.eye(zero.size):
        slope = (matrix_at(design, SMALL * unit) - matrix_at(design, -SMALL * unit)) / (2 * SMALL)
        slope *= scale / scale[:, None]
        U, sizes, V = np.linalg.svd(slope)
        r = max(1, int((sizes > THIN * sizes[0]).sum()))
        root = np.sqrt(sizes[:r])
        E.append(U[:, :r] * root)
        F.append(root[:, None] * V[:r])
    return Uncertain(A, tuple(E), tuple(F))


def over_frequency(system: Uncertain, crossing: float) -> tuple[NDArray, NDArray]:
    """Return frequencies (rad/s) and upper bounds of mu there.

    Peaks of mu for real factors are narrow.  So the frequencies are those of a grid, of the loop's own roots
    and of a crossing that is known, and then those halfway from the largest to its neighbors.

    Parameters
    ----------
    system : Uncertain
    crossing : float
        Where a root of a lost vehicle crosses the line (rad/s).
    """
    sizes = tuple(E.shape[1] for E in system.E)
    own = np.abs(np.linalg.eigvals(system.A).imag)
    inside = own[(own > FREQUENCIES[1]) & (own < FREQUENCIES[-1])]
    omega = np.unique(np.round([*FREQUENCIES, *inside, crossing], 9))
    values = np.array([upper_bound(system.M(slowest() + 1j * w), sizes) for w in omega])
    for _ in range(REFINED):
        at = int(values.argmax())
        for i in (at + 1, at):
            if 0 < i < omega.size:
                middle = (omega[i - 1] + omega[i]) / 2
                bound = upper_bound(system.M(slowest() + 1j * middle), sizes)
                omega, values = np.insert(omega, i, middle), np.insert(values, i, bound)
    return omega, values


def _right(matrix: NDArray) -> float:
    """Return by how much (1/s) a root lies right of the slowest that counts as stable."""
    return float(np.linalg.eigvals(matrix).real.max()) - slowest()


def _worst_in(system: Uncertain, size: float) -> tuple[NDArray, float]:
    """Return the d of a size at most that an evolution finds worst, to the first order, and its `_right`."""
    rng = np.random.default_rng(SEED)

    def cost(u: NDArray) -> NDArray:
        return np.array([-_right(system.at(size * (2 * place - 1))) for place in u.T])

    corners = rng.integers(0, 2, (len(system.E), 200)).astype(float)
    place, least = adapted(cost, corners[:, cost(corners).argmin()], 0.2, rng, GENERATIONS)
    return size * (2 * place - 1), -least


class Lost(NamedTuple):
    """The smallest d found that loses a vehicle: its size to the first order, in full, and that d in full.

    ``crossing`` is where its root crosses the line, to the first order (rad/s).
    """

    first_order: float
    size: float
    d: NDArray
    crossing: float


def lost_vehicle(design: Design, system: Uncertain) -> Lost:
    """Return the smallest d that is found to lose a vehicle.

    Parameters
    ----------
    design : Design
    system : Uncertain
        The same, to the first order; the search goes along it, and then out on the ray of what it found.

    Returns
    -------
    Lost
        Sizes are inf if none is lost up to `MOST` times the spreads.
    """
    low, high = LEAST, MOST
    worst, right = _worst_in(system, high)
    if right <= 0:
        return Lost(float("inf"), float("inf"), worst, 0.0)
    for _ in range(HALVINGS):
        middle = float(np.sqrt(low * high))
        d, right = _worst_in(system, middle)
        low, high, worst = (low, middle, d) if right > 0 else (middle, high, worst)
    unit = worst / np.abs(worst).max()
    border = brentq(lambda size: _right(system.at(size * unit)), 1e-6, np.abs(worst).max())
    roots = np.linalg.eigvals(system.at(border * unit))
    crossing = float(abs(roots[roots.real.argmax()].imag))
    for size in np.geomspace(border / 3, 3 * border, 80):
        if _right(matrix_at(design, size * unit)) > 0:
            return Lost(float(border), float(size), size * unit, crossing)
    return Lost(float(border), float("inf"), worst, crossing)


class Bounds(NamedTuple):
    """Bounds of mu of one design.

    ``upper`` is the largest over frequency, at ``omega`` (rad/s); ``first_order`` is the lower bound of the
    same; ``lower`` is one over the size of a vehicle that is lost in full, whose d are in ``lost`` by factor.
    """

    upper: float
    omega: float
    first_order: float
    lower: float
    lost: dict[str, float]
    curve: tuple[NDArray, NDArray]


def bounds(design: Design) -> Bounds:
    """Return bounds of mu of a ``design``, in half a minute."""
    system = uncertain(design)
    found = lost_vehicle(design, system)
    omega, values = over_frequency(system, found.crossing)
    lost = dict(zip(factor_names(), found.d.tolist(), strict=True))
    top, at = float(values.max()), float(omega[values.argmax()])
    return Bounds(top, at, 1 / found.first_order, 1 / found.size, lost, (omega, values))


def stored() -> dict[str, Bounds]:
    """Return the stored table ``data/uncertain_data.csv`` by design."""
    rows: dict[str, list[tuple[str, float, float]]] = {}
    for row in read_table("uncertain_data"):
        rows.setdefault(row["design"], []).append((row["quantity"], number(row["at"]), number(row["value"])))
    found = {}
    for name, all_ in rows.items():
        single = {quantity: (at, value) for quantity, at, value in all_}
        curve = np.array(
            [(at, value) for quantity, at, value in all_ if quantity == "upper over frequency"]
        ).T
        lost = {factor: single[factor][1] for factor in factor_names()}
        upper = single["upper"]
        first, lower = single["first order"][1], single["lower"][1]
        found[name] = Bounds(upper[1], upper[0], first, lower, lost, (curve[0], curve[1]))
    return found


def main() -> None:
    """Print the table ``data/uncertain_data.csv``."""
    print("design,quantity,at,value")
    for name, design in designs().items():
        if name not in JUDGED:
            continue
        found = bounds(design)
        rows = [("upper", found.omega, found.upper)]
        rows += [("first order", 0.0, found.first_order), ("lower", 0.0, found.lower)]
        rows += [(factor, 0.0, value) for factor, value in found.lost.items()]
        rows += [("upper over frequency", w, v) for w, v in zip(*found.curve, strict=True)]
        for quantity, at, value in rows:
            print(f'"{name}",{quantity},{at:.6g},{value:.6g}', flush=True)
        print(name, found[:4], file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
