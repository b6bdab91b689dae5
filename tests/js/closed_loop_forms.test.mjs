// Polynomials of closed loops from matrices: by hand for a loop of three states.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  characteristicTerms,
  numeratorsFrom,
} from '../../src/rlswaim/explorers/js/maths/closed_loop_forms.js';

// x'' = -w x - 2 x' + f d, d' = -c d + c (r - K x): s^3 + (2 + c) s^2 + (w + 2 c) s + c w + c K f.
const LOOP = {
  states: ['x', 'v', 'd'],
  inputs: ['r', 'g'],
  outputs: ['x', 'd'],
  initial: ['x', 'v'],
  entries: [
    [0, 1, 1, []],
    [1, 0, -1, ['w']],
    [1, 1, -2, []],
    [1, 2, 1, ['f']],
    [2, 2, -1, ['c']],
    [2, 0, -1, ['c', 'K']],
    [2, 3, 1, ['c']],
    [1, 4, 3, []],
    [3, 0, 1, []],
    [4, 2, 1, []],
  ],
};

/** @param {{ factors: string[], coefficients: ArrayLike<number> }[]} terms */
const plain = (terms) =>
  Object.fromEntries(terms.map(({ factors, coefficients }) => [factors.join(), Array.from(coefficients)]));

test('the characteristic polynomial in two free factors', () => {
  const found = plain(characteristicTerms(LOOP, { w: 5, f: 7 }, ['K', 'c']));
  assert.deepEqual(found, { '': [0, 5, 2, 1], c: [5, 2, 1, 0], 'K,c': [7, 0, 0, 0] });
});

test('the characteristic polynomial at numbers', () => {
  const found = plain(characteristicTerms(LOOP, { w: 5, f: 7, c: 2, K: 3 }));
  assert.deepEqual(found, { '': [52, 9, 4, 1] });
});

test('a factor at 0 leaves its terms out', () => {
  assert.deepEqual(plain(characteristicTerms(LOOP, { w: 5, f: 7, c: 0, K: 3 })), { '': [0, 5, 2, 1] });
});

test('numerators from inputs and from values at the start', () => {
  const values = { w: 5, f: 7, c: 2, K: 3 };
  /** @param {string} input */
  const from = (input) =>
    Object.fromEntries(
      Object.entries(numeratorsFrom(LOOP, values, input)).map(([output, terms]) => [
        output,
        plain(terms)[''],
      ]),
    );
  assert.deepEqual(from('r'), { x: [14, 0, 0], d: [10, 4, 2] });
  assert.deepEqual(from('g'), { x: [6, 3, 0], d: [-18, 0, 0] });
  assert.deepEqual(from('x(0)'), { x: [4, 4, 1], d: [-12, -6, 0] });
  assert.deepEqual(from('v(0)'), { x: [2, 1, 0], d: [-6, 0, 0] });
});
