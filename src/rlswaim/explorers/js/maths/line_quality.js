// Whether a branch drawn as a straight line from point to point is true enough to its curve.

/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/**
 * The part of the plane that is drawn (1/s), its scale (pixels per 1/s), and how far the drawn line may be off (pixels).
 * @typedef {{ left: number, right: number, top: number, scale: number, tolerance: number }} View
 */

/**
 * Where only the names of the branches matter.
 * @type {View}
 */
export const BLIND = { left: Infinity, right: -Infinity, top: -Infinity, scale: 1, tolerance: Infinity };

/**
 * @param {TracePoint} point
 * @param {number} i
 */
const isReal = ({ x, y }, i) => Math.abs(y[i]) <= 1e-6 * Math.abs(x[i]);

/**
 * Whether a step from a over its middle m to b must be halved.
 * @param {View} view
 * @param {TracePoint} a
 * @param {TracePoint} m
 * @param {TracePoint} b
 * @param {number} depth how often it was halved before
 */
export function isRough({ left, right, top, scale, tolerance }, a, m, b, depth) {
  if (depth < 16 && (m.far || b.far)) return true;
  const worst = (tolerance / scale) ** 2;
  const long = (8 / scale) ** 2;
  for (let i = 0; i < a.x.length; i++) {
    const bx = b.x[i] - a.x[i];
    const by = b.y[i] - a.y[i];
    const move = bx * bx + by * by;
    // Between two nodes no root leaves the real axis or comes to it, other than at the nodes themselves.
    const corner = a.gap[i] !== Infinity && b.gap[i] !== Infinity && isReal(a, i) !== isReal(b, i);
    if (corner && (depth < 16 || move > worst)) return true;
    if (Math.max(a.x[i], m.x[i], b.x[i]) < left || Math.min(a.x[i], m.x[i], b.x[i]) > right) continue;
    if (Math.min(Math.abs(a.y[i]), Math.abs(m.y[i]), Math.abs(b.y[i])) > top) continue;
    const mx = m.x[i] - a.x[i];
    const my = m.y[i] - a.y[i];
    const part = move > 0 ? Math.max(0, Math.min(1, (bx * mx + by * my) / move)) : 0;
    const offX = mx - part * bx;
    const offY = my - part * by;
    if (offX * offX + offY * offY > worst) return true;
    // Far from halfway along: the speed changes as beside a break-away, and the middle says little of the rest.
    if (Math.abs(part - 0.5) > 0.15 && move > long) return true;
  }
  return false;
}

/**
 * Whether nothing that is seen moves: each root less than the tolerance, or farther off the window than it moves.
 * @param {View} view
 * @param {TracePoint} a
 * @param {TracePoint} b
 */
export function isStill({ left, right, top, scale, tolerance }, a, b) {
  for (let i = 0; i < a.x.length; i++) {
    const dx = b.x[i] - a.x[i];
    const dy = b.y[i] - a.y[i];
    const move = Math.sqrt(dx * dx + dy * dy);
    if (move * scale <= tolerance) continue;
    const off = Math.max(
      left - Math.max(a.x[i], b.x[i]),
      Math.min(a.x[i], b.x[i]) - right,
      Math.min(Math.abs(a.y[i]), Math.abs(b.y[i])) - top,
    );
    if (move > off) return false;
  }
  return true;
}
