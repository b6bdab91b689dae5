// The workbench: one control system under its sliders, with its root locus, its poles, and panels that look
// at them.
import { nearestRoot } from '../drawing/nearest.js';
import { closedLoop } from '../maths/closed_loop.js';
import { margins } from '../maths/margins.js';
import { withCompensator } from '../page/compensator_words.js';
import { button, element, group, legend, panel, press, scrolling, select } from '../page/elements.js';
import { Lifecycle } from '../page/lifecycle.js';
import { LocusLine, printedWords } from '../page/locus_words.js';
import { PoleTable } from '../page/pole_table.js';
import { rehearse } from '../page/rehearsal.js';
import { VerdictLine } from '../page/verdict.js';
import { IN_S } from '../page/words_in_s.js';
import { CompensatorPanel } from './compensator_panel.js';
import { CriteriaCard } from './criteria_card.js';
import { Desk } from './desk.js';
import { FrequencyPanel } from './frequency_panel.js';
import { helpPanel } from './help_panel.js';
import { LocusPlane } from './locus_plane.js';
import { MapPanel } from './map_panel.js';
import { ModePanel } from './mode_panel.js';
import { RequirementPanel } from './requirement_panel.js';
import { ResponsePanel } from './response_panel.js';
import { signsOf } from './signs_of_planes.js';
import { TakeAway } from './take_away_panel.js';
import { VehiclePanel } from './vehicle_panel.js';
import { WorkbenchState } from './workbench_state.js';

/** @import { Context, Model, NamedRoots, Pole, System, Values } from '../types.d.ts' */
/** @import { SharedWindow } from './shared_window.js' */
/** @import { Verdict } from '../page/verdict.js' */
/** @import { Shown } from './workbench_state.js' */
/** @import { Words } from '../page/words_in_s.js' */
/** @typedef {Pole & { index: number }} Selected */
/**
 * @typedef {{ canvas: HTMLCanvasElement, node: HTMLDetailsElement }} Part a panel that draws while it is seen
 */

const MAGNIFY = [1, 3, 10, 100, 1000, 10000];

export class Workbench {
  /**
   * @param {Model} model @param {HTMLElement} el
   * @param {{ shared?: SharedWindow, state?: WorkbenchState }} [given] shared: with other workbenches
   */
  constructor(model, el, { shared, state = new WorkbenchState(model) } = {}) {
    this.shared = shared;
    this.state = state;
    /** @type {Words} */
    this.words = IN_S;
    this.plane = new LocusPlane(this);
    this.map = new MapPanel(this);
    this.responses = new ResponsePanel(this);
    this.vehicle = new VehiclePanel(this);
    this.mode = new ModePanel(this);
    this.frequency = new FrequencyPanel(this);
    this.compensator = new CompensatorPanel(this);
    this.requirements = new RequirementPanel(this);
    this.takeAway = new TakeAway(this);
    this.criteria = new CriteriaCard(this);
    this.verdictLine = new VerdictLine();
    this.table = new PoleTable(element('caption', { class: 'unseen' }, 'Closed-loop poles'), 'leaves from');
    this.signs = legend(signsOf(this.system));
    this.locusLine = new LocusLine();
    const { maps, vehicle } = this.system;
    const map = maps.length ? [this.map] : [];
    this.parts = [this.frequency, ...map, this.responses, ...(vehicle ? [this.mode] : [])];
    this.seen = new Map(this.parts.map(({ canvas }) => [canvas, true]));
    this.page = new Lifecycle(el, this.system.system, {
      state: this.state,
      colors: withCompensator(this.system.branches),
      canvases: [this.plane.canvas, ...this.seen.keys()],
      draw: () => this.#draw(),
      later: () => this.#later(),
      arrived: (texts) => this.#arrived(texts),
      stop: () => this.#end(),
    });
    this.#build(el);
    this.#watch();
  }

  /** The system around the vehicle under the sliders, with its compensator. @returns {System} */
  get system() {
    return this.state.inLoop;
  }

