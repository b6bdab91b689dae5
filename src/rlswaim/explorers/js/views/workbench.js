// The workbench: one control system under its sliders, with its root locus, its poles, and panels that look
// at them.
import { nearestRoot } from '../drawing/nearest.js';
import { closedLoop } from '../maths/closed_loop.js';
import { margins } from '../maths/margins.js';
import { withCompensator } from '../page/compensator_words.js';
import {
  button,
  element,
  group,
  legend,
  panel,
  press,
  scrolling,
  select,
  set,
  symbol,
} from '../page/elements.js';
import { Lifecycle } from '../page/lifecycle.js';
import { crossingWords, marginWords, printedWords } from '../page/locus_words.js';
import { PoleTable } from '../page/pole_table.js';
import { rehearse } from '../page/rehearsal.js';
import { VerdictLine, verdict } from '../page/verdict.js';
import { CompensatorPanel } from './compensator_panel.js';
import { FrequencyPanel } from './frequency_panel.js';
import { helpPanel } from './help_panel.js';
import { LocusPlane } from './locus_plane.js';
import { MapPanel } from './map_panel.js';
import { ModePanel } from './mode_panel.js';
import { RequirementPanel } from './requirement_panel.js';
import { ResponsePanel } from './response_panel.js';
import { TakeAway } from './take_away_panel.js';
import { WorkbenchState } from './workbench_state.js';

/** @import { Context, Model, NamedRoots, Pole, System, Values } from '../types.d.ts' */
/** @import { Verdict } from '../page/verdict.js' */
/** @import { Shown } from './workbench_state.js' */
/** @typedef {Pole & { index: number }} Selected */
/**
 * @typedef {{ canvas: HTMLCanvasElement, node: HTMLDetailsElement }} Part a panel that draws while it is seen
 */

const MAGNIFY = [1, 3, 10, 100, 1000, 10000];
/** What the signs of the planes mean. @param {System} system @returns {[string, string][]} */
const signsOf = ({ running, maps }) => [
  ['×', 'open-loop pole'],
  ['○', 'open-loop zero'],
  ['■ ● ▲ ◆ ▼', 'closed-loop poles, as in the table'],
  ['▸', 'rising gain'],
  ['◇', 'crossing: gain and ω'],
  ['•', `break-away; in the map, every 100 ${running[maps[0]].unit}`],
  ['╌', 'a pair whose roots left different poles'],
  ['+', 'printed in the report'],
];

export class Workbench {
  /** @param {Model} model @param {HTMLElement} el */
  constructor(model, el) {
    this.state = new WorkbenchState(model);
    /** @type {System} */
    this.system = this.state.system;
    this.plane = new LocusPlane(this);
    this.map = new MapPanel(this);
    this.responses = new ResponsePanel(this);
    this.mode = new ModePanel(this);
    this.frequency = new FrequencyPanel(this);
    this.compensator = new CompensatorPanel(this);
    this.requirements = new RequirementPanel(this);
    this.takeAway = new TakeAway(this);
    this.verdictLine = new VerdictLine();
    this.table = new PoleTable(element('caption', { class: 'unseen' }, 'Closed-loop poles'), 'leaves from');
    this.signs = legend(signsOf(this.system));
    this.locusWords = {
      running: element('span'),
      crossings: element('span'),
      margins: element('span'),
      printed: element('span'),
    };
    this.named = '';
    this.parts = [this.frequency, this.map, this.responses, ...(this.system.vehicle ? [this.mode] : [])];
    this.seen = new Map(this.parts.map(({ canvas }) => [canvas, true]));
    this.page = new Lifecycle(el, this.system.system, {
      state: this.state,
      colors: withCompensator(this.system.branches),
      canvases: [this.plane.canvas, ...this.seen.keys()],
      draw: () => this.#draw(),
      later: () => this.#later(),
      arrived: (texts) => {
        if ('view.mode' in texts) this.mode.node.open = Boolean(this.system.vehicle);
        if ('view.frequency' in texts) this.frequency.node.open = true;
        if ('view.compensator' in texts) this.compensator.node.open = true;
        if ('view.requirements' in texts) this.requirements.node.open = true;
      },
      stop: () => this.#end(),
    });
    this.#build(el);
    this.#watch();
  }

