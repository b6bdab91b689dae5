"""The polynomials that a locus in the browser follows, as functions of the value that runs."""

import math

import numpy as np

from browser_maths import factors_at, forms, sent


def loci_of(section: str) -> list[dict]:
    """Return the report's loops, the actuator's gain, and each station."""
    system = sent(section)
    more = [{"running": name, "off": [], "of": "poles"} for name in ("K_C", "K_R", *system["maps"])]
    return [*system["loci"], *more]


def polynomial_along(section: str, state: dict, what: dict):
    """Return the polynomial whose roots a locus follows, as a function of the running value or of many."""
    form = forms(section).polynomial
    size = max(len(term.coefficients) for term in form.terms)

    def value(t: float | np.ndarray, factors: dict[str, float]) -> np.ndarray:
        total = np.zeros((*np.shape(t), size))
        for term in form.terms:
            weight = math.prod(factors[f] for f in term.factors)
            total[..., : len(term.coefficients)] += np.multiply.outer(weight, term.coefficients)
        return total

    held = {**state, **dict.fromkeys(what["off"], 0.0)}

    def at(t: float | np.ndarray) -> np.ndarray:
        values = factors_at(section, {**held, what["running"]: t})
        if what["of"] == "zeros":
            return value(t, {**values, what["gain"]: 1.0}) - value(t, {**values, what["gain"]: 0.0})
        return value(t, values)

    return at
