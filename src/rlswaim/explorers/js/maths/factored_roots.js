// The roots of Π(s - poles) + k Π(s - zeros) from the factors, because rounded coefficients of an
// ill-conditioned polynomial have other roots.
import { gainAtPoint } from './factored_loop.js';
import { distance, EPS } from './polynomials.js';

/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {import('./multiple_roots.js').Root} Root */
/** @typedef {Float64Array | number[]} Numbers */
/** @typedef {Pick<FactoredLoop, 'poles' | 'zeros' | 'common' | 'gain'>} Factors */

const SWEEPS = 80;

/**
 * Moves n points to the n roots at the gain k, all at once, as `aberth` does for coefficients. Returns how
 * often a point was moved.
 * @param {Factors} loop
 * @param {number} k
 * @param {Numbers} x
 * @param {Numbers} y
 */
export function aberthOfFactors(loop, k, x, y, close = 1e-6) {
  const n = x.length;
  const rests = new Uint8Array(n);
  let moves = 0;
  for (let sweep = 0; sweep < SWEEPS && rests.includes(0); sweep++) {
    for (let i = 0; i < n; i++) {
      if (rests[i]) continue;
      moves++;
      if (moved(loop, k, x, y, i, close)) rests[i] = 1;
    }
  }
  return moves;
}

/**
 * Σ count / (s - root); infinite at a root.
 * @param {Root[]} roots
 * @param {number} x
 * @param {number} y
 */
function inverses(roots, x, y) {
  let [re, im] = [0, 0];
  for (const root of roots) {
    const [dx, dy] = [x - root.x, y - root.y];
    const weight = root.count / (dx * dx + dy * dy);
    re += dx * weight;
    im -= dy * weight;
  }
  return [re, im];
}

// f'/f at a point; null where the point is a root as nearly as rounding tells.
/**
 * @param {Factors} loop
 * @param {number} k
 * @param {number} x
 * @param {number} y
 */
function logarithmicDerivative(loop, k, x, y) {
  const [resting, restingUp] = inverses(loop.common, x, y);
  const [px, py] = inverses(loop.poles, x, y);
  if (!Number.isFinite(resting + restingUp)) return null;
  if (k === 0 || loop.gain === 0) return Number.isFinite(px + py) ? [px + resting, py + restingUp] : null;
  const [zx, zy] = inverses(loop.zeros, x, y);
  const [gx, gy] = gainAtPoint(loop, x, y); // -1/G; with q = its part of k, f = P (1 - k/q)
  if (!Number.isFinite(zx + zy)) return [px + resting, py + restingUp];
  // f = P Π + k Q; in the parts a = q/(q - k) of P and 1 - a of k Q.
  const [ex, ey] = [gx - k, gy];
  const size = distance(gx, gy);
  const off = distance(ex, ey);
  const rounding = EPS * (loop.poles.length + loop.zeros.length);
  if (off <= rounding * (size + Math.abs(k))) return null;
  if (!Number.isFinite(px + py)) return [zx + resting, zy + restingUp];
  const square = ex * ex + ey * ey;
  const [ax, ay] = [(gx * ex + gy * ey) / square, (gy * ex - gx * ey) / square];
  const [dx, dy] = [px - zx, py - zy];
  return [zx + ax * dx - ay * dy + resting, zy + ax * dy + ay * dx + restingUp];
}

/**
 * @param {Factors} loop
 * @param {number} k
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} i
 * @param {number} close
 */
function moved(loop, k, x, y, i, close) {
  const found = logarithmicDerivative(loop, k, x[i], y[i]);
  if (!found) return true;
  let [sx, sy] = found;
  let gap = Infinity;
  let largest = 0;
  for (let j = 0; j < x.length; j++) {
    largest = Math.max(largest, x[j] * x[j] + y[j] * y[j]);
    if (j === i) continue;
    const [ex, ey] = [x[i] - x[j], y[i] - y[j]];
    const square = ex * ex + ey * ey || 1e-300;
    gap = Math.min(gap, square);
    sx -= ex / square;
    sy += ey / square;
  }
  const square = sx * sx + sy * sy || 1e-300;
  const limit = 16 * largest || Infinity; // no step is longer than four times the largest root
  const scale = square * limit < 1 ? Math.sqrt(limit / square) : 1 / square;
  x[i] -= sx * scale;
  y[i] += sy * scale;
  return 1 <= square * close * close * gap;
}
