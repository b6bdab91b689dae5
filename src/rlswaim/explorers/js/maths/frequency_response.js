// An open loop over frequency: L(j omega) or, in discrete time, L(exp(j omega T)).
import { gainAtPoint } from './factored_loop.js';
import { frequenciesOf } from './frequency_points.js';

/** @typedef {import('./cut_loop.js').CutLoop} CutLoop */
/** @typedef {import('./polynomials.js').Complex} Complex */
/** @typedef {Pick<CutLoop, 'parts' | 'gain' | 'period'>} Loop */
/** @typedef {{ omega: number, re: number, im: number, dB: number, degrees: number }} Sample */
/**
 * By rising frequency (rad/s); degrees go on without jumps of 360.
 * @typedef {Record<'omega' | 're' | 'im' | 'dB' | 'degrees', Float64Array>} Curve
 */

const DEGREES = 180 / Math.PI;

/**
 * L at one frequency.
 * @param {Loop} loop
 * @param {number} omega rad/s
 * @returns {Complex}
 */
export function responseAt({ parts, gain, period }, omega) {
  const [x, y] = period ? [Math.cos(omega * period), Math.sin(omega * period)] : [0, omega];
  const [re, im] = gainAtPoint(parts, x, y); // the gain that N/D makes -1 of
  const square = re * re + im * im;
  return [(-gain * re) / square, (gain * im) / square];
}

/** @param {Complex} value */
export const decibels = ([re, im]) => 20 * Math.log10(Math.hypot(re, im));

/** The angle nearest to another one. @param {number} degrees @param {number} last */
const near = (degrees, last) => degrees + 360 * Math.round((last - degrees) / 360);

/** The top of a parabola through three points. @param {number[]} x @param {number[]} y */
function vertex([a, b, c], [p, q, r]) {
  const [left, right] = [(b - a) * (q - r), (b - c) * (q - p)];
  return b - ((b - a) * left - (b - c) * right) / (2 * (left - right));
}

/**
 * Where the size is largest between samples, twice as near as before in digits with each turn.
 * @param {Loop} loop
 * @param {ArrayLike<number>} omega
 */
function peaksOf(loop, omega) {
  /** @param {number} w */
  const height = (w) => decibels(responseAt(loop, w));
  const heights = Array.from(omega, height);
  const found = [];
  for (let k = 1; k < omega.length - 1; k++) {
    if (!(heights[k] > heights[k - 1] && heights[k] > heights[k + 1])) continue;
    let at = [omega[k - 1], omega[k], omega[k + 1]];
    for (let turn = 0; turn < 3; turn++) {
      const top = vertex(at, at.map(height));
      if (!(top > at[0] && top < at[2]) || top === at[1]) break;
      found.push(top);
      const width = Math.abs(top - at[1]);
      at = [top - width, top, top + width];
    }
  }
  return found;
}

/**
 * The response at frequencies that show all of it. The phase is between -360 and 0 degrees at the first of the
 * frequencies that have to be among them, or begins between -270 and 90.
 * @param {Loop} loop
 * @param {number[]} also
 * @returns {Curve}
 */
export function frequencyResponse(loop, also = []) {
  const even = frequenciesOf(loop, also);
  const all = Float64Array.from([...even, ...peaksOf(loop, even)]).sort();
  const values = Array.from(all, (w) => ({ w, value: responseAt(loop, w) }));
  const kept = values.filter(({ value: [re, im] }) => Number.isFinite(re + im) && (re !== 0 || im !== 0));
  let last = -90;
  const degrees = kept.map(({ value: [re, im] }) => {
    last = near(Math.atan2(im, re) * DEGREES, last);
    return last;
  });
  const anchor = kept.findIndex(({ w }) => w === also[0]);
  const turn = anchor < 0 ? 0 : 360 * Math.floor(degrees[anchor] / 360 + 1);
  return {
    omega: Float64Array.from(kept, ({ w }) => w),
    re: Float64Array.from(kept, ({ value }) => value[0]),
    im: Float64Array.from(kept, ({ value }) => value[1]),
    dB: Float64Array.from(kept, ({ value }) => decibels(value)),
    degrees: Float64Array.from(degrees, (angle) => angle - turn),
  };
}

/**
 * The curve at any frequency, with the phase in line with its neighbors.
 * @param {Loop} loop
 * @param {Curve} curve
 * @param {number} omega rad/s
 * @returns {Sample}
 */
export function sampleAt(loop, curve, omega) {
  const value = responseAt(loop, omega);
  const [re, im] = value;
  const after = curve.omega.findIndex((w) => w >= omega);
  const beside = curve.degrees[after < 0 ? curve.degrees.length - 1 : after];
  return { omega, re, im, dB: decibels(value), degrees: near(Math.atan2(im, re) * DEGREES, beside) };
}
