// Responses in time from partial fractions of the numerators that Python sends: nothing here knows any
// physics.
import { numeratorsOf } from './changed_vehicle.js';
import { closedLoopPoles } from './closed_loop.js';
import { EPS, evaluate, meanOf } from './polynomials.js';
import { factorsOf, polynomial } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./polynomials.js').Points} Points */
/** @typedef {import('./polynomials.js').Complex} Complex */
/** @typedef {(time: number) => Complex} Motion */
/**
 * input: a key of system.numerators; duration: s, of a gust.
 * @typedef {{ input: string, kind: string, amplitude: number, duration?: number }} Excitation
 */

// (e^z - 1)/z, right at and near z = 0 too.
/**
 * @param {number} x
 * @param {number} y
 * @returns {Complex}
 */
export function growth(x, y) {
  if (x === 0 && y === 0) return [1, 0];
  const half = Math.sin(y / 2);
  const re = Math.expm1(x) * Math.cos(y) - 2 * half * half;
  const im = Math.exp(x) * Math.sin(y);
  const size = x * x + y * y;
  return [(re * x + im * y) / size, (im * x - re * y) / size];
}

// Poles so close that their residues would cancel are set apart on a small circle about their mean: m poles
// at distance r from it change the response by r^m, and rounding by EPS/r^(m - 1).
/**
 * @param {Points} poles
 * @param {number} scale
 */
export function setApart({ x, y }, scale) {
  const n = x.length;
  const free = new Set(Array(n).keys());
  const moved = { x: Float64Array.from(x), y: Float64Array.from(y) };
  const radius = (/** @type {number} */ m, /** @type {number} */ size) => EPS ** (1 / (2 * m - 1)) * size;
  for (let i = 0; i < n; i++) {
    if (!free.has(i)) continue;
    const size = Math.max(Math.hypot(x[i], y[i]), scale);
    const close = [...free].filter((j) => Math.hypot(x[i] - x[j], y[i] - y[j]) < radius(2, size));
    for (const j of close) free.delete(j);
    const m = close.length;
    if (m === 1) continue;
    const [cx, my] = [x, y].map((v) => meanOf(v, close));
    const cy = Math.abs(my) < radius(2, size) ? 0 : my;
    close.forEach((j, k) => {
      const angle = (2 * Math.PI * k) / m;
      moved.x[j] = cx + radius(m, size) * Math.cos(angle);
      // Two stay beside each other, real if they may.
      moved.y[j] = cy + (m > 2 ? radius(m, size) * Math.sin(angle) : 0);
    });
  }
  return moved;
}

/**
 * What one pole x + jy makes of the input at each time: the convolution of e^(pt) with it.
 * @type {Record<string, (x: number, y: number, duration: number) => Motion>}
 */
export const MOTIONS = {
  initial: (x, y) => (t) => {
    const size = Math.exp(x * t);
    return [size * Math.cos(y * t), size * Math.sin(y * t)];
  },
  step: (x, y) => (t) => {
    const [re, im] = growth(x * t, y * t);
    return [t * re, t * im];
  },
  // (1 - cos wt)/2 for one period, in parts 1, e^(jwt) and e^(-jwt): a pole at jw is met without a division
  // by 0.
  gust(x, y, duration) {
    const w = (2 * Math.PI) / duration;
    /** @type {Motion} */
    const during = (t) => {
      const [re, im] = growth(x * t, y * t);
      let [sx, sy] = [re / 2, im / 2];
      for (const turn of [w, -w]) {
        const [gx, gy] = growth(x * t, (y - turn) * t);
        const [c, s] = [Math.cos(turn * t), Math.sin(turn * t)];
        sx -= (gx * c - gy * s) / 4;
        sy -= (gx * s + gy * c) / 4;
      }
      return [t * sx, t * sy];
    };
    const [ex, ey] = during(duration);
    return (t) => {
      if (t <= duration) return during(t);
      const [c, s] = MOTIONS.initial(x, y, 0)(t - duration);
      return [ex * c - ey * s, ex * s + ey * c];
    };
  },
};

/** @typedef {{ x: number, y: number, re: number, im: number }} Part a root, and 1/D' at it */

/**
 * What a numerator is to be multiplied by at each root: 1/D', twice for a pair, of which the real part is
 * both its halves.
 * @param {Points} poles
 * @returns {Part[]}
 */
export function residueParts({ x, y }) {
  const parts = [];
  for (let i = 0; i < x.length; i++) {
    if (y[i] < 0) continue;
    let [re, im] = [1, 0];
    for (let j = 0; j < x.length; j++)
      if (j !== i)
        [re, im] = [re * (x[i] - x[j]) - im * (y[i] - y[j]), re * (y[i] - y[j]) + im * (x[i] - x[j])];
    const weight = (y[i] > 0 ? 2 : 1) / (re * re + im * im);
    parts.push({ x: x[i], y: y[i], re: weight * re, im: -weight * im });
  }
  return parts;
}

/**
 * The outputs at the given times (s) after an input.
 * @param {System} system
 * @param {State} state
 * @param {Excitation} excitation
 * @param {ArrayLike<number>} times
 * @returns {Record<string, Float64Array>}
 */
export function responses(system, state, { input, kind, amplitude, duration }, times) {
  const factors = factorsOf(system, state);
  const outputs = Object.entries(numeratorsOf(system, state, input)).map(([name, terms]) => ({
    name,
    N: polynomial(terms, factors),
    sum: new Float64Array(times.length),
  }));
  const poles = setApart(closedLoopPoles(system, state), 1 / times[times.length - 1]);
  for (const { x, y, re, im } of residueParts(poles)) {
    const values = Array.from(times, MOTIONS[kind](x, y, duration));
    for (const { N, sum } of outputs) {
      const [nx, ny] = evaluate(N, x, y);
      const [rx, ry] = [amplitude * (nx * re - ny * im), amplitude * (nx * im + ny * re)];
      if (rx === 0 && ry === 0) continue;
      for (let k = 0; k < sum.length; k++) sum[k] += rx * values[k][0] - ry * values[k][1];
    }
  }
  return Object.fromEntries(outputs.map(({ name, sum }) => [name, sum]));
}
