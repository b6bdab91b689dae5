"""Other cases of Greensite's vehicle, by polynomials in 40 digits and by python-control's margins."""

import warnings

import control
import mpmath as mp
import numpy as np
import pytest

from rlswaim.practice import agreement
from rlswaim.practice import greensite as g
from rlswaim.practice.margins import margins
from rlswaim.source.tables import constants

mp.mp.dps = 40
C = {name: mp.mpf(str(value)) for name, value in constants("greensite").items()}
CASES = {
    "as printed": {"K_p": 1.73, "K_d": 0.69},
    "no notch": {"K_p": 1.73, "K_d": 0.69, "notch": False},
    "rigid, printed": {"K_p": 1.78, "K_d": 0.44, "notch": False, "bending": False, "actuator": False},
    "rigid, hardware": {"K_p": 1.78, "K_d": 0.44, "notch": False, "bending": False},
    "mode, ideal engine": {"K_p": 1.2, "K_d": 0.3, "notch": False, "actuator": False},
    "more air": {"K_p": 1.73, "K_d": 0.69, "mu_alpha": 1.3},
    "both, mode low": {"K_p": 2.4, "K_d": 0.5, "mu_alpha": 0.7, "mu_c": 1.3, "omega": 0.9},
    "mode high": {"K_p": 1.73, "K_d": 0.69, "omega": 1.1},
    "no drift control": {"K_p": 0.9, "K_d": 0.8, "K_z": 0.0, "K_zdot": 0.0},
    "drift gains up": {"K_p": 1.5, "K_d": 0.9, "K_z": 4e-4, "K_zdot": -3e-3},
    "load relief": {"K_p": 0.8, "K_d": 0.8, "K_z": 0.0, "K_zdot": 1e-3, "mu_alpha": 0.9},
}


def times(*factors):
    """Multiply polynomials, highest power first, without rounding to double."""
    product = np.array([mp.mpf(1)], dtype=object)
    for one in factors:
        product = np.convolve(product, np.array([mp.mpf(x) for x in one], dtype=object))
    return product


def plus(*terms):
    size = max(len(one) for one in terms)
    return sum(
        np.concatenate([np.array([mp.mpf(0)] * (size - len(one)), dtype=object), one]) for one in terms
    )


def value(p, s):
    """Return a polynomial, highest power first, at s."""
    return mp.polyval(list(p)[::-1], s, asc=True)


