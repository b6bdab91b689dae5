"""Transfer functions and roots in factors, as the report prints them: to numbers, to LaTeX and to text."""

from collections.abc import Sequence

import control
import numpy as np
from numpy.polynomial import polynomial as npp
from numpy.typing import ArrayLike, NDArray

from rlswaim.loops.transfer_functions import transfer
from rlswaim.rootlocus.polynomials import roots, trimmed


def from_factors(gain: float, zeros: Sequence[complex], poles: Sequence[complex]) -> control.TransferFunction:
    """Return a transfer function from its factors, as the report prints them.

    Parameters
    ----------
    gain : float
    zeros, poles : sequence of complex
        A root with an imaginary part stands for itself and its conjugate (1/s).
    """

    def product(given: Sequence[complex]) -> NDArray:
        return npp.polyfromroots([r for z in given for r in ((z, np.conj(z)) if np.imag(z) else (z,))]).real

    return transfer(gain * product(zeros), product(poles))


def factored(loop: control.TransferFunction) -> tuple[float, NDArray, NDArray]:
    """Return gain, zeros and poles (1/s) of a ``loop``; of a pair, the root above the real axis."""
    top, bottom = (trimmed(p[0][0][::-1]) for p in (loop.num, loop.den))
    zeros, poles = (np.sort_complex(r[r.imag >= 0]) for r in (roots(top), roots(bottom)))
    return float(top[-1] / bottom[-1]), zeros, poles


def as_latex(loop: control.TransferFunction, digits: int = 4) -> str:
    """Return a transfer function in factors as LaTeX, in the report's manner [Eqs. 92-96].

    Parameters
    ----------
    loop : TransferFunction
    digits : int
        Significant digits of each number.
    """

    def number(x: float) -> str:
        text = f"{abs(x):.{digits}g}"
        mantissa, _, power = text.partition("e")
        return rf"{mantissa}\times 10^{{{int(power)}}}" if power else text

    def factor(root: complex) -> str:
        if root == 0:
            return "s"
        real = f"{'-' if root.real > 0 else '+'} {number(root.real)}"
        return rf"(s {real} \pm j\,{number(root.imag)})" if root.imag else f"(s {real})"

    gain, zeros, poles = factored(loop)
    sign = "-" if gain < 0 else ""
    return rf"\frac{{{sign}{number(gain)}\,{''.join(map(factor, zeros))}}}{{{''.join(map(factor, poles))}}}"


def as_text(values: ArrayLike, digits: int = 3) -> str:
    """Return roots in one line, rightmost first; of a pair, the one above the real axis.

    Parameters
    ----------
    values : array_like of complex
        Roots (1/s).
    digits : int
        Decimals of complex roots; real ones have two more significant digits.
    """
    upper = sorted((r for r in np.asarray(values, complex) if r.imag >= 0), key=lambda r: -r.real)
    signed = [
        f"{r.real:.{digits}f} ± j{r.imag:.{digits}f}" if r.imag else f"{r.real:.{digits + 2}g}" for r in upper
    ]
    return ", ".join(signed).replace("-", "−")
