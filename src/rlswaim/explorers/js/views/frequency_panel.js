// The loop that the locus closes, cut open: its Bode, Nichols and Nyquist diagrams, linked with each other
// and with the locus. Dragged up or down, the curve sets the running gain.
import { contextOf } from '../drawing/context.js';
import { sampleOf } from '../drawing/frequency_axes.js';
import { boxesOf, drawFrequencies, heightOfBoxes, placed } from '../drawing/frequency_pictures.js';
import { curveAt, frequencyAt } from '../drawing/frequency_spots.js';
import { number } from '../drawing/numbers.js';
import { cutLoop, cutMargins } from '../maths/cut_loop.js';
import { frequencyResponse, sampleAt } from '../maths/frequency_response.js';
import { modeAt, modesOf } from '../maths/loop_modes.js';
import { button, element, panel, picture, select, set } from '../page/elements.js';
import { crossingsOf, marksOfMargins, namedMarginWords, sampleWords } from '../page/margin_names.js';
import { movable, movableByKeys } from '../page/movable_point.js';
import { download, fileName, svgOf } from '../page/take_away.js';
import { AxisSpot } from './axis_spot.js';

/** @import { Graphics } from '../types.d.ts' */
/** @import { Frequencies } from '../drawing/frequency_axes.js' */
/** @import { Placed } from '../drawing/frequency_pictures.js' */
/** @import { CutLoop } from '../maths/cut_loop.js' */
/** @import { Sample } from '../maths/frequency_response.js' */
/** @import { Workbench } from './workbench.js' */

/** @type {[string, string][]} */
export const PICTURES = [
  ['bode', 'Bode'],
  ['nichols', 'Nichols'],
  ['nyquist', 'Nyquist'],
  ['all', 'all three'],
];
/** @type {[number, string][]} */
const REACHES = [0.5, 1, 2.5, 5, 10, 25, 100].map((reach) => [reach, `±${reach}`]);
const KEYS_HELP = 'Up and down step the running gain, left and right the marked frequency.';

