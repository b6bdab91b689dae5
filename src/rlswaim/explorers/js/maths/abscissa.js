// The largest real part of the roots of Section VII's polynomial over sensor and jet stations, from the table
// of terms that Python sends.
import { aberth, roots } from './aberth.js';
import { addTerm, weightOf } from './terms.js';

/** @typedef {import('./terms.js').Term} Term */
/**
 * Section VII at fixed gains: the polynomial that each pair of shapes multiplies, by AT_SENSOR and AT_JET,
 * the shapes by name, and the pairs of stations of Table 3.
 * @typedef {{ parts: Float64Array[][], values: Record<string, ArrayLike<number>>,
 *   pairs: { sensor: number, jet: number }[] }} Plan
 */
/** @typedef {{ step: number, jet: number, values: Float64Array }} Row values along the sensor's stations */
/**
 * step: ft; line: the pieces of the line of zero, x, y, x, y of each; stable, neutral: numbers of pairs.
 * @typedef {{ step: number, line: Float32Array, stable: number, neutral: number }} Whole
 */

export const STATIONS = 421;
export const STEPS = [28, 14, 7, 3, 1];
const ORDER = 9;
const AT_JET = ['', 'arm', 'phi_1r', 'phi_2r'];
const AT_SENSOR = ['', 'phi_1', 'phi_2'];

/**
 * @param {{ [name: string]: any, terms?: Term[] }} system
 * @param {Record<string, number>} gains
 * @returns {Plan}
 */
export function planOf({ terms, shapes, pairs }, gains) {
  const parts = AT_SENSOR.map(() => AT_JET.map(() => new Float64Array(ORDER + 1)));
  for (const term of terms) {
    const index = (/** @type {string[]} */ names) =>
      Math.max(
        0,
        names.findIndex((name) => name && term.factors.includes(name)),
      );
    const held = { ...term, factors: term.factors.filter((name) => name in gains) };
    addTerm(parts[index(AT_SENSOR)][index(AT_JET)], term, weightOf(held, gains));
  }
  const values = Object.fromEntries(Object.entries(shapes).map(([name, shape]) => [name, shape.values]));
  return { parts, values, pairs };
}

/**
 * The roots at a pair of stations (ft).
 * @param {Plan} plan
 * @param {number} sensor
 * @param {number} jet
 */
export function rootsAt({ parts, values }, sensor, jet) {
  const c = new Float64Array(ORDER + 1);
  const at = (/** @type {string} */ name, /** @type {number} */ station) =>
    name ? values[name][station] : 1;
  AT_SENSOR.forEach((z, i) => {
    AT_JET.forEach((r, j) => {
      addTerm(c, { coefficients: parts[i][j] }, at(z, sensor) * at(r, jet));
    });
  });
  return roots(c);
}

/**
 * @param {Plan} plan
 * @param {number} sensor
 * @param {number} jet
 */
export const abscissaAt = (plan, sensor, jet) => largest(rootsAt(plan, sensor, jet).x);

// A root at the origin comes out of a sweep as a speck on either side of it.
/** @param {Float64Array | number[]} x */
function largest(x) {
  let value = -Infinity;
  for (let i = 0; i < x.length; i++) value = Math.max(value, x[i]);
  return Math.abs(value) < 1e-12 ? 0 : value;
}

/**
 * First the pairs asked for, then one row after the other, coarse ones first, and after the last of each
 * fineness the line of zero.
 * @param {Plan} plan
 * @param {number[]} steps (ft)
 * @returns {Generator<{ pairs: number[] } | Row | Whole, void, undefined>}
 */
