// Real polynomials. Coefficients run from the constant term up; complex values are pairs [re, im].

/** @typedef {ArrayLike<number>} Coefficients constant term first */
/** @typedef {{ x: ArrayLike<number>, y: ArrayLike<number> }} Points real and imaginary parts */
/** @typedef {[number, number]} Complex */

/** @param {Complex} a @param {Complex} b @returns {Complex} */
export const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];

/** @param {Complex} a @param {Complex} b @returns {Complex} */
export function over([a, b], [c, d]) {
  if (d === 0) return [a / c, b / c]; // a real divisor leaves real numbers as they are
  const size = c * c + d * d;
  return [(a * c + b * d) / size, (b * c - a * d) / size];
}

/** The distance from 1 to the next larger number. */
export const EPS = 2.220446049250313e-16;

/** The relative rounding of a coefficient after the few operations that it comes from. */
export const ROUNDING = 4 * EPS;

/**
 * The size of x + jy, several times sooner than Math.hypot; beyond 1e154 it overflows.
 * @param {number} x
 * @param {number} y
 */
export const distance = (x, y) => Math.sqrt(x * x + y * y);

/**
 * The mean of the values at some places.
 * @param {ArrayLike<number>} values
 * @param {number[]} places
 */
export const meanOf = (values, places) => places.reduce((sum, i) => sum + values[i], 0) / places.length;

/**
 * The value of a polynomial at x + jy.
 * @param {Coefficients} c
 * @param {number} x
 * @param {number} y
 * @returns {Complex}
 */
export function evaluate(c, x, y) {
  let re = 0;
  let im = 0;
  for (let k = c.length - 1; k >= 0; k--) {
    const turned = re * x - im * y + c[k];
    im = re * y + im * x;
    re = turned;
  }
  return [re, im];
}

/**
 * The sum of the sizes of a polynomial's terms at a distance from the origin: rounding is in proportion to
 * it.
 * @param {Coefficients} c
 * @param {number} size
 */
export function termsAt(c, size) {
  let sum = 0;
  for (let k = c.length - 1; k >= 0; k--) sum = sum * size + Math.abs(c[k]);
  return sum;
}

/**
 * @param {Coefficients} a
 * @param {Coefficients} b
 */
export function multiply(a, b) {
  const product = new Float64Array(Math.max(a.length + b.length - 1, 0));
  for (let i = 0; i < a.length; i++) for (let j = 0; j < b.length; j++) product[i + j] += a[i] * b[j];
  return product;
}

/**
 * a + factor b.
 * @param {Coefficients} a
 * @param {Coefficients} b
 * @param {number} factor
 */
export const combine = (a, b, factor) =>
  Float64Array.from({ length: Math.max(a.length, b.length) }, (_, k) => (a[k] ?? 0) + factor * (b[k] ?? 0));

/**
 * A polynomial without the zeros beyond its degree; empty if it is zero.
 * @param {Coefficients} c
 */
export function trimmed(c) {
  let length = c.length;
  while (length > 0 && c[length - 1] === 0) length--;
  const found = new Float64Array(length);
  for (let k = 0; k < length; k++) found[k] = c[k];
  return found;
}