export class FrequencyPanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.height = 0;
    this.reach = 2.5;
    this.marked = NaN; // rad/s
    /** @type {Placed[]} */
    this.pictures = [];
    this.canvas = picture('frequency', {
      role: 'application',
      tabindex: '0',
      'aria-description': KEYS_HELP,
    }).canvas;
    this.kinds = select('Show', PICTURES, (frequency) => bench.look({ frequency }));
    this.reaches = select('Nyquist', REACHES, (reach) => {
      this.reach = Number(reach);
      bench.page.follow();
    });
    this.reaches.choose(this.reach);
    this.stage = element('div', { class: 'over' }, this.canvas);
    this.readout = element('span', { class: 'reading' });
    this.words = element('p', { class: 'told' });
    const save = button('Picture (SVG)', () => this.#save());
    const row = element('div', { class: 'controls' }, this.kinds.node, this.reaches.node, save, this.readout);
    const title = 'Frequency response';
    this.panel = panel('frequency', title, () => bench.page.follow(), row, this.stage, this.words);
    this.node = this.panel.node;
    this.spot = new AxisSpot(bench.plane, (omega) => this.#mark(omega));
    this.node.addEventListener('toggle', () => this.spot.listen(this.node.open));
    this.#listen();
  }

  #listen() {
    const nothing = () => {};
    const hover = (/** @type {number[]} */ ...[px, py]) =>
      this.#mark(px === undefined ? NaN : frequencyAt(this.pictures, this.frequencies, px, py));
    const ground = { pan: nothing, hold: nothing, zoom: nothing, fit: nothing, hover };
    /** @type {import('../page/movable_point.js').MovablePoint} */
    const point = {
      grab: (px, py, reach) => this.#grab(px, py, reach),
      drag: (_, px, py) => this.#drag(px, py),
      drop: () => this.bench.page.history.settle(),
      click: (px, py) => this.#mark(frequencyAt(this.pictures, this.frequencies, px, py)),
      step: (right, up) => this.#step(right, up),
    };
    movable(this.canvas, point, ground);
    this.canvas.addEventListener('pointerleave', () => this.#mark(NaN));
    movableByKeys(this.canvas, point);
  }

  /** @param {number} px @param {number} py @param {number} reach */
  #grab(px, py, reach) {
    this.held = this.frequencies ? curveAt(this.pictures, this.frequencies, px, py, reach) : null;
    this.heldGain = this.cut?.gain;
    return this.held ? 0 : -1;
  }

  /** The held point of the curve goes up or down with the gain. @param {number} px @param {number} py */
  #drag(px, py) {
    const { state } = this.bench;
    const factor = this.held.factor(px, py);
    const { running } = this.cut;
    const { grid } = state.parameters.find(({ name }) => name === running);
    const gain = Math.min(Math.max(this.heldGain * factor, grid[0]), grid.at(-1));
    if (Number.isFinite(gain) && gain !== 0) this.bench.put(running, state.place(running, gain));
  }

  /** @param {number} right @param {number} up */
  #step(right, up) {
    if (up) {
      const { running } = this.cut;
      this.bench.put(running, this.bench.state.stepped(running, up));
      return;
    }
    if (!this.frequencies) return;
    const { omega } = this.frequencies.curve;
    const at = omega.findIndex((w) => w >= this.marked);
    const next = at < 0 ? omega.length >> 1 : at + right;
    this.#mark(omega[Math.min(Math.max(next, 0), omega.length - 1)]);
  }

  /** Marks a frequency in all pictures and on the locus. @param {number} omega rad/s, NaN for none */
  #mark(omega) {
    if (omega === this.marked || (Number.isNaN(omega) && Number.isNaN(this.marked))) return;
    this.marked = omega;
    if (!this.frequencies) return;
    this.frequencies.marked = this.#markedSample();
    this.#paint(contextOf(this.canvas, this.width, this.height));
    this.#tellMarked();
  }

  /** @returns {Sample | null} */
  #markedSample() {
    if (!(this.marked > 0)) return null;
    const sample = sampleAt(this.cut, this.frequencies.curve, this.marked);
    return Number.isFinite(sample.dB) ? sample : null;
  }

  #tellMarked() {
    const { marked } = this.frequencies;
    set(this.readout, marked ? sampleWords(marked) : '');
    this.spot.show(marked, this.cut.period);
  }

  /** @returns {Frequencies | null} */
  #compute() {
    const { system, state } = this.bench;
    /** @type {CutLoop} */
    this.cut = cutLoop(system, state.values, state.what);
    const { gain: k, poles } = this.cut;
    const { gain = 0, phase = 0 } = state.asked;
    const found = cutMargins(this.cut);
    if (k === 0 || !(this.cut.parts.gain !== 0)) return null;
    const modes = modesOf(poles);
    const curve = frequencyResponse(this.cut, found ? crossingsOf(found) : []);
    if (curve.omega.length < 2) return null;
    const modeOf = Array.from(curve.omega, (omega) => modeAt(modes, omega));
    const lobes = modes.flatMap((mode) => {
      const its = modeOf.flatMap((other, k) => (other === mode ? [k] : []));
      const top = its.reduce((best, k) => (curve.dB[k] > curve.dB[best] ? k : best), its[0]);
      return its.length ? [{ mode, at: sampleOf(curve, top) }] : [];
    });
    this.modes = modes;
    const marks = this.cut.isStable ? marksOfMargins(found, (omega) => sampleAt(this.cut, curve, omega)) : [];
    this.margins = found;
    return { curve, modeOf, lobes, margins: marks, marked: null, asked: { gain, phase } };
  }

  /** @param {number} width */
  draw(width) {
    const { state, page } = this.bench;
    const { frequency } = state.shown;
    this.frequencies = this.#compute();
    const boxes = boxesOf(frequency, width);
    const height = heightOfBoxes(boxes);
    if (this.height !== height) {
      this.height = height;
      this.canvas.style.height = `${height}px`;
    }
    this.width = width;
    this.kinds.choose(frequency);
    this.reaches.node.hidden = frequency === 'bode' || frequency === 'nichols';
    const { running, gain } = this.cut;
    set(this.panel.extra, `loop cut at ${running} = ${number(gain)}`);
    const { frequencies } = this;
    this.pictures = frequencies ? boxes.map((box) => placed(box, frequencies, this.reach)) : [];
    if (frequencies) frequencies.marked = this.#markedSample();
    const g = contextOf(this.canvas, width, height);
    g.clearRect(0, 0, width, height);
    this.#paint(g);
    if (frequencies) this.#tellMarked();
    set(this.words, this.#margins());
    this.canvas.style.color = page.theme.ink;
  }

  /** @param {Graphics} g */
  #paint(g) {
    if (this.frequencies) drawFrequencies(g, this.pictures, this.bench.page.theme, this.frequencies);
  }

  #margins() {
    const { running, gain } = this.cut;
    if (!this.frequencies)
      return `${running} = ${number(gain)}: nothing is fed back, so there is no loop to cut.`;
    const rest = this.bench.system.loop ? 'rest' : 'rigid body';
    return namedMarginWords(
      this.margins,
      this.cut.isStable,
      (omega) => modeAt(this.modes, omega)?.name ?? rest,
    );
  }

  /** The view of the Bode diagram's size, if it is shown. */
  get bode() {
    return this.node.open ? this.pictures.find(({ kind }) => kind === 'bode')?.views[0] : undefined;
  }

  #title() {
    const { running, gain } = this.cut;
    const [, name] = PICTURES.find(([kind]) => kind === this.bench.state.shown.frequency);
    const kind = name === 'all three' ? 'Bode, Nichols and Nyquist diagrams' : `${name} diagram`;
    return `${kind} of the loop cut at ${running} = ${number(gain)}`;
  }

  #save() {
    const { system, state, page } = this.bench;
    const name = fileName(system.system, state.values, 'frequency.svg');
    const title = `${this.#title()}. ${this.#margins()}`;
    const text = svgOf(this.width, this.height, title, page.theme.plane, (g) => this.#paint(g));
    download(name, 'image/svg+xml', text);
  }

  /** Words that may lag a little behind the picture. */
  later() {
    if (!this.cut) return;
    const tops = (this.frequencies?.lobes ?? []).map(({ mode, at }) => `${mode.name}: ${sampleWords(at)}`);
    const lobes = tops.length ? ` Lobes: ${tops.join('; ')}.` : '';
    this.canvas.ariaLabel = `${this.#title()}. ${this.#margins()}${lobes}`;
  }
}
