"""The schedule with the fewest designs whose frozen loops hold over the whole burn.

``python -m rlswaim.practice.schedule_search > src/rlswaim/source/data/schedule.csv`` takes minutes.
A design is the LQG with recovery of `rlswaim.practice.burn`, made for one time of the burn.  Two designs may
follow each other if there are times at which both hold, and the switch is in the middle of these.
"""

from itertools import combinations, pairwise, product

import numpy as np
from numpy.typing import NDArray

from rlswaim.practice import burn
from rlswaim.practice.designs import NOSE
from rlswaim.practice.dispersed import with_gravity
from rlswaim.practice.hardware import closed_loop, plant

TIMES = np.arange(1.0, 110.5)
"""At which the loops are frozen (s). At lift-off itself a root is zero under any design."""
CANDIDATES = (*np.arange(5.0, 107.6, burn.EACH), 110.0)
"""Times that a design is made for (s)."""


def largest_real_parts() -> NDArray:
    """Return the largest real part (1/s) of each candidate's loop at each time.

    Returns
    -------
    ndarray, shape (candidates, times)
    """
    plants = [plant(with_gravity(burn.booster_at(float(t))), burn.READS, jet=NOSE) for t in TIMES]
    controllers = [burn.made_for(float(t)) for t in CANDIDATES]
    found = [closed_loop(*pair).poles().real.max() for pair in product(plants, controllers)]
    return np.array(found).reshape(len(plants), -1).T


def held_spans(real_parts: NDArray) -> list[list[tuple[int, int]]]:
    """Return when each design holds, as places of the first and the last time of each unbroken span.

    Parameters
    ----------
    real_parts : ndarray, shape (candidates, times)
        Largest real parts (1/s).
    """
    spans = []
    for row in real_parts:
        edges = np.flatnonzero(np.diff(np.concatenate([[0], row < 0, [0]])))
        spans.append([(int(a), int(b) - 1) for a, b in edges.reshape(-1, 2)])
    return spans


def best_schedule(real_parts: NDArray, times: NDArray, candidates: NDArray) -> dict[float, float]:
    """Return the fewest designs that hold all the way, and of these the ones whose least overlap is longest.

    Among equals, the mean of the largest real part over the burn is least.

    Parameters
    ----------
    real_parts : ndarray, shape (candidates, times)
        Largest real parts (1/s).
    times, candidates : ndarray
        In s, in order.

    Returns
    -------
    dict of float to float
        When a design begins, and the time that it is made for (s).

    Raises
    ------
    ValueError
        If no schedule of up to four designs holds.
    """
    spans = [(a, b, i) for i, own in enumerate(held_spans(real_parts)) for a, b in own]
    for count in range(1, 5):
        best, found = (0.0, 0.0), {}
        for chain in combinations(sorted(spans), count):
            if chain[0][0] or chain[-1][1] < times.size - 1:
                continue
            shared = [(times[b], times[a]) for (_, a, _), (b, _, _) in pairwise(chain)]
            overlap = min((late - early for early, late in shared), default=np.inf)
            starts = [0.0, *(float((early + late) / 2) for early, late in shared)]
            parts = np.searchsorted(starts, times, side="right") - 1
            rows = np.array([i for *_, i in chain])[parts]
            rank = (float(overlap), -float(real_parts[rows, np.arange(times.size)].mean()))
            if overlap > 0 and rank > best:
                best, found = rank, dict(zip(starts, (float(candidates[i]) for *_, i in chain), strict=True))
        if found:
            return found
    raise ValueError(
        "candidates in best_schedule: got none that hold all the way, wanted four designs or fewer"
    )


def main() -> None:
    """Print the table ``schedule``."""
    print("begins,made_for")
    for begins, made_for in best_schedule(largest_real_parts(), TIMES, np.array(CANDIDATES)).items():
        print(f"{begins:g},{made_for:g}")


if __name__ == "__main__":
    main()
