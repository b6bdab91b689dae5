// A control system with a compensator in it. The system's polynomials are affine in the gain k whose signal
// goes through the compensator: with k N/D in place of k, times D, a term with k is multiplied by N and any
// other by D.
import { roots } from './aberth.js';
import { isProper, monic, rootsOf } from './compensator.js';
import { multiply } from './polynomials.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').Term} Term */
/** @typedef {import('./compensator.js').Compensator} Compensator */

export const BRANCH = 'compensator';

/**
 * The system with the compensator in the path of one of its gains; the system itself without one, or with one
 * that cannot be built.
 * @template {System} Any
 * @param {Any} system
 * @param {Compensator | null} compensator
 * @returns {Any}
 */
export function compensated(system, compensator) {
  if (!compensator || !isProper(compensator)) return system;
  const { place, sections } = compensator;
  // The characteristic polynomial begins with 1 as before, which the responses rely on.
  const [N, D] = monic(compensator);
  /** @param {Term} term */
  const within = (term) => ({
    factors: term.factors,
    coefficients: multiply(term.coefficients, term.factors.includes(place) ? N : D),
  });
  const numerators =
    system.numerators &&
    Object.fromEntries(
      Object.entries(system.numerators).map(([input, outputs]) => [
        input,
        Object.fromEntries(Object.entries(outputs).map(([output, terms]) => [output, terms.map(within)])),
      ]),
    );
  const poles = sections
    .flatMap((section) => rootsOf(section, roots).poles)
    .map((pole) => ({ ...pole, branch: BRANCH }));
  const terms = system.terms.map(within);
  return { ...system, terms, numerators, poles: [...system.poles, ...poles], through: { place, N, D } };
}

/**
 * A polynomial of the system without the compensator, affine in the gain of its place, as it is with it.
 * @param {import('./terms.js').Through | undefined} through the compensator, if there is one
 * @param {import('./terms.js').State} state
 * @param {(state: import('./terms.js').State) => ArrayLike<number>} at the polynomial without it
 * @returns {ArrayLike<number>} constant term first
 */
export function throughCompensator(through, state, at) {
  const whole = at(state);
  if (!through) return whole;
  const { place, N, D } = through;
  const without = at({ ...state, [place]: 0 });
  const length = Math.max(whole.length, without.length);
  const rest = Array.from({ length }, (_, k) => (whole[k] ?? 0) - (without[k] ?? 0));
  const [first, second] = [multiply(without, D), multiply(rest, N)];
  return Array.from(
    { length: Math.max(first.length, second.length) },
    (_, k) => (first[k] ?? 0) + (second[k] ?? 0),
  );
}
