// One's own loop, as the mathematics take it: poles, zeros and gain, and the polynomials that these make.
import { exactRoots, roundedCoefficients } from '../maths/exact_roots.js';
import { exactTransfer } from '../maths/exact_transfer.js';
import { distinctRoots } from '../maths/multiple_roots.js';
import { trimmed } from '../maths/polynomials.js';
import { LoopError } from './loop_error.js';

/** @typedef {import('./loop_text.js').GivenLoop} GivenLoop */
/** @typedef {import('../maths/multiple_roots.js').Root} Root */
/** @typedef {{ x: number[], y: number[] }} Points */
/**
 * N/D with constant terms first; exact: poles and zeros are known better than the rounded coefficients tell.
 * dt: 0 in continuous time, else the sampling time, true where it is not told.
 * @typedef {{ D: Float64Array, N: Float64Array, poles: Points, zeros: Points, gain: number,
 *   exact: boolean, dt: number | true }} GivenRoots
 */

export const HIGHEST = 30; // order
const FARTHEST = 1e-12; // of a root's size, from its conjugate
const WIDEST = 2500; // binary digits of the entries of a state space, times its order

/**
 * @param {GivenLoop} given
 * @returns {GivenRoots}
 */
export function givenRoots(given) {
  const found =
    given.form === 'states'
      ? fromStates(given)
      : given.form === 'factors'
        ? fromFactors(given)
        : fromFraction(given);
  const { D, N, poles, zeros, gain } = found;
  if (![...D, ...N, ...poles.x, ...poles.y, ...zeros.x, ...zeros.y, gain].every(Number.isFinite))
    throw new LoopError(
      'the loop',
      'coefficients beyond what double precision holds',
      'a loop in a unit nearer to its poles',
    );
  return { ...found, dt: given.dt };
}

/** @param {number} zeros @param {number} poles how many */
function refuseOrder(zeros, poles) {
  if (poles === 0) throw new LoopError('the loop', 'no poles', 'at least one');
  if (poles > HIGHEST) throw new LoopError('order of the loop', String(poles), `at most ${HIGHEST}`);
  if (zeros > poles)
    throw new LoopError(
      'the loop',
      `a numerator of order ${zeros} over one of order ${poles}`,
      'a proper loop: the roots of 1 + k G are those of 1 + (1/k) (1/G), so give 1/G',
    );
}

/** @param {Root[]} roots @returns {Points} */
function repeated(roots) {
  const all = roots.flatMap((root) => Array(root.count).fill(root));
  return { x: all.map(({ x }) => x), y: all.map(({ y }) => y) };
}

/** @param {Float64Array} c @param {Points} [roots] */
const pointsOf = (c, roots) => {
  const origin = Math.max(
    0,
    c.findIndex((v) => v !== 0),
  );
  const inner = c.subarray(origin);
  const nonzero = roots && { x: roots.x.slice(origin), y: roots.y.slice(origin) };
  const { x, y } = repeated(distinctRoots(inner, inner, nonzero));
  const nothing = Array(origin).fill(0);
  return { x: [...x, ...nothing], y: [...y, ...nothing] };
};

/** @param {import('./loop_text.js').FractionLoop} given */
function fromFraction({ num, den }) {
  const [n, d] = [num, den].map((c) => trimmed([...c].reverse()));
  if (d.length === 0) throw new LoopError('denominator', '0', 'a polynomial that is not zero');
  if (n.length === 0) throw new LoopError('numerator', '0', 'a polynomial that is not zero');
  refuseOrder(n.length - 1, d.length - 1);
  const lead = d[d.length - 1];
  const [N, D] = [n, d].map((c) => c.map((v) => v / lead));
  return {
    N: padded(N, D.length),
    D,
    poles: pointsOf(D),
    zeros: pointsOf(N),
    gain: N[N.length - 1],
    exact: false,
  };
}

/** @param {Float64Array} c @param {number} length */
const padded = (c, length) => Float64Array.from({ length }, (_, k) => c[k] ?? 0);

/** @param {import('./loop_text.js').FactorsLoop} given */
function fromFactors({ zeros, poles, gain }) {
  refuseOrder(zeros.length, poles.length);
  if (gain === 0) throw new LoopError('gain', '0', 'a loop that is not zero');
  const [z, p] = [conjugate('zeros', zeros), conjugate('poles', poles)];
  const D = multipliedOut(p, 1);
  const N = padded(multipliedOut(z, gain), D.length);
  return { N, D, poles: p, zeros: z, gain, exact: true };
}

/** Exact pairs. @param {string} name @param {[number, number][]} list @returns {Points} */
function conjugate(name, list) {
  const x = list.map(([re]) => re);
  const y = list.map(([, im]) => im);
  const left = new Set(list.keys());
  for (const i of list.keys()) {
    if (!left.has(i) || y[i] === 0) continue;
    left.delete(i);
    const size = Math.hypot(x[i], y[i]);
    const twin = [...left].find((j) => Math.hypot(x[j] - x[i], y[j] + y[i]) <= FARTHEST * size);
    if (twin === undefined)
      throw new LoopError(
        `${name}[${i}]`,
        `${x[i]} + ${y[i]}j without its conjugate`,
        'complex ones in pairs',
      );
    left.delete(twin);
    [x[twin], y[twin]] = [x[i], -y[i]];
  }
  return { x, y };
}

/** gain Π(s - roots). @param {Points} roots @param {number} gain */
export function multipliedOut({ x, y }, gain) {
  let [re, im] = [[gain], [0]];
  for (const i of x.keys()) {
    const [a, b] = [re, im];
    re = Array.from(
      { length: a.length + 1 },
      (_, k) => (a[k - 1] ?? 0) - (a[k] ?? 0) * x[i] + (b[k] ?? 0) * y[i],
    );
    im = Array.from(
      { length: a.length + 1 },
      (_, k) => (b[k - 1] ?? 0) - (b[k] ?? 0) * x[i] - (a[k] ?? 0) * y[i],
    );
  }
  return Float64Array.from(re);
}

/** @param {import('./loop_text.js').StatesLoop} given */
function fromStates({ A, B, C, D: through }) {
  const n = A.length;
  refuseOrder(0, n);
  const sizes = A.flat()
    .filter((v) => v !== 0)
    .map((v) => Math.log2(Math.abs(v)));
  if (n * (Math.max(0, ...sizes) - Math.min(0, ...sizes) + 53) > WIDEST * 2)
    throw new LoopError(
      'entries of A',
      `sizes from ${2 ** Math.min(...sizes)} to ${2 ** Math.max(...sizes)}`,
      'sizes nearer to each other',
    );
  const { N, D } = exactTransfer(A, B, C, through);
  const d = roundedCoefficients(D);
  const rounded = trimmed(roundedCoefficients(N));
  if (rounded.length === 0)
    throw new LoopError('the loop', 'C (sI - A)⁻¹ B + D = 0', 'a loop that is not zero');
  const all = [...d, ...rounded];
  if (!all.every(Number.isFinite))
    throw new LoopError(
      'the loop',
      'coefficients beyond what double precision holds',
      'a loop in a unit nearer to its poles',
    );
  return {
    N: padded(rounded, d.length),
    D: d,
    poles: pointsOf(d, exactRoots(D)),
    zeros: pointsOf(rounded, exactRoots({ ...N, integers: N.integers.slice(0, rounded.length) })),
    gain: rounded[rounded.length - 1],
    exact: true,
  };
}
