// Curves along the vehicle: a cubic is itself between its nodes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { atFeet, curveAt } from '../../src/rlswaim/explorers/js/maths/curves.js';

/** @param {number} l */
const cubic = (l) => 2 - l + 0.5 * l ** 2 - 0.1 * l ** 3;
/** @param {number} l */
const derivative = (l) => -1 + l - 0.3 * l ** 2;
const X = [0, 1, 4, 10];
const CURVE = { x: X, y: X.map(cubic), slope: X.map(derivative) };

test('values and derivatives between nodes, at them and at the ends', () => {
  for (const l of [0, 0.3, 1, 2.5, 4, 7.7, 10]) {
    const [value, slope] = curveAt(CURVE, l);
    assert.ok(Math.abs(value - cubic(l)) < 1e-12, `value at ${l}`);
    assert.ok(Math.abs(slope - derivative(l)) < 1e-12, `derivative at ${l}`);
  }
});

test('a curve at each foot, and a table as it is', () => {
  const values = atFeet(CURVE);
  assert.equal(values.length, 11);
  assert.ok(Math.abs(values[3] - cubic(3)) < 1e-12);
  assert.equal(atFeet(CURVE), values);
  const table = [1, 2, 3];
  assert.equal(atFeet(table), table);
});
