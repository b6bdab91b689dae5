"""Polynomials without rounding: integer coefficients, the characteristic polynomial, and its roots."""

from fractions import Fraction
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlswaim.rootlocus.aberth import aberth, real_and_conjugate


class Exact(NamedTuple):
    """A polynomial with the coefficients ``integers[i] / 2^exponent``, constant term first."""

    integers: list[int]
    exponent: int

    @property
    def degree(self) -> int:
        """The highest power whose coefficient is not 0; 0 for the zero polynomial."""
        return max((i for i, c in enumerate(self.integers) if c), default=0)

    @property
    def rounded(self) -> NDArray:
        """The coefficients, each correctly rounded."""
        return np.array([c / (1 << self.exponent) for c in self.integers])


def plus(a: Exact, b: Exact) -> Exact:
    """Return the sum of two polynomials.

    Parameters
    ----------
    a, b : Exact
    """
    exponent = max(a.exponent, b.exponent)
    scaled = [[c << (exponent - p.exponent) for c in p.integers] for p in (a, b)]
    return Exact([sum(pair) for pair in zip_longest(*scaled, fillvalue=0)], exponent)


def times(polynomial: Exact, factor: float) -> Exact:
    """Return a polynomial times a number.

    Parameters
    ----------
    polynomial : Exact
    factor : float
        It is taken without rounding.
    """
    over, under = factor.as_integer_ratio()
    integers = [c * over for c in polynomial.integers]
    return Exact(integers, polynomial.exponent + under.bit_length() - 1)


def exact(coefficients: ArrayLike) -> Exact:
    """Return a polynomial of given ``coefficients`` (floats, constant term first) without rounding."""
    [integers], exponent = _exact_integers(np.asarray(coefficients, float)[None])
    return Exact(integers, exponent)


def _exact_integers(matrix: NDArray) -> tuple[list[list[int]], int]:
    """Return integers N and an exponent e with matrix = N / 2^e exactly."""
    ratios = [[float(x).as_integer_ratio() for x in row] for row in matrix]
    e = max(d.bit_length() - 1 for row in ratios for _, d in row)
    return [[n * (2**e // d) for n, d in row] for row in ratios], e


def exact_transfer(A: NDArray, B: NDArray, C: NDArray) -> tuple[Exact, Exact]:
    """Return C adj(sI - A) B and det(sI - A) without rounding (Faddeev and LeVerrier).

    Parameters
    ----------
    A, B, C : ndarray, shapes (n, n), (n, 1) and (1, n)

    Returns
    -------
    tuple of Exact
        The numerator, with n coefficients, and the characteristic polynomial, with n + 1.
    """
    (whole, e), (column, e_B), (row, e_C) = (_exact_integers(M) for M in (A, B, C))
    n = len(whole)
    N, b, c = (np.array(M, dtype=object) for M in (whole, column, row))
    identity = np.array([[int(i == j) for j in range(n)] for i in range(n)], dtype=object)
    # adj(sI - N) = sum of M_k s^(n - 1 - k) with M_0 = I, M_k = N M_(k-1) + p_(n-k) I.
    adjoint, coefficients, numerator = identity, [1], [(c @ b).item()]
    for k in range(1, n + 1):
        product = N @ adjoint
        coefficients.append(-sum(product[i, i] for i in range(n)) // k)
        if k < n:
            adjoint = product + coefficients[-1] * identity
            numerator.append((c @ adjoint @ b).item())
    # Coefficient k of both belongs to N = 2^e A: it is 2^(e k) times that of A.
    denominator = [p << (e * (n - k)) for k, p in enumerate(coefficients)][::-1]
    numerator = [p << (e * (n - 1 - k)) for k, p in enumerate(numerator)][::-1]
    return Exact(numerator, e * (n - 1) + e_B + e_C), Exact(denominator, e * n)


def exact_characteristic_polynomial(A: NDArray) -> list[Fraction]:
    """Return the coefficients of det(sI - ``A``) without rounding, constant term first."""
    n = len(A)
    _, polynomial = exact_transfer(np.asarray(A, float), np.zeros((n, 1)), np.zeros((1, n)))
    return [Fraction(c, 1 << polynomial.exponent) for c in polynomial.integers]


def characteristic_polynomial(A: NDArray, B: NDArray | None = None, C: NDArray | None = None) -> NDArray:
    """Return det(sI - A), or the numerator C adj(sI - A) B, each coefficient correctly rounded.

    Parameters
    ----------
    A : ndarray, shape (n, n)
    B, C : ndarray, shapes (n, 1) and (1, n), optional
        With them the result is det(sI - A + B C) - det(sI - A), the numerator of C (sI - A)^-1 B.

    Returns
    -------
    ndarray, shape (n + 1,)
        Constant term first.
    """
    if B is None or C is None:
        return np.array([float(c) for c in exact_characteristic_polynomial(A)])
    numerator, _ = exact_transfer(*(np.asarray(M, float) for M in (A, B, C)))
    return np.append(numerator.rounded, 0.0)


def _slope(polynomial: Exact, s: complex) -> tuple[complex, bool]:
    """Return p'(s)/p(s), evaluated without rounding, and whether a root is as near as a float can say."""
    [[x, y]], e = _exact_integers(np.array([[s.real, s.imag]]))
    # p = q (s^2 - t s + r) + f (s - t) + g, q likewise with h and i: at the root s of the square
    # s - t = -s* and 2 s - t = 2 j y, so that p = g - f s*, q = i - h s* and p' = f + 2 j y q.
    t, r, f, g, h, i = 2 * x, x * x + y * y, 0, 0, 0, 0
    for power, coefficient in enumerate(polynomial.integers[::-1]):
        h, i = i, f + t * i - r * h
        f, g = g, (coefficient << (e * power)) + t * g - r * f
    (a, b), (c, d) = (g - f * x, f * y), (f - 2 * h * y * y, 2 * y * (i - h * x))
    # (a, b) is p(s) 2^(e n), and (c, d) is p'(s) 2^(e (n - 1)).
    size, slope = a * a + b * b, c * c + d * d
    if not size:
        return 0j, True
    real, imag = ((part << e) / size for part in (c * a + d * b, d * a - c * b))
    near = size << 104 <= slope * (x * x + y * y)  # |p| <= 2^-52 |s p'|
    return complex(real, imag), near


def refined_roots(polynomial: Exact, guess: NDArray) -> NDArray:
    """Return all simple roots to the last digit, whatever their condition.

    Parameters
    ----------
    polynomial : Exact
    guess : ndarray of complex, shape (n,)
        In conjugate pairs; a multiple root comes out as a group close to it.

    Returns
    -------
    ndarray of complex, shape (n,)
        The guess where the iteration does not end, as eigenvalues fit all coefficients at least together.
    """

    def slopes(s: NDArray, _: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        upper = s.real + 1j * np.abs(s.imag)  # a root's conjugate is one too: each pair is evaluated once
        points, place = np.unique(upper[:, 0], return_inverse=True)
        found = [_slope(polynomial, z) for z in points.tolist()]
        slope, near = (np.array(part)[place, None] for part in zip(*found, strict=True))
        return np.where(s.imag < 0, slope.conj(), slope), near, np.ones(s.shape, bool)

    # Real points would stay real, also where two of them stand for a pair: they start beside the axis.
    side = 1e-8j * np.abs(guess) * (-1.0) ** np.arange(guess.size)
    start = np.where(guess.imag == 0, guess + side, guess)
    values, found, _ = aberth(slopes, start[:, None], steps=24)
    return real_and_conjugate(values[:, 0]) if found[0] else guess
