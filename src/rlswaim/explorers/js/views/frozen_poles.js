// The poles of a fixed and of a scheduled design, the vehicle frozen at a time of the burn, with their trail.
import { contextOf } from '../drawing/context.js';
import { dot, mark, signsOf } from '../drawing/marks.js';
import { number } from '../drawing/numbers.js';
import { sPlane } from '../drawing/s_plane.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { element, legend, picture, scrolling, set } from '../page/elements.js';
import { PoleTable } from '../page/pole_table.js';
import { pace } from '../page/verdict.js';
import { simple } from './simple_view.js';

/** @import { Pole, Theme, Values } from '../types.d.ts' */
/** @import { Layer } from '../drawing/plane.js' */
/** @import { Lifecycle } from '../page/lifecycle.js' */

const TITLE = 'Poles of both loops, the vehicle frozen';
const SIDE = [-2.2, 0.8]; // 1/s
const UP = [-0.2, 8]; // rad/s

/** A pole and its mirror image. @param {Pole} pole @returns {Pole[]} */
const both = (pole) => (pole.im > 0 ? [pole, { ...pole, im: -pole.im }] : [pole]);

class FrozenPoles {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    /** @type {string[]} */
    this.names = Object.keys(payload.poles);
    this.words = element('p', { class: 'verdict' });
    this.what = element('span');
    const { canvas, figure } = picture('poles', {}, element('b', {}, 'Frozen poles'), this.what);
    this.canvases = [canvas];
    const caption = `${TITLE}: those up to ${payload.within} rad/s`;
    this.table = new PoleTable(element('caption', {}, caption), 'design');
    /** @type {[string, string][]} */
    const signs = [...signsOf(this.names)].map(([name, sign]) => [sign, `${name} design`]);
    this.nodes = [
      this.words,
      figure,
      legend([...signs, ['·', 'the seconds before']]),
      scrolling(TITLE, this.table.node),
    ];
  }

  /** The poles on the axis and above. @param {string} name @param {number} t @returns {Pole[]} */
  #upper(name, t) {
    /** @type {number[][]} */
    const found = this.payload.poles[name][t];
    return found.map(([re, im]) => ({ re, im, name }));
  }

  /** @param {Values} values @param {Theme} theme @returns {Layer[]} */
  #marks({ t, trail }, theme) {
    const first = Math.max(0, t - trail);
    const before = Array.from({ length: t - first }, (_, k) => first + k);
    const dots = before.flatMap((at) => this.names.flatMap((name) => this.#upper(name, at)));
    const here = this.names.flatMap((name) => this.#upper(name, t));
    return [
      ...dots.map(({ re, im, name }) => dot(re, im, theme.color(name))),
      ...here.map(({ re, im, name }) => mark(theme.sign(name), re, im, theme.color(name))),
    ];
  }

  /** @param {string} name @param {number} t */
  #told(name, t) {
    const [{ re, im }] = this.#upper(name, t);
    const at = `${re > 0 ? '+' : ''}${number(re)}${im ? ` ± ${number(im)}j` : ''} 1/s`;
    if (re === 0) return `${name}: on the axis, a root at ${at} neither grows nor decays`;
    return `${name}: ${re > 0 ? 'lost' : 'held'}, the root at ${at} ${pace(re)}`;
  }

  /** The time of the design that the schedule flies. @param {number} t */
  #madeFor(t) {
    /** @type {number[][]} */
    const switched = this.payload.switched;
    return switched.filter(([begins]) => begins <= t).at(-1)[1];
  }

  /** @param {Values} values @param {Lifecycle} page */
  draw(values, page) {
    const { t } = values;
    const [canvas] = this.canvases;
    const [width, height] = page.sizeOf(canvas);
    const view = viewOf(SIDE, UP, frameOf(width, height), width, height);
    sPlane(contextOf(canvas, width, height), view, page.theme, ...this.#marks(values, page.theme));
    const told = this.names.map((name) => this.#told(name, t)).join('; ');
    const said = `At ${t} s, ${told}. The schedule flies the design made for ${this.#madeFor(t)} s.`;
    set(this.words, said);
    set(this.what, ` at ${t} s`);
    const poles = this.names.flatMap((name) => this.#upper(name, t).flatMap(both));
    this.table.show(poles, page.theme);
    canvas.ariaLabel = `${TITLE}. ${said}`;
    return said;
  }
}

export const render = simple(FrozenPoles);
