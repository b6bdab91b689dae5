// The Python that gives the loop of the page, number by number, and its closed-loop roots.

import { linesOfC } from './compensator_python.js';

/** @typedef {import('../reading/loop_text.js').GivenLoop} GivenLoop */
/** @import { Compensator } from '../maths/compensator.js' */

/** As Python writes it: 1e-7, 0.1, -2.0. @param {number} value */
const real = (value) => String(value).replace(/^(-?\d+)$/, '$1.0');

/** @param {[number, number]} value */
const complex = ([re, im]) => (im === 0 ? real(re) : `complex(${real(re)}, ${real(im)})`);

/** @param {readonly any[]} list @param {(value: any) => string} text */
const list = (list, text) => `[${list.map(text).join(', ')}]`;

/** @param {number[][]} rows */
const matrix = (rows) => list(rows, (row) => list(row, real));

/** @param {import('../reading/statements.js').SamplingTime} dt */
const time = (dt) => (dt === true ? 'True' : real(dt));

/** The lines that make `loop`. @param {GivenLoop} given */
export function linesOf(given) {
  const dt = time(given.dt);
  switch (given.form) {
    case 'fraction':
      return [
        'import control',
        '',
        `loop = control.tf(${list(given.num, real)}, ${list(given.den, real)}, ${dt})`,
      ];
    case 'factors': {
      const parts = [list(given.zeros, complex), list(given.poles, complex), real(given.gain)].join(', ');
      if (!given.dt) return [`loop = (${parts})`];
      return ['from scipy.signal import ZerosPolesGain', '', `loop = ZerosPolesGain(${parts}, dt=${dt})`];
    }
    default: {
      const { A, B, C, D } = given;
      const parts = [A, B, C, [[D]]].map(matrix).join(',\n    ');
      return ['import control', '', `loop = control.ss(\n    ${parts},\n    ${dt},\n)`];
    }
  }
}

/** A loop in factors as a system of python-control, which can be put in series. @param {GivenLoop} given */
function systemLines(given) {
  if (given.form !== 'factors') return linesOf(given);
  const parts = [list(given.zeros, complex), list(given.poles, complex), real(given.gain)].join(', ');
  return ['import control', '', `loop = control.zpk(${parts}, ${time(given.dt)})`];
}

/**
 * The lines that put a compensator before the loop.
 * @param {GivenLoop} given @param {Compensator} compensator
 */
const seriesLines = (given, compensator) => [
  ...linesOfC(compensator, given.dt ? `, ${time(given.dt)}` : ''),
  `loop = control.series(${given.form === 'states' ? 'control.ss(C)' : 'C'}, loop)`,
];

/** @param {GivenLoop} given @param {number} k @param {Compensator | null} compensator in the loop */
export const pythonOfLoop = (given, k, compensator) =>
  `${[
    'import rlswaim as rl',
    ...(compensator ? [...systemLines(given), ...seriesLines(given, compensator)] : linesOf(given)),
    '',
    `locus = rl.root_locus(loop, gains=[${real(k)}])`,
    'locus.roots[0], locus.crossings, locus.break_aways',
  ].join('\n')}\n`;
