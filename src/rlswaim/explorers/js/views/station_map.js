// The map over sensor and jet stations: computed beside the page, coarse first, drawn as it comes.
import { contextOf } from '../drawing/context.js';
import { number, signed } from '../drawing/numbers.js';
import { Plane } from '../drawing/plane.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { abscissaAt, planOf, rootsAt, STATIONS } from '../maths/abscissa.js';
import { element, legend, picture, set } from '../page/elements.js';
import { movable, movableByKeys } from '../page/movable_point.js';
import { ValueTable } from '../page/value_table.js';
import { VerdictLine } from '../page/verdict.js';
import { MapCalculator } from './map_calculator.js';
import { simple } from './simple_view.js';
import {
  chosenPair,
  colorScale,
  cursorMark,
  pairOfTable3,
  pixels,
  progressWords,
  zeroLine,
} from './station_map_marks.js';
import { StationPixels } from './station_pixels.js';

/** @import { Values } from '../types.d.ts' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @import { ParameterState } from '../page/parameter_state.js' */
/** @import { Part } from './station_pixels.js' */
/** @import { Pair } from './station_map_marks.js' */

const RANGE = [-0.5, STATIONS - 0.5];
const SCALE_MARGIN = { left: 8, right: 8, top: 0, bottom: 0 };
const SCALE_WORDS = 'Color scale from −10 to +10 1/s, purple below zero, orange above';

/** A whole foot on the vehicle. @param {number} value */
const onVehicle = (value) => Math.max(0, Math.min(STATIONS - 1, Math.round(value)));

class StationMap {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    /** @type {string[]} */
    const names = payload.parameters.map((/** @type {{ name: string }} */ { name }) => name);
    this.gains = names.filter((name) => name !== 'sensor' && name !== 'jet');
    this.key = '';
    this.started = false;
    /** @type {any} */
    this.plan = null;
    /** @type {Pair | null} */
    this.cursor = null;
    this.pixels = new StationPixels(payload.palette);
    this.calculator = new MapCalculator((parts) => this.#receive(parts));
    this.map = picture(
      'stations',
      { tabindex: '0', role: 'application' },
      element('b', {}, 'Largest real part of all poles'),
      ' (1/s) for every sensor and jet',
    );
    this.scale = picture('scale', {}, 'color of the map (1/s): below zero all poles decay');
    this.scale.canvas.ariaLabel = SCALE_WORDS;
    this.verdict = new VerdictLine();
    this.progress = element('p', { class: 'crossings' });
    const heads = ['case', 'sensor (ft)', 'jet (ft)', 'largest real part (1/s)', 'stable'];
    this.table = new ValueTable('The pairs of Table 3 at these gains', heads);
    this.canvases = [this.map.canvas, this.scale.canvas];
  }

  get nodes() {
    const signs = legend([
      ['✚', 'the pair chosen: click, or drag it'],
      ['○', 'pairs of Table 3'],
      ['━', 'zero: stable within'],
      ['◌', 'the keyboard’s mark: arrow keys move it (with Shift ten feet), Enter picks'],
    ]);
    const { map, scale, progress, table } = this;
    return [this.verdict.node, map.figure, scale.figure, progress, signs, table.node];
  }

