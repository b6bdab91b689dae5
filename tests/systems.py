"""Random vehicles, and how sets of roots are compared: by pairing, never by sorting."""

from dataclasses import replace

import numpy as np
from hypothesis import strategies as st
from scipy.optimize import linear_sum_assignment

import rlswaim as rl

LOOPS = {
    "rate_attitude": {"K_A": 1.8, "K_C": 10.0, "K_R": 0.618, "gyro": 60.0},
    "single_sensor": {"K_A": -3.14, "K_C": 1.75, "K_R": -0.286, "K_z": 0.2, "sensor": 140.0},
    "two_sensor": {
        "K_A": 1.2,
        "K_C": 10.0,
        "K_R": 0.5,
        "K_za": 0.3,
        "K_zb": -0.2,
        "sensor_a": 140.0,
        "sensor_b": 300.0,
    },
    "dual_actuation": {
        "K_A": 1.0,
        "K_C": 10.0,
        "K_R": 0.5,
        "kK_z": -2e5,
        "K_r": 20.0,
        "b": 0.5,
        "sensor": 140.0,
        "jet": 140.0,
    },
}
"""Each control system with gains of a size at which the loop matters."""


def closed_loop(name, eqs, **changes):
    """Return one of the report's systems at the gains of LOOPS, some of them changed."""
    return getattr(rl, name)(eqs, **{**LOOPS[name], **changes})


def mismatch(found, wanted):
    """Return the largest distance in the best pairing of two root sets, relative to the larger root or 1."""
    found, wanted = np.asarray(found, complex), np.asarray(wanted, complex)
    assert found.size == wanted.size, f"got {found.size} roots, wanted {wanted.size}"
    distance = np.abs(found[:, None] - wanted[None, :])
    rows, columns = linear_sum_assignment(distance)
    scale = np.maximum(np.maximum(np.abs(found[rows]), np.abs(wanted[columns])), 1.0)
    return float((distance[rows, columns] / scale).max(initial=0.0))


def polynomial_at(coefficients, s):
    """Return |p(s)| over the sum of its terms' sizes at |s| (at least .01): rounding leaves 1e-16 or so."""
    s, order = np.asarray(s)[..., None], np.arange(len(coefficients))
    size = np.maximum(np.abs(s), 0.01) ** order @ np.abs(coefficients)
    return np.abs(s**order @ coefficients) / size


def rounding_of(coefficients, s):
    """Return how far rounding of the coefficients moves roots (1/s), to first order."""
    p = np.polynomial.Polynomial(coefficients)
    size = np.abs(s)[:, None] ** np.arange(len(coefficients)) @ np.abs(coefficients)
    return np.finfo(float).eps * size / np.abs(p.deriv()(s))


def same_poles(A, B):
    """Say whether det(sI - A) = det(sI - B) at points around all eigenvalues of both."""
    size = 2 * max(np.linalg.norm(A, 2), np.linalg.norm(B, 2), 1.0)
    s = size * np.exp(2j * np.pi * np.arange(len(A) + 1) / (len(A) + 1.3))
    values = [np.linalg.det(s[:, None, None] * np.eye(len(M)) - M) for M in (A, B)]
    return np.allclose(*values, rtol=1e-9, atol=0)


def factors(low, high):
    return st.floats(low, high, allow_nan=False)


def zero_or(low, high):
    """Zero, or a number of a size that matters."""
    return st.just(0.0) | factors(low, high)


@st.composite
def boosters(draw):
    """Vehicles around the report's, each datum up to three times smaller or larger."""
    base = rl.swaim_booster()
    scale = {name: draw(factors(0.4, 2.5)) for name in ("M", "I_y", "S", "T")}
    modes = tuple(
        replace(
            mode,
            omega=mode.omega * draw(factors(0.4, 3.0)),
            zeta=draw(zero_or(0.001, 0.1)),
            mass=mode.mass * draw(factors(0.4, 2.5)),
            deflections=mode.deflections * draw(factors(0.5, 1.5)),
        )
        for mode in base.modes
    )
    flight = replace(base.flight, q_D=draw(zero_or(50.0, 3000.0)), U=draw(factors(500.0, 4000.0)))
    surfaces = tuple(
        replace(s, station=draw(factors(0.0, 420.0)), C_Nalpha=s.C_Nalpha * draw(factors(0.2, 3.0)))
        for s in base.surfaces
    )
    scaled = {name: getattr(base, name) * value for name, value in scale.items()}
    return replace(base, modes=modes, flight=flight, surfaces=surfaces, **scaled)


gains = zero_or(0.01, 20.0) | factors(-20.0, -0.01)
poles = factors(0.1, 50.0)
stations = factors(0.0, 420.0)
