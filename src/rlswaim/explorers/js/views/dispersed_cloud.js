// The closed-loop poles of vehicles whose data are dispersed about those under the sliders.
import { roots } from '../maths/aberth.js';
import { polynomialAround } from '../maths/changed_vehicle.js';
import { inSlices } from '../page/slices.js';

/** @import { Roots, System, Values } from '../types.d.ts' */
/** @import { Workbench } from './workbench.js' */

const SLICE = 3; // ms at a time
const REST = 60; // ms until it begins

/** @param {System} around @param {Values} values @returns {Generator<Roots>} */
function* dispersed(around, values) {
  const system = { ...(around.base ?? around), through: around.through };
  const factors = around.dispersed;
  const names = Object.keys(factors);
  for (let k = 0; k < factors[names[0]].length; k++) {
    const data = Object.fromEntries(names.map((name) => [name, values[name] * factors[name][k]]));
    yield roots(polynomialAround(system, { ...values, ...data }));
  }
}

export class DispersedCloud {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    /** @type {Roots[]} */
    this.points = [];
    this.key = '';
    this.stop = () => {};
  }

  /** Follows the state when the hand rests: until then the last cloud goes away. */
  follow() {
    const { state, system, page } = this.bench;
    const key = state.shown.cloud ? JSON.stringify(state.values) : '';
    if (key === this.key) return;
    this.stop();
    this.key = key;
    this.points = [];
    if (!key) return;
    /** @type {Roots[]} */
    const found = [];
    this.stop = inSlices(
      dispersed(system, state.values),
      SLICE,
      ({ parts, done }) => {
        found.push(...parts);
        if (!done) return;
        this.points = found;
        page.follow();
      },
      REST,
    );
  }

  /** How many of the vehicles have no root right of the axis. */
  get stable() {
    return this.points.filter(({ x }) => Array.from(x).every((re) => re <= 0)).length;
  }
}
