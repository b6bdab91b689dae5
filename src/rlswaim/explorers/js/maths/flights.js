// Flights between those that Python has integrated: straight lines between the pitch programs, and along
// time.

/** @typedef {Record<string, number>} Program upright, level (s) */
/** @typedef {number[][][]} Table by upright and level, of rows */
/**
 * @typedef {object} Flown
 * @property {{ upright: number[], level: number[] }} nodes
 * @property {number[]} times
 * @property {Record<string, Table>} curves
 * @property {Table} peak
 * @property {Record<string, number>} printed
 */

/**
 * The cell of a list of nodes that a value lies in, and its share of the way through.
 * @param {number[]} nodes @param {number} value
 * @returns {[number, number]}
 */
function cellOf(nodes, value) {
  const below = nodes.findLastIndex((node) => node <= value);
  const at = Math.max(0, Math.min(nodes.length - 2, below));
  return [at, (value - nodes[at]) / (nodes[at + 1] - nodes[at])];
}

/** @param {number[]} a @param {number[]} b @param {number} share */
export const mixed = (a, b, share) => a.map((v, k) => v + share * (b[k] - v));

/**
 * The row of a table for a pitch program.
 * @param {Table} table @param {Flown} flown @param {Program} program
 */
function rowOf(table, { nodes }, program) {
  const [i, p] = cellOf(nodes.upright, program.upright);
  const [k, q] = cellOf(nodes.level, program.level);
  return mixed(mixed(table[i][k], table[i][k + 1], q), mixed(table[i + 1][k], table[i + 1][k + 1], q), p);
}

/**
 * The flight of a pitch program: its curves, their values at the printed time, and the largest dynamic
 * pressure.
 * @param {Flown} flown @param {Program} program
 */
export function flight(flown, program) {
  const [k, share] = cellOf(flown.times, flown.printed.t);
  /** @type {Record<string, number[]>} */
  const curves = {};
  /** @type {Record<string, number>} */
  const there = {};
  for (const [name, table] of Object.entries(flown.curves)) {
    const curve = rowOf(table, flown, program);
    curves[name] = curve;
    there[name] = curve[k] + share * (curve[k + 1] - curve[k]);
  }
  const [time, size] = rowOf(flown.peak, flown, program);
  return { curves, there, peak: { time, size } };
}

/**
 * One curve of the flight of a pitch program at a time.
 * @param {Pick<Flown, 'nodes' | 'times' | 'curves'>} flown @param {string} name
 * @param {Program & { t: number }} at
 */
export function curveOfFlightAt({ nodes, times, curves }, name, { t, upright, level }) {
  const [i, p] = cellOf(nodes.upright, upright);
  const [k, q] = cellOf(nodes.level, level);
  const [n, share] = cellOf(times, t);
  /** @param {number} row @param {number} column */
  const along = (row, column) => {
    const curve = curves[name][row][column];
    return curve[n] + share * (curve[n + 1] - curve[n]);
  };
  /** @param {number} row */
  const between = (row) => along(row, k) + q * (along(row, k + 1) - along(row, k));
  return between(i) + p * (between(i + 1) - between(i));
}
