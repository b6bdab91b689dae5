// The state of a workbench: its parameters, and what is shown of the system under them.
import { systemAt } from '../maths/changed_vehicle.js';
import { compensated } from '../maths/compensated.js';
import { kindsOf } from '../maths/compensator.js';
import { periodOf } from '../maths/cut_loop.js';
import { isOwnVehicle } from '../maths/vehicle_data.js';
import { compensatorFrom } from '../page/compensator_text.js';
import { holds, ParameterState } from '../page/parameter_state.js';
import { askedFrom } from '../page/requirement_text.js';
import { deskText } from './desk_state.js';
import { excitationsOf } from './excitations.js';
import { shownFrom } from './shown_from_address.js';

/** @import { Compensator } from '../maths/compensator.js' */
/** @import { Camera, Model, System, Values, What } from '../types.d.ts' */
/**
 * @typedef {object} Shown
 * @property {string} locus the key of the locus that is drawn
 * @property {number} printed the preset whose printed roots are shown, -1 for none
 * @property {number} mode the pole whose mode is shown
 * @property {number} map the station that runs in the pole map, by its place
 * @property {Camera | null} camera
 * @property {number} input the excitation of the responses, by its place
 * @property {number} duration s
 * @property {number} gust s
 * @property {DeskState | null} desk how the desk is laid out; null while it is closed
 * @property {number} cloud 1: with the poles of dispersed vehicles
 * @property {string} compensator as in the address, empty for none
 * @property {string} requirements as in the address, empty for none
 * @property {string} frequency which picture of the frequency response
 */
/** @import { DeskState } from './desk_state.js' */
/** @typedef {{ key: string, text: string, what: What }} LocusChoice */

/**
 * The loci that can be drawn: the report's own, then one for each slider.
 * @param {System} system
 * @returns {LocusChoice[]}
 */
function lociOf({ loci, running }) {
  const own = loci.map((/** @type {What} */ what) => ({ key: what.name, text: what.name, what }));
  const rest = Object.keys(running).map((name) => {
    /** @type {What} */
    const what = { running: name, off: [], of: 'poles' };
    return { key: name, text: name, what };
  });
  return [...own, ...rest];
}

export class WorkbenchState extends ParameterState {
  /** @param {Model} model */
  constructor(model) {
    super(model);
    /** @type {System} */
    const system = model.get('payload');
    this.base = system;
    this.loci = lociOf(system);
    this.inputs = excitationsOf(system);
    const fresh = system.presets.findIndex((preset) => holds(preset.values, system.initial));
    /** @type {Shown} */
    this.start = {
      map: 0,
      camera: null,
      input: 0,
      duration: 5,
      gust: 2,
      desk: null,
      cloud: 0,
      frequency: 'bode',
      compensator: '',
      requirements: '',
      locus: fresh < 0 ? this.loci[0].key : this.locusOf(fresh),
      printed: fresh,
      mode: system.poles.findIndex(
        (/** @type {{ branch: string, im: number }} */ p) => p.branch === 'mode 1' && p.im > 0,
      ),
    };
    this.shown = { ...this.start };
  }

  /** The system around the vehicle of the parameters. @returns {System} */
  get system() {
    const { base } = this;
    return base.plant ? systemAt(base, this.values) : base;
  }

  /** Is the vehicle under the loop the one that Python sent the system for? */
  get isOwnVehicle() {
    const { plant } = this.base;
    return !plant || isOwnVehicle(plant, this.values);
  }

  /** The parameters without those of the vehicle that are as they were. @returns {Values} */
  get told() {
    const { plant } = this.base;
    const names = this.own.map(({ name }) => name);
    const told = names.filter((name) => !plant || plant.own[name] !== this.model.get(name));
    return Object.fromEntries(told.map((name) => [name, this.model.get(name)]));
  }

  get watched() {
    return [...this.names, 'magnify'];
  }

  /** How many times the window about the origin is enlarged; 1: there is none. @returns {number} */
  get magnify() {
    return this.model.get('magnify');
  }

  /** @param {number} preset */
  locusOf(preset) {
    return this.loci[this.base.presets[preset].locus ?? 0].key;
  }

  get what() {
    return this.loci.find(({ key }) => key === this.shown.locus).what;
  }

  /** Gains whose signal a compensator may go through: those of the loops. @returns {string[]} */
  get places() {
    if (this.base.loop) return ['k']; // a loop that a reader gave has this gain alone
    const gains = this.loci
      .map(({ what }) => what.running)
      .filter((name) => this.system.running[name].magnitudes);
    const own = this.system.loci.map((/** @type {What} */ { running }) => running);
    return [...new Set(gains.filter((name) => own.includes(name)))].reverse();
  }

  /** The compensator that is chosen, null for none. */
  get compensator() {
    this.#read();
    return this.kept.compensator;
  }

  /** What is asked of the loop. */
  get asked() {
    return askedFrom(this.shown.requirements, Boolean(this.period)) ?? {};
  }

