"""Root loci by compiled continuation: what `rlswaim.rootlocus.locus` does with numpy, some times faster.

Needs numba (the extra ``fast``); `rlswaim.rootlocus.fast` imports it where numba is there.
All roots at one gain are corrected together, by Aberth's iteration from the roots at the gain before it
or on both sides of it.  What can't be trusted is said so, and left to eigenvalues.  Polynomials run from
the constant term up.

A state is an array of six rows: the roots' real and imaginary parts; those of ds/dk, or nan where the
polynomial hardly knows it; the gain; and whether all roots are firm.  They are if the polynomial fixes
each to 12 digits, or better than the closed loop's matrix does, whose norm is norms[0] + |k| norms[1].
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

compiled = njit(cache=True, error_model="numpy")
FREE = -1  # in place of a partner: this root may leave the real axis, or its pair
DEPTH = 500  # states that may wait for being drawn, beside the first ones


@njit(cache=True, error_model="numpy", fastmath={"contract"})
def _horner(p: NDArray, sizes: NDArray, x: NDArray, y: NDArray, w: NDArray) -> None:
    """Write p(s), p'(s) (real and imaginary parts), sum of sizes times |s|^i, and |s|, into the rows of w."""
    a, b, c, d, terms, size = w[0], w[1], w[2], w[3], w[4], w[5]
    for j in range(x.size):
        a[j], b[j], c[j], d[j], terms[j] = p[-1], 0.0, 0.0, 0.0, sizes[-1]
        size[j] = np.sqrt(x[j] * x[j] + y[j] * y[j])
    for i in range(p.size - 2, -1, -1):
        here, here_size = p[i], sizes[i]
        for j in range(x.size):  # innermost, so that it runs on vectors
            c[j], d[j] = c[j] * x[j] - d[j] * y[j] + a[j], c[j] * y[j] + d[j] * x[j] + b[j]
            a[j], b[j] = a[j] * x[j] - b[j] * y[j] + here, a[j] * y[j] + b[j] * x[j]
            terms[j] = terms[j] * size[j] + here_size


@compiled
def _size(x: float, y: float) -> float:
    """Return |x + jy|, faster than hypot does; beyond 1e154 it is inf, and nothing is trusted."""
    return np.sqrt(x * x + y * y)


@compiled
def _over(a: complex, b: complex) -> complex:
    """Return a / b; nan for b = 0, where numba would raise an error."""
    size = b.real * b.real + b.imag * b.imag
    return complex((a.real * b.real + a.imag * b.imag) / size, (a.imag * b.real - a.real * b.imag) / size)


@njit(cache=True, error_model="numpy", fastmath={"reassoc", "contract", "nsz"})
def _push(x: NDArray, y: NDArray, j: int) -> complex:
    """Return the sum of 1/(s_j - s_i) over all other roots."""
    real, imag = 0.0, 0.0
    for i in range(x.size):
        dx, dy = x[j] - x[i], y[j] - y[i]
        square = dx * dx + dy * dy
        weight = 1 / square if square > 0 else 0.0
        real += dx * weight
        imag -= dy * weight
    return complex(real, imag)


@compiled
def _corrected(
    p: NDArray, sizes: NDArray, x: NDArray, y: NDArray, partner: NDArray, w: NDArray, steps: int
) -> bool:
    """Correct roots in place, pairs as pairs and real ones on the axis unless FREE; tell if trusted."""
    n = x.size
    done, left = np.zeros(n, np.bool_), n
    for _ in range(steps):
        _horner(p, sizes, x, y, w)
        left = 0
        for j in range(n):
            q = partner[j]
            if done[j] or 0 <= q < j:
                continue
            done[j] = max(abs(w[0, j]), abs(w[1, j])) <= 4e-16 * n * w[4, j]
            if done[j]:  # rounding is all that is left of p
                continue
            newton = _over(complex(w[0, j], w[1, j]), complex(w[2, j], w[3, j]))
            turn = newton * _push(x, y, j)
            step = _over(newton, 1 - turn)
            x[j], y[j] = x[j] - step.real, 0.0 if q == j else y[j] - step.imag
            if q > j:
                x[q], y[q] = x[j], -y[j]
            done[j] = abs(step) * abs(turn) <= 1e-14 * _size(x[j], y[j])
            left += not done[j]
        if left == 0:
            break
    return left == 0 and _all_there(p, x, y, w)


