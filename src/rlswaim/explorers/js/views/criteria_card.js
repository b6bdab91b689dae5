// A card with what an engineer asks of a loop: the criteria of chapter XVI for the gains that are set, with
// their bounds, and whether each is met.

import { letterOf } from '../drawing/letters.js';
import { number } from '../drawing/numbers.js';
import { evaluateCriteria, isMet } from '../maths/criteria.js';
import { once } from '../maths/kept_values.js';
import { placesOf } from '../maths/open_loop.js';
import { element, headRow, panel, scrolling, set } from '../page/elements.js';

/** @import { Workbench } from './workbench.js' */
/** @typedef {import('../maths/criteria.js').Asked} Asked */
/** @typedef {import('../maths/criteria.js').Criterion} Criterion */

const DIGITS = 3;
/** @type {Record<string, string>} */
const UNIT = { deg: '°', 'deg/s': '°/s', 1: '' };
const VERDICT = new Map([
  [true, 'met'],
  [false, 'not met'],
  [null, 'nothing asked'],
]);

/** A number and its unit stay on one line. @param {number} value @param {string} unit */
const withUnit = (value, unit) =>
  [number(value, DIGITS), UNIT[unit] ?? unit].join(/^deg/.test(unit) ? '' : '\u00a0').trim();

/** A value in words where it is no number. @param {Criterion} criterion @param {Asked} asked */
function valueWords({ name, value, unit, atMost }, { settling }) {
  if (Number.isFinite(value)) return withUnit(value, unit);
  if (Number.isNaN(value)) return 'none';
  if (name === 'settling') return `not within ${settling.horizon} s`;
  return atMost ? 'without end' : '∞';
}

/** What a row is about: a symbol and words. @param {string} name @param {Asked} asked */
function labelOf(name, { peaks, settling, margins }) {
  const timed = name === 'settling' ? settling : peaks.find((peak) => peak.name === name);
  if (timed) {
    const { symbol, says } = timed;
    return symbol ? [element('i', {}, letterOf(symbol)), ` ${says}`] : [says];
  }
  const kind = Object.keys(margins).find((each) => name.endsWith(` ${each}`));
  return [kind ? `${name.slice(0, -kind.length - 1)}: ${margins[kind]}` : `${name} margin`];
}

export class CriteriaCard {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    /** @type {Criterion[] | null} */
    this.shown = null;
    this.words = element('p', { class: 'criteria' });
    this.limits = element('p', { class: 'told fine' });
    this.body = element('tbody');
    const heads = headRow(['criterion', 'value', 'asked', 'verdict']);
    const table = element('table', { class: 'values criteria' }, heads, this.body);
    const toggled = () => this.later();
    this.panel = panel(
      'criteria',
      'Criteria',
      toggled,
      this.words,
      scrolling('criteria', table),
      this.limits,
    );
    this.node = this.panel.node;
  }

  /** Words and numbers, which may lag a little behind the pictures. */
  later() {
    if (!this.node.open || !this.bench.poles) return;
    const { state, system } = this.bench;
    const asked = /** @type {Asked} */ (system.criteria);
    const found = once(system, `criteria ${placesOf(system, state.values)}`, () =>
      evaluateCriteria(/** @type {any} */ (system), state.values),
    );
    if (found === this.shown) return;
    this.shown = found;
    this.#tell(found, asked);
    const named = [...this.body.rows].map((row) => row.dataset.criterion).join();
    if (named !== found.map(({ name }) => name).join())
      this.body.replaceChildren(...found.map(({ name }) => emptyRow(name, asked)));
    found.forEach((criterion, k) => {
      this.#show(this.body.rows[k], criterion, asked);
    });
  }

  /** @param {HTMLTableRowElement} row @param {Criterion} criterion @param {Asked} asked */
  #show(row, criterion, asked) {
    const { bound, unit, atMost } = criterion;
    const met = isMet(criterion);
    const [value, wanted, verdict] = [...row.cells].slice(1);
    set(value, valueWords(criterion, asked));
    set(wanted, bound === null ? '' : `${atMost ? '≤' : '≥'}\u00a0${withUnit(bound, unit)}`);
    const isNear = bound !== null && number(criterion.value, DIGITS) === number(bound, DIGITS);
    set(verdict, `${isNear ? 'just ' : ''}${VERDICT.get(met)}`);
    verdict.className = met === null ? 'fine' : met ? 'stable' : 'unstable';
  }

  /** @param {Criterion[]} found @param {Asked} asked */
  #tell(found, { wanted, settling, gusts, note }) {
    const verdicts = found.map(isMet).filter((met) => met !== null);
    const missed = verdicts.filter((met) => !met).length;
    set(this.panel.extra, missed ? `${missed} of ${verdicts.length} not met` : `all ${verdicts.length} met`);
    const isStable = !found.some(({ value }) => Number.isNaN(value));
    const [from, to] = gusts.durations;
    set(
      this.words,
      isStable
        ? (found.some(({ name }) => name === 'settling')
            ? `θ settles when it stays within ${100 * wanted.band} % of a step of its command, ` +
              `over ${settling.horizon} s. `
            : '') +
            `Peaks are those of the worst 1 − cos gust of ${from} to ${to} s and ` +
            `${withUnit(wanted[gusts.peak], gusts.unit)}. ` +
            'Margins are those of the loop cut at the engine’s command, by mode.'
        : 'This loop is not stable: its motions grow, and it has no margins.',
    );
    set(this.limits, note);
  }
}

/** @param {string} name @param {Asked} asked */
const emptyRow = (name, asked) =>
  element(
    'tr',
    { 'data-criterion': name },
    element('th', { scope: 'row' }, ...labelOf(name, asked)),
    ...['value', 'asked', 'verdict'].map(() => element('td')),
  );
