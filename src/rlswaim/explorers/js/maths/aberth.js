// All roots of a polynomial at once, by Aberth's iteration.
import { distance, EPS } from './polynomials.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {Float64Array | number[]} Numbers */

const SWEEPS = 80;

// One entry for each point that still moves; made once, and larger when a larger polynomial comes.
let moving = new Uint8Array(32);

/**
 * Moves n distinct points to the n roots of c, all at once (Aberth's method). Unlike Newton's, two of them never fall
 * on one root, so branches stay apart at break-away points. A point rests once |p| is as small as rounding allows, or
 * after a step shorter than `close` times the distance to its neighbor: what is left is then smaller by close^2 again.
 * Where Aberth's correction has a pole a step would lead anywhere, and powers of it overflow: none is longer than four
 * times the size of the largest root.
 * @param {Coefficients} c
 * @param {number} n
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} close
 */
export function aberth(c, n, x, y, close = 1e-6) {
  if (moving.length < n) moving = new Uint8Array(2 * n);
  const rests = moving;
  let largestSquare = 0;
  for (let i = 0; i < n; i++) {
    rests[i] = 0;
    largestSquare = Math.max(largestSquare, x[i] * x[i] + y[i] * y[i]);
  }
  const longestSquare = 16 * largestSquare || Infinity;
  let left = n;
  for (let sweep = 0; left > 0 && sweep < SWEEPS; sweep++) {
    for (let i = 0; i < n; i++) {
      if (rests[i] === 1 || !moved(c, n, x, y, i, close, longestSquare)) continue;
      rests[i] = 1;
      left--;
    }
  }
}

// Moves point i by one step, 1 / (p'/p - sum of 1/(z_i - z_j)). Returns whether it rests from now on.
/**
 * @param {Coefficients} c
 * @param {number} n
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} i
 * @param {number} close
 * @param {number} longestSquare
 */
function moved(c, n, x, y, i, close, longestSquare) {
  const zx = x[i];
  const zy = y[i];
  const size = Math.sqrt(zx * zx + zy * zy);
  let px = c[n];
  let py = 0;
  let dx = 0;
  let dy = 0;
  let bound = Math.abs(px);
  for (let k = n - 1; k >= 0; k--) {
    let t = dx * zx - dy * zy + px;
    dy = dx * zy + dy * zx + py;
    dx = t;
    t = px * zx - py * zy + c[k];
    py = px * zy + py * zx;
    px = t;
    bound = bound * size + Math.abs(c[k]);
  }
  let q = px * px + py * py;
  if (q <= EPS * EPS * bound * bound) return true;
  let sx = (dx * px + dy * py) / q;
  let sy = (dy * px - dx * py) / q;
  let gap = Infinity;
  for (let j = 0; j < n; j++) {
    if (j === i) continue;
    const ex = zx - x[j];
    const ey = zy - y[j];
    q = ex * ex + ey * ey || 1e-300;
    if (q < gap) gap = q;
    sx -= ex / q;
    sy += ey / q;
  }
  q = sx * sx + sy * sy || 1e-300;
  const scale = q * longestSquare < 1 ? Math.sqrt(longestSquare / q) : 1 / q;
  x[i] -= sx * scale;
  y[i] += sy * scale;
  return 1 <= q * close * close * gap;
}

/**
 * Points on circles whose radii the size of the coefficients tells (Bini): sound for roots of very different size.
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
 * @param {Coefficients} c
 * @param {number} a
 * @param {number} b
 */
const slope = (c, a, b) => (Math.log(Math.abs(c[b])) - Math.log(Math.abs(c[a]))) / (b - a);

// The corners of the upper convex hull of the points (k, ln |c_k|).
/**
 * @param {Coefficients} c
 * @param {number} n
 */
function upperHull(c, n) {
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

/**
 * All roots of a polynomial. Zeros at the origin come out exactly, and real roots exactly real.
 * @param {Coefficients} c
 * @returns {{ x: number[], y: number[] }}
 */
export function roots(c) {
  let n = Math.max(0, c.length - 1);
  while (n > 0 && c[n] === 0) n--;
  let m = 0;
  while (m < n && c[m] === 0) m++;
  const { inner, unit } = scaled(Float64Array.from({ length: n - m + 1 }, (_, k) => c[m + k]));
  const [x, y] = startingPoints(inner, n - m);
  aberth(inner, n - m, x, y);
  aberth(inner, n - m, x, y, 1e-3); // a point that rested early did so beside points that still moved
  flatten(x, y);
  const origin = new Array(m).fill(0);
  return { x: [...origin, ...x.map((v) => v * unit)], y: [...origin, ...y.map((v) => v * unit)] };
}

// A polynomial whose terms could overflow at its roots, in a unit of s (a power of 2) in which they don't; others as they are.
/** @param {Float64Array} c */
function scaled(c) {
  const n = c.length - 1;
  const logs = c.map((v) => Math.log2(Math.abs(v))).filter(Number.isFinite);
  const most = Math.max(...logs);
  const spread = most - Math.min(...logs);
  if (n < 1 || (spread < 300 && Math.abs(most) < 300)) return { inner: c, unit: 1 };
  const unit = Math.round((Math.log2(Math.abs(c[0])) - Math.log2(Math.abs(c[n]))) / n) || 0;
  const powers = Array.from(c, (v, k) => (v === 0 ? -Infinity : Math.log2(Math.abs(v)) + k * unit));
  const shift = -Math.round(Math.max(...powers)) || 0;
  const inner = c.map((v, k) => timesPower(v, k * unit + shift));
  return { inner, unit: 2 ** unit };
}

// value 2^power, where the power alone may overflow.
/**
 * @param {number} value
 * @param {number} power
 */
function timesPower(value, power) {
  const third = Math.trunc(power / 3);
  return value * 2 ** third * 2 ** third * 2 ** (power - 2 * third);
}

/**
 * A root nearer to its own conjugate than any other root is has none: it is real, however small.
 * @param {Numbers} x
 * @param {Numbers} y
 */
export function flatten(x, y) {
  for (let i = 0; i < x.length; i++) {
    if (y[i] === 0) continue;
    let least = Infinity;
    for (let j = 0; j < x.length; j++)
      if (j !== i) least = Math.min(least, distance(x[i] - x[j], y[i] + y[j]));
    if (2 * Math.abs(y[i]) < least) y[i] = 0;
  }
}

/**
 * A polynomial without a constant term has a root at the origin itself: the nearest one there is it.
 * @param {Coefficients} c
 * @param {Numbers} x
 * @param {Numbers} y
 */
export function anchor(c, x, y) {
  const n = x.length;
  let missing = 0;
  while (missing < n && c[missing] === 0) missing++;
  if (missing === 0) return;
  for (let i = 0; i < n; i++) if (x[i] === 0 && y[i] === 0) missing--;
  for (; missing > 0; missing--) {
    let nearest = -1;
    let least = Infinity;
    for (let i = 0; i < n; i++) {
      const size = x[i] * x[i] + y[i] * y[i];
      if (size < least && (x[i] !== 0 || y[i] !== 0)) [nearest, least] = [i, size];
    }
    if (nearest < 0) return;
    x[nearest] = y[nearest] = 0;
  }
}

/**
 * Rounding leaves a real root a little off the axis: a quick look, while a locus is traced.
 * @param {Numbers} x
 * @param {Numbers} y
 */
export function settle(x, y) {
  for (let i = 0; i < x.length; i++) if (Math.abs(y[i]) <= 1e-13 * Math.abs(x[i])) y[i] = 0;
}
