// The polynomials of a closed loop from its matrices, which Python sends as sums of products of factors:
// determinant and cofactors of s I - A by Laplace's expansion. Some factors may stay free, the others are
// numbers.

/** @import { Term } from './terms.js' */
/** @typedef {[row: number, column: number, weight: number, factors: string[]]} Entry of [A B; C D] */
/**
 * @typedef {{ states: string[], inputs: string[], outputs: string[], initial: string[], entries: Entry[] }}
 *   Matrices
 */
/** @typedef {Map<number, number>} Sum coefficients, by the bits of their free factors and the power of s */
/** @typedef {[column: number, entry: Sum][]} Row */

const POWERS = 16; // the power of s is the key's last four bits: no loop here has more states

/** @param {Sum} total @param {Sum} first @param {Sum} second @param {number} sign */
function addProduct(total, first, second, sign) {
  for (const [a, x] of first)
    for (const [b, y] of second) total.set(a + b, (total.get(a + b) ?? 0) + sign * x * y);
}

/** @param {number} bits */
function isOdd(bits) {
  let odd = 0;
  for (let rest = bits; rest; rest &= rest - 1) odd ^= 1;
  return odd === 1;
}

/**
 * The determinants of the rows in every choice of as many columns, by a bit for each column.
 * @param {Row[]} rows
 */
function minors(rows) {
  /** @type {Map<number, Sum>} */
  let found = new Map([[0, new Map([[0, 1]])]]);
  for (const row of rows) {
    /** @type {Map<number, Sum>} */
    const grown = new Map();
    for (const [columns, minor] of found)
      for (const [column, entry] of row) {
        const bit = 1 << column;
        if (columns & bit) continue;
        const total = grown.get(columns | bit) ?? new Map();
        grown.set(columns | bit, total);
        addProduct(total, minor, entry, isOdd(columns >> column) ? -1 : 1);
      }
    found = grown;
  }
  return found;
}

/**
 * The entries of [A B; C D] by row and column, with the numbers put in.
 * @param {Matrices} matrices @param {Record<string, number>} values @param {string[]} free
 */
function summed({ states, outputs, entries }, values, free) {
  const rows = Array.from({ length: states.length + outputs.length }, () => new Map());
  for (const [row, column, weight, factors] of entries) {
    let [size, bits] = [weight, 0];
    for (const factor of factors) {
      const at = free.indexOf(factor);
      if (at < 0) size *= values[factor];
      else bits |= 1 << at;
    }
    if (size === 0) continue;
    const entry = rows[row].get(column) ?? new Map();
    rows[row].set(column, entry);
    entry.set(POWERS * bits, (entry.get(POWERS * bits) ?? 0) + size);
  }
  return rows;
}

/** The rows of s I - A. @param {Map<number, Sum>[]} rows @param {number} n @returns {Row[]} */
function pencil(rows, n) {
  return rows.slice(0, n).map((row, i) => {
    /** @type {Row} */
    const found = [];
    for (let j = 0; j < n; j++) {
      const entry = row.get(j);
      if (!entry && i !== j) continue;
      /** @type {Sum} */
      const turned = new Map(entry && Array.from(entry, ([key, value]) => [key, -value]));
      if (i === j) turned.set(1, 1);
      found.push([j, turned]);
    }
    return found;
  });
}

/** @param {Sum | undefined} sum @param {number} length @param {string[]} free @returns {Term[]} */
function termsOf(sum, length, free) {
  /** @type {Map<number, Float64Array>} */
  const found = new Map();
  for (const [key, value] of sum ?? []) {
    const bits = key >> 4;
    const coefficients = found.get(bits) ?? new Float64Array(length);
    found.set(bits, coefficients);
    coefficients[key % POWERS] = value;
  }
  return Array.from(found, ([bits, coefficients]) => ({
    factors: free.filter((_, k) => bits & (1 << k)),
    coefficients,
  }));
}

/**
 * The characteristic polynomial as a table of terms in the free factors.
 * @param {Matrices} matrices @param {Record<string, number>} values @param {string[]} free
 */
export function characteristicTerms(matrices, values, free = []) {
  const n = matrices.states.length;
  const found = minors(pencil(summed(matrices, values, free), n)).get(2 ** n - 1);
  return termsOf(found, n + 1, free);
}

/**
 * What an input enters each state's equation by. A state's initial value is an input too.
 * @param {Matrices} matrices @param {Map<number, Sum>[]} rows @param {string} input
 * @returns {(Sum | undefined)[]}
 */
function columnOf({ states, inputs }, rows, input) {
  const at = inputs.indexOf(input);
  const one = new Map([[0, 1]]);
  return states.map((state, i) =>
    at < 0 ? (`${state}(0)` === input ? one : undefined) : rows[i].get(states.length + at),
  );
}

/**
 * The numerators from one input by output, all factors numbers.
 * @param {Matrices} matrices @param {Record<string, number>} values @param {string} input
 * @returns {Record<string, Term[]>}
 */
export function numeratorsFrom(matrices, values, input) {
  const { states, outputs } = matrices;
  const n = states.length;
  const rows = summed(matrices, values, []);
  const own = pencil(rows, n);
  /** @type {Sum[]} */
  const found = outputs.map(() => new Map());
  columnOf(matrices, rows, input).forEach((entering, i) => {
    if (!entering) return;
    const cofactors = minors(own.filter((_, k) => k !== i));
    outputs.forEach((_, o) => {
      for (const [j, weight] of rows[n + o]) {
        const minor = j < n && cofactors.get(2 ** n - 1 - 2 ** j);
        if (!minor) continue;
        /** @type {Sum} */
        const adjugate = new Map();
        addProduct(adjugate, minor, weight, (i + j) % 2 ? -1 : 1);
        addProduct(found[o], adjugate, entering, 1);
      }
    });
  });
  return Object.fromEntries(outputs.map((output, o) => [output, termsOf(found[o], n, [])]));
}
