// The vehicle through the burn: its masses and modes at each second, and the flight of a pitch program.
import { curveAt } from './curves.js';
import { curveOfFlightAt, mixed } from './flights.js';

/** @import { Values } from '../types.d.ts' */
/** @import { Curve } from './curves.js' */
/** @import { Flown } from './flights.js' */
/** @import { Bent } from './vehicle_data.js' */
/**
 * rows: M, I_y, l_CG, omega_1, omega_2 and four weights a mode, by the second; curves: by mode, the two that
 * its last weights multiply.
 * @typedef {{ rows: number[][], curves: Curve[][], places: Record<string, number>,
 *   flown: Pick<Flown, 'nodes' | 'times' | 'curves'> }} Burn
 */

const LEAST_SPEED = 1; // ft/s: the equations divide by it

/** @param {Burn} burn @param {number} t s */
function rowAt({ rows }, t) {
  const k = Math.max(0, Math.min(Math.floor(t), rows.length - 2));
  return t === k ? rows[k] : t === k + 1 ? rows[k + 1] : mixed(rows[k], rows[k + 1], t - k);
}

/** @param {Burn} burn @param {number} t s @returns {Bent} */
export function bentAt(burn, t) {
  const row = rowAt(burn, t);
  return {
    l_CG: row[2],
    phi(mode, station) {
      const [one, along, ...weights] = row.slice(5 + 4 * mode, 9 + 4 * mode);
      /** @type {[number, number]} */
      const found = [one + along * station, along];
      weights.forEach((weight, k) => {
        const [value, derivative] = curveAt(burn.curves[mode][k], station);
        found[0] += weight * value;
        found[1] += weight * derivative;
      });
      return found;
    },
  };
}

/** Speed (ft/s) and dynamic pressure at a time of the flight. @param {Burn} burn @param {Values} state */
export function flightAt({ flown }, { t, upright, level }) {
  const [U, q_D] = ['U', 'q_D'].map((name) => curveOfFlightAt(flown, name, { t, upright, level }));
  return { U: Math.max(U, LEAST_SPEED), q_D };
}

/** What the coefficients are products of. @param {Burn} burn @param {Values} state */
export function burnData(burn, state) {
  const [M, I_y, , omega_1, omega_2] = rowAt(burn, state.t);
  const { U, q_D } = flightAt(burn, state);
  return { q_D, per_U: 1 / U, per_M: 1 / M, per_I_y: 1 / I_y, omega_1, omega_2 };
}
