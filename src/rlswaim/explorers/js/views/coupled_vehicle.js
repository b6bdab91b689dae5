// The vehicle without control: its poles as the coupling or one of its parameters runs.
import { contextOf } from '../drawing/context.js';
import { arrow, cross, line, mark, signsOf } from '../drawing/marks.js';
import { number } from '../drawing/numbers.js';
import { sPlane } from '../drawing/s_plane.js';
import { ladder } from '../drawing/ticks.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { paths, poles, uncoupled } from '../maths/coupled_poles.js';
import { element, legend, picture, scrolling, set } from '../page/elements.js';
import { PoleTable } from '../page/pole_table.js';
import { VerdictLine, verdict } from '../page/verdict.js';
import { simple } from './simple_view.js';

/** @import { Parameter, Point, Roots, Theme, Values } from '../types.d.ts' */
/** @import { Layer } from '../drawing/plane.js' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @typedef {ReturnType<typeof paths>} Found */

/** @type {Record<string, string>} */
const NAMES = {
  coupling: 'the coupling',
  omega_1: 'ω₁',
  omega_2: 'ω₂',
  q_D: 'qD',
  C_payload: 'the payload’s CNα (1/rad)',
  C_fins: 'the fins’ CNα (1/rad)',
  l_payload: 'the payload’s station',
  l_fins: 'the fins’ station',
};
const TITLE = 'Poles of the vehicle without control';

/**
 * The window that holds all poles, where they start and where they are. Its borders are round numbers, so it
 * stands still while the poles move a little.
 * @param {Roots[]} given @param {number} width @param {number} height
 */
function windowOf(given, width, height) {
  /** @param {number[]} values */
  const reach = (values) => ladder(Math.max(1.12 * Math.max(0, ...values), 0.4));
  const side = reach(given.flatMap(({ x }) => Array.from(x, Math.abs)));
  const top = reach(given.flatMap(({ y }) => Array.from(y)));
  return viewOf([-side, side], [-0.05 * top, top], frameOf(width, height), width, height);
}

/**
 * A path, and in its middle an arrow where it has a direction.
 * @param {Point[]} run @param {number} i @param {string} color @param {boolean} directed
 * @returns {Layer}
 */
const path = (run, i, color, directed) => (plane) => {
  const points = run.map((p) => [p.x[i], Math.abs(p.y[i])]);
  line(points, color)(plane);
  if (!directed) return;
  const { X, Y } = plane.view;
  const k = points.length >> 1;
  const [a, b] = [points[Math.max(0, k - 1)], points[Math.min(points.length - 1, k + 1)]];
  const [ax, ay, bx, by] = [X(a[0]), Y(a[1]), X(b[0]), Y(b[1])];
  const size = Math.hypot(bx - ax, by - ay);
  if (size > 0.5) arrow(bx - (9 * (bx - ax)) / size, by - (9 * (by - ay)) / size, bx, by, color)(plane);
};

/** @param {Found} found @param {Theme} theme @param {boolean} directed @returns {Layer[]} */
function marksOf({ start, present, names, runs }, theme, directed) {
  /** @param {(name: string, i: number) => Layer[]} layers */
  const each = (layers) => names.flatMap(layers);
  /** @param {Roots} at @param {number} i @returns {[number, number]} */
  const place = ({ x, y }, i) => [x[i], Math.abs(y[i])];
  return [
    ...each((name, i) => runs.map((run) => path(run, i, theme.color(name), directed))),
    mark(theme.sign('attitude'), 0, 0, theme.color('attitude'), 4),
    ...each((name, i) => [
      cross(...place(start, i), theme.color(name)),
      mark(theme.sign(name), ...place(present, i), theme.color(name)),
    ]),
  ];
}

class CoupledVehicle {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    this.what = element('span');
    const title = element('b', {}, 'Poles of the vehicle');
    const { canvas, figure } = picture('paths', {}, title, this.what);
    this.canvases = [canvas];
    this.verdict = new VerdictLine();
    this.table = new PoleTable(element('caption', {}, TITLE), 'grows out of');
    /** @type {[string, string][]} */
    const names = [...signsOf(Object.keys(payload.colors))].map(([name, sign]) => [sign, name]);
    const signs = legend([['×', 'each motion by itself'], ...names]);
    this.nodes = [this.verdict.node, figure, signs, scrolling(TITLE, this.table.node)];
  }

  /** What runs along the paths. @param {string} running */
  #run(running) {
    if (running === 'coupling') return ' while the coupling rises from nothing to all';
    /** @type {Parameter} */
    const { grid, unit } = this.payload.parameters.find((/** @type {Parameter} */ p) => p.name === running);
    const range = `from ${number(grid[0])} to ${number(grid.at(-1))} ${unit}`;
    return ` while ${NAMES[running] ?? running} runs ${range}`;
  }

  /** @param {Values} values @param {Lifecycle} page */
  draw(values, page) {
    const { payload } = this;
    const [canvas] = this.canvases;
    const [width, height] = page.sizeOf(canvas);
    const view = windowOf([uncoupled(payload, values), poles(payload, values)], width, height);
    const found = paths(payload, values, view);
    const marks = marksOf(found, page.theme, values.running === 'coupling');
    sPlane(contextOf(canvas, width, height), view, page.theme, ...marks);
    const { names, present } = found;
    const moving = names.map((name, i) => ({ re: present.x[i], im: present.y[i], name }));
    const said = verdict(moving, 'but for the attitude, which nothing restores, ');
    if (said.kind === 'stable') said.word = 'No divergence';
    this.verdict.show(said);
    set(this.what, this.#run(values.running));
    this.table.show([{ re: 0, im: 0, name: 'attitude' }, ...moving], page.theme);
    canvas.ariaLabel = `${TITLE}${this.what.textContent}. ${said.word}${said.long}`;
    return `${said.word}${said.long}`;
  }
}

export const render = simple(CoupledVehicle);
