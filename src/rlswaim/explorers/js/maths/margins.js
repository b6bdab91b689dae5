// Gain and phase margins of the loop that a locus draws.
import { roots } from './aberth.js';
import { marginsByOmega, phaseMargin } from './one_margin.js';
import { lastLoop, loopOf } from './open_loop.js';
import { ownMargins } from './own_margins.js';
import { combine, evaluate, multiply } from './polynomials.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').What} What */
/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./crossings.js').Crossing} Crossing */
/** @typedef {{ D: Coefficients, N: Coefficients, crossings: () => Crossing[] }} Loop */

/**
 * The margins of the loop k N/D at the present gain: by which factor the gain may change before a root
 * crosses the axis, how far the phase is from -180 degrees where the loop's size is 1, and the delay (s) that
 * would use it up. null where nothing is fed back.
 * @param {System} system
 * @param {State} state
 * @param {What} what
 */
export function margins(system, state, what = lastLoop(system)) {
  if (!system.running[what.running].magnitudes || what.of === 'zeros') return null;
  const loop = loopOf(system, state, what);
  if (system.loop) return ownMargins(loop.parts, loop.crossings(), state[what.running], system.loop.dt);
  return marginsOf(loop, state[what.running]);
}

/**
 * The margins of k N/D.
 * @param {Loop} loop
 * @param {number} k
 */
export function marginsOf({ D, N, crossings }, k) {
  if (k === 0 || Array.from(N).every((v) => v === 0)) return null;
  const phase = frequenciesOfUnitSize(D, N, k).map((omega) => {
    const [dx, dy] = evaluate(D, 0, omega);
    const [nx, ny] = evaluate(N, 0, omega);
    return phaseMargin(-k * (nx * dx + ny * dy), -k * (ny * dx - nx * dy), omega);
  });
  return marginsByOmega(crossings(), k, phase);
}

/**
 * Where |D|^2 - k^2 |N|^2 = 0, a polynomial of u = omega^2.
 * @param {Coefficients} D
 * @param {Coefficients} N
 * @param {number} k
 */
function frequenciesOfUnitSize(D, N, k) {
  const u = roots(combine(squareOnAxis(D), squareOnAxis(N), -k * k));
  return u.x.filter((x, i) => x > 0 && Math.abs(u.y[i]) <= 1e-9 * x).map(Math.sqrt);
}

/**
 * |c(j omega)|^2 as a polynomial of omega^2: the squares of c's even and odd parts, c(j omega) = even + j
 * omega odd.
 * @param {Coefficients} c
 */
function squareOnAxis(c) {
  const part = (/** @type {number} */ first) =>
    Float64Array.from({ length: (c.length - first + 1) >> 1 }, (_, k) => c[2 * k + first] * (-1) ** k);
  const [even, odd] = [part(0), part(1)];
  return combine(multiply(even, even), [0, ...multiply(odd, odd)], 1);
}
