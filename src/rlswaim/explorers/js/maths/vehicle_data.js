// The vehicle's data and the coefficients of its equations that they make, by the sums that Python sends.
import { bentAt, burnData } from './burn.js';
import { curveAt } from './curves.js';

/** @import { Values } from '../types.d.ts' */
/** @import { Burn } from './burn.js' */
/** @import { Curve } from './curves.js' */
/** @import { Matrices } from './closed_loop_forms.js' */
/** @typedef {[weight: number, factors: string[]][]} Products */
/** @typedef {{ l_CG: number, phi: (mode: number, station: number) => [number, number] }} Bent */
/**
 * own: where the sliders start; weights: the weight across the path by the choice `gravity`; places: where
 * forces act, stations or the parameters that give them; burn: the vehicle at each second.
 * @typedef {Matrices & { coefficients: Record<string, Products>, parameters: string[], own: Values,
 *   folded: string[], weights?: Record<string, number>, curves?: Curve[], l_CG?: number,
 *   places?: Record<string, string>, burn?: Burn }} Plant
 */

/** The vehicle's parameters alone, as a key. @param {Plant} plant @param {Values} state */
export const dataKey = ({ parameters }, state) => parameters.map((name) => state[name]).join();

/** Is this the vehicle that the plant was made for? @param {Plant} plant @param {Values} state */
export const isOwnVehicle = ({ parameters, own }, state) =>
  parameters.every((name) => (state[name] ?? own[name]) === own[name]);

/**
 * The center of gravity and the modes: a deflection and its derivative at any station.
 * @param {Plant} plant @param {Values} state
 * @returns {Bent}
 */
export function bentBy(plant, state) {
  if (plant.burn) return bentAt(plant.burn, state.t);
  return { l_CG: plant.l_CG, phi: (mode, station) => curveAt(plant.curves[mode], station) };
}

/**
 * Arm, deflections and slopes where forces act.
 * @param {Record<string, number | string>} places @param {Bent} bent @param {Values} state
 */
function shapesAtPlaces(places, { l_CG, phi }, state) {
  /** @type {Record<string, number>} */
  const found = {};
  for (const [place, at] of Object.entries(places)) {
    const station = typeof at === 'string' ? state[at] : at;
    found[`arm_${place}`] = station - l_CG;
    for (const mode of [0, 1]) {
      const [deflection, derivative] = phi(mode, station);
      found[`phi_${mode + 1}_${place}`] = deflection;
      found[`sigma_${mode + 1}_${place}`] = -derivative;
    }
  }
  return found;
}

/** @param {Plant} plant @param {Values} state @returns {Values} */
function dataOf(plant, state) {
  const { parameters, own, weights, burn } = plant;
  const given = Object.fromEntries(parameters.map((name) => [name, state[name] ?? own[name]]));
  const places = burn?.places ?? plant.places;
  const shapes = places ? shapesAtPlaces(places, bentBy(plant, given), given) : {};
  if (burn) return { ...burnData(burn, given), ...shapes };
  return { ...given, ...shapes, ...(weights ? { gravity: weights[given.gravity] } : {}) };
}

/**
 * Each coefficient at the vehicle's data.
 * @param {Plant} plant @param {Values} state
 * @returns {Record<string, number>}
 */
export function coefficientsAt(plant, state) {
  const data = dataOf(plant, state);
  /** @type {Record<string, number>} */
  const found = {};
  for (const [name, products] of Object.entries(plant.coefficients)) {
    let sum = 0;
    for (const [weight, factors] of products) {
      let value = weight;
      for (const factor of factors) value *= data[factor];
      sum += value;
    }
    found[name] = sum;
  }
  return found;
}
