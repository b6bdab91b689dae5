// A card with what an engineer asks of a loop: does it settle, how large is each motion, and the margins by
// mode, for the gains that are set.

import { number, signed } from '../drawing/numbers.js';
import { scaleOf } from '../drawing/response_charts.js';
import { margins } from '../maths/margins.js';
import { nearestFirst } from '../maths/one_margin.js';
import { responses } from '../maths/responses.js';
import { element, headRow, panel, scrolling, set } from '../page/elements.js';

/** @import { Workbench } from './workbench.js' */
/** @typedef {{ re: number, im: number, name: string }} Pole */
/** @typedef {{ omega: number }} Crossing */

const HORIZON = 30; // s
const SAMPLES = 1501;
const BAND = 0.1; // of its largest size, within which a motion counts as settled

/**
 * When a motion comes to stay within a band about its last value (s), or null if it does not before the last
 * tenth of the time.
 * @param {Float64Array} values @param {Float64Array} times
 */
export function settledAt(values, times) {
  const last = values[values.length - 1];
  const most = values.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
  let at = values.length - 1;
  while (at > 0 && Math.abs(values[at - 1] - last) <= BAND * most) at -= 1;
  return at > 0.9 * values.length ? null : times[at];
}

/**
 * The name of the root whose frequency is nearest to that of a crossing.
 * @param {Pole[]} poles @param {number} omega
 */
export function nearestMode(poles, omega) {
  const far = (/** @type {Pole} */ { re, im }) => Math.abs(Math.log(Math.hypot(re, im) / omega));
  return poles.filter(({ re, im }) => re || im).reduce((a, b) => (far(b) < far(a) ? b : a)).name;
}

export class CriteriaCard {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.words = element('p', { class: 'criteria' });
    this.body = element('tbody');
    const table = element('table', { class: 'criteria' }, headRow(['what', 'value', 'at']), this.body);
    const toggled = () => this.later();
    this.node = panel('criteria', 'Criteria', toggled, this.words, scrolling('criteria', table)).node;
  }

  /** Words and numbers, which may lag a little behind the pictures. */
  later() {
    if (!this.node.open || !this.bench.poles) return;
    const { state, poles } = this.bench;
    const stable = poles.every(({ re }) => re < 0);
    const { text } = state.inputs[state.shown.input];
    set(
      this.words,
      stable
        ? `Motions over ${HORIZON} s after a ${text}; margins of the locus' loop, named by the nearest root.`
        : 'This loop is not stable: its motions grow, and it has no margins.',
    );
    this.body.replaceChildren(...(stable ? [...this.#motions(), ...this.#margins(poles)] : []));
  }

  #motions() {
    const { system, state } = this.bench;
    const times = Float64Array.from({ length: SAMPLES }, (_, k) => (HORIZON * k) / (SAMPLES - 1));
    return Object.entries(responses(system, state.values, state.response, times)).flatMap(
      ([name, values]) => {
        const [factor, unit] = scaleOf(system.units[name]);
        const at = values.reduce((a, v, k) => (Math.abs(v) > Math.abs(values[a]) ? k : a), 0);
        const settled = settledAt(values, times);
        return [
          row(`${name}, largest`, `${number(values[at] * factor, 3)} ${unit}`, `${number(times[at], 3)} s`),
          row(
            `${name} settles`,
            settled === null ? `not within ${HORIZON} s` : `${number(settled, 3)} s`,
            '',
          ),
        ];
      },
    );
  }

  /** @param {Pole[]} poles */
  #margins(poles) {
    const { system, state } = this.bench;
    const found = margins(system, state.values, state.what);
    if (!found) return [];
    const at = (/** @type {Crossing} */ { omega }) => `${number(omega, 3)} rad/s`;
    const of = (/** @type {Crossing} */ { omega }) => (omega > 0 ? nearestMode(poles, omega) : 'slow');
    const phase = nearestFirst(found.phase, ({ degrees }) => degrees);
    const gain = nearestFirst(found.gain, ({ dB }) => dB);
    return [
      ...phase.map((m) => row(`${of(m)}: phase margin`, `${signed(m.degrees, 3)}°`, at(m))),
      ...phase.map((m) => row(`${of(m)}: delay margin`, `${number(m.delay, 3)} s`, at(m))),
      ...gain.map((m) => row(`${of(m)}: gain margin`, `${signed(m.dB, 3)} dB`, at(m))),
    ];
  }
}

/** @param {string} what @param {string} value @param {string} at */
const row = (what, value, at) =>
  element('tr', {}, element('th', { scope: 'row' }, what), element('td', {}, value), element('td', {}, at));
