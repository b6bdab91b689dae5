// What is asked of a loop, evaluated as `rlswaim.practice.criteria` does: from the forms, bounds and steps
// that Python sends.
import { burnData } from './burn.js';
import { numeratorsOf } from './changed_vehicle.js';
import { closedLoopPoles } from './closed_loop.js';
import { engineMargins } from './engine_loop.js';
import { turnsOf, worstPeaks } from './gust_peaks.js';
import { evaluate } from './polynomials.js';
import { residueParts, setApart } from './responses.js';
import { along, factorsOf, polynomial, polynomialOf } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./responses.js').Part} Part */
/** @typedef {[quantity: string, order: number, weight: number, factors: string[]]} FormTerm */
/**
 * @typedef {{ name: string, terms: FormTerm[], factor: number, unit: string, lever?: number[],
 *   symbol: string, says: string }} Peak
 * @typedef {{ wanted: Record<string, number>, stable: number, engine: string[], near: number,
 *   settling: { horizon: number, samples: number, symbol: string, says: string },
 *   gusts: import('./gust_peaks.js').Gusts & { input: string, peak: string, unit: string },
 *   peaks: Peak[], modes: Record<string, [parameter: string, unit: number]>,
 *   margins: Record<string, string>, speed?: number, note: string }} Asked
 * @typedef {{ name: string, value: number, bound: number | null, unit: string, atMost: boolean }} Criterion
 */

/** Whether a criterion is met; null where nothing is asked. @param {Criterion} criterion */
export function isMet({ value, bound, atMost }) {
  if (bound === null) return null;
  return atMost ? value <= bound : value >= bound;
}

/** The residues of a numerator at the roots. @param {ArrayLike<number>} N @param {Part[]} parts */
function residues(N, parts) {
  const [rx, ry] = [new Float64Array(parts.length), new Float64Array(parts.length)];
  parts.forEach(({ x, y, re, im }, i) => {
    const [nx, ny] = evaluate(N, x, y);
    rx[i] = nx * re - ny * im;
    ry[i] = nx * im + ny * re;
  });
  return { rx, ry };
}

/**
 * The numerator from the gust of a sum of derivatives of the loop's outputs, by the powers of s.
 * @param {Peak} peak @param {Record<string, ArrayLike<number>>} numerators
 * @param {Record<string, number>} data
 * @param {number} length
 */
function numeratorOf({ terms }, numerators, data, length) {
  const sum = new Float64Array(length);
  for (const [quantity, order, weight, factors] of terms) {
    let size = weight;
    for (const name of factors) size *= data[name];
    const own = numerators[quantity];
    for (let k = 0; k < own.length && k + order < length; k++) sum[k + order] += size * own[k];
  }
  return sum;
}

/**
 * The peaks in the worst gust of each.
 * @param {System & { criteria: Asked }} system @param {State} state @param {Part[]} parts
 */
function peaksAt(system, state, parts) {
  const { peaks, gusts, wanted, speed } = system.criteria;
  const U = speed ?? system.vehicle.U;
  const D = polynomialOf(system, state);
  const n = D.length - 1;
  const factors = factorsOf(system, state);
  /** @type {Record<string, ArrayLike<number>>} */
  const numerators = { [gusts.input]: D };
  for (const [output, terms] of Object.entries(numeratorsOf(system, state, gusts.input)))
    numerators[output] = polynomial(terms, factors);
  const weights = system.plant?.weights ?? {};
  const outputs = peaks.map((peak) => {
    const lever = peak.lever ? along(peak.lever, state.jet) : 0;
    const data = { ...state, U, gravity: weights[state.gravity] ?? 0, lever };
    const N = numeratorOf(peak, numerators, data, n + 1);
    return { ...residues(N, parts), through: N[n] / D[n] };
  });
  return worstPeaks(parts, outputs, gusts).map((peak) => (peak * wanted[gusts.peak]) / U);
}

/** Whether anything commands theta. @param {System} system */
const isCommanded = ({ numerators }) => !numerators || 'theta_c' in numerators;

/**
 * When theta comes to stay in its band about a step of its command (s).
 * @param {System & { criteria: Asked }} system @param {State} state @param {Part[]} parts
 */
function settlingTime(system, state, parts) {
  const { settling, wanted } = system.criteria;
  const { theta } = numeratorsOf(system, state, 'theta_c');
  const { rx, ry } = residues(polynomial(theta, factorsOf(system, state)), parts);
  const step = settling.horizon / (settling.samples - 1);
  const [mx, my] = [new Float64Array(parts.length), new Float64Array(parts.length)];
  const turns = turnsOf(parts, step);
  let outside = -1;
  for (let k = 0; k < settling.samples; k++) {
    let sum = 0;
    turns.forEach(({ ex, ey, fx, fy }, i) => {
      if (k > 0) [mx[i], my[i]] = [ex * mx[i] - ey * my[i] + fx, ex * my[i] + ey * mx[i] + fy];
      sum += rx[i] * mx[i] - ry[i] * my[i];
    });
    if (Math.abs(sum - 1) > wanted.band) outside = k;
  }
  return outside === settling.samples - 1 ? Infinity : (outside + 1) * step;
}

