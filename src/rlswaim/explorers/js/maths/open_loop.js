// One loop of a control system as D + k N in its gain k, with its poles, zeros, break-aways and crossings.
import { breakAways } from './break_aways.js';
import { crossings, IMAGINARY_AXIS, UNIT_CIRCLE } from './crossings.js';
import { factored } from './factored_loop.js';
import { aberthOfFactors } from './factored_roots.js';
import { lazy, once } from './kept_values.js';
import { along, factorsOf, longest, weightOf } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./multiple_roots.js').Root} Root */
/**
 * What a locus draws: the parameter that runs, the gains that are off, and whether its roots are the
 * closed-loop poles or the zeros that the poles run to in a later loop, whose gain multiplies them.
 * @typedef {{ running: string, off?: string[], of?: string, gain?: string }} What
 */
/** @typedef {{ D: Float64Array, N: Float64Array, sizes: { D: Float64Array, N: Float64Array } }} OpenLoop */

/**
 * What a locus draws unless it is told otherwise: the loop that is closed last.
 * @param {System} system
 * @returns {What}
 */
export const lastLoop = (system) => ({
  running: system.locus_gains[system.locus_gains.length - 1],
  off: [],
  of: 'poles',
});

/**
 * @param {State} state
 * @param {string[]} gains
 * @returns {State}
 */
export const withoutGains = (state, gains = []) => ({
  ...state,
  ...Object.fromEntries(gains.map((gain) => [gain, 0])),
});

/**
 * The loop as D + k N in the gain k that runs; the sizes are the sums of the sizes of the terms of each
 * coefficient.
 * @param {System} system
 * @param {State} state
 * @param {What} what
 * @returns {OpenLoop}
 */
export function openLoop(system, state, what = lastLoop(system)) {
  const { running, off, of, gain } = what;
  const factors = factorsOf(system, withoutGains(state, off));
  const zeros = of === 'zeros';
  if (zeros && gain) factors[gain] = 1;
  factors[running] = 1;
  const length = longest(system.terms);
  const [D, N, Ds, Ns] = Array.from({ length: 4 }, () => new Float64Array(length));
  for (const term of system.terms) {
    if (zeros && !term.factors.includes(gain ?? '')) continue;
    const weight = weightOf(term, factors);
    const [sum, sizes] = term.factors.includes(running) ? [N, Ns] : [D, Ds];
    for (let k = 0; k < term.coefficients.length; k++) {
      const part = weight * term.coefficients[k];
      sum[k] += part;
      sizes[k] += Math.abs(part);
    }
  }
  let n = length;
  while (n > 1 && D[n - 1] === 0 && N[n - 1] === 0) n--;
  const [d, m, ds, ms] = [D, N, Ds, Ns].map((c) => c.subarray(0, n));
  return { D: d, N: m, sizes: { D: ds, N: ms } };
}

/**
 * The places of all sliders as a key.
 * @param {System} system
 * @param {State} state
 */
export const placesOf = (system, state) => system.parameters.map(({ name }) => state[name]).join();

/**
 * The open loop with what its own polynomials tell: it stays while its gain runs.
 * @param {System} system
 * @param {State} state
 * @param {What} what
 */
export function loopOf(system, state, what) {
  const { running, off = [], of = 'poles', gain } = what;
  const still = withoutGains(state, [...off, running, gain ?? running]);
  return once(system, `loop ${running} ${of} ${placesOf(system, still)}`, () => {
    const loop = openLoop(system, state, what);
    const own = system.loop;
    const parts = factored(own?.exact ? own : loop);
    return {
      ...loop,
      parts,
      solve: own?.exact ? solver(parts) : undefined,
      breaks: breakAways(parts),
      crossings: lazy(() => crossings(parts, own?.dt ? UNIT_CIRCLE : IMAGINARY_AXIS)),
      zeros: repeated([...parts.zeros, ...parts.common]),
    };
  });
}

/**
 * @param {import('./factored_loop.js').FactoredLoop} parts
 * @returns {import('./tracing.js').Curve['solve']}
 */
const solver = (parts) => (t, x, y, close) => aberthOfFactors(parts, t, x, y, close);

/** @param {Root[]} roots */
function repeated(roots) {
  const all = roots.flatMap((root) => new Array(root.count).fill(root));
  return { x: all.map(({ x }) => x), y: all.map(({ y }) => y) };
}

/** @param {{ re: number, im: number }} pole @param {number} factor */
const scaled = ({ re, im }, factor) => ({ re: factor * re, im: factor * im });

/**
 * The open-loop poles, each with the branch that leaves from it: the vehicle's from Python, the actuators'
 * are factors. A pole with a parameter `at` is in proportion to what `each` place of it says.
 * @param {System} system
 * @param {State} state
 * @returns {{ x: ArrayLike<number>, y: ArrayLike<number>, branches: string[] }}
 */
export function namedPoles(system, state) {
  const poles = [
    ...system.poles.map((p) => (p.at ? { ...p, ...scaled(p, along(p.each, state[p.at])) } : p)),
    ...system.actuators.map((a) => ({ re: -state[a.factor], im: 0, branch: a.branch })),
  ];
  return { x: poles.map((p) => p.re), y: poles.map((p) => p.im), branches: poles.map((p) => p.branch) };
}
