// Puts the roots of a point of a trace in the order of the point before: each stays on its branch.
import { matchRoots } from './match_roots.js';

/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {import('./trace_points.js').Numbers} Numbers */

// A root that moves by less than a third of the distance to the next one is not taken for it.
const NEAR = 0.1;

/**
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} i
 */
const isFlat = (x, y, i) => Math.abs(y[i]) <= 1e-10 * Math.abs(x[i]);

/**
 * @param {Numbers} x
 * @param {Numbers} y
 * @param {number} i
 * @param {number} j
 */
const areConjugates = (x, y, i, j) =>
  y[i] * y[j] < 0 &&
  Math.abs(y[i] + y[j]) < 1e-6 * Math.abs(y[i]) &&
  Math.hypot(x[i] - x[j], y[i] + y[j]) < 1e-6 * Math.abs(y[i]);

/** @param {Int32Array} partner */
function hasMoves(partner) {
  for (let i = 0; i < partner.length; i++) if (partner[i] !== i) return true;
  return false;
}

export class BranchOrder {
  /** @param {number} n number of branches */
  constructor(n) {
    this.partner = new Int32Array(n);
    this.spare = new Float64Array(n);
  }

  /**
   * Puts a point's roots in the order of the point before. Two that coincide can't tell which is which: the next point
   * then asks where they came from.
   * @param {TracePoint} before
   * @param {TracePoint} point
   */
  order(before, point) {
    if (point.follows === before.number && point.seen === before.turns) return;
    point.follows = before.number;
    point.seen = before.turns;
    compare(before, point);
    if (!point.clear) {
      matchRoots(before.kx, before.ky, point.x, point.y, this.partner);
      this.swapWhereBranchesMeet(before, point);
      if (hasMoves(this.partner)) {
        this.turn(point.x);
        this.turn(point.y);
        this.turn(point.gap);
        point.turns++;
        compare(before, point);
        point.clear = false;
      }
    }
    if (!point.apart) keepOrigin(point, before);
  }

  /** @param {Numbers} values */
  turn(values) {
    const { partner, spare } = this;
    for (let i = 0; i < spare.length; i++) spare[i] = values[i];
    for (let i = 0; i < spare.length; i++) values[i] = spare[partner[i]];
  }

  /**
   * Where two branches meet on the real axis both pairings are equally near. The right one of two real roots is the upper
   * one of a pair and the other way round, so that a step over both a meeting and a parting finds them in the same order.
   * @param {TracePoint} before
   * @param {TracePoint} point
   */
  swapWhereBranchesMeet({ kx, ky }, { x, y }) {
    const { partner } = this;
    for (let i = 0; i < partner.length; i++) {
      for (let j = i + 1; j < partner.length; j++) {
        const [p, q] = [partner[i], partner[j]];
        const meet = isFlat(kx, ky, i) && isFlat(kx, ky, j) && areConjugates(x, y, p, q);
        const part = isFlat(x, y, p) && isFlat(x, y, q) && areConjugates(kx, ky, i, j);
        if ((meet && kx[i] > kx[j] !== y[p] > y[q]) || (part && ky[i] > ky[j] !== x[p] > x[q]))
          [partner[i], partner[j]] = [q, p];
      }
    }
  }
}

// Clear: each root moves little beside the distance to the next one, and no other pairing can be nearer. Far: one doesn't.
/**
 * @param {TracePoint} before
 * @param {TracePoint} point
 */
function compare(before, point) {
  const { x, y } = point;
  point.far = false;
  point.clear = before.apart;
  for (let i = 0; i < x.length; i++) {
    const dx = x[i] - before.x[i];
    const dy = y[i] - before.y[i];
    if (dx * dx + dy * dy <= NEAR * before.gap[i]) continue;
    point.far = true;
    point.clear = false;
    return;
  }
}

/**
 * @param {TracePoint} point
 * @param {TracePoint} before
 */
function keepOrigin(point, before) {
  const { x, y, gap } = point;
  [point.kx, point.ky] = [x.slice(), y.slice()];
  for (let i = 0; i < x.length; i++)
    if (gap[i] === Infinity) [point.kx[i], point.ky[i]] = [before.kx[i], before.ky[i]];
}
