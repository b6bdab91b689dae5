// The vehicle bent in a closed-loop mode, at one phase of its motion or at several.
import { write } from './context.js';
import { multiples } from './ticks.js';

/** @import { Graphics, Theme } from '../types.d.ts' */
/** @typedef {{ re: Float64Array, im: Float64Array }} Shape of the motion at each foot, down, at most 1 */
/** @typedef {{ station: number, label: string }} StationMark */
/** @typedef {(at: number) => number} Along */

const BORDER = { left: 16, right: 16, top: 14, bottom: 24 };
const BODY = 7; // half the body's width on the picture
export const STILL_PHASES = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => (k * Math.PI) / 8);

/**
 * The body as a band around its bent axis, pointed at the nose.
 * @param {Graphics} g @param {Along} X @param {Along} Y @param {number} last
 */
function body(g, X, Y, last) {
  /** @param {number} k */
  const half = (k) => BODY * Math.min(1, 0.15 + k / 45);
  g.beginPath();
  g.moveTo(X(0), Y(0));
  for (let k = 5; k <= last; k += 5) g.lineTo(X(k), Y(k) - half(k));
  for (let k = last; k >= 5; k -= 5) g.lineTo(X(k), Y(k) + half(k));
  g.closePath();
}

/**
 * @param {Graphics} g @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1
 * @param {string} color
 */
function straight(g, x0, y0, x1, y1, color) {
  g.beginPath();
  g.moveTo(x0, y0);
  g.lineTo(x1, y1);
  g.strokeStyle = color;
  g.lineWidth = 1;
  g.stroke();
}

/**
 * The undisturbed axis, feet below it, and the marked stations.
 * @param {Graphics} g @param {Theme} theme @param {number} width @param {number} height
 * @param {Along} X @param {number} middle @param {number} last @param {StationMark[]} marks
 */
function scenery(g, theme, width, height, X, middle, last, marks) {
  g.setLineDash([4, 4]);
  straight(g, X(0), middle, X(last), middle, theme.axis);
  g.setLineDash([]);
  for (const l of multiples(width < 480 ? 100 : 50, 0, last)) {
    const nose = l === 0;
    write(g, nose ? '0 ft (nose)' : `${l}`, X(l), height - 8, theme.muted, nose ? 'left' : 'center');
  }
  for (const { station, label } of marks) {
    straight(g, X(station), middle - 24, X(station), middle + 24, theme.muted);
    write(g, label, X(station), BORDER.top - 5, theme.muted);
  }
}

/**
 * @param {Graphics} g @param {number} width @param {number} height @param {Theme} theme @param {string} color
 * @param {Shape} shape @param {number[]} phases one while it moves, several where it stands still
 * @param {StationMark[]} marks
 */
export function drawBent(g, width, height, theme, color, shape, phases, marks) {
  const last = shape.re.length - 1;
  /** @type {Along} */
  const X = (l) => BORDER.left + ((width - BORDER.left - BORDER.right) * l) / last;
  const middle = BORDER.top + (height - BORDER.top - BORDER.bottom) / 2;
  const reach = (height - BORDER.top - BORDER.bottom) / 2 - BODY - 4;
  g.clearRect(0, 0, width, height);
  g.lineJoin = 'round';
  scenery(g, theme, width, height, X, middle, last, marks);
  for (const side of [reach, -reach]) {
    g.beginPath();
    for (let k = 0; k <= last; k += 5) g.lineTo(X(k), middle + side * Math.hypot(shape.re[k], shape.im[k]));
    g.strokeStyle = theme.grid;
    g.lineWidth = 1.5;
    g.stroke();
  }
  phases.forEach((phase, i) => {
    const [cos, sin] = [Math.cos(phase), Math.sin(phase)];
    g.globalAlpha = phases.length > 1 ? 1 - (0.85 * i) / phases.length : 1;
    body(g, X, (k) => middle + reach * (shape.re[k] * cos - shape.im[k] * sin), last);
    g.fillStyle = theme.plane;
    if (i === 0) g.fill();
    g.strokeStyle = color;
    g.lineWidth = i === 0 ? 2 : 1;
    g.stroke();
  });
  g.globalAlpha = 1;
}
