// Roots of a polynomial whose coefficients are known without rounding, to the last digits of a double.
import { roots } from './aberth.js';
import { scaled } from './exact_transfer.js';
import { sharpened } from './sharpened.js';

/** @typedef {import('./exact_transfer.js').Exact} Exact */
/** @typedef {{ x: bigint[], y: bigint[] }} Fixed numbers over 2^bits */

const SPARE = 320; // binary digits beyond those by which the coefficients differ
const SWEEPS = 60;
const DONE = 2 ** -70; // a relative step after which a root is known to more digits than a double has

/** @param {bigint} value */
const lengthOf = (value) => (value === 0n ? 0 : (value < 0n ? -value : value).toString(16).length * 4);

/** value / 2^exponent, rounded. @param {bigint} value @param {number} exponent */
export function rounded(value, exponent) {
  const drop = Math.max(0, lengthOf(value) - 128);
  return scaled(Number(value >> BigInt(drop)), drop - exponent);
}

/** @param {number} value @param {number} bits */
function fixed(value, bits) {
  if (value === 0 || !Number.isFinite(value)) return 0n;
  const power = 60 - Math.floor(Math.log2(Math.abs(value)));
  const integer = BigInt(Math.round(scaled(value, power)));
  return bits >= power ? integer << BigInt(bits - power) : integer >> BigInt(power - bits);
}

/** The coefficients as doubles. @param {Exact} polynomial */
export const roundedCoefficients = ({ integers, exponent }) =>
  Float64Array.from(integers, (value) => rounded(value, exponent));

/**
 * All roots. Those at the origin are exact.
 * @param {Exact} polynomial
 * @returns {{ x: number[], y: number[] }}
 */
export function exactRoots({ integers, exponent }) {
  let n = integers.length - 1;
  while (n > 0 && integers[n] === 0n) n--;
  let zeros = 0;
  while (zeros < n && integers[zeros] === 0n) zeros++;
  const inner = integers.slice(zeros, n + 1);
  const origin = new Array(zeros).fill(0);
  if (inner.length < 2) return { x: origin, y: [...origin] };
  const c = Float64Array.from(inner, (value) => rounded(value, exponent));
  const guess = sharpened(c, roots(c));
  const { x, y } = refined(inner, guess);
  return { x: [...origin, ...x], y: [...origin, ...y] };
}

/**
 * @param {bigint[]} integers
 * @param {{ x: number[], y: number[] }} guess
 */
function refined(integers, { x, y }) {
  const n = integers.length - 1;
  // In a unit of 2^unit all roots are at most 1 in size.
  const unit = Math.ceil(Math.log2(Math.max(...x.map((v, i) => Math.hypot(v, y[i]))))) || 0;
  const heights = integers.map((value, i) => (value ? lengthOf(value) + unit * i : -Infinity));
  const top = Math.max(...heights);
  const low = Math.min(...heights.filter(Number.isFinite));
  const bits = top - low + SPARE;
  const c = integers.map((value, i) => {
    const shift = bits - top + unit * i;
    return shift >= 0 ? value << BigInt(shift) : value >> BigInt(-shift);
  });
  const [px, py] = [x, y].map((part) => part.map((v) => scaled(v, -unit)));
  // Real points would stay real and equal points equal: they start a little off the axis and apart.
  px.forEach((v, i) => {
    px[i] = v * (1 + 1e-9 * i);
    py[i] += (i % 2 ? 1e-8 : -1.3e-8) * (1 + i / (8 * n)) * Math.abs(v);
  });
  const exact = { x: px.map((v) => fixed(v, bits)), y: py.map((v) => fixed(v, bits)) };
  const rests = new Uint8Array(n);
  for (let sweep = 0; sweep < SWEEPS && rests.includes(0); sweep++)
    for (let i = 0; i < n; i++) if (!rests[i] && moved(c, bits, exact, px, py, i)) rests[i] = 1;
  return { x: px.map((v) => scaled(v, unit)), y: py.map((v) => scaled(v, unit)) };
}

/**
 * Moves root i by one step of Aberth's; returns whether it rests from now on.
 * @param {bigint[]} c
 * @param {number} bits
 * @param {Fixed} exact
 * @param {number[]} x
 * @param {number[]} y
 * @param {number} i
 */
function moved(c, bits, exact, x, y, i) {
  const [re, im] = newtonStep(c, bits, exact.x[i], exact.y[i]);
  if (re === 0 && im === 0) return true;
  // 1 - step times the sum of the inverse distances
  let [ax, ay] = [1, 0];
  for (let j = 0; j < x.length; j++) {
    if (j === i) continue;
    const [ex, ey] = [x[i] - x[j], y[i] - y[j]];
    const square = ex * ex + ey * ey;
    if (square === 0) continue;
    ax -= (re * ex + im * ey) / square;
    ay -= (im * ex - re * ey) / square;
  }
  const square = ax * ax + ay * ay;
  const [sx, sy] = square > 1e-20 ? [(re * ax + im * ay) / square, (im * ax - re * ay) / square] : [re, im];
  if (!Number.isFinite(sx + sy)) return true;
  exact.x[i] -= fixed(sx, bits);
  exact.y[i] -= fixed(sy, bits);
  x[i] = rounded(exact.x[i], bits);
  y[i] = rounded(exact.y[i], bits);
  const size = Math.hypot(x[i], y[i]);
  if (Math.hypot(sx, sy) > DONE * size) return false;
  if (Math.abs(y[i]) < DONE * size) y[i] = 0;
  return true;
}

/**
 * p/p' at a point, rounded.
 * @param {bigint[]} c
 * @param {number} bits
 * @param {bigint} x
 * @param {bigint} y
 */
function newtonStep(c, bits, x, y) {
  const by = BigInt(bits);
  let [px, py, dx, dy] = [0n, 0n, 0n, 0n];
  for (let k = c.length - 1; k >= 0; k--) {
    [dx, dy] = [((dx * x - dy * y) >> by) + px, ((dx * y + dy * x) >> by) + py];
    [px, py] = [((px * x - py * y) >> by) + c[k], (px * y + py * x) >> by];
  }
  const most = Math.max(...[px, py, dx, dy].map(lengthOf));
  const [vx, vy, wx, wy] = [px, py, dx, dy].map((value) => rounded(value, most));
  const square = wx * wx + wy * wy;
  return square ? [(vx * wx + vy * wy) / square, (vy * wx - vx * wy) / square] : [0, 0];
}
