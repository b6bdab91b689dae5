// A control system around a vehicle with other data: the same tables that Python sends of the report's, from
// the closed loop's matrices.

import { roots } from './aberth.js';
import { flightAt } from './burn.js';
import { characteristicTerms, numeratorsFrom } from './closed_loop_forms.js';
import { throughCompensator } from './compensated.js';
import { once } from './kept_values.js';
import { BLIND } from './line_quality.js';
import { matchRoots } from './match_roots.js';
import { deflectionsAlong, shapesAlong, shapesNear } from './shapes.js';
import { factorsOf, polynomial } from './terms.js';
import { trace } from './tracing.js';
import { bentBy, coefficientsAt, dataKey, isOwnVehicle } from './vehicle_data.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./terms.js').OpenPole} OpenPole */

// Of the way from one vehicle to the other. Four coefficients or fewer are multiplied in a determinant of the
// four equations, so five places tell the polynomial at all others.
const STEPS = [0, 0.25, 0.5, 0.75, 1];

/**
 * The system at the vehicle of the state: itself where that is the vehicle that Python sent it for.
 * @template {System} Given
 * @param {Given} system @param {State} state
 * @returns {Given}
 */
export function systemAt(system, state) {
  const { plant, terms } = system;
  if (!plant || (terms && isOwnVehicle(plant, state))) return system;
  return once(system, `vehicle ${dataKey(plant, state)}`, () => changed(system, state));
}

/** @template {System} Given @param {Given} system @param {State} state @returns {Given} */
function changed(system, state) {
  const { plant } = system;
  const coefficients = coefficientsAt(plant, state);
  /** @type {Given} */
  const given = { ...system, base: system, numerators: undefined };
  given.terms = characteristicTerms(plant, coefficients, gainsOf(system));
  given.poles = polesOf(system, coefficients);
  if (plant.burn) {
    const bent = bentBy(plant, state);
    given.shapes = shapesAlong(system.shapes, bent);
    const { U } = flightAt(plant.burn, state);
    given.vehicle = { ...system.vehicle, ...deflectionsAlong(bent), l_CG: bent.l_CG, U };
  }
  return given;
}

/** The factors that are no coefficient of the vehicle. @param {System} system @returns {string[]} */
function gainsOf({ plant }) {
  const { entries, coefficients } = plant;
  const all = entries.flatMap(([, , , factors]) => factors);
  return [...new Set(all)].filter((factor) => !(factor in coefficients));
}

/**
 * The polynomial of the vehicle alone: without feedback each actuator has its pole at 0.
 * @param {System} system @param {Record<string, number>} coefficients
 */
function openPolynomial(system, coefficients) {
  const still = Object.fromEntries(gainsOf(system).map((name) => [name, 0]));
  const terms = characteristicTerms(system.plant, { ...coefficients, ...still });
  return polynomial(terms, {}).subarray(system.actuators.length);
}

/** @param {Record<string, number>} from @param {Record<string, number>} to @param {number} share */
const mixed = (from, to, share) =>
  Object.fromEntries(Object.entries(from).map(([name, value]) => [name, value + share * (to[name] - value)]));

/**
 * The changed vehicle's poles, each with the name of the one that it grows out of as the coefficients go
 * straight from those of the system's own vehicle.
 * @param {System} system @param {Record<string, number>} coefficients
 * @returns {OpenPole[]}
 */
function polesOf(system, coefficients) {
  const { plant, poles } = system;
  const start = coefficientsAt(plant, plant.own);
  const end = openPolynomial(system, coefficients);
  const rests = end[0] === 0 && poles.filter(({ re, im }) => re === 0 && im === 0).length === 1;
  const moving = rests ? poles.filter(({ re, im }) => re !== 0 || im !== 0) : poles;
  const skipped = poles.length - moving.length;
  const known = STEPS.map((t) => (t === 1 ? end : openPolynomial(system, mixed(start, coefficients, t)))).map(
    (c) => c.subarray(skipped),
  );
  const curve = {
    /** @param {number} t @param {Float64Array} c */
    fill(t, c) {
      const weights = STEPS.map((own) =>
        STEPS.reduce(
          (product, other) => (other === own ? product : (product * (t - other)) / (own - other)),
          1,
        ),
      );
      for (let k = 0; k < c.length; k++) c[k] = known.reduce((sum, at, i) => sum + weights[i] * at[k], 0);
    },
    /** @param {number} a @param {number} b */
    middle: (a, b) => (a + b) / 2,
  };
  const from = { x: moving.map(({ re }) => re), y: moving.map(({ im }) => im) };
  const traced = trace(curve, STEPS, from, BLIND).at(-1);
  const exact = roots(end.slice(skipped));
  const partner = matchRoots(traced.x, traced.y, exact.x, exact.y, new Int32Array(moving.length));
  const moved = moving.map(({ branch }, i) => ({ re: exact.x[partner[i]], im: exact.y[partner[i]], branch }));
  return rests ? [...poles.filter((pole) => !moving.includes(pole)), ...moved] : moved;
}

/** All factors of the matrices. @param {System} system @param {State} state */
function valuesAt(system, state) {
  const { plant } = system;
  const shapes = plant.burn ? shapesNear(system, bentBy(plant, state), state) : system.shapes;
  return { ...coefficientsAt(plant, state), ...factorsOf({ ...system, shapes }, state) };
}

/**
 * The closed loop's polynomial around any vehicle, all at the numbers of the state.
 * @param {System} system @param {State} state
 */
export const polynomialAround = (system, state) =>
  throughCompensator(system.through, state, (values) =>
    polynomial(characteristicTerms(system.plant, valuesAt(system, values)), {}),
  );

/**
 * The numerators from an input by output: Python's, or else at the numbers of the state.
 * @param {System} system @param {State} state @param {string} input
 * @returns {Record<string, import('./terms.js').Term[]>}
 */
export function numeratorsOf(system, state, input) {
  const given = system.numerators?.[input];
  if (given) return given;
  /** @param {State} values */
  const at = (values) => numeratorsFrom(system.plant, valuesAt(system, values), input);
  if (!system.through) return at(state);
  const outputs = system.plant.outputs.map((output) => {
    /** @param {State} values */
    const one = (values) => polynomial(at(values)[output], {});
    const coefficients = throughCompensator(system.through, state, one);
    return [output, [{ factors: /** @type {string[]} */ ([]), coefficients }]];
  });
  return Object.fromEntries(outputs);
}
