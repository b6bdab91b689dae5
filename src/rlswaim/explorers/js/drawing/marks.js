// Marks on a plane: lines, shapes, crosses, rings, arrows. Each is a layer.
import { polygon } from './context.js';

/** @import { Graphics, Roots } from '../types.d.ts' */
/** @import { Layer, Plane } from './plane.js' */

/**
 * One shape for each sign, a path about the origin: things are told apart without color too.
 * @type {Record<string, (g: Graphics, r: number) => void>}
 */
const SHAPES = {
  '■': (g, r) => g.rect(-r, -r, 2 * r, 2 * r),
  '●': (g, r) => g.arc(0, 0, 1.1 * r, 0, 2 * Math.PI),
  '▲': (g, r) => polygon(g, [0, -1.3 * r, 1.25 * r, r, -1.25 * r, r]),
  '◆': (g, r) => polygon(g, [0, -1.5 * r, 1.5 * r, 0, 0, 1.5 * r, -1.5 * r, 0]),
  '▼': (g, r) => polygon(g, [0, 1.3 * r, 1.25 * r, -r, -1.25 * r, -r]),
  '◀': (g, r) => polygon(g, [-1.3 * r, 0, r, -1.25 * r, r, 1.25 * r]),
  '▶': (g, r) => polygon(g, [1.3 * r, 0, -r, -1.25 * r, -r, 1.25 * r]),
  '⬟': (g, r) =>
    polygon(
      g,
      [0, -1.4, 1.35, -0.4, 0.85, 1.2, -0.85, 1.2, -1.35, -0.4].map((v) => v * r),
    ),
};
/** A motion has one sign in all chapters. @type {Record<string, string>} */
const SIGNS = {
  attitude: '■',
  'short period': '●',
  'mode 1': '▲',
  'mode 2': '◆',
  actuator: '▼',
  valve: '◀',
  zero: '▶',
};

/**
 * A sign for each name: its own, or one that is left; many names share the signs.
 * @param {string[]} names @returns {Map<string, string>}
 */
export function signsOf(names) {
  const taken = names.map((name) => SIGNS[name]);
  const left = Object.keys(SHAPES).filter((sign) => !taken.includes(sign));
  let next = 0;
  return new Map([...names].sort().map((name) => [name, SIGNS[name] ?? left[next++ % left.length]]));
}

/** A polyline. @param {number[][]} points @param {string} color @returns {Layer} */
export const line =
  (points, color, width = 2, dash = /** @type {number[]} */ ([])) =>
  (plane) => {
    const { g, view } = plane;
    g.beginPath();
    for (const [x, y] of points) g.lineTo(view.X(x), view.Y(y));
    g.setLineDash(dash);
    plane.stroke(color, width);
    g.setLineDash([]);
  };

/**
 * A filled sign.
 * @param {string} sign @param {number} x @param {number} y @param {string} color
 * @returns {Layer}
 */
export const mark =
  (sign, x, y, color, size = 5) =>
  (plane) => {
    const { g, view, theme } = plane;
    g.save();
    g.translate(view.X(x), view.Y(y));
    g.beginPath();
    SHAPES[sign](g, size);
    plane.stroke(theme.plane, 3);
    g.fillStyle = color;
    g.fill();
    plane.stroke(theme.ink, 1);
    g.restore();
  };

/** @param {number} x @param {number} y @param {string} color @returns {Layer} */
export const dot =
  (x, y, color) =>
  ({ g, view }) => {
    g.beginPath();
    g.arc(view.X(x), view.Y(y), 2.6, 0, 2 * Math.PI);
    g.fillStyle = color;
    g.fill();
  };

/**
 * A ring, on an edge where one is given.
 * @param {number} x @param {number} y @param {number} radius
 * @returns {Layer}
 */
export const ring =
  (x, y, radius, width = 1.6, { color = '', edge = '', inside = '' } = {}) =>
  (plane) => {
    const { g, view, theme } = plane;
    g.beginPath();
    g.arc(view.X(x), view.Y(y), radius, 0, 2 * Math.PI);
    if (inside) {
      g.fillStyle = inside;
      g.fill();
    }
    if (edge) plane.stroke(edge, width + 2);
    plane.stroke(color || theme.ink, width);
  };

/**
 * Two strokes that cross at a point, on an edge in another color.
 * @param {Plane} plane @param {number} px @param {number} py @param {number[]} arm of the first
 * @param {string} color @param {number} width @param {string} edge
 */
function strokes(plane, px, py, [dx, dy], color, width, edge) {
  const { g } = plane;
  g.beginPath();
  for (const [x, y] of [
    [dx, dy],
    [-dy, dx],
  ]) {
    g.moveTo(px - x, py - y);
    g.lineTo(px + x, py + y);
  }
  plane.stroke(edge, width + 2.4);
  plane.stroke(color, width);
}

/** A cross, ×. @param {number} x @param {number} y @param {string} color @returns {Layer} */
export const cross = (x, y, color) => (plane) =>
  strokes(plane, plane.view.X(x), plane.view.Y(y), [5, 5], color, 2, plane.theme.plane);

/** An upright cross, +. @param {number} x @param {number} y @param {number} size @returns {Layer} */
export const plus =
  (x, y, size, color = '', width = 1.6, edge = '') =>
  (plane) => {
    const { view, theme } = plane;
    strokes(plane, view.X(x), view.Y(y), [size, 0], color || theme.ink, width, edge || theme.plane);
  };

/** Words beside a point. @param {string} words @param {number} x @param {number} y @returns {Layer} */
export const label =
  (words, x, y, dx = 0, dy = 0, color = '', align = 'center') =>
  (plane) =>
    plane.text(words, plane.view.X(x) + dx, plane.view.Y(y) + dy, color || plane.theme.ink, align);

/**
 * The head of an arrow, for a fill: its tip, the unit vector of its direction, its length and half its width.
 * @param {Graphics} g @param {number} x @param {number} y @param {number} ux @param {number} uy
 * @param {number} length @param {number} half
 */
export function arrowHead(g, x, y, ux, uy, length, half) {
  const [bx, by] = [x - length * ux, y - length * uy];
  polygon(g, [x, y, bx - half * uy, by + half * ux, bx + half * uy, by - half * ux]);
}

/**
 * An arrow from px to px.
 * @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1
 * @param {string} color @returns {Layer}
 */
export const arrow =
  (x0, y0, x1, y1, color, width = 2) =>
  (plane) => {
    const { g } = plane;
    const size = Math.hypot(x1 - x0, y1 - y0);
    if (size < 1) return;
    const head = Math.min(9, size);
    const [ux, uy] = [(x1 - x0) / size, (y1 - y0) / size];
    g.beginPath();
    g.moveTo(x0, y0);
    g.lineTo(x1 - 0.8 * head * ux, y1 - 0.8 * head * uy);
    plane.stroke(color, width);
    g.beginPath();
    arrowHead(g, x1, y1, ux, uy, head, 0.45 * head);
    g.fillStyle = color;
    g.fill();
  };

/** Many roots as small squares, those above the axis and on it. @param {Roots[]} all @returns {Layer} */
export const specks = (all) => (plane) => {
  const { g, view, theme } = plane;
  g.beginPath();
  for (const { x, y } of all)
    for (let i = 0; i < x.length; i++) {
      if (y[i] < 0) continue;
      const [px, py] = [view.X(x[i]), view.Y(y[i])];
      if (view.holds(px, py)) g.rect(px - 1, py - 1, 2, 2);
    }
  g.fillStyle = theme.muted;
  g.fill();
};
