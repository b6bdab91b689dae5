// A single margin of a loop: its sizes, and the order in which margins are told.

/** @typedef {{ factor: number, dB: number, omega: number }} GainMargin factor by which the gain may change */
/** @typedef {{ degrees: number, omega: number, delay: number }} PhaseMargin delay: s that would use it up */

/** @param {number} factor @param {number} omega @returns {GainMargin} */
export const gainMargin = (factor, omega) => ({ factor, dB: 20 * Math.log10(factor), omega });

/**
 * How far the phase of the loop is from -180 degrees at a frequency where the loop's size is 1.
 * @param {number} re @param {number} im of -L there @param {number} omega
 * @returns {PhaseMargin}
 */
export function phaseMargin(re, im, omega) {
  const degrees = (Math.atan2(im, re) * 180) / Math.PI;
  return { degrees, omega, delay: (((degrees + 360) % 360) * Math.PI) / 180 / omega };
}

/**
 * Both kinds by rising frequency, those of the gain from where branches cross the boundary of stability.
 * @param {{ gain: number, omega: number }[]} crossings @param {number} k the present gain
 * @param {PhaseMargin[]} phase
 */
export function marginsByOmega(crossings, k, phase) {
  const gain = crossings.map((c) => gainMargin(c.gain / k, c.omega)).filter(({ factor }) => factor > 0);
  /** @param {{ omega: number }} a @param {{ omega: number }} b */
  const byOmega = (a, b) => a.omega - b.omega;
  return { gain: gain.sort(byOmega), phase: phase.sort(byOmega) };
}

/**
 * The nearest to the boundary first.
 * @template Each @param {Each[]} each @param {(margin: Each) => number} size
 */
export const nearestFirst = (each, size) => [...each].sort((a, b) => Math.abs(size(a)) - Math.abs(size(b)));
