// The closed-loop poles as text: the table of the page, and the same as CSV.
import { digits, element, set } from './dom.js';
import { SIGNS } from '../drawing/s_plane.js';

const HEADS = ['leaves from', 'real (1/s)', 'imaginary (1/s)', 'ω (rad/s)', 'ζ', 'stability'];

const stability = (re) => (re > 0 ? 'unstable' : re < 0 ? 'stable' : 'neutrally stable');

// A cell with eight digits, of which the last three are set back: enough to compare, easy to read.
class Figure {
  constructor() {
    this.parts = [new Text(), new Text(), new Text()];
    this.cell = element(
      'td',
      {},
      this.parts[0],
      element('span', { class: 'fine' }, this.parts[1]),
      this.parts[2],
    );
  }

  show(value) {
    if (value === this.value) return;
    this.value = value;
    const text = Number.isNaN(value) ? '–' : digits(value, 8);
    const end = text.includes('e') ? text.indexOf('e') : text.length;
    const kept = end > 3 ? end - 3 : end;
    [text.slice(0, kept), text.slice(kept, end), text.slice(end)].forEach((part, k) => {
      if (this.parts[k].data !== part) this.parts[k].data = part;
    });
  }
}

export class PoleTable {
  constructor() {
    const head = element('tr', {}, ...HEADS.map((text) => element('th', { scope: 'col' }, text)));
    this.body = element('tbody');
    this.rows = [];
    this.node = element(
      'table',
      { class: 'poles' },
      element('caption', { class: 'unseen' }, 'Closed-loop poles'),
      element('thead', {}, head),
      this.body,
    );
  }

  #newRow() {
    const sign = element('span', { 'aria-hidden': 'true' });
    const name = new Text();
    const figures = Array.from({ length: 4 }, () => new Figure());
    const word = element('td');
    const node = element(
      'tr',
      {},
      element('th', { scope: 'row' }, sign, ' ', name),
      ...figures.map((f) => f.cell),
      word,
    );
    this.body.append(node);
    this.rows.push({ node, sign, name, figures, word });
  }

  show(poles, theme) {
    while (this.rows.length < poles.length) this.#newRow();
    while (this.rows.length > poles.length) this.rows.pop().node.remove();
    poles.forEach(({ re, im, name }, i) => {
      const row = this.rows[i];
      const { color, mark } = theme.branch(name);
      if (row.color !== color) row.sign.style.color = row.color = color;
      set(row.sign, SIGNS[mark]);
      if (row.name.data !== name) row.name.data = name;
      if (row.re === re && row.im === im) return;
      [row.re, row.im] = [re, im];
      Object.assign(row.node.dataset, { re, im, branch: name });
      const size = Math.hypot(re, im);
      [re, im, size, -re / size].forEach((value, k) => row.figures[k].show(value));
      set(row.word, stability(re));
      const kind = re > 0 ? 'unstable' : 'stable';
      if (row.word.className !== kind) row.word.className = kind;
    });
  }
}

export function polesAsText(poles) {
  const rows = poles.map(({ re, im, name }) => {
    const size = Math.hypot(re, im);
    return [name, re, im, size, size ? -re / size : '', stability(re)].join();
  });
  return ['leaves from,real (1/s),imaginary (1/s),omega (rad/s),zeta,stability', ...rows, ''].join('\n');
}
