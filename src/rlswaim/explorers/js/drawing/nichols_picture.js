// The Nichols diagram: size in dB over phase, with lines of constant size of the closed loop.
import { extent } from './bode_picture.js';
import { polygon } from './context.js';
import { coloredCurve, lobeNames, markedPoint, straight } from './frequency_axes.js';
import { plus } from './marks.js';
import { grid, ground, Plane } from './plane.js';
import { hatch } from './required_region.js';
import { frameOf, viewOf } from './view.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Frequencies, Place } from './frequency_axes.js' */
/** @import { Layer } from './plane.js' */

const MARGIN = { left: 50, right: 10, top: 8, bottom: 34 };
const CLOSED = [-20, -12, -6, -3, -1, 0, 1, 3, 6, 12]; // dB of L/(1 + L)
const POINTS = 120;
const NEAREST = 1e-4; // to the angle 0, where the line of 0 dB has no end
const SIZES = [-40, 60]; // dB that are shown at most

/** @type {Place} */
const place = ({ degrees, dB }) => [degrees, dB];

/**
 * A line of constant size of the closed loop: L = T/(1 - T), its phase between -360 and 0 degrees.
 * @param {number} dB
 */
function closedLine(dB) {
  const size = 10 ** (dB / 20);
  return Array.from({ length: POINTS + 1 }, (_, k) => {
    const angle = Math.min(Math.max((2 * Math.PI * k) / POINTS, NEAREST), 2 * Math.PI - NEAREST);
    const [x, y] = [size * Math.cos(angle), size * Math.sin(angle)];
    const square = (1 - x) ** 2 + y * y;
    const [re, im] = [(x * (1 - x) - y * y) / square, y / square];
    return [(Math.atan2(im, re) * 180) / Math.PI - (im > 0 ? 360 : 0), 20 * Math.log10(Math.hypot(re, im))];
  });
}

const LINES = CLOSED.map((dB) => ({ dB, points: closedLine(dB) }));

/** @param {Frequencies} frequencies @param {number} width @param {number} height */
export function nicholsView({ curve }, width, height) {
  const [low, high] = extent(curve.dB);
  const isSeen = (/** @type {number} */ _, /** @type {number} */ k) =>
    curve.dB[k] >= SIZES[0] && curve.dB[k] <= SIZES[1];
  const [first, last] = extent(curve.degrees.filter(isSeen));
  const angles = [90 * Math.floor(Math.min(first, -230) / 90), 90 * Math.ceil(Math.max(last, -130) / 90)];
  const bottom = 20 * Math.floor(Math.max(Math.min(low, -20), SIZES[0]) / 20);
  const top = 20 * Math.ceil(Math.min(Math.max(high, 20), SIZES[1]) / 20);
  return viewOf(angles, [bottom, top], frameOf(width, height, MARGIN), width, height);
}

/** The lines in each turn of the phase that is seen. @type {Layer} */
function closedGrid(plane) {
  const { g, view, theme } = plane;
  const [from, to] = [Math.floor(view.left / 360), Math.ceil(view.right / 360)];
  for (let turn = from; turn <= to; turn++) {
    g.beginPath();
    for (const { points } of LINES) {
      let before = NaN;
      for (const [degrees, dB] of points) {
        const jumps = !(Math.abs(degrees - before) < 180);
        const [x, y] = [view.X(degrees + 360 * (turn + 1)), view.Y(dB)];
        if (jumps) g.moveTo(x, y);
        else g.lineTo(x, y);
        before = degrees;
      }
    }
    plane.stroke(theme.axis, 0.7);
  }
}

/** The closed loop's size at each line, beside the critical point. @type {Layer} */
function closedNumbers(plane) {
  const { view, theme } = plane;
  let last = Infinity;
  for (const { dB, points } of LINES) {
    const [, level] = points[POINTS / 2];
    if (last - view.Y(level) < 11) continue;
    last = view.Y(level);
    plane.text(`${dB > 0 ? '+' : ''}${dB}`.replace('-', '−'), view.X(-180), last, theme.muted);
  }
}

/** About each critical point: the required margins as half diagonals, which the curve has to stay out of.
 * @param {Frequencies['asked']} asked
 * @returns {(x: number) => Layer}
 */
const requiredMargins =
  ({ gain, phase }) =>
  (x) =>
  (plane) => {
    if (!(gain > 0 || phase > 0)) return;
    const { X, Y } = plane.view;
    const corners = [X(x - phase), Y(0), X(x), Y(gain), X(x + phase), Y(0), X(x), Y(-gain)];
    hatch(plane, corners);
    plane.g.beginPath();
    polygon(plane.g, corners);
    plane.stroke(plane.theme.ink, 1.2);
  };

/** @param {Frequencies} frequencies @returns {Layer} */
const marginLines =
  ({ margins }) =>
  (plane) => {
    for (const { kind, at, short, governs } of margins) {
      const turn = 360 * Math.round((at.degrees + 180) / 360);
      straight(plane, place(at), [-180 + turn, 0], plane.theme.ink, governs ? 2.6 : 1.2);
      if (!governs) continue;
      const [px, py] = [plane.view.X((at.degrees - 180 + turn) / 2), plane.view.Y(at.dB / 2)];
      if (kind === 'gain') plane.text(short, px + 6, py, undefined, 'left');
      else plane.text(short, px, py - 9);
    }
  };

/**
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {Frequencies} frequencies
 */
export function drawNichols(g, view, theme, frequencies) {
  const range = (view.right - view.left) / Math.max(1, view.frame.w / 44);
  const step = [30, 45, 90, 180, 360].find((size) => size >= range) ?? 720;
  const [from, to] = [Math.floor(view.left / 360), Math.ceil(view.right / 360)];
  const critical = Array.from({ length: to - from + 1 }, (_, k) => -180 + 360 * (from + k));
  new Plane(g, view, theme)
    .layers(ground, grid(step, 20), closedGrid, closedNumbers)
    .border()
    .numbers(step, 20)
    .labels('phase of L (°)', '|L| (dB)')
    .layers(
      ...critical.map(requiredMargins(frequencies.asked)),
      ...critical.map((x) => plus(x, 0, 6)),
      coloredCurve(frequencies, place),
      marginLines(frequencies),
      lobeNames(frequencies, place),
      markedPoint(frequencies.marked, place),
    );
}
