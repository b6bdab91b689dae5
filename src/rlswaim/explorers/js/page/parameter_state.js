// The parameters of a view: their values are the model's. As a snapshot for undo, and as texts for the page's
// address.
import { unknownNames, valuesFrom } from './address_values.js';

/** @import { Model, Payload, Values } from '../types.d.ts' */

/** Are the values of a set those of the present state? @param {Values} values @param {Values} present */
export const holds = (values, present) =>
  Object.entries(values).every(([name, value]) => present[name] === value);

export class ParameterState {
  /** @param {Model} model */
  constructor(model) {
    this.model = model;
    /** @type {Payload} */
    this.payload = model.get('payload');
    this.parameters = this.payload.parameters;
    this.names = this.parameters.map(({ name }) => name);
    // Those of another view on the page are kept by that view.
    const names = this.payload.own ?? this.names;
    this.own = this.parameters.filter(({ name }) => names.includes(name));
  }

  /** Traits of the model whose change is drawn. */
  get watched() {
    return this.names;
  }

  /** @returns {Values} */
  get values() {
    return Object.fromEntries(this.names.map((name) => [name, this.model.get(name)]));
  }

  /** @param {Values} values */
  set(values) {
    for (const [name, value] of Object.entries(values)) this.model.set(name, value);
    this.model.save_changes();
  }

  /** @returns {string} */
  snapshot() {
    return JSON.stringify(Object.fromEntries(this.own.map(({ name }) => [name, this.model.get(name)])));
  }

  /** @param {string} snapshot */
  restore(snapshot) {
    this.set(JSON.parse(snapshot));
  }

  /** What differs from the start. @returns {Values} */
  toAddress() {
    const values = this.own.map(({ name }) => [name, this.model.get(name)]);
    return Object.fromEntries(values.filter(([name, value]) => value !== this.payload.initial[name]));
  }

  reset() {
    this.set(this.payload.initial);
  }

  /** Names that an address may use beside the parameters'. @returns {string[]} */
  get otherNames() {
    return [];
  }

  /**
   * Takes from an address what makes sense; the rest stays as it is. Returns notes on what was changed
   * or left out.
   * @param {Record<string, string>} texts
   */
  fromAddress(texts) {
    const { values, notes } = valuesFrom(this.own, texts);
    this.set(values);
    const known = [...this.own.map(({ name }) => name), ...this.otherNames];
    return [...notes, ...unknownNames(Object.keys(texts), known)];
  }
}
