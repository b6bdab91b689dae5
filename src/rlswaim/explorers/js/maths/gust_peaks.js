// The worst 1-cosine gust for each of several outputs, from partial fractions: the steps of time and the
// lengths are those that Python sends.
import { growth } from './responses.js';

/** @typedef {{ x: number, y: number }} Root with its part of the motion: y >= 0, a pair counts once */
/** @typedef {{ rx: Float64Array, ry: Float64Array, through: number }} Output residues; the gust's own part */
/** @typedef {{ durations: [number, number], count: number, fine: number, step: number }} Gusts */

const LOOK = 25; // steps between two looks at what is left of the motion

/** @param {number} from @param {number} to @param {number} count */
const ratios = (from, to, count) =>
  Array.from({ length: count }, (_, k) => from * (to / from) ** (k / (count - 1)));

/**
 * What each root does in a step of time: it turns, and takes up an input of 1.
 * @param {Root[]} roots @param {number} step
 */
export function turnsOf(roots, step) {
  return roots.map(({ x, y }) => {
    const size = Math.exp(x * step);
    const [gx, gy] = growth(x * step, y * step);
    return { ex: size * Math.cos(y * step), ey: size * Math.sin(y * step), fx: step * gx, fy: step * gy };
  });
}

/** @param {Output} output @param {Float64Array} mx @param {Float64Array} my @param {number} wind */
function sampleOf({ rx, ry, through }, mx, my, wind) {
  let sum = through * wind;
  for (let i = 0; i < mx.length; i++) sum += rx[i] * mx[i] - ry[i] * my[i];
  return sum;
}

/**
 * What an output cannot exceed any more.
 * @param {Output} output @param {Float64Array} mx @param {Float64Array} my
 */
function leftOf({ rx, ry }, mx, my) {
  let sum = 0;
  for (let i = 0; i < mx.length; i++) sum += Math.hypot(rx[i], ry[i]) * Math.hypot(mx[i], my[i]);
  return sum;
}

/**
 * The peak of each output in a gust of height 1, looked for until nothing can exceed what is known.
 * @param {ReturnType<typeof turnsOf>} turns @param {Output[]} outputs @param {number} duration
 * @param {{ step: number, end: number }} time @param {number[]} known peaks of other gusts
 */
function peaksOf(turns, outputs, duration, { step, end }, known) {
  const [mx, my] = [new Float64Array(turns.length), new Float64Array(turns.length)];
  const peaks = outputs.map(() => 0);
  const samples = Math.ceil(end / step - 1e-9);
  let wind = 0;
  for (let k = 0; k < samples; k++) {
    const t = k * step;
    if (k > 0)
      turns.forEach(({ ex, ey, fx, fy }, i) => {
        const x = mx[i];
        mx[i] = ex * x - ey * my[i] + fx * wind;
        my[i] = ex * my[i] + ey * x + fy * wind;
      });
    wind = t > 0 && t < duration ? (1 - Math.cos((2 * Math.PI * t) / duration)) / 2 : 0;
    for (let o = 0; o < outputs.length; o++) {
      const size = Math.abs(sampleOf(outputs[o], mx, my, wind));
      if (size > peaks[o]) peaks[o] = size;
    }
    if (t > duration && k % LOOK === 0)
      if (outputs.every((output, o) => leftOf(output, mx, my) <= Math.max(peaks[o], known[o]))) break;
  }
  return peaks;
}

/**
 * The peak of each output in its worst gust of height 1.
 * @param {Root[]} roots @param {Output[]} outputs @param {Gusts} gusts
 */
export function worstPeaks(roots, outputs, { durations, count, fine, step }) {
  const turns = turnsOf(roots, step);
  const time = { step, end: 2 * durations[1] };
  const lengths = ratios(durations[0], durations[1], count);
  const known = outputs.map(() => 0);
  const at = outputs.map(() => 0);
  lengths.forEach((length, k) => {
    peaksOf(turns, outputs, length, time, known).forEach((peak, o) => {
      if (peak > known[o]) [known[o], at[o]] = [peak, k];
    });
  });
  return outputs.map((output, o) => {
    const [from, to] = [lengths[Math.max(at[o] - 1, 0)], lengths[Math.min(at[o] + 1, count - 1)]];
    let best = known[o];
    for (const length of ratios(from, to, fine))
      best = Math.max(best, ...peaksOf(turns, [output], length, time, [best]));
    return best;
  });
}
