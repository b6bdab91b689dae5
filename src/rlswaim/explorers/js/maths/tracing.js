// Follows all roots of a polynomial that depends on one number t, as continuous branches.
import { aberth, anchor, flatten, settle } from './aberth.js';
import { BranchOrder } from './branch_order.js';
import { isRough, isStill } from './line_quality.js';
import { matchRoots } from './match_roots.js';
import { spreadMultiple } from './spread_multiple.js';
import { tracePoint } from './trace_points.js';

/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {import('./trace_points.js').Numbers} Numbers */
/** @typedef {import('./line_quality.js').View} View */
/** @typedef {import('./break_aways.js').BreakAway} BreakAway */
/**
 * fill puts the polynomial at t into c, middle returns the place between two t, and at the breaks roots meet;
 * solve moves points to the roots at t, where something tells these better than the polynomial does, and
 * returns how often it moved one.
 * @typedef {{ fill: (t: number, c: Float64Array) => void, middle: (a: number, b: number) => number,
 *   breaks?: BreakAway[], solve?: (t: number, x: Numbers, y: Numbers, close: number) => number }} Curve
 */

const DEEPEST = 28;
// The most work of a trace, in terms of the polynomial that are evaluated; what is left then is drawn as it
// is. A locus of order 30 takes a hundredth of it, one of 101 branches an eighth.
const MOST = 2e7;
const EACH = 5000; // what a solution costs besides, in the same unit

/** Traces a curve of n roots stretch by stretch. */
export class Tracer {
  /**
   * @param {Curve} curve
   * @param {number} n
   * @param {View} view BLIND where only the names of the branches matter
   */
  constructor(curve, n, view) {
    this.curve = curve;
    this.n = n;
    this.view = view;
    this.c = new Float64Array(n + 1);
    this.branches = new BranchOrder(n);
    this.budget = MOST;
    /** @type {TracePoint[]} */
    this.points = [];
    // Aberth keeps real points real and equal points equal, so they start a little off the axis and apart.
    this.shifts = Float64Array.from({ length: n }, (_, i) => (i % 2 ? 1e-8 : -1.3e-8) * (1 + i / (8 * n)));
  }

  /**
   * The points from a to the value t, the last one there.
   * @param {TracePoint} a
   * @param {number} t
   */
  to(a, t) {
    this.points = [];
    this.segment(a, this.solve(t, a, a, true), 0);
    return this.points;
  }

  /**
   * The roots at t, from those at two points beside it.
   * @param {number} t
   * @param {TracePoint} a
   * @param {TracePoint} b
   * @param {boolean} atNode whether roots may meet at this t
   */
  solve(t, a, b, atNode) {
    const { n, c, curve, shifts } = this;
    const x = a.x.slice();
    const y = a.y.slice();
    for (let i = 0; i < n; i++) {
      x[i] = (a.x[i] + b.x[i]) / 2;
      y[i] = (a.y[i] + b.y[i]) / 2 + shifts[i] * (Math.abs(x[i]) + 1e-9);
      x[i] += 0.3 * shifts[i] * (Math.abs(x[i]) + 1e-9); // nor on a line to both sides of which all is alike
    }
    curve.fill(t, c);
    if (!a.apart) spreadMultiple(c, a, x, y);
    const moves = curve.solve ? curve.solve(t, x, y, 1e-3) : aberth(c, n, x, y, 1e-3);
    settle(x, y);
    anchor(c, x, y);
    if (atNode) meet(curve.breaks ?? [], t, x, y);
    this.budget -= EACH + n * (moves + n);
    return tracePoint(t, x, y);
  }

  /**
   * Traces from a to b: halves the step until the drawn line is true and no root moves so far that it could
   * be taken for another.
   * @param {TracePoint} a
   * @param {TracePoint} b
   * @param {number} depth
   */
  segment(a, b, depth) {
    this.branches.order(a, b); // a may have changed its order since
    if (b.clear && isStill(this.view, a, b)) {
      this.points.push(b);
      return;
    }
    const m = this.solve(this.curve.middle(a.t, b.t), a, b, false);
    this.branches.order(a, m);
    this.branches.order(m, b);
    if (depth < DEEPEST && this.budget > 0 && isRough(this.view, a, m, b, depth)) {
      this.segment(a, m, depth + 1);
      this.segment(m, b, depth + 1);
    } else this.points.push(m, b);
  }
}

