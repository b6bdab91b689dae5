// Margins with the names of the modes that they belong to, as marks and in words.

import { number, signed } from '../drawing/numbers.js';
import { nearestFirst } from '../maths/one_margin.js';

/** @import { MarginMark } from '../drawing/frequency_axes.js' */
/** @import { Sample } from '../maths/frequency_response.js' */
/** @import { GainMargin, PhaseMargin } from '../maths/one_margin.js' */
/** @typedef {{ gain: GainMargin[], phase: PhaseMargin[] }} Margins */

const MOST = 3; // margins of a kind that are told

/** @param {Margins} margins */
const ordered = ({ gain, phase }) => ({
  gain: nearestFirst(
    gain.filter(({ omega }) => omega > 0),
    ({ dB }) => dB,
  ),
  phase: nearestFirst(phase, ({ degrees }) => degrees),
});

/**
 * Marks of all margins on the curve; of each kind the nearest governs.
 * @param {Margins | null} margins @param {(omega: number) => Sample} sample
 * @returns {MarginMark[]}
 */
export function marksOfMargins(margins, sample) {
  if (!margins) return [];
  const { gain, phase } = ordered(margins);
  return [
    ...gain.map(({ dB, omega }, k) => ({
      kind: 'gain',
      short: `${signed(dB, 3)} dB`,
      at: sample(omega),
      governs: k === 0,
    })),
    ...phase.map(({ degrees, omega }, k) => ({
      kind: 'phase',
      short: `${signed(degrees, 3)}°`,
      at: sample(omega),
      governs: k === 0,
    })),
  ].filter(({ at }) => Number.isFinite(at.dB));
}

/** The frequencies of all margins, the governing phase margin's first. @param {Margins} margins */
export function crossingsOf(margins) {
  const { gain, phase } = ordered(margins);
  return [...phase, ...gain].map(({ omega }) => omega);
}

/** @param {Sample} sample */
export const sampleWords = ({ omega, dB, degrees }) =>
  `ω ${number(omega, 3)} rad/s: ${signed(dB, 3)} dB, ${number(degrees, 4)}°`;

/**
 * The governing margin of each kind by the name of its mode, then the others.
 * @param {Margins | null} margins @param {boolean} isStable @param {(omega: number) => string} nameOf
 */
export function namedMarginWords(margins, isStable, nameOf) {
  if (!margins) return '';
  if (!isStable) return 'No margins: the closed loop is not stable.';
  const { gain, phase } = ordered(margins);
  /** @param {number} omega */
  const where = (omega) => `${nameOf(omega)}, ω ${number(omega, 3)} rad/s`;
  const gains = gain.map(({ dB, omega }) => `${signed(dB, 3)} dB (${where(omega)})`);
  const phases = phase.map(({ degrees, omega }) => `${signed(degrees, 3)}° (${where(omega)})`);
  const [soonest] = [...phase].sort((a, b) => a.delay - b.delay);
  /** @param {string} kind @param {string[]} all @param {string} without */
  const told = (kind, all, without) => {
    if (all.length === 0) return `${kind} margin: ${without}.`;
    const others = all.length > 1 ? `; then ${all.slice(1, MOST).join(', ')}` : '';
    return `Governing ${kind} margin: ${all[0]}${others}.`;
  };
  const delay = soonest ? ` Delay margin: ${number(soonest.delay, 3)} s (${where(soonest.omega)}).` : '';
  return (
    `${told('phase', phases, 'none, the loop’s size is nowhere 1')} ` +
    `${told('gain', gains, 'none, any gain')}${delay}`
  );
}
