// A workbench with its sliders that only the page holds: no widget of Python stands behind it.
import { element } from '../page/elements.js';
import { PageModel } from '../page/page_model.js';
import { ParameterRows } from '../page/parameter_rows.js';
import { Workbench } from './workbench.js';

/** @import { System, Values } from '../types.d.ts' */
/** @import { SharedWindow } from './shared_window.js' */

export class PageBench {
  /**
   * @param {System} payload @param {Values} initial @param {string} name in the address
   * @param {SharedWindow} [shared]
   */
  constructor(payload, initial, name, shared) {
    const { parameters, plant } = payload;
    const start = { ...plant.own, ...initial };
    this.model = new PageModel({ payload: { ...payload, initial: start }, magnify: 1, ...start });
    const own = payload.own ?? parameters.map((parameter) => parameter.name);
    const shown = parameters.filter(({ name: of }) => own.includes(of) && !plant.folded.includes(of));
    this.rows = new ParameterRows(shown, this.model);
    const root = element('div', { 'data-name': name }, this.rows.node);
    this.node = element('div', { class: 'bench' }, root);
    this.workbench = new Workbench(this.model, root, { shared });
  }

  get name() {
    return this.workbench.page.name;
  }

  stop() {
    this.rows.stop();
    this.workbench.page.stop();
  }
}
