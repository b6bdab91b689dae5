// A small root locus whose gain runs by itself: the poles wander along it until the reader stops them,
// moves the gain by hand, or goes on to the workbench.
import { windowOf } from '../drawing/camera.js';
import { contextOf } from '../drawing/context.js';
import { drawLocus } from '../drawing/locus_pictures.js';
import { number } from '../drawing/numbers.js';
import { rootLocus } from '../maths/locus.js';
import { addressWith, inLab } from '../page/address.js';
import { button, element, picture, set, symbol } from '../page/elements.js';
import { onThemeChange, themeOf } from '../page/theme.js';
import { VerdictLine, verdict } from '../page/verdict.js';

/** @import { Context, Locus, Model, System, Theme, Values } from '../types.d.ts' */

const PERIOD = 40; // s from the least gain to the largest and back
const EVERY = 40; // ms between two pictures
const STEPS = 1000; // places of the slider
/** @type {import('../drawing/locus_pictures.js').Extra} */
const EXTRA = { printed: [], selected: null, inset: null };

class MovingLoop {
  /** @param {Model} model @param {HTMLElement} el */
  constructor(model, el) {
    this.el = el;
    /** @type {System & { window: import('../types.d.ts').Camera, range: [number, number], page: string }} */
    this.system = model.get('payload');
    this.gain = this.system.locus_gains.at(-1);
    /** @type {Values} */
    this.values = { ...this.system.initial };
    /** @type {Theme} */
    this.theme = undefined;
    this.verdict = new VerdictLine();
    const { canvas, figure } = picture('loop', {}, 'Root locus of a rate and attitude loop');
    this.canvas = canvas;
    this.slider = element('input', { type: 'range', min: 0, max: STEPS, 'aria-label': `gain ${this.gain}` });
    this.size = element('output');
    this.runButton = button('', () => this.#run(!this.runs));
    this.link = element('a', { class: 'onward', hidden: inLab() }, 'Move all gains in chapter IV');
    const label = element('span', {}, ...symbol(this.gain));
    const row = element(
      'div',
      { class: 'controls' },
      this.runButton,
      label,
      this.slider,
      this.size,
      this.link,
    );
    el.classList.add('rlswaim-explorer', 'rlswaim-moving');
    el.dataset.explorer = this.system.system;
    el.append(figure, row, this.verdict.node);
    this.#listen();
    this.runs = false;
    this.frame = 0;
    this.last = 0;
    this.#put(this.#placeOf(this.values[this.gain]));
    this.#run(!matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  #listen() {
    this.seen = false;
    this.watch = new IntersectionObserver((entries) => {
      this.seen = entries.at(-1).isIntersecting;
      this.#next();
    });
    this.resized = new ResizeObserver(() => this.#draw());
    this.slider.addEventListener('input', () => {
      this.#run(false);
      this.#put(Number(this.slider.value) / STEPS);
      this.#draw();
    });
    this.unwatch = onThemeChange(() => {
      this.theme = undefined;
      this.#draw();
    });
    this.watch.observe(this.canvas);
    this.resized.observe(this.canvas);
  }

  /** The share of the way, on a scale of equal ratios, at which a gain lies. @param {number} gain */
  #placeOf(gain) {
    const [least, most] = this.system.range;
    return Math.log(gain / least) / Math.log(most / least);
  }

  /** @param {number} place from 0 to 1 */
  #put(place) {
    const [least, most] = this.system.range;
    this.place = place;
    this.values[this.gain] = Number((least * (most / least) ** place).toPrecision(3));
  }

  /** @param {boolean} runs */
  #run(runs) {
    this.runs = runs;
    this.began = undefined;
    set(this.runButton, runs ? 'Pause' : 'Let the gain run');
    this.#next();
  }

  #next() {
    if (!this.runs || !this.seen) return;
    this.frame ||= requestAnimationFrame((now) => {
      this.frame = 0;
      if (now - this.last >= EVERY) this.#step(now);
      this.#next();
    });
  }

  /** On from where the gain is: to and fro, slower at the ends. @param {number} now ms */
  #step(now) {
    this.last = now;
    const phase = Math.acos(1 - 2 * Math.min(Math.max(this.place, 0), 1)) / (2 * Math.PI);
    this.began ??= now - phase * 1000 * PERIOD;
    this.#put((1 - Math.cos((2 * Math.PI * (now - this.began)) / (1000 * PERIOD))) / 2);
    this.#draw();
  }

  #draw() {
    const { system, values, canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0) return;
    this.theme ??= themeOf(this.el, system.branches);
    const view = windowOf(system.window, width, height);
    const locus = /** @type {Locus} */ (rootLocus(system, values, view));
    drawLocus(contextOf(canvas, width, height), view, this.theme, locus, EXTRA);
    this.#tell(locus);
    this.el.dispatchEvent(new CustomEvent('rlswaim:drawn', { bubbles: true, detail: { ms: 0 } }));
  }

  /** @param {Locus} locus */
  #tell({ present, open }) {
    const { x, y } = present;
    const poles = open.branches.map((name, i) => ({ re: x[i], im: y[i], name }));
    const found = verdict(poles);
    const size = number(this.values[this.gain], 3);
    this.verdict.show(found);
    set(this.size, size);
    this.slider.value = String(Math.round(this.place * STEPS));
    this.slider.ariaValueText = size;
    this.link.href = `${this.system.page}${addressWith(this.system.workbench, this.values, '')}`;
    this.canvas.ariaLabel = `Root locus in ${this.gain} at ${size}: ${found.word.toLowerCase()}${found.long}`;
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.runs = false;
    this.watch.disconnect();
    this.resized.disconnect();
    this.unwatch();
  }
}

/** @param {Context} context */
export function render({ model, el }) {
  const loop = new MovingLoop(model, el);
  return () => loop.stop();
}