@compiled
def _all_there(p: NDArray, x: NDArray, y: NDArray, w: NDArray) -> bool:
    """Return whether the roots, and their inverses, add up to what the polynomial says, but for rounding."""
    total, inverse, size, inverse_size = p[-2] / p[-1], p[1] / p[0], 0.0, 0.0
    for j in range(x.size):
        if not w[4, j] < 1e300:
            return False
        own = _size(x[j], y[j])
        error = 1e-12 * own + 1e-15 * x.size * w[4, j] / max(_size(w[2, j], w[3, j]), 1e-300)
        total, size = total + x[j], size + error
        if p[0] != 0:
            inverse, inverse_size = inverse + x[j] / own**2, inverse_size + error / own**2
    return abs(total) <= size and (p[0] == 0 or abs(inverse) <= inverse_size)


@compiled
def _start(p: NDArray, x: NDArray, y: NDArray) -> None:
    """Write first guesses: on circles whose radii the upper hull of log |p_i| gives (Bini's choice)."""
    n, low = x.size, 0
    while low < n and p[low] == 0:
        x[low], y[low] = 0.0, 0.0
        low += 1
    heights = np.log(np.abs(p))  # -inf where p_i = 0, never on the hull
    while low < n:
        high, slope = low + 1, -np.inf
        for i in range(low + 1, n + 1):
            here = (heights[i] - heights[low]) / (i - low)
            if here >= slope:
                high, slope = i, here
        for j in range(low, high):
            angle = 2 * np.pi * ((j - low) / (high - low) + low / n) + 0.7
            x[j], y[j] = np.exp(-slope) * np.cos(angle), np.exp(-slope) * np.sin(angle)
        low = high


@compiled
def _partners(x: NDArray, y: NDArray, partner: NDArray) -> None:
    """Write which root is which one's conjugate, in a set of exact pairs; its own index for a real one."""
    partner[:] = FREE
    for j in range(x.size):
        if partner[j] == FREE:
            q = j
            if y[j] != 0:
                q = min(q + 1, x.size - 1)
                while q < x.size - 1 and (x[q] != x[j] or y[q] != -y[j]):
                    q += 1
            partner[j], partner[q] = q, j


@compiled
def _paired(x: NDArray, y: NDArray, partner: NDArray) -> bool:
    """Make free roots exact pairs, or real ones, in place; tell if that moved none by more than rounding."""
    sound = True
    for j in range(x.size):
        if partner[j] != FREE:
            continue
        q, least = j, 4 * y[j] ** 2
        for i in range(j + 1, x.size):
            distance = (x[i] - x[j]) ** 2 + (y[i] + y[j]) ** 2
            if partner[i] == FREE and distance < least:
                q, least = i, distance
        partner[j], partner[q] = q, j
        sound = sound and least <= 1e-12 * (x[j] ** 2 + y[j] ** 2)
        x[j], y[j] = (x[j] + x[q]) / 2, (y[j] - y[q]) / 2
        x[q], y[q] = x[j], -y[j]
        if q == j:
            y[j] = 0.0
    return sound


@compiled
def _solved(p: NDArray, sizes: NDArray, x: NDArray, y: NDArray, partner: NDArray, w: NDArray) -> bool:
    """Correct guesses to the roots, exact pairs; start anew if that fails; tell if trusted."""
    trusted = _corrected(p, sizes, x, y, partner, w, 25)
    if not trusted:
        _start(p, x, y)
        partner[:] = FREE
        trusted = _corrected(p, sizes, x, y, partner, w, 100)
    return _paired(x, y, partner) and trusted


@compiled
def roots(p: NDArray) -> tuple[NDArray, bool]:
    """Return all roots of a polynomial, and whether they are to be trusted: none double, or nearly so."""
    n, sizes = p.size - 1, np.abs(p)
    x, y, w, partner = np.empty(n), np.empty(n), np.empty((6, n)), np.full(n, FREE)
    _start(p, x, y)
    trusted = _solved(p, sizes, x, y, partner, w)
    for j in range(x.size):
        trusted = trusted and w[4, j] < 1e7 * _size(w[2, j], w[3, j]) * _size(x[j], y[j])
    return x + 1j * y, trusted


