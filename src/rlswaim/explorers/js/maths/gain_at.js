// The value of the running parameter at a place of a drawn branch.
import { runningCurve } from './running_curve.js';
import { pointAt } from './tracing.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').What} What */
/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {Pick<TracePoint, 't' | 'x' | 'y'>} Place */

const GOLDEN = (Math.sqrt(5) - 1) / 2;

/**
 * The value of the running parameter at which a branch of a locus comes nearest to a point: the nearest place on the drawn
 * line first, then golden section on the curve itself.
 * @param {System} system
 * @param {State} state
 * @param {What} what
 * @param {number} branch
 * @param {number} x
 * @param {number} y
 * @param {{ branches: TracePoint[] }} locus
 */
export function gainAt(system, state, what, branch, x, y, locus) {
  const points = locus.branches;
  const best = nearestPoint(points, branch, x, y);
  const { curve } = runningCurve(system, state, what);
  const distance = (/** @type {Place} */ p) => Math.hypot(p.x[branch] - x, p.y[branch] - y);
  /** @type {Place} */
  let low = points[Math.max(0, best - 1)];
  /** @type {Place} */
  let high = points[Math.min(points.length - 1, best + 1)];
  const at = (/** @type {number} */ share) => pointAt(curve, points, low.t + share * (high.t - low.t));
  let [first, second] = [at(1 - GOLDEN), at(GOLDEN)];
  for (let turn = 0; turn < 100; turn++) {
    if (!(Math.abs(high.t - low.t) > 1e-9 * Math.max(Math.abs(low.t), Math.abs(high.t)))) break;
    if (distance(first) <= distance(second)) {
      [high, second] = [second, first];
      first = at(1 - GOLDEN);
    } else {
      [low, first] = [first, second];
      second = at(GOLDEN);
    }
  }
  return [low, first, second, high].reduce((p, q) => (distance(q) < distance(p) ? q : p)).t;
}

// The number of the drawn point that is nearest along the line.
/**
 * @param {TracePoint[]} points
 * @param {number} branch
 * @param {number} x
 * @param {number} y
 */
function nearestPoint(points, branch, x, y) {
  let best = 0;
  let least = Infinity;
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1], points[k]];
    const [dx, dy] = [b.x[branch] - a.x[branch], b.y[branch] - a.y[branch]];
    const [ex, ey] = [x - a.x[branch], y - a.y[branch]];
    const part = Math.max(0, Math.min(1, (ex * dx + ey * dy) / (dx * dx + dy * dy || 1)));
    const off = Math.hypot(ex - part * dx, ey - part * dy);
    if (off < least) [least, best] = [off, part < 0.5 ? k - 1 : k];
  }
  return best;
}
