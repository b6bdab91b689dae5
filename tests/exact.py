"""Roots to 50 digits, and root sets compared by pairing."""

import mpmath
import numpy as np
from scipy.optimize import linear_sum_assignment


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


def paired(found, wanted):
    """Return the wanted roots in the order of the found ones that makes the total distance least."""
    rows, columns = linear_sum_assignment(np.abs(found[:, None] - wanted[None, :]))
    return wanted[columns[np.argsort(rows)]]


def relative_errors(found, wanted):
    """Return each found root's relative distance from the wanted root it is paired with (absolute at 0)."""
    partner = paired(found, wanted)
    return np.abs(found - partner) / np.where(partner == 0, 1, np.abs(partner))
