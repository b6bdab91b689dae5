// The roots of D + k N as the gain k runs from 0.

/** @typedef {import('./break_aways.js').BreakAway} BreakAway */
/** @typedef {import('./tracing.js').Curve} Curve */

/**
 * @param {{ D: ArrayLike<number>, N: ArrayLike<number>, solve?: Curve['solve'] }} loop of equal length
 * @param {number} sign of the gains
 * @param {BreakAway[]} breaks
 * @returns {Curve}
 */
export const gainCurve = ({ D, N, solve }, sign, breaks) => ({
  breaks,
  solve,
  fill(t, c) {
    for (let k = 0; k < c.length; k++) c[k] = D[k] + t * N[k];
  },
  middle: (a, b) =>
    a === 0 || b === 0 ? (a + b) / 2 : sign * Math.sqrt(Math.abs(a)) * Math.sqrt(Math.abs(b)),
});

const MOST = 2000;

/**
 * Sizes of gains at which a trace stops in any case, rising: from 0 by thirds of a decade, and where branches
 * meet.
 * @param {number[]} magnitudes the first and the last size
 * @param {number[]} breaks sizes of gains
 */
export function gainNodes([first, last], breaks) {
  const steps = Math.min(MOST, Math.max(1, Math.round(3 * (Math.log10(last) - Math.log10(first))))) || 1;
  const regular = Array.from({ length: steps + 1 }, (_, i) => first * (last / first) ** (i / steps));
  return [...new Set([0, ...regular, ...breaks])].sort((a, b) => a - b);
}
