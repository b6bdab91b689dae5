// The loop of a control system opened at the engine's command, where several gains may meet.
import { crossings } from './crossings.js';
import { factored } from './factored_loop.js';
import { marginsOf } from './margins.js';
import { evaluate } from './polynomials.js';
import { factorsOf, longest, weightOf } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').OpenLoop} OpenLoop */
/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {{ gain: { dB: number, omega: number }[], phase: import('./one_margin.js').PhaseMargin[],
 *   disk: number }} Margins */

const POINTS = 2000;
const BESIDE = 60; // points on either side of a lightly damped root
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/**
 * L = N/D, closed by 1 + L = 0: without the gains that make the engine's command it is open.
 * @param {System} system @param {State} state @param {string[]} gains
 * @returns {OpenLoop}
 */
export function engineLoop(system, state, gains) {
  const factors = factorsOf(system, state);
  const [D, N, Ds, Ns] = Array.from({ length: 4 }, () => new Float64Array(longest(system.terms)));
  for (const term of system.terms) {
    const weight = weightOf(term, factors);
    const [sum, sizes] = term.factors.some((name) => gains.includes(name)) ? [N, Ns] : [D, Ds];
    for (let k = 0; k < term.coefficients.length; k++) {
      const part = weight * term.coefficients[k];
      sum[k] += part;
      sizes[k] += Math.abs(part);
    }
  }
  return { D, N, sizes: { D: Ds, N: Ns } };
}

/** |(1 - L)/(1 + L)|/2 at j omega. @param {OpenLoop} loop @param {number} omega */
function unbalance({ D, N }, omega) {
  const [dx, dy] = evaluate(D, 0, omega);
  const [nx, ny] = evaluate(N, 0, omega);
  return Math.hypot(dx - nx, dy - ny) / Math.hypot(dx + nx, dy + ny) / 2;
}

/**
 * Frequencies over all roots, close together beside those near the axis.
 * @param {ArrayLike<{ x: number, y: number }>} marks
 */
function frequencies(marks) {
  const roots = Array.from(marks);
  const sizes = roots.map(({ x, y }) => Math.hypot(x, y)).filter((size) => size > 1e-9 && size < 1e6);
  const [low, high] = sizes.length ? [Math.min(...sizes) / 100, Math.max(...sizes) * 100] : [1e-2, 1e2];
  const even = Array.from({ length: POINTS }, (_, k) => low * (high / low) ** (k / (POINTS - 1)));
  const beside = roots
    .filter(({ y }) => y > 0)
    .flatMap(({ x, y }) => {
      const width = Math.max(Math.abs(x), 1e-6 * Math.hypot(x, y));
      return Array.from({ length: 2 * BESIDE + 1 }, (_, k) => y + width * Math.sinh((k - BESIDE) / 10));
    });
  return [...even, ...beside].filter((omega) => omega >= low && omega <= high).sort((a, b) => a - b);
}

/**
 * The largest value of a function between two places, by golden section.
 * @param {(omega: number) => number} size @param {number} low @param {number} high
 */
function largestBetween(size, low, high) {
  let [a, b] = [low, high];
  for (let turn = 0; turn < 60; turn++) {
    const [c, d] = [b - GOLDEN * (b - a), a + GOLDEN * (b - a)];
    if (size(c) > size(d)) b = d;
    else a = c;
  }
  return size((a + b) / 2);
}

/**
 * The size of the disk in which gain and phase may vary together.
 * @param {OpenLoop} loop @param {ArrayLike<{ x: number, y: number }>} marks
 */
function diskOf(loop, marks) {
  const size = (/** @type {number} */ omega) => unbalance(loop, omega);
  const at = frequencies(marks);
  const sizes = at.map(size);
  const most = sizes.reduce((best, value, k) => (value > sizes[best] ? k : best), 0);
  const inner = largestBetween(size, at[Math.max(most - 1, 0)], at[Math.min(most + 1, at.length - 1)]);
  return 1 / Math.max(sizes[most], inner);
}

/**
 * All margins at the engine's command; no gain margin at rest, where every loop is real.
 * @param {System} system @param {State} state @param {string[]} gains
 * @param {ArrayLike<{ x: number, y: number }>} closed the roots of the closed loop
 * @returns {Margins}
 */
export function engineMargins(system, state, gains, closed) {
  const loop = engineLoop(system, state, gains);
  if (loop.N.every((c) => c === 0)) return { gain: [], phase: [], disk: 2 };
  /** @type {FactoredLoop} */
  const parts = factored(loop);
  const found = marginsOf({ ...loop, crossings: () => crossings(parts) }, 1);
  const gain = found.gain.filter(({ omega }) => omega > 0);
  return {
    gain,
    phase: found.phase,
    disk: diskOf(loop, [...parts.poles, ...parts.zeros, ...Array.from(closed)]),
  };
}
