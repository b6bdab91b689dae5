// A model that only the page holds, with the calls of the widget's own.

/** @import { Model, Values } from '../types.d.ts' */

/** @implements {Model} */
export class PageModel {
  /** @param {Values} values */
  constructor(values) {
    this.values = values;
    /** @type {Map<string, Set<() => void>>} */
    this.acts = new Map();
  }

  /** @param {string} name */
  get(name) {
    return this.values[name];
  }

  /** @param {string} name @param {unknown} value */
  set(name, value) {
    if (this.values[name] === value) return;
    this.values[name] = value;
    for (const act of [...(this.acts.get(`change:${name}`) ?? [])]) act();
  }

  save_changes() {}

  /** @param {string} event @param {() => void} act */
  on(event, act) {
    this.acts.set(event, (this.acts.get(event) ?? new Set()).add(act));
  }

  /** @param {string} event @param {() => void} act */
  off(event, act) {
    this.acts.get(event)?.delete(act);
  }
}
