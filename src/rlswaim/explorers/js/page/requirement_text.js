// What is asked of a loop: as a text for the address, zeta_0.1~phase_30, and in words.
import { ASKED } from '../maths/requirements.js';
import { number } from './numbers.js';

/** @import { Requirements } from '../maths/requirements.js' */
/** @typedef {ReturnType<typeof import('../maths/requirements.js').findings>[number]} Found */

/** @param {Requirements} asked */
export const textOfAsked = (asked) =>
  Object.entries(asked)
    .map(([kind, bound]) => `${kind}_${bound}`)
    .join('~');

/** @param {string} kind @param {number} bound */
export const isSensible = (kind, bound) =>
  Object.hasOwn(ASKED, kind) && bound >= ASKED[kind].least && bound <= ASKED[kind].most;

/**
 * What a text asks for, undefined where it makes no sense.
 * @param {string} text
 * @returns {Requirements | undefined}
 */
export function askedFrom(text) {
  if (text === '') return {};
  const parts = text.split('~').map((part) => part.split('_'));
  const isGood = parts.every(
    ([kind, bound, ...more]) => more.length === 0 && bound && isSensible(kind, Number(bound)),
  );
  const asked = Object.fromEntries(parts.map(([kind, bound]) => [kind, Number(bound)]));
  return isGood && Object.keys(asked).length === parts.length ? asked : undefined;
}

/** Why it holds or not. @param {Found} found */
export function foundWords({ kind, found, name, omega, holds }) {
  const { unit } = ASKED[kind];
  const isMargin = kind === 'gain' || kind === 'phase';
  const verdict = holds ? 'holds' : 'does not hold';
  if (isMargin && found === 0) return `${verdict}: the loop is not stable`;
  if (found === Infinity) return `${verdict}: ${isMargin ? 'no frequency limits it' : 'it does not decay'}`;
  const value = `${number(found, 3)}${unit && unit !== '°' ? ` ${unit}` : unit}`;
  const where = name ? ` (${name})` : omega > 0 ? ` at ω ${number(omega, 3)} rad/s` : '';
  return `${verdict}: ${value}${where}`;
}
