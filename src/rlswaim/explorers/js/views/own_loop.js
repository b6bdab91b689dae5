// The workbench for a loop that a reader types or pastes.
import { withCompensator } from '../page/compensator_words.js';
import { button, element, group, set } from '../page/elements.js';
import { IN_S } from '../page/words_in_s.js';
import { wordsInZ } from '../page/words_in_z.js';
import { OwnLoopState } from './own_loop_state.js';
import { Workbench } from './workbench.js';

/** @import { Context, Model } from '../types.d.ts' */

const REST = 250; // ms after the last letter
const HELP =
  'A fraction, zeros, poles and gain, or A, B, C, D, typed or as python-control and MATLAB print them. ' +
  'Add dt = 0.1 (or dt = True) for discrete time.';
/** @type {[string, string][]} */
const FORMS = [
  ['Expression', '10 (s + 2) / (s (s + 1) (s^2 + 2 s + 26))'],
  ['Numerator and denominator', 'num = [1, 3]\nden = [1, 4, 8, 0]\ndt = 0'],
  ['Zeros, poles, gain', 'zeros = [-2]\npoles = [0, -1+5j, -1-5j]\ngain = 4\ndt = 0'],
  ['State space', 'A = [[0, 1], [-4, -0.4]]\nB = [[0], [1]]\nC = [[1, 0.5]]\nD = [[0]]\ndt = 0'],
];

/** The field for the loop's text, with what is wrong with it. */
class LoopField {
  /** @param {(text: string) => void} act @param {string} text */
  constructor(act, text) {
    this.area = element('textarea', {
      rows: '4',
      spellcheck: 'false',
      autocapitalize: 'off',
      autocomplete: 'off',
      'aria-describedby': 'own-loop-help own-loop-wrong',
    });
    this.area.value = text;
    this.wrong = element('output', { class: 'wrong', id: 'own-loop-wrong' });
    this.form = element('span', { class: 'form' });
    let timer = 0;
    this.area.addEventListener('input', () => {
      clearTimeout(timer);
      timer = window.setTimeout(() => act(this.area.value), REST);
    });
    const forms = FORMS.map(([name, example]) => button(name, () => act(example)));
    const label = element('label', {}, element('b', {}, 'The open loop G'), ' ', this.form, this.area);
    const help = element('small', { id: 'own-loop-help' }, HELP);
    const begin = group('buttons', 'Forms', element('span', {}, 'Begin with'), ...forms);
    this.node = element('div', { class: 'loop-field' }, label, this.wrong, help, begin);
  }

  /** @param {string} text @param {string} wrong @param {string} form that was understood */
  show(text, wrong, form) {
    if (this.area.value !== text && document.activeElement !== this.area) this.area.value = text;
    set(this.wrong, wrong && `${wrong}. The loop before is shown.`);
    set(this.form, form);
    if (this.area.getAttribute('aria-invalid') !== String(Boolean(wrong)))
      this.area.setAttribute('aria-invalid', String(Boolean(wrong)));
  }
}

/** What was understood, in words. @param {import('../types.d.ts').System} system */
function formOf({ given, loop }) {
  const forms = {
    fraction: 'numerator and denominator',
    factors: 'zeros, poles, gain',
    states: 'A, B, C, D',
  };
  const time = loop.dt === true ? 'discrete' : loop.dt ? `discrete, dt = ${loop.dt} s` : 'continuous';
  const [n, m] = [loop.poles.x.length, loop.zeros.x.length];
  const form = forms[/** @type {keyof typeof forms} */ (given.form)];
  return `read as ${form}, ${time}: ${n} pole${n > 1 ? 's' : ''}, ${m || 'no'} zero${m === 1 ? '' : 's'}`;
}

export class OwnLoop extends Workbench {
  /** @param {Model} model @param {HTMLElement} el */
  constructor(model, el) {
    const state = new OwnLoopState(model);
    super(model, el, { state });
    this.field = new LoopField((loop) => state.set({ loop }), model.get('loop'));
    this.case = element('p', { class: 'case' });
    const presets = el.querySelector('.buttons');
    presets.before(this.field.node);
    presets.after(this.case);
    this.known = undefined;
  }

  #renew() {
    this.known = this.state.base;
    const { loop, branches } = this.known;
    this.words = loop.dt ? wordsInZ(loop.dt) : IN_S;
    return withCompensator(branches);
  }

  prepare() {
    const state = /** @type {OwnLoopState} */ (this.state);
    state.update();
    if (this.known !== state.base) this.page.recolor(this.#renew());
    this.field.show(state.model.get('loop'), state.wrong, formOf(state.base));
    const known = this.system.presets.find((_, i) => state.isDesign(i));
    set(this.case, known?.label ?? '');
  }
}

/** @param {Context} context */
export const render = ({ model, el }) => new OwnLoop(model, el).page.stop;
