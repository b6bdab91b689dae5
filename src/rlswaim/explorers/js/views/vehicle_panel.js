// The vehicle under the loop: its data as sliders, folded away, and the poles of vehicles dispersed about it.
import { button, element, panel, press, set } from '../page/elements.js';
import { ParameterRows } from '../page/parameter_rows.js';
import { DispersedCloud } from './dispersed_cloud.js';

/** @import { Workbench } from './workbench.js' */

export class VehiclePanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    const { base, model, own } = bench.state;
    const { plant, dispersed } = base;
    const named = own.filter(({ name }) => plant?.folded.includes(name));
    this.rows = new ParameterRows(named, model);
    this.cloud = new DispersedCloud(bench);
    this.back = button("The report's vehicle", () => bench.state.set(plant.own));
    this.disperse = button('Dispersed vehicles', () => this.#toggle(), {
      'aria-pressed': 'false',
      title: 'poles of vehicles whose data are off at random',
      hidden: !dispersed,
    });
    this.said = element('span', { class: 'told' });
    const row = element('div', { class: 'controls' }, this.back, this.disperse, this.said);
    this.panel = panel('vehicle', 'The vehicle under the loop', () => {}, this.rows.node, row);
    this.node = this.panel.node;
    this.node.hidden = named.length === 0;
  }

  #toggle() {
    this.bench.look({ cloud: 1 - this.bench.state.shown.cloud });
  }

  draw() {
    const { state } = this.bench;
    const { cloud } = state.shown;
    this.cloud.follow();
    press(this.disperse, cloud === 1);
    set(this.panel.extra, state.isOwnVehicle ? "the report's" : 'other data than the report’s');
    const { points, stable } = this.cloud;
    set(this.said, points.length ? `${stable} of ${points.length} have no root right of the axis` : '');
  }

  stop() {
    this.cloud.stop();
    this.rows.stop();
  }
}
