// The desk: a workbench that fills the window, with its sliders, its locus and the panels that are chosen in
// sight together. It takes any panel that a workbench has.
import { button, element, group, press } from '../page/elements.js';
import { Layer } from '../page/layer.js';
import { splitter } from '../page/splitter.js';
import { RANGE, START } from './desk_state.js';

/** @import { Workbench } from './workbench.js' */
/** @import { DeskState } from './desk_state.js' */

const FIRST = ['map', 'poles']; // they stand beside and under the locus, as desk.css has it
const LEAST = 120; // px for a picture

/** @param {HTMLElement} node @returns {string} */
const keyOf = ({ dataset }) => dataset.panel;

/** The place of a panel among all. @param {HTMLElement} node */
const rankOf = (node) => (FIRST.includes(keyOf(node)) ? FIRST.indexOf(keyOf(node)) : FIRST.length);

export class Desk {
  /**
   * @param {Workbench} bench @param {HTMLElement} el
   * @param {HTMLElement} work what holds the locus, and the panels
   */
  constructor(bench, el, work) {
    this.bench = bench;
    this.el = el;
    this.work = work;
    /** @type {Layer} */
    this.layer = undefined;
    /** @type {Map<Element, number>} */
    this.rooms = new Map();
    this.button = button('Desk', () => this.#toggle(), {
      title: 'sliders, locus and panels together in the whole window (Escape leaves)',
      'aria-pressed': 'false',
    });
    this.choices = element('span');
    const leave = button('Close', () => this.#set(null), { title: 'leave the desk (Escape)' });
    this.node = group('chooser', 'Panels', element('span', {}, 'Show'), this.choices, leave);
    this.splits = this.#splitters();
    work.append(...this.splits.map(({ node }) => node));
    this.resized = new ResizeObserver(() => this.#measure());
  }

  #splitters() {
    /** @param {'across' | 'down'} name @param {string} label */
    const split = (name, label) =>
      splitter({
        label,
        isUpright: name === 'across',
        range: RANGE,
        get: () => this.state?.[name] ?? START[name],
        put: (percent) => this.#set({ ...this.state, [name]: percent }),
        restore: () => this.#set({ ...this.state, [name]: START[name] }),
      });
    return [split('across', 'Width of the locus'), split('down', 'Height of the first row')];
  }

  /** @returns {DeskState | null} null while it is closed */
  get state() {
    return this.bench.state.shown.desk;
  }

  get panels() {
    return /** @type {HTMLDetailsElement[]} */ ([...this.work.querySelectorAll('details.panel')]);
  }

  get #open() {
    return this.panels.filter(({ open }) => open).map(keyOf);
  }

  /**
   * The height that a panel has for its picture; undefined where the page gives it what it likes.
   * @param {Element} canvas
   */
  room(canvas) {
    return this.layer?.isOpen ? this.rooms.get(canvas) : undefined;
  }

  #toggle() {
    this.#set(this.state ? null : { ...START, panels: this.#open });
  }

  /** @param {DeskState | null} desk */
  #set(desk) {
    this.bench.look({ desk });
    this.follow();
  }

  /** The page follows the state. */
  follow() {
    const { state } = this;
    this.layer ??= new Layer(this.el.closest('.widget-vbox') ?? this.el, () => this.#set(null));
    const wasOpen = this.layer.isOpen;
    press(this.button, Boolean(state));
    if (!state) {
      this.layer.close();
      this.resized.disconnect();
      if (wasOpen) this.bench.page.follow();
      return;
    }
    state.panels ??= this.#open;
    for (const name of /** @type {const} */ (['across', 'down']))
      this.work.style.setProperty(`--${name}`, `${state[name]}%`);
    for (const { tell } of this.splits) tell();
    for (const node of this.panels) node.open = state.panels.includes(keyOf(node));
    this.layer.open();
    if (!wasOpen) for (const node of [this.el, ...this.panels]) this.resized.observe(node);
    this.#arrange();
  }

  /** A button for each panel, when all are there. */
  begin() {
    const made = this.panels.map((node) => {
      node.addEventListener('toggle', () => this.#chosen());
      return button(node.querySelector('summary b').textContent.split(':')[0], () => {
        node.open = !node.open;
      });
    });
    this.choices.append(...made);
  }

  #chosen() {
    if (this.state) this.#set({ ...this.state, panels: this.#open });
  }

  /** A last panel that would stand alone in its row takes the whole row. */
  #arrange() {
    const open = this.panels.filter((node) => node.open);
    const last = [...open].sort((a, b) => rankOf(a) - rankOf(b)).at(-1);
    for (const node of this.panels) node.classList.toggle('last', node === last);
    this.work.dataset.count = open.length % 2 ? 'odd' : 'even';
    [...this.choices.children].forEach((choice, k) => {
      press(/** @type {HTMLElement} */ (choice), this.panels[k].open);
    });
  }

  /** Notes how much room each picture has. */
  #measure() {
    for (const node of this.panels) {
      const canvas = node.open && node.querySelector('canvas');
      if (canvas) this.rooms.set(canvas, Math.max(LEAST, node.clientHeight - canvas.offsetTop - 6));
    }
    const { node } = this.layer;
    const top = this.work.getBoundingClientRect().top - node.getBoundingClientRect().top + node.scrollTop;
    node.style.setProperty('--work-top', `${Math.round(top)}px`);
    this.bench.page.follow();
  }

  stop() {
    this.resized.disconnect();
    this.layer?.close();
  }
}
