// First guesses of the roots of a polynomial, from the sizes of its coefficients.

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */

/**
 * Points on circles whose radii the size of the coefficients tells (Bini): sound for roots of very different
 * size.
 * @param {Coefficients} c of degree n, whose constant term is not 0
 * @param {number} n
 * @returns {[number[], number[]]} by rising size
 */
export function startingPoints(c, n) {
  const x = new Array(n).fill(0.5);
  const y = x.slice();
  const hull = upperHull(c, n);
  for (let h = 1; h < hull.length; h++) {
    const [from, to] = [hull[h - 1], hull[h]];
    const radius = Math.exp(-slope(c, from, to));
    for (let i = from; i < to; i++) {
      const angle = (2 * Math.PI * (i - from)) / (to - from) + (2 * Math.PI * h) / n + 0.7;
      x[i] = radius * Math.cos(angle);
      y[i] = radius * Math.sin(angle);
    }
  }
  return [x, y];
}

/**
 * The slope of ln |c_k| from one k to another.
 * @param {Coefficients} c
 * @param {number} a
 * @param {number} b
 */
export const slope = (c, a, b) => (Math.log(Math.abs(c[b])) - Math.log(Math.abs(c[a]))) / (b - a);

/**
 * The corners of the upper convex hull of the points (k, ln |c_k|).
 * @param {Coefficients} c
 * @param {number} n
 */
export function upperHull(c, n) {
  /** @type {number[]} */
  const hull = [];
  for (let k = 0; k <= n; k++) {
    if (c[k] === 0) continue;
    while (hull.length > 1) {
      const [before, last] = hull.slice(-2);
      if (slope(c, before, last) > slope(c, last, k)) break;
      hull.pop();
    }
    hull.push(k);
  }
  return hull;
}
