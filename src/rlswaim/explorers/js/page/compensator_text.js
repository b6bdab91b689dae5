// A compensator as a text for the address: K_A~1.2~notch_20_0.1_0.6~delay_0.05_3.
import { KINDS, kindsOf, MOST, ordersOf } from '../maths/compensator.js';

/** @import { Compensator, Section } from '../maths/compensator.js' */

const LARGEST = 1e4; // of its gain, either way

/** @param {Compensator | null} compensator */
export function textOf(compensator) {
  if (!compensator) return '';
  const { place, gain, sections } = compensator;
  const parts = sections.map(({ kind, values }) => [kind, ...values].join('_'));
  return [place, gain, ...parts].join('~');
}

/** A number as it is written, not a blank. @param {string} text */
const numberOf = (text) => (/^[-+.\d][-+.\de]*$/i.test(text) ? Number(text) : NaN);

/**
 * A number as its kind takes it: within the bounds, whole where it is a count.
 * @param {string} kind @param {number} k which of its numbers @param {number} value
 */
export function bounded(kind, k, value) {
  const { least, most } = KINDS[kind];
  const within = Math.min(Math.max(value, least[k]), most[k]);
  return KINDS[kind].snap?.(k, within) ?? within;
}

/** @param {string} text @param {string[]} kinds @returns {Section | undefined} */
function sectionFrom(text, kinds) {
  const [kind, ...rest] = text.split('_');
  if (!kinds.includes(kind) || rest.length !== KINDS[kind].names.length) return undefined;
  const values = rest.map(numberOf);
  return values.every((v, k) => v === bounded(kind, k, v)) ? { kind, values } : undefined;
}

/** Are they few enough to be drawn at once? @param {Section[]} sections */
export function isSmall(sections) {
  const { zeros, poles } = ordersOf(sections);
  return sections.length <= MOST.sections && Math.max(zeros, poles) <= MOST.order;
}

/**
 * What a text says, undefined where it makes no sense.
 * @param {string} text @param {string[]} places the gains that a compensator may go with
 * @param {string[]} kinds of sections that it may have
 * @returns {Compensator | undefined}
 */
export function compensatorFrom(text, places, kinds = kindsOf(false)) {
  const [place, gain, ...parts] = text.split('~');
  if (!places.includes(place) || gain === undefined || parts.length > MOST.sections) return undefined;
  const sections = parts.map((part) => sectionFrom(part, kinds));
  const size = numberOf(gain);
  const isSane = Math.abs(size) <= LARGEST && Math.abs(size) >= 1 / LARGEST;
  if (!isSane || sections.includes(undefined) || !isSmall(sections)) return undefined;
  return { place, gain: size, sections };
}
