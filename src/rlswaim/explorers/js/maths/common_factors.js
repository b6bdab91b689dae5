// Factors that the poles and zeros of a loop have in common, but for rounding, as
// `rlswaim.rootlocus.common_factors` finds them.
import { fittedTogether } from './fitted_roots.js';
import { distinctRoots, withPairs } from './multiple_roots.js';
import { distance, EPS } from './polynomials.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./multiple_roots.js').Root} Root */
/** @typedef {{ x: number, y: number }} Place */
/** @typedef {{ poles: Root[], zeros: Root[] }} Parts */
/** @typedef {{ c: Float64Array, sizes: Coefficients }} Polynomial the sizes are those of each sum's terms */
/** @typedef {{ zero: Place, pole: Place, count: number }} Met a zero and a pole that are the same */

const NEAR = 1e-3; // no two points farther apart than this part of their size are taken for one
const SAME = 64 * EPS; // points that differ by so much of their size are the same

/** @param {Place} a @param {Place} b */
const isSame = (a, b) => a.x === b.x && a.y === b.y;

/**
 * What poles and zeros have in common, nearest ones first, and the rest of them. A real zero meets a real
 * pole only, and one above the axis a pole there: pairs stay pairs.
 * @param {Parts} all
 * @param {(zero: Root, pole: Root) => boolean} same
 * @param {boolean} [once] one of each distinct point
 * @returns {Parts & { met: Met[] }}
 */
function cancelled({ poles, zeros }, same, once = false) {
  /** @type {{ zero: Root, pole: Root, apart: number }[]} */
  const pairs = [];
  for (const zero of zeros) {
    for (const pole of poles) {
      const apart = distance(zero.x - pole.x, zero.y - pole.y);
      const areAlike = Math.sign(zero.y) === Math.sign(pole.y);
      if (areAlike && apart <= NEAR * distance(pole.x, pole.y)) pairs.push({ zero, pole, apart });
    }
  }
  if (pairs.length === 0) return { poles, zeros, met: [] };
  const left = new Map([...poles, ...zeros].map((root) => [root, root.count]));
  const leftOf = (/** @type {Root} */ root) => left.get(root) ?? 0;
  /** @type {Met[]} */
  const met = [];
  for (const { zero, pole } of pairs.sort((a, b) => a.apart - b.apart)) {
    const isUsed = leftOf(zero) < zero.count || leftOf(pole) < pole.count;
    const most = once ? Number(!isUsed) : Math.min(leftOf(zero), leftOf(pole));
    if (most === 0 || !same(zero, pole)) continue;
    for (const root of [zero, pole]) left.set(root, leftOf(root) - most);
    met.push({ zero, pole, count: most });
  }
  const rest = (/** @type {Root[]} */ roots) =>
    roots.map((root) => ({ ...root, count: leftOf(root) })).filter(({ count }) => count > 0);
  return { poles: rest(poles), zeros: rest(zeros), met };
}

/**
 * Poles and zeros, without those in common, and these, fitted to the coefficients of both polynomials. Of a
 * group not all may be common: where the polynomials cannot have them all, one of each distinct point is
 * tried, and at last only those that both have exactly.
 * @param {Parts} all
 * @param {{ poles: Polynomial, zeros: Polynomial }} data
 * @param {(zero: Root, pole: Root) => boolean} same whether they may be but for rounding
 * @returns {Parts & { common: Root[] }}
 */
export function agreeing(all, data, same) {
  const upper = { poles: onePerPair(all.poles), zeros: onePerPair(all.zeros) };
  for (const once of [false, true]) {
    const { met, ...left } = cancelled(upper, same, once);
    if (met.every(({ zero, pole }) => isSame(zero, pole))) break;
    const found = sharing(left, met, data);
    if (found) return found;
  }
  return withoutEqual(all);
}

/** Poles and zeros without those that are exactly equal, and these. @param {Parts} all */
export function withoutEqual(all) {
  const { met, ...left } = cancelled(all, isSame);
  return { ...left, common: met.map(({ pole: { x, y }, count }) => ({ x, y, count })) };
}

/** @param {Root[]} roots */
const onePerPair = (roots) => roots.filter(({ y }) => y >= 0);

/**
 * Either the zeros' places or the poles' are taken for the common ones; the others of the other polynomial
 * are those of the quotient or, where this has lost digits, its own.
 * @param {Parts} left one of each pair
 * @param {Met[]} met
 * @param {{ poles: Polynomial, zeros: Polynomial }} data
 */
function sharing(left, met, data) {
  for (const known of /** @type {const} */ (['zeros', 'poles'])) {
    const other = known === 'zeros' ? 'poles' : 'zeros';
    const shared = met.map(({ zero, pole, count }) => ({ ...(known === 'zeros' ? zero : pole), count }));
    const quotient = shared.reduce(divided, data[other].c);
    const ofQuotient = onePerPair(distinctRoots(quotient, quotient));
    for (const rest of [ofQuotient, left[other]]) {
      const found = fittedToBoth({ ...left, [other]: rest }, shared, data);
      if (found) return found;
    }
  }
  return null;
}

/**
 * A polynomial over the factor of a root or a pair, as often as it counts.
 * @param {Float64Array} c @param {Root} root
 */
function divided(c, { x, y, count }) {
  const falling = Array.from(c).reverse();
  const [first, second] = y === 0 ? [x, 0] : [2 * x, -(x * x + y * y)];
  for (let times = 0; times < count; times++) {
    for (let k = 1; k < falling.length; k++)
      falling[k] += first * falling[k - 1] + (k > 1 ? second * falling[k - 2] : 0);
    falling.length -= y === 0 ? 1 : 2;
  }
  return Float64Array.from(falling.reverse());
}

/**
 * @param {Parts} left
 * @param {Root[]} shared
 * @param {{ poles: Polynomial, zeros: Polynomial }} data
 * @returns {(Parts & { common: Root[] }) | null}
 */
function fittedToBoth(left, shared, data) {
  /** @type {{ x: number, y: number, poles: number, zeros: number }[]} */
  const places = [];
  const add = (/** @type {Root} */ { x, y, count }, /** @type {('poles' | 'zeros')[]} */ of) => {
    const known = places.find((p) => distance(p.x - x, p.y - y) <= SAME * distance(x, y));
    const at = known ?? { x, y, poles: 0, zeros: 0 };
    if (!known) places.push(at);
    for (const kind of of) at[kind] += count;
  };
  for (const root of shared) add(root, ['poles', 'zeros']);
  for (const root of left.poles) add(root, ['poles']);
  for (const root of left.zeros) add(root, ['zeros']);
  const counts = [places.map(({ poles }) => poles), places.map(({ zeros }) => zeros)];
  const found = fittedTogether([data.poles, data.zeros], places, counts);
  if (!found) return null;
  const those = (/** @type {(p: number, z: number) => number} */ howOften) =>
    withPairs(
      found
        .map(({ x, y }, i) => ({ x, y, count: howOften(counts[0][i], counts[1][i]) }))
        .filter(({ count }) => count > 0),
    );
  return { poles: those((p, z) => p - z), zeros: those((p, z) => z - p), common: those(Math.min) };
}
