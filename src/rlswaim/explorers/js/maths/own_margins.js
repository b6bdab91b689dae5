// Gain and phase margins of a loop from its factors, in continuous or discrete time.
import { roots } from './aberth.js';
import { gainAtPoint } from './factored_loop.js';
import { aberthOfFactors } from './factored_roots.js';
import { marginsByOmega, phaseMargin } from './one_margin.js';
import { combine } from './polynomials.js';

/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {import('./crossings.js').Crossing} Crossing */
/** @typedef {import('./multiple_roots.js').Root} Root */

const REAL = 1e-9; // relative size of what rounding leaves of an imaginary part

/**
 * The margins at the gain k, as `marginsOf` gives them; omega and delay of a discrete loop are in radians a
 * sample and in samples.
 * @param {FactoredLoop} parts
 * @param {Crossing[]} crossings
 * @param {number} k
 * @param {number | true} dt
 */
export function ownMargins(parts, crossings, k, dt) {
  if (k === 0 || parts.gain === 0) return null;
  const phase = frequenciesOfUnitSize(parts, k, Boolean(dt)).map((omega) => {
    const [gx, gy] = dt ? gainAtPoint(parts, Math.cos(omega), Math.sin(omega)) : gainAtPoint(parts, 0, omega);
    return phaseMargin(k * gx, -k * gy, omega); // in the direction of -k G, as gx + j gy = -1/G
  });
  return marginsByOmega(crossings, k, phase);
}

/**
 * Where |P|^2 = (k gain)^2 |Z|^2: along the axis a factor (s - p)(-s - p) is u + p^2 with u = omega^2, along
 * the circle (z - p)(1/z - p) is -2p (c - (p + 1/p)/2) with c = cos omega. Both are root loci again,
 * in k^2.
 * @param {FactoredLoop} parts
 * @param {number} k
 * @param {boolean} discrete
 */
function frequenciesOfUnitSize({ poles, zeros, gain }, k, discrete) {
  const onto = discrete ? onCosine : onSquare;
  const [P, Z] = [poles, zeros].map((roots) => roots.filter(({ x, y }) => !discrete || x || y).map(onto));
  const size = (/** @type {Root[]} */ roots) =>
    discrete
      ? roots.reduce(
          (product, { x, y, count }) =>
            product * (2 * Math.hypot(x, y)) ** count * (y || x < 0 ? 1 : (-1) ** count),
          1,
        )
      : 1;
  const factor =
    (-((k * gain) ** 2) * size(zeros.filter(({ x, y }) => x || y))) /
    size(poles.filter(({ x, y }) => x || y));
  const found = rootsOfFactors(P, Z, factor);
  const values = found.x.filter(
    (x, i) => Math.abs(found.y[i]) <= REAL * Math.max(Math.abs(x), discrete ? 1 : 0),
  );
  if (discrete) return values.filter((c) => Math.abs(c) < 1).map(Math.acos);
  return values.filter((u) => u > 0).map(Math.sqrt);
}

/** @param {Root} root @returns {Root} */
const onSquare = ({ x, y, count }) => ({ x: y * y - x * x, y: -2 * x * y, count });

/** @param {Root} root @returns {Root} */
function onCosine({ x, y, count }) {
  const square = x * x + y * y;
  return { x: (x + x / square) / 2, y: (y - y / square) / 2, count };
}

/**
 * The roots of Π(u - P) + factor Π(u - Z).
 * @param {Root[]} P
 * @param {Root[]} Z
 * @param {number} factor
 */
function rootsOfFactors(P, Z, factor) {
  if (!Number.isFinite(factor)) return { x: [], y: [] };
  const found = roots(combine(product(P), product(Z), factor));
  const n = found.x.length;
  if (![...found.x, ...found.y].every(Number.isFinite)) return { x: [], y: [] };
  // Real points would stay real: they start a little off the axis and apart.
  found.y = found.y.map((v, i) => v + (i % 2 ? 1e-8 : -1.3e-8) * (1 + i / (8 * n)) * Math.abs(found.x[i]));
  const loop = { poles: P, zeros: Z, common: /** @type {Root[]} */ ([]), gain: factor };
  aberthOfFactors(loop, 1, found.x, found.y);
  return found;
}

/** @param {Root[]} points conjugate pairs and real ones */
function product(points) {
  let [re, im] = [[1], [0]];
  for (const { x, y, count } of points) {
    for (let k = 0; k < count; k++) {
      const [a, b] = [
        [0, ...re],
        [0, ...im],
      ];
      re = a.map((v, i) => v - ((re[i] ?? 0) * x - (im[i] ?? 0) * y));
      im = b.map((v, i) => v - ((re[i] ?? 0) * y + (im[i] ?? 0) * x));
    }
  }
  return Float64Array.from(re);
}
