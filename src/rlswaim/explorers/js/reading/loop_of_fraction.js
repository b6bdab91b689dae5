// A fraction that was read as a loop: numerator over denominator where each is one polynomial, else factors.
import { distinctRoots } from '../maths/multiple_roots.js';
import { over, times } from '../maths/polynomials.js';
import { isReal } from './complex_polynomials.js';
import { expanded } from './fractions.js';
import { LoopError } from './loop_error.js';

/** @typedef {import('./complex_polynomials.js').Complex} Complex */
/** @typedef {import('./fractions.js').Factor} Factor */
/** @typedef {import('./fractions.js').Fraction} Fraction */
/** @typedef {import('./statements.js').SamplingTime} SamplingTime */

/** @param {Factor[]} factors */
const isOne = (factors) => factors.length === 0 || (factors.length === 1 && factors[0].power === 1);

/** @param {Factor[]} factors */
const allReal = (factors) => factors.every(({ c }) => isReal(c));

/** s s^2 (s+1) as s^3 (s+1). @param {Factor[]} factors @returns {Factor[]} */
function gathered(factors) {
  /** @type {Map<string, Factor>} */
  const found = new Map();
  for (const { c, power } of factors) {
    const key = c.join();
    found.set(key, { c, power: power + (found.get(key)?.power ?? 0) });
  }
  return [...found.values()];
}

/**
 * Factors that are polynomials to be rooted later, and what they are multiplied by: each has the leading
 * coefficient 1. A quadratic with known roots is left to the mathematics too.
 * @param {Factor[]} factors
 */
function monic(factors) {
  /** @type {Complex} */
  let lead = [1, 0];
  const made = factors.map(({ c, power }) => {
    const last = c[c.length - 1];
    for (let k = 0; k < power; k++) lead = times(lead, last);
    return { c: c.map((value) => over(value, last)), power };
  });
  for (const { c } of made)
    if (!isReal(c) && c.length > 2)
      throw new LoopError('a factor of the expression', 'complex coefficients', 'real ones, or (s - p)');
  return { made, lead };
}

/**
 * @param {{ fraction: Fraction, letter: string }} read
 * @param {SamplingTime} given
 * @param {boolean} isTold whether the sampling time was
 * @returns {import('./loop_text.js').GivenLoop}
 */
export function loopOfFraction({ fraction, letter }, given, isTold) {
  const { gain } = fraction;
  const [above, below] = [gathered(fraction.above), gathered(fraction.below)];
  if (letter === 'z' && given === 0 && isTold)
    throw new LoopError('dt', '0 beside an expression in z', 'a time above 0, or True');
  if (letter !== 'z' && letter !== '' && given !== 0)
    throw new LoopError('dt', `${given} beside an expression in ${letter}`, '0, or an expression in z');
  const dt = letter === 'z' && given === 0 ? true : given;
  if (gain[1] === 0 && isOne(above) && isOne(below) && allReal(above) && allReal(below)) {
    /** @param {Factor[]} factors @param {number} factor */
    const highestFirst = (factors, factor) =>
      expanded(factors, [factor, 0])
        .map(([re]) => re)
        .reverse();
    return { form: 'fraction', num: highestFirst(above, gain[0]), den: highestFirst(below, 1), dt };
  }
  const [n, d] = [monic(above), monic(below)];
  const size = over(times(gain, n.lead), d.lead);
  if (Math.abs(size[1]) > 1e-12 * Math.abs(size[0]))
    throw new LoopError('gain of the expression', 'a complex number', 'a real one');
  return { form: 'factors', zeros: rootsOf(n.made), poles: rootsOf(d.made), gain: size[0], dt };
}

/** @param {Factor[]} factors with the leading coefficient 1 @returns {Complex[]} */
function rootsOf(factors) {
  return factors.flatMap(({ c, power }) => {
    const found = c.length === 2 ? [[-c[0][0] + 0, -c[0][1] + 0]] : realRoots(c.map(([re]) => re));
    return Array.from({ length: power }, () => /** @type {Complex[]} */ (found)).flat();
  });
}

/** @param {number[]} c monic, constant term first @returns {number[][]} */
function realRoots(c) {
  if (c.length > 3) {
    const p = Float64Array.from(c);
    return distinctRoots(p, p).flatMap(({ x, y, count }) => Array(count).fill([x, y]));
  }
  const [product, half] = [c[0], c[1] / 2];
  const square = half * half - product;
  if (square < 0) return [Math.sqrt(-square), -Math.sqrt(-square)].map((y) => [-half + 0, y]);
  const far = -half - (half < 0 ? -1 : 1) * Math.sqrt(square);
  return [far, far ? product / far : 0].map((x) => [x + 0, 0]);
}
