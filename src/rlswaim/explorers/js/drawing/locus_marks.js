// Marks of a root locus on the upper half of the s plane: what lies below the real axis mirrors it. Each is a
// layer.

import { polygon } from './context.js';
import { arrowHead, cross, mark } from './marks.js';
import { number } from './numbers.js';

/** @import { Crossing, NamedRoots, Point, Roots } from '../types.d.ts' */
/** @import { Layer, Plane } from './plane.js' */

/** Below the axis by more than rounding. @param {Roots} p @param {number} i */
const below = (p, i) => p.y[i] < -1e-7 * Math.abs(p.x[i]);

/** The root nearest to the mirror image of root i. @param {Roots} p @param {number} i */
function mirror(p, i) {
  let best = i;
  let least = Infinity;
  for (let j = 0; j < p.x.length; j++) {
    const d = Math.abs(p.x[j] - p.x[i]) + Math.abs(p.y[j] + p.y[i]);
    if (j !== i && d < least) [best, least] = [j, d];
  }
  return best;
}

/**
 * Stretches of branch i, each with whether it lies below the axis as the mirror image of another branch.
 * Leaving the axis such a stretch starts at the point before, returning to it it ends there.
 * @param {Point[]} points @param {string[]} names @param {number} i
 */
function stretches(points, names, i) {
  const found = [];
  let from = 0;
  let apart = false;
  for (let k = 0; k < points.length; k++) {
    const mixed = below(points[k], i) && names[mirror(points[k], i)] !== names[i];
    if (mixed === apart) continue;
    /** @type {number} */
    const to = mixed ? k - 1 : k;
    found.push({ from, to, apart });
    [from, apart] = [Math.max(to, 0), mixed];
  }
  found.push({ from, to: points.length - 1, apart });
  return found;
}

/** @param {Plane} plane @param {Point[]} points @param {number} from @param {number} to @param {number} i */
function run(plane, points, from, to, i, color = '') {
  if (to <= from) return;
  const { g } = plane;
  const { X, Y } = plane.view;
  g.beginPath();
  g.moveTo(X(points[from].x[i]), Y(Math.abs(points[from].y[i])));
  for (let k = from + 1; k <= to; k++) g.lineTo(X(points[k].x[i]), Y(Math.abs(points[k].y[i])));
  plane.stroke(color, 2);
}

/**
 * The traced branches. Where a root above the axis and its mirror image come from different branches, the two
 * colors alternate: such a motion belongs to neither alone.
 * @param {Point[]} points @param {string[]} names @returns {Layer}
 */
export const branches = (points, names) => (plane) => {
  const { g, theme } = plane;
  const over = [];
  for (let i = 0; i < names.length; i++) {
    for (const stretch of stretches(points, names, i)) {
      if (stretch.apart) over.push({ ...stretch, i });
      else run(plane, points, stretch.from, stretch.to, i, theme.color(names[i]));
    }
  }
  if (over.length === 0) return;
  g.setLineDash([7, 7]);
  for (const { from, to, i } of over) run(plane, points, from, to, i, theme.color(names[i]));
  g.setLineDash([]);
};

/**
 * Arrow heads in the direction of the run, one in each stretch of so many px.
 * @param {Point[]} points
 * @returns {Layer}
 */
export const directions =
  (points, names = /** @type {string[]} */ ([]), every = 110) =>
  ({ g, view: { X, Y, holds }, theme }) => {
    names.forEach((name, i) => {
      let left = every / 2;
      g.beginPath();
      for (let k = 1; k < points.length; k++) {
        const [a, b] = [points[k - 1], points[k]];
        const [x, y] = [X(b.x[i]), Y(Math.abs(b.y[i]))];
        const [dx, dy] = [x - X(a.x[i]), y - Y(Math.abs(a.y[i]))];
        const length = Math.sqrt(dx * dx + dy * dy);
        left -= length;
        if (left > 0 || length === 0 || below(b, i)) continue;
        left = every;
        const [mx, my, ux, uy] = [x - dx / 2, y - dy / 2, dx / length, dy / length];
        if (holds(mx, my)) arrowHead(g, mx + 6 * ux, my + 6 * uy, ux, uy, 10.2, 4.8);
      }
      g.fillStyle = theme.color(name);
      g.fill();
    });
  };

/**
 * The poles under the sliders: each the filled sign of its branch.
 * @param {Roots} at @param {string[]} names
 * @returns {Layer}
 */
export const poles = (at, names) => (plane) => {
  const { theme } = plane;
  names.forEach((name, i) => {
    mark(theme.sign(name), at.x[i], Math.abs(at.y[i]), theme.color(name))(plane);
  });
};

/** Where branches begin. @param {NamedRoots} open @returns {Layer} */
export const crosses = (open) => (plane) => {
  open.branches.forEach((name, i) => {
    cross(open.x[i], Math.abs(open.y[i]), plane.theme.color(name))(plane);
  });
};

/**
 * A small open diamond on the border of stability with the gain and the frequency beside it.
 * @param {Crossing} at @param {boolean} discrete on the unit circle, else on the imaginary axis
 * @returns {Layer}
 */
export const crossing =
  ({ gain, omega }, discrete = false) =>
  (plane) => {
    const { g, theme, view } = plane;
    const place = discrete ? [Math.cos(omega), Math.sin(omega)] : [0, omega];
    const [x, y] = [view.X(place[0]), view.Y(place[1])];
    if (!view.holds(x, y)) return;
    g.beginPath();
    polygon(g, [x, y - 5, x + 5, y, x, y + 5, x - 5, y]);
    g.fillStyle = theme.plane;
    g.fill();
    plane.stroke(theme.ink, 1.2);
    const at = number(gain, 3);
    plane.text(omega ? `${at} · ω ${number(omega, 3)}` : at, x + 9, y - 14, theme.ink, 'left');
  };
