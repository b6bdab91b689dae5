// The panels below the locus; each draws when it is open and on the screen.
import { drawBent, STILL } from './bent.js';
import { drawResponses, heightOf, responseWords } from './charts.js';
import { DURATIONS, GUSTS } from './desk.js';
import { button, complex, element, number, panel, press, select, set } from './dom.js';
import { nearestOn } from './interact.js';
import { poleMap } from './locus.js';
import { modeShape } from './modes.js';
import { contextOf } from './picture.js';
import { drawMap } from './planes.js';
import { responses } from './response.js';
import { fitted, seen } from './window.js';

const SAMPLES = 181;
const INLINE = 2.5; // ms that a map may take in the locus's own frame
const REST = 80; // ms

// The closed-loop poles as a station runs along the vehicle; a click picks the station.
export class MapPanel {
  constructor(bench) {
    this.bench = bench;
    const { system } = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'map' });
    this.list = select('Station of', system.maps.map((name, i) => [i, name]), (at) => bench.look({ map: Number(at) }));
    this.panel = panel('map', 'Pole map', () => bench.schedule(), element('div', { class: 'controls' }, this.list.node), this.canvas);
    if (system.maps.length < 2) this.list.node.parentNode.hidden = true;
    this.node = this.panel.node;
    this.canvas.addEventListener('click', (event) => this.#pick(event));
  }

  #pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    for (const side of this.sides) {
      const point = nearestOn(side, this.view, px, py, 12);
      if (point) return this.bench.put(this.bench.desk.station, this.bench.desk.place(this.bench.desk.station, point.t));
    }
  }

  // A map that takes its time waits until the hand rests, so that it never holds up the locus.
  draw(width) {
    clearTimeout(this.timer);
    const slow = this.cost > INLINE;
    this.canvas.classList.toggle('stale', slow);
    if (slow) this.timer = setTimeout(() => this.#trace(width), REST);
    else this.#trace(width);
  }

  #trace(width) {
    const start = performance.now();
    this.#picture(width, this.bench.closed);
    this.cost = performance.now() - start;
    this.canvas.classList.remove('stale');
  }

  stop() {
    clearTimeout(this.timer);
  }

  #picture(width, closed) {
    const { system, desk, theme } = this.bench;
    const height = Math.round(Math.min(0.8 * width, 420));
    const points = Array.from(closed.x, (x, i) => [x, closed.y[i]]).concat(system.poles.map((p) => [p.re, p.im]));
    this.view = desk.view.camera ? seen(desk.view.camera, width, height) : fitted(points, width, height);
    this.sides = poleMap(system, desk.state, closed, this.view, desk.station);
    this.canvas.style.height = `${height}px`;
    drawMap(contextOf(this.canvas, width, height), this.view, theme, closed, closed.branches, this.sides, 'ft');
    const [from, to] = system.running[desk.station].ends;
    const still = `${number(desk.state[desk.station])} ft`;
    set(this.panel.extra, this.sides.length ? `${desk.station} from ${from} to ${to} ft, filled marks at ${still}` : 'no influence: the feedback leaves out the bending');
    this.list.list.value = desk.view.map;
  }

  later(short) {
    const { station, state } = this.bench.desk;
    const ends = this.bench.system.running[station].ends;
    this.canvas.setAttribute('aria-label', `Closed-loop poles as the ${station} runs from ${ends.join(' to ')} ft. At ${number(state[station])} ft: ${short}`);
  }
}

