// The root locus on the page: its picture and caption, its window, and its poles as movable points.

import { cameraOf, fitted, insetOf, windowOf, withinReach, zoomed } from '../drawing/camera.js';
import { contextOf } from '../drawing/context.js';
import { drawLocus } from '../drawing/locus_pictures.js';
import { nearestOn, nearestPole } from '../drawing/nearest.js';
import { number } from '../drawing/numbers.js';
import { requiredInZ, requiredRegion } from '../drawing/required_region.js';
import { gainAt } from '../maths/gain_at.js';
import { rootLocus } from '../maths/locus.js';
import { namedPoles } from '../maths/open_loop.js';
import { regionInZ, regionOf } from '../maths/requirements.js';
import { button, element, group, press, set, symbol } from '../page/elements.js';
import { movable, movableByKeys, placeOn } from '../page/movable_point.js';
import { groundOf, middleOf, windowKeys, zoomByWheel } from '../page/window_gestures.js';
import { LocusTip } from './locus_tip.js';
import { PoleButtons } from './pole_buttons.js';

/** @import { Camera, Graphics, Locus, NamedRoots, Pole, System, Values, View, What } from '../types.d.ts' */
/** @import { Extra } from '../drawing/locus_pictures.js' */
/** @import { Workbench } from './workbench.js' */

const KEYS_HELP =
  'Arrows step the running parameter, plus and minus zoom, 0 fits, Shift with arrows pans, ' +
  'Tab goes to the poles.';
const ZOOM = 1 / 0.7;
const CIRCLE = [-1, 1].map((x) => [x, 1]); // what a plane of z shows at least

/** A value of what runs, with its unit. @param {System} system @param {string} name */
export const runText = (system, name) => {
  const { unit } = system.running[name] ?? {};
  /** @param {number} value */
  return (value) => (unit ? `${number(value)} ${unit}` : number(value));
};

export class LocusPlane {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    /** @type {HTMLCanvasElement} */
    this.spare = undefined;
    this.ranged = '';
    this.open = '';
    this.canvas = element('canvas', {
      role: 'application',
      tabindex: '0',
      'data-plane': 'locus',
      'aria-description': KEYS_HELP,
    });
    this.tip = new LocusTip();
    this.poles = new PoleButtons((branch) => this.#open(branch));
    this.title = element('b', {}, 'Root locus');
    this.range = element('span');
    this.now = { marks: element('span'), name: element('span'), size: element('span'), off: element('span') };
    const now = element('small', {}, ...Object.values(this.now));
    const caption = element('figcaption', {}, element('span', {}, this.title, ', ', this.range), now);
    const over = [this.poles.node, this.tip.spot, this.tip.node, this.#tools()];
    this.node = element(
      'figure',
      { class: 'locus' },
      caption,
      element('div', { class: 'stage' }, this.canvas, ...over),
    );
    this.#listen();
  }

  #tools() {
    /** @param {number} factor */
    const zoom = (factor) => () => {
      const view = this.#next();
      const [px, py] = middleOf(view);
      this.#move(zoomed(view, factor, px, py));
    };
    this.lock = button(
      'Lock axes',
      () => this.#move(this.bench.state.shown.camera ? null : cameraOf(this.view)),
      {
        title: 'hold the window while sliders move',
        'aria-pressed': 'false',
      },
    );
    return group(
      'tools',
      'window',
      button('−', zoom(1 / ZOOM), { 'aria-label': 'zoom out' }),
      button('+', zoom(ZOOM), { 'aria-label': 'zoom in' }),
      button('Fit', () => this.#move(null), { title: 'show all poles (double click)' }),
      this.lock,
    );
  }

  #listen() {
    const { canvas } = this;
    const window = {
      view: () => this.#next(),
      move: (/** @type {Camera | null} */ camera) => this.#move(camera),
      hover: (/** @type {number[]} */ ...[px, py, reach]) => this.#hover(px, py, reach),
    };
    const ground = groundOf(window);
    const point = this.#point();
    movable(canvas, point, ground);
    this.stop = zoomByWheel(canvas, ground);
    canvas.addEventListener('dblclick', (event) => {
      const [px, py] = placeOn(canvas, event);
      if (point.grab(px, py, 9) < 0) ground.fit();
    });
    for (const node of [canvas, this.poles.node]) movableByKeys(node, point, windowKeys(window));
  }

  /**
   * A pole is a point that moves along its branch.
   * @returns {import('../page/movable_point.js').MovablePoint}
   */
  #point() {
    const { bench } = this;
    return {
      grab: (px, py, reach) => nearestPole(this.locus.present, this.#at(px, py).view, px, py, reach),
      drag: (branch, px, py) => {
        const { view } = this.#at(px, py);
        const own = this.locus.branches.map(({ t, x, y }) => ({ t, x: [x[branch]], y: [y[branch]] }));
        const { y } = nearestOn(own, view, px, py, Infinity);
        this.#run(branch, y, view, px, py);
      },
      drop: () => bench.page.history.settle(),
      open: (branch) => this.#open(branch),
      click: (px, py, reach) => {
        const { view, locus } = this.#at(px, py);
        const found = nearestOn(locus.branches, view, px, py, reach);
        if (found) this.#run(found.branch, found.y, view, px, py);
      },
      step: (right, up) => {
        const { running } = bench.state.what;
        bench.put(running, bench.state.stepped(running, right + up));
      },
    };
  }

