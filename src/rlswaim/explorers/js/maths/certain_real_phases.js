// Where N/D is real on the imaginary axis, from a polynomial in omega^2, as long as its roots leave no doubt.
import { roots } from './aberth.js';
import { distance, EPS, evaluate, termsAt } from './polynomials.js';

/** @typedef {import('./multiple_roots.js').Root} Root */

const HIGHEST = 24; // the order of a polynomial that is tried
const LEAST = 1e-280; // a size that a coefficient may not fall below
const CLOSE = 1e-6; // the part of an omega^2 by which a root may be off before it is polished

/**
 * The omega > 0 at which the phase of Π(j omega - zeros) / Π(j omega - poles) is a multiple of 180 degrees,
 * or null if rounding leaves their number in doubt. N/D is real where Π(s - zeros) Π(s + poles) is, and there
 * the odd part of that polynomial (the even one, if s itself is a factor an odd number of times) is 0.
 * @param {Root[]} poles real or in conjugate pairs
 * @param {Root[]} zeros likewise
 * @returns {number[] | null}
 */
export function certainRealPhases(poles, zeros) {
  const { c, sizes, isOdd } = product(poles, zeros);
  if (c.length > HIGHEST) return null;
  const first = isOdd ? 0 : 1;
  const n = (c.length - 1 - first) >> 1;
  if (n < 0) return [];
  const [part, terms] = [new Float64Array(n + 1), new Float64Array(n + 1)];
  for (let k = 0; k <= n; k++) {
    part[k] = (k % 2 ? -1 : 1) * c[2 * k + first];
    terms[k] = sizes[2 * k + first];
  }
  const squares = certainSquares(part, terms, 4 * EPS * (c.length + n));
  if (!squares) return null;
  const found = squares.map((square) => polished(poles, zeros, Math.sqrt(square)));
  return found.includes(0) ? null : found;
}

// The real polynomial Π(s - zeros) Π(s + poles), the sums of the sizes of its coefficients' terms, and
// whether s is a factor an odd number of times; without the factors that are real all over the axis.
/**
 * @param {Root[]} poles
 * @param {Root[]} zeros
 */
function product(poles, zeros) {
  let c = Float64Array.of(1);
  let sizes = Float64Array.of(1);
  let isOdd = false;
  for (const [roots, side] of /** @type {[Root[], number][]} */ ([
    [zeros, 1],
    [poles, -1],
  ])) {
    for (const { x, y, count } of roots) {
      if (x === 0 && y === 0 && count % 2) isOdd = !isOdd;
      if (x === 0 || y < 0) continue;
      const factor = y === 0 ? [-side * x, 1] : [x * x + y * y, -2 * side * x, 1];
      for (let i = 0; i < count; i++) {
        c = times(c, factor);
        sizes = times(sizes, factor.map(Math.abs));
      }
    }
  }
  return { c, sizes, isOdd };
}

/**
 * @param {Float64Array} c
 * @param {number[]} factor
 */
function times(c, factor) {
  const found = new Float64Array(c.length + factor.length - 1);
  for (let i = 0; i < c.length; i++) for (let j = 0; j < factor.length; j++) found[i + j] += c[i] * factor[j];
  return found;
}

/**
 * The positive roots of a polynomial, or null if rounding leaves their number in doubt. Around each root lies
 * a disc, and discs that have no point in common hold one root each (Smith's theorem): a real one, if the
 * disc lies about the real axis.
 * @param {Float64Array} c
 * @param {Float64Array} sizes the sums of the sizes of the terms of each coefficient
 * @param {number} rounding the part of the sizes by which a value may be off
 * @returns {number[] | null}
 */
function certainSquares(c, sizes, rounding) {
  const n = c.length - 1;
  const lead = Math.abs(c[n]) - rounding * sizes[n];
  if (!(lead > 0 && c.every((v) => Number.isFinite(v)) && sizes.every((v) => v > LEAST))) return null;
  const { x, y } = roots(c);
  /** @type {number[]} */
  const radii = [];
  for (let i = 0; i < n; i++) {
    const size = distance(x[i], y[i]);
    let apart = lead;
    for (let j = 0; j < n; j++) if (j !== i) apart *= distance(x[i] - x[j], y[i] - y[j]);
    const radius = (n * (distance(...evaluate(c, x[i], y[i])) + rounding * termsAt(sizes, size))) / apart;
    const isClear = y[i] === 0 ? radius < CLOSE * size : radius < Math.abs(y[i]);
    if (!isClear) return null;
    for (let j = 0; j < i; j++) if (!(radius + radii[j] < distance(x[i] - x[j], y[i] - y[j]))) return null;
    radii.push(radius);
  }
  return x.filter((v, i) => y[i] === 0 && v > 0);
}

// The place beside omega at which the phase is a multiple of 180 degrees, by Newton's steps on the factors; 0
// if they lead away.
/**
 * @param {Root[]} poles
 * @param {Root[]} zeros
 * @param {number} omega
 */
function polished(poles, zeros, omega) {
  let at = omega;
  for (let step = 0; step < 2; step++) {
    let phase = 0;
    let slope = 0;
    for (const [roots, side] of /** @type {[Root[], number][]} */ ([
      [zeros, 1],
      [poles, -1],
    ])) {
      for (const { x, y, count } of roots) {
        const weight = side * count;
        if (x === 0) {
          phase += y === 0 ? weight * (Math.PI / 2) : 0;
          continue;
        }
        phase -= weight * Math.atan((at - y) / x);
        slope -= (weight * x) / (x * x + (at - y) ** 2);
      }
    }
    at -= (phase - Math.PI * Math.round(phase / Math.PI)) / slope;
  }
  return Math.abs(at - omega) <= CLOSE * omega ? at : 0;
}
