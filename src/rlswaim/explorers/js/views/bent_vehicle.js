// The bent vehicle with the forces on it, under the motions that the sliders set.
import { contextOf } from '../drawing/context.js';
import { number, signed } from '../drawing/numbers.js';
import { Plane } from '../drawing/plane.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { loads, ROWS } from '../maths/bent_vehicle_forces.js';
import { element, legend, picture, set } from '../page/elements.js';
import { ValueTable } from '../page/value_table.js';
import { REACH, vehicleMarks } from './bent_vehicle_marks.js';
import { ModeMotion } from './mode_motion.js';
import { simple } from './simple_view.js';

/** @import { Values } from '../types.d.ts' */
/** @import { ParameterState } from '../page/parameter_state.js' */
/** @import { PageBench } from './page_bench.js' */
/** @import { Loads } from '../maths/bent_vehicle_forces.js' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @typedef {ReturnType<typeof loads>} Found loads of each source and their sums */

const UNITS = { q_1: '1 ft of q₁', q_2: '1 ft of q₂', theta: '1° of θ', alpha: '1° of α', delta: '1° of δ' };
const LOADS = ['force down (lb)', 'moment nose up (ft lb)', 'on mode 1 (lb)', 'on mode 2 (lb)'];
const MARGIN = { left: 8, right: 8, top: 8, bottom: 36 };

/** @param {Loads} sum */
function spoken({ Z, M, F1, F2 }) {
  /** @param {number} value @param {string} plus @param {string} minus */
  const way = (value, plus, minus) => (value === 0 ? '' : ` ${value > 0 ? plus : minus}`);
  /** @param {number} value */
  const size = (value) => number(Math.abs(value), 3);
  return (
    `Together: a force across of ${size(Z)} lb${way(Z, 'down', 'up')}, a moment of ${size(M)} ft lb` +
    `${way(M, 'nose up', 'nose down')}; mode 1 is pushed${way(F1, 'down', 'up')} with ${size(F1)} lb, ` +
    `mode 2${way(F2, 'down', 'up')} with ${size(F2)} lb.`
  );
}

class BentVehicle {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    this.stretch = element('small');
    const title = element('b', {}, 'The bent vehicle');
    this.mode = element('span');
    const { canvas, figure } = picture('vehicle', {}, title, ', nose to the left', this.mode, this.stretch);
    this.canvases = [canvas];
    this.words = element('p', { class: 'verdict' });
    const heads = ['from', 'local angle of attack (deg)', ...LOADS];
    this.table = new ValueTable('Forces under the sliders', heads);
    const signs = legend([
      ['━', 'elastic axis'],
      ['╌', 'rigid axis, turned by θ'],
      ['┄', 'undisturbed axis; exhaust without δ'],
      ['▬', 'payload and fins, with the air’s force across'],
      ['■', 'center of gravity'],
    ]);
    /** @type {Values | null} the motions of a mode, which are drawn in place of the sliders' */
    this.motions = null;
    /** @type {ModeMotion | undefined} */
    this.motion = undefined;
    this.nodes = [this.words, figure, signs, this.table.node, this.#units()];
  }

  /** The table of what one unit of each motion gives. */
  #units() {
    const units = new ValueTable('What one unit of each motion gives, all sources together', [
      'for',
      ...LOADS,
    ]);
    /** @param {string} row @param {string} motion */
    const total = (row, motion) =>
      loads(this.payload, { q_1: 0, q_2: 0, theta: 0, alpha: 0, delta: 0, [motion]: 1 }).sum[row];
    units.show(
      Object.entries(UNITS).map(([motion, text]) => ({
        cells: [text, ...ROWS.map((row) => signed(total(row, motion)))],
      })),
    );
    return units.node;
  }

  /** @param {Values} values @param {Found} found @param {Lifecycle} page */
  #picture(values, found, page) {
    const [canvas] = this.canvases;
    const [width, height] = page.sizeOf(canvas);
    const view = viewOf([-75, 525], [-REACH, REACH], frameOf(width, height, MARGIN), width, height);
    const marks = vehicleMarks(view, page.theme, this.payload, values, found);
    new Plane(contextOf(canvas, width, height), view, page.theme).chart(
      'station (ft from the nose)',
      '',
      marks,
      true,
    );
    const { force, gamma_0 } = this.payload.weight;
    set(
      this.stretch,
      `Heights and angles are drawn ${number(view.sy / view.sx, 2)} times too large, and an arrow’s length ` +
        `goes with the square root of its force. The weight, ${number(force, 3)} lb, is drawn for a path ` +
        `${number(gamma_0, 2)}° above the horizon (chapter II’s program).`,
    );
  }

  /** @param {Found} found */
  #tell({ each, sum }) {
    /** @param {string} source @param {string} angle @param {Loads} given */
    const row = (source, angle, given) => ({
      cells: [source, angle, ...ROWS.map((name) => signed(given[name]))],
      data: { source, ...given },
    });
    const rows = each.map(({ name, incidence, loads: own }, i) =>
      row(name, i ? signed(incidence) : '–', own),
    );
    this.table.show([...rows, row('sum', '', sum)]);
  }

  /**
   * A bench on the vehicle: the mode that is picked there moves it.
   * @param {PageBench | null} bench @param {ParameterState} _ @param {Lifecycle} page
   */
  benched(bench, _, page) {
    this.motion ??= new ModeMotion(page, (motions, name) => {
      const rests = !motions && !this.motions;
      this.motions = motions;
      set(this.mode, motions ? `, moving in the closed-loop mode from ${name}` : '');
      if (motions) this.#picture(motions, loads(this.payload, motions), page);
      else if (!rests) page.follow();
    });
    this.motion.follow(bench);
  }

  stop() {
    this.motion?.stop();
  }

  /** @param {Values} values @param {Lifecycle} page */
  draw(values, page) {
    const found = loads(this.payload, values);
    if (!this.motions) this.#picture(values, found, page);
    this.#tell(found);
    const said = spoken(found.sum);
    set(this.words, said);
    const [q_1, q_2, theta, alpha, delta] = Object.keys(UNITS).map((name) => number(values[name]));
    this.canvases[0].ariaLabel =
      `The vehicle bent by q1 = ${q_1} ft and q2 = ${q_2} ft, pitched ${theta} degrees, ` +
      `at ${alpha} degrees angle of attack, exhaust swung ${delta} degrees. ${said}`;
    return said;
  }
}

export const render = simple(BentVehicle);
