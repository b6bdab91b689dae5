// The closed-loop motion at one pole, along the vehicle, from the numerators that Python sends.
import { numeratorsOf } from './changed_vehicle.js';
import { atFeet } from './curves.js';
import { evaluate, over, termsAt } from './polynomials.js';
import { factorsOf, inputsOf, polynomial } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./polynomials.js').Complex} Complex */
/** @typedef {Record<string, Complex>} Outputs */
/** @typedef {{ re: Float64Array, im: Float64Array }} Shape one entry a foot */

/** @param {Complex} z */
const size = ([re, im]) => Math.hypot(re, im);

// At a pole every input leaves the outputs in the same proportion; the one that rounding spoils least is
// taken: that whose values are largest beside the terms that they are sums of.
/**
 * @param {System} system
 * @param {State} state
 * @param {Complex} pole
 * @returns {Outputs | null}
 */
function proportions(system, state, pole) {
  const factors = factorsOf(system, state);
  let best = -Infinity;
  let found = null;
  for (const input of inputsOf(system)) {
    const outputs = numeratorsOf(system, state, input);
    /** @type {Outputs} */
    const values = {};
    let [clear, largest] = [0, 0];
    for (const [name, terms] of Object.entries(outputs)) {
      const N = polynomial(terms, factors);
      values[name] = evaluate(N, ...pole);
      const all = termsAt(N, size(pole));
      const share = all > 0 ? size(values[name]) / all : 0;
      clear += Math.log(share + 1e-16);
      largest = Math.max(largest, share);
    }
    if (clear > best && largest > 1e-12) [best, found] = [clear, values];
  }
  return found;
}

/**
 * Each coordinate of the deflection as its value and its shape along the vehicle, down as z is.
 * @param {System['vehicle']} vehicle
 * @param {Outputs} values
 * @param {Complex} p
 * @returns {[name: string, value: Complex, along: (foot: number) => number][]}
 */
function coordinatesOf({ U, l_CG, ...given }, { alpha, theta, q1, q2 }, p) {
  const [phi_1, phi_2] = [given.phi_1, given.phi_2].map(atFeet);
  // z' = U (alpha - theta): a motion at s = 0 goes on sideways for good, and nothing else counts beside that.
  /** @type {Complex} */
  const sideways = [U * (alpha[0] - theta[0]), U * (alpha[1] - theta[1])];
  const rests = size(p) === 0;
  const weight = rests && size(sideways) > 0 ? 0 : 1;
  const counted = (/** @type {Complex} */ [re, im]) => /** @type {Complex} */ ([weight * re, weight * im]);
  return [
    ['translation', rests ? sideways : over(sideways, p), () => 1],
    ['theta', counted(theta), (foot) => foot - l_CG],
    ['q1', counted(q1), (foot) => -phi_1[foot]],
    ['q2', counted(q2), (foot) => -phi_2[foot]],
  ];
}

/**
 * The mode at a pole: each output, the share of each coordinate in the deflection (root of mean square along
 * the vehicle), and the deflection at each foot, scaled to a largest size of 1 reached as a real number. null
 * where the pole moves no output (an actuator's on its own).
 * @param {System} system
 * @param {State} state
 * @param {{ re: number, im: number }} pole
 * @returns {(Outputs & { shares: Record<string, number>, shape: Shape }) | null}
 */
export function modeShape(system, state, { re, im }) {
  const values = proportions(system, state, [re, im]);
  if (!values) return null;
  const feet = atFeet(system.vehicle.phi_1).length;
  const shape = { re: new Float64Array(feet), im: new Float64Array(feet) };
  const weights = coordinatesOf(system.vehicle, values, [re, im]).map(([name, value, along]) => {
    let squares = 0;
    for (let l = 0; l < feet; l++) {
      const at = along(l);
      shape.re[l] += value[0] * at;
      shape.im[l] += value[1] * at;
      squares += at * at;
    }
    return /** @type {const} */ ([name, size(value) * Math.sqrt(squares / feet)]);
  });
  const total = weights.reduce((sum, [, weight]) => sum + weight, 0);
  if (total === 0) return null;
  const unit = scaleToOne(shape);
  const scaled = Object.entries(values).map(([name, value]) => [name, over(value, unit)]);
  const shares = Object.fromEntries(weights.map(([name, weight]) => [name, weight / total]));
  return { ...Object.fromEntries(scaled), shares, shape };
}

// Divides a shape by its largest value, and returns that.
/**
 * @param {Shape} shape
 * @returns {Complex}
 */
function scaleToOne({ re, im }) {
  /** @type {Complex} */
  let unit = [0, 0];
  for (let l = 0; l < re.length; l++) if (Math.hypot(re[l], im[l]) > size(unit)) unit = [re[l], im[l]];
  for (let l = 0; l < re.length; l++) [re[l], im[l]] = over([re[l], im[l]], unit);
  return unit;
}
