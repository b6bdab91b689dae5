// The distinct roots of a polynomial with their multiplicities.
import { roots } from './aberth.js';
import { exactRoots } from './exact_roots.js';
import { exactly } from './exact_transfer.js';
import { fittedRoots, misfit } from './fitted_roots.js';
import { distance, meanOf, ROUNDING } from './polynomials.js';
import { sharpened } from './sharpened.js';

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./polynomials.js').Complex} Complex */
/** @typedef {{ x: number, y: number, count: number }} Root a root of a multiplicity */

const CLUSTER = 0.1; // no roots farther apart than this part of their size are taken for one
const KNOWN_CLUSTER = 0.01; // the same of roots that are known better than the coefficients tell
const FITS = 1e-6; // roots that are more than this off from a coefficient are not all the roots

/**
 * The roots of a polynomial, each once: those that the data let be one are one.
 * @param {Float64Array} c
 * @param {Coefficients} sizes
 * @param {{ x: number[], y: number[] }} [known] the roots, where they are known better than from c
 * @returns {Root[]}
 */
export function distinctRoots(c, sizes, known) {
  if (c.length < 2) return [];
  if (known) return withPairs(grouped(c, sizes, known, KNOWN_CLUSTER));
  const near = sharpened(c, roots(c));
  const found = grouped(c, sizes, near, CLUSTER);
  const areSingle = found.every(({ count }) => count === 1);
  const fitting = areSingle ? found : fittedRoots(c, sizes, found);
  if (fitting && misfit(c, sizes, fitting) <= FITS) return withPairs(fitting);
  // Each is a root to rounding, and yet they are not all of them: so many are near each other.
  const exact = c.every(Number.isFinite) ? exactRoots(exactly(c)) : near;
  const again = grouped(c, sizes, exact, CLUSTER);
  return withPairs(fittedRoots(c, sizes, again) ?? grouped(c, sizes, exact, 0));
}

/**
 * Roots in groups that may each be one multiple root, one of each pair.
 * @param {Float64Array} c
 * @param {Coefficients} sizes
 * @param {{ x: number[], y: number[] }} all
 * @param {number} widest of a group, as a part of its size
 * @returns {Root[]}
 */
function grouped(c, sizes, { x, y }, widest) {
  const partner = conjugates(x, y);
  const left = new Set(x.keys());
  /** @type {Root[]} */
  const found = [];
  for (const i of x.keys()) {
    if (!left.has(i) || y[i] < 0) continue;
    const { members, count, x: at, y: up } = clusterOf(c, sizes, x, y, i, left, widest);
    for (const j of members) {
      left.delete(j);
      left.delete(partner[j]);
    }
    found.push({ x: at, y: up, count });
  }
  return found;
}

/** Each root of a real function that lies above the axis, with its conjugate. @param {Root[]} upper */
export const withPairs = (upper) =>
  upper.flatMap((root) => (root.y === 0 ? [root] : [root, { ...root, y: -root.y }]));

// For each root the number of its conjugate, its own if it is real: nearest ones first. A root that has lost
// its conjugate counts as real.
/**
 * @param {number[]} x
 * @param {number[]} y
 */
function conjugates(x, y) {
  const partner = Array.from(x.keys());
  const nearest = (/** @type {number} */ i, /** @type {number[]} */ others) => {
    let [at, least] = [-1, Infinity];
    for (const j of others) {
      const off = distance(x[j] - x[i], y[j] + y[i]);
      if (off < least) [at, least] = [j, off];
    }
    return at;
  };
  let [upper, lower] = [1, -1].map((side) => partner.filter((i) => side * y[i] > 0));
  const isAlone = (/** @type {number} */ i) => partner[i] === i;
  for (let before = -1; before !== upper.length && lower.length > 0; ) {
    before = upper.length;
    for (const i of upper) {
      const j = nearest(i, lower);
      if (j >= 0 && nearest(j, upper) === i) [partner[i], partner[j]] = [j, i];
    }
    [upper, lower] = [upper.filter(isAlone), lower.filter(isAlone)];
  }
  for (const i of [...upper, ...lower]) y[i] = 0;
  return partner;
}

