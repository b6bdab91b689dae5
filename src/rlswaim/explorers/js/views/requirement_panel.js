// What is asked of the closed loop: bounds that are typed here, hatched in the s plane, and told to hold or
// not.

import { typedNumber } from '../drawing/numbers.js';
import { cutLoop, judgedMargins } from '../maths/cut_loop.js';
import { ASKED, findings, polesOfZ } from '../maths/requirements.js';
import { element, panel, set } from '../page/elements.js';
import { foundWords, isOffered, isSensible, textOfAsked, unitOf } from '../page/requirement_text.js';

/** @import { Workbench } from './workbench.js' */

const EXPLAINED =
  'The hatched part of the plane is where no pole may be, that of the Nichols diagram where the curve ' +
  'may not be. Settling time and overshoot are told by the poles: the slowest of them and the least damped ' +
  'pair, as if it were alone. Margins are those of the loop that is cut.';

export class RequirementPanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.rows = Object.entries(ASKED).map(([kind, asked]) => this.#row(kind, asked));
    const list = element('ul', { class: 'sections' }, ...this.rows.map(({ node }) => node));
    this.summary = element('p', { class: 'told' });
    const explained = element('p', { class: 'told fine' }, EXPLAINED);
    this.panel = panel('requirements', 'Requirements', () => this.show(), list, this.summary, explained);
    this.node = this.panel.node;
  }

  /** @param {string} kind @param {{ text: string, unit: string, fresh: number }} asked */
  #row(kind, { text, unit, fresh }) {
    const check = element('input', { type: 'checkbox' });
    const input = element('input', { type: 'text', inputmode: 'decimal', size: 6, value: String(fresh) });
    input.ariaLabel = `${text}${unit ? `, ${unit}` : ''}`;
    const said = element('span', { class: 'reading' });
    const label = element('label', {}, check, element('span', {}, ` ${text}`));
    const units = element('span', {}, unit);
    const act = () => this.#ask(kind, check.checked, input.value);
    check.addEventListener('change', act);
    input.addEventListener('change', () => {
      check.checked = true;
      act();
    });
    const node = element('li', { class: 'controls', 'data-asked': kind }, label, input, units, said);
    return { kind, check, input, units, said, node };
  }

  /** @param {string} kind @param {boolean} isAsked @param {string} text */
  #ask(kind, isAsked, text) {
    const { [kind]: before, ...others } = this.bench.state.asked;
    const typed = typedNumber(text);
    const bound = isSensible(kind, typed, Boolean(this.bench.state.period))
      ? typed
      : (before ?? ASKED[kind].fresh);
    const all = isAsked ? { ...others, [kind]: bound } : others;
    const ordered = Object.keys(ASKED).filter((name) => name in all);
    this.bench.look({
      requirements: textOfAsked(Object.fromEntries(ordered.map((name) => [name, all[name]]))),
    });
    this.show();
  }

  /** Shows which hold. */
  show() {
    const { state, system, poles } = this.bench;
    const { asked } = state;
    const count = Object.keys(asked).length;
    for (const { kind, check, input, units, node } of this.rows) {
      node.hidden = !isOffered(kind, Boolean(state.period));
      set(units, unitOf(kind, this.#dt));
      check.checked = kind in asked;
      if (kind in asked && document.activeElement !== input) input.value = String(asked[kind]);
    }
    if (count === 0) this.held = undefined;
    const found = count && poles ? this.#found(system, state) : [];
    for (const { kind, said, node } of this.rows) {
      const its = found.find((each) => each.kind === kind);
      set(said, its ? foundWords(its, this.#dt) : '');
      node.className = `controls ${its ? (its.holds ? 'stable' : 'unstable') : ''}`;
    }
    const failed = found.filter(({ holds }) => !holds).map(({ kind }) => ASKED[kind].text);
    const words = failed.length
      ? `${failed.length} of ${count} not met: ${failed.join(', ')}`
      : `all ${count} hold`;
    set(this.panel.extra, count ? words : 'none');
    set(this.summary, count ? `Requirements: ${words}.` : 'Nothing is asked for.');
  }

  get #dt() {
    return this.bench.system.loop?.dt ?? 0;
  }

  /** @param {any} system @param {Workbench['state']} state */
  #found(system, state) {
    const cut = cutLoop(system, state.values, state.what);
    const { isStable, period } = cut;
    const poles = period ? polesOfZ(this.bench.poles, period) : this.bench.poles;
    return findings(state.asked, { poles, margins: judgedMargins(system, cut), isStable });
  }
}
