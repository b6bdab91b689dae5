// Sliders that the view makes itself, one row for each parameter: a slider over the parameter's places, and a
// box for any value within its range. A parameter of texts is a list to choose from.
import { valueFrom } from './address_values.js';
import { element, select, symbol } from './elements.js';
import { nextPlace, roundPlaces, WAYS } from './slider_keys.js';
import { nearest } from './sliders.js';

/** @import { Model, Parameter } from '../types.d.ts' */

class NumberRow {
  /** @param {Parameter} parameter @param {(value: number) => void} put */
  constructor(parameter, put) {
    const { name, grid, unit, meaning } = parameter;
    this.parameter = parameter;
    this.put = put;
    this.value = NaN;
    const given = { 'aria-label': meaning ?? name, title: meaning };
    const last = grid.length - 1;
    this.slider = element('input', { type: 'range', min: 0, max: last, step: 1, ...given });
    this.box = element('input', { type: 'text', inputmode: 'decimal', autocomplete: 'off', ...given });
    const label = element('span', { class: 'name' }, ...symbol(name), unit ? ` (${unit})` : '');
    this.node = element('div', { class: 'row', 'data-parameter': name }, label, this.slider, this.box);
    this.slider.addEventListener('input', () => put(grid[Number(this.slider.value)]));
    this.slider.addEventListener('keydown', (event) => this.#step(event));
    this.box.addEventListener('change', () => this.#typed());
  }

  /** @param {KeyboardEvent} event */
  #step(event) {
    const way = WAYS[event.key];
    if (!way) return;
    event.preventDefault();
    const { grid } = this.parameter;
    this.put(nextPlace(event.altKey ? grid : roundPlaces(grid, event.shiftKey), this.value, way));
  }

  #typed() {
    const { value } = valueFrom(this.parameter, this.box.value.replace(',', '.'));
    if (value !== undefined) this.put(/** @type {number} */ (value));
    this.box.value = String(this.value);
  }

  /** @param {number} value */
  show(value) {
    if (value === this.value) return;
    this.value = value;
    this.slider.value = String(nearest(this.parameter, value));
    this.slider.setAttribute('aria-valuetext', String(value));
    this.box.value = String(value);
  }
}

class ChoiceRow {
  /** @param {Parameter} parameter @param {(value: string) => void} put */
  constructor({ name, grid, meaning }, put) {
    this.list = select(
      meaning ?? name,
      grid.map((text) => [text, text]),
      put,
    );
    this.node = element('div', { class: 'row choice', 'data-parameter': name }, this.list.node);
  }

  /** @param {string} value */
  show(value) {
    this.list.choose(value);
  }
}

export class ParameterRows {
  /** @param {Parameter[]} parameters @param {Model} model */
  constructor(parameters, model) {
    this.model = model;
    this.rows = parameters.map((parameter) => {
      const { name, grid } = parameter;
      /** @param {any} value */
      const put = (value) => {
        model.set(name, value);
        model.save_changes();
      };
      const row = typeof grid[0] === 'string' ? new ChoiceRow(parameter, put) : new NumberRow(parameter, put);
      const follow = () => row.show(/** @type {never} */ (model.get(name)));
      model.on(`change:${name}`, follow);
      follow();
      return { name, follow, node: row.node };
    });
    this.node = element('div', { class: 'rows' }, ...this.rows.map(({ node }) => node));
  }

  stop() {
    for (const { name, follow } of this.rows) this.model.off(`change:${name}`, follow);
  }
}
