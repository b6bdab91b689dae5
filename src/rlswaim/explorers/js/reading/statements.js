// What a text says apart from its formulas: name = value, a call tf(...), the sampling time, lines that
// programs print around a system.
import { LoopError, quoted } from './loop_error.js';
import { realFrom } from './numbers.js';

/** @typedef {number | true} SamplingTime 0 in continuous time; true where it is not told */

const TOLD =
  String.raw`(?:Inputs|Outputs|States) \(\d+\):|Continuous-time |Discrete-time |Name:|Model Properties|` +
  String.raw`Sample time:|import |from \w+ import |[%#]`;
const AROUND = new RegExp(String.raw`^\s*(?:<\w+>:|${TOLD}).*$`, 'gm');
const CALLS = /(?:[A-Za-z]\w*\.)?\b(tf|TransferFunction|zpk|ZerosPolesGain|ss|StateSpace)\s*\(/;

/** A text with one kind of minus, of power sign, of product sign and of space. @param {string} text */
export function plainText(text) {
  const raised = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return text
    .replace(/[−–]/g, '-')
    .replace(/[·×]/g, '*')
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, (power) => `^${[...power].map((c) => raised.indexOf(c)).join('')}`)
    .replace(/\r\n?/g, '\n')
    .replace(/[\t\u00a0\u2009]/g, ' ');
}

/** A text without the lines that programs print around a system. @param {string} text */
export const withoutSurroundings = (text) => text.replace(AROUND, '');

/** @param {string} text @param {string} where @returns {SamplingTime} */
export function samplingTime(text, where = 'dt') {
  const plain = text.trim().replace(/ ?(?:s|sec|seconds?)$/, '');
  if (/^(?:true|unspecified|-1)$/i.test(plain)) return true;
  if (/^(?:none|false)$/i.test(plain)) return 0;
  const value = realFrom(plain, where);
  if (value < 0) throw new LoopError(where, quoted(text), '0 (continuous), a time above 0, or True');
  return value;
}

/** What MATLAB says of the sampling time: undefined if nothing. @param {string} text */
export function toldTime(text) {
  const told = /^\s*Sample time: *([^\n.]*(?:\.\d+)?[^\n.]*)\.?$/m.exec(text);
  if (told) return samplingTime(told[1], 'sample time');
  return /^\s*Discrete-time /m.test(text) ? /** @type {const} */ (true) : undefined;
}

/** The place of the bracket that closes the one at a place. @param {string} text @param {number} open */
function closingBracket(text, open) {
  let depth = 0;
  for (let i = open; i < text.length; i++) {
    if ('([{'.includes(text[i])) depth++;
    else if (')]}'.includes(text[i]) && --depth === 0) return i;
  }
  throw new LoopError('brackets', quoted(text.slice(open)), 'one that closes each');
}

/**
 * The parts of a text between separators outside of all brackets.
 * @param {string} text @param {string} separators
 */
export function partsOf(text, separators) {
  const parts = [''];
  let depth = 0;
  for (const letter of text) {
    if ('([{'.includes(letter)) depth++;
    if (')]}'.includes(letter)) depth--;
    if (depth === 0 && separators.includes(letter)) parts.push('');
    else parts[parts.length - 1] += letter;
  }
  return parts;
}

/**
 * What is assigned to each name: all up to the next name = outside of brackets.
 * @param {string} text
 * @returns {Map<string, string>}
 */
export function assignments(text) {
  /** @type {Map<string, string>} */
  const found = new Map();
  /** @type {{ name: string, at: number, from: number }[]} */
  const starts = [];
  let depth = 0;
  const name = /([A-Za-z]\w*)\s*(?:=(?!=)|:(?!:))\s*/y;
  for (let i = 0; i < text.length; i++) {
    if ('([{'.includes(text[i])) depth++;
    else if (')]}'.includes(text[i])) depth--;
    else if (depth === 0 && /[A-Za-z]/.test(text[i]) && !/\w/.test(text[i - 1] ?? ' ')) {
      name.lastIndex = i;
      const match = name.exec(text);
      if (match) starts.push({ name: match[1], at: i, from: name.lastIndex });
    }
  }
  starts.forEach(({ name: key, from }, i) => {
    found.set(
      key,
      text
        .slice(from, starts[i + 1]?.at)
        .trim()
        .replace(/[;,]+$/, '')
        .trim(),
    );
  });
  return found;
}

/**
 * The call of tf, zpk or ss in a text, with its arguments: those without a name in order, and by name.
 * @param {string} text
 * @returns {{ kind: string, ordered: string[], named: Record<string, string> } | null}
 */
export function callIn(text) {
  const found = CALLS.exec(text);
  if (!found) return null;
  const open = found.index + found[0].length - 1;
  const inner = text.slice(open + 1, closingBracket(text, open));
  /** @type {Record<string, string>} */
  const named = {};
  const ordered = [];
  for (const part of partsOf(inner, ',').map((each) => each.trim())) {
    const [, name, value] = /^([A-Za-z]\w*)\s*=([\s\S]*)$/.exec(part) ?? [];
    if (name) named[name] = value.trim();
    else if (part) ordered.push(part);
  }
  const kinds = { TransferFunction: 'tf', ZerosPolesGain: 'zpk', StateSpace: 'ss' };
  return { kind: kinds[/** @type {keyof typeof kinds} */ (found[1])] ?? found[1], ordered, named };
}
