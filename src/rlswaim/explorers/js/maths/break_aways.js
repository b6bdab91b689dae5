// Where branches of a root locus meet: multiple roots of D + k N for a real gain k.
import { flatten } from './aberth.js';
import { gainAtPoint } from './factored_loop.js';
import { distance, EPS, meanOf } from './polynomials.js';
import { startingPoints } from './starting_points.js';

/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {import('./multiple_roots.js').Root} Root */
/**
 * count: how many branches meet at x + jy.
 * @typedef {{ gain: number, x: number, y: number, count: number }} BreakAway
 */
/**
 * The sum of weight / (s - x - jy).
 * @typedef {{ x: number[], y: number[], weight: number[] }} Terms
 */

const ROUND = 64; // roundings of a term that a sum of zero may be off by

/**
 * The break-aways of a loop: there d(ln k)/ds = Σ 1/(s - poles) - Σ 1/(s - zeros) = 0. A multiple open-loop
 * pole is one too, at the gain 0. Of a conjugate pair the upper one stands for both. One whose gain rounding
 * of the data may change by more than its size is left out.
 * @param {FactoredLoop} loop
 * @returns {BreakAway[]}
 */
export function breakAways(loop) {
  const { poles, zeros } = loop;
  if (!Number.isFinite(loop.gain) || loop.gain === 0) return [];
  const multiple = poles.filter(({ count, y }) => count > 1 && y >= 0);
  const start = multiple.map(({ x, y, count }) => ({ gain: 0, x, y, count }));
  const roots = [...poles, ...zeros];
  const terms = {
    x: roots.map(({ x }) => x),
    y: roots.map(({ y }) => y),
    weight: roots.map(({ count }, i) => (i < poles.length ? count : -count)),
  };
  const met = gathered(terms, stationaryPoints(terms), loop.doubt);
  return [...start, ...met.flatMap((point) => withGain(loop, point))];
}

/**
 * @param {FactoredLoop} loop
 * @param {Root} point
 * @returns {BreakAway[]}
 */
function withGain(loop, { x, y, count }) {
  if (y < 0) return [];
  const [gain, rest] = gainAtPoint(loop, x, y);
  if (!(Math.abs(rest) <= 1e-3 * Math.abs(gain))) return [];
  const doubt = loop.doubt(x, y);
  const isReal = Math.abs(rest) <= Math.max(1e-9, 16 * doubt) * Math.abs(gain);
  return isReal && doubt < 1 && Number.isFinite(gain) ? [{ gain, x, y, count: count + 1 }] : [];
}

/**
 * All zeros of the sum of terms, by Aberth's iteration on the sum times Π(s - x - jy).
 * @param {Terms} terms
 * @returns {{ x: number[], y: number[] }}
 */
function stationaryPoints(terms) {
  const { scale, c } = numerator(terms);
  let n = c.length - 1;
  while (n > 0 && c[n] === 0) n--;
  if (n < 1) return { x: [], y: [] };
  const [x, y] = guesses(c, n, scale);
  const rests = new Uint8Array(n);
  for (let sweep = 0; sweep < 80 && rests.includes(0); sweep++)
    for (let i = 0; i < n; i++) if (rests[i] === 0 && moved(terms, x, y, i)) rests[i] = 1;
  flatten(x, y);
  return { x, y };
}

// Starting points for the roots of c, in a unit of `scale`; a constant term of 0 counts as very small.
/**
 * @param {Float64Array} c
 * @param {number} n
 * @param {number} scale
 */
function guesses(c, n, scale) {
  const least = 1e-16 * Math.max(...c.map(Math.abs));
  const inner = c.slice(0, n + 1);
  if (inner[0] === 0) inner[0] = least;
  return startingPoints(inner, n).map((v) => v.map((part) => part * scale));
}

// Σ weight Π over the other terms of (s - x - jy): a real polynomial of s / scale, which is the geometric
// mean of the sizes.
/** @param {Terms} terms */
function numerator(terms) {
  const sizes = terms.x.map((x, i) => Math.hypot(x, terms.y[i])).filter((size) => size > 0);
  const scale = Math.exp(sizes.reduce((sum, size) => sum + Math.log(size), 0) / sizes.length) || 1;
  const n = terms.x.length;
  const [Qx, Qy] = [new Float64Array(n), new Float64Array(n)];
  const [Rx, Ry] = [new Float64Array(n + 1), new Float64Array(n + 1)];
  Rx[0] = 1;
  for (let done = 0; done < n; done++) {
    const px = terms.x[done] / scale; // a pair of names for a pair of values would cost more than the sums
    const py = terms.y[done] / scale;
    const weight = terms.weight[done];
    for (let k = done; k >= 0; k--) {
      const qx = Qx[k];
      const qy = Qy[k];
      Qx[k] = (k > 0 ? Qx[k - 1] : 0) - (qx * px - qy * py) + weight * Rx[k];
      Qy[k] = (k > 0 ? Qy[k - 1] : 0) - (qx * py + qy * px) + weight * Ry[k];
    }
    for (let k = done + 1; k >= 0; k--) {
      const rx = Rx[k];
      const ry = Ry[k];
      Rx[k] = (k > 0 ? Rx[k - 1] : 0) - (rx * px - ry * py);
      Ry[k] = (k > 0 ? Ry[k - 1] : 0) - (rx * py + ry * px);
    }
  }
  return { scale, c: Qx };
}

