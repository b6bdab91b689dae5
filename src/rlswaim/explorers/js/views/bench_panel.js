// The bench under a view of chapters I to III, folded: any control system around the view's own vehicle.

import { deflectionsAlong, shapesAlong } from '../maths/shapes.js';
import { bentBy } from '../maths/vehicle_data.js';
import { onAddress, readAddress, writeAddress } from '../page/address.js';
import { element, panel, select } from '../page/elements.js';
import { PageBench } from './page_bench.js';

/** @import { System } from '../types.d.ts' */
/** @import { ParameterState } from '../page/parameter_state.js' */

/** @type {Record<string, string>} */
const SYSTEMS = {
  'rate-attitude': 'IV, rate and attitude',
  'single-sensor': 'V, one sensor',
  'two-sensor': 'VI, two sensors',
  'dual-actuation': 'VII, thrust and jet',
};

/**
 * What Python sends of one control system, put together with what all have alike.
 * @param {any} payload of the view @param {string} name of the control system
 * @returns {System}
 */
export function benchSystem(payload, name) {
  const { bench, parameters: above } = payload;
  const { matrices, shapes, parameters, ...own } = bench.systems[name];
  const { curves, nodes, times } = payload;
  const plant = { ...bench.plant, ...matrices, l_CG: bench.vehicle.l_CG };
  if (plant.burn) plant.burn = { ...plant.burn, flown: { curves, nodes, times } };
  const followed = above.filter((/** @type {{ name: string }} */ p) => plant.parameters.includes(p.name));
  const names = [...parameters, ...bench.own];
  const bent = bentBy(plant, plant.own);
  return {
    ...own,
    view: 'workbench',
    plant,
    vehicle: { ...bench.vehicle, ...deflectionsAlong(bent) },
    own: names,
    parameters: [...names.map((of) => bench.parameters[of]), ...followed],
    shapes: shapesAlong(shapes, bent),
  };
}

export class BenchPanel {
  /**
   * @param {ParameterState} state of the view
   * @param {(bench: PageBench | null) => void} changed
   */
  constructor(state, changed) {
    this.state = state;
    this.changed = changed;
    this.chosen = state.payload.bench.start;
    /** @type {PageBench | null} */
    this.bench = null;
    /** @type {(() => void)[]} */
    this.unfollow = [];
    this.list = select('Control system', Object.entries(SYSTEMS), (name) => this.#choose(name));
    this.list.choose(this.chosen);
    this.place = element('div');
    const row = element('div', { class: 'controls' }, this.list.node);
    const title = 'Close the loop around this vehicle';
    this.panel = panel('bench', title, () => this.#toggled(), row, this.place);
    this.node = this.panel.node;
    this.unfollowAddress = onAddress((hash) => this.#arrive(hash));
    this.#arrive();
  }

  /** @param {string} system */
  #nameOf(system) {
    return `${this.state.payload.system}-${system}`;
  }

  /** An address that is about a bench opens it. @param {string} [hash] */
  #arrive(hash) {
    const named = Object.keys(SYSTEMS).find(
      (name) => Object.keys(readAddress(this.#nameOf(name), hash)).length,
    );
    if (!named) return;
    this.list.choose(named);
    this.node.open = true;
    if (named !== this.chosen || !this.bench) this.#choose(named);
  }

  #toggled() {
    if (this.node.open && !this.bench) this.#choose(this.chosen);
    this.changed(this.node.open ? this.bench : null);
  }

  /** @param {string} name */
  #choose(name) {
    if (this.bench) {
      this.#leave();
      writeAddress(this.#nameOf(this.chosen), {});
    }
    this.chosen = name;
    const { model, payload, values } = this.state;
    const system = benchSystem(payload, name);
    const start = { ...values, ...system.presets.at(-1).values };
    this.bench = new PageBench(system, start, this.#nameOf(name));
    const own = this.bench.model;
    for (const followed of system.plant.parameters.filter((of) => !system.own.includes(of))) {
      const follow = () => own.set(followed, model.get(followed));
      model.on(`change:${followed}`, follow);
      this.unfollow.push(() => model.off(`change:${followed}`, follow));
    }
    this.place.replaceChildren(this.bench.node);
    this.changed(this.bench);
  }

  #leave() {
    for (const stop of this.unfollow) stop();
    this.unfollow = [];
    this.bench?.stop();
  }

  stop() {
    this.unfollowAddress();
    this.#leave();
  }
}
