// Where in the s plane or the z plane no pole may be: hatched, with a line at its border, so that it needs no
// color.
import { polygon } from './context.js';
import { straight } from './frequency_axes.js';
import { line } from './marks.js';

/** @import { Layer, Plane } from './plane.js' */
/** @typedef {{ sigma: number, zeta: number }} Region 0: not asked for */

const APART = 9; // px between lines of the hatch

/** @param {Plane} plane @param {number[]} corners px */
export function hatch({ g, view, theme }, corners) {
  const { x, y, w, h } = view.frame;
  g.save();
  g.beginPath();
  polygon(g, corners);
  g.clip();
  g.beginPath();
  for (let at = APART * Math.ceil((x - h) / APART); at < x + w; at += APART) {
    g.moveTo(at, y + h);
    g.lineTo(at + h, y);
  }
  g.strokeStyle = theme.axis;
  g.lineWidth = 0.7;
  g.stroke();
  g.restore();
}

/** Right of -sigma. @param {Plane} plane @param {number} sigma */
function decay(plane, sigma) {
  const { x, y, w, h } = plane.view.frame;
  const left = Math.min(Math.max(plane.view.X(-sigma), x), x + w);
  hatch(plane, [left, y, x + w, y, x + w, y + h, left, y + h]);
  straight(plane, [-sigma, plane.view.bottom], [-sigma, plane.view.top], plane.theme.ink, 1.2);
}

/** Above the ray of a damping ratio. @param {Plane} plane @param {number} zeta */
function damping(plane, zeta) {
  const { view } = plane;
  const far = 2 * Math.hypot(Math.max(Math.abs(view.left), Math.abs(view.right)), view.top);
  const [rx, ry] = [-zeta * far, Math.sqrt(1 - zeta * zeta) * far];
  const corners = [
    [0, 0],
    [rx, ry],
    [far, ry],
    [far, 0],
  ];
  hatch(
    plane,
    corners.flatMap(([a, b]) => [view.X(a), view.Y(b)]),
  );
  straight(plane, [0, 0], [rx, ry], plane.theme.ink, 1.2);
}

/** @param {Region} region @returns {Layer} */
export const requiredRegion =
  ({ sigma, zeta }) =>
  (plane) => {
    if (sigma > 0) decay(plane, sigma);
    if (zeta > 0) damping(plane, zeta);
  };

const STEPS = 96; // of a spiral or a circle over the upper half

/**
 * Hatches what lies outside of a curve about z = 0, from the positive to the negative real axis.
 * @param {Plane} plane @param {(angle: number) => number} sizeAt
 */
function outside(plane, sizeAt) {
  const { view, theme } = plane;
  const border = Array.from({ length: STEPS + 1 }, (_, k) => {
    const angle = (Math.PI * k) / STEPS;
    return [sizeAt(angle) * Math.cos(angle), sizeAt(angle) * Math.sin(angle)];
  });
  const far = 2 * Math.max(Math.abs(view.left), Math.abs(view.right), view.top, 1);
  const around = [
    [-far, 0],
    [-far, far],
    [far, far],
    [far, 0],
  ];
  hatch(
    plane,
    [...border, ...around].flatMap(([a, b]) => [view.X(a), view.Y(b)]),
  );
  line(border, theme.ink, 1.2)(plane);
}

/** @param {{ radius: number, zeta: number }} region radius 1 and zeta 0: not asked for @returns {Layer} */
export const requiredInZ =
  ({ radius, zeta }) =>
  (plane) => {
    if (radius < 1) outside(plane, () => radius);
    const turn = zeta / Math.sqrt(1 - zeta * zeta);
    if (zeta > 0) outside(plane, (angle) => Math.exp(-turn * angle));
  };