@compiled
def _assigned(cost: NDArray, order: NDArray) -> None:
    """Write the column of each row that makes the total cost least (Hungarian method, shortest paths)."""
    n = len(cost)
    u, v, row, way = np.zeros(n + 1), np.zeros(n + 1), np.zeros(n + 1, np.int64), np.zeros(n + 1, np.int64)
    for i in range(1, n + 1):
        row[0], j0 = i, 0
        least, used = np.full(n + 1, np.inf), np.zeros(n + 1, np.bool_)
        while row[j0] != 0:
            used[j0], delta, j1 = True, np.inf, 0
            for j in range(1, n + 1):
                if not used[j]:
                    here = cost[row[j0] - 1, j - 1] - u[row[j0]] - v[j]
                    if here < least[j]:
                        least[j], way[j] = here, j0
                    if least[j] < delta:
                        delta, j1 = least[j], j
            for j in range(n + 1):
                if used[j]:
                    u[row[j]] += delta
                    v[j] -= delta
                else:
                    least[j] -= delta
            j0 = j1
        while j0:
            row[j0], j0 = row[way[j0]], way[j0]
    for j in range(1, n + 1):
        order[row[j] - 1] = j - 1


@compiled
def _copy(source: NDArray, to: NDArray) -> None:
    for i in range(len(source)):
        for j in range(source.shape[1]):
            to[i, j] = source[i, j]


@compiled
def _order(before: NDArray, after: NDArray) -> None:
    """Put a state's columns in the order of the state before: nearest, or the least total distance."""
    n = before.shape[1]
    cost, order, reached = np.empty((n, n)), np.empty(n, np.int64), np.zeros(n, np.bool_)
    for i in range(n):
        least = np.inf
        for j in range(n):
            cost[i, j] = (before[0, i] - after[0, j]) ** 2 + (before[1, i] - after[1, j]) ** 2
            if cost[i, j] < least:
                order[i], least = j, cost[i, j]
        reached[order[i]] = True
    for j in range(n):
        if not reached[j]:
            _assigned(np.sqrt(cost), order)
            break
    unsorted = np.empty_like(after)
    _copy(after, unsorted)
    for i in range(4):
        for j in range(n):
            after[i, j] = unsorted[i, order[j]]


@compiled
def _state(N: NDArray, D: NDArray, k: float, norms: NDArray, state: NDArray, partner: NDArray) -> bool:
    """Correct a state's roots for D + k N and write the rest of it; tell if trusted."""
    x, y, w, none = state[0], state[1], np.empty((6, D.size - 1)), np.empty((6, D.size - 1))
    p, sizes = np.empty(D.size), np.empty(D.size)
    for i in range(D.size):
        p[i], sizes[i] = D[i] + k * N[i], abs(D[i]) + abs(k * N[i])
    trusted, firm = _solved(p, sizes, x, y, partner, w), True
    _horner(N, sizes, x, y, none)
    for j in range(x.size):
        size, slope = _size(x[j], y[j]), _size(w[2, j], w[3, j])
        firm = firm and w[4, j] <= slope * max(norms[0] + abs(k) * norms[1], 4e3 * size)
        tangent = _over(-complex(none[0, j], none[1, j]), complex(w[2, j], w[3, j]))
        known = slope * size > 1e-6 * w[4, j]
        state[2, j], state[3, j] = (tangent.real, tangent.imag) if known else (np.nan, np.nan)
    for j in range(x.size):
        state[4, j], state[5, j] = k, firm
    return trusted


@compiled
def follow(N: NDArray, D: NDArray, gains: NDArray, norms: NDArray) -> tuple[NDArray, bool]:
    """Return states (K, 6, n) of D + k N as branches, and whether all are to be trusted."""
    states, partner = np.empty((gains.size, 6, D.size - 1)), np.full(D.size - 1, FREE)
    for i in range(gains.size):
        if i == 0:
            _start(D + gains[0] * N, states[0, 0], states[0, 1])
        else:
            _copy(states[i - 1], states[i])
            _partners(states[i, 0], states[i, 1], partner)
        if not _state(N, D, gains[i], norms, states[i], partner):
            return states, False
        if i:
            _order(states[i - 1], states[i])
    return states, True


