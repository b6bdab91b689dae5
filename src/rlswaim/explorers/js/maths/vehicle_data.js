// The vehicle's data and the coefficients of its equations that they make, by the sums that Python sends.

/** @import { Values } from '../types.d.ts' */
/** @import { Matrices } from './closed_loop_forms.js' */
/** @typedef {[weight: number, factors: string[]][]} Products */
/** @typedef {{ x: number[], y: number[], slope: number[] }} Curve nodes of cubic pieces, along the vehicle */
/**
 * own: where the sliders start; weights: the weight across the path by the choice `gravity`.
 * @typedef {Matrices & { coefficients: Record<string, Products>, parameters: string[], own: Values,
 *   weights?: Record<string, number> }} Plant
 */

/** The vehicle's parameters alone, as a key. @param {Plant} plant @param {Values} state */
export const dataKey = ({ parameters }, state) => parameters.map((name) => state[name]).join();

/** Is this the vehicle that the plant was made for? @param {Plant} plant @param {Values} state */
export const isOwnVehicle = ({ parameters, own }, state) =>
  parameters.every((name) => (state[name] ?? own[name]) === own[name]);

/** @param {Plant} plant @param {Values} state @returns {Values} */
function dataOf(plant, state) {
  const { parameters, own, weights } = plant;
  const data = Object.fromEntries(parameters.map((name) => [name, state[name] ?? own[name]]));
  return weights ? { ...data, gravity: weights[data.gravity] } : data;
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