// At a break-away the roots that meet there are known better than they can be found.
/**
 * @param {BreakAway[]} breaks
 * @param {number} t
 * @param {Numbers} px
 * @param {Numbers} py
 */
function meet(breaks, t, px, py) {
  for (const { gain, x, y, count } of breaks) {
    if (gain !== t) continue;
    for (const at of y === 0 ? [0] : [y, -y]) {
      const off = Array.from(px, (v, i) => Math.hypot(v - x, py[i] - at));
      for (let k = 0; k < count; k++) {
        const i = off.indexOf(Math.min(...off));
        if (i < 0) break;
        [px[i], py[i], off[i]] = [x, at, Infinity];
      }
    }
  }
}

/**
 * Traces t over the nodes, a stretch at each step; at last returns the points, whose branches are in the
 * order of start: { x, y } at the first node. Traced back, a curve has the same branches as on its way forth.
 * @param {Curve} curve
 * @param {number[]} nodes
 * @param {{ x: ArrayLike<number>, y: ArrayLike<number> }} start
 * @param {View} view
 * @returns {Generator<undefined, TracePoint[], undefined>}
 */
export function* tracing(curve, nodes, start, view) {
  const tracer = new Tracer(curve, start.x.length, view);
  const points = [tracePoint(nodes[0], Array.from(start.x), Array.from(start.y))];
  for (const t of nodes.slice(1)) {
    for (const point of tracer.to(points[points.length - 1], t)) points.push(point);
    yield;
  }
  return points;
}

/**
 * Runs to the end what goes step by step.
 * @template T
 * @param {Generator<any, T, undefined>} steps
 * @returns {T}
 */
export function finished(steps) {
  let step = steps.next();
  while (!step.done) step = steps.next();
  return step.value;
}

/**
 * @param {Curve} curve
 * @param {number[]} nodes
 * @param {{ x: ArrayLike<number>, y: ArrayLike<number> }} start
 * @param {View} view
 */
export const trace = (curve, nodes, start, view) => finished(tracing(curve, nodes, start, view));

/**
 * The roots of the curve at t beside a guess, in its order, to the last digits.
 * @param {Curve} curve
 * @param {number} t
 * @param {{ x: Numbers, y: Numbers }} guess
 */
export function pointBeside(curve, t, guess) {
  const n = guess.x.length;
  const shift = (/** @type {number} */ i) => (i % 2 ? 1e-8 : -1.3e-8) * (1 + i / (8 * n));
  const x = Array.from(guess.x, (v, i) => v * (1 + 0.3 * shift(i)));
  const y = Array.from(guess.y, (v, i) => v + shift(i) * Math.abs(x[i]));
  const c = new Float64Array(n + 1);
  curve.fill(t, c);
  if (curve.solve) curve.solve(t, x, y, 1e-6);
  else aberth(c, n, x, y);
  flatten(x, y);
  anchor(c, x, y);
  const partner = matchRoots(guess.x, guess.y, x, y, new Int32Array(n));
  return { t, x: Array.from(partner, (i) => x[i]), y: Array.from(partner, (i) => y[i]) };
}

/**
 * The roots at one value of t inside a traced curve, in the order of its branches.
 * @param {Curve} curve
 * @param {{ t: number, x: Numbers, y: Numbers }[]} points
 * @param {number} t
 */
export function pointAt(curve, points, t) {
  const next = Math.max(
    1,
    points.findIndex((p, i) => i > 0 && (p.t - t) * (points[i - 1].t - t) <= 0),
  );
  const [a, b] = [points[next - 1], points[next]];
  const part = a.t === b.t ? 0 : (t - a.t) / (b.t - a.t);
  const between = (/** @type {'x' | 'y'} */ k) => Array.from(a[k], (v, i) => v + part * (b[k][i] - v));
  return pointBeside(curve, t, { x: between('x'), y: between('y') });
}
