// The Bode diagram: size in dB and phase in degrees over frequency, with the margins.

import { write } from './context.js';
import {
  coloredCurve,
  decadeGrid,
  decadeNumbers,
  lobeNames,
  markedPoint,
  straight,
} from './frequency_axes.js';
import { line } from './marks.js';
import { ground, Plane } from './plane.js';
import { multiples, stepOf, tick } from './ticks.js';
import { viewOf } from './view.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Sample } from '../maths/frequency_response.js' */
/** @import { Frequencies, Place } from './frequency_axes.js' */
/** @import { Layer } from './plane.js' */

const MARGIN = { left: 50, right: 10, top: 8, bottom: 34, between: 10 };
const DEEPEST = -120; // dB below the largest value

/** @type {Place} */
const atSize = ({ omega, dB }) => [Math.log10(omega), dB];
/** @type {Place} */
const atPhase = ({ omega, degrees }) => [Math.log10(omega), degrees];

/** Round borders about values. @param {number} low @param {number} high @param {number} step */
const round = (low, high, step) => [
  step * Math.floor(low / step + 1e-9),
  step * Math.ceil(high / step - 1e-9),
];

/** The least and the largest of many. @param {ArrayLike<number>} values */
export const extent = (values) => [Math.min(...Array.from(values)), Math.max(...Array.from(values))];

/**
 * The two planes, one above the other.
 * @param {Frequencies} frequencies @param {number} width @param {number} height
 * @returns {{ size: View, phase: View }}
 */
export function bodeViews({ curve }, width, height) {
  const { left, right, top, bottom, between } = MARGIN;
  const w = Math.max(width - left - right, 1);
  const h = Math.max(height - top - bottom - between, 2);
  const upper = Math.round(0.58 * h);
  const ends = [curve.omega[0], curve.omega.at(-1)].map(Math.log10);
  const [low, high] = extent(curve.dB);
  const sizes = round(Math.max(Math.min(low, -10), high + DEEPEST), Math.max(high, 10), 20);
  const phases = extent(curve.degrees);
  const angles = round(Math.min(phases[0], -190), Math.max(phases[1], -170), 90);
  const above = { x: left, y: top, w, h: upper };
  const below = { x: left, y: top + upper + between, w, h: h - upper };
  return {
    size: viewOf(ends, sizes, above, width, height),
    phase: viewOf(ends, angles, below, width, height),
  };
}

/** @param {number} level @returns {Layer} */
const levelLine =
  (level, color = '', width = 1.2) =>
  (plane) => {
    const { view, theme } = plane;
    straight(plane, [view.left, level], [view.right, level], color || theme.axis, width);
  };

/**
 * A margin as a line from the curve to 0 dB or to -180 degrees.
 * @param {Frequencies} f @param {string} kind
 */
const marginLines =
  ({ margins }, kind) =>
  /** @param {Plane} plane */
  (plane) => {
    const place = kind === 'gain' ? atSize : atPhase;
    for (const { at, short, governs, kind: its } of margins) {
      if (its !== kind) continue;
      const [x, y] = place(at);
      const end = kind === 'gain' ? 0 : -180 + 360 * Math.round((y + 180) / 360);
      straight(plane, [x, y], [x, end], plane.theme.ink, governs ? 2.6 : 1.2);
      const right = plane.view.X(x) > plane.view.frame.x + 0.75 * plane.view.frame.w;
      const { frame } = plane.view;
      const py = Math.min(Math.max(plane.view.Y((y + end) / 2), frame.y + 8), frame.y + frame.h - 8);
      if (governs)
        plane.text(short, plane.view.X(x) + (right ? -5 : 5), py, undefined, right ? 'right' : 'left');
    }
  };

/** @param {Sample | null} marked @returns {Layer} */
const markedFrequency = (marked) => (plane) => {
  if (!marked) return;
  const at = Math.log10(marked.omega);
  line(
    [
      [at, plane.view.bottom],
      [at, plane.view.top],
    ],
    plane.theme.muted,
    1,
    [3, 3],
  )(plane);
};

/**
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {number} apart px between numbers
 * @param {number[]} steps to choose from @param {Layer[]} layers
 */
function strip(g, view, theme, apart, steps, ...layers) {
  const range = view.top - view.bottom;
  const least = range / Math.max(2, view.frame.h / apart);
  const step = steps.find((s) => s >= least) ?? stepOf(range, view.frame.h, apart);
  const levels = multiples(step, view.bottom, view.top);
  const rows = levels.map((at) => levelLine(at, theme.grid, 1));
  for (const at of levels) write(g, tick(at, step), view.frame.x - 5, view.Y(at), theme.muted, 'right');
  return new Plane(g, view, theme)
    .layers(ground, ...rows, decadeGrid)
    .border()
    .layers(...layers);
}

/**
 * @param {Graphics} g @param {{ size: View, phase: View }} views @param {Theme} theme
 * @param {Frequencies} frequencies
 */
export function drawBode(g, { size, phase }, theme, frequencies) {
  const { marked } = frequencies;
  strip(
    g,
    size,
    theme,
    30,
    [10, 20, 40, 60],
    levelLine(0),
    markedFrequency(marked),
    coloredCurve(frequencies, atSize),
    marginLines(frequencies, 'gain'),
    lobeNames(frequencies, atSize),
    markedPoint(marked, atSize),
  );
  const lower = strip(
    g,
    phase,
    theme,
    26,
    [30, 45, 90, 180, 360, 720],
    levelLine(-180),
    markedFrequency(marked),
    coloredCurve(frequencies, atPhase),
    marginLines(frequencies, 'phase'),
    markedPoint(marked, atPhase),
  );
  decadeNumbers(lower);
  const { frame } = phase;
  write(g, 'ω (rad/s)', frame.x + frame.w / 2, phase.height - 8, theme.ink);
  beside(g, '|L| (dB)', size, theme);
  beside(g, 'phase (°)', phase, theme);
}

/**
 * What an axis is, along it.
 * @param {Graphics} g @param {string} words @param {View} view @param {Theme} theme
 */
function beside(g, words, { frame }, theme) {
  g.save();
  g.translate(7, frame.y + frame.h / 2);
  g.rotate(-Math.PI / 2);
  write(g, words, 0, 0, theme.ink);
  g.restore();
}
