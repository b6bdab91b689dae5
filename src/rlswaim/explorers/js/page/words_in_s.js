// What a workbench says of a loop in continuous time.
import { crossingWords, marginWords } from './locus_words.js';
import { POLES_IN_S } from './pole_table.js';
import { verdict } from './verdict.js';

/** @import { Crossing, Pole, Roots } from '../types.d.ts' */
/** @import { GainMargin, PhaseMargin } from '../maths/one_margin.js' */
/** @import { PoleWords } from './pole_table.js' */
/** @import { Verdict } from './verdict.js' */
/** @typedef {{ gain: GainMargin[], phase: PhaseMargin[] }} Margins */
/**
 * @typedef {object} Words
 * @property {(poles: Pole[]) => Verdict} verdict
 * @property {(crossings: Crossing[]) => string} crossings
 * @property {(margins: Margins | null, isStable: boolean) => string} margins
 * @property {(roots: Roots) => boolean} isStable
 * @property {PoleWords} poles
 */

/** @type {Words} */
export const IN_S = {
  verdict,
  crossings: crossingWords,
  margins: marginWords,
  isStable: ({ x }) => Array.from(x).every((re) => re < 0),
  poles: POLES_IN_S,
};
