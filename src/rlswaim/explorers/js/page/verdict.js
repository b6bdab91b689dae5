// Is the system stable, and why: in words, on a line of the page.
import { nearestRoot } from '../drawing/nearest.js';
import { number } from '../drawing/numbers.js';
import { element, set } from './elements.js';

/** @import { Pole } from '../types.d.ts' */
/** @typedef {{ kind: string, word: string, short: string, long: string }} Verdict */

/** A root and its mirror image, with the poles that both left. @param {Pole} pole @param {Pole[]} poles */
function spoken({ re, im, name }, poles) {
  const at = `${re > 0 ? '+' : ''}${number(re)}`;
  if (im === 0) return `a real root at ${at} 1/s (from ${name})`;
  const roots = { x: poles.map((p) => p.re), y: poles.map((p) => p.im) };
  const twin = poles[nearestRoot(roots, re, -im).index].name;
  return `a pair at ${at} ± ${number(im)}j 1/s (from ${twin === name ? twin : `${name} and ${twin}`})`;
}

/** The time in which a motion doubles or halves. @param {number} re 1/s */
export const pace = (re) => `${re > 0 ? 'doubles' : 'halves'} every ${number(Math.LN2 / Math.abs(re), 3)} s`;

/** @param {Pole[]} poles @param {string} but what the words leave out, said where all the rest decays */
export function verdict(poles, but = '') {
  const upper = poles.filter((p) => p.im >= 0).sort((a, b) => b.re - a.re);
  const [worst, ...others] = upper;
  const told = spoken(worst, poles);
  const slow = pace(worst.re);
  if (worst.re > 0) {
    const count = poles.filter((p) => p.re > 0).length;
    const also = others.filter((p) => p.re > 0).map((p) => spoken(p, poles));
    const lie = `${count} of ${poles.length} roots ${count > 1 ? 'lie' : 'lies'}`;
    const rest = also.length ? ` Also right of the axis: ${also.join('; ')}.` : '';
    return {
      kind: 'unstable',
      word: 'Unstable',
      short: `Unstable: ${lie} right of the imaginary axis.`,
      long: ` because of ${told}: its motion ${slow}.${rest}`,
    };
  }
  if (worst.re === 0)
    return {
      kind: 'neutral',
      word: 'Neutrally stable',
      short: 'Neutrally stable: a root lies on the imaginary axis.',
      long: `: ${but}${told} neither grows nor decays.`,
    };
  return {
    kind: 'stable',
    word: 'Stable',
    short: 'Stable: all roots lie left of the imaginary axis.',
    long: `: ${but}all roots lie left of the imaginary axis. The slowest is ${told}; its motion ${slow}.`,
  };
}

/** The line of a view that says so. */
export class VerdictLine {
  constructor() {
    this.word = element('b');
    this.reason = element('span');
    this.node = element('p', { class: 'verdict' }, this.word, this.reason);
  }

  /** @param {Pick<Verdict, 'kind' | 'word' | 'long'>} verdict */
  show({ kind, word, long }) {
    set(this.word, word);
    set(this.reason, long);
    if (this.word.className !== kind) this.word.className = kind;
  }
}
