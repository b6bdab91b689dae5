// The upper half of the s plane as a ground for marks: unstable half, lines of constant damping and
// frequency, axes.
import { write } from './context.js';
import { ground, Plane } from './plane.js';
import { multiples, stepOf, tick } from './ticks.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Layer } from './plane.js' */

const DAMPING = [0.8, 0.6, 0.4, 0.2, 0.1];

/** @type {Layer} */
function unstableHalf({ g, view, theme }) {
  const { x, y, w, h } = view.frame;
  const axis = Math.min(Math.max(view.X(0), x), x + w);
  g.fillStyle = theme.unstable;
  g.fillRect(axis, y, x + w - axis, h);
}

/** Circles of constant frequency and rays of constant damping. @param {number} step @returns {Layer} */
const polarGrid = (step) => (plane) => {
  const { g, theme, view } = plane;
  const { left, right, bottom, top, X, Y } = view;
  const far = Math.hypot(Math.max(-left, right), top);
  const near = Math.hypot(Math.max(left, -right, 0), Math.max(bottom, 0));
  g.beginPath();
  for (const radius of multiples(step, Math.max(near, step), far)) {
    const r = radius * view.scale;
    g.moveTo(X(0) + r, Y(0));
    g.arc(X(0), Y(0), r, 0, Math.PI, true);
  }
  for (const zeta of DAMPING) {
    g.moveTo(X(0), Y(0));
    g.lineTo(X(-zeta * far), Y(far * Math.sqrt(1 - zeta * zeta)));
  }
  plane.stroke(theme.grid, 1);
};

/** The damping of each ray, where the ray leaves the window. @type {Layer} */
function dampings(plane) {
  const { left, top, scale, X, Y } = plane.view;
  if (left >= 0) return;
  let last = -Infinity;
  for (const zeta of DAMPING) {
    const up = Math.sqrt(1 - zeta * zeta);
    const radius = Math.min((top - 9 / scale) / up, (16 / scale + left) / -zeta);
    const x = X(-zeta * radius);
    if (Math.abs(x - last) > 32 || radius * up < 0.9 * top)
      plane.text(`ζ ${zeta}`, x, Y(up * radius), plane.theme.muted);
    last = x;
  }
}

/** @type {Layer} */
export function axes(plane) {
  const { g, theme, view } = plane;
  const { x, y, w, h } = view.frame;
  g.beginPath();
  g.moveTo(x, view.Y(0));
  g.lineTo(x + w, view.Y(0));
  plane.stroke(theme.axis, 1);
  g.beginPath();
  g.moveTo(view.X(0), y);
  g.lineTo(view.X(0), y + h);
  plane.stroke(theme.axis, 1.5);
}

const APART = 25; // px between numbers beside the plane, where its two scales differ

/**
 * The plane with its numbers, and marks on it.
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {...Layer} marks
 */
export function sPlane(g, view, theme, ...marks) {
  const step = stepOf(view.right - view.left, view.frame.w, 70);
  return new Plane(g, view, theme)
    .clear()
    .layers(ground, unstableHalf)
    .numbers(step, Math.max(step, stepOf(view.top - view.bottom, view.frame.h, APART)))
    .labels('Re s (1/s)', 'Im s (1/s)')
    .layers(polarGrid(step), dampings, axes, ...marks);
}

/** Numbers along the axes of the small window. @param {number} step @returns {Layer} */
const numbersInside =
  (step) =>
  ({ g, view, theme }) => {
    const { y, h } = view.frame;
    for (const at of multiples(step, view.left, view.right))
      if (at) write(g, tick(at, step), view.X(at), y + h - 8, theme.muted, 'center', theme.plane);
    for (const at of multiples(step, step, view.top))
      write(g, tick(at, step), view.X(0) + 4, view.Y(at), theme.muted, 'left', theme.plane);
  };

/**
 * A small window about the origin over the plane, with a border and its enlargement.
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {number} magnify @param {...Layer} marks
 */
export function originInset(g, view, theme, magnify, ...marks) {
  const step = stepOf(view.right - view.left, view.frame.w, 60);
  /** @type {Layer} */
  const enlargement = (plane) => {
    const { x, y } = view.frame;
    plane.text(`×${magnify.toLocaleString('en')} about the origin`, x + 6, y + 10, theme.ink, 'left');
  };
  return new Plane(g, view, theme)
    .layers(ground, unstableHalf, polarGrid(step), axes, numbersInside(step), enlargement, ...marks)
    .border();
}