// The largest group of roots beside one that are far from the others and may be one multiple root.
/**
 * @param {Float64Array} c
 * @param {Coefficients} sizes
 * @param {number[]} x
 * @param {number[]} y
 * @param {number} i
 * @param {Set<number>} left
 * @param {number} widest of a group, as a part of its size
 */
function clusterOf(c, sizes, x, y, i, left, widest) {
  const alone = { members: [i], count: 1, x: x[i], y: y[i] };
  const off = (/** @type {number} */ j) => distance(x[j] - x[i], y[j] - y[i]);
  const farthest = widest * distance(x[i], y[i]);
  const near = [i];
  for (const j of left) if (j !== i && off(j) <= 4 * farthest) near.push(j);
  if (near.length === 1) return alone;
  near.sort((a, b) => off(a) - off(b));
  for (let m = near.length; m > 1; m--) {
    const members = near.slice(0, m);
    const next = m < near.length ? off(near[m]) : Infinity;
    if (off(members[m - 1]) > Math.min(farthest, 0.25 * next)) continue;
    const [mx, my] = [x, y].map((v) => meanOf(v, members));
    const real = members.some((j) => y[j] === 0) || members.some((j) => y[j] * my < 0);
    const at = polishedMultiple(c, m, mx, real ? 0 : my);
    if (isMultiple(c, sizes, m, at[0], at[1])) return { members, count: m, x: at[0], y: at[1] };
    const pair = real && repeatedPair(c, sizes, x, y, members);
    if (pair) return pair;
  }
  return alone;
}

// A group about the axis as a pair that is repeated: its mean and its mean square fix where.
/**
 * @param {Float64Array} c
 * @param {Coefficients} sizes
 * @param {number[]} x
 * @param {number[]} y
 * @param {number[]} members
 */
function repeatedPair(c, sizes, x, y, members) {
  const count = members.length / 2;
  const mx = meanOf(x, members);
  const square = members.reduce((sum, j) => sum + y[j] ** 2 - (x[j] - mx) ** 2, 0) / members.length;
  if (count < 2 || !Number.isInteger(count) || !(square > 0)) return null;
  const at = polishedMultiple(c, count, mx, Math.sqrt(square));
  return isMultiple(c, sizes, count, at[0], at[1]) ? { members, count, x: at[0], y: Math.abs(at[1]) } : null;
}

// The derivatives of c at a point over j!, for j = 0 ... m, and the sums of the sizes of their terms.
/**
 * @param {Coefficients} c
 * @param {Coefficients} sizes
 * @param {number} m
 * @param {number} x
 * @param {number} y
 */
function taylor(c, sizes, m, x, y) {
  const n = c.length;
  const size = Math.hypot(x, y);
  const [re, im, terms] = [Float64Array.from(c), new Float64Array(n), Float64Array.from(sizes, Math.abs)];
  for (let j = 0; j <= m && j < n; j++) {
    for (let k = n - 2; k >= j; k--) {
      const [a, b] = [re[k + 1], im[k + 1]];
      re[k] += a * x - b * y;
      im[k] += a * y + b * x;
      terms[k] += terms[k + 1] * size;
    }
  }
  return { re, im, terms };
}

// The simple root of the (m-1)th derivative beside a point: where a multiple root of c is, if it has one.
/**
 * @param {Coefficients} c
 * @param {number} m
 * @param {number} x
 * @param {number} y
 * @returns {Complex}
 */
function polishedMultiple(c, m, x, y) {
  let [zx, zy] = [x, y];
  for (let step = 0; step < 4; step++) {
    const { re, im } = taylor(c, c, m, zx, zy);
    const [px, py, dx, dy] = [re[m - 1], im[m - 1], m * re[m], m * im[m]];
    const square = dx * dx + dy * dy;
    zx -= (px * dx + py * dy) / square;
    zy -= (py * dx - px * dy) / square;
  }
  return Math.hypot(zx - x, zy - y) <= CLUSTER * Math.hypot(x, y) ? [zx, zy] : [x, y];
}

/**
 * @param {Coefficients} c
 * @param {Coefficients} sizes
 * @param {number} m
 * @param {number} x
 * @param {number} y
 */
function isMultiple(c, sizes, m, x, y) {
  const { re, im, terms } = taylor(c, sizes, m, x, y);
  for (let j = 0; j < m; j++) if (Math.hypot(re[j], im[j]) > ROUNDING * terms[j]) return false;
  return true;
}
