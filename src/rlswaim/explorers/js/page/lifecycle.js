// The life of a view on its page: when it is drawn, its theme and size, its undo, its part of the page's
// address.
import { goToAddressed, nameOf, onAddress, readAddress, writeAddress } from './address.js';
import { element, set } from './elements.js';
import { Notice } from './notice.js';
import { Redraw } from './redraw.js';
import { roundSteps } from './slider_keys.js';
import { nameSliders } from './slider_names.js';
import { keepInSight } from './slider_rows.js';
import { onThemeChange, themeOf } from './theme.js';
import { onUndoKeys, UndoHistory } from './undo.js';

/** @import { Theme } from '../types.d.ts' */
/** @import { ParameterState } from './parameter_state.js' */
/**
 * @typedef {object} View what a lifecycle asks of a view
 * @property {ParameterState} state
 * @property {Record<string, string>} colors
 * @property {HTMLCanvasElement[]} canvases nothing is drawn before the first has a size
 * @property {() => string} draw the same state gives the same picture, and words for it
 * @property {() => void} [later] what may lag behind the picture
 * @property {() => void} [stop]
 * @property {(texts: Record<string, string>) => void} [arrived] what an address says beside the state
 */

const LAG = 160; // ms until what nobody watches follows the picture

/** A page that is loaded again or gone back to keeps its place. */
export const isNewHere = () => {
  const [entry] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
  return entry?.type === 'navigate';
};

export class Lifecycle {
  /** @param {HTMLElement} el @param {string} system @param {View} view */
  constructor(el, system, view) {
    this.el = el;
    this.view = view;
    this.live = element('span', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
    /** @type {Theme} */
    this.theme = undefined;
    /** @type {Map<Element, [number, number]>} */
    this.sizes = new Map();
    this.timer = 0;
    this.words = '';
    this.arrived = false;
    this.prints = false;
    this.unkeySliders = () => {};
    this.unnameSliders = () => {};
    this.freeSliders = () => {};
    this.notice = new Notice(() => this.reset());
    el.append(this.notice.node);
    el.classList.add('rlswaim-explorer');
    el.dataset.explorer = system;
    el.dataset.lmSuppressShortcuts = 'true'; // JupyterLab keeps its own keys out
    this.redraw = new Redraw(el, () => this.#draw());
    this.history = new UndoHistory({
      snapshot: () => view.state.snapshot(),
      restore: (snapshot) => {
        view.state.restore(snapshot);
        this.redraw.now();
      },
    });
    this.#listen();
  }

  get name() {
    return nameOf(this.el);
  }

  get seen() {
    return this.redraw.seen;
  }

  /** Width and height of a canvas in CSS px, as last laid out. @param {Element} canvas */
  sizeOf(canvas) {
    return this.sizes.get(canvas) ?? [0, 0];
  }

  /** The state changed under the hand. */
  changed() {
    this.notice.clear();
    this.history.note();
    this.redraw.now();
  }

  /** Other things are drawn from now on. @param {Record<string, string>} colors */
  recolor(colors) {
    this.view.colors = colors;
    this.theme = themeOf(this.el, colors);
  }

  /** Something changed that the page brings about, not the hand. */
  follow() {
    this.redraw.next();
  }

  /** Back to the start of the view. */
  reset() {
    this.view.state.reset();
    this.changed();
  }

  #listen() {
    const { el, view } = this;
    const { model, watched } = view.state;
    const changed = () => this.changed();
    for (const name of watched) model.on(`change:${name}`, changed);
    const resized = new ResizeObserver(() => this.#measure());
    for (const canvas of view.canvases) resized.observe(canvas);
    const unwatch = onThemeChange(() => {
      if (this.theme) this.theme = themeOf(el, view.colors); // at once: what moves by itself doesn't wait
      this.follow();
    });
    const unkey = onUndoKeys(el, this.history);
    const unfollow = onAddress((hash) => this.#readAddress(true, hash));
    const print = () => this.#print();
    addEventListener('beforeprint', print);
    this.stop = () => {
      this.redraw.stop();
      this.history.stop();
      clearTimeout(this.timer);
      resized.disconnect();
      unwatch();
      unkey();
      this.unkeySliders();
      this.unnameSliders();
      this.freeSliders();
      unfollow();
      removeEventListener('beforeprint', print);
      for (const name of watched) model.off(`change:${name}`, changed);
      view.stop?.();
    };
  }

  #measure() {
    if (!this.arrived && this.el.isConnected) {
      this.arrived = true;
      requestAnimationFrame(() => this.#arrive()); // it changes the layout, which is just being measured
    }
    if (this.view.canvases.map((canvas) => this.#resized(canvas)).some(Boolean)) this.follow();
  }

  #arrive() {
    this.#takeSliders();
    this.#readAddress(isNewHere());
    this.history.begin();
  }

  #takeSliders() {
    const { own, model } = this.view.state;
    if (this.el.closest('.bench')) return; // a bench that the page alone holds has sliders of its own
    /** @type {HTMLElement} */
    const panel = this.el.closest('.widget-vbox');
    if (!panel) return;
    this.unnameSliders = nameSliders(panel, own, model);
    this.unkeySliders = roundSteps(panel, own, model, (note) => this.notice.typed(note));
    this.freeSliders = keepInSight(panel);
  }

  /**
   * Notes the size that the layout gives a canvas; a height that the drawing has set is its own.
   * @param {HTMLElement} canvas
   */
  #resized(canvas) {
    const [before, above] = this.sizeOf(canvas);
    const { clientWidth: width, clientHeight: height } = canvas;
    this.sizes.set(canvas, [width, height]);
    return width !== before || (height !== above && canvas.style.height === '');
  }

  /** What goes wrong is told, and stops nothing that comes later. */
  #draw() {
    if (this.sizeOf(this.view.canvases[0])[0] === 0) return; // not on the page yet
    try {
      this.#drawn();
      this.notice.mended();
    } catch (error) {
      this.notice.failed(error);
    }
  }

  /** Paper shows all that is open, whether somebody sees it or not, and waits for nothing. */
  #print() {
    this.prints = true;
    this.#draw();
    this.prints = false;
  }

  #drawn() {
    const { el, view } = this;
    const start = performance.now();
    this.theme ??= themeOf(el, view.colors);
    const first = this.words === '';
    this.words = view.draw();
    const detail = { ms: performance.now() - start };
    if (first) set(this.live, this.words);
    el.dispatchEvent(new CustomEvent('rlswaim:drawn', { bubbles: true, detail }));
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.#later(), LAG);
  }

  #later() {
    try {
      this.later();
    } catch (error) {
      this.notice.failed(error);
    }
  }

  /** Words for a screen reader and the address follow when the hand rests. */
  later() {
    if (this.words === '') return;
    set(this.live, this.words);
    this.view.later?.();
    this.writeAddress();
  }

  writeAddress() {
    writeAddress(this.name, this.view.state.toAddress());
  }

  /**
   * @param {boolean} shows whether the page goes to the view that the address is about
   * @param {string} [hash] the address if it is not the page's
   */
  #readAddress(shows, hash) {
    const texts = readAddress(this.name, hash);
    if (Object.keys(texts).length === 0) return;
    const notes = this.view.state.fromAddress(texts);
    this.view.arrived?.(texts);
    this.notice.opened(notes);
    this.follow();
    if (shows) goToAddressed(this.el, this.name, hash);
  }
}
