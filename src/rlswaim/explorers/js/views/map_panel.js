// The closed-loop poles as a station runs along the vehicle; a click picks the station, a drag moves it.
import { fitted, windowOf, withinReach } from '../drawing/camera.js';
import { contextOf } from '../drawing/context.js';
import { letterOf } from '../drawing/letters.js';
import { drawMap } from '../drawing/locus_pictures.js';
import { nearestOn, nearestPole } from '../drawing/nearest.js';
import { number } from '../drawing/numbers.js';
import { poleMapping } from '../maths/locus.js';
import { namedPoles } from '../maths/open_loop.js';
import { element, panel, picture, select, set } from '../page/elements.js';
import { movable } from '../page/movable_point.js';
import { inSlices, slice } from '../page/slices.js';

/** @import { NamedRoots, Point, View } from '../types.d.ts' */
/** @import { Workbench } from './workbench.js' */

const INLINE = 0.8; // ms that a map may take in the locus's own frame
const SLICE = 3; // ms at a time for one that takes longer
const REST = 60; // ms until it begins

export class MapPanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.height = 0;
    const { system } = bench;
    /** @type {[number, string][]} */
    const stations = system.maps.map((/** @type {string} */ name, /** @type {number} */ i) => [i, name]);
    const ofStations = system.maps.every((/** @type {string} */ name) => system.running[name].unit === 'ft');
    this.list = select(ofStations ? 'Station of' : 'As this runs:', stations, (at) =>
      bench.look({ map: Number(at) }),
    );
    this.canvas = picture('map', {}).canvas;
    const row = element('div', { class: 'controls', hidden: stations.length < 2 }, this.list.node);
    this.panel = panel('map', 'Pole map', () => bench.page.follow(), row, this.canvas);
    this.node = this.panel.node;
    /** @type {Point[][]} */
    this.sides = [];
    this.cost = Infinity; // ms that the last map took; infinite for one that came to no end
    this.stop = () => {};
    movable(this.canvas, this.#point());
  }

  /**
   * The station is a point that moves along the traced branches.
   * @returns {import('../page/movable_point.js').MovablePoint}
   */
  #point() {
    /** @param {number} px @param {number} py @param {number} reach */
    const run = (px, py, reach) => {
      const places = this.sides.map((side) => nearestOn(side, this.view, px, py, reach));
      const place = places.find(Boolean);
      const { state } = this.bench;
      if (place) this.bench.put(state.station, state.place(state.station, place.t));
    };
    return {
      grab: (px, py, reach) => (this.view ? nearestPole(this.bench.closed, this.view, px, py, reach) : -1),
      drag: (_, px, py) => run(px, py, 30),
      click: (px, py) => run(px, py, 12),
      step: () => {},
    };
  }

  /**
   * A map that takes its time waits until the hand rests, and is then traced in slices between the frames: it
   * never holds up the locus. Until it is there, the last one stands dimmed.
   * @param {number} width
   */
  draw(width) {
    this.stop();
    const { system, state, closed } = this.bench;
    const height = this.bench.desk.room(this.canvas) ?? Math.round(Math.min(0.8 * width, 420));
    const { camera } = state.shown;
    const view = camera ? windowOf(camera, width, height) : this.#fit(width, height);
    const steps = poleMapping(system, state.values, closed, view, state.station);
    let spent = 0;
    /** @param {import('../page/slices.js').Found<unknown, Point[][]>} found */
    const take = ({ ms, done, result }) => {
      spent += ms;
      this.cost = done ? spent : Infinity;
      if (done) this.#picture(closed, view, result);
      this.canvas.classList.toggle('stale', !done);
      return done;
    };
    const { prints } = this.bench.page;
    if ((prints || this.cost < INLINE) && take(slice(steps, prints ? Infinity : INLINE))) return;
    this.stop = inSlices(steps, SLICE, take, REST);
    this.canvas.classList.add('stale');
  }

  /** @param {number} width @param {number} height */
  #fit(width, height) {
    const { closed, system, state } = this.bench;
    const near = [closed, namedPoles(system, state.values)].flatMap((roots) => withinReach(system, roots));
    return fitted(near, width, height);
  }

  /** @param {NamedRoots} closed @param {View} view @param {Point[][]} sides */
  #picture(closed, view, sides) {
    const { system, state, page } = this.bench;
    const { width, height } = view;
    this.view = view;
    this.sides = sides;
    if (this.height !== height) {
      this.height = height;
      this.canvas.style.height = `${height}px`;
    }
    const { ends, unit } = system.running[state.station];
    drawMap(
      contextOf(this.canvas, width, height),
      view,
      page.theme,
      closed,
      sides,
      system.running[state.station],
    );
    const still = `${number(state.values[state.station])} ${unit}`;
    const range = `${letterOf(state.station)} from ${ends.join(' to ')} ${unit}, filled marks at ${still}`;
    set(this.panel.extra, sides.length ? range : 'no influence: the feedback leaves out the bending');
    this.list.choose(state.shown.map);
  }

  /** Words that may lag a little behind the picture. @param {string} words */
  later(words) {
    const { station, values } = this.bench.state;
    const { ends, unit } = this.bench.system.running[station];
    const range = `${ends.join(' to ')} ${unit}`;
    const at = `${number(values[station])} ${unit}`;
    this.canvas.ariaLabel = `Closed-loop poles as the ${station} runs from ${range}. At ${at}: ${words}`;
  }
}
