// Polynomials with complex coefficients, constant term first, as an expression is read; and their products.
import { times } from '../maths/polynomials.js';

/** @typedef {import('../maths/polynomials.js').Complex} Complex */
/** @typedef {Complex[]} Polynomial */

/** @param {Polynomial} a @param {Polynomial} b @returns {Polynomial} */
export function product(a, b) {
  /** @type {Polynomial} */
  const found = Array.from({ length: a.length + b.length - 1 }, () => [0, 0]);
  a.forEach((one, i) => {
    b.forEach((other, j) => {
      const [re, im] = times(one, other);
      found[i + j] = [found[i + j][0] + re, found[i + j][1] + im];
    });
  });
  return found;
}

/** a + sign b. @param {Polynomial} a @param {Polynomial} b @param {number} sign @returns {Polynomial} */
export const sum = (a, b, sign) =>
  Array.from({ length: Math.max(a.length, b.length) }, (_, k) => {
    const [[ax, ay], [bx, by]] = [a[k] ?? [0, 0], b[k] ?? [0, 0]];
    return [ax + sign * bx, ay + sign * by];
  });

/** Without leading zeros. @param {Polynomial} c */
export function trimmed(c) {
  let length = c.length;
  while (length > 1 && c[length - 1][0] === 0 && c[length - 1][1] === 0) length--;
  return c.slice(0, length);
}

/** @param {Polynomial} c */
export const isReal = (c) => c.every(([, im]) => im === 0);
