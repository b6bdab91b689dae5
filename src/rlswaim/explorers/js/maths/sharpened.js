// Ill-conditioned roots to the last digits: their polynomial evaluated with twice the digits (Dekker's and Knuth's exact
// sums and products, as pairs of a number and what rounding left of it).
import { distance, EPS } from './polynomials.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {{ x: number[], y: number[] }} Roots */
/** @typedef {[number, number]} Pair a number and what rounding left of it */

const SPLIT = 134217729; // 2^27 + 1

/**
 * @param {number} a
 * @param {number} b
 * @returns {Pair}
 */
function sum(a, b) {
  const s = a + b;
  const t = s - a;
  return [s, a - (s - t) + (b - t)];
}

/**
 * @param {Pair} a
 * @param {number} b
 * @returns {Pair}
 */
function times([a, rest], b) {
  const p = a * b;
  const [ga, gb] = [SPLIT * a, SPLIT * b];
  const [ha, hb] = [ga - (ga - a), gb - (gb - b)];
  const [la, lb] = [a - ha, b - hb];
  return [p, ha * hb - p + ha * lb + la * hb + la * lb + rest * b];
}

/**
 * @param {Pair} a
 * @param {Pair} b
 * @returns {Pair}
 */
function add(a, b) {
  const [s, e] = sum(a[0], b[0]);
  return sum(s, e + a[1] + b[1]);
}

/**
 * The value of a polynomial at x + jy, with twice the digits on the way.
 * @param {Coefficients} c
 * @param {number} x
 * @param {number} y
 * @returns {[number, number]}
 */
export function evaluatePrecisely(c, x, y) {
  /** @type {Pair} */
  let re = [0, 0];
  /** @type {Pair} */
  let im = [0, 0];
  for (let k = c.length - 1; k >= 0; k--) {
    const next = add(add(times(re, x), times(im, -y)), [c[k], 0]);
    im = add(times(re, y), times(im, x));
    re = next;
  }
  return [re[0] + re[1], im[0] + im[1]];
}

/**
 * p' and the sum of the sizes of the terms of p at x + jy.
 * @param {Coefficients} c
 * @param {number} x
 * @param {number} y
 */
function slopeAndTerms(c, x, y) {
  const size = distance(x, y);
  let px = 0;
  let py = 0;
  let dx = 0;
  let dy = 0;
  let terms = 0;
  for (let k = c.length - 1; k >= 0; k--) {
    const real = dx * x - dy * y + px;
    dy = dx * y + dy * x + py;
    dx = real;
    const value = px * x - py * y + c[k];
    py = px * y + py * x;
    px = value;
    terms = terms * size + Math.abs(c[k]);
  }
  return { dx, dy, terms };
}

const STEPS = 6;
const GOOD = 1e-11; // a relative error of a root that needs no mending

/**
 * Newton's steps on the roots that rounding has moved by more than 1e-11 of their size, each shorter than a third of the
 * distance to the next root. The others stay as they are.
 * @param {Coefficients} c
 * @param {Roots} roots
 * @returns {Roots}
 */
export function sharpened(c, { x, y }) {
  const moved = { x: x.slice(), y: y.slice() };
  for (let i = 0; i < x.length; i++) {
    const { dx, dy, terms } = slopeAndTerms(c, x[i], y[i]);
    if (!(EPS * terms > GOOD * distance(x[i], y[i]) * distance(dx, dy))) continue;
    const partner = y[i] === 0 ? -1 : partnerOf(x, y, i);
    const at = y[i] < 0 && partner >= 0 ? null : newton(c, x, y, i);
    if (!at) continue;
    [moved.x[i], moved.y[i]] = at;
    if (partner >= 0) [moved.x[partner], moved.y[partner]] = [at[0], -at[1]];
  }
  return moved;
}

/**
 * @param {number[]} x
 * @param {number[]} y
 * @param {number} i
 */
const partnerOf = (x, y, i) =>
  x.findIndex((v, j) => y[i] * y[j] < 0 && Math.hypot(v - x[i], y[j] + y[i]) <= 1e-6 * Math.abs(y[i]));

/**
 * @param {Coefficients} c
 * @param {number[]} x
 * @param {number[]} y
 * @param {number} i
 */
function newton(c, x, y, i) {
  let [zx, zy] = [x[i], y[i]];
  let gap = Infinity;
  for (let j = 0; j < x.length; j++) if (j !== i) gap = Math.min(gap, Math.hypot(x[j] - zx, y[j] - zy));
  for (let step = 0; step < STEPS; step++) {
    const { dx, dy } = slopeAndTerms(c, zx, zy);
    const [px, py] = evaluatePrecisely(c, zx, zy);
    const square = dx * dx + dy * dy;
    const [sx, sy] = [(px * dx + py * dy) / square, (py * dx - px * dy) / square];
    if (!(Math.hypot(sx, sy) < gap / 3)) return null;
    [zx, zy] = [zx - sx, zy - sy];
    if (Math.hypot(sx, sy) <= EPS * Math.hypot(zx, zy)) break;
  }
  return Math.hypot(zx - x[i], zy - y[i]) < gap / 2 ? [zx, zy] : null;
}
