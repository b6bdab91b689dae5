// What of a frequency response lies under the pointer: a frequency, or the curve to take hold of.
import { sampleOf } from './frequency_axes.js';
import { spotOf } from './frequency_pictures.js';

/** @import { View } from '../types.d.ts' */
/** @import { Frequencies } from './frequency_axes.js' */
/** @import { Placed } from './frequency_pictures.js' */
/**
 * @typedef {{ picture: Placed, view: View, isPhase: boolean, qx: number, qy: number }} Under px of a
 *   picture
 */
/**
 * A point of the curve that is held: by which factor the gain changes as the pointer goes elsewhere.
 * @typedef {{ omega: number, factor: (px: number, py: number) => number }} Held
 */

/**
 * The view under the pointer.
 * @param {Placed[]} pictures @param {number} px @param {number} py
 * @returns {Under | undefined}
 */
function under(pictures, px, py) {
  for (const picture of pictures) {
    const [qx, qy] = [px - picture.x, py - picture.y];
    const at = picture.views.findIndex((view) => view.holds(qx, qy));
    if (at >= 0) return { picture, view: picture.views[at], isPhase: at > 0, qx, qy };
  }
  return undefined;
}

/**
 * The point of the curve nearest to the pointer, along the chords between samples.
 * @param {Under} under @param {Frequencies} frequencies
 */
function nearest({ picture, view, isPhase, qx, qy }, { curve }) {
  let [omega, off] = [NaN, Infinity];
  let [ax, ay] = spotOf(picture.kind, view, isPhase, sampleOf(curve, 0));
  for (let k = 1; k < curve.omega.length; k++) {
    const [bx, by] = spotOf(picture.kind, view, isPhase, sampleOf(curve, k));
    const [dx, dy] = [bx - ax, by - ay];
    const square = dx * dx + dy * dy;
    const part = square ? Math.max(0, Math.min(1, ((qx - ax) * dx + (qy - ay) * dy) / square)) : 0;
    const far = Math.hypot(ax + part * dx - qx, ay + part * dy - qy);
    if (far < off) {
      off = far;
      omega = curve.omega[k - 1] * (curve.omega[k] / curve.omega[k - 1]) ** part;
    }
    [ax, ay] = [bx, by];
  }
  return { omega, off };
}

const REACH = 30; // px within which the curve is read in a picture without an axis of frequencies

/**
 * The frequency (rad/s) under the pointer: along the axis where there is one, else the curve's; NaN for none.
 * @param {Placed[]} pictures @param {Frequencies | null} frequencies @param {number} px @param {number} py
 */
export function frequencyAt(pictures, frequencies, px, py) {
  const found = frequencies && under(pictures, px, py);
  if (!found) return NaN;
  if (found.picture.kind === 'bode') return 10 ** found.view.x(found.qx);
  const { omega, off } = nearest(found, frequencies);
  return off < REACH ? omega : NaN;
}

/**
 * The point of the curve within reach; the phase alone is no hold, as the gain does not move it.
 * @param {Placed[]} pictures @param {Frequencies} frequencies
 * @param {number} px @param {number} py @param {number} reach
 * @returns {Held | null}
 */
export function curveAt(pictures, frequencies, px, py, reach) {
  const found = under(pictures, px, py);
  if (!found || found.isPhase) return null;
  const { omega, off } = nearest(found, frequencies);
  if (!(off < reach)) return null;
  const { picture, view, qx, qy } = found;
  if (picture.kind === 'nyquist') {
    const size = Math.hypot(view.x(qx), view.y(qy));
    const factor = (/** @type {number} */ x, /** @type {number} */ y) =>
      Math.hypot(view.x(x - picture.x), view.y(y - picture.y)) / size;
    return { omega, factor };
  }
  return { omega, factor: (_, y) => 10 ** ((view.y(y - picture.y) - view.y(qy)) / 20) };
}
