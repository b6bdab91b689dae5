// Numbers as people and programs write them: 1, −2.5, .5, 1e-3, 1.2×10^3 is none; 2j, 1+2i, (3-1j).
import { LoopError, quoted } from './loop_error.js';

/** @typedef {import('../maths/polynomials.js').Complex} Complex */

export const UNSIGNED = String.raw`(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?`;
const PART = new RegExp(String.raw`^([+-]?)\s*(${UNSIGNED})?\s*\*?\s*([ij])?$`);
const SUM = new RegExp(String.raw`^([+-]?\s*(?:${UNSIGNED})?)\s*([+-]\s*(?:${UNSIGNED})?\s*\*?\s*[ij])$`);
const MOST = 1e60;
const LEAST = 1e-60;

/** @param {number} value @param {string} where @param {string} text */
export function bounded(value, where, text) {
  if (value !== 0 && !(Math.abs(value) <= MOST && Math.abs(value) >= LEAST))
    throw new LoopError(where, quoted(text), '0, or a size from 1e-60 to 1e60');
  return value;
}

/** @param {string} text @param {string} where @returns {Complex} */
export function complexFrom(text, where) {
  const plain = text
    .trim()
    .replace(/^\((.*)\)$/, '$1')
    .trim();
  const both = SUM.exec(plain);
  if (both?.[1].trim()) return [onePart(both[1], where, text)[0], onePart(both[2], where, text)[1]];
  return onePart(plain, where, text);
}

/** @param {string} text @param {string} where @param {string} whole @returns {Complex} */
function onePart(text, where, whole) {
  const [, sign, digits, unit] = PART.exec(text.trim()) ?? [];
  if (digits === undefined && unit === undefined) throw new LoopError(where, quoted(whole), 'a number');
  const size = bounded(Number(digits ?? 1), where, whole) * (sign === '-' ? -1 : 1);
  return unit ? [0, size] : [size, 0];
}

/** @param {string} text @param {string} where */
export function realFrom(text, where) {
  const [re, im] = complexFrom(text, where);
  if (im !== 0) throw new LoopError(where, quoted(text), 'a real number');
  return re;
}