class Exact:
    """One case as polynomials: L = top/bottom, and what the wind does."""

    def __init__(self, K_p, K_d, **given):
        given = (g.greensite.__kwdefaults__ or {}) | given
        K_p, K_d, K_z, K_zdot = (mp.mpf(str(k)) for k in (K_p, K_d, given["K_z"], given["K_zdot"]))
        A6, K1 = (C[k] * mp.mpf(str(given[f])) for k, f in (("A6", "mu_alpha"), ("K1", "mu_c")))
        a1V, w = C["a1"] * C["V"], C["omega"] * mp.mpf(str(given["omega"]))
        a, b = [1, -C["a1"], 0], [-(a1V + C["a4"])]
        c, d = [-A6 / C["V"], 0], [1, 0, -A6]
        self.rigid = plus(times(a, d), -times(b, c))
        self.z, self.theta = (
            plus(times([C["a3"]], d), -times(b, [K1])),
            plus(times(a, [K1]), -times(c, [C["a3"]])),
        )
        z_w, theta_w = plus(times([-a1V], d), times(b, [A6])), plus(times([-A6], a), times(c, [a1V]))
        self.winds = {"z": z_w, "theta": theta_w}
        mode = [1, 2 * C["zeta"] * w, w**2] if given["bending"] else [1]
        push = C["phi_tvc"] * C["T_c"] if given["bending"] else mp.mpf(0)
        angle, drift = [K_d, K_p], [K_zdot, K_z]
        bent = plus(times([C["sigma_ins"]], angle), times([-C["phi_ins"]], drift))
        inner = plus(
            times(angle, self.theta, mode), times(drift, self.z, mode), -times([push], bent, self.rigid)
        )
        W, V = times([1]), times([1])
        if given["actuator"]:
            T = C["delay"]
            W = times([C["omega_tvc"] ** 2], [-(T**3), 12 * T**2, -60 * T, 120])
            V = times([1, C["damping_tvc"], C["omega_tvc"] ** 2], [T**3, 12 * T**2, 60 * T, 120])
        if given["notch"]:
            at = C["omega"]
            W = times(W, [1, 2 * C["zeta_notch_zeros"] * at, at**2])
            V = times(V, [1, 2 * C["zeta_notch_poles"] * at, at**2])
        self.top, self.bottom = times(W, inner), times(V, self.rigid, mode)
        self.closed = plus(self.top, self.bottom)
        self.wind = -times(W, mode, plus(times(angle, theta_w), times(drift, z_w)))

    def poles(self):
        p = list(np.trim_zeros(self.closed))
        return mp.polyroots(p[::-1], maxsteps=500, extraprec=400, asc=True)

    def response(self, t, amplitude, duration):
        """Return delta, theta, z and alpha in a 1-cosine gust, by residues."""
        w = 2 * mp.pi / duration
        slope = np.polyder(self.closed)
        parts = {name: np.zeros((2, t.size), complex) for name in ("delta", "theta", "z")}
        zero = mp.mpf(10) ** -18  # at 0 itself numerator and denominator vanish together
        places = [(p, None) for p in self.poles()] + [(zero, 1), (w * 1j, -0.5), (-w * 1j, -0.5)]
        for s, share in places:
            gust = share if share is not None else 1 / s - s / (s**2 + w**2)
            below = value(slope, s) if share is None else value(self.closed, s)
            delta = value(self.wind, s) / below * gust
            rigid = value(self.rigid, s)
            direct = 0 if share is None else gust
            found = {"delta": delta}
            for name, forced in (("theta", self.theta), ("z", self.z)):
                top = value(self.winds[name], s) * direct + value(forced, s) * delta
                found[name] = top / rigid
            for name, residue in found.items():
                for row, late in enumerate((0.0, duration)):
                    after = np.where(t > late, t - late, 0.0)
                    parts[name][row] += complex(residue) * np.exp(complex(s) * after) * (t > late)
        return {name: amplitude / 2 * (both[0] - both[1]).real for name, both in parts.items()}


def positive_real(p):
    """Return the positive real roots of a polynomial."""
    p = list(np.trim_zeros(np.array([mp.re(x) for x in p], dtype=object)))
    found = mp.polyroots(p[::-1], maxsteps=500, extraprec=400, asc=True)
    return sorted(float(r.real) for r in found if r.real > 0 and abs(r.imag) < 1e-25 * abs(r))


def on_axis(p):
    """Return p(j x) as a polynomial in x."""
    n = len(p) - 1
    return np.array([mp.mpc(x) * mp.mpc(0, 1) ** (n - i) for i, x in enumerate(p)], dtype=object)


def exact_margins(case):
    """Return gain margins (dB) and phase margins (deg) with their frequencies, by polynomials in omega."""
    top, bottom = on_axis(case.top), on_axis(case.bottom)
    conj = np.array([mp.conj(x) for x in bottom], dtype=object)

    def L(w):
        return value(top, w) / value(bottom, w)

    crossing = [mp.im(x) for x in np.convolve(top, conj)]
    gain = [(float(-20 * mp.log10(abs(L(w)))), w) for w in positive_real(crossing) if mp.re(L(w)) < 0]
    top2, bottom2 = (np.convolve(p, [mp.conj(x) for x in p]) for p in (top, bottom))
    phase = [(float(mp.degrees(mp.arg(-L(w)))), w) for w in positive_real(plus(top2, -bottom2))]
    return gain, phase


