// A browser compiles a script while it runs. These drawings, which nobody sees, run while the page rests
// before a hand first moves a slider, so that its first moves are as fast as later ones. Once a page.
import { whileResting } from './slices.js';

/** @import { System, Values } from '../types.d.ts' */

const ROUNDS = 150;

let begun = false;

/**
 * Draws with one of the gains changed a little, in turn.
 * @param {System} system @param {Values} values @param {(values: Values) => void} draw
 */
function* rounds({ running }, values, draw) {
  const gains = Object.keys(running).filter((name) => running[name].magnitudes);
  for (let k = ROUNDS; k > 0; k--) {
    const name = gains[k % gains.length];
    yield draw({ ...values, [name]: values[name] * (1 + 1e-3 * k) });
  }
}

/** @param {System} system @param {Values} values @param {(values: Values) => void} draw */
export function rehearse(system, values, draw) {
  if (!begun) whileResting(rounds(system, values, draw));
  begun = true;
}