  /** @param {Part[]} parts */
  #receive(parts) {
    for (const part of parts) {
      if (part.pairs) this.#showPairs(part.pairs);
      else this.pixels.take(part);
    }
    this.page.follow();
  }

  /** @param {number[]} values of the pairs of Table 3 */
  #showPairs(values) {
    const rows = values.map((value, i) => {
      const { case: at, sensor, jet } = this.payload.pairs[i];
      const stable = value < 0 ? 'yes' : value > 0 ? 'no' : 'neutral';
      return { cells: [`${at}`, `${sensor}`, `${jet}`, signed(value), stable], data: { case: at, value } };
    });
    this.table.show(rows);
  }

  /** A new map where the gains have changed; it is computed once somebody sees it. @param {Values} values */
  #follow(values) {
    const key = JSON.stringify(this.gains.map((name) => values[name]));
    if (key !== this.key) {
      this.key = key;
      this.plan = planOf(this.payload, Object.fromEntries(this.gains.map((name) => [name, values[name]])));
      this.pixels.restart();
      this.calculator.drop();
      this.started = false;
    }
    if (this.page.prints && !this.pixels.whole) this.started = this.calculator.atOnce(this.plan);
    if (this.page.seen && !this.started) this.calculator.start(this.plan);
    this.started ||= this.page.seen;
  }

  /** @param {Values} values */
  #picture(values) {
    const { theme } = this.page;
    const [width, height] = this.page.sizeOf(this.map.canvas);
    this.view = viewOf(RANGE, RANGE, frameOf(width, height), width, height);
    new Plane(contextOf(this.map.canvas, width, height), this.view, theme).chart(
      'station of the sensor (ft)',
      'station of the jet (ft)',
      [
        pixels(this.pixels.shown),
        zeroLine(this.pixels.whole),
        ...this.payload.pairs.map(pairOfTable3),
        chosenPair(/** @type {any} */ (values)),
        cursorMark(this.cursor),
      ],
    );
    const [w, h] = this.page.sizeOf(this.scale.canvas);
    const along = viewOf([0, 1], [0, 1], frameOf(w, h, SCALE_MARGIN), w, h);
    new Plane(contextOf(this.scale.canvas, w, h), along, theme)
      .clear()
      .layers(colorScale(this.payload.palette));
  }

  /** @param {Values} values */
  #verdict({ sensor, jet }) {
    const value = abscissaAt(this.plan, sensor, jet);
    const right = rootsAt(this.plan, sensor, jet).x.filter((/** @type {number} */ x) => x > 0).length;
    const also = value > 0 ? `; ${right} of 9 poles lie right of the axis` : '';
    const pair = `with the sensor at ${number(sensor)} ft and the jet at ${number(jet)} ft`;
    this.verdict.node.dataset.value = String(value);
    return {
      kind: value > 0 ? 'unstable' : 'stable',
      word: value < 0 ? 'Stable' : value > 0 ? 'Unstable' : 'Neutral',
      long: `: ${pair} the largest real part is ${signed(value)} 1/s${also}.`,
    };
  }

  #cursorWords() {
    if (!this.cursor) return '';
    const { sensor, jet } = this.cursor;
    const value = signed(abscissaAt(this.plan, sensor, jet));
    return `The mark is at sensor ${sensor} ft, jet ${jet} ft: ${value} 1/s.`;
  }

  /** @param {Values} values */
  draw(values) {
    this.#follow(values);
    this.#picture(values);
    const told = this.#verdict(values);
    this.verdict.show(told);
    set(this.progress, progressWords(this.pixels, STATIONS * STATIONS));
    this.page.el.dataset.step = this.pixels.complete ? 'complete' : String(this.pixels.whole?.step ?? 0);
    const said = `${told.word}${told.long}`;
    const there = this.#cursorWords();
    this.map.canvas.ariaLabel =
      `Map of the largest real part over sensor and jet stations. ${said} ` +
      `Arrow keys move a mark, Enter picks its pair. ${there}`;
    return there || said;
  }

  /** @param {Pair | null} pair */
  #put(pair) {
    this.cursor = null;
    if (pair) this.state.set(pair);
    this.page.follow();
  }

  /**
   * The pair is a point that moves over whole feet.
   * @returns {import('../page/movable_point.js').MovablePoint}
   */
  #point() {
    /** @param {number} px @param {number} py */
    const at = (px, py) => this.#put({ sensor: onVehicle(this.view.x(px)), jet: onVehicle(this.view.y(py)) });
    return {
      grab: (px, py, reach) => {
        const { sensor, jet } = this.state.values;
        const off = Math.hypot(this.view.X(sensor) - px, this.view.Y(jet) - py);
        return off <= reach ? 0 : -1;
      },
      drag: (_, px, py) => at(px, py),
      click: at,
      step: (right, up) => {
        const { sensor, jet } = this.cursor ?? this.state.values;
        this.cursor = { sensor: onVehicle(sensor + right), jet: onVehicle(jet + up) };
        this.page.follow();
      },
    };
  }

  /** @param {KeyboardEvent} event */
  #otherKeys({ key }) {
    if ((key === 'Enter' || key === ' ') && this.cursor) this.#put(this.cursor);
    else if (key === 'Escape') this.#put(null);
    else return false;
    return true;
  }

  /** @param {ParameterState} state @param {Lifecycle} page */
  begin(state, page) {
    this.state = state;
    this.page = page;
    const { canvas } = this.map;
    const point = this.#point();
    movable(canvas, point);
    movableByKeys(canvas, point, (event) => this.#otherKeys(event));
    canvas.addEventListener('blur', () => this.#put(null));
  }

  stop() {
    this.calculator.stop();
  }
}

export const render = simple(StationMap);
