// What lies nearest to the pointer: a point of a traced curve, or a pole.
/** @import { Point, Roots, View } from '../types.d.ts' */
/**
 * @typedef {{ branch: number, t: number, x: number, y: number }} Place on a branch, where t runs
 */

/**
 * The point of a traced curve nearest to (px, py), if it is within reach, along the chords between the
 * points.
 * @param {Point[]} points @param {View} view @param {number} px @param {number} py @param {number} reach px
 * @returns {Place | null}
 */
export function nearestOn(points, { X, Y }, px, py, reach) {
  let least = reach * reach;
  let found = null;
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1], points[k]];
    for (let i = 0; i < a.x.length; i++) {
      const [ax, ay] = [X(a.x[i]), Y(Math.abs(a.y[i]))];
      const [dx, dy] = [X(b.x[i]) - ax, Y(Math.abs(b.y[i])) - ay];
      const length = dx * dx + dy * dy;
      const part = length ? Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
      const off = (ax + part * dx - px) ** 2 + (ay + part * dy - py) ** 2;
      if (off >= least) continue;
      least = off;
      found = {
        branch: i,
        t: a.t + part * (b.t - a.t),
        x: a.x[i] + part * (b.x[i] - a.x[i]),
        y: a.y[i] + part * (b.y[i] - a.y[i]),
      };
    }
  }
  return found;
}

/**
 * The pole nearest to (px, py) if it is within reach, else -1; of two at one place the one above the axis.
 * @param {Roots} poles @param {View} view @param {number} px @param {number} py @param {number} reach px
 */
export function nearestPole({ x, y }, view, px, py, reach) {
  let least = reach * reach;
  let found = -1;
  for (let i = 0; i < x.length; i++) {
    const off = (view.X(x[i]) - px) ** 2 + (view.Y(Math.abs(y[i])) - py) ** 2;
    if (off < least - 1e-9 || (found >= 0 && off < least + 1e-9 && y[found] < 0)) [least, found] = [off, i];
  }
  return found;
}

/**
 * The root nearest to re + j im, and its distance.
 * @param {Roots} roots @param {number} re @param {number} im
 */
export function nearestRoot({ x, y }, re, im) {
  const off = Array.from(x, (v, i) => Math.hypot(v - re, y[i] - im));
  const least = Math.min(...off);
  return { index: off.indexOf(least), off: least };
}