export function* rows(plan, steps = STEPS) {
  yield { pairs: plan.pairs.map(({ sensor, jet }) => abscissaAt(plan, sensor, jet)) };
  for (const step of steps) {
    const side = Math.ceil(STATIONS / step);
    const all = new Float64Array(side * side);
    const sweep = new Sweep(plan);
    for (let jet = 0; jet < STATIONS; jet += step) {
      const values = sweep.row(jet, step);
      all.set(values, (jet / step) * side);
      yield { step, jet, values };
    }
    const stable = all.filter((v) => v < 0).length;
    const neutral = all.filter((v) => v === 0).length;
    yield { step, line: zeroLine(all, side, step), stable, neutral };
  }
}

// Runs over all pairs of stations row by row: each cell's roots start from those of the cell beside it.
class Sweep {
  /** @param {Plan} plan */
  constructor(plan) {
    this.plan = plan;
    this.c = new Float64Array(ORDER + 1);
    this.across = AT_SENSOR.map(() => new Float64Array(ORDER + 1));
    this.x = new Float64Array(ORDER);
    this.y = new Float64Array(ORDER);
    /** @type {Float64Array[] | null} the roots of the last row's first cell */
    this.first = null;
  }

  /**
   * @param {number} jet (ft)
   * @param {number} step (ft)
   */
  row(jet, step) {
    const { c, across } = this;
    const { values, parts } = this.plan;
    // The row's own polynomials: only the sensor is left to run.
    across.forEach((sum, i) => {
      sum.set(parts[i][0]);
      for (let j = 1; j < AT_JET.length; j++)
        addTerm(sum, { coefficients: parts[i][j] }, values[AT_JET[j]][jet]);
    });
    const row = new Float64Array(Math.ceil(STATIONS / step));
    let warm = this.first !== null;
    if (this.first) [this.x, this.y] = this.first.map((points) => points.slice());
    for (let n = 0; n < row.length; n++) {
      const p = values.phi_1[n * step];
      const q = values.phi_2[n * step];
      for (let k = 0; k <= ORDER; k++) c[k] = across[0][k] + p * across[1][k] + q * across[2][k];
      row[n] = this.#cell(warm);
      if (n === 0) this.first = [this.x.slice(), this.y.slice()];
      warm = true;
    }
    return row;
  }

  // Aberth keeps real points real, so they start a little off the axis. The sum of the roots tells whether
  // all were found.
  /** @param {boolean} warm whether x and y are near the roots */
  #cell(warm) {
    const { c, x, y } = this;
    if (warm) {
      for (let i = 0; i < ORDER; i++) y[i] += (i % 2 ? 1e-7 : -1.3e-7) * (Math.abs(x[i]) + 1e-6);
      aberth(c, ORDER, x, y, 1e-5);
      let sum = c[ORDER - 1];
      let size = Math.abs(sum);
      for (let i = 0; i < ORDER; i++) {
        sum += x[i];
        size += Math.abs(x[i]);
      }
      if (Math.abs(sum) <= 1e-10 * size) return largest(x);
    }
    const found = roots(c);
    x.set(found.x);
    y.set(found.y);
    return largest(x);
  }
}

/**
 * The line of zero through n by n values `step` feet apart, by straight pieces (marching squares).
 * @param {Float64Array} values
 * @param {number} n
 * @param {number} step
 */
function zeroLine(values, n, step) {
  /** @type {number[]} */
  const path = [];
  const share = (/** @type {number} */ a, /** @type {number} */ b) => a / (a - b);
  for (let j = 0; j + 1 < n; j++) {
    for (let s = 0; s + 1 < n; s++) {
      const at = j * n + s;
      const [a, b, c, d] = [values[at], values[at + 1], values[at + n + 1], values[at + n]];
      const [p, q, r, t] = [a > 0, b > 0, c > 0, d > 0];
      if (p === q && q === r && r === t) continue;
      const points = [];
      if (p !== q) points.push(s + share(a, b), j);
      if (q !== r) points.push(s + 1, j + share(b, c));
      if (t !== r) points.push(s + share(d, c), j + 1);
      if (p !== t) points.push(s, j + share(a, d));
      path.push(...points.map((v) => v * step));
    }
  }
  return Float32Array.from(path);
}