// One step of point i. Returns whether it rests from now on.
/**
 * @param {Terms} terms
 * @param {number[]} x
 * @param {number[]} y
 * @param {number} i
 */
function moved(terms, x, y, i) {
  const zx = x[i];
  const zy = y[i];
  let [fx, fy] = [0, 0]; // the sum f
  let gx = 0; // -f'
  let gy = 0;
  let px = 0; // Σ 1/(s - r) - Σ 1/(s - s_j)
  let py = 0;
  let size = 0; // Σ |terms|
  for (let k = 0; k < terms.x.length; k++) {
    const dx = zx - terms.x[k];
    const dy = zy - terms.y[k];
    const over = 1 / (dx * dx + dy * dy || 1e-300);
    const ix = dx * over;
    const iy = -dy * over;
    const weight = terms.weight[k];
    fx += weight * ix;
    fy += weight * iy;
    gx += weight * (ix * ix - iy * iy);
    gy += weight * 2 * ix * iy;
    px += ix;
    py += iy;
    size += Math.abs(weight) * Math.sqrt(over);
  }
  const f = fx * fx + fy * fy;
  if (f <= EPS * EPS * size * size) return true;
  for (let j = 0; j < x.length; j++) {
    const ex = zx - x[j];
    const ey = zy - y[j];
    const over = j === i ? 0 : 1 / (ex * ex + ey * ey || 1e-300);
    px -= ex * over;
    py += ey * over;
  }
  const sx = px - (gx * fx + gy * fy) / f;
  const sy = py - (gy * fx - gx * fy) / f;
  const square = sx * sx + sy * sy || 1e-300;
  x[i] -= sx / square;
  y[i] += sy / square;
  return 1 <= square * EPS * EPS * (zx * zx + zy * zy);
}

// Stationary points that coincide but for rounding as one: more than two branches meet there.
/**
 * @param {Terms} terms
 * @param {{ x: number[], y: number[] }} points
 * @param {FactoredLoop['doubt']} doubt
 * @returns {Root[]}
 */
function gathered(terms, { x, y }, doubt) {
  const rounding = ROUND * terms.x.length * EPS;
  const left = new Set(x.keys());
  /** @type {Root[]} */
  const found = [];
  for (const i of left) {
    const near = [i];
    const farthest = 1e-4 * distance(x[i], y[i]);
    for (const j of left) if (j !== i && distance(x[j] - x[i], y[j] - y[i]) <= farthest) near.push(j);
    left.delete(i);
    const [mx, my] = near.length === 1 ? [x[i], y[i]] : [x, y].map((v) => meanOf(v, near));
    const up = near.some((j) => y[j] * my <= 0) ? 0 : my;
    const spread = Math.max(...near.map((j) => distance(x[j] - mx, y[j] - up)));
    if (near.length > 1 && relativeSlope(terms, mx, up, spread) <= rounding + doubt(mx, up)) {
      for (const j of near) left.delete(j);
      found.push({ x: mx, y: up, count: near.length });
    } else found.push({ x: x[i], y: y[i], count: 1 });
  }
  return found;
}

/**
 * The sum at x + jy, or what it changes over the spread of points about it where this is more, beside the
 * sizes of its terms.
 * @param {Terms} terms
 * @param {number} x
 * @param {number} y
 * @param {number} spread
 */
function relativeSlope(terms, x, y, spread) {
  let [re, im, slopeRe, slopeIm, size] = [0, 0, 0, 0, 0];
  for (let k = 0; k < terms.x.length; k++) {
    const [dx, dy] = [x - terms.x[k], y - terms.y[k]];
    const square = dx * dx + dy * dy;
    const over = terms.weight[k] / square;
    re += dx * over;
    im -= dy * over;
    slopeRe += ((dx * dx - dy * dy) * over) / square;
    slopeIm -= (2 * dx * dy * over) / square;
    size += Math.abs(over) * distance(dx, dy);
  }
  const change = distance(slopeRe, slopeIm) * spread;
  return Math.max(distance(re, im), change) / size;
}
