// What an address says of a view: the values that can be shown, and words for what was changed or left out.
import { number } from '../drawing/numbers.js';

/** @import { Parameter } from '../types.d.ts' */
/** @typedef {{ value?: number | string, note?: string }} Found a value, none without sense, and words */

const LONGEST = 40; // characters of a text from elsewhere that are shown

// Nearer to 0 than this, times the largest place of its slider, a value moves no root by a digit; but its
// product with a few others might be too small for a number.
const SMALLEST = 1e-60;

/** Where a value comes from, in words. */
const ADDRESS = 'from the address';

/** @param {string} name @param {string} why @param {string} [origin] */
export const leftOut = (name, why, origin = ADDRESS) =>
  `${name.slice(0, LONGEST)} ${origin} is ${why} and is left out.`;

/**
 * The value of a parameter: a choice, a whole number where its slider has only such, else any number between
 * the ends of its slider.
 * @param {Parameter} parameter @param {string} text @param {string} [origin] where it comes from
 * @returns {Found}
 */
export function valueFrom({ name, grid }, text, origin = ADDRESS) {
  if (typeof grid[0] === 'string')
    return grid.includes(text) ? { value: text } : { note: leftOut(name, 'not one of its choices', origin) };
  const value = text.trim() === '' ? NaN : Number(text);
  if (Number.isNaN(value)) return { note: leftOut(name, 'not a number', origin) };
  const isWhole = !Number.isFinite(value) || Number.isInteger(value);
  if (!isWhole && grid.every(Number.isInteger)) return { note: leftOut(name, 'not a whole number', origin) };
  const [first, last] = [grid[0], grid.at(-1)];
  const bounded = Math.min(Math.max(value, first), last);
  if (bounded !== 0 && Math.abs(bounded) < SMALLEST * Math.max(-first, last))
    return { value: 0, note: `${name} ${origin} is too small to tell from 0: 0 is shown.` };
  if (bounded === value) return { value };
  const range = `${number(first)} to ${number(last)}`;
  const note = `${name} ${origin} is beyond its range ${range}: ${number(bounded)} is shown.`;
  return { value: bounded, note };
}

/**
 * The values of parameters that an address names, and the notes on them.
 * @param {Parameter[]} parameters @param {Record<string, string>} texts
 */
export function valuesFrom(parameters, texts) {
  const named = parameters.filter(({ name }) => name in texts);
  const found = named.map((parameter) => ({ parameter, ...valueFrom(parameter, texts[parameter.name]) }));
  const kept = found.filter(({ value }) => value !== undefined);
  return {
    values: Object.fromEntries(kept.map(({ parameter, value }) => [parameter.name, value])),
    notes: found.flatMap(({ note }) => (note ? [note] : [])),
  };
}

/** @param {string[]} names from an address @param {string[]} known */
export const unknownNames = (names, known) =>
  names.filter((name) => !known.includes(name)).map((name) => leftOut(name, 'not known here'));
