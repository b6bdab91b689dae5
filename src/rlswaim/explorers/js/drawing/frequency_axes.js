// What the pictures of a frequency response share: an axis of frequencies in decades, the curve in the colors
// of its modes, marks on it.
import { write } from './context.js';
import { Plane } from './plane.js';

/** @import { Layer } from './plane.js' */
/** @import { Curve, Sample } from '../maths/frequency_response.js' */
/** @import { Mode } from '../maths/loop_modes.js' */
/**
 * Where a point of the curve stands in a picture.
 * @typedef {(sample: Sample) => [number, number]} Place
 */
/** @typedef {{ kind: string, short: string, at: Sample, governs: boolean }} MarginMark */
/**
 * What all pictures draw: modeOf has the mode of each point of the curve, lobes those with their tops,
 * asked the margins that are required (dB, degrees; 0 for none).
 * @typedef {{ curve: Curve, modeOf: (Mode | undefined)[], lobes: { mode: Mode, at: Sample }[],
 *   margins: MarginMark[], marked: Sample | null, asked: { gain: number, phase: number } }} Frequencies
 */

/** @param {Curve} curve @param {number} k @returns {Sample} */
export const sampleOf = ({ omega, re, im, dB, degrees }, k) => ({
  omega: omega[k],
  re: re[k],
  im: im[k],
  dB: dB[k],
  degrees: degrees[k],
});

/** Decades and their lines at 2 to 9. @param {number} first @param {number} last log10 of the ends */
function lines(first, last) {
  const from = Math.floor(first);
  const decades = Array.from({ length: Math.ceil(last) - from + 1 }, (_, k) => from + k);
  const all = decades.flatMap((d) => [1, 2, 3, 4, 5, 6, 7, 8, 9].map((digit) => d + Math.log10(digit)));
  return { decades, all: all.filter((at) => at > first && at < last) };
}

/** Lines at round frequencies over a plane whose x is log10 of them. @type {Layer} */
export function decadeGrid(plane) {
  const { g, view, theme } = plane;
  const { y, h } = view.frame;
  const { decades, all } = lines(view.left, view.right);
  const few = decades.length > 5 ? decades : all;
  g.beginPath();
  for (const at of few) {
    g.moveTo(view.X(at), y);
    g.lineTo(view.X(at), y + h);
  }
  plane.stroke(theme.grid, 1);
}

const RAISED = '⁻⁰¹²³⁴⁵⁶⁷⁸⁹';
/** @param {number} power */
const powerOfTen = (power) =>
  power >= -2 && power <= 3
    ? String(Number(`1e${power}`))
    : `10${[...String(power)].map((d) => RAISED['-0123456789'.indexOf(d)]).join('')}`;

/** @param {Plane} plane */
export function decadeNumbers({ g, view, theme }) {
  const { y, h } = view.frame;
  for (const at of lines(view.left, view.right).decades)
    if (at >= view.left - 1e-9 && at <= view.right + 1e-9)
      write(g, powerOfTen(at), view.X(at), y + h + 10, theme.muted);
}

/**
 * The curve, each mode's stretch in its color.
 * @param {Frequencies} frequencies @param {Place} place
 * @returns {Layer}
 */
export const coloredCurve =
  ({ curve, modeOf }, place) =>
  (plane) => {
    const { g, view, theme } = plane;
    const count = curve.omega.length;
    for (let from = 0; from < count - 1; ) {
      const name = modeOf[from]?.name;
      g.beginPath();
      let to = from;
      do {
        const [x, y] = place(sampleOf(curve, to));
        g.lineTo(view.X(x), view.Y(y));
        to++;
      } while (to < count && (modeOf[to - 1]?.name === name || to - 1 === from));
      plane.stroke((name && theme.color(name)) || theme.ink, 2);
      from = to - 1;
    }
  };

/**
 * The names of lobes at their tops.
 * @param {Frequencies} frequencies @param {Place} place @returns {Layer}
 */
export const lobeNames =
  ({ lobes }, place, onlyInside = false) =>
  (plane) => {
    const { view, theme } = plane;
    const { frame } = view;
    for (const { mode, at } of lobes) {
      const [x, y] = place(at);
      if (onlyInside && !view.holds(view.X(x), view.Y(y))) continue;
      const px = Math.min(Math.max(view.X(x), frame.x + 26), frame.x + frame.w - 26);
      const py = Math.min(Math.max(view.Y(y) - 9, frame.y + 8), frame.y + frame.h - 8);
      plane.text(mode.name, px, py, theme.color(mode.name) ?? theme.ink);
    }
  };

/** @param {Plane} plane @param {number[]} from @param {number[]} to @param {number} width */
export function straight(plane, from, to, color = plane.theme.ink, width = 1.4) {
  const { g, view } = plane;
  g.beginPath();
  g.moveTo(view.X(from[0]), view.Y(from[1]));
  g.lineTo(view.X(to[0]), view.Y(to[1]));
  plane.stroke(color, width);
}

/** The frequency under the pointer. @param {Sample | null} marked @param {Place} place @returns {Layer} */
export const markedPoint = (marked, place) => (plane) => {
  if (!marked) return;
  const { g, view, theme } = plane;
  const [x, y] = place(marked);
  g.beginPath();
  g.arc(view.X(x), view.Y(y), 4.5, 0, 2 * Math.PI);
  g.fillStyle = theme.plane;
  g.fill();
  plane.stroke(theme.ink, 1.6);
};