  /** The system with the compensator in its loop. @returns {System} */
  get inLoop() {
    this.#read();
    return this.kept.system;
  }

  #read() {
    const text = this.shown.compensator;
    const { kept, system: without } = this;
    if (kept?.text === text && kept.without === without) return;
    const compensator = (text && this.compensatorFrom(text)) || null;
    /** @type {{ text: string, compensator: Compensator | null, without: System, system: System }} */
    this.kept = { text, compensator, without, system: this.inSeries(without, compensator) };
  }

  /** The system with a compensator in it. @param {System} system @param {Compensator | null} compensator */
  inSeries(system, compensator) {
    return compensated(system, compensator);
  }

  /** The compensator that a text gives, undefined where it fits not here. @param {string} text */
  compensatorFrom(text) {
    return compensatorFrom(text, this.places, kindsOf(Boolean(this.period)));
  }

  /** Time between samples (s, 1 where it is not told), 0 in continuous time. @returns {number} */
  get period() {
    return periodOf(this.base);
  }

  /** The station that runs in the pole map. @returns {string} */
  get station() {
    return this.base.maps[this.shown.map];
  }

  get response() {
    const { kind, input, amplitude } = this.inputs[this.shown.input];
    return { kind, input, amplitude, duration: this.shown.gust };
  }

  /**
   * Is this the design of the report that the parameters are at? Of two with the same gains, the one that was
   * chosen.
   * @param {number} preset
   */
  isDesign(preset) {
    const { printed, compensator } = this.shown;
    if (compensator) return false;
    const { values } = this;
    /** @param {number} i */
    const at = (i) => holds(this.base.presets[i].values, values);
    return preset >= 0 && at(preset) && (printed === preset || printed < 0 || !at(printed));
  }

  /** @param {string} name @returns {number[]} */
  #gridOf(name) {
    return this.parameters.find((p) => p.name === name).grid;
  }

  /**
   * A value as its slider may take it: whole where the places are whole, else with five digits.
   * @param {string} name @param {number} value
   */
  place(name, value) {
    const grid = this.#gridOf(name);
    if (!grid.every(Number.isInteger)) return Number(value.toPrecision(5));
    return Math.min(Math.max(Math.round(value), grid[0]), grid.at(-1));
  }

  /**
   * The slider's place so many places on from the present value.
   * @param {string} name @param {number} places
   */
  stepped(name, places) {
    const grid = this.#gridOf(name);
    const value = this.model.get(name);
    const next = places > 0 ? grid.findIndex((g) => g > value) : grid.findLastIndex((g) => g < value);
    if (next < 0) return value;
    return grid[Math.min(Math.max(next + places - Math.sign(places), 0), grid.length - 1)];
  }

  /** The values of the parameters that are this view's own. @param {Values} values @returns {Values} */
  #ownOf(values) {
    return Object.fromEntries(this.own.map(({ name }) => [name, values[name]]));
  }

  reset() {
    this.shown = { ...this.start, desk: this.shown.desk };
    this.set({ ...this.#ownOf(this.base.initial), magnify: this.base.magnify ?? 1 });
  }

  /** The window and the desk are no part of a step of the history. */
  snapshot() {
    /** @type {Shown} */
    const shown = { ...this.shown, camera: null, desk: null };
    return JSON.stringify([this.#ownOf(this.values), shown, this.magnify]);
  }

  /** @param {string} snapshot */
  restore(snapshot) {
    const [values, shown, magnify] = JSON.parse(snapshot);
    this.shown = { ...shown, camera: this.shown.camera, desk: this.shown.desk };
    this.set({ ...values, magnify });
  }

  /** All parameters if one differs from the start, then what is shown differently. @returns {Values} */
  toAddress() {
    const { values, shown, start } = this;
    /** @type {Values} */
    const all = holds(this.#ownOf(this.base.initial), values) ? {} : { ...this.told };
    for (const name of /** @type {(keyof Shown)[]} */ (Object.keys(start)))
      if (name !== 'camera' && name !== 'desk' && shown[name] !== start[name])
        all[`view.${name}`] = shown[name];
    if (shown.desk) all['view.desk'] = deskText(shown.desk);
    const { camera } = shown;
    if (camera)
      all['view.window'] = [camera.x, camera.y, camera.w].map((v) => Number(v.toPrecision(6))).join('_');
    if (this.magnify !== (this.base.magnify ?? 1)) all['view.magnify'] = this.magnify;
    return all;
  }

  get otherNames() {
    return [...Object.keys(this.start).filter((name) => name !== 'camera'), 'window', 'magnify'].map(
      (name) => `view.${name}`,
    );
  }

  /** @param {Record<string, string>} texts */
  fromAddress(texts) {
    const { shown, magnify, notes } = shownFrom(this, texts);
    Object.assign(this.shown, shown);
    if (magnify !== undefined) this.set({ magnify });
    return [...super.fromAddress(texts), ...notes];
  }
}
