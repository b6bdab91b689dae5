"""Roots to 50 digits, root sets compared by pairing, and drawn branches beside exact ones."""

import mpmath
import numpy as np
from scipy.optimize import linear_sum_assignment

from rlswaim.rootlocus.adaptive_gains import SCREEN


def exact_roots(coefficients):
    """Return the roots (complex) of a polynomial with float or mpf coefficients, constant term first."""
    with mpmath.workdps(60):
        p, at_origin = [mpmath.mpf(c) for c in coefficients], 0
        while p and p[-1] == 0:
            p = p[:-1]
        while p[0] == 0:
            p, at_origin = p[1:], at_origin + 1
        found = mpmath.polyroots(p, asc=True, maxsteps=500, extraprec=200) if len(p) > 1 else []
        return np.array([complex(z) for z in found] + [0j] * at_origin)


def closed_loop(numerator, denominator, gain):
    """Return D + k N without rounding, as mpf, constant term first."""
    with mpmath.workdps(60):
        p = [mpmath.mpf(float(c)) for c in denominator]
        for i, c in enumerate(numerator):
            p[i] += mpmath.mpf(float(gain)) * mpmath.mpf(float(c))
        return p


def count_of_marks(system):
    """Return how many real break-aways and how many crossings the locus of a transfer function has.

    Those are real roots of D N' - N D', and roots w > 0 of Im D(jw) N(-jw); w = 0 counts if neither vanishes.
    """
    N, D = (np.polynomial.Polynomial(np.trim_zeros(p[0][0], "f")[::-1]) for p in (system.num, system.den))
    odd = (D * N(np.polynomial.Polynomial([0, -1]))).coef[1::2]  # over jw, as a polynomial in -w^2
    meetings, squares = exact_roots((D * N.deriv() - N * D.deriv()).coef), exact_roots(odd)
    real, on_axis = (np.abs(z.imag) <= 1e-9 * np.maximum(np.abs(z), 1e-3) for z in (meetings, squares))
    return real.sum(), (on_axis & (squares.real < -1e-12)).sum() + bool(N.coef[0] * D.coef[0])


def paired(found, wanted):
    """Return the wanted roots in the order of the found ones that makes the total distance least."""
    rows, columns = linear_sum_assignment(np.abs(found[:, None] - wanted[None, :]))
    return wanted[columns[np.argsort(rows)]]


def relative_errors(found, wanted):
    """Return each found root's relative distance from the wanted root it is paired with (absolute at 0)."""
    partner = paired(found, wanted)
    return np.abs(found - partner) / np.where(partner == 0, 1, np.abs(partner))


def off_the_chord(point, a, b):
    """Return how far a point lies off the chord from a to b."""
    if a == b:
        return abs(point - a)
    along = np.clip(((point - a) * (b - a).conjugate()).real / abs(b - a) ** 2, 0, 1)
    return abs(point - a - along * (b - a))


def off_the_polyline(exact, drawn, axes):
    """Return how far (pixels) exact roots in view lie off drawn branches (K, n), the worst one."""
    scale = np.array([SCREEN[0] / (axes[1] - axes[0]), SCREEN[1] / (axes[3] - axes[2])])
    at = np.stack([drawn.real, drawn.imag], axis=-1) * scale
    start, along = at[:-1].reshape(-1, 2), np.diff(at, axis=0).reshape(-1, 2)
    length2 = np.maximum((along**2).sum(axis=1), 1e-300)
    seen = exact[(exact.real > axes[0]) & (exact.real < axes[1]) & (np.abs(exact.imag) < axes[3])]
    worst = 0.0
    for point in np.stack([seen.real, seen.imag], axis=-1) * scale:
        t = np.clip(((point - start) * along).sum(axis=1) / length2, 0, 1)
        worst = max(worst, np.linalg.norm(start + t[:, None] * along - point, axis=1).min())
    return worst
