// Poles as text: the table of the page, and the same as CSV.

import { digits } from '../drawing/numbers.js';
import { element, headRow, set } from './elements.js';
import { asText } from './take_away.js';

/** @import { Pole, Theme, Values } from '../types.d.ts' */

/**
 * What a table says of a pole: heads of the columns; frequency and damping; the excess over the border of
 * stability, whose sign decides.
 * @typedef {{ heads: string[], plain: string[], motion: (re: number, im: number) => [number, number],
 *   excess: (re: number, im: number) => number }} PoleWords
 */

/** @type {PoleWords} */
export const POLES_IN_S = {
  heads: ['real (1/s)', 'imaginary (1/s)', 'ω (rad/s)', 'ζ', 'stability'],
  plain: ['real (1/s)', 'imaginary (1/s)', 'omega (rad/s)', 'zeta', 'stability'],
  motion: (re, im) => [Math.hypot(re, im), -re / Math.hypot(re, im)],
  excess: (re) => re,
};

/** @param {number} excess */
const stability = (excess) => (excess > 0 ? 'unstable' : excess < 0 ? 'stable' : 'neutrally stable');

/** A cell with eight digits, of which the last three are set back: enough to compare, easy to read. */
class Figure {
  constructor() {
    this.parts = [new Text(), new Text(), new Text()];
    const [first, fine, power] = this.parts;
    this.cell = element('td', {}, first, element('span', { class: 'fine' }, fine), power);
    /** @type {number} */
    this.value = undefined;
  }

  /** @param {number} value */
  show(value) {
    if (value === this.value) return;
    this.value = value;
    const text = digits(value, 8);
    const end = text.includes('e') ? text.indexOf('e') : text.length;
    const kept = end > 3 ? end - 3 : end;
    [text.slice(0, kept), text.slice(kept, end), text.slice(end)].forEach((part, k) => {
      if (this.parts[k].data !== part) this.parts[k].data = part;
    });
  }
}

class Row {
  constructor() {
    this.sign = element('span', { 'aria-hidden': 'true' });
    this.name = new Text();
    this.figures = Array.from({ length: 4 }, () => new Figure());
    this.word = element('td');
    const cells = this.figures.map(({ cell }) => cell);
    const head = element('th', { scope: 'row' }, this.sign, ' ', this.name);
    this.node = element('tr', {}, head, ...cells, this.word);
    this.color = '';
    /** @type {PoleWords} */
    this.words = undefined;
    /** @type {Pole} */
    this.pole = { re: NaN, im: NaN, name: '' };
  }

  /** @param {Pole} pole @param {Theme} theme @param {PoleWords} words */
  show({ re, im, name }, theme, words) {
    const color = theme.color(name);
    if (this.color !== color) {
      this.color = color;
      this.sign.style.color = color;
    }
    set(this.sign, theme.sign(name));
    if (this.name.data !== name) this.name.data = name;
    if (this.pole.re === re && this.pole.im === im && this.words === words) return;
    this.words = words;
    this.pole = { re, im, name };
    Object.assign(this.node.dataset, { re, im, branch: name });
    [re, im, ...words.motion(re, im)].forEach((value, k) => {
      this.figures[k].show(value);
    });
    const excess = words.excess(re, im);
    set(this.word, stability(excess));
    const kind = excess > 0 ? 'unstable' : 'stable';
    if (this.word.className !== kind) this.word.className = kind;
  }
}

export class PoleTable {
  /** @param {Element} caption @param {string} head of the first column */
  constructor(caption, head) {
    this.body = element('tbody');
    /** @type {Row[]} */
    this.rows = [];
    this.words = POLES_IN_S;
    this.node = element(
      'table',
      { class: 'poles' },
      caption,
      headRow([head, ...this.words.heads]),
      this.body,
    );
  }

  /** @param {Pole[]} poles @param {Theme} theme @param {PoleWords} words */
  show(poles, theme, words = POLES_IN_S) {
    if (this.words !== words) {
      this.words = words;
      words.heads.forEach((text, k) => {
        set(this.node.tHead.rows[0].cells[k + 1], text);
      });
    }
    while (this.rows.length < poles.length) {
      const row = new Row();
      this.body.append(row.node);
      this.rows.push(row);
    }
    while (this.rows.length > poles.length) this.rows.pop().node.remove();
    poles.forEach((pole, i) => {
      this.rows[i].show(pole, theme, words);
    });
  }
}

/** @param {Pole[]} poles @param {Values} values of the parameters @param {PoleWords} words */
export function polesAsText(poles, values, words = POLES_IN_S) {
  const rows = poles.map(({ re, im, name }) => {
    const [omega, zeta] = words.motion(re, im);
    return [name, re, im, omega, Number.isNaN(zeta) ? '' : zeta, stability(words.excess(re, im))];
  });
  return asText(['leaves from', ...words.plain], rows, values);
}
