// Guesses for the roots that leave from one place.
import { startingPoints } from './starting_points.js';

/** @typedef {import('./trace_points.js').Numbers} Numbers */

/**
 * Where three or more roots of the point before coincide, puts their guesses on the circle about that place
 * whose radius the polynomial's coefficients there tell: equal guesses would stay equal.
 * @param {Float64Array} c
 * @param {{ x: Numbers, y: Numbers, gap: Numbers }} before
 * @param {Numbers} x
 * @param {Numbers} y
 */
export function spreadMultiple(c, before, x, y) {
  const left = new Set(Array.from(before.gap.keys()).filter((i) => before.gap[i] === Infinity));
  if (left.size < 3) return;
  for (const i of left) {
    const members = [...left].filter(
      (j) =>
        Math.hypot(before.x[j] - before.x[i], before.y[j] - before.y[i]) <=
        1e-4 * Math.hypot(before.x[i], before.y[i]),
    );
    for (const j of members) left.delete(j);
    if (members.length > 2) spread(c, members, before.x[i], before.y[i], x, y);
  }
}

/**
 * @param {Float64Array} c
 * @param {number[]} members
 * @param {number} px
 * @param {number} py
 * @param {Numbers} x
 * @param {Numbers} y
 */
function spread(c, members, px, py, x, y) {
  const n = c.length - 1;
  const [re, im] = [Float64Array.from(c), new Float64Array(n + 1)];
  for (let j = 0; j <= n; j++) {
    for (let k = n - 1; k >= j; k--) {
      const [a, b] = [re[k + 1], im[k + 1]];
      re[k] += a * px - b * py;
      im[k] += a * py + b * px;
    }
  }
  const sizes = re.map((v, k) => Math.hypot(v, im[k]));
  if (sizes[0] === 0 || sizes[n] === 0) return;
  const [sx, sy] = startingPoints(sizes, n);
  members.forEach((i, k) => {
    x[i] = px + sx[k];
    y[i] = py + sy[k];
  });
}
