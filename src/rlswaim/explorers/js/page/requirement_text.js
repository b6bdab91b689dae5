// What is asked of a loop: as a text for the address, zeta_0.1~phase_30, and in words.

import { number } from '../drawing/numbers.js';
import { ASKED } from '../maths/requirements.js';

/** @import { Requirements } from '../maths/requirements.js' */
/** @typedef {ReturnType<typeof import('../maths/requirements.js').findings>[number]} Found */

/** @param {Requirements} asked */
export const textOfAsked = (asked) =>
  Object.entries(asked)
    .map(([kind, bound]) => `${kind}_${bound}`)
    .join('~');

/** May it be asked for of a loop in z, or in s? @param {string} kind @param {boolean} isDiscrete */
export const isOffered = (kind, isDiscrete) =>
  (ASKED[kind].in ?? (isDiscrete ? 'z' : 's')) === (isDiscrete ? 'z' : 's');

/** @param {string} kind @param {number} bound @param {boolean} isDiscrete */
export const isSensible = (kind, bound, isDiscrete) =>
  Object.hasOwn(ASKED, kind) &&
  isOffered(kind, isDiscrete) &&
  bound >= ASKED[kind].least &&
  bound <= ASKED[kind].most;

/** The unit of a kind. @param {string} kind @param {number | boolean} dt true: no sampling time is told */
export function unitOf(kind, dt) {
  const { unit } = ASKED[kind];
  return dt === true && unit === 's' ? 'samples' : unit;
}

/**
 * What a text asks for, undefined where it makes no sense.
 * @param {string} text @param {boolean} isDiscrete
 * @returns {Requirements | undefined}
 */
export function askedFrom(text, isDiscrete = false) {
  if (text === '') return {};
  const parts = text.split('~').map((part) => part.split('_'));
  const isGood = parts.every(
    ([kind, bound, ...more]) => more.length === 0 && bound && isSensible(kind, Number(bound), isDiscrete),
  );
  const asked = Object.fromEntries(parts.map(([kind, bound]) => [kind, Number(bound)]));
  return isGood && Object.keys(asked).length === parts.length ? asked : undefined;
}

/** Why it holds or not. @param {Found} found @param {number | boolean} [dt] true: no sampling time is told */
export function foundWords({ kind, found, name, omega, holds }, dt = 0) {
  const unit = unitOf(kind, dt);
  const isMargin = kind === 'gain' || kind === 'phase';
  const verdict = holds ? 'holds' : 'does not hold';
  if (isMargin && found === 0) return `${verdict}: the loop is not stable`;
  if (found === Infinity) return `${verdict}: ${isMargin ? 'no frequency limits it' : 'it does not decay'}`;
  const value = `${number(found, 3)}${unit && unit !== '°' ? ` ${unit}` : unit}`;
  const each = dt === true ? 'sample' : 's';
  const where = name ? ` (${name})` : omega > 0 ? ` at ω ${number(omega, 3)} rad/${each}` : '';
  return `${verdict}: ${value}${where}`;
}
