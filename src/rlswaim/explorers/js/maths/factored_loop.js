// An open loop as distinct poles and zeros, without what they have in common: what break-aways and crossings
// are found from.
import { agreeing, withoutEqual } from './common_factors.js';
import { distinctRoots } from './multiple_roots.js';
import { EPS, evaluate, ROUNDING, termsAt, trimmed } from './polynomials.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./polynomials.js').Complex} Complex */
/**
 * D + k N; the sizes are what each coefficient is a small difference of, by default its own size.
 * @typedef {{ D: Coefficients, N: Coefficients, sizes?: { D: Float64Array, N: Float64Array } }}
 *   PolynomialLoop
 */
/** @typedef {{ poles: Points, zeros: Points, gain: number }} FactorLoop gain Π(s - zeros) / Π(s - poles) */
/** @typedef {{ x: ArrayLike<number>, y: ArrayLike<number> }} Points */
/** @typedef {import('./multiple_roots.js').Root} Root */
/**
 * gain Π(s - zeros) / Π(s - poles); common: the roots that stand still, as zeros and poles have them in
 * common; doubt: the part of D/N at a point by which the rounding of the data changes it; isRoot: whether the
 * data let a point be a pole (or a zero) itself.
 * @typedef {{ poles: Root[], zeros: Root[], common: Root[], gain: number,
 *   doubt: (x: number, y: number) => number, isRoot: (of: 'poles' | 'zeros', x: number, y: number) => boolean
 * }} FactoredLoop
 */

/**
 * @param {PolynomialLoop | FactorLoop} loop
 * @returns {FactoredLoop}
 */
export const factored = (loop) => ('poles' in loop ? fromFactors(loop) : fromPolynomials(loop));

/**
 * @param {FactorLoop} loop
 * @returns {FactoredLoop}
 */
function fromFactors({ poles, zeros, gain }) {
  const { common, ...parts } = withoutEqual({ poles: gathered(poles), zeros: gathered(zeros) });
  const all = [...parts.poles, ...parts.zeros];
  return {
    ...parts,
    common,
    gain,
    doubt: (x, y) =>
      all.reduce((sum, r) => sum + (EPS * r.count * Math.hypot(r.x, r.y)) / Math.hypot(x - r.x, y - r.y), 0),
    isRoot: (of, x, y) =>
      parts[of].some((r) => Math.hypot(x - r.x, y - r.y) <= ROUNDING * Math.hypot(r.x, r.y)),
  };
}

/**
 * @param {PolynomialLoop} loop
 * @returns {FactoredLoop}
 */
function fromPolynomials({ D, N, sizes }) {
  const resting = leadingZeros(D, N); // roots at the origin at every gain
  const [d, n] = [trimmed(D).subarray(resting), trimmed(N).subarray(resting)];
  const data = {
    poles: { c: d, sizes: sizes ? sizes.D.subarray(resting) : d },
    zeros: { c: n, sizes: sizes ? sizes.N.subarray(resting) : n },
  };
  const all = { poles: distinctRoots(d, data.poles.sizes), zeros: distinctRoots(n, data.zeros.sizes) };
  /** @type {FactoredLoop['isRoot']} */
  const isRoot = (of, x, y) => rests(data[of].c, data[of].sizes, x, y);
  const { common, ...parts } = agreeing(
    all,
    data,
    (z, p) => isRoot('poles', z.x, z.y) || isRoot('zeros', p.x, p.y),
  );
  return {
    ...parts,
    common: resting > 0 ? [{ x: 0, y: 0, count: resting }, ...common] : common,
    gain: n[n.length - 1] / d[d.length - 1],
    doubt: (x, y) => share(d, data.poles.sizes, x, y) + share(n, data.zeros.sizes, x, y),
    isRoot,
  };
}

/**
 * @param {Coefficients} D
 * @param {Coefficients} N
 */
function leadingZeros(D, N) {
  let count = 0;
  while (count < Math.min(D.length, N.length) - 1 && D[count] === 0 && N[count] === 0) count++;
  return count;
}

// The rounding of a polynomial's value beside the value.
/**
 * @param {Coefficients} c
 * @param {Coefficients} sizes
 * @param {number} x
 * @param {number} y
 */
const share = (c, sizes, x, y) =>
  (EPS / 2) * (termsAt(sizes, Math.hypot(x, y)) / Math.hypot(...evaluate(c, x, y)));

/**
 * @param {Coefficients} c
 * @param {Coefficients} sizes
 * @param {number} x
 * @param {number} y
 */
const rests = (c, sizes, x, y) =>
  Math.hypot(...evaluate(c, x, y)) <= ROUNDING * termsAt(sizes, Math.hypot(x, y));

// Equal points as one of a multiplicity.
/**
 * @param {Points} points
 * @returns {Root[]}
 */
function gathered({ x, y }) {
  /** @type {Map<string, Root>} */
  const found = new Map();
  for (let i = 0; i < x.length; i++) {
    const key = `${x[i] + 0} ${y[i] + 0}`;
    const root = found.get(key) ?? { x: x[i], y: y[i], count: 0 };
    root.count++;
    found.set(key, root);
  }
  return [...found.values()];
}

/**
 * The gain k at which 1 + k G is zero at a point, as a complex number: real on the locus.
 * @param {Pick<FactoredLoop, 'poles' | 'zeros' | 'gain'>} loop
 * @param {number} x
 * @param {number} y
 * @returns {Complex}
 */
export function gainAtPoint({ poles, zeros, gain }, x, y) {
  let re = -1 / gain;
  let im = 0;
  let i = 0;
  let j = 0;
  let over = poles[0]?.count ?? 0;
  let under = zeros[0]?.count ?? 0;
  while (i < poles.length || j < zeros.length) {
    // The size stays moderate: what would make it larger waits until something has made it smaller.
    const isZero = i === poles.length || (j < zeros.length && re * re + im * im > 1);
    const root = isZero ? zeros[j] : poles[i];
    const dx = x - root.x;
    const dy = isZero ? root.y - y : y - root.y;
    const weight = isZero ? 1 / (dx * dx + dy * dy) : 1;
    const turned = (re * dx - im * dy) * weight;
    im = (re * dy + im * dx) * weight;
    re = turned;
    if (isZero && --under === 0) under = zeros[++j]?.count ?? 0;
    if (!isZero && --over === 0) over = poles[++i]?.count ?? 0;
  }
  return [re, im];
}

/**
 * Σ 1/(s - poles) - Σ 1/(s - zeros), which is d(ln k)/ds on the locus.
 * @param {FactoredLoop} loop
 * @param {number} x
 * @param {number} y
 * @returns {Complex}
 */
export function logarithmicSlope({ poles, zeros }, x, y) {
  const sum = [0, 0];
  addInverses(sum, poles, x, y, 1);
  addInverses(sum, zeros, x, y, -1);
  return [sum[0], sum[1]];
}

/**
 * @param {number[]} sum
 * @param {Root[]} roots
 * @param {number} x
 * @param {number} y
 * @param {number} sign
 */
function addInverses(sum, roots, x, y, sign) {
  for (const root of roots) {
    const dx = x - root.x;
    const dy = y - root.y;
    const weight = (sign * root.count) / (dx * dx + dy * dy);
    sum[0] += dx * weight;
    sum[1] -= dy * weight;
  }
}
