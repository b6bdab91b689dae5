// The poles of the vehicle without control: from the two tables that Python sends, as the coupling or a
// slider runs.

import { roots } from './aberth.js';
import { matchRoots } from './match_roots.js';
import { trace } from './tracing.js';

/** @import { Values, View } from '../types.d.ts' */
/** @typedef {[number, number[]][]} Sum products: a weight and the places of its factors */
/**
 * @typedef {[number, number, number[]][]} Table a weight, a power of s, places of coefficients
 */
/**
 * @typedef {{ factors: string[], coefficients: Sum[], determinant: Table, blocks: [string, Table][] }} Tables
 */

/** Room for intermediate values: they are summed thousands of times in a frame. */
const room = () => ({ found: new Float64Array(24), whole: new Float64Array(8) });

/**
 * The table has one value a foot; between two of them the picture takes the straight line.
 * @param {number[]} values @param {number} station
 */
function along(values, station) {
  const left = Math.max(0, Math.min(Math.floor(station), values.length - 2));
  return values[left] + (station - left) * (values[left + 1] - values[left]);
}

/** @param {any} payload @param {Values} factors @param {string} surface */
function place(payload, factors, surface) {
  for (const [name, values] of Object.entries(payload.shapes))
    factors[`${name}_${surface}`] = along(values, factors[`l_${surface}`]);
}

/** @param {any} payload @param {Values} state */
function factorsOf(payload, state) {
  /** @type {Values} */
  const factors = { coupling: 1, ...state };
  for (const surface of payload.surfaces) place(payload, factors, surface);
  return factors;
}

/** @type {WeakMap<object, Tables>} */
const compiled = new WeakMap();

/** The tables with numbers in place of names. @param {any} payload @returns {Tables} */
function compile({ coefficients, determinant, blocks }) {
  const names = Object.keys(coefficients);
  /** @type {[number, string[]][][]} */
  const sums = Object.values(coefficients);
  const factors = [...new Set(sums.flat().flatMap(([, of]) => of))];
  /** @param {[number, number, string[]][]} table @returns {Table} */
  const indexed = (table) =>
    table.map(([weight, power, of]) => [weight, power, of.map((name) => names.indexOf(name))]);
  return {
    factors,
    coefficients: sums.map((products) =>
      products
        .filter(([weight]) => weight !== 0)
        .map(([weight, of]) => [weight, of.map((name) => factors.indexOf(name))]),
    ),
    determinant: indexed(determinant),
    blocks: Object.entries(blocks).map(([name, table]) => [name, indexed(table)]),
  };
}

/** @param {any} payload */
function tablesOf(payload) {
  if (!compiled.has(payload)) compiled.set(payload, compile(payload));
  return compiled.get(payload);
}

/** @param {Tables} tables @param {Values} values @param {Float64Array} found */
function coefficientsOf({ factors, coefficients }, values, found) {
  const given = factors.map((name) => values[name]);
  for (let n = 0; n < coefficients.length; n++) {
    let sum = 0;
    for (const [weight, of] of coefficients[n]) {
      let value = weight;
      for (let k = 0; k < of.length; k++) value *= given[of[k]];
      sum += value;
    }
    found[n] = sum;
  }
  return found;
}

/** @param {Table} table @param {Float64Array} coefficients @param {Float64Array} c */
function polynomial(table, coefficients, c) {
  c.fill(0);
  for (const [weight, power, of] of table) {
    let value = weight;
    for (let k = 0; k < of.length; k++) value *= coefficients[of[k]];
    c[power] += value;
  }
  return c;
}

/**
 * The whole vehicle's polynomial, without the attitude's root at the origin.
 * @param {any} payload @param {Values} factors @param {ReturnType<typeof room>} given @param {Float64Array} c
 */
function fill(payload, factors, { found, whole }, c) {
  const tables = tablesOf(payload);
  polynomial(tables.determinant, coefficientsOf(tables, factors, found), whole);
  for (let k = 0; k < c.length; k++) c[k] = whole[k + 1];
}

/** All poles but the attitude. @param {any} payload @param {Values} state */
export function poles(payload, state) {
  const c = new Float64Array(7);
  fill(payload, factorsOf(payload, state), room(), c);
  return roots(c);
}

/**
 * The poles that each motion would have by itself, with its name.
 * @param {any} payload @param {Values} state
 */
export function uncoupled(payload, state) {
  const tables = tablesOf(payload);
  const coefficients = coefficientsOf(tables, factorsOf(payload, state), new Float64Array(24));
  /** @type {{ x: number[], y: number[], names: string[] }} */
  const found = { x: [], y: [], names: [] };
  for (const [name, table] of tables.blocks) {
    const order = Math.max(...table.map(([, power]) => power));
    const c = polynomial(table, coefficients, new Float64Array(order + 1));
    const { x, y } = roots(name === 'short period' ? c.slice(1) : c);
    found.x.push(...x);
    found.y.push(...y);
    found.names.push(...x.map(() => name));
  }
  return found;
}

/** The polynomial as a parameter runs. @param {any} payload @param {Values} state @param {string} running */
function curve(payload, state, running) {
  const factors = factorsOf(payload, state);
  const own = room();
  const surface = payload.surfaces.find((/** @type {string} */ name) => `l_${name}` === running);
  return {
    /** @param {number} t @param {Float64Array} c */
    fill(t, c) {
      factors[running] = t;
      if (surface) place(payload, factors, surface);
      fill(payload, factors, own, c);
    },
    /** @param {number} a @param {number} b */
    middle: (a, b) => (a + b) / 2,
  };
}

/** @param {number} from @param {number} to @param {number} count */
const nodes = (from, to, count) =>
  Array.from({ length: count + 1 }, (_, k) => from + ((to - from) * k) / count);

/**
 * Paths of the poles: while the coupling rises from nothing to all, or while the chosen parameter runs from
 * where it is to both ends of its slider. The names are those of the motions that the poles grow out of.
 * @param {any} payload @param {Values} state @param {View} view
 */
export function paths(payload, state, view) {
  const start = uncoupled(payload, state);
  const rising = trace(curve(payload, state, 'coupling'), nodes(0, 1, 16), start, view);
  const end = rising.at(-1);
  const exact = poles(payload, state);
  const partner = matchRoots(end.x, end.y, exact.x, exact.y, new Int32Array(6));
  const present = { x: Array.from(partner, (p) => exact.x[p]), y: Array.from(partner, (p) => exact.y[p]) };
  if (state.running === 'coupling') return { start, present, names: start.names, runs: [rising] };
  const { grid } = payload.parameters.find(
    (/** @type {{ name: string }} */ { name }) => name === state.running,
  );
  const here = state[state.running];
  const moving = curve(payload, state, state.running);
  const runs = [grid[0], grid.at(-1)]
    .filter((to) => to !== here)
    .map((to) => trace(moving, nodes(here, to, 16), present, view));
  return { start, present, names: start.names, runs };
}
