// The marks of the bent vehicle: its axes, its surfaces, and arrows for the forces on it.
import { arrow, label, line, mark } from '../drawing/marks.js';
import { height, RADIAN, rigidHeight } from '../maths/bent_vehicle_forces.js';

/** @import { Theme, Values, View } from '../types.d.ts' */
/** @import { Layer } from '../drawing/plane.js' */
/** @import { Found } from './bent_vehicle.js' */

export const REACH = 100; // ft above and below
const LAST = 420; // ft
const KEY = 1e6; // lb
/** @type {Record<string, string>} */
const COLORS = { thrust: 'actuator', payload: 'rigid', fins: 'rigid' };

/**
 * The length of an arrow: it goes with the square root of the force, so that small ones can be seen beside
 * the thrust.
 * @param {number} force lb @param {number} width of the picture
 */
const pixels = (force, width) =>
  Math.sign(force) * 30 * Math.sqrt(Math.abs(force) / KEY) * Math.min(1, width / 600);

/**
 * @param {number[][]} axis @param {Theme} theme @param {any} payload @param {Values} values
 * @returns {Layer[]}
 */
function axes(axis, theme, payload, values) {
  const ends = [0, LAST];
  return [
    line(
      ends.map((at) => [at, 0]),
      theme.axis,
      1,
      [2, 4],
    ),
    line(
      ends.map((at) => [at, rigidHeight(payload, values, at)]),
      theme.color('rigid'),
      1.5,
      [7, 5],
    ),
    line(axis, theme.grid, 15),
    line(axis, theme.color('mode 1')),
    ...payload.sources
      .slice(1)
      .map((/** @type {{ station: number }} */ { station }) =>
        line(axis.slice(Math.max(0, station - 13), station + 14), theme.muted, 5),
      ),
  ];
}

/** @param {View} view @param {Theme} theme @param {any} payload @returns {Layer[]} */
function weight({ X, Y, width }, theme, { weight: { force, gamma_0 }, l_CG }) {
  const [x, y, size] = [X(l_CG), Y(0), pixels(force, width)];
  const [dx, dy] = [size * Math.sin(gamma_0 * RADIAN), size * Math.cos(gamma_0 * RADIAN)];
  return [
    arrow(x, y, x + dx, y + dy, theme.color('neutral'), 3),
    label('weight', l_CG, 0, dx + 4, dy + 10, theme.muted),
    mark('■', l_CG, 0, theme.color('neutral'), 4),
  ];
}

/**
 * Exhaust and thrust: along the bent axis at the engine, swung by delta. Angles are stretched like heights.
 * @param {View} view @param {number[][]} axis @param {Theme} theme @param {any} payload
 * @param {Values} values
 * @returns {Layer[]}
 */
function thrust(view, axis, theme, payload, values) {
  const [{ station, incidence }] = payload.sources;
  const [at, up] = axis[station];
  const size = pixels(payload.thrust, view.width);
  const turn = values.theta + incidence.q_1 * values.q_1 + incidence.q_2 * values.q_2;
  const color = theme.color('actuator');
  /** The exhaust's way from the engine, in px. @param {number} angle degrees */
  const exhaust = (angle) => {
    const [dx, dy] = [view.sx, -Math.tan(angle * RADIAN) * view.sy];
    const scale = size / Math.hypot(dx, dy);
    return [dx * scale, dy * scale];
  };
  const [sx, sy] = exhaust(-turn);
  const [dx, dy] = exhaust(values.delta - turn);
  const [x, y] = [view.X(at), view.Y(up)];
  return [
    line(
      [
        [at, up],
        [at + sx / view.sx, up - sy / view.sy],
      ],
      color,
      1,
      [2, 4],
    ),
    arrow(x + dx, y + dy, x, y, color, 3),
    label('thrust', at, up, dx / 2, dy / 2 + (dy > 0 ? 12 : -12), color),
  ];
}

/**
 * The force of each source across the vehicle.
 * @param {View} view @param {number[][]} axis @param {Theme} theme @param {any} payload
 * @param {Found} found
 * @returns {Layer[]}
 */
function forces(view, axis, theme, payload, { each }) {
  return each.flatMap(({ name, loads: { Z } }, i) => {
    const [at, up] = axis[payload.sources[i].station];
    const [x, y, size] = [view.X(at), view.Y(up), pixels(Z, view.width)];
    const color = theme.color(COLORS[name] ?? 'rigid');
    const word = i ? name : 'thrust, across';
    const layers = [arrow(x, y, x, y + size, color, 3)];
    if (Math.abs(size) > 4) layers.push(label(word, at, up, i ? 0 : -40, size + Math.sign(Z) * 9, color));
    return layers;
  });
}

/**
 * The direction of the air, and the length of a known force.
 * @param {View} view @param {Theme} theme @param {Values} values
 * @returns {Layer[]}
 */
function keys({ X, Y, sx, sy, width }, theme, { theta, alpha }) {
  const color = theme.color('mode 2');
  const [x, y] = [X(-70), Y(-0.8 * REACH)];
  const [end, below, size] = [X(515), Y(-0.88 * REACH), pixels(KEY, width)];
  return [
    arrow(x, y, x + 44, y + (Math.tan((theta - alpha) * RADIAN) * 44 * sy) / sx, color),
    label('air', -70, -0.8 * REACH, 14, -12, color),
    arrow(end - size, below, end, below, theme.ink, 3),
    label('1,000,000 lb', 515, -0.88 * REACH, -size - 6, 0, theme.ink, 'right'),
  ];
}

/**
 * @param {View} view @param {Theme} theme @param {any} payload @param {Values} values @param {Found} found
 */
export function vehicleMarks(view, theme, payload, values, found) {
  const axis = Array.from({ length: LAST + 1 }, (_, at) => [at, height(payload, values, at)]);
  return [
    ...axes(axis, theme, payload, values),
    ...weight(view, theme, payload),
    ...thrust(view, axis, theme, payload, values),
    ...forces(view, axis, theme, payload, found),
    ...keys(view, theme, values),
  ];
}
