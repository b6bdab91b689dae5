// Where traced branches cross the imaginary axis as a station runs: no polynomial tells it there.
import { pointAt } from './tracing.js';

/** @typedef {import('./crossings.js').Crossing} Crossing */
/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {import('./tracing.js').Curve} Curve */

/**
 * The crossings between the points of a trace. Where a root stays at the origin, another that passes it there is told by
 * the next coefficient's sign.
 * @param {Curve} curve
 * @param {TracePoint[]} points
 * @returns {Crossing[]}
 */
export function stationCrossings(curve, points) {
  const c = new Float64Array(points[0].x.length + 1);
  const next = (/** @type {number} */ t) => {
    curve.fill(t, c);
    return c[0] === 0 ? c[1] : NaN;
  };
  return points.slice(1).flatMap((b, k) => {
    const a = points[k];
    const found = throughOrigin(next, a.t, b.t, c);
    const anchored = !Number.isNaN(next(b.t));
    for (let i = 0; i < a.x.length; i++) {
      if (a.x[i] * b.x[i] >= 0 || Math.max(Math.abs(a.x[i]), Math.abs(b.x[i])) < 1e-9) continue;
      const m = crossingOf(curve, a, b, i);
      // Of a pair the upper root tells of both.
      if (m.y[i] < -1e-12 || (anchored && m.y[i] < 1e-9)) continue;
      found.push({ gain: m.t, omega: Math.max(0, m.y[i]), direction: Math.sign(b.x[i] - a.x[i]) });
    }
    return found;
  });
}

/**
 * @param {(t: number) => number} next
 * @param {number} from
 * @param {number} to
 * @param {Float64Array} c
 * @returns {Crossing[]}
 */
function throughOrigin(next, from, to, c) {
  let [low, high] = [from, to];
  const [first, last] = [next(low), next(high)];
  if (!(first * last < 0)) return [];
  const direction = Math.sign((first - last) / c[2]);
  for (let turn = 0; turn < 50; turn++) {
    const t = (low + high) / 2;
    if (next(t) * first > 0) low = t;
    else high = t;
  }
  return [{ gain: high, omega: 0, direction }];
}

// By false position between two points (Illinois: the end that stays counts half).
/**
 * @param {Curve} curve
 * @param {TracePoint} a
 * @param {TracePoint} b
 * @param {number} i the branch
 */
function crossingOf(curve, a, b, i) {
  /** @type {Pick<TracePoint, 't' | 'x' | 'y'>[]} */
  let [low, high, m] = [a, b, b];
  let [left, right] = [a.x[i], b.x[i]];
  for (
    let turn = 0;
    turn < 60 && Math.abs(m.x[i]) > 1e-12 * Math.hypot(m.x[i], m.y[i]) && high.t - low.t > 1e-12 * high.t;
    turn++
  ) {
    m = pointAt(curve, [low, high], low.t + ((high.t - low.t) * left) / (left - right));
    if (m.x[i] * right > 0) [high, right, left] = [m, m.x[i], left / 2];
    else [low, left, right] = [m, m.x[i], right / 2];
  }
  return m;
}
