// What a root locus shows beside its poles, in words: crossings, margins, the roots that the report prints.
import { nearestRoot } from '../drawing/nearest.js';
import { complex, number, signed } from '../drawing/numbers.js';
import { nearestFirst } from '../maths/one_margin.js';
import { element, set, symbol } from './elements.js';

/** @import { Crossing, Roots } from '../types.d.ts' */
/** @import { GainMargin, PhaseMargin } from '../maths/one_margin.js' */

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

/** A frequency in continuous time. @param {number} omega */
const inSeconds = (omega) => `ω = ${number(omega, 3)} rad/s`;

/**
 * The margins of a stable loop, phase and delay at the front, and of each kind those that are used up first;
 * an unstable loop has none.
 * @param {{ gain: GainMargin[], phase: PhaseMargin[] } | null} margins
 * @param {boolean} isStable
 * @param {(omega: number) => string} [at] a frequency in words @param {string} [unit] of a delay
 */
export function marginWords(margins, isStable, at = inSeconds, unit = 's') {
  if (!margins) return '';
  if (!isStable) return 'Phase margins: none, as this loop is not stable. Gain margins: none.';
  const phase = nearestFirst(margins.phase, ({ degrees }) => degrees).map(
    (m) => `${signed(m.degrees, 3)}° (${at(m.omega)})`,
  );
  const gain = nearestFirst(margins.gain, ({ dB }) => dB).map(
    (m) => `${signed(m.dB, 3)} dB (×${number(m.factor, 3)}, ${at(m.omega)})`,
  );
  const delays = margins.phase.map(({ delay }) => delay);
  const delay = delays.length ? ` Delay margin: ${number(Math.min(...delays), 3)} ${unit}.` : '';
  return (
    `Phase margins: ${phase.join(', ') || 'the loop’s size is nowhere 1'}.${delay} ` +
    `Gain margins: ${gain.join(', ') || 'no crossing, any gain'}.`
  );
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

/** The line of a view that says so, after the name of what runs. */
export class LocusLine {
  constructor() {
    this.running = '';
    this.name = element('span');
    this.words = [element('span'), element('span'), element('span')];
    const spaced = this.words.flatMap((word, i) => (i ? [' ', word] : [word]));
    this.node = element('p', { class: 'crossings' }, this.name, ...spaced);
  }

  /** @param {string} running @param {[crossings: string, margins: string, printed: string]} texts */
  show(running, texts) {
    if (this.running !== running) {
      this.running = running;
      this.name.replaceChildren(...symbol(running));
    }
    this.words.forEach((word, i) => {
      set(word, texts[i]);
    });
  }
}