/**
 * The smallest margins of each mode by name.
 * @param {import('./engine_loop.js').Margins} found @param {Record<string, number>} modes rad/s
 * @param {number} near
 */
export function byMode({ gain, phase }, modes, near) {
  const names = ['rigid', 'aero', ...Object.keys(modes)];
  const none = () => ({ gain_dB: Infinity, phase_deg: Infinity, delay_s: Infinity });
  const table = Object.fromEntries(names.map((name) => [name, none()]));
  /** @param {number} omega @param {boolean} falls */
  const owner = (omega, falls) => {
    const far = Object.entries(modes).map(([name, at]) => ({ name, off: Math.abs(Math.log(omega / at)) }));
    const closest = far.reduce((a, b) => (b.off < a.off ? b : a), { name: '', off: Infinity });
    return closest.off < Math.log(near) ? closest.name : falls ? 'aero' : 'rigid';
  };
  for (const { dB, omega } of gain) {
    const row = table[owner(omega, dB < 0)];
    row.gain_dB = Math.min(row.gain_dB, Math.abs(dB));
  }
  for (const { degrees, delay, omega } of phase) {
    const row = table[owner(omega, false)];
    row.phase_deg = Math.min(row.phase_deg, Math.abs(degrees));
    row.delay_s = Math.min(row.delay_s, delay);
  }
  return table;
}

/**
 * The margins as criteria, in Python's order; the gain of the aero margin may fall by so much.
 * @param {Asked} asked @param {import('./engine_loop.js').Margins} found
 * @param {Record<string, number>} modes
 * @returns {Criterion[]}
 */
function marginCriteria({ wanted, near }, found, modes) {
  const rows = [{ name: 'disk', value: found.disk, bound: wanted.disk, unit: '1', atMost: false }];
  for (const [mode, row] of Object.entries(byMode(found, modes, near))) {
    const bends = mode in modes;
    const gained = bends && !Number.isFinite(row.phase_deg);
    const bounds = {
      gain_dB: [wanted[gained ? 'bending_gain_dB' : 'gain_dB'], 'dB'],
      phase_deg: [wanted[bends ? 'bending_phase_deg' : 'phase_deg'], 'deg'],
      delay_s: [wanted.delay_s, 's'],
    };
    for (const [kind, [bound, unit]] of Object.entries(bounds))
      if (mode !== 'aero' || kind === 'gain_dB') {
        const value = row[/** @type {keyof typeof row} */ (kind)];
        rows.push({
          name: `${mode} ${kind}`,
          value,
          bound: Number(bound),
          unit: String(unit),
          atMost: false,
        });
      }
  }
  return rows;
}

/**
 * Every criterion of the loop, in Python's order and by its names: a loop that is not stable has endless
 * peaks and no margins.
 * @param {System & { criteria: Asked }} system @param {State} state
 * @returns {Criterion[]}
 */
export function evaluateCriteria(system, state) {
  const { wanted, stable, peaks, settling, engine, modes } = system.criteria;
  const poles = closedLoopPoles(system, state);
  const isStable = Array.from(poles.x).every((re) => re <= stable);
  const parts = residueParts(setApart(poles, 1 / settling.horizon));
  const sizes = isStable ? peaksAt(system, state, parts) : peaks.map(() => Infinity);
  const times = isStable && isCommanded(system) ? settlingTime(system, state, parts) : Infinity;
  const burn = system.plant?.burn;
  /** @type {Record<string, number>} */
  const data = burn ? { ...burnData(burn, state) } : state;
  const omegas = Object.fromEntries(
    Object.entries(modes).map(([name, [at, unit]]) => [name, unit * data[at]]),
  );
  const marks = Array.from(poles.x, (x, i) => ({ x, y: poles.y[i] }));
  const found = isStable ? engineMargins(system, state, engine, marks) : { gain: [], phase: [], disk: NaN };
  const told = marginCriteria(system.criteria, found, omegas);
  const settled = { name: 'settling', value: times, bound: wanted.settling, unit: 's', atMost: true };
  return [
    ...(isCommanded(system) ? [settled] : []),
    ...peaks.map(({ name, factor, unit }, i) => ({
      name,
      value: sizes[i] * factor,
      bound: wanted[name] ?? null,
      unit,
      atMost: true,
    })),
    ...told.map((row) => (isStable ? row : { ...row, value: NaN })),
  ];
}
