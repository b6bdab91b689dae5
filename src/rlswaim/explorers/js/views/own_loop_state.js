// The state of a workbench for one's own loop: its text, its gain, and the system that the text gives.
import { ordersOf } from '../maths/compensator.js';
import { valuesFrom } from '../page/address_values.js';
import { askedFrom } from '../page/requirement_text.js';
import { HIGHEST } from '../reading/given_loop.js';
import { durationOf, inSeries, systemOf } from './own_loop_system.js';
import { WorkbenchState } from './workbench_state.js';

/** @import { Compensator } from '../maths/compensator.js' */
/** @import { Model, System } from '../types.d.ts' */

const ANY_GAIN = { name: 'k', grid: [-1e30, 0.5, 1e30] };
const LONGEST = 20_000; // characters of a text

export class OwnLoopState extends WorkbenchState {
  /** @param {Model} model */
  constructor(model) {
    const payload = model.get('payload');
    const system = systemOf(payload, model.get('loop'));
    super(/** @type {Model} */ ({ get: (name) => (name === 'payload' ? system : model.get(name)) }));
    this.model = model;
    this.payload = payload;
    this.read = model.get('loop');
    this.wrong = '';
    this.start.duration = durationOf(system.loop);
    this.shown = { ...this.start };
  }

  /** Takes the text of the model; one that is no loop leaves the last one. */
  update() {
    const text = this.model.get('loop');
    if (text === this.read) return;
    this.read = text;
    try {
      const system = systemOf(this.payload, text);
      this.base = system;
      this.wrong = '';
      Object.assign(this.shown, { camera: null, duration: durationOf(system.loop), locus: 'k' });
      this.#leaveWhatDoesNotFit();
    } catch (error) {
      this.wrong = error instanceof Error ? error.message : String(error);
    }
  }

  /** A compensator in s makes no sense of a loop in z, nor do some requirements; one may be too long. */
  #leaveWhatDoesNotFit() {
    const { compensator, requirements } = this.shown;
    if (compensator && !this.compensatorFrom(compensator)) this.shown.compensator = '';
    if (!askedFrom(requirements, Boolean(this.period))) this.shown.requirements = '';
  }

  /** @override @param {string} text */
  compensatorFrom(text) {
    const found = super.compensatorFrom(text);
    if (!found) return undefined;
    const order = this.base.loop.poles.x.length + ordersOf(found.sections).poles;
    return order <= HIGHEST ? found : undefined;
  }

  /** @override @param {System} system @param {Compensator | null} compensator */
  inSeries(system, compensator) {
    return inSeries(system, compensator);
  }

  /** @param {Record<string, string>} texts */
  fromAddress(texts) {
    const { loop, k, ...rest } = texts;
    if (loop !== undefined) this.set({ loop: loop.slice(0, LONGEST) });
    this.update();
    const { values, notes } = valuesFrom([ANY_GAIN], k === undefined ? {} : { k });
    this.set(values);
    return [...notes, ...super.fromAddress(rest)];
  }
}
