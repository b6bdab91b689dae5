// Which part of the s plane is seen: fitted to the poles, or where wheel, fingers and keys have put it.
import { BRANCH } from '../maths/compensated.js';
import { ladder } from './ticks.js';
import { frameOf, viewOf } from './view.js';

/** @import { Camera, Frame, Roots, View } from '../types.d.ts' */

const MARGIN = { left: 44, right: 10, top: 8, bottom: 36 };
const WIDTHS = [1e-7, 1e5]; // narrowest and widest window (1/s)
const FARTHEST = 1e6; // of a window's place from the origin (1/s)
const BELOW = 0.07; // of the window's height, below the real axis

/**
 * The window whose lower left corner is at (left, bottom), with one scale in both directions.
 * @param {number} left @param {number} bottom @param {number} scale px per 1/s
 * @param {Frame} frame @param {number} width @param {number} height
 */
function windowAt(left, bottom, scale, frame, width, height) {
  const x = [left, left + frame.w / scale];
  return viewOf(x, [bottom, bottom + frame.h / scale], frame, width, height);
}

/**
 * The window that holds all points. Its borders are round numbers, so they stay while the points move a
 * little.
 * @param {number[][]} points @param {number} width @param {number} height
 */
export function fitted(points, width, height) {
  const frame = frameOf(width, height, MARGIN);
  /** @param {(point: number[]) => number} along */
  const reach = (along) => 1.08 * points.reduce((most, point) => Math.max(most, along(point)), 0);
  const want = [reach(([x]) => -x), reach(([x]) => x), reach(([, y]) => Math.abs(y))];
  const least = 0.4 * Math.max(...want, 1e-6);
  const [l, r, t] = want.map((v) => ladder(Math.max(v, least)));
  const scale = Math.min(frame.w / (l + r), frame.h / ((1 + BELOW) * t));
  const spare = frame.w / scale - l - r;
  return windowAt(-(l + (spare * l) / (l + r)), -BELOW * t, scale, frame, width, height);
}

/** @param {View} view @returns {Camera} */
export const cameraOf = ({ left, right, bottom }) => ({ x: (left + right) / 2, y: bottom, w: right - left });

/** Is this a window that can be reached by zooming and panning? @param {Camera} camera */
export const isWindow = ({ x, y, w }) =>
  Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST && w >= WIDTHS[0] && w <= WIDTHS[1];

/** @param {Camera} camera @param {number} width @param {number} height */
export function windowOf({ x, y, w }, width, height) {
  const frame = frameOf(width, height, MARGIN);
  return windowAt(x - w / 2, y, frame.w / w, frame, width, height);
}

/**
 * What lies below the real axis mirrors the rest: no more than a strip of it is seen.
 * @param {number} left @param {number} bottom @param {number} w @param {number} h
 */
const raised = (left, bottom, w, h) => ({ x: left + w / 2, y: Math.max(bottom, -BELOW * h), w });

/**
 * Closer by a factor; the point at (px, py) stays there.
 * @param {View} view @param {number} factor @param {number} px @param {number} py
 */
export function zoomed(view, factor, px, py) {
  const before = view.right - view.left;
  const w = Math.min(Math.max(before / factor, WIDTHS[0]), WIDTHS[1]);
  const part = w / before;
  const [x, y] = [view.x(px), view.y(py)];
  return raised(x - (x - view.left) * part, y - (y - view.bottom) * part, w, (view.top - view.bottom) * part);
}

/** Moved by (dx, dy) px. @param {View} view @param {number} dx @param {number} dy */
export function panned({ left, right, bottom, top, sx, sy }, dx, dy) {
  return raised(left - dx / sx, bottom + dy / sy, right - left, top - bottom);
}

/**
 * A small window in the upper left corner that shows the neighborhood of the origin `magnify` times enlarged.
 * @param {View} view @param {number} magnify
 */
export function insetOf(view, magnify) {
  const w = Math.round(0.4 * view.frame.w);
  const h = Math.round(0.46 * view.frame.h);
  const frame = { x: view.frame.x + 6, y: view.frame.y + 6, w, h };
  const scale = view.scale * magnify;
  return windowAt(-(0.62 * w) / scale, (-0.1 * h) / scale, scale, frame, view.width, view.height);
}

/**
 * The roots that a first window holds: of a system with a `reach`, those no farther from the origin. A
 * compensator's own are no reason to make all others small.
 * @param {{ reach?: number, [name: string]: any }} system
 * @param {Roots & { branches?: string[] }} roots
 */
export function withinReach({ reach = Infinity }, { x, y, branches = [] }) {
  const sizes = Array.from(x, (re, i) => Math.hypot(re, y[i]));
  const others = sizes.filter((size, i) => branches[i] !== BRANCH && size <= reach);
  const farthest = Math.min(reach, 1.5 * Math.max(...others));
  const isNear = (/** @type {number} */ i) => sizes[i] <= (branches[i] === BRANCH ? farthest : reach);
  return Array.from(x, (re, i) => [re, y[i]]).filter((_, i) => isNear(i));
}
