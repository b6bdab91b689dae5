// All roots of a polynomial at once, by Aberth's iteration.
import { distance, EPS, termsAt } from './polynomials.js';
import { slope, startingPoints, upperHull } from './starting_points.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {Float64Array | number[]} Numbers */

const SWEEPS = 80;
const WIDE = 1e200; // the square of a polynomial's value whose products with its slope are numbers

// One entry for each point that still moves; made once, and larger when a larger polynomial comes.
let moving = new Uint8Array(32);

/**
 * Moves n distinct points to the n roots of c, all at once (Aberth's method). Unlike Newton's, two of them
 * never fall on one root, so branches stay apart at break-away points. A point rests once |p| is as small as
 * rounding allows, or after a step shorter than `close` times the distance to its neighbor: what is left is
 * then smaller by close^2 again. Where Aberth's correction has a pole a step would lead anywhere, and powers
 * of it overflow: none is longer than four times the size of the largest point or, where that is larger, of
 * the geometric mean of all roots. Returns how often a point was moved.
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
  const mean = Math.abs(c[0] / c[n]) ** (2 / n);
  const longestSquare = 16 * Math.max(largestSquare, mean) || Infinity;
  let left = n;
  let moves = 0;
  for (let sweep = 0; left > 0 && sweep < SWEEPS; sweep++) {
    moves += left;
    for (let i = 0; i < n; i++) {
      if (rests[i] === 1 || !moved(c, n, x, y, i, close, longestSquare)) continue;
      rests[i] = 1;
      left--;
    }
  }
  return moves;
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
  if (!(q > 1 / WIDE && q < WIDE)) {
    // All beside the size of the terms, so that no product overflows; nothing tells where the terms do.
    [px, py, dx, dy, bound] = [px / bound, py / bound, dx / bound, dy / bound, 1];
    q = px * px + py * py;
  }
  if (!(q > EPS * EPS * bound * bound)) return true;
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
  return 1 <= stepped(x, y, i, sx, sy, longestSquare) * close * close * gap;
}

// Moves point i by 1 / (sx + j sy), or by the longest step allowed. Returns the square of sx + j sy.
/**
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} i
 * @param {number} sx
 * @param {number} sy
 * @param {number} longestSquare
 */
function stepped(x, y, i, sx, sy, longestSquare) {
  const q = sx * sx + sy * sy || 1e-300;
  const scale = q * longestSquare < 1 ? Math.sqrt(longestSquare / q) : 1 / q;
  x[i] -= sx * scale;
  y[i] += sy * scale;
  return q;
}

/**
 * All roots of a polynomial. Zeros at the origin come out exactly, and real roots exactly real. A root that
 * no number of double precision holds comes out as an infinite one, or as 0.
 * @param {Coefficients} c
 * @returns {{ x: number[], y: number[] }}
 */
export const roots = (c) =>
  rootsBy((inner) => {
    const start = startingPoints(inner, inner.length - 1);
    return isWide(inner, start) ? rootsByScale(inner) : refined(inner, start);
  }, c);

/**
 * The roots at the origin, and those that a method finds of a polynomial without such.
 * @param {(inner: Float64Array) => { x: number[], y: number[] }} method
 * @param {Coefficients} c
 */
function rootsBy(method, c) {
  let n = Math.max(0, c.length - 1);
  while (n > 0 && c[n] === 0) n--;
  let m = 0;
  while (m < n && c[m] === 0) m++;
  const inner = new Float64Array(n - m + 1);
  for (let k = m; k <= n; k++) inner[k - m] = c[k];
  const { x, y } = method(inner);
  const origin = new Array(m).fill(0);
  return { x: origin.concat(x), y: origin.concat(y) };
}

/**
 * @param {Float64Array} c
 * @param {[number[], number[]]} start
 */
function refined(c, [x, y]) {
  const n = c.length - 1;
  aberth(c, n, x, y);
  aberth(c, n, x, y, 1e-3); // a point that rested early did so beside points that still moved
  flatten(x, y);
  return { x, y };
}

const LARGE = 2 ** 300; // products of three numbers up to it, and of their inverses, are numbers

/**
 * Whether the terms of a polynomial without roots at the origin could overflow at its roots.
 * @param {Float64Array} c
 * @param {[number[], number[]]} start by rising size
 */
function isWide(c, [x, y]) {
  const n = c.length - 1;
  if (n < 1 || !c.every(Number.isFinite)) return false;
  const largest = distance(x[n - 1], y[n - 1]);
  const least = Math.min(Math.abs(c[0]), distance(x[0], y[0]));
  return !(largest < LARGE && termsAt(c, largest) < LARGE && least > 1 / LARGE);
}

const APART = 8; // binary digits between the sizes of roots that are found apart
const LOST = -70; // binary digits below which a term counts for nothing

// The roots in groups of like size, each in a unit of s (a power of 2) of its own. The kth smallest root
// belongs to the stretch of the hull from k - 1 to k.
/** @param {Float64Array} c */
function rootsByScale(c) {
  const hull = upperHull(c, c.length - 1);
  const units = hull.slice(1).map((to, h) => -slope(c, hull[h], to) / Math.LN2);
  const found = { x: /** @type {number[]} */ ([]), y: /** @type {number[]} */ ([]) };
  let first = 0;
  for (let h = 0; h < units.length; h++) {
    if (units[h + 1] - units[h] <= APART) continue;
    const [from, to] = [hull[first], hull[h + 1]];
    const unit = Math.round(-slope(c, from, to) / Math.LN2);
    const heightAt = (/** @type {number} */ k) => Math.log2(Math.abs(c[k])) + k * unit;
    const most = Math.round(Math.max(...hull.slice(first, h + 2).map(heightAt)));
    const counts = (/** @type {number} */ k) => {
      const [at, along] = k < from ? [from, units[first]] : [to, units[h]];
      const below = Math.log2(Math.abs(c[k])) - Math.log2(Math.abs(c[at])) + (k - at) * along;
      return (k >= from && k <= to) || below > LOST;
    };
    const own = c.map((v, k) => (counts(k) ? timesPower(v, k * unit - most) : 0));
    const { x, y } = rootsBy((inner) => refined(inner, startingPoints(inner, inner.length - 1)), own);
    const bySize = Array.from(x.keys()).sort((i, j) => distance(x[i], y[i]) - distance(x[j], y[j]));
    for (const i of bySize.slice(from, to)) {
      found.x.push(timesPower(x[i], unit));
      found.y.push(timesPower(y[i], unit));
    }
    first = h + 1;
  }
  return found;
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
