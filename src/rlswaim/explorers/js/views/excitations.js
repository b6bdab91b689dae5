// What a loop can be excited with, and the choices of a response's length.
import { letterOf } from '../drawing/letters.js';
import { inputsOf } from '../maths/terms.js';

/** @import { System } from '../types.d.ts' */
/** @typedef {{ input: string, kind: string, amplitude: number, text: string }} Excitation */

const DEGREE = Math.PI / 180;
/** @type {Record<string, string>} */
const WINDS = { alpha_g: 'α_g', alpha_w: 'α_w' };
const FEET = ['q1', 'q2'];
export const DURATIONS = [1, 2, 5, 10, 20, 50, 100, 200, 500];
export const GUSTS = [0.2, 0.5, 1, 2, 5, 10];

/** A step, a gust, or one coordinate displaced at the start. @param {string} input @returns {Excitation} */
function excitationOf(input) {
  const name = input.replace('(0)', '');
  if (input === 'theta_c') return { input, kind: 'step', amplitude: DEGREE, text: 'step of 1° in θ_c' };
  if (WINDS[input])
    return { input, kind: 'gust', amplitude: DEGREE, text: `1 − cos gust of 1° in ${WINDS[input]}` };
  const [amplitude, size] = FEET.includes(name) ? [1, '1 ft'] : [DEGREE, '1°'];
  return { input, kind: 'initial', amplitude, text: `${letterOf(name)} of ${size} at the start` };
}

/** @param {System} system @returns {Excitation[]} */
export const excitationsOf = (system) => system.excitations ?? inputsOf(system).map(excitationOf);
