// The step response of the closed loop k G/(1 + k G) of a loop that a reader gave.
import { closedLoop } from './closed_loop.js';
import { MOTIONS, setApart } from './responses.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('../reading/given_loop.js').GivenRoots} GivenRoots */

const MOST = 100_000; // samples

/**
 * The output at the given times (s) after a unit step of the reference; in discrete time a sample lasts dt,
 * or 1 s where it is not told.
 * @param {System} system
 * @param {State} state
 * @param {ArrayLike<number>} times
 */
export function stepResponse(system, state, times) {
  const { loop } = system;
  if (loop.dt) return sampled(loop, state.k, times);
  const { x, y } = setApart(closedLoop(system, state), 1 / times[times.length - 1]);
  const isProper = loop.zeros.x.length === loop.poles.x.length;
  const lead = isProper ? 1 + state.k * loop.gain : 1;
  const size = (state.k * loop.gain) / lead;
  const sum = new Float64Array(times.length).fill(isProper ? size : 0);
  for (let i = 0; i < x.length; i++) {
    if (y[i] < 0) continue;
    const [re, im] = residue(loop, x, y, i, size * (y[i] > 0 ? 2 : 1));
    if (re === 0 && im === 0) continue;
    const values = Array.from(times, MOTIONS.step(x[i], y[i], 0));
    for (let k = 0; k < sum.length; k++) sum[k] += re * values[k][0] - im * values[k][1];
  }
  return sum;
}

/**
 * size Π(p - zeros) / Π(p - other poles) for one pole, a factor above and one below in turn.
 * @param {GivenRoots} loop
 * @param {ArrayLike<number>} x
 * @param {ArrayLike<number>} y
 * @param {number} i
 * @param {number} size
 */
function residue({ zeros }, x, y, i, size) {
  let [re, im] = [size, 0];
  let next = 0;
  for (let j = 0; j < x.length; j++) {
    if (next < zeros.x.length) {
      const [a, b] = [x[i] - zeros.x[next], y[i] - zeros.y[next]];
      [re, im] = [re * a - im * b, re * b + im * a];
      next++;
    }
    if (j === i) continue;
    const [a, b] = [x[i] - x[j], y[i] - y[j]];
    const square = a * a + b * b;
    [re, im] = [(re * a + im * b) / square, (im * a - re * b) / square];
  }
  return [re, im];
}

/**
 * @param {GivenRoots} loop
 * @param {number} k
 * @param {ArrayLike<number>} times
 */
function sampled({ D, N, dt }, k, times) {
  const n = D.length - 1;
  const P = D.map((v, i) => v + k * N[i]);
  const period = dt === true ? 1 : dt;
  const places = Array.from(times, (t) => Math.floor(t / period + 1e-9));
  const count = Math.min(places[places.length - 1], MOST) + 1;
  const y = new Float64Array(count);
  for (let m = 0; m < count; m++) {
    let sum = 0;
    for (let i = 0; i <= n && i <= m; i++) sum += k * N[n - i];
    for (let i = 1; i <= n && i <= m; i++) sum -= P[n - i] * y[m - i];
    y[m] = sum / P[n];
  }
  return Float64Array.from(places, (m) => y[Math.min(m, count - 1)]);
}