@compiled
def _between(low: NDArray, high: NDArray, k: float, state: NDArray, partner: NDArray) -> None:
    """Write a guess between two states; roots that change their partners on the way are free."""
    other, t = np.empty_like(partner), (k - low[4, 0]) / (high[4, 0] - low[4, 0])
    _partners(low[0], low[1], partner)
    _partners(high[0], high[1], other)
    for j in range(partner.size):
        for i in range(2):
            state[i, j] = (1 - t) * low[i, j] + t * high[i, j]
        if partner[j] != other[j]:
            partner[j] = FREE


@compiled
def _steepness(dx: float, dy: float, x: float, y: float) -> float:
    """Return the slope of a tangent (dx, dy) against the chord (x, y), 10 at most."""
    along = dx * x + dy * y
    return min(abs(dy * x - dx * y) / along, 10.0) if along > 0 else 10.0


@compiled
def _seen(x: float, y: float, view: NDArray) -> bool:
    """Return whether a point lies on the picture or close to it."""
    near = abs(x - (view[0] + view[1]) / 2) < 0.55 * (view[1] - view[0])
    return near and abs(y - (view[2] + view[3]) / 2) < 0.55 * (view[3] - view[2])


@compiled
def _pieces(low: NDArray, high: NDArray, view: NDArray) -> int:
    """Return into how many pieces an interval is to be cut: `picture._deviation`, for one interval."""
    a, b = low[4, 0], high[4, 0]
    if b - a <= 1e-9 * b or a < view[7] < b:
        return 1
    worst = 0.0
    for j in range(low.shape[1]):
        unknown = np.isnan(low[2, j]), np.isnan(high[2, j])
        seen = _seen(low[0, j], low[1, j], view) or _seen(high[0, j], high[1, j], view)
        if seen and not (unknown[0] and unknown[1]):
            x, y = view[4] * (high[0, j] - low[0, j]), view[5] * (high[1, j] - low[1, j])
            left = _steepness(view[4] * low[2, j], view[5] * low[3, j], x, y)
            right = _steepness(view[4] * high[2, j], view[5] * high[3, j], x, y)
            both = 2 * right if unknown[0] else 2 * left if unknown[1] else left + right
            worst = max(worst, 4 / 27 * both * _size(x, y))
    if worst <= view[6]:
        return 1
    return int(min(max(np.ceil(1.25 * np.sqrt(worst / view[6])), 2.0), 12.0))


@compiled
def picture(
    N: NDArray, D: NDArray, first: NDArray, norms: NDArray, view: NDArray, offset: float, most: int
) -> tuple[NDArray, bool]:
    """Return states (K, 6, n) true to the curve, and whether all are to be trusted.

    The ``first`` gains (falling) are among them.  ``view``: left, right, bottom, top (1/s), pixels per
    1/s in both directions, the tolerance (pixels), and the gain at which a root is at infinity (or nan).
    """
    waiting, trusted = follow(N, D, first, norms)
    n, top, count = D.size - 1, first.size - 1, 0
    states, stack, partner = np.empty((most, 6, n)), np.empty((top + DEPTH, 6, n)), np.empty(n, np.int64)
    for i in range(first.size):
        _copy(waiting[i], stack[i])
    while trusted and top >= 0:
        high, pieces = stack[top], 1
        if count:
            low = states[count - 1]
            _order(low, high)
            pieces = _pieces(low, high, view)
        if pieces == 1:
            _copy(high, states[count])
            count, top = count + 1, top - 1
            continue
        trusted = count + top + 12 < most and top + 12 < len(stack)
        for m in range(pieces - 1, 0, -1):
            a, b = low[4, 0] + offset, high[4, 0] + offset
            k, top = a * (b / a) ** (m / pieces) - offset, top + 1
            _between(low, high, k, stack[top], partner)
            trusted = trusted and _state(N, D, k, norms, stack[top], partner)
            if not trusted:
                break
    return states[:count], trusted