  /** @param {HTMLElement} el */
  #build(el) {
    const { running, crossings, margins, printed } = this.locusWords;
    const poles = panel('poles', 'Closed-loop poles', () => {}, scrolling('pole table', this.table.node));
    for (const { node } of [poles, this.map, this.responses]) node.open = true;
    const panels = [poles, this.compensator, this.requirements, ...this.parts, this.takeAway].map(
      ({ node }) => node,
    );
    el.append(
      this.#presets(),
      this.#bar(),
      this.verdictLine.node,
      this.page.live,
      this.plane.node,
      element('p', { class: 'crossings' }, running, crossings, ' ', margins, ' ', printed),
      this.signs,
      element('div', { class: 'panels' }, ...panels, helpPanel()),
    );
  }

  #presets() {
    this.designs = this.system.presets.map(({ name, label, note }, i) =>
      button(name, () => this.#choose(i), { title: [label, note].filter(Boolean).join(': ') }),
    );
    const reset = button('Reset', () => {
      this.state.reset();
      this.page.changed();
    });
    return group('buttons', 'Designs', element('span', {}, 'Designs'), ...this.designs, reset);
  }

  /** @param {number} preset */
  #choose(preset) {
    Object.assign(this.state.shown, { locus: this.state.locusOf(preset), printed: preset, camera: null });
    this.state.set(this.system.presets[preset].values);
    this.page.changed();
  }

  #bar() {
    /** @type {[string, string][]} */
    const loci = this.state.loci.map(({ key, text }) => [key, text]);
    this.loci = select('Locus in', loci, (locus) => this.look({ locus, camera: null }));
    /** @type {[number, string][]} */
    const sizes = MAGNIFY.map((m) => [m, m === 1 ? 'as it is' : `×${m.toLocaleString('en')} inset`]);
    this.inset = select('Origin', sizes, (m) => {
      this.state.set({ magnify: Number(m) });
      this.page.changed();
    });
    const { link, said } = this.takeAway;
    const steps = element('span', { class: 'steps' }, ...this.page.history.buttons, link, said);
    return element('div', { class: 'bar' }, this.loci.node, this.inset.node, steps);
  }

  #watch() {
    this.watch = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries)
          this.seen.set(/** @type {HTMLCanvasElement} */ (target), isIntersecting);
        if (entries.some(({ isIntersecting }) => isIntersecting)) this.page.follow();
      },
      { rootMargin: '120px' },
    );
    for (const canvas of this.seen.keys()) this.watch.observe(canvas);
  }

  #end() {
    this.watch.disconnect();
    this.plane.stop();
    this.mode.stop();
    this.map.stop();
  }

  // What the parts of the workbench ask for.

  /** Shows something else of the same system. @param {Partial<Shown>} shown */
  look(shown) {
    Object.assign(this.state.shown, shown);
    this.page.changed();
  }

  /** @param {string} name @param {number} value */
  put(name, value) {
    this.state.set({ [name]: value });
  }

  /** Shows the mode of the pole at re + j im. @param {number} re @param {number} im */
  openMode(re, im) {
    const { index, off } = nearestRoot(this.closed, re, im);
    if (off > 1e-5 * Math.hypot(re, im) + 1e-9)
      return this.takeAway.say('another loop is open here: not a pole of the whole system');
    if (!this.system.vehicle) return;
    this.mode.node.open = true;
    this.look({ mode: index });
  }

  /**
   * The closed-loop pole whose mode is shown; none while the panel is closed.
   * @param {NamedRoots} closed
   * @returns {Selected | null}
   */
  selected({ x, y, branches }) {
    if (!this.mode.node.open) return null;
    const index = Math.min(this.state.shown.mode, x.length - 1);
    return { index, re: x[index], im: y[index], name: branches[index] };
  }

  /** @param {Part} part */
  isSeen({ node, canvas }) {
    return node.open && this.seen.get(canvas);
  }

  #draw() {
    const { state, page } = this;
    const { values } = state;
    const system = state.inLoop;
    this.system = system;
    /** @type {NamedRoots} */
    this.closed = closedLoop(system, values);
    const { x, y, branches } = this.closed;
    /** @type {Pole[]} */
    this.poles = branches.map((name, i) => ({ re: x[i], im: y[i], name }));
    const [width, height] = page.sizeOf(this.plane.canvas);
    this.plane.draw(width, height, this.closed);
    for (const part of this.parts)
      if (this.isSeen(part)) part.draw(page.sizeOf(part.canvas)[0] || width, this.closed);
    this.#tell(values);
    rehearse(system, values, (other) => this.plane.rehearse(other));
    return this.verdict.short;
  }

  /** @param {Values} values */
  #tell(values) {
    const { state, system } = this;
    const { running } = state.what;
    const { locus, extra } = this.plane;
    /** @type {Verdict} */
    this.verdict = verdict(this.poles);
    this.verdictLine.show(this.verdict);
    this.table.show(this.poles, this.page.theme);
    const words = this.locusWords;
    if (this.named !== running) {
      this.named = running;
      words.running.replaceChildren(...symbol(running));
    }
    set(words.crossings, crossingWords(locus.crossings));
    set(
      words.margins,
      marginWords(
        margins(system, values, state.what),
        Array.from(locus.present.x).every((x) => x < 0),
      ),
    );
    set(words.printed, printedWords(/** @type {any} */ (extra.printed), locus.present));
    const { path } = system.presets[state.shown.printed] ?? {};
    const sign = /** @type {Text} */ (this.signs.lastChild.lastChild);
    const meaning = ` printed in the report${path ? ` (${path})` : ''}`;
    if (sign.data !== meaning) sign.data = meaning;
    this.designs.forEach((design, i) => {
      press(design, state.isDesign(i));
    });
    this.loci.choose(state.shown.locus);
    this.inset.choose(state.magnify);
    this.compensator.show();
    this.requirements.show();
  }

  /** Words that may lag a little behind the pictures. */
  #later() {
    const { word, long, short } = this.verdict;
    this.plane.later(`${word.toLowerCase()}${long}`);
    this.map.later(short);
    this.responses.later();
    this.frequency.later();
    if (this.system.vehicle) this.mode.later();
    this.takeAway.later();
  }
}

/** @param {Context} context */
export const render = ({ model, el }) => new Workbench(model, el).page.stop;
