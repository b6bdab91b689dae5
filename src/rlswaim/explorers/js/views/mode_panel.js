// The vehicle in the mode of one closed-loop pole: rigid and bending motion together, moving, with the share
// of each.
import { drawBent, STILL_PHASES } from '../drawing/bent_shape.js';
import { contextOf } from '../drawing/context.js';
import { complex, number } from '../drawing/numbers.js';
import { modeShape } from '../maths/mode_shape.js';
import { button, element, panel, picture, press, select, set } from '../page/elements.js';
import { pace } from '../page/verdict.js';

/** @import { NamedRoots } from '../types.d.ts' */
/** @import { Shape } from '../drawing/bent_shape.js' */
/** @import { Selected, Workbench } from './workbench.js' */
/** @typedef {{ width: number, pole: Selected, shares: Record<string, number>, shape: Shape }} Shown */

const STRAIGHT = { shares: {}, shape: { re: new Float64Array(421), im: new Float64Array(421) } };
const HEIGHT = 190;
const PERIOD = 2400; // ms of one swing on the page, whatever the mode's own
/** @type {Record<string, string>} */
const COORDINATES = {
  translation: 'rigid-body translation',
  theta: 'rigid-body rotation',
  q1: 'bending mode 1',
  q2: 'bending mode 2',
};

/** @param {number} share */
const percent = (share) => `${(100 * share).toFixed(0)} %`;

class ShareRow {
  constructor() {
    this.label = element('span');
    this.meter = element('meter', { min: 0, max: 1, 'aria-hidden': 'true' });
    this.text = element('b');
    this.node = element('li', {}, this.label, this.meter, this.text);
  }

  /** @param {string} name @param {number} share */
  show(name, share) {
    set(this.label, COORDINATES[name] ?? name);
    this.meter.value = share;
    set(this.text, percent(share));
  }
}

export class ModePanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.canvas = picture('mode', {}).canvas;
    this.list = select('Pole', [], (at) => bench.look({ mode: Number(at) }));
    this.pause = button('Pause', () => this.#toggle(), { 'aria-pressed': 'false' });
    this.shares = element('ul', { class: 'shares' });
    /** @type {ShareRow[]} */
    this.rows = [];
    const row = element('div', { class: 'controls' }, this.list.node, this.pause);
    this.panel = panel('mode', 'Mode shape', () => bench.page.follow(), row, this.canvas, this.shares);
    this.node = this.panel.node;
    this.still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.pause.hidden = this.still;
    this.paused = false;
    this.phase = 0;
    this.next = 0;
    /** @type {Shown | null} */
    this.shown = null;
  }

  #toggle() {
    this.paused = !this.paused;
    press(this.pause, this.paused);
    this.bench.page.follow();
  }

  /** @param {number} width @param {NamedRoots} closed */
  draw(width, closed) {
    const { system, state } = this.bench;
    const pole = this.bench.selected(closed);
    const found = modeShape(system, state.values, pole);
    this.shown = { width, pole, ...(found ?? STRAIGHT) };
    this.#options(closed, pole.index);
    this.#tell(pole, Boolean(found));
    this.#frame(performance.now());
  }

  /** The poles above the axis to choose from. @param {NamedRoots} closed @param {number} selected */
  #options({ x, y, branches }, selected) {
    const { list } = this.list;
    while (list.options.length < x.length) list.add(new Option('', String(list.options.length)));
    branches.forEach((name, i) => {
      const text = `${name}, ${complex(x[i], y[i])}`;
      const option = list.options[i];
      if (option.text !== text) option.text = text;
      if (option.hidden !== y[i] < 0) option.hidden = y[i] < 0;
    });
    if (list.selectedIndex !== selected) list.selectedIndex = selected;
  }

  /** @param {Selected} pole @param {boolean} moves */
  #tell({ re, im }, moves) {
    const period = im ? `period ${number((2 * Math.PI) / Math.abs(im), 3)} s, ` : 'no oscillation, ';
    const end = re === 0 ? 'neither grows nor decays' : pace(re);
    set(this.panel.extra, moves ? `${period}${end}` : 'this pole moves no coordinate of the vehicle');
    const entries = Object.entries(this.shown.shares).sort((a, b) => b[1] - a[1]);
    this.shares.hidden = !moves;
    while (this.rows.length < entries.length) {
      const row = new ShareRow();
      this.shares.append(row.node);
      this.rows.push(row);
    }
    entries.forEach(([name, share], k) => {
      this.rows[k].show(name, share);
    });
  }

  /**
   * One picture; the next one follows while the panel is open, on the screen and not paused.
   * @param {number} now ms
   */
  #frame(now) {
    cancelAnimationFrame(this.next);
    const { width, pole, shape } = this.shown;
    const { page, system, state } = this.bench;
    const running = !this.still && !this.paused;
    if (running) this.phase = (2 * Math.PI * (now % PERIOD)) / PERIOD;
    const phases = this.still ? STILL_PHASES : [this.phase];
    const marks = [
      { station: system.vehicle.l_CG, label: 'CG' },
      ...system.maps
        .filter((/** @type {string} */ name) => system.running[name].unit === 'ft')
        .map((/** @type {string} */ name) => ({ station: state.values[name], label: name })),
    ];
    this.canvas.style.height = `${HEIGHT}px`;
    const color = page.theme.color(pole.name);
    drawBent(contextOf(this.canvas, width, HEIGHT), width, HEIGHT, page.theme, color, shape, phases, marks);
    if (running && this.bench.isSeen(this))
      this.next = requestAnimationFrame((time) => this.bench.isSeen(this) && this.#frame(time));
  }

  /** Words that may lag a little behind the picture. */
  later() {
    if (!this.shown) return;
    const { pole, shares } = this.shown;
    const parts = Object.entries(shares).map(
      ([name, share]) => `${COORDINATES[name] ?? name} ${percent(share)}`,
    );
    const at = `${pole.name} at ${complex(pole.re, pole.im)} 1/s`;
    this.canvas.ariaLabel = `The vehicle in the mode of ${at}: ${parts.join(', ')}`;
  }

  stop() {
    cancelAnimationFrame(this.next);
  }
}
