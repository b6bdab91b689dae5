// What a root locus shows beside its poles, in words: crossings, margins, the roots that the report prints.
import { nearestRoot } from '../drawing/nearest.js';
import { complex, number, signed } from './numbers.js';

/** @import { Crossing, Roots } from '../types.d.ts' */
/** @typedef {{ dB: number, factor: number, omega: number }} GainMargin */
/** @typedef {{ degrees: number, omega: number }} PhaseMargin */

const READ_OFF = 0.05; // of a root's size, at least of .1 1/s: what a plotted locus tells

/** Where the branches cross the imaginary axis, after the name of what runs. @param {Crossing[]} crossings */
export function crossingWords(crossings) {
  const list = crossings.map(
    (c) => `${number(c.gain)} (ω = ${number(c.omega)} rad/s, to the ${c.direction > 0 ? 'right' : 'left'})`,
  );
  return list.length
    ? `: imaginary axis crossed at ${list.join(', ')}.`
    : ': no branch crosses the imaginary axis.';
}

/** @param {{ gain: GainMargin[], phase: PhaseMargin[] } | null} margins */
export function marginWords(margins) {
  if (!margins) return '';
  const gain = margins.gain.map(
    (m) => `${signed(m.dB, 3)} dB (×${number(m.factor, 3)}, ω = ${number(m.omega, 3)} rad/s)`,
  );
  const phase = margins.phase.map((m) => `${signed(m.degrees, 3)}° (ω = ${number(m.omega, 3)} rad/s)`);
  /** @param {string[]} words */
  const list = (words) => (words.length ? words.join(', ') : 'none');
  return `Gain margins: ${list(gain)}. Phase margins: ${list(phase)}.`;
}

/**
 * The report's roots beside those of the loop that is drawn, each with the one nearest to it.
 * @param {{ re: number, im: number, text: string }[]} printed @param {Roots} present
 */
export function printedWords(printed, present) {
  if (printed.length === 0) return '';
  const far = printed.flatMap(({ re, im, text }) => {
    const { index, off } = nearestRoot(present, re, im);
    if (off <= READ_OFF * Math.max(Math.hypot(re, im), 0.1)) return [];
    return [`${text} (nearest here ${complex(present.x[index], present.y[index])})`];
  });
  const count = `Printed roots (+): ${printed.length}, `;
  return far.length
    ? `${count}of which ${far.length} more than a plot’s reading off: ${far.join('; ')}.`
    : `${count}all within a plot’s reading of the roots here.`;
}
