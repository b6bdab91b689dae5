// The Nyquist diagram: L in its plane, with the unit circle and the point -1.
import { coloredCurve, lobeNames, markedPoint, straight } from './frequency_axes.js';
import { line, plus, ring } from './marks.js';
import { grid, ground, Plane } from './plane.js';
import { stepOf } from './ticks.js';
import { frameOf, viewOf } from './view.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Frequencies, Place } from './frequency_axes.js' */
/** @import { Layer } from './plane.js' */

const MARGIN = { left: 50, right: 10, top: 8, bottom: 34 };

/** @type {Place} */
const place = ({ re, im }) => [re, im];

/**
 * A window about the origin with one scale in both directions.
 * @param {number} reach at least so far each way @param {number} width @param {number} height
 */
export function nyquistView(reach, width, height) {
  const frame = frameOf(width, height, MARGIN);
  const scale = Math.min(frame.w, frame.h) / (2 * reach);
  const [x, y] = [frame.w / scale / 2, frame.h / scale / 2];
  return viewOf([-x, x], [-y, y], frame, width, height);
}

/** @type {Layer} */
function scenery(plane) {
  const { view, theme } = plane;
  straight(plane, [view.left, 0], [view.right, 0], theme.axis, 1);
  straight(plane, [0, view.bottom], [0, view.top], theme.axis, 1);
  ring(0, 0, view.scale, 1.2, { color: theme.axis })(plane);
}

/** Negative frequencies mirror the positive ones. @param {Frequencies} frequencies @returns {Layer} */
const mirrored =
  ({ curve }) =>
  (plane) =>
    line(
      Array.from(curve.re, (re, k) => [re, -curve.im[k]]),
      plane.theme.muted,
      1,
      [4, 4],
    )(plane);

/** @param {Frequencies} frequencies @returns {Layer} */
const marginLines =
  ({ margins }) =>
  (plane) => {
    const { view } = plane;
    for (const { kind, at, short, governs } of margins) {
      const from = kind === 'gain' ? [-1, 0] : [0, 0];
      straight(plane, from, [at.re, at.im], plane.theme.ink, governs ? 2.6 : 1.2);
      if (governs) plane.text(short, view.X(at.re), view.Y(at.im) + (at.im > 0 ? -10 : 11));
    }
  };

/**
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {Frequencies} frequencies
 */
export function drawNyquist(g, view, theme, frequencies) {
  const step = stepOf(view.right - view.left, view.frame.w, 60);
  new Plane(g, view, theme)
    .layers(ground, grid(step, step))
    .border()
    .numbers(step, step)
    .labels('Re L', 'Im L')
    .layers(
      scenery,
      mirrored(frequencies),
      coloredCurve(frequencies, place),
      marginLines(frequencies),
      plus(-1, 0, 6),
      lobeNames(frequencies, place, true),
      markedPoint(frequencies.marked, place),
    );
}