  /** The window as it will be drawn next: more than one move may come in a frame. */
  #next() {
    const { camera } = this.bench.state.shown;
    return camera ? windowOf(camera, this.view.width, this.view.height) : this.view;
  }

  /**
   * What lies under the pointer: the plane, or the small window about the origin.
   * @param {number} px @param {number} py
   */
  #at(px, py) {
    return this.inset?.view.holds(px, py) ? this.inset : this;
  }

  /** @param {Camera | null} camera */
  #move(camera) {
    this.bench.look({ camera });
  }

  /**
   * Sets what runs to where a branch comes nearest to the pointer.
   * @param {number} branch @param {number} y of the branch there: its sign counts
   * @param {View} view @param {number} px @param {number} py
   */
  #run(branch, y, view, px, py) {
    const { system, state } = this.bench;
    const up = Math.abs(view.y(py)) * (y < 0 ? -1 : 1);
    const t = gainAt(
      system,
      state.values,
      state.what,
      branch,
      view.x(px),
      up,
      /** @type {any} */ (this.locus),
    );
    this.bench.put(state.what.running, state.place(state.what.running, t));
  }

  /** @param {number} branch */
  #open(branch) {
    const { x, y } = this.locus.present;
    this.bench.openMode(x[branch], y[branch]);
  }

  /** @param {number} [px] @param {number} [py] @param {number} [reach] */
  #hover(px, py, reach) {
    if (!this.locus) return;
    const { view, locus } = px === undefined ? this : this.#at(px, py);
    const place = px === undefined ? null : nearestOn(locus.branches, view, px, py, reach);
    const pole = place && nearestPole(locus.present, view, px, py, reach) >= 0;
    this.canvas.style.cursor = pole ? 'grab' : place ? 'pointer' : '';
    if (!place) return this.tip.hide();
    const { running } = this.bench.state.what;
    const text = runText(this.bench.system, running)(place.t);
    this.tip.show(place, view, this.locus.open.branches[place.branch], running, text);
  }

  /** Draws the present state. @param {number} width @param {number} height @param {NamedRoots} closed */
  draw(width, height, closed) {
    const { system, state } = this.bench;
    const { values, what, magnify } = state;
    const { camera, printed } = state.shown;
    /** @type {Pole[]} */
    const roots = system.presets[printed]?.printed ?? [];
    /** @type {View} */
    this.view = camera ? windowOf(camera, width, height) : this.#fit(width, height, closed, roots);
    /** @type {Locus} */
    this.locus = rootLocus(system, values, this.view, what);
    this.inset = null;
    if (magnify > 1) {
      const view = insetOf(this.view, magnify);
      this.inset = { view, magnify, locus: /** @type {Locus} */ (rootLocus(system, values, view, what)) };
    }
    /** @type {Extra} */
    this.extra = {
      printed: state.isDesign(printed) && state.isOwnVehicle ? roots : [],
      cloud: this.bench.vehicle.cloud.points,
      selected: this.bench.selected(closed),
      region: state.period
        ? requiredInZ(regionInZ(state.asked, state.period))
        : requiredRegion(regionOf(state.asked)),
      inset: this.inset,
      discrete: Boolean(system.loop?.dt),
    };
    this.paint(contextOf(this.canvas, width, height));
    this.poles.place(this.locus.present, this.view);
    this.#say(values, what);
    press(this.lock, Boolean(camera));
  }

  /** Draws the locus of other values in the present window, where nobody sees it. @param {Values} values */
  rehearse(values) {
    const { system, state, page } = this.bench;
    this.spare ??= element('canvas');
    const g = contextOf(this.spare, this.view.width, this.view.height);
    drawLocus(g, this.view, page.theme, rootLocus(system, values, this.view, state.what), this.extra);
  }

  /** @param {Graphics} g */
  paint(g) {
    drawLocus(g, this.view, this.bench.page.theme, this.locus, this.extra);
  }

  /**
   * The window that holds all poles: open, closed, and printed.
   * @param {number} width @param {number} height @param {NamedRoots} closed @param {Pole[]} printed
   */
  #fit(width, height, closed, printed) {
    const { system, state, shared } = this.bench;
    const near = [namedPoles(system, state.values), closed].flatMap((roots) => withinReach(system, roots));
    const circle = system.loop?.dt ? CIRCLE : [];
    const points = [...near, ...circle, ...printed.map(({ re, im }) => [re, im])];
    return fitted(shared?.with(this.bench, points) ?? points, width, height);
  }

  /** @param {Values} values @param {What} what */
  #say(values, { running, of, off = [], gain, name }) {
    const text = runText(this.bench.system, running);
    set(this.title, of === 'zeros' ? `Zeros of the loop in ${gain}` : 'Root locus');
    const range = ` from ${text(this.locus.from ?? 0)} to ${text(this.locus.end)}`;
    if (this.ranged !== running + range) {
      this.ranged = running + range;
      this.range.replaceChildren(...symbol(running), range);
      this.now.name.replaceChildren(...symbol(running));
    }
    set(this.now.marks, `${name && name !== running ? `${name}: ` : ''}filled marks at `);
    set(this.now.size, ` = ${text(values[running])}`);
    const still = off.filter((other) => other !== running);
    if (this.open === still.join()) return;
    this.open = still.join();
    const names = still.flatMap((other, k) => [k ? ', ' : ', with ', ...symbol(other)]);
    this.now.off.replaceChildren(...names, ...(names.length ? [' = 0'] : []));
  }

  /** Words that may lag a little behind the picture. @param {string} words */
  later(words) {
    const { state, system } = this.bench;
    const { running } = state.what;
    const { present, end, from = 0, open } = this.locus;
    const text = runText(system, running);
    const range = `Root locus in ${running} from ${text(from)} to ${text(end)}`;
    this.canvas.ariaLabel = `${range}. At ${running} = ${text(state.values[running])}: ${words}`;
    this.poles.tell(present, open.branches);
  }
}
