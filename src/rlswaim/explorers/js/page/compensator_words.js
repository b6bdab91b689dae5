// A compensator in short words.

import { complex, number } from '../drawing/numbers.js';
import { BRANCH } from '../maths/compensated.js';
import { KINDS } from '../maths/compensator.js';

/** @import { Compensator } from '../maths/compensator.js' */

/** @param {Compensator} compensator */
export function ratioWords({ place, gain, sections }) {
  const parts = sections.map(
    ({ kind, values }) => `${KINDS[kind].text.toLowerCase()} ${values.map((v) => number(v)).join(', ')}`,
  );
  return [`with ${place}`, ...(gain === 1 ? [] : [`gain ${number(gain)}`]), ...parts].join(' · ');
}

/** Where a root of it is. @param {number} re @param {number} im @param {boolean} isDiscrete */
export const placeWords = (re, im, isDiscrete) =>
  isDiscrete ? `z = ${complex(re, im)}` : `${complex(re, im)} 1/s, ω ${number(Math.hypot(re, im), 3)} rad/s`;

const COLORS = ['#E69F00', '#009E73'];

/** The colors of a system's branches, and one that none of them has for those of a compensator.
 * @param {Record<string, string>} branches
 */
export const withCompensator = (branches) => ({
  ...branches,
  [BRANCH]: COLORS.find((color) => !Object.values(branches).includes(color)) ?? COLORS[0],
});