  /** Opens what an address is about. @param {Record<string, string>} texts */
  #arrived(texts) {
    if ('view.mode' in texts) this.mode.node.open = Boolean(this.system.vehicle);
    if ('view.desk' in texts) this.desk.follow();
    const { frequency, compensator, requirements } = this;
    for (const [name, { node }] of Object.entries({ frequency, compensator, requirements }))
      if (`view.${name}` in texts) node.open = true;
  }

  /** @param {HTMLElement} el */
  #build(el) {
    const poles = panel('poles', 'Closed-loop poles', () => {}, scrolling('pole table', this.table.node));
    for (const { node } of [poles, this.map, this.responses]) node.open = true;
    const compensator = this.state.places.length ? [this.compensator] : [];
    const criteria = this.system.criteria ? [this.criteria] : [];
    const panels = [
      poles,
      this.vehicle,
      ...compensator,
      this.requirements,
      ...this.parts,
      ...criteria,
      this.takeAway,
    ].map(({ node }) => node);
    const work = element(
      'div',
      { class: 'work' },
      element('div', { class: 'plane' }, this.plane.node, this.locusLine.node, this.signs),
      element('div', { class: 'panels' }, ...panels, helpPanel()),
    );
    this.desk = new Desk(this, el, work);
    el.append(this.#presets(), this.#bar(), this.verdictLine.node, this.page.live, this.desk.node, work);
    this.desk.begin();
  }

  #presets() {
    this.designs = this.system.presets.map(({ name, label, note }, i) =>
      button(name, () => this.#choose(i), { title: [label, note].filter(Boolean).join(': ') }),
    );
    const reset = button('Reset', () => {
      this.state.reset();
      this.page.changed();
    });
    const { designs = 'Designs' } = this.system;
    return group('buttons', designs, element('span', {}, designs), ...this.designs, reset);
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
    const desk = this.page.el.dataset.name ? [] : [this.desk.button]; // two side by side have none
    const steps = element('span', { class: 'steps' }, ...this.page.history.buttons, link, ...desk, said);
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
    this.shared?.leave(this);
    this.plane.stop();
    this.mode.stop();
    this.map.stop();
    this.desk.stop();
    this.vehicle.stop();
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
    return node.open && (this.page.prints || this.seen.get(canvas));
  }

  /** Before each drawing. */
  prepare() {}

  #draw() {
    this.prepare();
    const { state, system, page } = this;
    const { values } = state;
    /** @type {NamedRoots} */
    this.closed = closedLoop(system, values);
    const { x, y, branches } = this.closed;
    /** @type {Pole[]} */
    this.poles = branches.map((name, i) => ({ re: x[i], im: y[i], name }));
    const [width, height] = page.sizeOf(this.plane.canvas);
    this.plane.draw(width, height, this.closed);
    this.shared?.drawn(this);
    for (const part of this.parts)
      if (this.isSeen(part)) part.draw(page.sizeOf(part.canvas)[0] || width, this.closed);
    this.vehicle.draw();
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
    this.verdict = this.words.verdict(this.poles);
    this.verdictLine.show(this.verdict);
    this.table.show(this.poles, this.page.theme, this.words.poles);
    const { crossings, margins: told, isStable } = this.words;
    this.locusLine.show(running, [
      crossings(locus.crossings),
      told(margins(system, values, state.what), isStable(locus.present)),
      printedWords(/** @type {any} */ (extra.printed), locus.present),
    ]);
    const { path } = system.presets[state.shown.printed] ?? {};
    const sign = /** @type {Text} */ (this.signs.lastChild.lastChild);
    const meaning = ` printed in the report${path ? ` (${path})` : ''}`;
    if (!system.given && sign.data !== meaning) sign.data = meaning;
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
    if (this.system.maps.length) this.map.later(short);
    this.responses.later();
    this.frequency.later();
    if (this.system.vehicle) this.mode.later();
    this.takeAway.later();
    this.criteria.later();
  }
}

/** @param {Context} context */
export const render = ({ model, el }) => new Workbench(model, el).page.stop;
