// Bode, Nichols and Nyquist diagrams of one loop on one canvas: one of them, or all.
import { bodeViews, drawBode } from './bode_picture.js';
import { drawNichols, nicholsView } from './nichols_picture.js';
import { drawNyquist, nyquistView } from './nyquist_picture.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @import { Frequencies } from './frequency_axes.js' */
/** @typedef {{ kind: string, x: number, y: number, w: number, h: number }} Box of a picture, px */
/**
 * A picture in its box: views in px of the box; the first of Bode's is that of the size.
 * @typedef {Box & { views: View[] }} Placed
 */

const ROOMY = 840; // px from which all three stand side by side
const BOTH = 520; // px from which two do

/**
 * @param {string} kind @param {number} x @param {number} y @param {number} w @param {number} h @returns
 *   {Box}
 */
const box = (kind, x, y, w, h) => ({ kind, x, y, w, h });

/**
 * Where each picture stands on a canvas of some width.
 * @param {string} kind 'bode', 'nichols', 'nyquist' or 'all'
 * @param {number} width
 * @returns {Box[]}
 */
export function boxesOf(kind, width) {
  if (kind !== 'all') return [box(kind, 0, 0, width, Math.round(Math.min(Math.max(0.7 * width, 300), 420)))];
  if (width >= ROOMY) {
    const [wide, w] = [Math.round(0.4 * width), Math.round(0.3 * width)];
    return [
      box('bode', 0, 0, wide, 360),
      box('nichols', wide, 0, w, 360),
      box('nyquist', wide + w, 0, w, 360),
    ];
  }
  const h = width >= BOTH ? Math.round(0.45 * width) : Math.round(0.85 * width);
  const first = box('bode', 0, 0, width, 340);
  if (width < BOTH) return [first, box('nichols', 0, 340, width, h), box('nyquist', 0, 340 + h, width, h)];
  const w = width / 2;
  return [first, box('nichols', 0, 340, w, h), box('nyquist', w, 340, w, h)];
}

/** @param {Box[]} boxes */
export const heightOfBoxes = (boxes) => Math.max(...boxes.map(({ y, h }) => y + h));

/**
 * @param {Box} box @param {Frequencies} frequencies @param {number} reach of the Nyquist diagram
 * @returns {Placed}
 */
export function placed(box, frequencies, reach) {
  const { kind, w, h } = box;
  if (kind === 'nyquist') return { ...box, views: [nyquistView(reach, w, h)] };
  if (kind === 'nichols') return { ...box, views: [nicholsView(frequencies, w, h)] };
  const { size, phase } = bodeViews(frequencies, w, h);
  return { ...box, views: [size, phase] };
}

/** @param {Graphics} g @param {Placed[]} pictures @param {Theme} theme @param {Frequencies} frequencies */
export function drawFrequencies(g, pictures, theme, frequencies) {
  for (const { kind, x, y, w, h, views } of pictures) {
    g.save();
    g.translate(x, y);
    g.clearRect(0, 0, w, h);
    if (kind === 'bode') drawBode(g, { size: views[0], phase: views[1] }, theme, frequencies);
    else if (kind === 'nichols') drawNichols(g, views[0], theme, frequencies);
    else drawNyquist(g, views[0], theme, frequencies);
    g.restore();
  }
}

/**
 * Where a sample stands in a view, in px of its picture.
 * @param {string} kind @param {View} view @param {boolean} isPhase the lower one of Bode's
 * @param {import('../maths/frequency_response.js').Sample} sample
 * @returns {[number, number]}
 */
export function spotOf(kind, view, isPhase, { omega, re, im, dB, degrees }) {
  if (kind === 'nyquist') return [view.X(re), view.Y(im)];
  if (kind === 'nichols') return [view.X(degrees), view.Y(dB)];
  return [view.X(Math.log10(omega)), view.Y(isPhase ? degrees : dB)];
}
