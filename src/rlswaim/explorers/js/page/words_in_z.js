// What a workbench says of a loop in discrete time.

import { number } from '../drawing/numbers.js';
import { marginWords } from './locus_words.js';

/** @import { Crossing, Pole } from '../types.d.ts' */
/** @import { Words } from './words_in_s.js' */

/** @param {number} re @param {number} im */
const excess = (re, im) => {
  const off = Math.hypot(re, im) - 1;
  return Math.abs(off) <= 4 * Number.EPSILON ? 0 : off;
};

/** @param {Pole} pole */
const spoken = ({ re, im, name }) =>
  im === 0
    ? `a real root at z = ${number(re)} (from ${name})`
    : `a pair at z = ${number(re)} ± ${number(Math.abs(im))}j (from ${name})`;

/** @param {Pole[]} poles @returns {import('./verdict.js').Verdict} */
function verdict(poles) {
  const [worst] = [...poles].sort((a, b) => Math.hypot(b.re, b.im) - Math.hypot(a.re, a.im));
  const size = `|z| = ${number(Math.hypot(worst.re, worst.im))}`;
  const off = excess(worst.re, worst.im);
  const count = poles.filter((p) => excess(p.re, p.im) > 0).length;
  if (off > 0)
    return {
      kind: 'unstable',
      word: 'Unstable',
      short: `Unstable: ${count} of ${poles.length} roots outside of the unit circle.`,
      long: ` because of ${spoken(worst)}, ${size}: ${count} of ${poles.length} outside of the unit circle.`,
    };
  if (off === 0)
    return {
      kind: 'neutral',
      word: 'Neutrally stable',
      short: 'Neutrally stable: a root lies on the unit circle.',
      long: `: ${spoken(worst)} lies on the unit circle.`,
    };
  return {
    kind: 'stable',
    word: 'Stable',
    short: 'Stable: all roots lie within the unit circle.',
    long: `: all roots lie within the unit circle. The outermost is ${spoken(worst)}, ${size}.`,
  };
}

/** @param {Crossing[]} crossings */
function crossingWords(crossings) {
  const list = crossings.map(
    (c) =>
      `${number(c.gain)} (angle ${number(c.omega)} rad, to the ${c.direction > 0 ? 'outside' : 'inside'})`,
  );
  return list.length
    ? `: unit circle crossed at ${list.join(', ')}.`
    : ': no branch crosses the unit circle.';
}

/** @type {Words['margins']} */
const marginsInZ = (margins, isStable) =>
  marginWords(margins, isStable, (omega) => `angle ${number(omega, 3)} rad`, 'samples');

/**
 * Frequency and damping are those of s with z = e^(sT); without a sampling time T = 1 sample.
 * @param {number | true} dt
 * @returns {Words}
 */
export function wordsInZ(dt) {
  const period = dt === true ? 1 : dt;
  const [unit, plain] =
    dt === true ? ['ω (rad/sample)', 'omega (rad/sample)'] : ['ω (rad/s)', 'omega (rad/s)'];
  return {
    verdict,
    crossings: crossingWords,
    margins: marginsInZ,
    isStable: ({ x, y }) => Array.from(x, (re, i) => excess(re, y[i])).every((off) => off < 0),
    poles: {
      heads: ['real', 'imaginary', unit, 'ζ', 'stability'],
      plain: ['real', 'imaginary', plain, 'zeta', 'stability'],
      motion(re, im) {
        const [decay, turn] = [Math.log(Math.hypot(re, im)), Math.atan2(im, re)];
        const size = Math.hypot(decay, turn);
        return [size / period, -decay / size];
      },
      excess,
    },
  };
}
