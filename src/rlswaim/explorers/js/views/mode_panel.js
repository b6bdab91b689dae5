// The vehicle in the mode of one closed-loop pole: rigid and bending motion together, moving, with the share of each.
import { drawBent, STILL } from '../drawing/bent_shape.js';
import { contextOf } from '../drawing/canvas.js';
import { button, complex, element, number, panel, press, select, set } from '../page/dom.js';
import { modeShape } from '../maths/mode_shape.js';

const STRAIGHT = { shares: {}, shape: { re: new Float64Array(421), im: new Float64Array(421) } };
const PERIOD = 2400; // ms of one swing on the page, whatever the mode's own
const COORDINATES = {
  translation: 'rigid-body translation',
  theta: 'rigid-body rotation',
  q1: 'bending mode 1',
  q2: 'bending mode 2',
};

export class ModePanel {
  constructor(bench) {
    this.bench = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'mode' });
    this.list = select('Pole', [], (at) => bench.look({ mode: Number(at) }));
    this.pause = button('Pause', () => this.#toggle(), { 'aria-pressed': 'false' });
    this.shares = element('ul', { class: 'shares' });
    const row = element('div', { class: 'controls' }, this.list.node, this.pause);
    this.panel = panel('mode', 'Mode shape', () => bench.follow(), row, this.canvas, this.shares);
    this.node = this.panel.node;
    this.still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.pause.hidden = this.still;
  }

  #toggle() {
    this.paused = !this.paused;
    press(this.pause, this.paused);
    this.bench.follow();
  }

  draw(width, closed) {
    const { system, desk } = this.bench;
    const pole = this.bench.selected(closed);
    const found = modeShape(system, desk.state, pole);
    this.shown = { width, pole, ...(found ?? STRAIGHT) };
    this.#options(closed);
    this.#tell(pole, found);
    this.#frame(performance.now());
  }

  #options(closed) {
    const { list } = this.list;
    while (list.options.length < closed.x.length) list.add(new Option('', list.options.length));
    closed.branches.forEach((name, i) => {
      const text = `${name}, ${complex(closed.x[i], closed.y[i])}`;
      const option = list.options[i];
      if (option.text !== text) option.text = text;
      if (option.hidden !== closed.y[i] < 0) option.hidden = closed.y[i] < 0;
    });
    if (list.selectedIndex !== this.shown.pole.index) list.selectedIndex = this.shown.pole.index;
  }

  #tell({ re, im }, found) {
    const time = Math.LN2 / Math.abs(re);
    const pace = im ? `period ${number((2 * Math.PI) / Math.abs(im), 3)} s, ` : 'no oscillation, ';
    const end =
      re === 0 ? 'neither grows nor decays' : `${re > 0 ? 'doubles' : 'halves'} every ${number(time, 3)} s`;
    set(this.panel.extra, found ? `${pace}${end}` : 'this pole moves no coordinate of the vehicle');
    const entries = Object.entries(this.shown.shares).sort((a, b) => b[1] - a[1]);
    this.shares.hidden = !found;
    while (this.shares.children.length < entries.length)
      this.shares.append(
        element(
          'li',
          {},
          element('span'),
          element('meter', { min: 0, max: 1, 'aria-hidden': 'true' }),
          element('b'),
        ),
      );
    entries.forEach(([name, share], k) => {
      const [label, meter, text] = this.shares.children[k].children;
      set(label, COORDINATES[name] ?? name);
      meter.value = share;
      set(text, `${(100 * share).toFixed(0)} %`);
    });
  }

  // One picture; the next one follows while the panel is open, on the screen and not paused.
  #frame(now) {
    cancelAnimationFrame(this.next);
    const { width, pole, shape } = this.shown;
    const { theme, system, desk } = this.bench;
    const height = 190;
    const running = !this.still && !this.paused;
    if (running) this.phase = (2 * Math.PI * (now % PERIOD)) / PERIOD;
    const phases = this.still ? STILL : [this.phase ?? 0];
    const marks = [
      { station: system.vehicle.l_CG, label: 'CG' },
      ...system.maps.map((name) => ({ station: desk.state[name], label: name })),
    ];
    this.canvas.style.height = `${height}px`;
    drawBent(
      contextOf(this.canvas, width, height),
      width,
      height,
      theme,
      theme.branch(pole.name).color,
      shape,
      phases,
      marks,
    );
    if (running && this.bench.isSeen(this))
      this.next = requestAnimationFrame((time) => this.bench.isSeen(this) && this.#frame(time));
  }

  later() {
    if (!this.shown) return;
    const { pole, shares } = this.shown;
    const parts = Object.entries(shares).map(
      ([name, share]) => `${COORDINATES[name] ?? name} ${(100 * share).toFixed(0)} %`,
    );
    this.canvas.setAttribute(
      'aria-label',
      `The vehicle in the mode of ${pole.name} at ${complex(pole.re, pole.im)} 1/s: ${parts.join(', ')}`,
    );
  }

  stop() {
    cancelAnimationFrame(this.next);
  }
}
