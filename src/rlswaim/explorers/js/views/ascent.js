// The ascent for other pitch programs: dynamic pressure, altitude and speed against time, beside the printed
// values.
import { contextOf } from '../drawing/context.js';
import { label, line, mark } from '../drawing/marks.js';
import { number, signed } from '../drawing/numbers.js';
import { Plane } from '../drawing/plane.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { flight } from '../maths/flights.js';
import { element, legend, picture, set } from '../page/elements.js';
import { ValueTable } from '../page/value_table.js';
import { simple } from './simple_view.js';

/** @import { Theme, Values } from '../types.d.ts' */
/** @import { Layer } from '../drawing/plane.js' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @typedef {ReturnType<typeof flight>} Flight */

/** @type {Record<string, string[]>} */
const QUANTITIES = {
  q_D: ['dynamic pressure q', 'D', 'lb/ft²'],
  h: ['altitude h', '', 'ft'],
  U: ['speed U', '', 'ft/s'],
};
const DOTTED = [2, 4];

/** @param {number[][][]} table */
const most = (table) => table.flat(2).reduce((a, b) => Math.max(a, b), 0);

/** @param {string} word @param {string} index @param {string} unit */
const historyOf = (word, index, unit) =>
  picture('history', {}, element('b', {}, word, element('sub', {}, index)), ` (${unit})`);

class Ascent {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    this.first = flight(payload, payload.initial);
    this.words = element('p', { class: 'verdict' });
    const { t } = payload.printed;
    this.table = new ValueTable(`At ${t} s`, ['', 'here', 'in the report', 'off by (%)']);
    this.pictures = Object.entries(QUANTITIES).map(([name, [word, index, unit]]) => ({
      name,
      top: 1.05 * most(payload.curves[name]),
      ...historyOf(word, index, unit),
    }));
    this.program = historyOf('pitch program γ', '0', 'deg');
    this.canvases = [...this.pictures.map(({ canvas }) => canvas), this.program.canvas];
    const figures = [...this.pictures, this.program].map(({ figure }) => figure);
    this.nodes = [
      this.words,
      element('div', { class: 'planes' }, ...figures),
      legend([
        ['━', 'this program'],
        ['┄', 'the book’s program'],
        ['◆', `printed, at ${t} s`],
        ['▲', 'largest dynamic pressure'],
      ]),
      element('p', {}, this.#accuracy()),
      this.table.node,
    ];
  }

  #accuracy() {
    const { nodes, accuracy } = this.payload;
    const [U, h, q_D] = ['U', 'h', 'q_D'].map((name) => number(accuracy[name], 2));
    return (
      `Between the ${nodes.upright.length * nodes.level.length} programs that are flown ahead the curves ` +
      `are straight-line means, off by at most ${U} ft/s, ${h} ft and ${q_D} lb/ft².`
    );
  }

  /** @param {HTMLCanvasElement} canvas @param {number} top @param {Lifecycle} page @param {Layer[]} layers */
  #chart(canvas, top, page, layers) {
    const [width, height] = page.sizeOf(canvas);
    const view = viewOf([0, this.payload.times.at(-1)], [0, top], frameOf(width, height), width, height);
    new Plane(contextOf(canvas, width, height), view, page.theme).chart('time (s)', '', layers);
  }

  /** @param {Theme} theme @param {Flight['peak']} peak @returns {Layer[]} */
  #peak(theme, { time, size }) {
    const foot = [
      [time, 0],
      [time, size],
    ];
    const [dx, align] = time > 60 ? [-9, 'right'] : [9, 'left'];
    return [
      line(foot, theme.axis, 1, [4, 4]),
      mark('▲', time, size, theme.color('corrected')),
      label(`${number(time, 3)} s`, time, size, dx, -8, theme.ink, align),
    ];
  }

  /** @param {Flight} found @param {Lifecycle} page */
  #drawHistories(found, page) {
    const { times, printed } = this.payload;
    const { theme } = page;
    /** @param {number[]} curve */
    const points = (curve) => curve.map((v, k) => [times[k], v]);
    for (const { name, top, canvas } of this.pictures) {
      this.#chart(canvas, top, page, [
        line(points(this.first.curves[name]), theme.color('neutral'), 1.5, DOTTED),
        line(points(found.curves[name]), theme.color('rigid')),
        ...(name === 'q_D' ? this.#peak(theme, found.peak) : []),
        mark('◆', printed.t, printed[name], theme.ink, 4),
      ]);
      const [word, index, unit] = QUANTITIES[name];
      const there = `${number(found.there[name])} ${unit} at ${printed.t} s`;
      canvas.ariaLabel = `${word}${index} against time: ${there}, printed ${number(printed[name])}.`;
    }
  }

  /** @param {Values} values @param {string} told @param {Lifecycle} page */
  #drawProgram(values, told, page) {
    const { initial, times } = this.payload;
    /** @param {Values} program */
    const points = ({ upright, level }) => [
      [0, 90],
      [upright, 90],
      [level, 0],
      [Math.max(level, times.at(-1)), 0],
    ];
    this.#chart(this.program.canvas, 95, page, [
      line(points(initial), page.theme.color('neutral'), 1.5, DOTTED),
      line(points(values), page.theme.color('rigid')),
    ]);
    this.program.canvas.ariaLabel = `Flight path angle against time: ${told}.`;
  }

  /** @param {Flight} found */
  #tell({ there, peak }) {
    const { printed } = this.payload;
    /** @param {string} name @param {number} value @param {number} wanted */
    const cells = (name, value, wanted) => [
      name,
      number(value),
      number(wanted),
      signed(100 * (value / wanted - 1), 3),
    ];
    const rows = Object.entries(QUANTITIES).map(([name, [word, index, unit]]) => ({
      cells: cells(`${word}${index} (${unit})`, there[name], printed[name]),
      data: { quantity: name, value: there[name] },
    }));
    const { time, size } = peak;
    const largest = cells('largest qD (lb/ft²)', size, printed.q_D);
    this.table.show([...rows, { cells: largest, data: { quantity: 'peak', value: size, time } }]);
  }

  /** @param {Values} values @param {Lifecycle} page */
  draw(values, page) {
    const found = flight(this.payload, /** @type {any} */ (values));
    const told = `Vertical until ${number(values.upright)} s, level at ${number(values.level)} s`;
    this.#drawHistories(found, page);
    this.#drawProgram(values, told, page);
    this.#tell(found);
    const { printed } = this.payload;
    const said =
      `${told}: the largest dynamic pressure, ${number(found.peak.size)} lb/ft², comes at ` +
      `${number(found.peak.time, 3)} s; the report has ${number(printed.q_D)} at ${printed.t} s.`;
    set(this.words, said);
    return said;
  }
}

export const render = simple(Ascent);
