// What the workbench draws of a loop that a reader gave: the same record that Python sends of a control
// system.

import { number } from '../drawing/numbers.js';
import { breakAways } from '../maths/break_aways.js';
import { BRANCH } from '../maths/compensated.js';
import { compensatedLoop } from '../maths/compensated_loop.js';
import { isProper } from '../maths/compensator.js';
import { crossings, IMAGINARY_AXIS, UNIT_CIRCLE } from '../maths/crossings.js';
import { factored } from '../maths/factored_loop.js';
import { givenRoots } from '../reading/given_loop.js';
import { readLoop } from '../reading/loop_text.js';

/** @import { Payload, System } from '../types.d.ts' */
/** @typedef {import('../reading/given_loop.js').GivenRoots} GivenRoots */

const AROUND = [1e-3, 1e2]; // of the least and the largest gain of note, where a locus begins and ends
const MOST = 1e30;
const SPAN = 6; // times of the slowest or the fastest motion that a response shows
const DIGITS = [1, 2, 5];

/**
 * As the library names the branch that leaves a pole.
 * @param {number} x @param {number} y @param {boolean} discrete
 */
function nameOf(x, y, discrete) {
  const re = number(x, 3);
  if (discrete) return `pole at z = ${re}${y ? ` ± j${number(Math.abs(y), 3)}` : ''}`;
  if (x === 0 && y === 0) return 'pole at the origin';
  return y ? `mode at ${number(Math.hypot(x, y), 3)} rad/s` : `pole at ${re} 1/s`;
}

/** From a gain far below all of note to one far above. @param {GivenRoots} loop */
function magnitudesOf(loop) {
  const parts = factored(loop.exact ? loop : { D: loop.D, N: loop.N });
  const border = loop.dt ? UNIT_CIRCLE : IMAGINARY_AXIS;
  const gains = [...breakAways(parts), ...crossings(parts, border)].map(({ gain }) => Math.abs(gain));
  const known = gains.filter((gain) => gain > 1 / MOST && gain < MOST);
  const least = Math.min(1, ...known);
  const most = Math.max(1, typical(loop), ...known);
  return [Math.max(least * AROUND[0], 1 / MOST), Math.min(most * AROUND[1], MOST)];
}

/** Where roots have gone about as far as the poles are from the origin. @param {GivenRoots} loop */
function typical({ poles, zeros, gain }) {
  const size = Math.max(...poles.x.map((x, i) => Math.hypot(x, poles.y[i]))) || 1;
  return Math.min(size ** (poles.x.length - zeros.x.length) / Math.abs(gain), MOST);
}

/** Times of 1, 2 and 5 over all decades that a loop may need (s). */
export const DURATIONS_OF_ANY = Array.from({ length: 16 }, (_, k) => k - 8).flatMap((power) =>
  DIGITS.map((digit) => Number(`${digit}e${power}`)),
);

/** A length of the response that suits a loop (s). @param {GivenRoots} loop */
export function durationOf({ poles, dt }) {
  const sizes = poles.x.map((x, i) => Math.hypot(x, poles.y[i])).filter((size) => size > 0);
  const middle = sizes.length ? Math.exp(sizes.reduce((sum, v) => sum + Math.log(v), 0) / sizes.length) : 1;
  const wanted = dt ? 50 * (dt === true ? 1 : dt) : (2 * SPAN) / middle;
  return DURATIONS_OF_ANY.find((duration) => duration >= wanted) ?? DURATIONS_OF_ANY.at(-1);
}

/**
 * @param {Payload} payload
 * @param {string} text
 * @returns {System}
 */
export function systemOf(payload, text) {
  const given = readLoop(text);
  const known = payload.known?.[text];
  /** @type {GivenRoots} */
  const loop = known
    ? { ...known, D: Float64Array.from(known.D), N: Float64Array.from(known.N) }
    : givenRoots(given);
  const { poles } = loop;
  const names = poles.x.map((x, i) => nameOf(x, poles.y[i], Boolean(loop.dt)));
  const colors = /** @type {string[]} */ (payload.colors);
  return /** @type {any} */ ({
    ...payload,
    given,
    ...closedOf(loop, (i) => names[i]),
    branches: Object.fromEntries([...new Set(names)].map((name, i) => [name, colors[i % colors.length]])),
    durations: DURATIONS_OF_ANY,
  });
}

/** 1 + k N/D as a workbench takes it. @param {GivenRoots} loop @param {(pole: number) => string} nameAt */
const closedOf = (loop, nameAt) => ({
  loop,
  terms: [
    { factors: [], coefficients: loop.D },
    { factors: ['k'], coefficients: loop.N },
  ],
  poles: loop.poles.x.map((re, i) => ({ re, im: loop.poles.y[i], branch: nameAt(i) })),
  running: { k: { magnitudes: magnitudesOf(loop), signed: true } },
});

/**
 * The system with a compensator in series with its loop; itself without one, or with one that cannot be
 * built.
 * @param {System} system
 * @param {import('../maths/compensator.js').Compensator | null} compensator
 * @returns {System}
 */
export function inSeries(system, compensator) {
  if (!compensator || !isProper(compensator)) return system;
  const loop = compensatedLoop(system.loop, compensator);
  return { ...system, ...closedOf(loop, (i) => system.poles[i]?.branch ?? BRANCH) };
}
