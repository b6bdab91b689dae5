// A loop that a reader gave, in series with a compensator: a loop of the same kind.
import { roots } from './aberth.js';
import { monic, rootsOf } from './compensator.js';
import { multiply } from './polynomials.js';

/** @typedef {import('./compensator.js').Compensator} Compensator */
/** @typedef {import('../reading/given_loop.js').GivenRoots} GivenRoots */

/**
 * @param {GivenRoots} loop
 * @param {Compensator} compensator
 * @returns {GivenRoots}
 */
export function compensatedLoop(loop, compensator) {
  const [N, D] = monic(compensator);
  const all = compensator.sections.map((section) => rootsOf(section, roots));
  /** @param {'poles' | 'zeros'} of */
  const joined = (of) => {
    const added = all.flatMap((each) => each[of]);
    const { x, y } = loop[of];
    return { x: [...x, ...added.map(({ re }) => re)], y: [...y, ...added.map(({ im }) => im)] };
  };
  const whole = { D: multiply(loop.D, D), N: multiply(loop.N, N) };
  const padded = Float64Array.from(whole.D, (_, k) => whole.N[k] ?? 0);
  return {
    ...loop,
    D: whole.D,
    N: padded,
    poles: joined('poles'),
    zeros: joined('zeros'),
    gain: loop.gain * N[N.length - 1],
  };
}
