// The panels below the locus; each draws when it is open and on the screen.
import { contextOf } from '../drawing/canvas.js';
import { drawResponses, heightOf, responseWords } from '../drawing/response_charts.js';
import { DURATIONS, GUSTS } from './workbench_state.js';
import { element, number, panel, select, set } from '../page/dom.js';
import { nearestOn } from '../page/pointer.js';
import { poleMapping } from '../maths/locus.js';
import { drawMap } from '../drawing/pole_pictures.js';
import { responses } from '../maths/responses.js';
import { fitted, windowOf } from '../drawing/camera.js';

const SAMPLES = 181;
const INLINE = 0.8; // ms that a map may take in the locus's own frame
const SLICE = 3; // ms at a time for one that takes longer
const REST = 60; // ms until it begins

// The closed-loop poles as a station runs along the vehicle; a click picks the station.
export class MapPanel {
  constructor(bench) {
    this.bench = bench;
    const { system } = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'map' });
    this.list = select(
      'Station of',
      system.maps.map((name, i) => [i, name]),
      (at) => bench.look({ map: Number(at) }),
    );
    this.panel = panel(
      'map',
      'Pole map',
      () => bench.follow(),
      element('div', { class: 'controls' }, this.list.node),
      this.canvas,
    );
    if (system.maps.length < 2) this.list.node.parentNode.hidden = true;
    this.node = this.panel.node;
    this.sides = [];
    this.cost = Infinity;
    this.canvas.addEventListener('click', (event) => this.#pick(event));
  }

  #pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    for (const side of this.sides) {
      const point = nearestOn(side, this.view, px, py, 12);
      if (point)
        return this.bench.put(
          this.bench.desk.station,
          this.bench.desk.place(this.bench.desk.station, point.t),
        );
    }
  }

  // A map that takes its time waits until the hand rests, and is then traced in slices between the frames: it never holds
  // up the locus. Until it is there, the last one stands dimmed.
  draw(width) {
    clearTimeout(this.timer);
    const work = this.#begin(width);
    const quick = this.cost < INLINE && this.#slice(work, INLINE);
    if (!quick) this.timer = setTimeout(() => this.#continue(work), REST);
    this.canvas.classList.toggle('stale', !work.done);
  }

  #begin(width) {
    const { system, desk, closed } = this.bench;
    const height = Math.round(Math.min(0.8 * width, 420));
    const points = Array.from(closed.x, (x, i) => [x, closed.y[i]]).concat(
      system.poles.map((p) => [p.re, p.im]),
    );
    const view = desk.view.camera ? windowOf(desk.view.camera, width, height) : fitted(points, width, height);
    return {
      closed,
      view,
      steps: poleMapping(system, desk.state, closed, view, desk.station),
      cost: 0,
      done: false,
    };
  }

  #continue(work) {
    if (!this.#slice(work, SLICE)) this.timer = setTimeout(() => this.#continue(work));
    this.canvas.classList.toggle('stale', !work.done);
  }

  // Traces on for some time; draws when all is there.
  #slice(work, time) {
    const start = performance.now();
    let spent = 0;
    while (!work.done && spent < time) {
      const { done, value } = work.steps.next();
      spent = performance.now() - start;
      if (done) this.#picture(work, value);
      work.done = done;
    }
    work.cost += spent;
    this.cost = work.done ? work.cost : Infinity; // of one that was given up nobody knows
    return work.done;
  }

  stop() {
    clearTimeout(this.timer);
  }

  #picture({ closed, view }, sides) {
    const { system, desk, theme } = this.bench;
    const { width, height } = view;
    [this.view, this.sides] = [view, sides];
    if (this.height !== height) this.canvas.style.height = `${(this.height = height)}px`;
    drawMap(
      contextOf(this.canvas, width, height),
      this.view,
      theme,
      closed,
      closed.branches,
      this.sides,
      'ft',
    );
    const [from, to] = system.running[desk.station].ends;
    const still = `${number(desk.state[desk.station])} ft`;
    set(
      this.panel.extra,
      this.sides.length
        ? `${desk.station} from ${from} to ${to} ft, filled marks at ${still}`
        : 'no influence: the feedback leaves out the bending',
    );
    this.list.list.value = desk.view.map;
  }

  later(short) {
    const { station, state } = this.bench.desk;
    const ends = this.bench.system.running[station].ends;
    this.canvas.setAttribute(
      'aria-label',
      `Closed-loop poles as the ${station} runs from ${ends.join(' to ')} ft. At ${number(state[station])} ft: ${short}`,
    );
  }
}

export class ResponsePanel {
  constructor(bench) {
    this.bench = bench;
    const { desk } = bench;
    this.canvas = element('canvas', { role: 'img', 'data-plane': 'responses' });
    const number_ = (name) => (value) => bench.look({ [name]: Number(value) });
    this.lists = {
      input: select(
        'After a',
        desk.inputs.map(({ text }, i) => [i, text]),
        number_('input'),
      ),
      gust: select(
        'lasting',
        GUSTS.map((s) => [s, `${s} s`]),
        number_('gust'),
      ),
      duration: select(
        'over',
        DURATIONS.map((s) => [s, `${s} s`]),
        number_('duration'),
      ),
    };
    const row = element('div', { class: 'controls' }, ...Object.values(this.lists).map(({ node }) => node));
    this.panel = panel('responses', 'Responses', () => bench.follow(), row, this.canvas);
    this.node = this.panel.node;
    this.#choices();
  }

  #choices() {
    const { desk } = this.bench;
    for (const [name, { list }] of Object.entries(this.lists))
      if (list.value !== String(desk.view[name])) list.value = desk.view[name];
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
    drawResponses(
      contextOf(this.canvas, width, height),
      width,
      height,
      theme,
      this.times,
      this.found,
      system.units,
    );
    this.#choices();
  }

  later() {
    if (!this.found) return;
    const { desk, system } = this.bench;
    const { text } = desk.inputs[desk.view.input];
    this.canvas.setAttribute(
      'aria-label',
      `Responses over ${desk.view.duration} s after a ${text}. ${responseWords(this.found, system.units)}`,
    );
  }
}

export function legend() {
  const entries = [
    ['×', 'open-loop pole'],
    ['○', 'open-loop zero'],
    ['■ ● ▲ ◆ ▼', 'closed-loop poles, as in the table'],
    ['▸', 'rising gain'],
    ['◇', 'crossing: gain and ω'],
    ['•', 'break-away; in the map, every 100 ft'],
    ['╌', 'a pair whose roots left different poles'],
    ['+', 'printed in the report'],
  ];
  const item = ([sign, meaning]) =>
    element('li', {}, element('span', { 'aria-hidden': 'true' }, sign), ` ${meaning}`);
  return element('ul', { class: 'legend' }, ...entries.map(item));
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
  const list = element(
    'dl',
    {},
    ...HELP.flatMap(([key, meaning]) => [element('dt', {}, key), element('dd', {}, meaning)]),
  );
  return panel('help', 'Keys and gestures', () => {}, list).node;
}
