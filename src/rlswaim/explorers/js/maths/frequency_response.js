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

/** @typedef {{ w: number, value: Complex, height: number }} Point */

/** @param {Loop} loop @returns {(w: number) => Point} */
const pointOf = (loop) => (w) => {
  const value = responseAt(loop, w);
  return { w, value, height: decibels(value) };
};

/**
 * Where the size is largest between points, twice as near as before in digits with each turn.
 * @param {Loop} loop
 * @param {Point[]} points
 */
function peaksOf(loop, points) {
  const at = pointOf(loop);
  const found = [];
  for (let k = 1; k < points.length - 1; k++) {
    let three = points.slice(k - 1, k + 2);
    if (!(three[1].height > three[0].height && three[1].height > three[2].height)) continue;
    for (let turn = 0; turn < 3; turn++) {
      const places = three.map(({ w }) => w);
      const top = vertex(
        places,
        three.map(({ height }) => height),
      );
      if (!(top > places[0] && top < places[2]) || top === places[1]) break;
      const width = Math.abs(top - places[1]);
      three = [top - width, top, top + width].map(at);
      found.push(three[1]);
    }
  }
  return found;
}

/**
 * The response at frequencies that show all of it. The phase is between -360 and 0 degrees at the first of
 * the frequencies that have to be among them, or begins between -270 and 90.
 * @param {Loop} loop
 * @param {number[]} also
 * @returns {Curve}
 */
export function frequencyResponse(loop, also = []) {
  const even = Array.from(frequenciesOf(loop, also), pointOf(loop));
  const all = [...even, ...peaksOf(loop, even)].sort((a, b) => a.w - b.w);
  const isNumber = (/** @type {Point} */ { height }) => Number.isFinite(height);
  const kept = all.filter((point, k) => isNumber(point) && point.w !== all[k - 1]?.w);
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
    dB: Float64Array.from(kept, ({ height }) => height),
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