export class ResponsePanel {
  constructor(bench) {
    this.bench = bench;
    const { desk } = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'responses' });
    const number_ = (name) => (value) => bench.look({ [name]: Number(value) });
    this.lists = {
      input: select('After a', desk.inputs.map(({ text }, i) => [i, text]), number_('input')),
      gust: select('lasting', GUSTS.map((s) => [s, `${s} s`]), number_('gust')),
      duration: select('over', DURATIONS.map((s) => [s, `${s} s`]), number_('duration')),
    };
    const row = element('div', { class: 'controls' }, ...Object.values(this.lists).map(({ node }) => node));
    this.panel = panel('responses', 'Responses', () => bench.schedule(), row, this.canvas);
    this.node = this.panel.node;
    this.#choices();
  }

  #choices() {
    const { desk } = this.bench;
    for (const [name, { list }] of Object.entries(this.lists)) if (list.value !== String(desk.view[name])) list.value = desk.view[name];
    this.lists.gust.node.hidden = desk.response.kind !== 'gust';
  }

  draw(width) {
    const { system, desk, theme } = this.bench;
    const { duration } = desk.view;
    if (this.duration !== duration) {
      this.duration = duration;
      this.times = Float64Array.from({ length: SAMPLES }, (_, k) => (duration * k) / (SAMPLES - 1));
    }
    this.found = responses(system, desk.state, desk.response, this.times);
    const height = heightOf(width, Object.keys(this.found).length);
    if (this.height !== height) this.canvas.style.height = `${(this.height = height)}px`;
    drawResponses(contextOf(this.canvas, width, height), width, height, theme, this.times, this.found, system.units);
    this.#choices();
  }

  later() {
    if (!this.found) return;
    const { desk, system } = this.bench;
    const { text } = desk.inputs[desk.view.input];
    this.canvas.setAttribute('aria-label', `Responses over ${desk.view.duration} s after a ${text}. ${responseWords(this.found, system.units)}`);
  }
}

const STRAIGHT = { shares: {}, shape: { re: new Float64Array(421), im: new Float64Array(421) } };
const PERIOD = 2400; // ms of one swing on the page, whatever the mode's own
const COORDINATES = { translation: 'rigid-body translation', theta: 'rigid-body rotation', q1: 'bending mode 1', q2: 'bending mode 2' };

export class ModePanel {
  constructor(bench) {
    this.bench = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'mode' });
    this.list = select('Pole', [], (at) => bench.look({ mode: Number(at) }));
    this.pause = button('Pause', () => this.#toggle(), { 'aria-pressed': 'false' });
    this.shares = element('ul', { class: 'shares' });
    const row = element('div', { class: 'controls' }, this.list.node, this.pause);
    this.panel = panel('mode', 'Mode shape', () => bench.schedule(), row, this.canvas, this.shares);
    this.node = this.panel.node;
    this.still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.pause.hidden = this.still;
  }

  #toggle() {
    this.paused = !this.paused;
    press(this.pause, this.paused);
    this.bench.schedule();
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
    const end = re === 0 ? 'neither grows nor decays' : `${re > 0 ? 'doubles' : 'halves'} every ${number(time, 3)} s`;
    set(this.panel.extra, found ? `${pace}${end}` : 'this pole moves no coordinate of the vehicle');
    const entries = Object.entries(this.shown.shares).sort((a, b) => b[1] - a[1]);
    this.shares.hidden = !found;
    while (this.shares.children.length < entries.length) this.shares.append(element('li', {}, element('span'), element('meter', { min: 0, max: 1 }), element('b')));
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
    const marks = system.maps.map((name) => ({ station: desk.state[name], label: name }));
    this.canvas.style.height = `${height}px`;
    drawBent(contextOf(this.canvas, width, height), width, height, theme, theme.branch(pole.name).color, shape, phases, marks);
    if (running && this.bench.isSeen(this)) this.next = requestAnimationFrame((time) => this.bench.isSeen(this) && this.#frame(time));
  }

  later() {
    if (!this.shown) return;
    const { pole, shares } = this.shown;
    const parts = Object.entries(shares).map(([name, share]) => `${COORDINATES[name] ?? name} ${(100 * share).toFixed(0)} %`);
    this.canvas.setAttribute('aria-label', `The vehicle in the mode of ${pole.name} at ${complex(pole.re, pole.im)} 1/s: ${parts.join(', ')}`);
  }

  stop() {
    cancelAnimationFrame(this.next);
  }
}

const HELP = [
  ['drag a filled mark', 'move a closed-loop pole along its locus: the slider follows'],
  ['click the locus', 'set the running parameter; hover reads gain, ω and ζ'],
  ['click a filled mark, or Enter on it', 'show its mode shape along the vehicle'],
  ['click the pole map', 'pick the station'],
  ['wheel, pinch, + and −', 'zoom'],
  ['drag the plane, Shift + arrows', 'pan'],
  ['double click, 0', 'fit the window again'],
  ['Tab', 'from the plane to each pole'],
  ['arrows, Page Up, Page Down', 'on the plane or a pole: step the running parameter'],
  ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
];

export function helpPanel() {
  const list = element('dl', {}, ...HELP.flatMap(([key, meaning]) => [element('dt', {}, key), element('dd', {}, meaning)]));
  return panel('help', 'Keys and gestures', () => {}, list).node;
}

