// Fractions of products of polynomials, as an expression makes them: factors stay factors until they are
// added to something.
import { times } from '../maths/polynomials.js';
import { product, sum, trimmed } from './complex_polynomials.js';
import { LoopError } from './loop_error.js';

/** @typedef {import('./complex_polynomials.js').Complex} Complex */
/** @typedef {import('./complex_polynomials.js').Polynomial} Polynomial */
/** @typedef {{ c: Polynomial, power: number }} Factor */
/** @typedef {{ gain: Complex, above: Factor[], below: Factor[] }} Fraction */

const MOST = 60; // degree of a part of an expression

/** @param {Factor[]} factors */
const degreeOf = (factors) => factors.reduce((sum, { c, power }) => sum + (c.length - 1) * power, 0);

/** @param {Factor[]} factors @returns {Factor[]} */
function bounded(factors) {
  const degree = degreeOf(factors);
  if (degree > MOST) throw new LoopError('degree of the expression', String(degree), `at most ${MOST}`);
  return factors;
}

/** @param {Complex} gain @returns {Fraction} */
export const constant = (gain) => ({ gain, above: [], below: [] });

/** The variable itself. @returns {Fraction} */
export const variable = () => ({
  gain: [1, 0],
  above: [
    {
      c: [
        [0, 0],
        [1, 0],
      ],
      power: 1,
    },
  ],
  below: [],
});

/** @param {Fraction} a */
const isZero = ({ gain: [re, im] }) => re === 0 && im === 0;

/** @param {Fraction} a @param {Fraction} b @returns {Fraction} */
export const multiplied = (a, b) => ({
  gain: times(a.gain, b.gain),
  above: bounded([...a.above, ...b.above]),
  below: bounded([...a.below, ...b.below]),
});

/** @param {Fraction} a @returns {Fraction} */
export function inverse({ gain: [re, im], above, below }) {
  if (re === 0 && im === 0) throw new LoopError('divisor in the expression', '0', 'something else');
  const size = re * re + im * im;
  return { gain: im === 0 ? [1 / re, 0] : [re / size, -im / size], above: below, below: above };
}

/** @param {Fraction} a @param {Fraction} b */
export const divided = (a, b) => {
  // A real number is divided by at once: 1/49 once rounded times 49 is not 1.
  if (b.above.length + b.below.length === 0 && b.gain[1] === 0 && b.gain[0] !== 0)
    return { ...a, gain: /** @type {Complex} */ ([a.gain[0] / b.gain[0], a.gain[1] / b.gain[0]]) };
  return multiplied(a, inverse(b));
};

/** @param {Fraction} a @param {number} power whole @returns {Fraction} */
export function raised(a, power) {
  if (power < 0) return raised(inverse(a), -power);
  /** @param {Factor[]} factors */
  const each = (factors) => (power ? factors.map(({ c, power: p }) => ({ c, power: p * power })) : []);
  /** @type {Complex} */
  let gain = [1, 0];
  for (let k = 0; k < power; k++) gain = times(gain, a.gain);
  return { gain, above: bounded(each(a.above)), below: bounded(each(a.below)) };
}

/** @param {Factor[]} factors @param {Complex} gain */
export function expanded(factors, gain) {
  /** @type {Polynomial} */
  let found = [gain];
  for (const { c, power } of factors) for (let k = 0; k < power; k++) found = product(found, c);
  return found;
}

/** a + sign b: multiplied out above, the denominators stay factors. */
/** @param {Fraction} a @param {Fraction} b @param {number} sign @returns {Fraction} */
export function added(a, b, sign) {
  if (isZero(b)) return a;
  if (isZero(a)) return { ...b, gain: [sign * b.gain[0], sign * b.gain[1]] };
  const left = expanded(bounded([...a.above, ...b.below]), a.gain);
  const right = expanded(bounded([...b.above, ...a.below]), b.gain);
  const c = trimmed(sum(left, right, sign));
  const below = bounded([...a.below, ...b.below]);
  if (c.length === 1) return { gain: c[0], above: [], below };
  return { gain: [1, 0], above: [{ c, power: 1 }], below };
}
