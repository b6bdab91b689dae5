// Multiple roots fitted to all coefficients of a polynomial at once (Gauss and Newton's steps), as
// `rlswaim.rootlocus.repeated_roots` does and tells where it is from.
import { multiply, ROUNDING } from './polynomials.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./multiple_roots.js').Root} Root */

const STEPS = 5; // the error falls with the square at each

/** The real factor of a root or of a pair. @param {Root} root */
const factorOf = ({ x, y }) => (y === 0 ? [-x, 1] : [x * x + y * y, -2 * x, 1]);

/** @param {Root[]} roots one of each pair @param {Root} [left] a root that counts once less */
const product = (roots, left) =>
  roots.reduce((sum, root) => {
    let p = sum;
    for (let k = root === left ? 1 : 0; k < root.count; k++) p = multiply(p, factorOf(root));
    return p;
  }, Float64Array.of(1));

/**
 * How the product changes with the real part of a root and, of a pair, with the imaginary part.
 * @param {Root[]} roots @param {Root} root
 */
function slopesAt(roots, root) {
  const { x, y, count } = root;
  if (x === 0 && y === 0) return []; // it is exact
  const rest = product(roots, root).map((v) => v * count);
  const ways = y === 0 ? [[-1]] : [[2 * x, -2], [2 * y]];
  return ways.map((way) => multiply(rest, Float64Array.from(way)));
}

/**
 * The least squares solution of the sum of columns times unknowns = right, by orthogonal columns.
 * @param {Float64Array[]} columns @param {Float64Array} right
 */
function leastSquares(columns, right) {
  const dot = (/** @type {Float64Array} */ a, /** @type {Float64Array} */ b) =>
    a.reduce((sum, v, i) => sum + v * b[i], 0);
  const rest = right.slice();
  /** @type {Float64Array[]} */
  const units = [];
  /** @type {number[][]} */
  const upper = [];
  const along = columns.map((column) => {
    const own = column.slice();
    const parts = units.map((unit) => {
      const part = dot(unit, own);
      for (let k = 0; k < own.length; k++) own[k] -= part * unit[k];
      return part;
    });
    const size = Math.sqrt(dot(own, own));
    const unit = own.map((v) => v / size);
    const share = dot(unit, rest);
    for (let k = 0; k < rest.length; k++) rest[k] -= share * unit[k];
    units.push(unit);
    upper.push([...parts, size]);
    return share;
  });
  for (let i = along.length - 1; i >= 0; i--) {
    for (let j = i + 1; j < along.length; j++) along[i] -= upper[j][i] * along[j];
    along[i] /= upper[i][i];
  }
  return along;
}

/**
 * How far the product of the roots' factors is from each coefficient, as a part of the sizes of its terms.
 * @param {Coefficients} c @param {Coefficients} sizes of the terms of each coefficient @param {Root[]} roots
 */
function offOf(c, sizes, roots) {
  const last = c[c.length - 1];
  const mirrored = roots.map(({ x, y, count }) => ({
    x: -Math.hypot(x, y),
    y: 0,
    count: y ? 2 * count : count,
  }));
  // Below roots at the origin there is nothing, and no unit.
  const unit = product(mirrored).map((v, k) => Math.max(v, Math.abs(sizes[k] / last)) || 1);
  return { unit, off: product(roots).map((v, k) => (v - c[k] / last) / unit[k]) };
}

/**
 * The largest of these; one that is no number counts as none: nothing can be told of such a polynomial.
 * @param {Coefficients} c @param {Coefficients} sizes @param {Root[]} roots
 */
export const misfit = (c, sizes, roots) =>
  offOf(c, sizes, roots).off.reduce((most, v) => Math.max(most, Math.abs(v) || 0), 0);

/**
 * Roots of given multiplicities, moved to where they fit all coefficients best; none if they do not fit to
 * rounding, so that the polynomial has no such roots.
 * @param {Coefficients} c @param {Coefficients} sizes @param {Root[]} start one of each pair
 * @returns {Root[] | null}
 */
export function fittedRoots(c, sizes, start) {
  const places = fittedTogether([{ c, sizes }], start, [start.map(({ count }) => count)]);
  return places ? places.map((place, i) => ({ ...place, count: start[i].count })) : null;
}

/**
 * The same for several polynomials that have roots in common: where the roots are.
 * @param {{ c: Coefficients, sizes: Coefficients }[]} polynomials
 * @param {{ x: number, y: number }[]} start one of each pair
 * @param {number[][]} counts how often each polynomial has each
 * @returns {{ x: number, y: number }[] | null}
 */
export function fittedTogether(polynomials, start, counts) {
  let places = start;
  for (let step = 0; ; step++) {
    const sets = counts.map((each) => places.map(({ x, y }, i) => ({ x, y, count: each[i] })));
    const parts = polynomials.map(({ c, sizes }, p) => offOf(c, sizes, sets[p]));
    const fits = parts.every(({ off }) => off.every((v) => Math.abs(v) <= ROUNDING * off.length));
    if (fits) return places;
    if (step === STEPS) return null;
    const columns = places.map((_, i) => columnsOf(sets, parts, i));
    const moves = leastSquares(columns.flat(), Float64Array.from(parts.flatMap(({ off }) => [...off])));
    places = places.map(({ x, y }, i) => {
      const [dx = 0, dy = 0] = moves.splice(0, columns[i].length);
      return { x: x - dx, y: y - dy };
    });
  }
}

/**
 * How all coefficients of all polynomials change with the real part of a root and, of a pair, with its
 * imaginary part; nothing of one at the origin, which is exact.
 * @param {Root[][]} sets @param {{ unit: Float64Array }[]} parts @param {number} i
 */
function columnsOf(sets, parts, i) {
  const { x, y } = sets[0][i];
  const ways = x === 0 && y === 0 ? 0 : y === 0 ? 1 : 2;
  const slopes = sets.map((set) => (set[i].count > 0 ? slopesAt(set, set[i]) : []));
  return Array.from({ length: ways }, (_, way) =>
    Float64Array.from(
      parts.flatMap(({ unit }, p) => Array.from(unit, (u, k) => (slopes[p][way]?.[k] ?? 0) / u)),
    ),
  );
}