@pytest.fixture(scope="module", params=CASES)
def pair(request):
    given = CASES[request.param]
    exact = Exact(**given)
    exact.margins = exact_margins(exact)
    return given, exact


def test_poles(pair):
    given, exact = pair
    poles = np.array([complex(p) for p in exact.poles()])
    closed = g.closed_loop(**given).poles()
    kept = closed[np.abs(closed) > 1e-9]  # without K_z the drift itself is a root at 0, which is cancelled
    assert kept.size == poles.size
    for pole in poles:
        assert np.abs(kept - pole).min() < 1e-7 * (1 + abs(pole))
    found = agreement.largest_real_part(g.greensite(**given))
    assert found == pytest.approx(max(poles.real.max(), closed.real.max()), abs=1e-8)


def test_margins(pair):
    given, exact = pair
    gain, phase = exact.margins
    found = margins(g.greensite(**given))
    assert [m.dB for m in found.gain] == pytest.approx([dB for dB, _ in gain], abs=1e-6)
    assert [m.omega for m in found.gain] == pytest.approx([w for _, w in gain], rel=1e-7)
    assert [m.deg for m in found.phase] == pytest.approx([deg for deg, _ in phase], abs=1e-5)
    assert [m.omega for m in found.phase] == pytest.approx([w for _, w in phase], rel=1e-7)


def test_margins_of_python_control(pair):
    given, exact = pair
    gain, phase = exact.margins
    with warnings.catch_warnings():  # its polynomials overflow far beyond every crossing
        warnings.simplefilter("ignore", RuntimeWarning)
        gm, pm, _, w_gain, w_phase, _ = control.stability_margins(g.greensite(**given), returnall=True)
    ours = sorted((w, dB) for dB, w in gain)
    theirs = sorted((w, 20 * np.log10(k)) for k, w in zip(gm, w_gain, strict=True) if 1e-6 < w < 1e6)
    assert [w for w, _ in theirs] == pytest.approx([w for w, _ in ours], rel=1e-4)
    assert [dB for _, dB in theirs] == pytest.approx([dB for _, dB in ours], abs=1e-3)
    for deg, w in phase:
        at = np.abs(w_phase - w).argmin()
        assert w_phase[at] == pytest.approx(w, rel=1e-4)
        assert (pm[at] - deg + 180) % 360 - 180 == pytest.approx(0, abs=1e-2)


@pytest.mark.parametrize(("amplitude", "duration"), [(6.4, 3.0), (9.0, 1.0), (3.0, 12.0)])
@pytest.mark.parametrize("name", ["as printed", "rigid, printed", "more air", "both, mode low"])
def test_gusts(name, amplitude, duration):
    exact, V = Exact(**CASES[name]), float(C["V"])
    t = np.arange(0, 30, 0.01)
    y = exact.response(t, amplitude / V, duration)
    wind = np.where(t < duration, amplitude / V / 2 * (1 - np.cos(2 * np.pi * t / duration)), 0)
    y["alpha"] = y["theta"] + np.gradient(y["z"], t) / V - wind
    found = agreement.gust_peaks(amplitude, duration, **CASES[name])
    assert found["z"] == pytest.approx(np.abs(y["z"]).max(), rel=1e-4)
    for output in ("theta", "delta", "alpha"):
        assert found[output] == pytest.approx(np.degrees(np.abs(y[output]).max()), rel=2e-3), output
    assert found["alpha_w"] == pytest.approx(np.degrees(amplitude / V), rel=1e-5)


def test_gust_that_is_none():
    with pytest.raises(ValueError, match="duration in gust_peaks: got 0"):
        agreement.gust_peaks(6.4, 0.0, **CASES["as printed"])
    with pytest.raises(ValueError, match="amplitude in gust_peaks: got nan"):
        agreement.gust_peaks(float("nan"), **CASES["as printed"])
    with pytest.raises(ValueError, match="loop in gust_peaks: got a root"):
        agreement.gust_peaks(**CASES["no notch"])
