// The upper half of the z plane as a ground for marks: outside of the unit circle roots are unstable; lines
// of constant damping and frequency are those of s with z = e^(sT).
import { ground, Plane } from './plane.js';
import { axes } from './s_plane.js';
import { stepOf } from './ticks.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Layer } from './plane.js' */

const DAMPING = [0.1, 0.2, 0.4, 0.6, 0.8];
const TENTHS = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
const STEPS = 48;
const APART = 25; // px between numbers beside the plane

/** Where s = -zeta omega + j omega sqrt(1 - zeta^2) lies. @param {number} zeta @param {number} omega */
function placeOf(zeta, omega) {
  const size = Math.exp(-zeta * omega);
  const angle = omega * Math.sqrt(1 - zeta * zeta);
  return [size * Math.cos(angle), size * Math.sin(angle)];
}

/** @type {Layer} */
function unstableRest({ g, view, theme }) {
  const { x, y, w, h } = view.frame;
  g.fillStyle = theme.unstable;
  g.fillRect(x, y, w, h);
  g.beginPath();
  g.arc(view.X(0), view.Y(0), view.scale, 0, 2 * Math.PI);
  g.fillStyle = theme.plane;
  g.fill();
}

/** @param {Layer extends (plane: infer P) => any ? P : never} plane @param {number[][]} points */
function through({ g, view }, points) {
  points.forEach(([x, y], k) => {
    if (k) g.lineTo(view.X(x), view.Y(y));
    else g.moveTo(view.X(x), view.Y(y));
  });
}

/** Rays and circles of s as they are in z. @type {Layer} */
function dampingGrid(plane) {
  const { g, theme } = plane;
  const part = Array.from({ length: STEPS + 1 }, (_, k) => k / STEPS);
  g.beginPath();
  for (const zeta of DAMPING) {
    const last = Math.PI / Math.sqrt(1 - zeta * zeta);
    through(
      plane,
      part.map((share) => placeOf(zeta, share * last)),
    );
  }
  for (const tenth of TENTHS) {
    const omega = (tenth * Math.PI) / 10;
    through(
      plane,
      part.map((zeta) => placeOf(zeta, omega)),
    );
  }
  plane.stroke(theme.grid, 1);
}

/** The damping of each line, and the border of stability. @type {Layer} */
function circle(plane) {
  const { g, view, theme } = plane;
  for (const zeta of DAMPING) {
    const [x, y] = placeOf(zeta, 0.55 * Math.PI);
    if (view.scale > 60 && view.holds(view.X(x), view.Y(y)))
      plane.text(`ζ ${zeta}`, view.X(x), view.Y(y), theme.muted);
  }
  g.beginPath();
  g.arc(view.X(0), view.Y(0), view.scale, 0, 2 * Math.PI);
  plane.stroke(theme.axis, 1.5);
}

/**
 * The plane with its numbers, and marks on it.
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {...Layer} marks
 */
export function zPlane(g, view, theme, ...marks) {
  const step = stepOf(view.right - view.left, view.frame.w, 70);
  return new Plane(g, view, theme)
    .clear()
    .layers(ground, unstableRest)
    .numbers(step, Math.max(step, stepOf(view.top - view.bottom, view.frame.h, APART)))
    .labels('Re z', 'Im z')
    .layers(dampingGrid, axes, circle, ...marks);
}
