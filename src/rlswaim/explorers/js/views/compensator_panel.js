// A compensator in the loop: its place, its gain and its sections, which are added, typed and taken out here.

import { number, typedNumber } from '../drawing/numbers.js';
import { isProper, KINDS, kindsOf } from '../maths/compensator.js';
import { movementOf } from '../maths/moved_roots.js';
import { bounded, textOf } from '../page/compensator_text.js';
import { placeWords, ratioWords } from '../page/compensator_words.js';
import { button, element, panel, select, set } from '../page/elements.js';
import { Grips } from './compensator_grips.js';

/** @import { Compensator, Section } from '../maths/compensator.js' */
/** @import { Workbench } from './workbench.js' */

const WITHOUT =
  'It is in the locus, the poles, the verdict, the margins, the frequency response, the pole map, the mode ' +
  'shape and the responses. Other views of the page are without it.';
const IN_OWN_LOOP =
  'It is in the locus, the poles, the verdict, the margins, the frequency response and the step response.';
const LEFT_OUT =
  ' A pure delay is whole samples, poles at z = 0; part of a sample is not offered, as no z⁻ⁿ has it.';

export class CompensatorPanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    const { state } = bench;
    /** @type {[string, string][]} */
    const places = state.places.map((name) => [name, name]);
    this.places = select('in the path of', places, (place) => this.#put({ ...this.#now(), place }));
    this.gain = this.#field('gain', (value) => this.#put({ ...this.#now(), gain: value }));
    this.kinds = select('Section', [], () => {});
    this.add = button('Add', () => this.#add());
    this.clear = button('Take it out', () => this.bench.look({ compensator: '' }));
    this.list = element('ul', { class: 'sections' });
    this.words = element('p', { class: 'told' });
    const first = element('div', { class: 'controls' }, this.kinds.node, this.add, this.places.node);
    const second = element('div', { class: 'controls' }, this.gain.node, this.clear);
    this.rest = element('div', {}, second, this.list);
    this.panel = panel('compensator', 'Compensator', () => {}, first, this.rest, this.words);
    this.node = this.panel.node;
    this.grips = [this.#onPlane(), this.#onBode()];
    this.shown = '-';
    this.kindsShown = '';
    this.offered = '';
  }

  /** Offers the kinds of sections of continuous or discrete time. */
  #offer() {
    const kinds = kindsOf(this.#isDiscrete);
    if (this.offered === kinds.join()) return;
    this.offered = kinds.join();
    const options = kinds.map((kind) => element('option', { value: kind }, KINDS[kind].text));
    this.kinds.list.replaceChildren(...options);
  }

  get #isDiscrete() {
    return Boolean(this.bench.state.period);
  }

  get #movement() {
    return movementOf(this.bench.state.period);
  }

  #onPlane() {
    const { plane } = this.bench;
    return new Grips(plane.canvas.parentElement, {
      ...this.#puts(),
      view: () => plane.view,
      spot: ({ re, im }, view) => ({ x: view.X(re), y: view.Y(im) }),
      moved: ({ im }, x, y) => [plane.view.x(x), im === 0 ? 0 : plane.view.y(y)],
    });
  }

  /** On the Bode diagram a root goes with its frequency. */
  #onBode() {
    const { frequency } = this.bench;
    return new Grips(frequency.stage, {
      ...this.#puts(),
      view: () => frequency.bode,
      spot: (grip, view) => {
        const at = Math.log10(this.#movement.omega(grip.re, grip.im) || 1e-9);
        return { x: view.X(at), y: view.frame.y + (grip.isZero ? 12 : view.frame.h - 12) };
      },
      moved: ({ re, im }, x) => this.#movement.at(re, im, 10 ** frequency.bode.x(x)),
    });
  }

  #puts() {
    return {
      put: (/** @type {number} */ at, /** @type {number[]} */ values) => this.#change(at, values),
      drop: () => this.bench.page.history.settle(),
      stepped: (/** @type {[number, number, number, number]} */ ...step) => this.#movement.stepped(...step),
      told: (/** @type {number} */ re, /** @type {number} */ im) => placeWords(re, im, this.#isDiscrete),
    };
  }

  /**
   * A box for a number, which takes effect when it is left or with Enter.
   * @param {string} label @param {(value: number) => void} act
   */
  #field(label, act) {
    const input = element('input', { type: 'text', inputmode: 'decimal', size: 8 });
    input.addEventListener('change', () => {
      const value = typedNumber(input.value);
      if (Number.isFinite(value)) act(value);
      this.shown = '-';
      this.show();
    });
    return { input, node: element('label', {}, element('span', {}, label), input) };
  }

  /** @returns {Compensator} */
  #now() {
    const { state } = this.bench;
    return state.compensator ?? { place: this.places.list.value || state.places[0], gain: 1, sections: [] };
  }

  /** Puts it into the loop; returns whether it fits there. @param {Compensator} compensator */
  #put(compensator) {
    const text = textOf(compensator);
    const fits = Boolean(this.bench.state.compensatorFrom(text));
    if (fits) this.bench.look({ compensator: text });
    return fits;
  }

  #add() {
    const now = this.#now();
    const kind = this.kinds.list.value;
    const omega = Number(this.#frequency().toPrecision(3)) * (this.bench.state.period || 1);
    const values = KINDS[kind].fresh(omega).map((value, k) => bounded(kind, k, value));
    const section = { kind, values };
    const sections = [...now.sections, section];
    if (!this.#put({ ...now, sections }))
      set(this.words, 'No more sections: the loop would be too long to be drawn at once.');
  }

  /** Where a new section goes: the marked frequency, or that of the pair that decays most slowly. */
  #frequency() {
    const { frequency, poles } = this.bench;
    if (frequency.marked > 0) return frequency.marked;
    const isDiscrete = this.#isDiscrete;
    /** @param {{ re: number, im: number }} pole */
    const growth = ({ re, im }) => (isDiscrete ? Math.hypot(re, im) : re);
    const [slowest] = poles.filter(({ im }) => im > 0).sort((a, b) => growth(b) - growth(a));
    if (slowest) return this.#movement.omega(slowest.re, slowest.im);
    return isDiscrete ? 1 / (10 * this.bench.state.period) : 1;
  }

  /**
   * Sets the numbers of a section, within their bounds.
   * @param {number} at @param {number[]} values
   */
  #change(at, values) {
    const now = this.#now();
    /** @param {string} kind */
    const within = (kind) => values.map((value, k) => bounded(kind, k, value));
    const sections = now.sections.map((old, i) =>
      i === at ? { kind: old.kind, values: within(old.kind) } : old,
    );
    this.#put({ ...now, sections });
  }

  /** @param {number} at @param {number} k @param {number} value */
  #set(at, k, value) {
    const { values } = this.#now().sections[at];
    this.#change(
      at,
      values.map((old, i) => (i === k ? value : old)),
    );
  }

  /** @param {Section} section @param {number} at */
  #row({ kind }, at) {
    const { text, names } = KINDS[kind];
    const fields = names.map((name, k) => this.#field(name, (value) => this.#set(at, k, value)));
    const remove = button('Remove', () => {
      const now = this.#now();
      this.#put({ ...now, sections: now.sections.filter((_, i) => i !== at) });
    });
    remove.ariaLabel = `Remove ${text}, section ${at + 1}`;
    const node = element(
      'li',
      { class: 'controls' },
      element('b', {}, text),
      ...fields.map((f) => f.node),
      remove,
    );
    return { node, inputs: fields.map(({ input }) => input) };
  }

  /** The rings about its roots, where the pictures now have them. */
  place() {
    const sections = this.bench.state.compensator?.sections ?? [];
    for (const grips of this.grips) grips.show(sections);
  }

  /** Shows the present compensator. */
  show() {
    this.place();
    this.#offer();
    const { shown } = this.bench.state;
    if (this.shown === shown.compensator) return;
    this.shown = shown.compensator;
    const { compensator } = this.bench.state;
    const now = this.#now();
    this.rest.hidden = !compensator;
    this.places.choose(now.place);
    this.gain.input.value = String(now.gain);
    const kinds = now.sections.map(({ kind }) => kind).join();
    if (this.kindsShown !== kinds) {
      this.kindsShown = kinds;
      this.rows = now.sections.map((section, at) => this.#row(section, at));
      this.list.replaceChildren(...this.rows.map(({ node }) => node));
    }
    now.sections.forEach(({ values }, at) => {
      values.forEach((value, k) => {
        this.rows[at].inputs[k].value = String(value);
      });
    });
    set(this.panel.extra, compensator ? ratioWords(compensator) : 'none');
    set(this.words, compensator ? this.#told(compensator) : 'No compensator is in the loop.');
  }

  /** @param {Compensator} compensator */
  #told(compensator) {
    const { place } = compensator;
    if (!isProper(compensator))
      return 'It has more zeros than poles, so it cannot be built and is left out until a pole is added.';
    const [of, rest] = this.#isDiscrete ? ['z', 'z = 1'] : ['s', 's = 0'];
    const gain = number(compensator.gain);
    const its = `C(${of}) = ${gain} times its sections, each 1 at ${rest} where it can be,`;
    if (this.bench.system.loop)
      return [
        `${its} stands before G(${of}): the loop is ${place} C G. ${IN_OWN_LOOP}`,
        this.#isDiscrete ? LEFT_OUT : '',
      ].join('');
    return (
      `${its} stands in the path of ${place}, before its actuator: the signal is multiplied by ` +
      `${place} C(s). ${WITHOUT}`
    );
  }
}
