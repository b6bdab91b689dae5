// Responses in time as small pictures side by side: one for each quantity, with axes and units.
import { write } from './context.js';
import { letterOf } from './letters.js';
import { line } from './marks.js';
import { grid, ground, Plane } from './plane.js';
import { stepOf } from './ticks.js';
import { frameOf, viewOf } from './view.js';

/** @import { Graphics, Theme } from '../types.d.ts' */
/** @typedef {Record<string, Float64Array>} Responses */

const ROW = 118;
const MARGIN = { left: 50, right: 8, top: 18, bottom: 20 };
/** @type {Record<string, string>} */
const BRANCH = {
  z: 'drift',
  eta: 'mode 1',
  alpha: 'attitude',
  theta: 'attitude',
  q1: 'mode 1',
  q2: 'mode 2',
  delta: 'actuator',
  delta_r: 'jet',
};

/** Angles are told in degrees. @param {string} unit @returns {[number, string]} */
export const scaleOf = (unit) => (unit === 'rad' ? [180 / Math.PI, '°'] : [1, unit]);

/**
 * As scaleOf, with a power of a thousand where the numbers would be too long for the axis.
 * @param {string} unit @param {Float64Array} values @returns {[number, string]}
 */
function axisScaleOf(unit, values) {
  const [factor, name] = scaleOf(unit);
  const most = values.reduce((size, v) => Math.max(size, Math.abs(v * factor)), 0);
  const thousands = most >= 1e5 ? Math.floor(Math.log10(most) / 3) : 0;
  if (thousands === 0) return [factor, name];
  const raised = [...String(3 * thousands)].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('');
  return [factor / 1000 ** thousands, `10${raised} ${name}`];
}

/** @param {number} width @param {number} count */
const columnsOf = (width, count) => Math.min(count, Math.max(1, Math.floor(width / 220)));

/** @param {number} width @param {number} count */
export const heightOf = (width, count) => Math.ceil(count / columnsOf(width, count)) * ROW;

/**
 * How many stand side by side, and the height of each: of all ways to fill the room the one whose pictures
 * are nearest to twice as wide as high; in the room that they ask for themselves, as they ask for it.
 * @param {number} width @param {number} height @param {number} count
 */
function layoutOf(width, height, count) {
  const own = columnsOf(width, count);
  if (height === heightOf(width, count)) return { columns: own, row: ROW };
  const ways = Array.from({ length: count }, (_, k) => ({
    columns: k + 1,
    row: height / Math.ceil(count / (k + 1)),
  }));
  const off = (/** @type {{ columns: number, row: number }} */ { columns, row }) =>
    Math.abs(Math.log(width / columns / row / 2));
  return ways.reduce((best, way) => (off(way) < off(best) ? way : best));
}

/**
 * A range of round numbers that holds all values and zero, and its step.
 * @param {Float64Array} values @param {number} row the height of a picture
 */
function rangeOf(values, row) {
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  if (high - low < 1e-12) return [-1, 1, 1];
  const step = stepOf(high - low, row - MARGIN.top - MARGIN.bottom, 26);
  return [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step, step];
}

/**
 * @param {Graphics} g @param {number} width @param {number} height @param {Theme} theme
 * @param {Float64Array} times @param {Responses} responses @param {Record<string, string>} units
 */
export function drawResponses(g, width, height, theme, times, responses, units) {
  const names = Object.keys(responses);
  const { columns, row } = layoutOf(width, height, names.length);
  const w = width / columns;
  const end = times[times.length - 1];
  g.clearRect(0, 0, width, height);
  names.forEach((name, i) => {
    const inner = frameOf(w, row, MARGIN);
    const frame = { ...inner, x: inner.x + (i % columns) * w, y: inner.y + Math.floor(i / columns) * row };
    const [factor, unit] = axisScaleOf(units[name], responses[name]);
    const values = responses[name].map((v) => v * factor);
    const [low, high, step] = rangeOf(values, row);
    const view = viewOf([0, end], [low, high], frame, width, height);
    const every = stepOf(end, frame.w, 60);
    const color = theme.color(BRANCH[name]) ?? theme.ink;
    const curve = Array.from(times, (t, k) => [t, values[k]]);
    const plane = new Plane(g, view, theme).layers(ground, grid(every, step)).numbers(every, step);
    write(g, unit ? `${letterOf(name)} (${unit})` : name, frame.x, frame.y - 9, theme.ink, 'left');
    write(g, 't (s)', frame.x + frame.w, frame.y - 9, theme.muted, 'right');
    line(
      [
        [0, 0],
        [end, 0],
      ],
      theme.axis,
      1,
    )(plane);
    line(curve, color, 1.8)(plane);
  });
}

/**
 * The largest and the last value of each response, in words.
 * @param {Responses} responses @param {Record<string, string>} units
 */
export function responseWords(responses, units) {
  const told = Object.entries(responses).map(([name, values]) => {
    const [factor, unit] = scaleOf(units[name]);
    const most = values.reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
    /** @param {number} v */
    const text = (v) => `${(v * factor).toPrecision(3)} ${unit}`;
    return `${name}: largest ${text(most)}, at the end ${text(values[values.length - 1])}`;
  });
  return told.join('; ');
}
