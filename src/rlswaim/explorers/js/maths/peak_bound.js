// The least peak of the sensitivity that any controller can reach, from poles and zeros right of the axis.
import { roots } from './aberth.js';
import { combine, trimmed } from './polynomials.js';
import { along } from './terms.js';

/** @import { Values } from '../types.d.ts' */
/**
 * What Python sends: of each case the numerators of theta, q1, q2 ... over delta and the poles right of the
 * axis, one or two real ones; of each mode its slope at every foot.
 * @typedef {{ cases: Record<string, { numerators: number[][], poles: number[] }>, slopes: number[][],
 *   axis: number, far: number }} Payload
 */
/** @typedef {{ x: number[], y: number[] }} Right zeros right of the axis */
/** @typedef {{ poles: number[], zeros: Right, peak: number, interlaced: boolean }} Bound */

/** @param {Payload} payload @param {Values} values @returns {Right} */
function zerosOf({ cases, slopes, axis, far }, { gravity, gyro_a, gyro_b, share }) {
  const [theta, ...modes] = cases[gravity].numerators;
  const numerator = modes.reduce((sum, mode, i) => {
    const slope = (1 - share) * along(slopes[i], gyro_a) + share * along(slopes[i], gyro_b);
    return combine(sum, mode, -slope);
  }, Float64Array.from(theta));
  const { x, y } = roots(trimmed(numerator));
  const right = x.map((_, i) => i).filter((i) => x[i] > axis && Math.hypot(x[i], y[i]) < far);
  return { x: right.map((i) => x[i]), y: right.map((i) => y[i]) };
}

/** Blaschke's product of the zeros at a real pole, with its sign. @param {Right} zeros @param {number} p */
function blaschke({ x, y }, p) {
  let [size, sign] = [1, 1];
  x.forEach((re, i) => {
    size *= Math.hypot(p + re, y[i]) / Math.hypot(p - re, y[i]);
    if (y[i] === 0 && p < re) sign = -sign;
  });
  return sign * size;
}

/**
 * The least peak of T with T(p) = 1 at each pole and 0 at each zero [Nevanlinna, Pick]: the square root of
 * the largest v for which det(v - w_i w_j)/(p_i + p_j) is 0, w_i being Blaschke's product at p_i.
 * @param {Right} zeros @param {number[]} poles
 */
function peakOf(zeros, poles) {
  const [a, b] = poles.map((p) => blaschke(zeros, p));
  if (poles.length < 2) return Math.abs(a);
  const [p, q] = poles;
  const [own, cross] = [1 / (4 * p * q), 1 / (p + q) ** 2];
  const [second, first] = [own - cross, 2 * a * b * cross - (a * a + b * b) * own];
  const last = a * a * b * b * (own - cross);
  return Math.sqrt((-first + Math.sqrt(Math.max(first * first - 4 * second * last, 0))) / (2 * second));
}

/**
 * Is the number of poles right of each real zero even: can a stable controller do it?
 * @param {Right} zeros @param {number[]} poles
 */
function isInterlaced({ x, y }, poles) {
  const real = x.filter((_, i) => y[i] === 0);
  return real.every((z) => poles.filter((p) => p > z).length % 2 === 0);
}

/** @param {Payload} payload @param {Values} values @returns {Bound} */
export function bound(payload, values) {
  const { poles } = payload.cases[values.gravity];
  const zeros = zerosOf(payload, values);
  return { poles, zeros, peak: peakOf(zeros, poles), interlaced: isInterlaced(zeros, poles) };
}

/**
 * The least peak if the loop can act below a bandwidth alone: Bode's integral made up there.
 * @param {number[]} poles @param {number} bandwidth rad/s
 */
export const overBand = (poles, bandwidth) =>
  Math.exp((Math.PI * poles.reduce((sum, p) => sum + p, 0)) / bandwidth);
